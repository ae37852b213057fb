# SPDX-License-Identifier: LGPL-2.1-or-later
"""A zigzag steered along a curve: both ends, even angles, a tolerance (section 5).

Unknown are all thetas and where the first block stands. Least squares of the distances of the
midpoints from the curve and of theta_k − theta_(k+2), with walls at the tolerance and at the band
of thetas, subject to what holds exactly: the ends. Each step is a Gauss-Newton step with these
constraints; the Jacobian of a chain is a lower triangle that comes from one product a unit.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import chain

_AWAY, _WALL, _EVEN, _BAND, _GOAL = 0.05, 200.0, 1.0, 10.0, 0.3
_INSIDE = 0.97  # of the tolerance, where the wall begins
_STEPS = 25
_ROUNDS = 8
_TRIES = 6
_POLISH = 8
_LONGEST = 0.5  # radians, a step
_STIFF = 20.0  # what a constraint that is missed counts beside the squares
_SETTLED = 1e-3
_MET = 1e-9


@dataclass(frozen=True)
class Task:
    """What a steered zigzag should be; lengths in units of the curve, angles in radians.

    ``path``: a `paths.Path`; ``legs``; ``given`` (sides, r, (p, p + extra), distance) of
    `chain.steps`; ``band`` of thetas; ``goal``: theta to prefer; ``square`` (start, end): blocks
    that stand square on the curve; ``symmetric``; ``closed``: the last block is the first.
    """

    path: Any
    legs: Any
    given: tuple
    tolerance: float
    goal: float
    band: tuple = (np.radians(20.0), np.radians(90.0))
    square: tuple = (False, False)
    symmetric: bool = False
    closed: bool = False

    @property
    def edge_length(self) -> float:
        """‖AB‖."""
        return 2 * self.given[1]


class Steering:
    """State of one steered zigzag on its way: see `steered`."""

    def __init__(self, task: Task, start: NDArray, thetas: NDArray, lengths: NDArray) -> None:
        self.task = task
        self.start = self.first = start
        self.thetas = (thetas + thetas[::-1]) / 2 if task.symmetric else thetas
        self.lengths = lengths
        self.reduce = _reduction(len(thetas), task.symmetric, len(self._freedoms()))
        self._look()

    def _freedoms(self) -> NDArray:
        """Twists (m, 4, 4) by which the first block may move."""
        task, frame = self.task, self.first
        leg, midpoint = frame[:3, 2], frame[:3, 3]
        found = [] if task.square[0] and not task.closed else [chain.turn(leg, midpoint)]
        if task.closed:
            ahead, left = task.path.at(np.zeros(1))[1][0], None
            if task.legs.central:
                found.append(chain.turn(ahead, task.legs.vector))
            else:
                left = np.cross(leg, ahead)
                found.append(chain.shift(left / np.linalg.norm(left)))
        return np.array(found).reshape(-1, 4, 4)

    def _look(self) -> None:
        """Residuals here."""
        task = self.task
        self.chain = chain.Chain(self.start, self.thetas, task.given)
        points = self.chain.midpoints
        self.lengths = task.path.nearest(points, self.lengths)
        feet, tangents = task.path.at(self.lengths)
        legs = task.legs.at(points)
        left = np.cross(legs, tangents)
        self.left = left / np.linalg.norm(left, axis=1, keepdims=True)
        self.off = ((points - feet) * self.left).sum(1) / task.edge_length
        beyond = np.maximum(np.abs(self.off) - self._limit, 0)
        outside = self.thetas - np.clip(self.thetas, *task.band)
        self.uneven = self._uneven(self.thetas)
        self.unlike = self._paired(self.thetas) - task.goal
        residual = np.concatenate([
            _AWAY * self.off, _WALL * beyond, _EVEN * self.uneven, _BAND * outside,
            _GOAL * self.unlike,
        ])  # fmt: skip
        self.missed, self.rows = self._conditions()
        self.merit = residual @ residual + _STIFF * np.abs(self.missed).sum()

    def _paired(self, values: NDArray) -> NDArray:
        """Means of two units, one to each side: a bend makes one wider and the other narrower."""
        if len(values) < 2:
            return values
        if self.task.closed:
            return (np.roll(values, -1, axis=0) + values) / 2
        return (values[1:] + values[:-1]) / 2

    @property
    def within_band(self) -> bool:
        """Whether all thetas are in the band, but for a degree."""
        low, high = self.task.band
        return bool((self.thetas > low - 0.02).all() and (self.thetas < high + 0.02).all())

    def _uneven(self, values: NDArray) -> NDArray:
        if self.task.closed:
            return np.roll(values, -2, axis=0) - values
        return values[2:] - values[:-2]

    def _conditions(self) -> tuple[NDArray, NDArray]:
        """What must vanish, and its derivative by thetas and freedoms."""
        task, frames = self.task, self.chain.frames
        twists = np.concatenate([self.chain.twists, self._freedoms()])
        last = frames[-1]
        move = np.einsum("jab,b->ja", twists[:, :3], last[:, 3])
        if task.closed:
            goal = frames[0]
            own = np.concatenate([np.zeros_like(self.chain.twists), self._freedoms()])
            move = move - np.einsum("jab,b->ja", own[:, :3], goal[:, 3])
            x, y = goal[:3, 0], goal[:3, 1]
            facing = twists[:, :3, :3] @ last[:3, 0] - own[:, :3, :3] @ last[:3, 0]
        else:
            end, ahead = task.path.at(np.array([task.path.length]))
            goal = np.column_stack([np.eye(3), end[0]])
            x = ahead[0]
            y = np.cross(task.legs.at(end[0]), x)
            y = y / np.linalg.norm(y)
            facing = twists[:, :3, :3] @ last[:3, 0]
        gap = last[:3, 3] - goal[:3, 3]
        values = [gap @ x / task.edge_length, gap @ y / task.edge_length]
        rows = [move @ x / task.edge_length, move @ y / task.edge_length]
        if task.closed or task.square[1]:
            values.append(last[:3, 0] @ y)
            rows.append(facing @ y)
        return np.array(values), np.array(rows)

    def _step(self, damping: float) -> NDArray:
        """The step of all unknowns that is best for the problem made linear here.

        Walls are hinges: which of them are touched is asked again where the step leads.
        """
        n, twists = len(self.thetas), self._freedoms()
        across = np.einsum("kaj,ka->kj", self.chain.moves(twists), self.left) @ self.reduce
        across /= self.task.edge_length
        own = self.reduce[:n]
        smooth = np.concatenate(
            [_AWAY * across, _EVEN * self._uneven(own), _GOAL * self._paired(own)]
        )
        value = np.concatenate([_AWAY * self.off, _EVEN * self.uneven, _GOAL * self.unlike])
        square = smooth.T @ smooth + damping * np.eye(smooth.shape[1])
        gradient, rows = smooth.T @ value, self.rows @ self.reduce
        limit, (low, high) = self._limit, self.task.band
        step, touched = np.zeros(len(gradient)), None
        for _ in range(_ROUNDS):
            off, thetas = self.off + across @ step, self.thetas + own @ step
            beyond, outside = np.abs(off) > limit, (thetas < low) | (thetas > high)
            now = np.concatenate([beyond, outside])
            if touched is not None and (now == touched).all():
                break
            touched = now
            wall, band = _WALL * across[beyond], _BAND * own[outside]
            to_wall = _WALL * (self.off - np.sign(off) * limit)[beyond]
            to_band = _BAND * (self.thetas - np.clip(thetas, low, high))[outside]
            step = _constrained(
                square + wall.T @ wall + band.T @ band,
                gradient + wall.T @ to_wall + band.T @ to_band,
                rows,
                self.missed,
            )
        return self.reduce @ step

    @property
    def _limit(self) -> float:
        return _INSIDE * self.task.tolerance / self.task.edge_length

    def onto_ends(self) -> "Steering":
        """Moved by the least that meets what has to hold exactly."""
        rows = self.rows @ self.reduce
        return self._shifted(self.reduce @ -np.linalg.pinv(rows) @ self.missed)

    def _shifted(self, step: NDArray) -> "Steering":
        n = len(self.thetas)
        start = self.start
        if len(step) > n:
            start = chain.moved(self._freedoms(), step[n:]) @ start
        return Steering._from(self, start, self.thetas + step[:n])

    @classmethod
    def _from(cls, other: "Steering", start: NDArray, thetas: NDArray) -> "Steering":
        new = cls.__new__(cls)
        new.task, new.first, new.reduce = other.task, other.first, other.reduce
        new.start, new.thetas, new.lengths = start, thetas, other.lengths
        new._look()
        return new

    def solved(self, steps: int = _STEPS) -> "Steering":
        """The least squares from here; see `steered`."""
        state, damping = self, 1e-4
        for _ in range(steps):
            better = None
            for _ in range(_TRIES):
                step = state._step(damping)
                if np.abs(step).max() < _LONGEST:
                    new = state._shifted(step).onto_ends()
                    if new.merit < state.merit:
                        better = new
                        break
                damping *= 8
            if better is None:
                break
            gained, state = state.merit - better.merit, better
            damping = max(damping / 8, 1e-8)
            if gained < _SETTLED * state.merit and np.abs(state.missed).max() < _MET:
                break
        return state._polished()

    def _polished(self) -> "Steering":
        """The ends met to rounding."""
        state = self
        for _ in range(_POLISH):
            if np.abs(state.missed).max() < _MET / 1000:
                break
            new = state.onto_ends()
            if np.abs(new.missed).max() >= np.abs(state.missed).max():
                break
            state = new
        return state


def _constrained(square: NDArray, gradient: NDArray, rows: NDArray, missed: NDArray) -> NDArray:
    """The step x of least x·square·x / 2 + gradient·x with rows · x = −missed."""
    n, m = len(square), len(rows)
    system = np.zeros((n + m, n + m))
    system[:n, :n] = square
    system[:n, n:], system[n:, :n] = rows.T, rows
    return np.linalg.solve(system, -np.concatenate([gradient, missed]))[:n]


def _reduction(n: int, symmetric: bool, freedoms: int) -> NDArray:
    """Unknowns (n + freedoms) from free ones: thetas the same from both ends where symmetric."""
    if not symmetric:
        return np.eye(n + freedoms)
    half = (n + 1) // 2
    found = np.zeros((n + freedoms, half + freedoms))
    k = np.arange(n)
    found[k, np.minimum(k, n - 1 - k)] = 1
    found[n + np.arange(freedoms), half + np.arange(freedoms)] = 1
    return found
