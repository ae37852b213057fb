# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a plane polygon with many holes: a sweep cuts it into monotone parts, then flips.

The sweep is that of Garey, Johnson, Preparata and Tarjan (1978): from top to bottom, a diagonal at
every corner where parts split or merge. Edges are then flipped until none can be made better
(Lawson 1977), so that corners in one line, as ribs have many, leave no flat triangle.
"""

import itertools
from collections.abc import Sequence
from math import atan2

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float]
Triangle = tuple[int, int, int]
Edge = tuple[int, int]

# Of the sweep, rad: ribs lie along the axes and level with each other but for rounding, which a
# sweep along an axis could not tell from a slope.
_DIRECTIONS = 0.618, 1.234, 0.317, 2.2
_BETTER = 1e-9  # relative, by which a flip must be better


def swept(plan: NDArray, size: Sequence[int]) -> NDArray:
    """Triangles (t, 3) of the corners of one polygon, ``plan`` (n, 2).

    ``size``: how many corners each loop has: the outer one first and anticlockwise, holes
    clockwise, all clear of each other.
    """
    after, before, start = [0] * len(plan), [0] * len(plan), 0
    for count in size:
        for k in range(count):
            here, following = start + k, start + (k + 1) % count
            after[here], before[following] = following, here
        start += count
    wanted = len(plan) + 2 * len(size) - 4
    for angle in _DIRECTIONS:
        turned = (plan[:, 0] + 1j * plan[:, 1]) * np.exp(1j * angle)
        found = _swept([(float(z.real), float(z.imag)) for z in turned], after, before)
        if found is not None and len(found) == wanted:
            return found
    raise RuntimeError("A face with holes crosses itself.")


def _swept(points: Sequence[Point], after: list[int], before: list[int]) -> NDArray | None:
    """Triangles by a sweep along y; None where corners are too level for it to tell."""
    try:
        parts = _parts(points, after, _Sweep(points, after, before).diagonals)
    except (KeyError, ValueError, RuntimeError):  # an edge that it does not know as open
        return None
    triangles: list[Triangle] = []
    for part in parts:
        triangles += _monotone(points, part)
    found = flipped(points, triangles, set(enumerate(after)))
    corners = np.array(points)[np.array(found)]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    areas = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    ring = np.array(points)
    following = ring[after]
    whole = (ring[:, 0] * following[:, 1] - ring[:, 1] * following[:, 0]).sum()
    return np.array(found) if abs(np.abs(areas).sum() - whole) <= 1e-9 * whole else None


def _turn(a: Point, b: Point, c: Point) -> float:
    """Twice the area of a triangle, positive where it runs anticlockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _key(point: Point) -> tuple[float, float]:
    """Order in which the sweep meets points: from top to bottom, from left to right."""
    return -point[1], point[0]


class _Sweep:
    """Diagonals that cut a polygon into parts that are monotone in y."""

    def __init__(
        self, points: Sequence[Point], after: Sequence[int], before: Sequence[int]
    ) -> None:
        self.points, self.after, self.before = points, after, before
        self.diagonals: list[Edge] = []
        # Edges with the inside on their right, by their upper corners; of these: the last corner
        # seen right of it, and whether parts merge there.
        self._open: list[int] = []
        self._helper: dict[int, tuple[int, bool]] = {}
        for v in sorted(range(len(points)), key=lambda v: _key(points[v])):
            self._meet(v)

    def _meet(self, v: int) -> None:
        p, a, b = self.points[v], self.points[self.before[v]], self.points[self.after[v]]
        a_below, b_below = _key(a) > _key(p), _key(b) > _key(p)
        convex = _turn(a, p, b) > 0
        if a_below and b_below:
            if not convex:  # parts split
                left = self._left_of(p)
                self.diagonals.append((v, self._helper[left][0]))
                self._helper[left] = v, False
            self._begin(v)
        elif not a_below and not b_below:
            self._finish(self.before[v], v)
            if not convex:  # parts merge
                self._reach(v, merges=True)
        elif b_below:  # the inside lies to the right
            self._finish(self.before[v], v)
            self._begin(v)
        else:
            self._reach(v)

    def _begin(self, edge: int) -> None:
        self._open.append(edge)
        self._helper[edge] = edge, False

    def _finish(self, edge: int, v: int) -> None:
        helper, merges = self._helper.pop(edge)
        self._open.remove(edge)
        if merges:
            self.diagonals.append((v, helper))

    def _reach(self, v: int, merges: bool = False) -> None:
        left = self._left_of(self.points[v])
        helper, merged = self._helper[left]
        if merged:
            self.diagonals.append((v, helper))
        self._helper[left] = v, merges

    def _left_of(self, p: Point) -> int:
        """The open edge next to the left of a point."""
        best, place = None, -np.inf
        for edge in self._open:
            (x0, y0), (x1, y1) = self.points[edge], self.points[self.after[edge]]
            x = x0 if y0 == y1 else x0 + (x1 - x0) * (y0 - p[1]) / (y0 - y1)
            if place < x <= p[0] and _turn((x0, y0), (x1, y1), p) >= 0:
                best, place = edge, x
        if best is None:
            raise RuntimeError("A face with holes crosses itself.")
        return best


def _parts(
    points: Sequence[Point], after: Sequence[int], diagonals: Sequence[Edge]
) -> list[list[int]]:
    """Loops of corners, anticlockwise, into which diagonals cut the polygon.

    RuntimeError where two edges are followed by the same one: a diagonal lies outside.
    """
    leaving = {v: [after[v]] for v in range(len(points))}
    for a, b in diagonals:
        leaving[a].append(b)
        leaving[b].append(a)
    around = {}
    for v, others in leaving.items():
        x, y = points[v]
        around[v] = sorted((atan2(points[w][1] - y, points[w][0] - x), w) for w in others)
    following = {}
    for v, others in leaving.items():
        for w in others:
            back = atan2(points[v][1] - points[w][1], points[v][0] - points[w][0])
            ways = around[w]
            lower = [other for angle, other in ways if angle < back]
            following[v, w] = w, lower[-1] if lower else ways[-1][1]
    if len(set(following.values())) < sum(map(len, leaving.values())):
        raise RuntimeError("A face with holes crosses itself.")
    loops = []
    while following:
        loop, edge = [], next(iter(following))
        while edge in following:
            loop.append(edge[0])
            edge = following.pop(edge)
        loops.append(loop)
    return loops


def _monotone(points: Sequence[Point], loop: Sequence[int]) -> list[Triangle]:
    """Triangles of a polygon that is monotone in y."""
    if len(loop) == 3:
        return [(loop[0], loop[1], loop[2])]
    order = sorted(range(len(loop)), key=lambda k: _key(points[loop[k]]))
    top, bottom = order[0], order[-1]
    count = len(loop)
    on_left, k = set(), top
    while k != bottom:  # anticlockwise from the top: down the left side
        on_left.add(k)
        k = (k + 1) % count
    triangles, stack = [], order[:2]
    for here in order[2:-1]:
        if (here in on_left) != (stack[-1] in on_left):
            for a, b in itertools.pairwise(stack):
                triangles.append(_anticlockwise(points, loop, a, b, here, here in on_left))
            stack = [stack[-1], here]
            continue
        last = stack.pop()
        while stack:
            p, q, r = (points[loop[k]] for k in (stack[-1], last, here))
            turn = _turn(p, q, r) if here in on_left else _turn(r, q, p)
            if turn <= 0:
                break
            triangles.append(
                _anticlockwise(points, loop, stack[-1], last, here, here not in on_left)
            )
            last = stack.pop()
        stack += [last, here]
    for a, b in itertools.pairwise(stack):
        triangles.append(_anticlockwise(points, loop, a, b, bottom, stack[-1] not in on_left))
    return triangles


def _anticlockwise(
    points: Sequence[Point], loop: Sequence[int], a: int, b: int, c: int, turned: bool
) -> Triangle:
    """A triangle the right way round; one without an area as its place in the fan says."""
    turn = _turn(points[loop[a]], points[loop[b]], points[loop[c]])
    turned = turn < 0 or (turn == 0 and turned)
    return (loop[c], loop[b], loop[a]) if turned else (loop[a], loop[b], loop[c])


def flipped(
    points: Sequence[Point], triangles: Sequence[Triangle], border: set[Edge]
) -> list[Triangle]:
    """The triangles with edges flipped, but for those of the border, until all are well shaped."""
    third: dict[Edge, int] = {}
    for a, b, c in triangles:
        third[a, b], third[b, c], third[c, a] = c, a, b
    waiting = {edge for edge in third if edge[::-1] in third and edge not in border}
    left = 20 * len(third)  # flips: each makes it better, so there are not many
    while waiting and left:
        left -= 1
        a, b = waiting.pop()
        if (a, b) not in third or (b, a) not in third:
            continue
        c, d = third[a, b], third[b, a]
        if not _is_better(*(points[k] for k in (a, b, c, d))):
            continue
        for edge in ((a, b), (b, a)):
            del third[edge]
        for p, q, r in ((a, d, c), (d, b, c)):
            third[p, q], third[q, r], third[r, p] = r, p, q
        for edge in ((a, d), (d, b), (b, c), (c, a)):
            if edge[::-1] in third and edge not in border and edge[::-1] not in border:
                waiting.add(edge)
    found = []
    for (a, b), c in third.items():
        if a < b and a < c:
            found.append((a, b, c))
    return found


def _is_better(a: Point, b: Point, c: Point, d: Point) -> bool:
    """Whether c–d is a better diagonal than a–b of the quadrilateral a, d, b, c."""
    if _turn(a, d, c) <= 0 or _turn(d, b, c) <= 0:
        return False
    u, v = (a[0] - c[0], a[1] - c[1]), (b[0] - c[0], b[1] - c[1])
    s, t = (b[0] - d[0], b[1] - d[1]), (a[0] - d[0], a[1] - d[1])
    dot_c, dot_d = u[0] * v[0] + u[1] * v[1], s[0] * t[0] + s[1] * t[1]
    cross_c, cross_d = u[0] * v[1] - u[1] * v[0], s[0] * t[1] - s[1] * t[0]
    size = abs(cross_c * dot_d) + abs(dot_c * cross_d)
    return cross_c * dot_d + dot_c * cross_d < -_BETTER * size
