# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far the hinges of a unit of thick panels fail to meet, and the poses that fail least.

Every hinge axis is a segment in the flat state that two bodies carry with them; its residual is
the vector between the two images of either end (hinges.md 3). Body 0, the left contact panel,
stays where it is; the right one turns about the leg at B by a prescribed angle (`Closure.turn`).
What is left are 83 unknowns: a small rotation and a displacement of 14 bodies, less that angle.
All arrays are batched over n units or states; lengths are in edge lengths ‖AB‖, so that rotations
and displacements are of one size.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..units.creases import BODIES, CREASES

BODY = {name: i for i, name in enumerate(BODIES)}
FIRST = np.array([BODY[c.bodies[0]] for c in CREASES])
SECOND = np.array([BODY[c.bodies[1]] for c in CREASES])
RIGHT = BODY["contact_right"]
# Columns kept of 15 bodies × (rotation, displacement): not the left contact panel's, nor the right
# one's rotation about the leg, which `Closure.frame` makes the third.
KEPT = np.setdiff1d(np.arange(6, 6 * len(BODIES)), [6 * RIGHT + 2])
UNKNOWNS = len(KEPT)


def _columns(end: str) -> NDArray:
    bodies = [b for b in BODIES if b.endswith(end)]
    wanted = np.concatenate([6 * BODY[b] + np.arange(6) for b in bodies])
    return np.flatnonzero(np.isin(KEPT, wanted))


# Unknowns of the five bodies of each sub-unit, which meet no body of the other, and the rest.
HALVES = tuple(_columns(end) for end in ("upper", "lower"))
REST = np.setdiff1d(np.arange(UNKNOWNS), np.concatenate(HALVES))
_CLOSE = 1e-7  # radians, edge lengths
_AT_ONCE = 48  # states whose matrices fit in a processor's cache


def scatter(first: NDArray, second: NDArray) -> tuple[NDArray, ...]:
    """Where the four 6 × 6 blocks of every pair of bodies go in the normal matrix, for reduceat.

    Their order, where equal places start in it, and the rows and columns of those places.
    """
    n = len(BODIES)
    pairs = np.concatenate([a * n + b for a in (first, second) for b in (first, second)])
    order = np.argsort(pairs, kind="stable")
    filled, starts = np.unique(pairs[order], return_index=True)
    return order, starts, filled // n, filled % n


ORDER, STARTS, ROW, COLUMN = scatter(FIRST, SECOND)


@dataclass(frozen=True)
class Closure:
    """Axes (n, 23, 2, 3), leg at B as unit vectors (n, 3) and the turn about it, radians (n,)."""

    axes: np.ndarray
    leg: np.ndarray
    turn: np.ndarray

    def take(self, index: NDArray | slice) -> "Closure":
        """The closure of some units of the batch."""
        return Closure(self.axes[index], self.leg[index], self.turn[index])

    def images(self, poses: NDArray) -> tuple:
        """Both bodies' images of the axis ends: two arrays (n, 23, 2, 3)."""
        return rigid.apply(poses[:, FIRST], self.axes), rigid.apply(poses[:, SECOND], self.axes)

    def residual(self, poses: NDArray) -> NDArray:
        """Vectors between the images of the axis ends (n, 23, 2, 3)."""
        first, second = self.images(poses)
        return first - second

    def gaps(self, poses: NDArray) -> NDArray:
        """Distance of the images of either axis end (n, 23, 2)."""
        return np.linalg.norm(self.residual(poses), axis=-1)

    def frame(self, poses: NDArray) -> NDArray:
        """Matrices (n, 3, 3): two rotations that keep the right contact's angle, then the leg."""
        swing = poses[:, RIGHT, :3, :3] @ self._back
        return rigid.tangent(rigid.rotation_vector(swing)) @ self._basis

    @cached_property
    def _basis(self) -> Any:
        """Two directions across the leg and the leg itself, columns (n, 3, 3)."""
        helper = np.eye(3)[np.abs(self.leg).argmin(-1)]
        e1 = np.cross(self.leg, helper)
        e1 /= np.linalg.norm(e1, axis=-1, keepdims=True)
        return np.stack([e1, np.cross(self.leg, e1), self.leg], -1)

    @cached_property
    def _back(self) -> Any:
        """Rotations (n, 3, 3) back by the prescribed turn."""
        return rigid.rotation(-self.turn[:, None] * self.leg)

    def held(self, poses: NDArray) -> NDArray:
        """The poses with the right contact panel turned to exactly the prescribed angle."""
        poses = poses.copy()
        turn = poses[:, RIGHT, :3, :3]
        excess = rigid.twist_angle(turn @ self._back, self.leg)
        poses[:, RIGHT, :3, :3] = turn @ rigid.rotation(-excess[:, None] * self.leg)
        return poses

    def blocks(self, poses: NDArray) -> list:
        """Derivatives of the residual by the first and the second body: (n, 23, 6, 6) each."""
        frame = self.frame(poses)
        result = []
        for images, bodies, sign in zip(self.images(poses), (FIRST, SECOND), (1, -1), strict=True):
            block = np.zeros((*images.shape[:2], 2, 3, 6))
            block[..., :3] = rigid.skew(-sign * images)
            block[..., 3:] = sign * np.eye(3)
            right = np.flatnonzero(bodies == RIGHT)
            block[:, right, :, :, :3] = block[:, right, :, :, :3] @ frame[:, None, None]
            result.append(block.reshape(*images.shape[:2], 6, 6))
        return result

    def jacobian(self, poses: NDArray) -> NDArray:
        """Dense derivative of the residual (n, 138, 83) by the unknowns of `moved`."""
        n, hinges = len(poses), np.arange(len(CREASES))
        dense = np.zeros((n, len(CREASES), 6, len(BODIES), 6))
        for block, bodies in zip(self.blocks(poses), (FIRST, SECOND), strict=True):
            dense[:, hinges, :, bodies, :] = np.moveaxis(block, 1, 0)
        return dense.reshape(n, 6 * len(CREASES), -1)[:, :, KEPT]

    def moved(self, poses: NDArray, step: NDArray) -> NDArray:
        """Poses after a step (n, 83): each body turned and displaced, the prescribed angle kept."""
        full = np.zeros((len(poses), 6 * len(BODIES)))
        full[:, KEPT] = step
        full = full.reshape(len(poses), len(BODIES), 6)
        full[:, RIGHT, :3] = (self.frame(poses) @ full[:, RIGHT, :3, None])[..., 0]
        turn = rigid.rotation(full[..., :3])
        place = (turn @ poses[..., :3, 3:])[..., 0] + full[..., 3:]
        return self.held(rigid.pose(turn @ poses[..., :3, :3], place))

    def normal(
        self,
        poses: NDArray,
        pull: NDArray | None = None,
        metric: Any = None,
        curvature: bool = False,
    ) -> tuple:
        """Matrix Jᵀ M J (n, 83, 83) and Jᵀ pull (n, 83, k), J the derivative of the residual.

        ``pull``: (n, 23, 2, 3, k) vectors at the axis ends, the residual itself if None;
        ``metric``: M as (n, 23, 2, 3, 3), the identity if None; ``curvature`` adds the residual's
        second derivatives along the first pull, which for the defaults gives the whole Hessian of
        half the squared residual.
        """
        n, bodies = len(poses), len(BODIES)
        pull = self.residual(poses)[..., None] if pull is None else pull
        both = np.concatenate(self.blocks(poses), -1)
        weighted = both
        if metric is not None:
            weighted = metric @ both.reshape(*metric.shape[:-1], 12)
            weighted = weighted.reshape(both.shape)
        columns = np.concatenate([weighted, pull.reshape(n, -1, 6, pull.shape[-1])], -1)
        product = np.swapaxes(both, -1, -2) @ columns
        if curvature:
            self._add_curvature(product, poses, pull[..., 0])
        square = product[..., :12].reshape(n, -1, 2, 6, 2, 6).transpose(0, 2, 4, 1, 3, 5)
        square = np.add.reduceat(square.reshape(n, -1, 6, 6)[:, ORDER], STARTS, 1)
        matrix = np.zeros((n, bodies, 6, bodies, 6))
        matrix[:, ROW, :, COLUMN, :] = np.moveaxis(square, 1, 0)
        pulled = np.zeros((n, bodies, 6, pull.shape[-1]))
        for k in range(len(CREASES)):
            pulled[:, FIRST[k]] += product[:, k, :6, 12:]
            pulled[:, SECOND[k]] += product[:, k, 6:, 12:]
        matrix = matrix.reshape(n, 6 * bodies, 6 * bodies)[:, KEPT[:, None], KEPT]
        return matrix, pulled.reshape(n, 6 * bodies, -1)[:, KEPT]

    def _add_curvature(self, product: NDArray, poses: NDArray, pull: NDArray) -> None:
        frame = self.frame(poses)[:, None]
        for images, bodies, sign, at in zip(
            self.images(poses), (FIRST, SECOND), (1, -1), (0, 6), strict=True
        ):
            bent = np.swapaxes(pull, -1, -2) @ images
            bent = (bent + np.swapaxes(bent, -1, -2)) / 2
            bent -= np.trace(bent, axis1=-2, axis2=-1)[..., None, None] * np.eye(3)
            right = np.flatnonzero(bodies == RIGHT)
            bent[:, right] = np.swapaxes(frame, -1, -2) @ bent[:, right] @ frame
            product[..., at : at + 3, at : at + 3] += sign * bent


def solved(matrix: NDArray, right: NDArray, parts: Any = HALVES, others: NDArray = REST) -> NDArray:
    """Solutions (n, 83, k) of normal equations (n, 83, 83), (n, 83, k).

    ``parts``: places of unknowns, equally many, between which the matrix is 0, and the ``others``:
    here the two halves of the unit. They are eliminated first: matrices so small that BLAS starts
    no threads for them, which on a busy machine would wait for one another.
    """
    size = len(others)
    halves = np.stack([matrix[:, h[:, None], h] for h in parts])
    across = np.stack([matrix[:, h[:, None], others] for h in parts])
    known = np.stack([right[:, h] for h in parts])
    reduced = np.linalg.solve(halves, np.concatenate([across, known], -1))
    taken = (np.swapaxes(across, -1, -2) @ reduced).sum(0)
    solution = np.empty_like(right)
    rest = np.linalg.solve(
        matrix[:, others[:, None], others] - taken[..., :size], right[:, others] - taken[..., size:]
    )
    solution[:, others] = rest
    for h, part in zip(parts, reduced, strict=True):
        solution[:, h] = part[..., size:] - part[..., :size] @ rest
    return solution


def settle(closure: Closure, poses: NDArray, rounds: int = 60) -> tuple:
    """Poses of least squared misfit next to ``poses``, by damped Newton steps.

    Returns the poses (n, 15, 4, 4) and which of them converged (n,): the last step was below
    1e-7 radians or edge lengths, so that the next, were it taken, would be some 1e-12.
    """
    parts = [
        _settle(closure.take(part), poses[part], rounds)
        for part in (slice(k, k + _AT_ONCE) for k in range(0, len(poses), _AT_ONCE))
    ]
    return tuple(np.concatenate(results) for results in zip(*parts, strict=True))


def _settle(closure: Closure, poses: NDArray, rounds: int) -> tuple[NDArray, NDArray]:
    poses = closure.held(poses)
    cost = (closure.residual(poses) ** 2).sum((1, 2, 3)) / 2
    damping = np.full(len(poses), 1e-9)
    uphill = np.zeros(len(poses), bool)
    active = np.arange(len(poses))
    for _ in range(rounds):
        part, here = closure.take(active), poses[active]
        matrix, gradient = part.normal(here, curvature=True)
        step, gain = _newton(matrix, gradient[..., 0], damping[active], uphill[active])
        there = part.moved(here, step)
        reached = (part.residual(there) ** 2).sum((1, 2, 3)) / 2
        size = np.abs(step).max(-1)
        gained = cost[active] - reached
        # Costs of states so close differ by rounding alone.
        better = (gained >= 0) | (size < _CLOSE)
        poses[active[better]] = there[better]
        cost[active[better]] = reached[better]
        good = better & ((gained > 0.75 * gain) | (size < _CLOSE))
        # A step that damping made short tells nothing.
        done = (size < _CLOSE) & (damping[active] < 1e-6)
        factor = np.select([good, gained > 0.25 * gain, better], [0.1, 1, 5], 20)
        damping[active] = np.clip(damping[active] * factor, 1e-12, 1e3)
        uphill[active] = ~better | (uphill[active] & ~good)
        active = active[~done]
        if not len(active):
            break
    converged = np.ones(len(poses), bool)
    converged[active] = False
    return poses, converged


def _newton(
    matrix: NDArray, gradient: NDArray, damping: NDArray, uphill: NDArray
) -> tuple[NDArray, NDArray]:
    """Newton steps (n, 83) and what they should take off the cost (n,).

    Where a step led ``uphill``, negative curvatures count as positive: next to a fold of the path,
    where the unit jumps to another branch.
    """
    step = np.empty_like(gradient)
    plain = ~uphill
    damped = matrix[plain] + damping[plain, None, None] * np.eye(UNKNOWNS)
    step[plain] = -solved(damped, gradient[plain, :, None])[..., 0]
    if uphill.any():
        curvature, modes = np.linalg.eigh(matrix[uphill])
        along = (np.swapaxes(modes, -1, -2) @ gradient[uphill, :, None])[..., 0]
        along /= np.abs(curvature) + damping[uphill, None]
        step[uphill] = -(modes @ along[..., None])[..., 0]
    slope = (gradient * step).sum(-1)
    bend = (step[:, None] @ matrix @ step[..., None])[:, 0, 0]
    return step, -slope - bend / 2
