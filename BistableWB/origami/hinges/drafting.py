# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws a `Boundary`: vertices, edges that faces share, planes and ruled faces, one by one."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .boundary import Arcs, Boundary, Ruled


class Draft:
    """A boundary in the making.

    Points and directions (three numbers) are given in the frame ``frame`` (4, 4), that of a unit
    for example, and kept in the frame of the body. Edges are numbers; ``~k`` is edge k backwards.
    """

    def __init__(self, frame: NDArray | None = None) -> None:
        self._points: list[Any] = []
        self._ends: list[Any] = []
        self._arcs: list[Any] = []
        self._faces: list[Any] = []
        self._lines: dict[Any, Any] = {}
        self.set_frame(frame)

    def set_frame(self, frame: NDArray | None) -> None:
        """From now on points are given in this frame (None: that of the body)."""
        self._frame = None if frame is None else np.asarray(frame, float).tolist()

    def vertex(self, point: Sequence[float]) -> int:
        """Number of a new vertex."""
        self._points.append(self._carried(point, 1.0))
        return len(self._points) - 1

    def _carried(self, point: Sequence[float], weight: float) -> Any:
        if self._frame is None:
            return point
        x, y, z = point
        return tuple(a * x + b * y + c * z + d * weight for a, b, c, d in self._frame[:3])

    def line(self, a: int, b: int) -> int:
        """Edge from vertex a to vertex b: the one that is there already, either way round."""
        found = self._lines.get((a, b))
        if found is None:
            found = self._edge(a, b)
            self._lines[a, b], self._lines[b, a] = found, ~found
        return found

    def arc(
        self,
        a: int,
        b: int,
        centre: Sequence[float],
        along: Sequence[float],
        across: Sequence[float],
        sweep: float,
    ) -> int:
        """New round edge from vertex a, at centre + along, ``sweep`` radians to vertex b."""
        edge = self._edge(a, b)
        self._arcs.append((
            edge, self._carried(centre, 1.0), self._carried(along, 0.0),
            self._carried(across, 0.0), sweep,
        ))  # fmt: skip
        return edge

    def circle(
        self, centre: Sequence[float], along: Sequence[float], across: Sequence[float]
    ) -> int:
        """New full circle, run through from ``along`` to ``across`` (vectors of its radius)."""
        start = self.vertex(tuple(c + x for c, x in zip(centre, along, strict=True)))
        return self.arc(start, start, centre, along, across, 2 * np.pi)

    def _edge(self, a: int, b: int) -> int:
        self._ends.append((a, b))
        return len(self._ends) - 1

    def plane(self, *loops: Sequence[int]) -> None:
        """Plane face within ``loops`` of edges: the outer one anticlockwise from outside."""
        self._faces.append(list(map(list, loops)))

    def polygon(self, *corners: int) -> None:
        """Plane face with straight edges between vertices, anticlockwise from outside."""
        self.plane(self.ring(corners))

    def ring(self, corners: Sequence[int]) -> list:
        """Closed loop of straight edges through vertices."""
        return [self.line(a, b) for a, b in zip(corners, (*corners[1:], corners[0]), strict=True)]

    def start(self, edge: int) -> int:
        """Vertex at which an edge starts."""
        return self._ends[edge][0] if edge >= 0 else self._ends[~edge][1]

    def outline(self, loop: Sequence[int]) -> NDArray:
        """Points (n, 3) of the body along a closed loop of edges; 24 on a full circle."""
        arcs = {edge: arc for edge, *arc in self._arcs}
        found = []
        for edge in loop:
            own = edge if edge >= 0 else ~edge
            if own not in arcs:
                found.append(np.array([self._points[self.start(edge)]], float))
                continue
            centre, along, across, sweep = arcs[own]
            angles = np.linspace(0, sweep, max(int(24 * abs(sweep) / 6.28), 2), endpoint=False)
            round_edge = np.outer(np.cos(angles), along) + np.outer(np.sin(angles), across) + centre
            found.append(round_edge if edge >= 0 else round_edge[::-1])
        return np.concatenate(found)

    def ruled(self, first: int, second: int, sign: float, flat: bool = False) -> None:
        """Face of straight lines between two edges, run through alike (both may be ``~k``).

        ``sign``: 1 where its outside is along the first edge's direction × the way to the second,
        else −1; ``flat``: both are lines of one plane.
        """
        if first < 0:
            first, second, sign = ~first, ~second, -sign
        sides = tuple(self.line(self._ends[first][k], self._end_of(second, k)) for k in (0, 1))
        if flat:
            loop = [first, sides[1], ~second, ~sides[0]]
            self.plane(loop if sign > 0 else [~ref for ref in reversed(loop)])
            return
        if second < 0:
            raise ValueError("A ruled face needs both its edges drawn the same way.")
        self._faces.append(Ruled(first, second, sides, int(sign)))

    def _end_of(self, edge: int, k: int) -> int:
        return self._ends[edge][k] if edge >= 0 else self._ends[~edge][1 - k]

    def boundary(self) -> Boundary:
        """The finished `Boundary`."""
        edge, centre, along, across, sweep = (
            zip(*self._arcs, strict=True) if self._arcs else [()] * 5
        )
        centres, alongs, acrosses = (
            np.array(v, float).reshape(-1, 3) for v in (centre, along, across)
        )
        arcs = Arcs(np.array(edge, int), centres, alongs, acrosses, np.array(sweep, float))
        ends = np.array(self._ends, int).reshape(-1, 2)
        return Boundary(np.array(self._points, float), ends, arcs, self._faces)
