# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ratios for what a hand feels or the tube carries: each unit's margin, found by its forces.

A snap margin is cheap to look up, a torque is not: it takes a study of the elastic unit
(docs/theory/hinges.md 4). So the margins that lead to wanted torques are searched, all units at
once, each between one that is too little and one that is enough: up to five rounds of about a
second a unit.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..design import TubeDesign
from ..errors import Choice, Phrase, Refusal, phrase
from ..hinges.parameters import HingeParameters
from ..progress import NOBODY, Progress
from ..snap.forces import SnapForces, snap_forces
from ..snap.load import carried
from ..snap.study import Conditions, layouts_of
from ..snap.targets import FIRM, TargetMargin, named
from ..units.ratios import RatioRule

LEAST = 1.5  # margin that every unit keeps, however little is asked of it
_MOST = 8.0
_ROUNDS = 5
_TOO_MUCH = 1.5  # of what is wanted: units are not made so hard for nothing
_POWER = 4.0  # of the margin by which torques grow, at first
_STEP = 0.7, 1.4  # of a margin in one round


@dataclass(frozen=True)
class Aim:
    """``carry``: factor by which every unit carries what hangs on it, or ``force``: N of a hand.

    Carried is the tube's own weight in whatever direction it is turned, its first block held; hands
    pull at the A ends of the contact panels, ‖AB‖ from the leg at B, and open a unit.
    """

    carry: float = 0.0
    force: float = 0.0

    def check(self) -> None:
        """`Refusal` unless one of both is asked for."""
        asked = [x for x in (self.carry, self.force) if x]
        if len(asked) != 1 or not (np.isfinite(asked[0]) and asked[0] > 0):
            raise Refusal(
                "Aim: nothing that can be aimed at",
                cure="give a factor above 0 that units carry with, 1.5 for example, or a force "
                "above 0 of a hand in N, not both",
            )


@dataclass(frozen=True)
class Aimed:
    """``margins``: what each unit is to aim at; ``reached`` (n,): got of what was wanted.

    ``warnings``: `Phrase` list, on what would break.
    """

    margins: tuple[float, ...]
    reached: NDArray
    warnings: list[Phrase]


def aimed(design: TubeDesign, hinges: HingeParameters, conditions: Conditions, aim: Aim,
          progress: Progress = NOBODY) -> Aimed:  # fmt: skip
    """Margins with which the units of a thick ``design`` come to what is aimed at.

    `Refusal` names the units that cannot, and what would help.
    """
    aim.check()
    search = _Search(design, hinges, conditions, aim)
    for done in range(_ROUNDS):
        part = progress.part(done / _ROUNDS, (done + 1) / _ROUNDS)
        if search.look(part):
            break
    return search.result()


class _Search:
    def __init__(
        self, design: TubeDesign, hinges: HingeParameters, conditions: Conditions, aim: Aim
    ) -> None:
        self.design, self.hinges, self.conditions, self.aim = design, hinges, conditions, aim
        target = design.rule.target
        known = isinstance(target, TargetMargin)
        self.target = target if known else TargetMargin(
            design.edge_length, design.pitch, FIRM, hinges.play
        )  # fmt: skip
        count = len(design.tube())
        self.margins = np.maximum(np.resize(self.target.margin, count).astype(float), LEAST)
        self.tried: list[tuple[NDArray, NDArray]] = []  # margins, and got of what is wanted
        self.share, self.stuck = np.zeros(count), np.zeros(count, bool)
        self.units: list[SnapForces] = []

    def look(self, progress: Progress) -> bool:
        """Study the tube with these margins; True if it is as wanted, else the next are set."""
        target = replace(self.target, margin=tuple(self.margins.tolist()))
        rule = RatioRule("TargetSnap", target=target)
        thick = replace(self.design, rule=rule).thick()
        layouts = layouts_of(thick, self.hinges)
        self.units = snap_forces(thick.thick, layouts, self.hinges, self.conditions.material,
                                 self.conditions.orientation, progress)  # fmt: skip
        self.stuck = ~target.choose(thick.tube.unit.theta, thick.tube.leaning).reached
        if self.aim.force:
            got = np.array([u.torque for u in self.units]) / thick.thick.scale
            self.share = np.maximum(got / self.aim.force, 1e-6)
        else:
            load = carried(thick.thick, layouts, self.hinges, self.conditions.material.density,
                           self.units, incoming_left=thick.tube.incoming_left)  # fmt: skip
            self.share = np.maximum(load.turned / self.aim.carry, 1e-6)
        self.tried.append((self.margins, self.share))
        low = (self.share < 1) & ~self.stuck
        high = (self.share > _TOO_MUCH) & (self.margins > LEAST + 1e-9)
        settled = not (low | high).any()
        if not settled:
            self._step(low | high)
        return settled

    def _bounds(self) -> tuple[NDArray, NDArray]:
        """Of every unit the largest margin that was too little, the smallest that was enough."""
        margins, shares = (np.array(each) for each in zip(*self.tried, strict=True))
        enough = np.where(shares >= 1, margins, np.inf).min(0)
        too_little = np.where((shares < 1) & (margins < enough), margins, 0.0).max(0)
        return too_little, enough

    def _step(self, moving: NDArray) -> None:
        too_little, enough = self._bounds()
        between = (too_little > 0) & np.isfinite(enough)
        wanted = (1 + _TOO_MUCH) / 2
        step = self.margins * ((wanted / self.share) ** (1 / _POWER)).clip(*_STEP)
        middle = np.sqrt(np.where(between, too_little * enough, 1.0))
        here = np.where(between, middle, step).clip(LEAST, _MOST)
        self.margins = np.where(moving, here, self.margins)

    def _choose(self) -> None:
        """Of every unit the smallest margin that was enough, or the one that led furthest."""
        margins, shares = (np.array(each) for each in zip(*self.tried, strict=True))
        each = np.arange(margins.shape[1])
        best = np.where(shares >= 1, -margins, shares - 1e6).argmax(0)
        self.margins, self.share = margins[best, each], shares[best, each]

    def result(self) -> Aimed:
        """What was found; `Refusal` where it is not enough."""
        self._choose()
        short = self.share < 1
        if short.any():
            worst = int(np.argmin(self.share))
            raise Refusal(
                "{units} cannot reach what is aimed at: unit {worst} gets {share:.0%} of it{stuck}",
                cure="make {EdgeLength} or {Gamma} larger, the curve shorter, or ask for less",
                parameter="EdgeLength",
                units=named(short),
                worst=worst + 1,
                share=float(self.share[worst]),
                stuck=phrase(", its ratio as near to sin(theta/2) as can be made")
                if self.stuck[worst]
                else "",
            )
        said = [
            phrase(
                "Unit {unit} would break where it snaps: its hardest worked knuckle bears "
                "{share:.0%} of what {material} bears. Make {EdgeLength} longer or {FaceThickness} "
                "larger, or choose a tougher {Material}.",
                unit=k + 1,
                share=unit.weakest.share,
                material=Choice(self.conditions.material.name),
            )
            for k, unit in enumerate(self.units)
            if unit.weakest.share > 1
        ]
        return Aimed(tuple(round(m, 3) for m in self.margins.tolist()), self.share, said)
