# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bounding trees of meshes, and which triangles of two bodies come near each other.

Every node is bounded between parallel planes in `DIRECTIONS`, which hugs slanted strips much closer
than a box does. A body's tree is built once; for another pose only its bounds are made anew.
All pairs of bodies walk down their trees together, level by level, in arrays.
"""

import numpy as np

from . import triangles

_ALIKE = 1e6  # copies of a pair of bodies lie alike within a millionth of a mm
_BLOCK = 1 << 15  # pairs of nodes whose bounds are compared at a time


def _directions():
    """Unit vectors (k, 3): eight in the plan of a flat print, its axis, and slanted ones."""
    turns = np.array([0, 4, 2, 6, 1, 3, 5, 7]) * np.pi / 8  # the most telling ones first
    plan = np.stack([np.cos(turns), np.sin(turns), np.zeros(8)], 1)
    slanted = np.array([[i, j, 1.0] for i, j in ((1, 0), (-1, 0), (0, 1), (0, -1))]) / np.sqrt(2)
    return np.concatenate([[[0, 0, 1.0]], plan, slanted])


DIRECTIONS = _directions()


class Tree:
    """A balanced tree over the triangles of one `Mesh`; leaf k holds triangle ``order[k]``.

    Nodes are numbered as in a heap: 0 the root, 2 i + 1 and 2 i + 2 below node i. Leaves left over
    (order −1) are empty.
    """

    def __init__(self, mesh):
        self.mesh = mesh
        corners = mesh.corners
        self.depth = max(int(np.ceil(np.log2(max(len(corners), 1)))), 0)
        self.order = _balanced(corners.mean(1), self.depth)

    @property
    def first_leaf(self):
        """Number of the first leaf."""
        return (1 << self.depth) - 1

    def bounds(self, pose):
        """Lowest and highest values (k, n) of all nodes along `DIRECTIONS`, posed by (4, 4)."""
        vertices = self.mesh.vertices @ pose[:3, :3].T + pose[:3, 3]
        values = (vertices @ DIRECTIONS.T).T.astype(np.float32)
        values = [values[:, self.mesh.triangles[:, corner]] for corner in range(3)]
        low = np.full((len(DIRECTIONS), 2 * len(self.order) - 1), np.inf, np.float32)
        high = np.full_like(low, -np.inf)
        full = np.flatnonzero(self.order >= 0)
        leaves, own = self.first_leaf + full, self.order[full]
        low[:, leaves] = triangles.least_of_three(np.stack(values, 1))[:, own]
        high[:, leaves] = triangles.most_of_three(np.stack(values, 1))[:, own]
        for level in range(self.depth, 0, -1):
            start, end = (1 << level) - 1, (1 << (level + 1)) - 1
            above = slice((1 << (level - 1)) - 1, start)
            low[:, above] = np.minimum(low[:, start:end:2], low[:, start + 1 : end : 2])
            high[:, above] = np.maximum(high[:, start:end:2], high[:, start + 1 : end : 2])
        return low, high


def _balanced(centres, depth):
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

    def __init__(self, trees, poses):
        self.trees, self.poses = trees, np.asarray(poses, float)
        parts = [tree.bounds(pose) for tree, pose in zip(trees, self.poses, strict=True)]
        self.low = np.concatenate([low for low, _ in parts], 1)
        self.high = np.concatenate([high for _, high in parts], 1)
        self.start = _starts(low.shape[1] for low, _ in parts)
        self.leaf = np.array([tree.first_leaf for tree in trees])
        meshes = [tree.mesh.moved(pose) for tree, pose in zip(trees, self.poses, strict=True)]
        self.meshes = meshes
        self.offset = _starts(len(mesh.triangles) for mesh in meshes)
        self.corners = np.concatenate([mesh.corners for mesh in meshes])
        self.normals, self.heights = triangles.planes(self.corners)
        self._order = np.concatenate([tree.order for tree in trees])
        self._order_start = _starts(len(tree.order) for tree in trees)

    def distinct(self, pairs):
        """Rows of ``pairs`` that are no copies of others, and which of these each row is like."""
        index = {id(tree): k for k, tree in enumerate(dict.fromkeys(self.trees))}
        kind = np.array([index[id(tree)] for tree in self.trees])
        first, second = np.asarray(pairs, int).reshape(-1, 2).T
        swap = kind[first] > kind[second]
        first, second = np.where(swap, second, first), np.where(swap, first, second)
        between = np.linalg.inv(self.poses)[first] @ self.poses[second]
        keys = np.rint(between[:, :3].reshape(-1, 12) * _ALIKE).astype(np.int64)
        keys = np.column_stack([kind[first], kind[second], keys])
        _, rows, which = np.unique(keys, axis=0, return_index=True, return_inverse=True)
        return rows, which.ravel()

    def body_pairs(self, reach):
        """Pairs (m, 2) of bodies, first < second, whose bounds are nearer than ``reach`` mm."""
        roots = self.start
        first, second = np.triu_indices(len(roots), 1)
        near = self._nearer(roots[first], roots[second], np.full(len(first), reach))
        return np.stack([first[near], second[near]], 1)

    def near_triangles(self, pairs, reach):
        """Triangles nearer than ``reach`` mm by their bounds, for ``pairs`` (m, 2) of bodies.

        Returns (index of the pair, triangle of the first, triangle of the second body), each (n,);
        triangles are rows of ``corners``. ``reach``: a number, or (m,). A body paired with itself
        gives every two of its triangles once.
        """
        pairs = np.asarray(pairs, int).reshape(-1, 2)
        reach = np.broadcast_to(np.asarray(reach, np.float32), len(pairs))
        found = [self._walk(pairs, reach, part) for part in _parts(len(pairs))]
        return _joined(found)

    def _walk(self, pairs, reach, which):
        a = np.zeros(len(which), int)
        b = a.copy()
        found = []
        while len(which):
            nodes = self.start[pairs[which, 0]] + a, self.start[pairs[which, 1]] + b
            keep = self._nearer(*nodes, reach[which])
            which, a, b = which[keep], a[keep], b[keep]
            leaf_a, leaf_b = self.leaf[pairs[which, 0]], self.leaf[pairs[which, 1]]
            done = (a >= leaf_a) & (b >= leaf_b)
            w = which[done]
            first = self._triangle(pairs[w, 0], a[done] - leaf_a[done])
            second = self._triangle(pairs[w, 1], b[done] - leaf_b[done])
            found.append((w, first, second))
            which, a, b = _below(which[~done], a[~done], b[~done], leaf_a[~done], leaf_b[~done])
            once = (a < b) | ((a == b) & (a < self.leaf[pairs[which, 0]]))
            once |= pairs[which, 0] != pairs[which, 1]
            which, a, b = which[once], a[once], b[once]
        return _joined(found)

    def _triangle(self, body, leaf):
        return self.offset[body] + self._order[self._order_start[body] + leaf]

    def _nearer(self, a, b, reach):
        """Rows of the pairs of nodes (n,), (n,) whose bounds are nearer than ``reach`` (n,)."""
        kept = []
        for k in range(0, len(a), _BLOCK):
            rows = np.arange(k, min(k + _BLOCK, len(a)))
            i, j, limit = a[rows], b[rows], reach[rows]
            for low, high in zip(self.low, self.high, strict=True):
                gap = np.maximum(low[i] - high[j], low[j] - high[i])
                near = np.flatnonzero(gap < limit)
                if len(near) < len(rows):
                    rows, i, j, limit = rows[near], i[near], j[near], limit[near]
            kept.append(rows)
        return np.concatenate(kept) if kept else np.zeros(0, int)


def _parts(count, size=256):
    return [np.arange(k, min(k + size, count)) for k in range(0, count, size)]


def _starts(lengths):
    return np.cumsum([0, *lengths])[:-1]


def _joined(parts):
    if not parts:
        return tuple(np.zeros((3, 0), int))
    return tuple(np.concatenate(column) for column in zip(*parts, strict=True))


def _below(which, a, b, leaf_a, leaf_b):
    """Pairs of the nodes below: of both, or of the one that is not a leaf."""
    deep_a, deep_b = a < leaf_a, b < leaf_b
    new_which, new_a, new_b = [], [], []
    for i in (0, 1):
        for j in (0, 1):
            use = (deep_a | (i == 0)) & (deep_b | (j == 0))
            new_which.append(which[use])
            new_a.append(np.where(deep_a, 2 * a + 1 + i, a)[use])
            new_b.append(np.where(deep_b, 2 * b + 1 + j, b)[use])
    return np.concatenate(new_which), np.concatenate(new_a), np.concatenate(new_b)
