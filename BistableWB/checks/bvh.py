# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bounding trees of meshes, and which triangles of two bodies come near each other.

Every node is bounded between parallel planes in `DIRECTIONS`, which hugs slanted strips much closer
than a box does. A body's tree is built once; for another pose only its bounds are made anew.
All pairs of bodies walk down their trees together, level by level, in arrays.
"""

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import triangles

if TYPE_CHECKING:
    from ..origami.meshes import Mesh

_TINY = 1e-9  # mm
_ALIKE = 1e6  # copies of a pair of bodies lie alike within a millionth of a mm
_BLOCK = 1 << 14  # pairs of nodes whose bounds are compared at a time
_ROUND = 4  # directions that are compared at a time
_ALL = np.frombuffer(np.ones(2 * _ROUND, bool).tobytes(), np.uint64)[0]  # as many truths as one


def _directions() -> NDArray:
    """Unit vectors (16, 3): the axis of a flat print, seven in its plan, and eight slanted ones."""
    turns = np.array([0, 4, 2, 6, 1, 3, 5]) * np.pi / 8  # the most telling ones first
    plan = np.stack([np.cos(turns), np.sin(turns), np.zeros(7)], 1)
    turns = np.array([1, 3, 5, 7, 0, 2, 4, 6]) * np.pi / 4
    slanted = np.stack([np.cos(turns), np.sin(turns), np.ones(8)], 1) / np.sqrt(2)
    return np.concatenate([[[0, 0, 1.0]], plan, slanted])


DIRECTIONS = _directions()


class Tree:
    """A balanced tree over the triangles of one `Mesh`; leaf k holds triangle ``order[k]``.

    Nodes are numbered as in a heap: 0 the root, 2 i + 1 and 2 i + 2 below node i. Leaves left over
    (order −1) are empty.
    """

    def __init__(self, mesh: "Mesh") -> None:
        self.mesh = mesh
        corners = mesh.corners
        self.depth = max(int(np.ceil(np.log2(max(len(corners), 1)))), 0)
        self.order = _balanced(corners.mean(1), self.depth)
        self.forget()

    def forget(self) -> None:
        """Drop what `own_pairs` found: it is large."""
        self._own: Any = None

    def own_pairs(self, reach: float) -> "tuple[Scene, NDArray, NDArray]":
        """The body's `Scene` in its own frame, and its triangles (n,), (n,) within ``reach`` mm.

        Those of the farthest reach asked for so far are remembered, and given for nearer ones too.
        """
        if self._own is None or self._own[0] < reach:
            scene = Scene([self], np.eye(4)[None])
            _, first, second = scene.near_triangles([(0, 0)], reach)
            self._own = reach, (scene, first, second)
        return self._own[1]

    @property
    def first_leaf(self) -> int:
        """Number of the first leaf."""
        return (1 << self.depth) - 1

    def bounds(self, pose: NDArray) -> list[NDArray]:
        """Bounds of all n nodes along `DIRECTIONS`, posed by (4, 4): a table (n, 8) for every four.

        Its columns are the four lowest values and the four highest ones, these negative: so the
        gap between two nodes is the sum of one's lowest and the other's highest.
        """
        values = (self.mesh.vertices @ pose[:3, :3].T + pose[:3, 3]) @ DIRECTIONS.T
        values = values.astype(np.float32)
        full = np.flatnonzero(self.order >= 0)
        leaves, corners = self.first_leaf + full, self.mesh.triangles[self.order[full]].T
        tables = []
        for k in range(0, len(DIRECTIONS), _ROUND):
            four = values[:, k : k + _ROUND]
            four = np.concatenate([four, -four], 1)
            table = np.full((2 * len(self.order) - 1, 2 * _ROUND), np.inf, np.float32)
            a, b, c = (four.take(column, 0) for column in corners)
            table[leaves] = np.minimum(np.minimum(a, b, out=a), c, out=a)
            for level in range(self.depth, 0, -1):
                start, end = (1 << level) - 1, (1 << (level + 1)) - 1
                above = table[(1 << (level - 1)) - 1 : start]
                np.minimum(table[start:end:2], table[start + 1 : end : 2], out=above)
            tables.append(table)
        return tables


def _balanced(centres: NDArray, depth: int) -> NDArray:
    """Triangles in the order of the leaves: halved at each level along its widest extent."""
    order = np.full(1 << depth, -1)
    order[: len(centres)] = np.arange(len(centres))
    padded = np.concatenate([centres, np.full((1, 3), np.nan)])  # entry −1
    for level in range(depth):
        rows = order.reshape(1 << level, -1)
        points = padded[rows]
        with np.errstate(all="ignore"):
            extent = np.fmax.reduce(points, 1) - np.fmin.reduce(points, 1)
        widest = np.where(np.isnan(extent), -1, extent).argmax(-1)
        keys = np.take_along_axis(points, widest[:, None, None], 2)[..., 0]
        order = np.take_along_axis(rows, np.argsort(keys, axis=1, kind="stable"), 1).ravel()
    return order


class Scene:
    """Bodies in their poses, and the bounds of all of them in one table of nodes.

    ``trees``: one `Tree` a body, the same one for copies; ``poses``: (4, 4) of every body.
    """

    def __init__(self, trees: Sequence[Tree], poses: ArrayLike) -> None:
        self.trees, self.poses = trees, np.asarray(poses, float)
        parts = [tree.bounds(pose) for tree, pose in zip(trees, self.poses, strict=True)]
        self.bounds = [np.concatenate(tables) for tables in zip(*parts, strict=True)]
        self.start = _starts(len(tables[0]) for tables in parts)
        self.leaf = np.array([tree.first_leaf for tree in trees])
        meshes = [tree.mesh.moved(pose) for tree, pose in zip(trees, self.poses, strict=True)]
        self.meshes = meshes
        self.offset = _starts(len(mesh.triangles) for mesh in meshes)
        self.corners = np.concatenate([mesh.corners for mesh in meshes])
        self.normals, self.heights = triangles.planes(self.corners)
        self._order = np.concatenate([tree.order for tree in trees])
        self._order_start = _starts(len(tree.order) for tree in trees)

    def distinct(self, pairs: NDArray) -> tuple[NDArray, NDArray]:
        """Rows of ``pairs`` that are no copies of others, and which of these each row is like."""
        kind = self._kinds
        first, second = np.asarray(pairs, int).reshape(-1, 2).T
        swap = kind[first] > kind[second]
        first, second = np.where(swap, second, first), np.where(swap, first, second)
        between = np.linalg.inv(self.poses)[first] @ self.poses[second]
        keys = np.rint(between[:, :3].reshape(-1, 12) * _ALIKE).astype(np.int64)
        keys = np.column_stack([kind[first], kind[second], keys])
        _, rows, which = np.unique(keys, axis=0, return_index=True, return_inverse=True)
        return rows, which.ravel()

    def like(self, pairs: NDArray, originals: NDArray, points: NDArray) -> NDArray:
        """Where ``points`` (m, 3) of pairs ``originals`` (m, 2) are in the ``pairs`` like them."""
        kind, first = self._kinds, pairs[:, 0]
        same = kind[first] == kind[originals[:, 0]]
        there = np.where(same, originals[:, 0], originals[:, 1])
        carried = self.poses[first] @ np.linalg.inv(self.poses)[there]
        return (carried[:, :3, :3] @ points[..., None])[..., 0] + carried[:, :3, 3]

    @cached_property
    def _kinds(self) -> NDArray:
        """A number (bodies,) for every body, the same for copies."""
        index = {id(tree): k for k, tree in enumerate(dict.fromkeys(self.trees))}
        return np.array([index[id(tree)] for tree in self.trees])

    @cached_property
    def boxes(self) -> NDArray:
        """Lowest and highest coordinates (bodies, 2, 3) of every body."""
        return np.array([mesh.bounds for mesh in self.meshes])

    def body_pairs(self, reach: float) -> NDArray:
        """Pairs (m, 2) of bodies, first < second, whose bounds are nearer than ``reach`` mm."""
        roots = self.start
        first, second = np.triu_indices(len(roots), 1)
        near = self._nearer(roots[first], roots[second], np.full(len(first), reach))
        return np.stack([first[near], second[near]], 1)

    def near_triangles(self, pairs: ArrayLike, reach: ArrayLike) -> tuple[NDArray, ...]:
        """Triangles nearer than ``reach`` mm by their bounds, for ``pairs`` (m, 2) of bodies.

        Returns (index of the pair, triangle of the first, triangle of the second body), each (n,);
        triangles are rows of ``corners``. ``reach``: a number, or (m,). A body paired with itself
        gives every two of its triangles once.
        """
        pairs = np.asarray(pairs, int).reshape(-1, 2)
        reaches = np.broadcast_to(np.asarray(reach, np.float32), len(pairs))
        found = [self._walk(pairs, reaches, part) for part in _parts(len(pairs))]
        return _joined(found)

    def touching(self, first: NDArray, second: NDArray, reach: float) -> NDArray:
        """Rows of the pairs of triangles (n,), (n,) whose boxes are within ``reach`` mm."""
        corners = self.corners.astype(np.float32)
        low = [triangles.least_of_three(corners[:, :, k]) - reach for k in range(3)]
        high = [triangles.most_of_three(corners[:, :, k]) + reach for k in range(3)]
        rows = np.arange(len(first))
        for least, most in zip(low, high, strict=True):
            i, j = first[rows], second[rows]
            rows = rows[(least[i] <= most[j]) & (least[j] <= most[i])]
        return rows

    def distances(self, one: NDArray, other: NDArray) -> NDArray:
        """Smallest distances (n,) mm of pairs of triangles."""
        return triangles.distances(self.corners.take(one, 0), self.corners.take(other, 0))

    def reaches(self, one: NDArray, other: NDArray) -> tuple[NDArray, NDArray]:
        """Whether triangles ``one`` reach the planes of ``other``, and whether they cross them."""
        low, high = self.above(one, other)
        return (low <= _TINY) & (high >= -_TINY), (low < -_TINY) & (high > _TINY)

    def above(self, one: NDArray, other: NDArray) -> tuple[NDArray, NDArray]:
        """Least and largest heights (n,), (n,) of triangles ``one`` above planes of ``other``."""
        normals, heights = self.normals.take(other, 0), self.heights.take(other)
        found = triangles.dot(self.corners.take(one, 0), normals[:, None])
        return triangles.least_of_three(found) - heights, triangles.most_of_three(found) - heights

    def _walk(self, pairs: NDArray, reach: NDArray, which: NDArray) -> tuple[NDArray, ...]:
        bodies = pairs.T
        starts, leaves = self.start[bodies], self.leaf[bodies]
        is_own = bodies[0] == bodies[1]
        is_own = is_own if is_own.any() else None
        a = np.zeros(len(which), int)
        b = a.copy()
        found = []
        while len(which):
            nodes = starts[0].take(which) + a, starts[1].take(which) + b
            keep = self._nearer(*nodes, reach.take(which))
            which, a, b = (column.take(keep) for column in (which, a, b))
            leaf_a, leaf_b = (leaf.take(which) for leaf in leaves)
            done = (a >= leaf_a) & (b >= leaf_b)
            rows = np.flatnonzero(done)
            if len(rows):
                w = which.take(rows)
                first = self._triangle(bodies[0].take(w), (a - leaf_a).take(rows))
                second = self._triangle(bodies[1].take(w), (b - leaf_b).take(rows))
                found.append((w, first, second))
                rows = np.flatnonzero(~done)
                which, a, b, leaf_a, leaf_b = (
                    column.take(rows) for column in (which, a, b, leaf_a, leaf_b)
                )
            which, a, b = _below(which, a, b, leaf_a, leaf_b)
            if is_own is not None:
                once = (a < b) | ((a == b) & (a < leaves[0].take(which))) | ~is_own.take(which)
                which, a, b = which[once], a[once], b[once]
        return _joined(found)

    def _triangle(self, body: NDArray, leaf: NDArray) -> NDArray:
        return self.offset[body] + self._order[self._order_start[body] + leaf]

    def _nearer(self, a: NDArray, b: NDArray, reach: NDArray) -> NDArray:
        """Rows of the pairs of nodes (n,), (n,) whose bounds are nearer than ``reach`` (n,)."""
        kept = []
        for k in range(0, len(a), _BLOCK):
            part = slice(k, k + _BLOCK)
            i, j, limit = a[part], b[part], reach[part]
            rows = np.arange(k, k + len(i))
            for table in self.bounds:
                one, other = table.take(i, 0), table.take(j, 0)
                gap = np.empty_like(one)
                np.add(one[:, :_ROUND], other[:, _ROUND:], out=gap[:, :_ROUND])
                np.add(one[:, _ROUND:], other[:, :_ROUND], out=gap[:, _ROUND:])
                near = (gap < limit[:, None]).view(np.uint64)[:, 0] == _ALL
                near = np.flatnonzero(near)
                if len(near) < len(rows):
                    rows, i, j, limit = (column.take(near) for column in (rows, i, j, limit))
            kept.append(rows)
        return np.concatenate(kept) if kept else np.zeros(0, int)


def _parts(count: int, size: int = 256) -> list[NDArray]:
    return [np.arange(k, min(k + size, count)) for k in range(0, count, size)]


def _starts(lengths: Iterator[Any]) -> NDArray:
    return np.cumsum([0, *lengths])[:-1]


def _joined(parts: Sequence[Sequence[NDArray]]) -> tuple[NDArray, ...]:
    if not parts:
        return tuple(np.zeros((3, 0), int))
    return tuple(np.concatenate(column) for column in zip(*parts, strict=True))


def _below(
    which: NDArray, a: NDArray, b: NDArray, leaf_a: NDArray, leaf_b: NDArray
) -> tuple[NDArray, ...]:
    """Pairs of the nodes below: of both, or of the one that is not a leaf."""
    deep_a, deep_b = a < leaf_a, b < leaf_b
    both = deep_a & deep_b
    a_next, b_next = (2 * node + 2 for node in (a, b))
    a_first, b_first = np.where(deep_a, a_next - 1, a), np.where(deep_b, b_next - 1, b)
    parts: list[tuple[NDArray, ...]] = [(which, a_first, b_first)]
    for mask, one, other in (
        (deep_b, a_first, b_next),
        (deep_a, a_next, b_first),
        (both, a_next, b_next),
    ):
        rows = None if mask.all() else np.flatnonzero(mask)
        columns = which, one, other
        parts.append(columns if rows is None else tuple(c.take(rows) for c in columns))
    return _joined(parts)
