# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kernel's solids of boundaries: read as text, each once, copies placed or mirrored."""

from weakref import ref

import FreeCAD as App
import numpy as np
import Part
from numpy.typing import NDArray

from ..origami.hinges.boundary import Boundary
from ..origami.hinges.brep_text import brep_text
from .matrices import array_of, placement_of

_MIRROR = np.diag([1.0, 1.0, -1.0, 1.0])
_SAME = 1e-5  # mm by which corners of a solid and of its boundary may differ
_MADE: dict = {}  # number of faces -> [(its boundary, weakly, whether it is mirrored)]


def shape_of(boundary: Boundary, place: NDArray | None = None) -> Part.Shape:
    """Solid of a boundary, carried by ``place`` (4, 4), a rigid motion or mirror image.

    Copies of one boundary share one solid of the kernel, and so do its mirror images.
    """
    place = np.eye(4) if place is None else np.asarray(place, float)
    mirrored = np.linalg.det(place[:3, :3]) < 0
    if mirrored:
        place = place @ _MIRROR
    shape = Part.Shape(_own(boundary, mirrored))
    shape.Placement = placement_of(place)
    return shape


def _own(boundary: Boundary, mirrored: bool) -> Part.Shape:
    """The kernel's solid, or its image mirrored in z, of a boundary in its own frame."""
    known = boundary.__dict__.setdefault("_shapes", {})
    if mirrored not in known:
        if mirrored:
            origin, normal = App.Vector(), App.Vector(0, 0, 1)
            known[True] = _own(boundary, False).mirror(origin, normal)
        else:
            known[False] = _read(boundary)
        _know(boundary, mirrored, known[mirrored])
    return known[mirrored]


def _know(boundary: Boundary, mirrored: bool, own: Part.Shape) -> None:
    """Find the boundary again by its solid, or the solid's mirror image."""
    boundary.__dict__["_shapes"][mirrored] = own
    alike = _MADE.setdefault(len(boundary.faces), [])
    alike[:] = [entry for entry in alike if entry[0]() is not None]
    alike.append((ref(boundary), mirrored))


def adopt(boundary: Boundary, place: NDArray, solid: Part.Shape) -> None:
    """Let a solid of a file stand for a boundary that ``place`` carries, so that none is made.

    Nothing happens where the solid is not that of the boundary, or there is one already.
    """
    mirrored = np.linalg.det(place[:3, :3]) < 0
    known = boundary.__dict__.setdefault("_shapes", {})
    if mirrored in known or solid.countElement("Face") != len(boundary.faces):
        return
    own = Part.Shape(solid)
    own.Placement = App.Placement()
    corners = boundary.vertices * (_MIRROR.diagonal()[:3] if mirrored else 1.0)
    some = own.Vertexes[:: max(1, len(own.Vertexes) // 4)]
    apart = [np.linalg.norm(corners - tuple(v.Point), axis=1).min() for v in some]
    if len(corners) == len(own.Vertexes) and max(apart) < _SAME:
        _know(boundary, mirrored, own)


def boundary_of(shape: Part.Shape) -> tuple[Boundary, NDArray] | None:
    """(`Boundary`, matrix (4, 4)) that a shape of ours was made from, or None.

    The matrix carries the boundary to where the shape stands.
    """
    for known, mirrored in tuple(_MADE.get(shape.countElement("Face"), ())):  # threads add to it
        boundary = known()
        if boundary is not None and boundary.__dict__["_shapes"][mirrored].isPartner(shape):
            place = array_of(shape.Placement)
            return boundary, place @ _MIRROR if mirrored else place
    return None


def _read(boundary: Boundary) -> Part.Shape:
    shape = Part.Shape()
    shape.importBrepFromString(brep_text(boundary))
    if shape.ShapeType != "Solid":
        raise RuntimeError("The kernel read no solid from a boundary.")
    return shape
