# SPDX-License-Identifier: LGPL-2.1-or-later
"""Needed play: the smallest achievable largest hinge misfit at a given opening (``hinges.md`` 4).

A true minimum of a maximum, not the least-squares figure: minimise δ subject to |r| ≤ δ at every
axis end, by a barrier method whose gap to the optimum is known.
"""

import numpy as np

from .closure import UNKNOWNS, solved

_GROWTH = 40.0  # of the barrier's sharpness from one stage to the next
_ROUNDS = 80
_LONGEST = 0.2  # step of a pose, radians or edge lengths


def smallest_largest(closure, poses, accuracy=1e-3):
    """Smallest largest distance of axis images, near ``poses``.

    ``closure``, ``poses``: n states, of least squared misfit for a start. Returns δ (n,) in edge
    lengths, at most a fraction ``accuracy`` above the (local) optimum, and the poses that reach
    it. δ is 0 where the start closes already.
    """
    largest = closure.gaps(poses).max((1, 2))
    bound, poses = largest.copy(), poses.copy()
    active = np.flatnonzero(largest > 1e-9)
    if not len(active):
        return np.where(largest > 1e-9, largest, 0.0), poses
    cones = 2 * np.prod(closure.axes.shape[1:3])
    level = largest[active] * 1.1
    sharpness = cones / (0.3 * level)
    for _ in range(_ROUNDS):
        part = closure.take(active)
        step, rise, decrement = _newton(part, poses[active], level, sharpness)
        share = _inside(part, poses[active], level, step, rise)
        poses[active] = part.moved(poses[active], share[:, None] * step)
        level = level + share * rise
        bound[active] = part.gaps(poses[active]).max((1, 2))
        central = decrement < 4
        done = central & (cones / sharpness < accuracy * level)
        sharpness = np.where(central, sharpness * _GROWTH, sharpness)
        active, level, sharpness = active[~done], level[~done], sharpness[~done]
        if not len(active):
            break
    return np.where(largest > 1e-9, bound, 0.0), poses


def _newton(closure, poses, level, sharpness):
    """Newton step of sharpness·δ − Σ log(δ² − |r|²): of the poses, of δ, and its decrement."""
    residual = closure.residual(poses)
    room = level[:, None, None] ** 2 - (residual**2).sum(-1)
    push = (2 / room)[..., None] * residual
    metric = (2 / room)[..., None, None] * np.eye(3) + push[..., None] * push[..., None, :]
    cross = -level[:, None, None, None] * (2 / room)[..., None] * push
    matrix, pulled = closure.normal(poses, np.stack([push, cross], -1), metric)
    gradient, mixed = pulled[..., 0], pulled[..., 1]
    slope = sharpness - (2 * level[:, None, None] / room).sum((1, 2))
    bend = ((2 * level[:, None, None] / room) ** 2 - 2 / room).sum((1, 2))
    scale = np.trace(matrix, axis1=1, axis2=2)[:, None, None] / UNKNOWNS
    steps = solved(matrix + 1e-12 * scale * np.eye(UNKNOWNS), pulled)
    by_gradient, by_mixed = steps[..., 0], steps[..., 1]
    rise = -(slope - (mixed * by_gradient).sum(-1)) / (bend - (mixed * by_mixed).sum(-1))
    step = -by_gradient - rise[:, None] * by_mixed
    return step, rise, -((gradient * step).sum(-1) + slope * rise)


def _inside(closure, poses, level, step, rise):
    """Share of the step, at most 1, that keeps every axis end well within its bound.

    Far from the optimum a step may be of any length: it is held to `_LONGEST` and to twice δ.
    """
    with np.errstate(divide="ignore"):
        share = np.minimum(level / np.abs(rise), _LONGEST / np.abs(step).max(-1))
    share = np.minimum(share, 1)
    residual = closure.residual(poses)
    old = level**2 - (residual**2).sum(-1).max((1, 2))
    for _ in range(40):
        there = level + share * rise
        gaps = closure.gaps(closure.moved(poses, share[:, None] * step)).max((1, 2))
        bad = (there <= 0) | (there**2 - gaps**2 < 0.05 * old)
        if not bad.any():
            break
        share = np.where(bad, 0.8 * share, share)
    return share
