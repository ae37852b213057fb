# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loose pieces of curves become chains: one rule for files and for linked geometry.

Ends that lie within a tolerance of each other belong together. Where two ends meet they are joined;
where more do, those two go together that run on straightest, so that a crossing stays two curves
and a branch leaves its trunk alone. What lies across a gap is moved there, never bent or stretched:
the longest part of a chain stays where it is.
"""

import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

JOIN = 0.01  # mm: ends this near each other are meant to meet
TOUCHING = 1e-6  # mm: ends this near each other do meet
_STRAIGHT = 30.0  # degrees: at a branch, a path that turns more does not run on
_CROWD = 300  # ends within one tolerance, which nobody compares one by one

Array = NDArray[np.float64]


@dataclass
class Chain:
    """Pieces in path order: ``links`` [(index of the piece, whether it is turned round)].

    ``shifts`` (3,) each: what moves every piece so that it starts where the last one ends.
    ``gap``: the widest gap that this closed. ``closed``: the end meets the start.
    """

    links: list
    shifts: list
    gap: float = 0.0
    closed: bool = False


@dataclass
class _Run:
    links: list
    starts: tuple  # its first and last point
    directions: tuple  # unit vectors out of it, at its first and last point
    length: float
    closed: bool = False
    gap: float = 0.0
    shifts: list = field(default_factory=list)


def chains(
    starts: Array, ends: Array, out: Array, into: Array, lengths: Array, tolerance: float = JOIN
) -> list[Chain]:
    """Chains of pieces, the longest first.

    ``starts``, ``ends`` (n, 3): points of the pieces; ``out``, ``into`` (n, 3): unit directions in
    which a piece runs at its start and at its end; ``lengths`` (n,); ``tolerance`` in the same
    unit. Pieces that touch are joined first, then those with a gap.
    """
    runs = [
        _Run([(k, False)], (starts[k], ends[k]), (-out[k], into[k]), float(lengths[k]),
             shifts=[np.zeros(3)])
        for k in range(len(starts))
    ]  # fmt: skip
    for run in runs:
        run.closed = math.dist(*run.starts) <= min(TOUCHING, run.length / 2)
    for limit in sorted({min(TOUCHING, tolerance), tolerance}):
        runs = _joined(runs, limit)
    runs.sort(key=lambda run: -run.length)
    return [Chain(run.links, run.shifts, run.gap, run.closed) for run in runs]


def nearest_gap(one: Array, other: Array) -> tuple[float, Array]:
    """The smallest distance of two sets of points (n, 3), (m, 3), and the point half way."""
    apart = np.linalg.norm(one[:, None] - other[None], axis=2)
    i, j = np.unravel_index(int(np.argmin(apart)), apart.shape)
    return float(apart[i, j]), (one[i] + other[j]) / 2


def _joined(runs: Sequence[_Run], limit: float) -> list[_Run]:
    """Runs with every pair of ends joined that belongs together within ``limit``."""
    partner = {}
    open_ends = [(k, end) for k, run in enumerate(runs) if not run.closed for end in (0, 1)]
    for node in _nodes([runs[k].starts[end] for k, end in open_ends], limit):
        for a, b in _pairs([open_ends[i] for i in node], runs, limit):
            partner[a], partner[b] = b, a
    seen: Any
    seen, result = set(), []
    for k, run in enumerate(runs):
        if run.closed or k in seen:
            if run.closed:
                result.append(run)
            continue
        path = _path(k, partner)
        seen.update(index for index, _ in path)
        result.append(_concatenated(path, runs, partner))
    return result


def _path(k: int, partner: Mapping[tuple[int, int], tuple[int, int]]) -> list[tuple[int, bool]]:
    """[(run, turned)] from one free end to the other through run ``k``; a ring starts at ``k``."""
    first = (k, 0)
    while first in partner:  # back to the free end
        before, end = partner[first]
        first = (before, 1 - end)
        if first == (k, 0):
            break
    path, here = [], first
    while True:
        index, end = here
        path.append((index, end == 1))
        leaving = (index, 1 - end)
        if leaving not in partner:
            return path
        here = partner[leaving]
        if here == first:
            return path


def _concatenated(
    path: Sequence[tuple[int, bool]],
    runs: Sequence[_Run],
    partner: Mapping[tuple[int, int], tuple[int, int]],
) -> _Run:
    if len(path) == 1 and (path[0][0], 0) not in partner:
        return runs[path[0][0]]
    parts = [_turned(runs[index]) if turned else runs[index] for index, turned in path]
    steps = [b.starts[0] - a.starts[1] for a, b in itertools.pairwise(parts)]
    moves = np.concatenate([np.zeros((1, 3)), -np.cumsum(np.reshape(steps, (-1, 3)), axis=0)])
    moves = moves - moves[int(np.argmax([part.length for part in parts]))]
    links = [link for part in parts for link in part.links]
    shifts = [s + move for part, move in zip(parts, moves, strict=True) for s in part.shifts]
    ends = parts[0].starts[0] + moves[0], parts[-1].starts[1] + moves[-1]
    gaps = [float(np.linalg.norm(step)) for step in steps] + [part.gap for part in parts]
    last_index, turned = path[-1]
    closed = (last_index, int(not turned)) in partner
    if closed:
        gaps.append(math.dist(*ends))
    directions = parts[0].directions[0], parts[-1].directions[1]
    length = sum(part.length for part in parts)
    return _Run(links, ends, directions, length, closed, max(gaps), shifts)


def _turned(run: _Run) -> _Run:
    links = [(k, not turned) for k, turned in run.links[::-1]]
    return _Run(links, run.starts[::-1], run.directions[::-1], run.length, run.closed, run.gap,
                run.shifts[::-1])  # fmt: skip


def _pairs(ends: Sequence[Sequence[int]], runs: Sequence[_Run], limit: float) -> Any:
    """Pairs of the ends (run, end) at one place that belong together."""
    if len(ends) == 2:
        (one, _), (other, _) = ends
        if one == other and runs[one].length <= 2 * limit:
            return []  # a speck is no loop
        return [tuple(ends)]
    turns = []
    for a, b in itertools.combinations(ends, 2):
        cosine = -float(runs[a[0]].directions[a[1]] @ runs[b[0]].directions[b[1]])
        turn = math.degrees(math.acos(max(-1.0, min(1.0, cosine))))
        if a[0] != b[0] and turn <= _STRAIGHT:
            turns.append((turn, a, b))
    taken, pairs = set(), []
    for _, a, b in sorted(turns):
        if a not in taken and b not in taken:
            taken |= {a, b}
            pairs.append((a, b))
    return pairs


def _nodes(points: Any, limit: float) -> list[list[int]]:
    """Groups of two or more points (by index) that lie within ``limit``, directly or in steps."""
    if not points:
        return []
    points = np.asarray(points)
    limit = limit * (1 + 1e-9) + 1e-15 * float(np.abs(points).max())  # rounding, far from home
    points = points - points.min(0)
    root = list(range(len(points)))

    def find(i: int) -> int:
        while root[i] != i:
            root[i] = root[root[i]]
            i = root[i]
        return i

    cell = 2 * limit
    for shift in itertools.product((0.0, 0.5), repeat=3):
        for group in _same_cell(np.floor(points / cell + shift)):
            for i, j in _near(points, group, limit):
                root[find(i)] = find(j)
    groups: dict[Any, Any] = {}
    for i in range(len(points)):
        groups.setdefault(find(i), []).append(i)
    return [group for group in groups.values() if len(group) > 1]


def _same_cell(cells: NDArray) -> list[list[int]]:
    """Groups of indices of equal rows, of two or more."""
    order = np.lexsort(cells.T)
    new = np.any(np.diff(cells[order], axis=0) != 0, axis=1)
    cuts = [0, *(np.flatnonzero(new) + 1).tolist(), len(cells)]
    order = order.tolist()
    return [order[a:b] for a, b in itertools.pairwise(cuts) if b - a > 1]


def _near(points: Any, group: Sequence[int], limit: float) -> Any:
    if len(group) > _CROWD:
        return itertools.pairwise(group)
    if len(group) == 2:
        i, j = group
        return [(i, j)] if math.dist(points[i], points[j]) <= limit else []
    apart = np.linalg.norm(points[group][:, None] - points[group][None], axis=2)
    return [(group[i], group[j]) for i, j in np.argwhere(np.triu(apart <= limit, 1)).tolist()]
