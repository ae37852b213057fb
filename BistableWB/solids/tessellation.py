# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes to triangle meshes. Bodies that are moved or mirrored copies are meshed once.

Our own solids are meshed from their boundaries; the kernel meshes any other shape.
"""

from collections.abc import Sequence
from functools import lru_cache
from math import pi
from typing import TYPE_CHECKING, Any

import MeshPart
import numpy as np
import Part
from numpy.typing import NDArray

from ..origami.hinges.meshing import CHORD_ERROR, Meshed
from ..origami.hinges.meshing import mesh_of as mesh_of_boundary
from ..origami.meshes import Mesh, PlacedMesh, joined, unpaired_edges
from .matrices import array_of
from .shapes import boundary_of

if TYPE_CHECKING:
    from .tube import Body

# Chords of round edges stay within half of what the checks allow a clearance to lose, and a circle
# has at least eight of them.
LINEAR_DEFLECTION = CHORD_ERROR  # mm
ANGULAR_DEFLECTION = 1.6  # radians
VIEW = 0.5, 1.6  # coarse: it is drawn many times a second
_SAME = 1e5  # corners are the same within a part of a mm
_REMEMBERED = 1500  # bodies, some tubes' worth; then all are forgotten
# Copies in a tube are mirrored up-down or left-right in the frame they were built in.
_MIRRORS = [np.diag([1.0, up, along]) for up in (1.0, -1.0) for along in (1.0, -1.0)]
_TURN, _ALIKE = 2 * pi, 1e-4  # angles (radians) that are the same


class Tessellator:
    """Meshes shapes; those that it has met, also moved or mirrored, come from its memory.

    ``linear`` (mm) and ``angular`` (radians) deflection bound how far flats lie from round faces.
    """

    def __init__(
        self, linear: float = LINEAR_DEFLECTION, angular: float = ANGULAR_DEFLECTION
    ) -> None:
        self.linear, self.angular = linear, angular
        self.forget()

    def forget(self) -> None:
        """Empty the memory."""
        self._known: dict[Any, Any] = {}  # fingerprint -> (`Meshed`, middle, mirror)
        self._bodies: dict[Any, Any] = {}  # number of faces -> [(body, its `Meshed`, matrix)]
        self._count = 0

    def mesh(self, shape: Part.Shape) -> Mesh:
        """Closed `Mesh` of a solid in the frame in which the shape stands."""
        original, matrix = self.original(shape)
        return original.moved(matrix)

    def original(self, shape: Part.Shape) -> tuple[Mesh, NDArray]:
        """The `Mesh` (shared by copies) whose image this shape's is, and the matrix (4, 4)."""
        meshed, matrix = self.meshed(shape)
        return meshed.mesh, matrix

    def meshed(self, shape: Part.Shape) -> tuple[Meshed, NDArray]:
        """`original` with the faces that the triangles lie on: a `Meshed` and the matrix."""
        made = boundary_of(shape)
        if made is not None:
            return mesh_of_boundary(made[0], self.linear), made[1]
        together = self._several(shape)
        if together is not None:
            return together, np.eye(4)
        place = array_of(shape.Placement)
        own = Part.Shape(shape)
        own.Placement = type(shape.Placement)()
        found, between = self._of(own)
        return found, place @ between

    def _several(self, shape: Part.Shape) -> Meshed | None:
        """`Meshed` of a compound of our own solids (ties, pillars), which stay apart."""
        solids = shape.Solids if shape.ShapeType == "Compound" else []
        made = [boundary_of(solid) for solid in solids]
        if not made or None in made:
            return None
        parts = [self.meshed(solid) for solid in solids]
        first = np.cumsum([0, *(solid.countElement("Face") for solid in solids)])[:-1]
        return _joined([
            Meshed(part.mesh.moved(place), part.faces + k, part.cones + k)
            for (part, place), k in zip(parts, first, strict=True)
        ])  # fmt: skip

    def _of(self, own: Part.Shape) -> tuple[Meshed, NDArray]:
        """(`Meshed`, matrix) of a body without its placement; one that was here is found fast."""
        alike = self._bodies.setdefault(own.countElement("Face"), [])
        for body, found, matrix in alike:
            if body.isPartner(own) and body.Orientation == own.Orientation:
                return found, matrix
        if self._count == _REMEMBERED:
            self.forget()
            return self._of(own)
        self._count += 1
        alike.append((own, *self._find(own)))
        return alike[-1][1:]

    def _find(self, own: Part.Shape) -> tuple[Meshed, NDArray]:
        key, middle, mirror = _fingerprint(own)
        if key not in self._known:
            self._known[key] = meshed_of(own, self.linear, self.angular), middle, mirror
        found, its_middle, its_mirror = self._known[key]
        between = np.eye(4)
        between[:3, :3] = mirror @ its_mirror  # mirrors are their own inverse
        between[:3, 3] = middle - between[:3, :3] @ its_middle
        return found, between


@lru_cache(maxsize=3)
def _shared(linear: float, angular: float) -> Tessellator:
    return Tessellator(linear, angular)


def shared(linear: float = LINEAR_DEFLECTION, angular: float = ANGULAR_DEFLECTION) -> Tessellator:
    """The `Tessellator` that view, checks and files have in common: a body is meshed once."""
    return _shared(linear, angular)


def placed_meshes(
    bodies: "Sequence[Body]", linear: float = LINEAR_DEFLECTION, angular: float = ANGULAR_DEFLECTION
) -> list[PlacedMesh]:
    """`PlacedMesh` of every body, of which only name and shape are needed."""
    tessellator = shared(linear, angular)
    return [
        PlacedMesh(
            body.name,
            *tessellator.original(body.shape),
            getattr(body, "unit", 0),
            getattr(body, "members", ()),
            getattr(body, "kind", ""),
        )
        for body in bodies
    ]


def mesh_of(
    shape: Part.Shape, linear: float = LINEAR_DEFLECTION, angular: float = ANGULAR_DEFLECTION
) -> Mesh:
    """Closed `Mesh` of one shape, deflections in mm and radians: see `meshed_of`."""
    made = boundary_of(shape)
    if made is not None:
        return mesh_of_boundary(made[0], linear).mesh.moved(made[1])
    return meshed_of(shape, linear, angular).mesh


def meshed_of(
    shape: Part.Shape, linear: float = LINEAR_DEFLECTION, angular: float = ANGULAR_DEFLECTION
) -> Meshed:
    """`Meshed` of one shape, deflections in mm and radians.

    Solids of a compound stay apart also where they touch. The kernel covers a cone with hundreds of
    points where a strip of triangles is as good: cones are left out and filled between their rims.
    """
    solids = shape.Solids
    if len(solids) > 1:
        parts = [meshed_of(solid, linear, angular) for solid in solids]
        first = np.cumsum([0, *(solid.countElement("Face") for solid in solids)])[:-1]
        return _joined([
            Meshed(part.mesh, part.faces + k, part.cones + k)
            for part, k in zip(parts, first, strict=True)
        ])  # fmt: skip
    every = shape.Faces
    is_cone = np.array([isinstance(face.Surface, Part.Cone) for face in every], bool)
    cones = np.flatnonzero(is_cone)
    if len(cones):
        kept = np.flatnonzero(~is_cone)
        others, faces = _from_kernel(Part.makeCompound([every[k] for k in kept]), linear, angular)
        closed = _with_strips(others, [every[k] for k in cones])
        if closed is not None:
            mesh, strips = closed
            return Meshed(mesh, np.concatenate([kept[faces], cones[strips]]), cones)
    return Meshed(*_from_kernel(shape, linear, angular), cones)


def _joined(parts: Sequence[Meshed]) -> Meshed:
    """Several as one, whose faces are numbered through."""
    faces, cones = (
        np.concatenate([getattr(p, what) for p in parts]) for what in ("faces", "cones")
    )
    return Meshed(joined([part.mesh for part in parts]), faces, cones)


def _from_kernel(shape: Part.Shape, linear: float, angular: float) -> tuple[Mesh, NDArray]:
    """`Mesh` and the face (t,) that each of its triangles lies on."""
    mesh = MeshPart.meshFromShape(
        Shape=shape, LinearDeflection=linear, AngularDeflection=angular, Segments=True
    )
    mesh.removeDuplicatedPoints()
    points, triangles = mesh.Topology
    faces = np.zeros(len(triangles), int)
    for number in range(mesh.countSegments()):
        faces[mesh.getSegment(number)] = number
    vertices = np.array([tuple(point) for point in points], float).reshape(-1, 3)
    return Mesh(vertices, np.array(triangles, int).reshape(-1, 3)), faces


def _fingerprint(shape: Part.Shape) -> tuple[tuple[int, int, bytes], NDArray, NDArray]:
    """(key, middle, mirror) of a shape in its own frame; copies have the same key.

    The copy is the image of the points that the key stands for under mirror and shift to middle.
    """
    places = [tuple(v.Point) for v in shape.Vertexes]
    corners = len(places)
    places += [tuple(e.valueAt((e.FirstParameter + e.LastParameter) / 2)) for e in shape.Edges]
    points = np.array(places)
    middle = (points[:corners].min(0) + points[:corners].max(0)) / 2
    candidates = []
    for mirror in _MIRRORS:
        whole = np.rint((points - middle) @ mirror * _SAME).astype(np.int64)
        candidates.append((whole[np.lexsort(whole.T)].tobytes(), mirror))
    code, mirror = min(candidates, key=lambda entry: entry[0])
    return (len(shape.Faces), len(shape.Edges), code), middle, mirror


def _with_strips(mesh: Mesh, cones: Sequence[Part.Shape]) -> tuple[Mesh, NDArray] | None:
    """The mesh with a strip of triangles for each cone between its rims, and the strips' cones.

    The latter (t,) are numbers in ``cones``, for the triangles added. None where rims do not fit.
    """
    rims = _rims(mesh)
    pairs = _rims_of(cones, rims, mesh.vertices)
    if pairs is None:
        return None
    first = _Rims([rims[a] for a, _ in pairs], mesh.vertices)
    second = _Rims([rims[b][::-1] for _, b in pairs], mesh.vertices)
    strips, which = _strips(first, second)
    whole = Mesh(mesh.vertices, np.concatenate([mesh.triangles, strips]))
    return None if len(unpaired_edges(whole.triangles)) else (whole, which)


def _rims(mesh: Mesh) -> list[NDArray]:
    """Open borders of a mesh as loops (n,) of vertices, each along its edges."""
    following = dict(unpaired_edges(mesh.triangles).tolist())
    loops = []
    while following:
        start, at = following.popitem()
        loop = [start]
        while at != start and at in following:
            loop.append(at)
            at = following.pop(at)
        loops.append(np.array(loop))
    return loops


def _rims_of(
    cones: Sequence[Part.Shape], rims: Sequence[NDArray], vertices: NDArray
) -> NDArray | None:
    """Numbers (c, 2) of the two rims of every cone; None where one has not two."""
    circles = [_circles(face) for face in cones]
    if not rims or any(len(found) != 2 for found in circles):
        return None
    there, wanted = _Rims(rims, vertices), np.array(circles, float).reshape(-1, 4)
    off = np.linalg.norm(wanted[:, None, :3] - there.middles, axis=2)
    off += np.abs(wanted[:, 3:] - there.radii)
    best = off.argmin(1)
    if (off[np.arange(len(best)), best] > 0.05 * wanted[:, 3]).any():
        return None
    return best.reshape(-1, 2)


def _circles(face: Part.Shape) -> list[tuple[float, ...]]:
    """(x, y, z, radius) of the rims of a cone, each rim once (it may be made of arcs)."""
    found: dict[Any, Any] = {}
    for edge in face.Edges:
        curve = edge.Curve
        if isinstance(curve, Part.Circle):
            centre = tuple(curve.Center)
            found.setdefault(tuple(round(x, 4) for x in centre), (*centre, curve.Radius))
    return list(found.values())


class _Rims:
    """Loops of vertices, joined: ``points`` their numbers (p,), ``loop`` which loop each is in."""

    def __init__(self, loops: Sequence[NDArray], vertices: NDArray) -> None:
        counts = np.array([len(loop) for loop in loops])
        self.points, self.loop = np.concatenate(loops), np.repeat(np.arange(len(loops)), counts)
        self.start = np.cumsum(counts) - counts
        self.next = np.arange(len(self.points)) + 1
        self.next[self.start + counts - 1] = self.start
        places = vertices[self.points]
        self.middles = np.add.reduceat(places, self.start) / counts[:, None]
        self.arms = places - self.middles[self.loop]
        self.radii = np.maximum.reduceat(np.linalg.norm(self.arms, axis=1), self.start)

    def frames(self) -> tuple[NDArray, NDArray]:
        """Two directions (loops, 3) in the plane of every loop, the second a quarter turn on."""
        axes = np.add.reduceat(np.cross(self.arms, self.arms[self.next]), self.start)
        axes /= np.linalg.norm(axes, axis=1, keepdims=True)
        first = self.arms[self.start]
        return first, np.cross(axes, first)

    def sorted_by_turn(self, frames: Sequence[NDArray]) -> tuple[NDArray, NDArray]:
        """Vertices (p,) of every loop by their angle in its frame, and where the next one stands.

        The latter (p,) is in radians, three turns further on for every loop.
        """
        along, across = (np.einsum("ij,ij->i", self.arms, axis[self.loop]) for axis in frames)
        turns = np.arctan2(across, along) % _TURN
        turns[turns > _TURN - _ALIKE] = 0.0
        order = np.lexsort((turns, self.loop))
        ends = turns[order][self.next] + _TURN * (self.next <= np.arange(len(order)))
        return self.points[order], ends + 3 * _TURN * self.loop


def _strips(first: _Rims, second: _Rims) -> tuple[NDArray, NDArray]:
    """Triangles between coaxial `_Rims` that run the same way round, and their pair's number.

    At every point of a rim, its edge up to there is joined to where the other rim has got to.
    """
    frames = first.frames()
    (a, a_ends), (b, b_ends) = (rims.sorted_by_turn(frames) for rims in (first, second))
    beside = np.searchsorted(b_ends, a_ends - _ALIKE)
    onto = np.searchsorted(a_ends, b_ends + _ALIKE, side="right")
    for at, here, there in ((beside, first, second), (onto, second, first)):
        stops = np.append(there.start[1:], len(there.points))[here.loop]
        at[at == stops] = there.start[here.loop[at == stops]]
    triangles = [
        np.stack([a[first.next], a, b[beside]], 1),
        np.stack([a[onto], b, b[second.next]], 1),
    ]
    return np.concatenate(triangles), np.concatenate([first.loop, second.loop])
