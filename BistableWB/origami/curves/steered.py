# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rule Steered, and closed curves: which counts and starts are tried, and the best of them."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from .marching import Blocks
from .quick import QuickMarch
from .steering import Steering, Task

if TYPE_CHECKING:
    from .crossing import CurveTable
    from .legs import Legs
    from .rules import PlacementRule

_COUNTS = (0, 1, -1, 2, -2)
_MANY = 300  # units of which the first that can be steered are taken
_WIDTHS = (1, 8)  # tolerances, narrowed by halves: wide ones first smooth the zigzag
_NARROWER = 2.0
_MARCHES = 4
_STEPS = (25, 8)
_NEAR_END = 0.05  # of ‖AB‖: how near a march from which steering starts comes to the end
_EVEN_ENOUGH = np.radians(4.0)  # thetas two units apart: nothing better is sought
_SLACK = 1.02  # of the tolerance, for what a wall lets through
_CLOSING = 0.05  # of ‖AB‖
_ALIKE = 1e-3  # of the chord: a curve that is symmetric
_ROUND = 1e-6  # of the distance from V by which a curve may leave its sphere


class Steered:
    """A zigzag steered along a tabulated curve; arguments as of `placement.place`."""

    def __init__(
        self,
        table: "CurveTable",
        legs: "Legs",
        edge_length: float,
        gamma: float,
        pitch: float,
        flip: bool,
        extra: Sequence[Any],
        rule: "PlacementRule",
        closed: bool,
    ) -> None:
        self.table, self.legs, self.edge_length = table, legs, edge_length
        self.gamma, self.rule, self.closed = gamma, rule, closed
        self.tolerance = rule.within(edge_length)
        # Nobody asked for a tolerance: what closes the tube is good enough, and is reported.
        free = closed and rule.tolerance is None
        self.limit = _CLOSING * edge_length if free else _SLACK * self.tolerance
        self.pitch, self.extra = pitch, np.asarray(extra if len(extra) else (0.0,), float)
        self.distance = self._distance()
        self.quick = QuickMarch(table, legs, edge_length, pitch, flip, extra, closed)
        self.length = self.quick.path.length
        self.unlike = 0.0  # mm by which a curve that was to be symmetric is not
        if rule.symmetric and not closed:
            self._take_as_it_is()

    def _distance(self) -> Any:
        """Distance of the curve from V of concurrent legs, None for parallel ones."""
        if not self.legs.central:
            return None
        reach = np.linalg.norm(self.table.points - self.legs.vector, axis=1)
        if np.ptp(reach) > _ROUND * reach[0]:
            raise Refusal(
                "{Ruling}: along legs through a viewpoint a tube is steered, or closed, only on a "
                "sphere about it, and this curve is {low:.4g} to {high:.4g} mm away from it",
                cure="give {Ruling} a direction, or choose EndFit as {PlacementRule}",
                parameter="Ruling",
                low=float(reach.min()),
                high=float(reach.max()),
            )
        return float(reach.mean())

    def solved(self) -> tuple:
        """`marching.Blocks`, gamma of the first block, and distances (n + 1,) from the curve.

        `Refusal` where no count of units is steered within the tolerance.
        """
        best = self._steered(len(self.rule.near), 1) if self.rule.near is not None else None
        for count, width in product(self._counts(), _WIDTHS):
            if best is not None and (self.rule.near is not None or len(best.thetas) > _MANY):
                break
            state = self._steered(count, width)
            if state is not None and (best is None or self._rank(state) < self._rank(best)):
                best = state
            if best is not None and self._good(best):
                break
        if best is None:
            raise Refusal(
                "{EdgeLength}: {value:.4g} mm is too long to steer units along this curve of "
                "{length:.4g} mm",
                cure="make {EdgeLength} shorter or the curve longer",
                parameter="EdgeLength",
                value=float(self.edge_length),
                length=self.length,
            )
        self._check(best)
        return self._blocks(best), self._gamma(best), np.abs(best.off) * self.edge_length

    def _counts(self) -> list[int]:
        n = max(round(self.length / self._advance()), 1)
        if self.closed:
            n = max(2 * round(n / 2), 4)
            counts = [n, n + 2, n - 2, n + 4, n - 4]
        elif self.rule.symmetric:
            n = n if n % 2 == self._parity() else n + 1
            counts = [n, n - 2, n + 2]
        else:
            counts = [n + more for more in _COUNTS]
        return [count for count in counts if count >= (4 if self.closed else 1)]

    def _advance(self) -> float:
        """How far a unit of the wanted theta, 2 gamma, leads along a straight curve."""
        extra = float(self.extra.mean())
        return (
            self.edge_length * np.sin(self.gamma)
            + 2 * (self.pitch + extra)
            + 2 * self.pitch * np.cos(self.gamma)
        )

    def _take_as_it_is(self) -> None:
        """Give up symmetry where the curve has none: `unlike` then says by how much."""
        off = self._unlike()
        if min(off) > _ALIKE * np.linalg.norm(np.ptp(self.quick.path.points, axis=0)):
            self.unlike = float(min(off))
            self.rule = replace(self.rule, symmetric=False)

    def _parity(self) -> int:
        """Units of a symmetric tube: odd along a curve that is its own mirror image, else even."""
        mirrored, turned = self._unlike()
        return 1 if mirrored <= turned else 0

    def _unlike(self) -> list[float]:
        """How far (mm) the curve is off its mirror image, and off itself turned half round."""
        points = self.quick.path.points
        middle, chord = (points[0] + points[-1]) / 2, points[-1] - points[0]
        offset = points - middle
        along = (offset @ chord) / (chord @ chord)
        mirrored = offset - 2 * along[:, None] * chord
        leg = self.legs.at(middle)
        turned = 2 * (offset @ leg)[:, None] * leg - offset
        return [float(np.abs(image - offset[::-1]).max()) for image in (mirrored, turned)]

    def _steered(self, count: int, width: float) -> Steering | None:
        """A `Steering` of so many units, None where it cannot be started.

        ``width``: the tolerance to begin with, in tolerances; where the start is further off
        than that, it is what it takes.
        """
        march = self._start(count) if self.rule.near is None else self._as_before()
        if march is None:
            return None
        thetas, lengths, frame, side = march
        sides = side * (-1.0) ** np.arange(count)
        extra = self.extra[np.minimum(np.arange(count), len(self.extra) - 1)]
        given = sides, self.edge_length / 2, (self.pitch, self.pitch + extra), self.distance
        square = self.rule.start == "Square", self.rule.end == "Square"
        task = Task(
            self.quick.path, self.legs, given, self.tolerance, 2 * self.gamma, self.rule.band,
            square, self.rule.symmetric, self.closed,
        )  # fmt: skip
        if square[0] and not self.closed:
            frame, thetas = self._square(frame, thetas, side)
        with np.errstate(all="ignore"):
            try:
                state = Steering(replace(task, symmetric=False), frame, thetas, lengths)
                return self._narrowed(state, task, width)
            except np.linalg.LinAlgError:
                return None

    def _narrowed(self, state: Steering, task: Task, width: float) -> Steering | None:
        """Solved with ever narrower tolerances; first as the curve is, then symmetric if asked."""
        if task.symmetric:
            state = state.solved(_STEPS[1])
        state = state.onto_ends()
        if width > 1:
            width = max(width, np.abs(state.off).max() * self.edge_length / self.tolerance)
        while np.isfinite(state.merit):
            near = replace(task, tolerance=width * self.tolerance)
            state = Steering(near, state.start, state.thetas, state.lengths)
            state = state.solved(_STEPS[int(width > 1)])
            if width <= 1:
                return state
            width = max(width / _NARROWER, 1.0)
        return None

    def _start(self, count: int) -> tuple[NDArray, NDArray, NDArray, int] | None:
        """Thetas, lengths, frame and side of a march with so many units on the curve, about."""
        gamma = self.gamma
        for _ in range(_MARCHES):
            march = self.quick.march(gamma, count)
            if not len(march.thetas):
                return None
            gone = march.lengths[-1] * count / len(march.thetas)
            if (
                len(march.thetas) == count
                and abs(gone - self.length) < _NEAR_END * self.edge_length
            ):
                break
            gamma = float(np.arcsin(min(np.sin(gamma) * self.length / gone, 0.95)))
        thetas, missing = march.thetas, count - len(march.thetas)
        if missing > count / 2:
            return None
        while len(thetas) < count:
            thetas = np.append(thetas, thetas[-2:][0])
        thetas = np.clip(thetas, 0.05, 2.6)
        return thetas, np.linspace(0, self.length, count + 1), march.frame, march.side

    def _as_before(self) -> Any:
        """The start of a placement that is to change little."""
        near = self.rule.near
        leg = self.legs.at(near.midpoints[0])
        along = near.reaches[0] - (near.reaches[0] @ leg) * leg
        along = along / np.linalg.norm(along)
        side = int(near.sides[0])
        frame = np.eye(4)
        frame[:3, 1], frame[:3, 2] = side * along, leg
        frame[:3, 0] = np.cross(side * along, leg)
        frame[:3, 3] = near.midpoints[0]
        return near.thetas, near.lengths * self.length / near.length, frame, side

    def _square(self, frame: NDArray, thetas: NDArray, side: float) -> tuple[NDArray, NDArray]:
        """The first block turned square with the curve."""
        turned = frame.copy()
        turned[:3, 0] = self.quick.start.ahead
        turned[:3, 1] = np.cross(frame[:3, 2], turned[:3, 0])
        return turned, thetas

    def _over(self, state: Steering) -> float:
        """How far beyond the tolerance, at least 1."""
        return max(np.abs(state.off).max() * self.edge_length / self.limit, 1.0)

    def _met(self, state: Steering) -> bool:
        return np.abs(state.missed).max() < 1e-7

    def _rank(self, state: Steering) -> tuple[bool, float, float]:
        return (not self._met(state), self._over(state), state.merit)

    def _good(self, state: Steering) -> bool:
        return (
            self._met(state)
            and self._over(state) <= 1
            and np.abs(state.uneven).max(initial=0) < _EVEN_ENOUGH
            and state.within_band
        )

    def _check(self, state: Steering) -> None:
        if self._met(state) and self._over(state) <= 1:
            return
        off = np.abs(state.off)
        k = int(off.argmax())
        raise Refusal(
            "{Tolerance}: with {value:.3g} mm the tube cannot be steered along the curve near "
            "({at}) mm, {need:.3g} mm would do",
            cure="raise {Tolerance}, make {EdgeLength} shorter or the bend wider",
            parameter="Tolerance",
            value=self.tolerance,
            need=float(1.05 * off[k] * self.edge_length) if self._met(state) else
            0.1 * self.edge_length,
            at=", ".join(f"{x:.4g}" for x in state.chain.midpoints[k]),
        )  # fmt: skip

    def _gamma(self, state: Steering) -> float:
        """Angle of the first block against the curve's normal."""
        return float(np.arccos(np.clip(state.start[:3, 0] @ self.quick.start.ahead, -1, 1)))

    def _blocks(self, state: Steering) -> Blocks:
        frames = state.chain.frames
        sides = np.append(state.task.given[0], -state.task.given[0][-1])
        reaches = self.edge_length / 2 * sides[:, None] * frames[:, :3, 1]
        lengths = np.clip(state.lengths - state.lengths[0] * self.closed, 0, self.length)
        parameters = self.quick.path.parameters_at(lengths)
        parameters[0], parameters[-1] = 0.0, 1.0
        if self.closed:
            parameters[-1] = 1.0
        return Blocks(
            parameters.tolist(),
            list(frames[:, :3, 3]),
            list(reaches),
            np.sin(state.thetas / 2).tolist(),
        )
