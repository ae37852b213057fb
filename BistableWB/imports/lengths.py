# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths of many pieces at once: a drawing has thousands, and each alone takes as long as all."""

import math
from collections.abc import Callable

import numpy as np

from .pieces import Arc, Array, Piece, Spline

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(16)
_NODES, _WEIGHTS = (_NODES + 1) / 2, _WEIGHTS / 2
_PRECISE = 1e-12  # of the length: where bisecting changes it by less, it is known
_DEEPEST = 24


def measure(pieces: list[Piece]) -> None:
    """Find the lengths of all Béziers and elliptic arcs among ``pieces``, and keep them there."""
    kinds: dict[int, list[Spline]] = {}
    arcs = [piece for piece in pieces if isinstance(piece, Arc) and not piece.is_circular]
    for piece in pieces:
        is_bezier = isinstance(piece, Spline) and len(piece.poles) == piece.degree + 1
        if is_bezier and piece.weights is None:
            kinds.setdefault(piece.degree, []).append(piece)
    for alike in kinds.values():
        _keep(alike, bezier_lengths(np.array([piece.poles for piece in alike])))
    if arcs:
        angles = np.array([(arc.first, arc.last) for arc in arcs])
        _keep(arcs, arc_lengths(np.array([(arc.u, arc.v) for arc in arcs]), angles))


def _keep(pieces, lengths):
    for piece, length in zip(pieces, lengths.tolist(), strict=True):
        piece.__dict__["length"] = length  # where its cached property keeps it


def bezier_lengths(poles: Array) -> Array:
    """Arc lengths (n,) of Béziers by their control points (n, degree + 1, 3)."""
    degree = poles.shape[1] - 1
    basis = np.array([math.comb(degree - 1, k) for k in range(degree)]) * (
        _NODES[:, None] ** np.arange(degree) * (1 - _NODES[:, None]) ** np.arange(degree)[::-1]
    )

    def rule(poles, owner):
        slopes = degree * np.diff(poles, axis=1)
        return np.linalg.norm(np.einsum("qk,nkx->nqx", basis, slopes), axis=2) @ _WEIGHTS

    return _refined(poles, np.arange(len(poles)), rule, _halves)


def arc_lengths(axes: Array, angles: Array) -> Array:
    """Lengths (n,) of elliptic arcs: conjugate radii (n, 2, 3), first and last angles (n, 2)."""
    uu, vv = (axes[:, 0] ** 2).sum(1), (axes[:, 1] ** 2).sum(1)
    uv = (axes[:, 0] * axes[:, 1]).sum(1)

    def rule(spans, owner):
        low, high = spans[:, :1], spans[:, 1:]
        t = low + (high - low) * _NODES
        sine, cosine = np.sin(t), np.cos(t)
        squares = uu[owner, None] * sine**2 + vv[owner, None] * cosine**2
        squares -= 2 * uv[owner, None] * sine * cosine
        return np.sqrt(np.maximum(squares, 0)) @ _WEIGHTS * np.abs(high - low)[:, 0]

    def halves(spans):
        middle = spans.mean(1)
        return np.stack([spans[:, 0], middle], 1), np.stack([middle, spans[:, 1]], 1)

    return _refined(angles, np.arange(len(angles)), rule, halves)


def _refined(spans: Array, owner: Array, rule: Callable, halves: Callable) -> Array:
    """Sums by ``owner`` of ``rule(spans, owner)``, with spans halved until they agree."""
    total, whole = np.zeros(len(spans)), rule(spans, owner)
    scale = whole.copy()
    for _ in range(_DEEPEST):
        left, right = halves(spans)
        lengths = rule(left, owner), rule(right, owner)
        both = lengths[0] + lengths[1]
        done = np.abs(both - whole) <= _PRECISE * scale[owner]
        np.add.at(total, owner[done], both[done])
        spans = np.concatenate([left[~done], right[~done]])
        whole = np.concatenate([lengths[0][~done], lengths[1][~done]])
        owner = np.concatenate([owner[~done], owner[~done]])
        if not len(owner):
            return total
    np.add.at(total, owner, whole)
    return total


def _halves(poles):
    """Both halves of Béziers (de Casteljau)."""
    left, right, level = [poles[:, 0]], [poles[:, -1]], poles
    while level.shape[1] > 1:
        level = (level[:, 1:] + level[:, :-1]) / 2
        left.append(level[:, 0])
        right.append(level[:, -1])
    return np.stack(left, axis=1), np.stack(right[::-1], axis=1)
