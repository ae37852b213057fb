# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boundary of a body as data: vertices, edges, faces; its volume and areas (hinges.md 7).

Edges are lines and arcs, faces are planes and *ruled* faces: the straight lines between two edges
that are run through alike. Between two arcs that is a cylinder, a cone or, where the axes of a
general unit are not quite parallel, an oblique cylinder; between two lines a warped quadrilateral.
Faces share their edges, so a body is closed by construction: every edge is run through once each
way. From the same data come a kernel's solid (`brep_text`) and a watertight mesh (`meshing`).
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

PLANE, CYLINDER, CONE, OBLIQUE, WARPED = "plane", "cylinder", "cone", "oblique", "warped"
_PARALLEL = 1e-9  # sine of the angle below which an axis and a motion are parallel


@dataclass(frozen=True)
class Ruled:
    """A face of straight lines between edges ``first`` and ``second``, both run through forward.

    ``sides``: the edges from the start of the first to that of the second, and from end to end (one
    and the same where both are full circles); ``sign``: 1 where the outside is along S_u × S_v, the
    first edge's direction × the way to the second, else −1.
    """

    first: int
    second: int
    sides: tuple
    sign: int

    def loop(self) -> list:
        """Edges in the order in which S_u × S_v sees them anticlockwise; ``~k`` is k reversed."""
        start, end = self.sides
        return [self.first, end, ~self.second, ~start]


@dataclass(frozen=True)
class Arcs:
    """Round edges: ``edge`` numbers (a,), ``centre``, ``along``, ``across`` (a, 3), ``sweep`` (a,).

    Points are centre + cos t along + sin t across, t = 0 … sweep (radians); along and across are as
    long as the radius (mm) and upright to each other.
    """

    edge: NDArray
    centre: NDArray
    along: NDArray
    across: NDArray
    sweep: NDArray

    @cached_property
    def radius(self) -> NDArray:
        """(a,) mm."""
        return np.linalg.norm(self.along, axis=1)

    @cached_property
    def axis(self) -> NDArray:
        """(a, 3) unit vectors about which the arcs run anticlockwise."""
        return np.cross(self.along, self.across) / (self.radius**2)[:, None]


@dataclass(frozen=True, eq=False)
class Boundary:
    """One closed body.

    ``vertices`` (v, 3) mm; ``ends`` (e, 2) the vertices of every edge (equal for a full circle);
    ``arcs``: its round edges; ``faces``: for a plane a list of loops of edge numbers, outer loop
    first, anticlockwise from outside (``~k``: edge k run backwards), or a `Ruled` face.
    """

    vertices: NDArray
    ends: NDArray
    arcs: Arcs
    faces: list = field(repr=False)

    @cached_property
    def arc_of(self) -> NDArray:
        """(e,) row in ``arcs`` of every edge, −1 for lines."""
        found = np.full(len(self.ends), -1)
        found[self.arcs.edge] = np.arange(len(self.arcs.edge))
        return found

    @cached_property
    def kinds(self) -> list:
        """Kind of every face: plane, cylinder, cone, oblique or warped."""
        found = [PLANE] * len(self.faces)
        numbers, faces = self.ruled
        if not len(self.arcs.edge):
            return [WARPED if isinstance(face, Ruled) else PLANE for face in self.faces]
        a, b = self.arc_of[np.array([(face.first, face.second) for face in faces]).T]
        move = self.arcs.centre[b] - self.arcs.centre[a]
        off = np.linalg.norm(np.cross(move, self.arcs.axis[a]), axis=1)
        is_straight = off <= _PARALLEL * np.linalg.norm(move, axis=1)
        is_cone = np.abs(self.arcs.radius[a] - self.arcs.radius[b]) > 1e-9
        kinds = np.select([a < 0, is_cone, is_straight], [WARPED, CONE, CYLINDER], OBLIQUE)
        for number, kind in zip(numbers, kinds.tolist(), strict=True):
            found[number] = kind
        return found

    @cached_property
    def edge_areas(self) -> NDArray:
        """(e, 3) each edge's part ½ ∮ r × dr of the vector area (mm²) of a loop."""
        start, end = (self.vertices[self.ends[:, k]] for k in (0, 1))
        found = np.cross(start, end) / 2
        arcs, edge = self.arcs, self.arcs.edge
        move = end[edge] - start[edge]
        sector = (arcs.radius**2 * arcs.sweep)[:, None] * arcs.axis
        found[edge] = (np.cross(arcs.centre, move) + sector) / 2
        return found

    @cached_property
    def planes(self) -> tuple[NDArray, ...]:
        """(numbers of the plane faces, their vector areas (p, 3) mm², a point (p, 3) on each)."""
        numbers = [k for k, face in enumerate(self.faces) if not isinstance(face, Ruled)]
        loops, owner, first = [], [], []
        for row, k in enumerate(numbers):
            loop = [ref for ring in self.faces[k] for ref in ring]
            loops += loop
            owner += [row] * len(loop)
            first.append(loop[0] if loop[0] >= 0 else ~loop[0])
        refs = np.array(loops)
        parts = (
            np.where((refs < 0)[:, None], -1, 1) * self.edge_areas[np.where(refs < 0, ~refs, refs)]
        )
        areas = np.zeros((len(numbers), 3))
        np.add.at(areas, owner, parts)
        return np.array(numbers), areas, self.vertices[self.ends[first, 0]]

    @cached_property
    def ruled(self) -> tuple:
        """(numbers of the ruled faces, the `Ruled` faces)."""
        numbers = [k for k, face in enumerate(self.faces) if isinstance(face, Ruled)]
        return numbers, [self.faces[k] for k in numbers]

    @cached_property
    def volume(self) -> float:
        """Volume, mm³, exact, by the divergence theorem: ⅓ ∮ r · dA over all faces."""
        _, areas, points = self.planes
        total = np.einsum("ij,ij->", areas, points) / 3
        return float(total) + self._ruled_flux() / 3

    def _ruled_flux(self) -> float:
        """∫ S · (S_u × S_v) du dv, signed and summed over all ruled faces."""
        _, faces = self.ruled
        if not faces:
            return 0.0
        table = np.array([(face.first, face.second, face.sign) for face in faces])
        a, b = self.arc_of[table[:, 0]], self.arc_of[table[:, 1]]
        total = 0.0
        for first, second, sign in table[a < 0]:
            p, q = self.vertices[self.ends[first]]
            s, r = self.vertices[self.ends[second]]
            total += sign * _warped_flux(p, q, r, s)
        a, b, sign = a[a >= 0], b[a >= 0], table[a >= 0, 2]
        arcs = self.arcs
        centre, axis, turn = arcs.centre[a], arcs.axis[a], arcs.sweep[a]
        move = arcs.centre[b] - centre
        r0 = arcs.radius[a]
        dr = arcs.radius[b] - r0
        chord = (np.cos(turn) - 1)[:, None] * arcs.along[a] + np.sin(turn)[:, None] * arcs.across[a]
        square = r0 * r0 + r0 * dr + dr * dr / 3
        flux = (1 + dr / r0 / 2) * np.einsum("ij,ij->i", chord, np.cross(move, centre))
        flux += turn * np.einsum("ij,ij->i", axis, square[:, None] * move)
        mean, slope = (r0 + dr / 2) * dr, (r0 / 2 + dr / 3) * dr
        flux -= turn * np.einsum("ij,ij->i", axis, mean[:, None] * centre + slope[:, None] * move)
        return total + float(sign @ flux)

    @cached_property
    def areas(self) -> NDArray:
        """(f,) area of every face, mm²; of oblique and warped faces to a part in 10⁶."""
        found = np.zeros(len(self.faces))
        numbers, areas, _ = self.planes
        found[numbers] = np.linalg.norm(areas, axis=1)
        for k, face in zip(*self.ruled, strict=True):
            found[k] = self._ruled_area(face, self.kinds[k])
        return found

    def _ruled_area(self, face: Ruled, kind: str) -> float:
        a, b = self.arc_of[face.first], self.arc_of[face.second]
        if kind in (CYLINDER, CONE):
            arcs = self.arcs
            dr = arcs.radius[b] - arcs.radius[a]
            slant = np.hypot(dr, np.linalg.norm(arcs.centre[b] - arcs.centre[a]))
            return arcs.sweep[a] * (arcs.radius[a] + dr / 2) * slant
        u = np.linspace(0, 1, 1001)
        first, second = (self.along_edge(edge, u) for edge in (face.first, face.second))
        strips = np.cross(first[1:] - second[:-1], second[1:] - first[:-1])
        return float(np.linalg.norm(strips, axis=1).sum() / 2)

    def along_edge(self, edge: int, fractions: NDArray) -> NDArray:
        """Points (n, 3) of an edge at ``fractions`` (n,) of its length."""
        row = self.arc_of[edge]
        if row < 0:
            start, end = self.vertices[self.ends[edge]]
            return start + np.outer(fractions, end - start)
        turn = fractions * self.arcs.sweep[row]
        return self.arcs.centre[row] + (
            np.outer(np.cos(turn), self.arcs.along[row])
            + np.outer(np.sin(turn), self.arcs.across[row])
        )

    @cached_property
    def round_area(self) -> float:
        """Area of all faces that are not plane, mm²."""
        return float(sum(self.areas[k] for k in self.ruled[0]))

    def bounds(self, matrix: NDArray | None = None) -> NDArray:
        """Lowest and highest coordinates (2, 3), exact, also of the image under ``matrix``."""
        body = self if matrix is None else self.moved(matrix)
        arcs, points = body.arcs, [body.vertices]
        for k in range(3):
            turn = np.arctan2(arcs.across[:, k], arcs.along[:, k])
            for angle in (turn % (2 * np.pi), (turn + np.pi) % (2 * np.pi)):
                rows = np.flatnonzero(angle < arcs.sweep)
                cos, sin = np.cos(angle[rows])[:, None], np.sin(angle[rows])[:, None]
                points.append(arcs.centre[rows] + cos * arcs.along[rows] + sin * arcs.across[rows])
        points = np.concatenate(points)
        return np.stack([points.min(0), points.max(0)])

    def moved(self, matrix: NDArray) -> "Boundary":
        """The boundary carried by a rigid motion or mirror image (4, 4); outside stays outside."""
        matrix = np.asarray(matrix, float)
        turn = matrix[:3, :3]
        arcs = Arcs(
            self.arcs.edge,
            self.arcs.centre @ turn.T + matrix[:3, 3],
            self.arcs.along @ turn.T,
            self.arcs.across @ turn.T,
            self.arcs.sweep,
        )
        faces = self.faces
        if np.linalg.det(turn) < 0:
            faces = [_turned(face) for face in faces]
        return Boundary(self.vertices @ turn.T + matrix[:3, 3], self.ends, arcs, faces)

    def unpaired(self) -> NDArray:
        """Numbers of edges that are not run through exactly once each way: empty if closed."""
        count = np.zeros((len(self.ends), 2), int)
        for face in self.faces:
            loops = [face.loop()] if isinstance(face, Ruled) else face
            backward = isinstance(face, Ruled) and face.sign < 0
            for ref in (ref for loop in loops for ref in loop):
                count[(ref if ref >= 0 else ~ref), int((ref < 0) != backward)] += 1
        return np.flatnonzero((count != 1).any(1))


def _turned(face: Ruled | Sequence[Sequence[int]]) -> Ruled | list[list[int]]:
    """A face of a mirror image: seen from the other side."""
    if isinstance(face, Ruled):
        return Ruled(face.first, face.second, face.sides, -face.sign)
    return [[~ref for ref in reversed(loop)] for loop in face]


def _warped_flux(p: NDArray, q: NDArray, r: NDArray, s: NDArray) -> float:
    """Flux of r through the bilinear face p q r s: the mean of its two triangulations."""

    def tetrahedron(a: NDArray, b: NDArray, c: NDArray) -> float:
        return float(a @ np.cross(b, c)) / 2

    one = tetrahedron(p, q, r) + tetrahedron(p, r, s)
    other = tetrahedron(p, q, s) + tetrahedron(q, r, s)
    return (one + other) / 2
