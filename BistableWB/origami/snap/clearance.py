# SPDX-License-Identifier: LGPL-2.1-or-later
"""Needed clearance: the least factor on it with which rigid bodies stand at an opening.

docs/theory/hinges.md 4: S(x) = min over poses of the largest `contact.Contacts.needed`. With
s = k gap + lean a and y = slope r these are second-order cones |y| <= s, linear in small relative
twists of the hinges' bodies: an interior point method finds the least k and the forces that hold
it there, again and again from where the last step led. Barrels of double hinges that may meet are
three more pairs of bodies, with s what is left between them and y = 0.
"""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..thick.closure import FIRST, KEPT, RIGHT, SECOND, scatter, solved
from ..units.creases import BODIES
from . import barrels
from .contact import YIELD

if TYPE_CHECKING:
    from ..thick.closure import Closure
    from .contact import Contacts

Floats = NDArray[np.float64]
_ROUNDS = 60
_RELINEARISED, _HALVED = 8, 5
_AIMS = 0.1, 0.4  # of the products of values and forces: wanted of the next step, if that was …
_FREE = 0.7  # … longer, or shorter than this
_ROUNDING = 1e-12
_SHORT = 0.95  # of the way to the nearest bound
_BALANCED = 1e-4  # forces that act on nothing, of all of them
_ROUGH = 0.03  # accuracy that the first round needs
_FLIP = np.array([1.0, -1.0, -1.0])
_CLOSED = 1e-6  # factors on the clearance below which a state closes by itself
# Pairs of bodies: the hinges' and, of every double hinge, both that its link joins.
_FIRST, _SECOND = (np.concatenate(both) for both in ((FIRST, barrels.FIRST),
                                                     (SECOND, barrels.SECOND)))  # fmt: skip
_ORDER, _STARTS, _ROW, _COLUMN = scatter(_FIRST, _SECOND)
_HINGES_OF_RIGHT = np.flatnonzero(_FIRST == RIGHT)  # it is the first body of all its hinges


def least_clearance(
    contacts: "Contacts", closure: "Closure", poses: NDArray, accuracy: float = 1e-3
) -> tuple[NDArray, ...]:
    """Least factor k on the clearance at given openings, near ``poses``.

    ``contacts``, ``closure``, ``poses``: n states, all in edge lengths; poses of least squared
    misfit for a start. Returns k (n,), at most a fraction ``accuracy`` above the (local) optimum,
    its derivative (n,) by the closure's turn (radians), and poses that need no more than k. k is 0
    where the start closes already.
    """
    bound = contacts.most_needed(poses)
    slopes, poses = np.zeros(len(poses)), poses.copy()
    forces = np.zeros((len(poses), len(_FIRST), contacts.valid.shape[2], 3))
    active, fresh = np.flatnonzero(bound > _CLOSED), True
    for k in range(_RELINEARISED):
        if not len(active):
            break
        held, part, here = contacts.take(active), closure.take(active), poses[active]
        program = _Program.at(held, part, here)
        room, gap = (0.1, max(accuracy, _ROUGH)) if fresh else (1e-3, accuracy)
        start = (1 + room) * bound[active]
        step, forces[active], slopes[active] = _minimised(
            program, start, None if fresh else forces[active], gap
        )
        reached = _downhill(held, part, here, step, bound[active])
        gained = 1 - reached[0] / bound[active]
        bound[active], poses[active] = reached
        active, fresh = active[(gained > accuracy) | (k == 0)], False
    return bound, slopes, poses


def _downhill(
    contacts: "Contacts", closure: "Closure", poses: NDArray, step: NDArray, bound: NDArray
) -> tuple[NDArray, NDArray]:
    """What is needed (n,), and poses, after as much of a step as lowers it; unmoved if none."""
    share, best, found = np.ones(len(step)), bound.copy(), poses.copy()
    for _ in range(_HALVED):
        there = closure.moved(poses, share[:, None] * step)
        needed = contacts.most_needed(there)
        better = needed < best
        best[better], found[better] = needed[better], there[better]
        left = best >= bound
        if not left.any():
            break
        share = np.where(left, share / 2, 0.0)
    return best, found


def _minimised(
    program: "_Program", level: NDArray, forces: NDArray | None, accuracy: float
) -> tuple[NDArray, ...]:
    """Step (n, 83) that needs least, the contacts' forces and the slope of the factor by the turn.

    Forces (n, 26, m, 3) are the multipliers of the cones: how much the factor changes with them.
    """
    n = len(level)
    steps, slopes, level = np.zeros((n, len(KEPT))), np.zeros(n), level.copy()
    values = program.values_at(steps, level)
    if forces is None:
        forces = program.inverse(values)
        forces /= (program.gaps * forces[..., 0]).sum((1, 2))[:, None, None, None]
    else:
        forces = forces.copy()
    active, aim = np.arange(n), np.full(n, _AIMS[0])
    for _ in range(_ROUNDS):
        part = program if len(active) == n else program.take(active)
        values = part.values_at(steps[active], level[active])
        held = forces[active]
        step, rise, change, slopes[active], unbalanced = part.newton(values, held, aim[active])
        gap = (values * held).sum((1, 2, 3))
        done = (gap < accuracy * level[active]) & (unbalanced < _BALANCED)
        share = np.minimum(1, _SHORT * part.reach(values, part.changed(step, rise)))
        steps[active] += share[:, None] * step
        level[active] += share * rise
        aim[active] = np.where(share > _FREE, *_AIMS)
        share = np.minimum(1, _SHORT * part.reach(held, change))
        forces[active] += share[:, None, None, None] * change
        active = active[~done]
        if not len(active):
            break
    return steps, forces, slopes


@dataclass(frozen=True)
class _Program:
    """Cones linear in the step: values (s, y₁, y₂) = ``values`` + ``rows`` · twist, + k gap in s.

    ``values`` (n, 26, m, 3), ``rows`` (n, 26, 3 m, 6) of 23 hinges and 3 pairs of barrels;
    ``valid`` (n, 26, m); ``turn`` (n, 3, 3): the right contact panel's rotations that count;
    ``leg`` (n, 3): its leg at B; ``gaps`` (26, 1): hinges' clearances.
    """

    values: Floats
    rows: Floats
    valid: NDArray[np.bool_]
    turn: Floats
    leg: Floats
    gaps: Floats

    @classmethod
    def at(cls, contacts: "Contacts", closure: "Closure", poses: NDArray) -> "_Program":
        """The program of small steps from ``poses``."""
        frames = _cone_frames(contacts)
        along, across = contacts.displacement(poses)
        shift = along[..., None] * contacts.axes[:, :, None] + across
        values = (frames @ shift[..., None])[..., 0]
        n, hinges, m = contacts.valid.shape
        rows = (frames @ contacts.arms(poses)).reshape(n, hinges, 3 * m, 6)
        leg = (poses[:, RIGHT, :3, :3] @ closure.leg[..., None])[..., 0]
        room, pull, there = _barrels(contacts, poses, m)
        gaps = np.full((len(_FIRST), 1), contacts.gap)
        gaps[hinges:] *= YIELD
        return cls(
            np.concatenate([values, room], 1), np.concatenate([rows, pull], 1),
            np.concatenate([contacts.valid, there], 1), closure.frame(poses), leg, gaps,
        )  # fmt: skip

    def take(self, index: NDArray) -> "_Program":
        """The program of some states."""
        names = "values", "rows", "valid", "turn", "leg"
        return replace(self, **{name: getattr(self, name)[index] for name in names})

    @property
    def counts(self) -> NDArray:
        """Number of cones (n,)."""
        return self.valid.sum((1, 2))

    def changes(self, step: NDArray) -> NDArray:
        """Change of the values by a step (n, 83)."""
        n = len(step)
        full = np.zeros((n, 6 * len(BODIES)))
        full[:, KEPT] = step
        full = full.reshape(n, len(BODIES), 6)
        full[:, RIGHT, :3] = (self.turn @ full[:, RIGHT, :3, None])[..., 0]
        twists = full[:, _SECOND] - full[:, _FIRST]
        return (self.rows @ twists[..., None]).reshape(self.values.shape)

    def values_at(self, step: NDArray, level: NDArray) -> NDArray:
        """Values after a step (n, 83), with the clearance's factor ``level`` (n,) in s."""
        found = self.values + self.changes(step)
        found[..., 0] += self.gaps * level[:, None, None]
        return found

    def changed(self, step: NDArray, rise: NDArray) -> NDArray:
        """Change of the values by a step (n, 83) and of the factor (n,)."""
        found = self.changes(step)
        found[..., 0] += self.gaps * rise[:, None, None]
        return found

    def inverse(self, values: NDArray) -> NDArray:
        """Gradients (n, 26, m, 3) of Σ log(s² − |y|²) / 2; 0 for padding."""
        scale = np.where(self.valid, 1 / np.where(self.valid, _room(values), 1.0), 0.0)
        return scale[..., None] * (values * _FLIP)

    def newton(self, values: NDArray, forces: NDArray, aim: NDArray) -> tuple[NDArray, ...]:
        """Step (n, 83), rise of the factor, change of forces, slope by the turn, and imbalance."""
        n, hinges, m = self.valid.shape
        metric = self._metric(values, forces)
        mean = (values * forces).sum((1, 2, 3)) / self.counts
        wanted = (aim * mean)[:, None, None, None] * self.inverse(values)
        weighted = metric @ self.rows.reshape(n, hinges, m, 3, 6)
        back = np.swapaxes(self.rows, -1, -2)
        gaps = self.gaps[..., None]
        sides = np.stack([-wanted, gaps * metric[..., 0], forces], -1)
        sides = back @ sides.reshape(n, hinges, 3 * m, 3)
        square = back @ weighted.reshape(self.rows.shape)
        matrix, pulled, about_leg = self._assembled(square, sides)
        slope = 1 - (self.gaps * wanted[..., 0]).sum((1, 2))
        bend = (self.gaps**2 * metric[..., 0, 0]).sum((1, 2))
        by_gradient, by_mixed = np.moveaxis(solved(matrix, pulled[..., :2]), -1, 0)
        mixed = pulled[..., 1]
        rise = -(slope - (mixed * by_gradient).sum(-1)) / (bend - (mixed * by_mixed).sum(-1))
        step = -by_gradient - rise[:, None] * by_mixed
        change = wanted - forces - (metric @ self.changed(step, rise)[..., None])[..., 0]
        unbalanced = np.abs(pulled[..., 2]).max(-1) + np.abs(
            1 - (self.gaps * forces[..., 0]).sum((1, 2))
        )
        return step, rise, change, -about_leg, unbalanced

    def _metric(self, values: NDArray, forces: NDArray) -> NDArray:
        """Nesterov and Todd's scaling (n, 26, m, 3, 3): takes values to forces; 0 for padding."""
        valid = self.valid
        room, room_of_forces = (
            np.sqrt(np.where(valid, _room(each), 1.0)) for each in (values, forces)
        )
        one, two = values / room[..., None], forces / room_of_forces[..., None] * _FLIP
        half = np.sqrt((1 + (one * two * _FLIP).sum(-1)) / 2)
        middle = (one + two) * (_FLIP / np.where(valid, 2 * half, 1.0)[..., None])
        scale = np.where(valid, room_of_forces / room, 0.0)
        found = 2 * middle[..., :, None] * middle[..., None, :]
        found[..., [0, 1, 2], [0, 1, 2]] -= _FLIP
        return scale[..., None, None] * found

    def reach(self, values: NDArray, change: NDArray) -> NDArray:
        """Share (n,) of a change that leads to the nearest bound."""
        room = _room(values)
        half = values[..., 0] * change[..., 0] - (values[..., 1:] * change[..., 1:]).sum(-1)
        discriminant = half**2 - _room(change) * room
        root = np.sqrt(np.maximum(discriminant, 0)) - half
        # Values without y, as of barrels, have discriminant 0, but for rounding.
        meets = self.valid & (root > 0) & (discriminant >= -_ROUNDING * half**2)
        share = np.where(meets, room / np.where(meets, root, 1.0), np.inf)
        return share.min((1, 2))

    def _assembled(self, square: NDArray, sides: NDArray) -> tuple[NDArray, ...]:
        """Matrix (n, 83, 83), vectors (n, 83, k), and the first vector's part about the leg (n,).

        From matrices (n, 26, 6, 6) and vectors (n, 26, 6, k) in the hinges' relative twists.
        """
        n, bodies, right = len(square), len(BODIES), _HINGES_OF_RIGHT
        turn, first, cross, own = self.turn[:, None], -sides, -square, square.copy()
        first[:, right, :3] = np.swapaxes(turn, -1, -2) @ first[:, right, :3]
        cross[:, right, :3] = np.swapaxes(turn, -1, -2) @ cross[:, right, :3]
        own[:, right, :3] = np.swapaxes(turn, -1, -2) @ own[:, right, :3]
        own[:, right, :, :3] = own[:, right, :, :3] @ turn
        blocks = np.stack([own, cross, np.swapaxes(cross, -1, -2), square], 1)
        blocks = np.add.reduceat(blocks.reshape(n, -1, 6, 6)[:, _ORDER], _STARTS, 1)
        matrix = np.zeros((n, bodies, 6, bodies, 6))
        matrix[:, _ROW, :, _COLUMN, :] = np.moveaxis(blocks, 1, 0)
        pulled = np.zeros((n, bodies, 6, sides.shape[-1]))
        for k, (a, b) in enumerate(zip(_FIRST, _SECOND, strict=True)):
            pulled[:, a] += first[:, k]
            pulled[:, b] += sides[:, k]
        matrix = matrix.reshape(n, 6 * bodies, 6 * bodies)[:, KEPT[:, None], KEPT]
        about_leg = -(sides[:, right, :3, 2:].sum(1)[..., 0] * self.leg).sum(-1)
        return matrix, pulled.reshape(n, 6 * bodies, -1)[:, KEPT], about_leg


def _barrels(contacts: "Contacts", poses: NDArray, m: int) -> tuple[NDArray, NDArray, NDArray]:
    """Values (n, 3, m, 3), rows (n, 3, 3 m, 6) and validity (n, 3, m) of pairs of barrels."""
    n, pairs = len(poses), len(barrels.FIRST)
    values, rows = np.zeros((n, pairs, m, 3)), np.zeros((n, pairs, m, 3, 6))
    valid = np.zeros((n, pairs, m), bool)
    if contacts.barrels is not None:
        values[:, :, :2, 0], rows[:, :, :2, 0] = contacts.barrels.room(poses)
        valid[:, :, :2] = True
    return values, rows.reshape(n, pairs, 3 * m, 6), valid


def _room(values: NDArray) -> NDArray:
    """s² − |y|² of values (…, 3)."""
    squares = values * values
    return squares[..., 0] - squares[..., 1] - squares[..., 2]


def _cone_frames(contacts: "Contacts") -> NDArray:
    """Rows (n, 23, m, 3, 3) that take a displacement to lean · a and both parts of slope · r."""
    axes = contacts.axes
    helper = np.eye(3)[np.abs(axes).argmin(-1)]
    first = np.cross(axes, helper)
    first /= np.linalg.norm(first, axis=-1, keepdims=True)
    rows = np.stack([axes, first, np.cross(axes, first)], -2)[:, :, None]
    slope = contacts.slope[..., None]
    return np.concatenate([contacts.lean[..., None], slope, slope], -1)[..., None] * rows
