# SPDX-License-Identifier: LGPL-2.1-or-later
"""The zigzag as a chain of steps, each by its angle theta: in a plane, or on a sphere about V.

A block's frame has its origin in the block's midpoint, x along the normal towards the next unit, z
along the legs and y = z × x: the block's mid-line, which leads to the joint where the next unit's
joint is on the left (side +1), away from it on the right (−1). Sides alternate.
"""

import numpy as np
from numpy.typing import NDArray

from .. import rigid

_NUDGE = 1e-6
_ROUNDS = 8
_TERMS = 24  # of an exponential


def steps(
    thetas: NDArray,
    sides: NDArray,
    radius: float,
    pitch: tuple[float, NDArray],
    distance: float | None = None,
) -> NDArray:
    """Steps (n, 4, 4) from block to block: the rule of `placement` solved for the next midpoint.

    ``thetas`` (n,) radians, ``sides`` (n,) ±1, ``radius`` r = ‖AB‖/2, ``pitch`` (p, p + extra of
    every unit (n,)), ``distance`` of the midpoints from V of concurrent legs, None for parallel.
    """
    sine = np.sin(thetas / 2)
    drop = np.zeros_like(sine)
    for _ in range(1 if distance is None else _ROUNDS):
        cosine = np.sqrt(np.maximum(1 - sine * sine - drop * drop, 0))
        length = 2 * (pitch[1] + radius * sine + pitch[0] * cosine)
        if distance is not None:
            drop = length / (2 * distance)
    ahead = np.stack([cosine, sides * sine, -drop], -1)
    midpoint = length[:, None] * ahead
    leg = np.zeros_like(ahead)
    leg[:, 2] = 1
    if distance is not None:
        leg += midpoint / distance
    along = -2 * (sides * sine)[:, None] * ahead
    along[:, 1] += 1
    found = np.zeros((len(sine), 4, 4))
    for column, vectors in enumerate((np.cross(along, leg), along, leg, midpoint)):
        found[:, :3, column] = vectors
    found[:, 3, 3] = 1
    return found


class Chain:
    """Blocks in space, by the first block's frame and all thetas, with derivatives.

    ``given``: what `steps` takes after the thetas.
    """

    def __init__(
        self,
        start: NDArray,
        thetas: NDArray,
        given: tuple[NDArray, float, tuple[float, NDArray], None],
    ) -> None:
        self.thetas = thetas
        steps_here = steps(thetas, *given)
        nudged = (
            steps(thetas + _NUDGE, *given) - steps(thetas - _NUDGE, *given)
        ) / (2 * _NUDGE)  # fmt: skip
        frames = np.empty((len(thetas) + 1, 4, 4))
        frames[0] = start
        for k, step in enumerate(steps_here):
            frames[k + 1] = frames[k] @ step
        self.frames = frames
        turned = frames[1:]
        self.twists = turned @ rigid.inverse(steps_here) @ nudged @ rigid.inverse(turned)

    @property
    def midpoints(self) -> NDArray:
        """Midpoints (n + 1, 3) of the blocks."""
        return self.frames[:, :3, 3]

    def moves(self, twists: NDArray) -> NDArray:
        """Derivatives of the midpoints (n + 1, 3, n + m) by the thetas and by motions of all.

        ``twists`` (m, 4, 4): motions of the whole chain. Block k hangs on the thetas before it.
        """
        every = np.concatenate([self.twists, twists])
        found = np.einsum("jab,kb->kaj", every[:, :3, :3], self.midpoints)
        found += every[:, :3, 3].T
        count = len(self.thetas)
        found[:, :, :count] *= (np.arange(count) < np.arange(count + 1)[:, None])[:, None]
        return found


def moved(twists: NDArray, amounts: NDArray) -> NDArray:
    """The motion (4, 4) along ``amounts`` (m,) of ``twists`` (m, 4, 4): their exponential."""
    total = np.einsum("m,mab->ab", np.asarray(amounts, float), twists)
    result = term = np.eye(4)
    for k in range(1, _TERMS):
        term = term @ total / k
        result = result + term
    return result


def turn(axis: NDArray, pivot: NDArray) -> NDArray:
    """The twist (4, 4) of turning about an axis through a point."""
    found = np.zeros((4, 4))
    found[:3, :3] = rigid.skew(axis)
    found[:3, 3] = -np.cross(axis, pivot)
    return found


def shift(direction: NDArray) -> NDArray:
    """The twist (4, 4) of moving along a direction."""
    found = np.zeros((4, 4))
    found[:3, 3] = direction
    return found
