# SPDX-License-Identifier: LGPL-2.1-or-later
"""The state of least energy of a unit of elastic panels whose hinges touch at their cones.

Unknown are the poses of the bodies and, of every panel, the amounts of its softest modes
(`panels.modes`); what a knuckle gives way by is found by the contact itself (`springs`). Newton's
method with the barrier of the cones, made sharper in stages (docs/theory/hinges.md 4).
Lengths mm, forces N, energies N·mm.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..thick.closure import FIRST, RIGHT, SECOND, Closure, solved
from ..units.creases import BODIES
from .springs import cones

STAGES = (3e-3, 2e-4)  # sharpness of the barrier, N·mm: some 0.01 N·mm is left of it
_ROUGH, _ACCURATE = 1e-3, 1e-6  # of the energy, that Newton's last step may still gain
_SAME = 3e-3  # of the cost: two rough searches that found the same state
_NB = len(BODIES)
ROUNDS = 40
_HARDEST = 1e6  # damping at which a step is none


@dataclass(frozen=True)
class ElasticUnit:
    """One unit's contacts, and what its panels and knuckles give way by.

    Contacts are padded: 23 hinges of k places, those that are not ``valid`` count nothing.
    ``points`` (23, k, 3), ``axes`` (23, 3), ``slope``, ``lean``, ``valid`` (23, k), ``gap``: as of
    `contact.Contacts`; ``modes``: two arrays (23, k, 3, m), displacements of the first and the
    second body's point by their modes; ``give``: two arrays (23, k, 3, 3), compliance of their
    knuckles, mm/N, all in the unit's flat frame; ``leg`` (3,) at B and ``turn`` (radians, signed)
    about it when deployed; ``size``: ‖AB‖.
    """

    points: NDArray
    axes: NDArray
    slope: NDArray
    lean: NDArray
    valid: NDArray
    gap: float
    modes: tuple[NDArray, NDArray]
    give: tuple[NDArray, NDArray]
    leg: NDArray
    turn: float
    size: float

    @property
    def count(self) -> int:
        """Modes of a panel."""
        return self.modes[0].shape[-1]

    @cached_property
    def frames(self) -> NDArray:
        """Frames (23, 3, 3) of the axes in the flat frame: two columns across, one along."""
        up = np.broadcast_to([0.0, 1.0, 0.0], self.axes.shape)
        return np.stack([up, np.cross(self.axes, up), self.axes], -1)

    @cached_property
    def columns(self) -> NDArray:
        """Places (23, 12 + 2m) of each hinge's unknowns among all: first and second body's."""
        each = 6 + self.count
        own = np.arange(each)
        return np.concatenate([FIRST[:, None] * each + own, SECOND[:, None] * each + own], 1)

    @cached_property
    def entries(self) -> NDArray:
        """Places of the hinges' matrices in the matrix of all unknowns, row by row, flat."""
        size = _NB * (6 + self.count)
        return (self.columns[:, :, None] * size + self.columns[:, None, :]).ravel()

    def kept(self, free: bool) -> NDArray:
        """Which of all unknowns are any.

        Not the left contact panel's pose, nor, unless the opening is ``free``, the right one's turn
        about the leg; nor modes that move nothing.
        """
        each = 6 + self.count
        mask = np.zeros((_NB, each), bool)
        mask[1:, :6] = True
        mask[RIGHT, 2] = free
        for modes, bodies in zip(self.modes, (FIRST, SECOND), strict=True):
            moved = (modes != 0).any((1, 2))
            for hinge, body in enumerate(bodies):
                mask[body, 6:] |= moved[hinge]
        return np.flatnonzero(mask.ravel())

    def closure(self, opening: float) -> Closure:
        """Only to hold the right contact panel at an opening (fraction of ``turn``)."""
        turn = np.array([self.turn * opening])
        return Closure(np.zeros((1, 0, 2, 3)), self.leg[None], turn)


@dataclass(frozen=True)
class State:
    """Poses (15, 4, 4), mm, from the flat state, and amounts of modes (15, m)."""

    poses: NDArray
    modes: NDArray


@dataclass(frozen=True)
class Rest:
    """A state of least energy.

    ``energy``: strain energy, N·mm; ``torque``: its derivative by the opening angle, N·mm, which a
    hand must give (negative: the unit opens by itself); ``forces`` (23, k, 3), N: on the second
    body of every contact, in the frame of the axis; ``rough``: what its first, rough search found,
    the same for the same state.
    """

    state: State
    energy: float
    torque: float
    forces: NDArray
    found: bool
    rough: float = 0.0


@dataclass(frozen=True)
class Pull:
    """Dead forces (n, 3), N, on points (n, 3) of the right contact panel (its flat place, mm)."""

    points: NDArray
    forces: NDArray


def start(unit: ElasticUnit, poses: NDArray) -> State:
    """Unstrained panels at given poses (15, 4, 4)."""
    return State(np.array(poses, float), np.zeros((_NB, unit.count)))


def least(
    unit: ElasticUnit, opening: float, state: State, clearance: float = 1.0,
    pull: Pull | None = None, stages: Sequence[float] = STAGES, rounds: int = ROUNDS,
    known: Rest | None = None,
) -> Rest:  # fmt: skip
    """The `Rest` next to a ``state``: at a prescribed opening, or free under a ``pull``.

    ``clearance``: share of the hinges' clearance that is there (1: as printed); ``known``: a rest
    at this opening that may be the same one, which then is not computed again.
    """
    closure = unit.closure(opening)
    if pull is None:
        state = replace(state, poses=closure.held(state.poses[None])[0])
    problem = _Problem(unit, closure, clearance, pull, state)
    found, rough = True, 0.0
    for mu in stages:
        accuracy = _ACCURATE if mu == stages[-1] and pull is None else _ROUGH
        state, found = problem.solve(state, mu, rounds, accuracy)
        if mu == stages[0]:
            rough = problem.at(state, mu).cost
            if known is not None and known.found and abs(rough - known.rough) < _SAME * abs(rough):
                return known
    here = problem.at(state, stages[-1])
    return Rest(state, here.strain, problem.torque(here), here.forces, found, rough)


@dataclass(frozen=True)
class _Here:
    cost: float
    strain: float
    forces: NDArray
    stiffness: NDArray
    there: NDArray  # points carried by the second body
    turned: NDArray  # world -> axis frame
    state: State
    closure: Closure

    @cached_property
    def frame(self) -> NDArray:
        """Of the right contact panel's turn: `Closure.frame`."""
        return self.closure.frame(self.state.poses[None])[0]


_UPPER, _LOWER = (np.array([body.endswith(end) for body in BODIES]) for end in ("_upper", "_lower"))


def _parts(bodies: Any) -> Any:
    """Unknowns of either half of a unit, by their ``bodies``, and the others: for `solved`."""
    upper, lower = _UPPER[bodies], _LOWER[bodies]
    halves = np.flatnonzero(upper), np.flatnonzero(lower)
    return halves, np.flatnonzero(~(upper | lower))


class _Problem:
    def __init__(
        self, unit: ElasticUnit, closure: Closure, clearance: float, pull: Pull | None, state: State
    ) -> None:
        self.unit, self.closure, self.pull = unit, closure, pull
        self.kept = unit.kept(pull is not None)
        self.parts = _parts(self.kept // (6 + unit.count))
        flat = unit.valid.ravel()
        first, second = state.poses[FIRST, :3, :3], state.poses[SECOND, :3, :3]
        # frozen at the start: how far knuckles give depends on poses little
        back = (np.swapaxes(first, -1, -2) @ second)[:, None]
        give = unit.give[0] + back @ unit.give[1] @ np.swapaxes(back, -1, -2)
        frame = unit.frames[:, None]
        give = (np.swapaxes(frame, -1, -2) @ give @ frame).reshape(-1, 3, 3)[flat]
        clear = np.full(len(give), max(clearance * unit.gap, 1e-9 * unit.size))
        self.cones = cones(give, unit.slope.ravel()[flat], unit.lean.ravel()[flat], clear)

    def at(self, state: State, mu: float) -> _Here:
        unit = self.unit
        first, second = state.poses[FIRST], state.poses[SECOND]
        own = unit.points + (unit.modes[0] @ state.modes[FIRST][:, None, :, None])[..., 0]
        other = unit.points + (unit.modes[1] @ state.modes[SECOND][:, None, :, None])[..., 0]
        there = rigid.apply(second, other)
        turned = np.swapaxes(first[:, :3, :3] @ unit.frames, -1, -2)
        apart = (there - first[:, None, :3, 3]) @ first[:, :3, :3] - own
        u = apart @ unit.frames
        flat = unit.valid.ravel()
        cost, strain, force, stiff = self.cones.push(u.reshape(-1, 3)[flat], mu)
        forces, stiffness = np.zeros((flat.size, 3)), np.zeros((flat.size, 3, 3))
        forces[flat], stiffness[flat] = force, stiff
        bent = (state.modes**2).sum() / 2
        shape = unit.valid.shape
        return _Here(
            cost.sum() + bent - self._work(state), strain.sum() + bent,
            forces.reshape(*shape, 3), stiffness.reshape(*shape, 3, 3), there, turned, state,
            self.closure,
        )  # fmt: skip

    def solve(self, state: State, mu: float, rounds: int, accuracy: float) -> tuple:
        """The state of least cost at one sharpness, and whether it was reached."""
        here, damping = self.at(state, mu), 1e-8
        for _ in range(rounds):
            gradient, matrix, scale = self.equations(here)
            step = -self.newton(matrix + damping * np.diag(scale), gradient)
            gain = -gradient @ step / 2
            if gain < 10 * mu and gain < accuracy * max(here.strain, 20 * mu):
                return state, True
            there, share = self.ahead(here, step, gain, mu)
            if there is None:
                damping = max(30 * damping, 1e-6)
                if damping > _HARDEST:
                    return state, False
                continue
            if share == 1:
                damping = max(damping / 30, 1e-10)
            here, state = there, there.state
        return state, False

    def newton(self, matrix: NDArray, gradient: NDArray) -> Any:
        """Solution of Newton's equations: the halves of the unit, which never meet, first."""
        return solved(matrix[None], gradient[None, :, None], *self.parts)[0, :, 0]

    def ahead(
        self, here: _Here, step: NDArray, gain: float, mu: float
    ) -> tuple[_Here | None, float]:
        """Where a share of the step leads that lowers the cost, or None."""
        for share in (1.0, 0.35, 0.1):
            there = self.at(self.moved(here, share * step), mu)
            if there.cost < here.cost - 0.02 * share * gain + 1e-11 * abs(here.cost):
                return there, share
        return None, 0.0

    def equations(self, here: _Here) -> tuple[NDArray, ...]:
        """Gradient and matrix of Newton's equations, and the scale of the unknowns for damping."""
        gradient, matrix = self.assembled(here)
        each = 6 + self.unit.count
        scale = np.zeros((_NB, each))
        scale[:, :3], scale[:, 3:6] = (self.unit.size / 2) ** 2, 1.0
        at = self.kept
        return gradient[at], matrix[at[:, None], at], scale.ravel()[at]

    def assembled(self, here: _Here) -> tuple:
        unit, state = self.unit, here.state
        k = unit.valid.shape[1]
        frame = here.frame
        turned = np.broadcast_to(here.turned[:, None], (len(unit.axes), k, 3, 3))
        twist = np.concatenate([-turned @ rigid.skew(here.there), turned], -1)
        across = np.swapaxes(unit.frames, -1, -2)[:, None]
        second = turned @ state.poses[SECOND, :3, :3][:, None] @ unit.modes[1]
        parts = [-twist, -across @ unit.modes[0], twist.copy(), second]
        for bodies, part in ((FIRST, parts[0]), (SECOND, parts[2])):
            at = np.flatnonzero(bodies == RIGHT)
            part[at, :, :, :3] = part[at, :, :, :3] @ frame
        rows = np.concatenate(parts, -1)
        pushed = (here.stiffness @ rows).reshape(len(rows), 3 * k, -1)
        rows = rows.reshape(len(rows), 3 * k, -1)
        blocks = np.swapaxes(rows, -1, -2) @ pushed
        pulls = (here.forces.reshape(len(rows), 1, 3 * k) @ rows)[:, 0]
        size = _NB * (6 + unit.count)
        gradient = np.bincount(unit.columns.ravel(), pulls.ravel(), size)
        matrix = np.bincount(unit.entries, blocks.ravel(), size * size).reshape(size, size)
        bent = (np.arange(_NB)[:, None] * (6 + unit.count) + 6 + np.arange(unit.count)).ravel()
        gradient[bent] += state.modes.ravel()
        matrix[bent, bent] += 1.0
        self._add_work(gradient, state, frame)
        return gradient, matrix

    def moved(self, here: _Here, step: NDArray) -> "State":
        """The state after a step of the kept unknowns."""
        unit, state = self.unit, here.state
        full = np.zeros(_NB * (6 + unit.count))
        full[self.kept] = step
        full = full.reshape(_NB, -1)
        turn, place = full[:, :3].copy(), full[:, 3:6]
        turn[RIGHT] = here.frame @ turn[RIGHT]
        turn = rigid.rotation(turn)
        place = (turn @ state.poses[:, :3, 3:])[..., 0] + place
        poses = rigid.pose(turn @ state.poses[:, :3, :3], place)
        if self.pull is None:
            poses = self.closure.held(poses[None])[0]
        return State(poses, state.modes + full[:, 6:])

    def torque(self, here: _Here) -> float:
        """Derivative of the energy by the opening angle, N·mm."""
        gradient, _ = self.assembled(here)
        return float(gradient[RIGHT * (6 + self.unit.count) + 2] * np.sign(self.unit.turn))

    def _work(self, state: State) -> float:
        if self.pull is None:
            return 0.0
        there = rigid.apply(state.poses[RIGHT], self.pull.points)
        return (self.pull.forces * (there - self.pull.points)).sum()

    def _add_work(self, gradient: NDArray, state: State, frame: NDArray) -> None:
        if self.pull is None:
            return
        there = rigid.apply(state.poses[RIGHT], self.pull.points)
        at = RIGHT * (6 + self.unit.count)
        gradient[at : at + 3] -= frame.T @ np.cross(there, self.pull.forces).sum(0)
        gradient[at + 3 : at + 6] -= self.pull.forces.sum(0)
