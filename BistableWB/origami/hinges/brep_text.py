# SPDX-License-Identifier: LGPL-2.1-or-later
"""A boundary as text that a CAD kernel reads as one solid: no sewing, no boolean operation.

The format is OpenCASCADE's own (``.brep``). Curves are lines and circles. On a plane the kernel
finds an edge's place itself; on the other surfaces, all of straight lines between two edges, every
edge is a line in the surface's parameters.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .boundary import CYLINDER, OBLIQUE, WARPED, Boundary

if TYPE_CHECKING:
    from .boundary import Ruled

_TOLERANCE = "1e-07"
_HEAD = "DBRep_DrawableShape\n\nCASCADE Topology V1, (c) Matra-Datavision\nLocations 0\n"
_NUMBER = "%.15g"
_VERTEX = f"Ve\n{_TOLERANCE}\n{{}}\n0 0\n\n0101101\n*\n"


def brep_text(boundary: Boundary) -> str:
    """Text for the kernel (``Part.Shape.importBrepFromString``): one solid."""
    return _Writer(boundary).text()


class _Writer:
    def __init__(self, boundary: Boundary) -> None:
        self.b = boundary
        self.curves, self.ranges = _curves(boundary)
        self.pcurves: list[Any] = []
        self.surfaces: list[Any] = []
        self.on_edges: list[Any] = [[] for _ in boundary.ends]  # lines on each edge's entry
        self.loops: list[Any] = []  # (number of the surface, loops, turned)

    def text(self) -> str:
        boundary = self.b
        numbers, areas, points = boundary.planes
        planes = dict(zip(numbers.tolist(), _plane_lines(areas, points), strict=True))
        ruled = dict(zip(boundary.ruled[0], _ruled_surfaces(boundary), strict=True))
        for number, face in enumerate(boundary.faces):
            if number in planes:
                self.surfaces.append(planes[number])
                self.loops.append((len(self.surfaces), face, False))
            else:
                self._ruled(face, *ruled[number])
        shapes = self._shapes()
        return "".join((
            _HEAD,
            f"Curve2ds {len(self.pcurves)}\n", "".join(self.pcurves),
            f"Curves {len(self.curves)}\n", "".join(self.curves),
            "Polygon3D 0\nPolygonOnTriangulations 0\n",
            f"Surfaces {len(self.surfaces)}\n", "".join(self.surfaces),
            "Triangulations 0\n\n", *shapes,
        ))  # fmt: skip

    def _ruled(self, face: "Ruled", line: str, width: float, height: float) -> None:
        """A ruled face: its surface, and the place of its edges on it."""
        self.surfaces.append(line)
        surface = len(self.surfaces)
        loop, against = face.loop(), height < 0  # the kernel's normal is against S_u × S_v
        if against:
            loop = [~edge for edge in reversed(loop)]
        self.loops.append((surface, [loop], (face.sign < 0) != against))
        start, end = face.sides
        self._on(face.first, surface, (0, 0), (width, 0))
        self._on(face.second, surface, (0, height), (width, height))
        if start == end or start == ~end:
            self._on_seam(start, surface, width, height)
            return
        for edge, u in ((start, 0), (end, width)):
            self._on(edge, surface, (u, 0), (u, height))

    def _on(self, edge: int, surface: int, a: Sequence[float], b: Sequence[float]) -> None:
        """The edge runs on a surface straight from parameters a to b (backwards if ``~k``)."""
        if edge < 0:
            edge, a, b = ~edge, b, a
        span = self.ranges[edge]
        curve = self._pcurve(a, b, span)
        self.on_edges[edge].append(f"2  {curve} {surface} 0 0 {span!r}\n")

    def _on_seam(self, edge: int, surface: int, width: float, height: float) -> None:
        """The edge that a face full round has twice: as its last and as its first line."""
        low, high = (0, height) if edge >= 0 else (height, 0)
        edge = edge if edge >= 0 else ~edge
        span = self.ranges[edge]
        forward = (width, 0) if height > 0 else (0, width)
        last, first = (self._pcurve((u, low), (u, high), span) for u in forward)
        self.on_edges[edge].append(f"3  {last} {first}CN {surface} 0 0 {span!r}\n")

    def _pcurve(self, a: Sequence[float], b: Sequence[float], span: float) -> int:
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = abs(dx) + abs(dy)
        if abs(length - span) <= 1e-9 * span:
            self.pcurves.append(f"1 {a[0]!r} {a[1]!r} {dx / length!r} {dy / length!r}\n")
        else:
            ends = f"{a[0]!r} {a[1]!r}  {b[0]!r} {b[1]!r}"
            self.pcurves.append(f"7 0 0  1 2 2  {ends}\n 0 2 {span!r} 2\n")
        return len(self.pcurves)

    def _shapes(self) -> list[str]:
        """Vertices, edges, wires and faces, shell and solid; each names those before it."""
        vertices, ends = self.b.vertices, self.b.ends.tolist()
        loops = sum(len(face) for _, face, _ in self.loops)
        count = len(vertices) + len(ends) + loops + len(self.loops) + 2
        first_edge = count - len(vertices)  # shapes are named from the last one, which is 1
        parts = [f"TShapes {count}\n"]
        parts += [_VERTEX.format(line) for line in _numbers(self.b.vertices)]
        for number, ((a, b), on, span) in enumerate(
            zip(ends, self.on_edges, self.ranges, strict=True)
        ):
            parts.append(
                f"Ed\n {_TOLERANCE} 1 1 0\n1  {number + 1} 0 0 {span!r}\n{''.join(on)}0\n\n"
                f"0101000\n+{count - a} 0 -{count - b} 0 *\n"
            )
        name = first_edge - len(ends)
        faces = []
        for surface, face, turned in self.loops:
            for loop in face:
                edges = " ".join(
                    f"+{first_edge - k} 0" if k >= 0 else f"-{first_edge - ~k} 0" for k in loop
                )
                parts.append(f"Wi\n\n0101100\n{edges} *\n")
            wires = " ".join(f"+{name - k} 0" for k in range(len(face)))
            name -= len(face)
            parts.append(f"Fa\n0  {_TOLERANCE} {surface} 0\n\n0101000\n{wires} *\n")
            faces.append(f"{'-' if turned else '+'}{name} 0")
            name -= 1
        parts.append(f"Sh\n\n0101100\n{' '.join(faces)} *\nSo\n\n1100000\n+2 0 *\n\n+1 0 \n")
        return parts


def _numbers(rows: NDArray) -> list[str]:
    """Text of every row of numbers."""
    form = " ".join([_NUMBER] * rows.shape[1])
    return [form % tuple(row) for row in rows.tolist()]


def _curves(boundary: Boundary) -> tuple[list[str], list[float]]:
    """Entries of the edges' curves, and where each edge ends on its curve (mm or radians)."""
    start, end = (boundary.vertices[boundary.ends[:, k]] for k in (0, 1))
    move = end - start
    spans = np.linalg.norm(move, axis=1)
    arcs = boundary.arcs
    spans[arcs.edge] = arcs.sweep
    with np.errstate(invalid="ignore", divide="ignore"):
        lines = _numbers(np.concatenate([start, move / spans[:, None]], 1))
    entries = [f"1 {line}\n" for line in lines]
    radius = arcs.radius[:, None]
    table = np.concatenate(
        [arcs.centre, arcs.axis, arcs.along / radius, arcs.across / radius, radius], 1
    )
    for edge, line in zip(arcs.edge.tolist(), _numbers(table), strict=True):
        entries[edge] = f"2 {line}\n"
    return entries, spans.tolist()


def _plane_lines(areas: NDArray, points: NDArray) -> list[str]:
    """Entries of planes with outward normals along ``areas`` (p, 3) through ``points`` (p, 3)."""
    normals = areas / np.linalg.norm(areas, axis=1, keepdims=True)
    x = np.cross(np.eye(3)[np.abs(normals).argmin(1)], normals)
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    table = np.concatenate([points, normals, x, np.cross(normals, x)], 1)
    return [f"1 {line}\n" for line in _numbers(table)]


def _ruled_surfaces(boundary: Boundary) -> list[tuple[str, float, float]]:
    """Entry of every ruled face's surface, and how far its parameters run (first edge, across)."""
    numbers, faces = boundary.ruled
    kinds = [boundary.kinds[k] for k in numbers]
    found: list[Any] = [
        (_warped(boundary, face), 1.0, 1.0) if kind == WARPED else None
        for face, kind in zip(faces, kinds, strict=True)
    ]
    rounded = [row for row, kind in enumerate(kinds) if kind != WARPED]
    if not rounded:
        return found
    arcs, edges = boundary.arcs, [(faces[row].first, faces[row].second) for row in rounded]
    a, b = boundary.arc_of[np.array(edges).T]
    move = arcs.centre[b] - arcs.centre[a]
    length = np.linalg.norm(move, axis=1)
    radius = arcs.radius[a]
    axes = arcs.along[a] / radius[:, None], arcs.across[a] / radius[:, None]
    circles = _numbers(np.concatenate([arcs.centre[a], arcs.axis[a], *axes, radius[:, None]], 1))
    # The kernel's axis points from the first edge to the second, whichever way round that runs.
    way = np.copysign(1.0, (move * arcs.axis[a]).sum(1))
    slope = arcs.radius[b] - radius
    angles, slants = np.arctan2(way * slope, length), way * np.hypot(slope, length)
    rulings = _numbers(move / length[:, None])
    columns = circles, arcs.sweep[a].tolist(), length.tolist(), way.tolist(), angles.tolist()
    for row, circle, sweep, far, sign, angle, slant, ruling in zip(
        rounded, *columns, slants.tolist(), rulings, strict=True
    ):
        if kinds[row] == OBLIQUE:
            found[row] = f"6 {ruling}\n2 {circle}\n", sweep, far
        elif kinds[row] == CYLINDER:
            found[row] = f"2 {circle}\n", sweep, sign * far
        else:
            found[row] = f"3 {circle}\n{angle!r}\n", sweep, slant
    return found


def _warped(boundary: Boundary, face: "Ruled") -> str:
    """Entry of a bilinear surface between two lines."""
    corners = [
        boundary.vertices[boundary.ends[e][k]] for k in (0, 1) for e in (face.first, face.second)
    ]
    poles = "\n".join(" ".join(_numbers(np.array(corners[k : k + 2]))) for k in (0, 2))
    return f"9 0 0 0 0 1 1 2 2 2 2 {poles}\n0 2\n1 2\n0 2\n1 2\n"
