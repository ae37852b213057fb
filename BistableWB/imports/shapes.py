# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact pieces ↔ FreeCAD's edges, and shape files: STEP, IGES, BREP. Runs inside FreeCAD."""

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import FreeCAD as App
import numpy as np
import Part

from ..origami.errors import Refusal, phrase
from ..solids.matrices import matrix_of
from .drawing import Read, Stroke
from .pieces import Arc, Array, Line, Piece, Spline


@dataclass(frozen=True, eq=False)
class EdgePiece(Piece):
    """An edge of a shape file; ``back``: run through from its end."""

    edge: Part.Edge
    back: bool = False

    def _own(self, t):
        first, last = self.edge.FirstParameter, self.edge.LastParameter
        first, last = (last, first) if self.back else (first, last)
        return first + np.asarray(t) * (last - first), last - first

    def at(self, t):
        """See `Piece.at`."""
        return np.array([tuple(self.edge.valueAt(x)) for x in self._own(t)[0].tolist()])

    def speed(self, t):
        """See `Piece.speed`."""
        x, span = self._own(t)
        return span * np.array([tuple(self.edge.derivative1At(y)) for y in x.tolist()])

    def mapped(self, matrix):
        """See `Piece.mapped`."""
        scale = np.cbrt(np.linalg.det(matrix[:3, :3]))
        if np.allclose(matrix[:3, :3], scale * np.eye(3), rtol=1e-12, atol=0):
            moved = self.edge.copy()
            if scale != 1:
                moved.scale(float(scale), App.Vector(0, 0, 0))
            moved.translate(App.Vector(*matrix[:3, 3].tolist()))
            return EdgePiece(moved, self.back)
        return EdgePiece(self.edge.transformGeometry(matrix_of(matrix)), self.back)

    def turned(self):
        """See `Piece.turned`."""
        return EdgePiece(self.edge, not self.back)

    @cached_property
    def length(self):
        """Arc length."""
        return self.edge.Length


def read_shape(path: Path) -> Read:
    """Strokes of the edges of a STEP, IGES or BREP file, in mm."""
    shape = Part.Shape()
    try:
        shape = Part.read(str(path))
    except (Part.OCCError, OSError, ValueError, RuntimeError) as error:
        raise _unreadable(path) from error
    if shape.isNull() or not shape.Edges:
        raise _unreadable(path)
    source = phrase("the file; shapes without a unit are in mm")
    read = Read([], "mm", source)
    free = [edge for edge in shape.Edges if not _in_face(edge, shape)]
    if len(free) < len(shape.Edges) and free:
        read.left_out[phrase("edge"), phrase("of a surface")] += len(shape.Edges) - len(free)
    read.strokes = [Stroke([EdgePiece(edge)]) for edge in free or shape.Edges if edge.Length > 0]
    return read


def _in_face(edge, shape):
    return any(other.isSame(edge) for face in shape.Faces for other in face.Edges)


def _unreadable(path):
    return Refusal("{name} has no edge that can be read", name=path.name,
                   cure="export the curve again")  # fmt: skip


def edge_of(piece: Piece) -> Part.Edge:
    """The edge of a piece: line, circle, ellipse or B-spline, exactly."""
    if isinstance(piece, EdgePiece):
        return piece.edge
    if isinstance(piece, Line):
        return Part.makeLine(_vector(piece.a), _vector(piece.b))
    if isinstance(piece, Arc):
        return _arc(piece)
    assert isinstance(piece, Spline)
    spline = Part.BSplineCurve()
    knots, counts = np.unique(piece.knots, return_counts=True)
    poles = [_vector(pole) for pole in piece.poles]
    weights = [1.0] * len(poles) if piece.weights is None else piece.weights.tolist()
    spline.buildFromPolesMultsKnots(
        poles, counts.tolist(), knots.tolist(), False, piece.degree, weights
    )
    return spline.toShape()


def _arc(piece):
    major, minor = piece.radii
    a, b = float(np.linalg.norm(major)), float(np.linalg.norm(minor))
    if b <= 1e-9 * a:  # seen from its edge
        return Part.makeLine(_vector(piece.start), _vector(piece.end))
    circular = piece.is_circular
    major, minor = (piece.u, piece.v) if circular else (major, minor)
    axes = np.column_stack([major / np.linalg.norm(major), minor / np.linalg.norm(minor)])
    x, y = axes.T @ piece.u / (a, a if circular else b)
    offset = math.atan2(y, x)  # where u stands among the half axes
    first, last = (angle + offset for angle in (piece.first, piece.last))
    if first > last:  # edges run with their parameter
        first, last = last, first
    curve = Part.Circle(App.Vector(), App.Vector(0, 0, 1), a) if circular else _oval(a, b)
    edge = curve.toShape(first, min(last, first + 2 * math.pi))
    normal = np.cross(axes[:, 0], axes[:, 1])
    frame = np.eye(4)
    frame[:3, :3] = np.column_stack([axes[:, 0], np.cross(normal, axes[:, 0]), normal])
    frame[:3, 3] = piece.centre
    edge.Placement = App.Placement(matrix_of(frame))
    return edge


def _oval(a, b):
    return Part.Ellipse(App.Vector(), a, b)


def _vector(point: Array) -> App.Vector:
    return App.Vector(*point.tolist())
