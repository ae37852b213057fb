# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each unit's ratio for a wanted snap: a snap margin within a strain limit, or an energy barrier.

hinges.md 4, *target snap*. On a plane the ratio c of a unit is free between sin(θ/2) and 1; the
margin and the peak strain both fall as its share (c − sin(θ/2)) / (1 − sin(θ/2)) grows. So a wanted
margin has one share, and a strain limit a smallest one; the larger of the two is chosen.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal, name_of, phrase
from ..units.angles import angles_for, half_opening
from .margin import barrier
from .table import CONTACT, GRID, PITCH_RATIOS, SHARES, first_below, profile, read

if TYPE_CHECKING:
    from ..errors import Phrase
    from ..units.oblique import Leaning

SMALLEST_SHARE, LARGEST_SHARE = SHARES[0], SHARES[-1]
FIRM = 1.8  # margin with which preloaded units also carry the tube (docs/strength.md)
_RESERVE = 0.98  # of the strain limit, for what interpolation leaves
_SHORT = 0.97  # of the target: less is not reached
_BARRIER_SHARES = np.geomspace(1e-3, 0.9, 13)
_BARRIER_STEPS = 25
_NAMED = 12  # units that one sentence names


@dataclass(frozen=True)
class Choice:
    """What a target chose for n units.

    ``share`` and ``ratio`` (n,); ``reached`` (n,) bool; ``achieved`` (n,): snap margin, or barrier
    in EA·‖AB‖; ``strain`` (n,): peak strain of the thick unit, for a barrier of its edges;
    ``warnings``: one sentence for each reason why some units cannot reach the target.
    """

    share: np.ndarray
    ratio: np.ndarray
    achieved: np.ndarray
    strain: np.ndarray
    reached: np.ndarray
    warnings: list = field(default_factory=list)


@dataclass(frozen=True)
class TargetMargin:
    """A wanted snap margin: play with which a unit would open freely / play of its hinges.

    ``margin``: one for all units, or one each (a tuple); ``edge_length`` ‖AB‖, ``pitch`` (face
    thickness + gap between planes) and ``play`` in mm; ``strain_limit``: peak misfit / ‖AB‖ that
    ratios keep below, 0: none; ``measure``: how play is counted, a key of `table.MEASURES`. Margins
    hold for compensated units with the hinges of new hinge sets, without preload, and are within
    5 % of `margin.assess`; between leaning contacts (curves of kind General) within 20 %, where
    they lean by more than 40° within 25 %. Preload adds to them, up to 40 %.
    """

    edge_length: float
    pitch: float
    margin: float | tuple[float, ...] = 1.5
    play: float = 0.28
    strain_limit: float = 0.0
    measure: str = CONTACT

    def ratios(self, theta: NDArray, leaning: "Leaning | None" = None) -> NDArray:
        """Ratios for θ (radians, scalar or (n,)); arguments as for `choose`."""
        return self.choose(theta, leaning).ratio.reshape(np.shape(theta))[()]

    def choose(self, theta: NDArray, leaning: "Leaning | None" = None) -> Choice:
        """The `Choice` for θ (radians, scalar or (n,)) and the units' `oblique.Leaning`.

        ValueError for bad numbers.
        """
        self._check()
        theta = np.atleast_1d(np.asarray(theta, float))
        low = half_opening(theta) if leaning is None else leaning.least.max(1)
        wanted = self._each(len(theta))
        needed = wanted * self.play / self.edge_length
        limit = _RESERVE * self.strain_limit if self.strain_limit else np.inf
        shares, plays, strains, lowest = self._profile(theta, leaning)
        self._check_made(theta, lowest)
        soft = first_below(np.log(plays), np.log(needed))
        strained = first_below(np.log(strains), np.log(limit))
        place = np.maximum(soft, strained)
        place = np.maximum(place, np.interp(np.log(lowest), GRID, np.arange(len(GRID))))
        share, play, strain = (read(rows, place) for rows in (shares[None], plays, strains))
        margin = play * self.edge_length / self.play
        reached = margin >= _SHORT * wanted
        by_strain = ~reached & (strained >= place - 1e-9) & (strained > 0)
        found = Choice(share, low + share * (1 - low), margin, strain, reached)
        found.warnings.extend(self._warnings(found, by_strain, wanted))
        return found

    def expected(
        self, theta: Any, ratio: NDArray | float, leaning: "Leaning | None" = None
    ) -> NDArray:
        """Snap margins (n,) to expect of units of given ratios; other arguments as for `choose`."""
        theta, ratio = np.broadcast_arrays(np.atleast_1d(theta), np.asarray(ratio, float))
        low = half_opening(theta) if leaning is None else leaning.least.max(1)
        share = np.maximum((ratio - low) / (1 - low), SMALLEST_SHARE)
        plays = self._profile(theta, leaning)[1]
        place = np.interp(np.log(share), GRID, np.arange(len(GRID)))
        # Beyond the table the needed play falls with the inverse of the share.
        beyond = np.minimum(LARGEST_SHARE / share, 1)
        return read(plays, place) * beyond * self.edge_length / self.play

    def floppy(
        self, theta: NDArray, ratio: NDArray, leaning: "Leaning | None" = None, free: bool = True
    ) -> list:
        """Sentences (at most one) that name the units which are expected to be floppy.

        ``free``: their ratio can be chosen. Other arguments as for `expected`.
        """
        margin = self.expected(theta, ratio, leaning)
        units = margin < 1
        if not units.any():
            return []
        ratios = phrase("choose {RatioRule} TargetSnap or a smaller ratio, or ") if free else ""
        return [
            phrase(
                "{units} {are} floppy: hinges with a play of {play:.2g} mm swallow the snap (snap "
                "margin about {margin:.2g}, below 1); {ratios}make {EdgeLength} or {Gamma} larger.",
                units=named(units),
                are=phrase("are" if units.sum() > 1 else "is"),
                play=self.play,
                margin=margin[units].min(),
                ratios=ratios,
            )
        ]

    def _profile(self, theta: NDArray, leaning: "Leaning | None") -> tuple[NDArray, ...]:
        """`table.profile`; of leaning units the mean of both sub-units at their own shares."""
        shares, plays, strains, lowest = profile(theta, self.pitch / self.edge_length, self.measure)
        if leaning is None:
            return shares, plays, strains, lowest
        least, most = leaning.least.min(1)[:, None], leaning.least.max(1)[:, None]
        own = np.log((most + shares * (1 - most) - least) / (1 - least))
        plays, strains = (
            np.sqrt(rows * [np.interp(x, GRID, row) for row, x in zip(rows, own, strict=True)])
            for rows in (plays, strains)
        )
        return shares, plays * leaning.size[:, None], strains, lowest

    def _each(self, count: int) -> NDArray:
        """Wanted margins (count,) of the units."""
        given = np.size(self.margin)
        if given not in (1, count):
            raise Refusal(
                "{UnitMargins} has {given} numbers and there are {count} units",
                cure="empty it, so that {TargetMargin} counts for all, or aim again",
                parameter="UnitMargins",
                given=given,
                count=count,
            )
        return np.broadcast_to(np.ravel(self.margin).astype(float), count)

    def _check(self) -> None:
        for name, value, cure in (
            ("EdgeLength", self.edge_length, phrase("set it to a length above 0")),
            ("Thickness", self.pitch, phrase(
                "without thickness there is no snap margin: set it to face thickness + gap "
                "between planes, 1.8 mm for example, or aim for a {TargetBarrier}")),
            ("TargetMargin", np.min(self.margin), phrase(
                "set it above 0; 1.5 is firm, below 1 is floppy")),
            ("HingePlay", self.play, phrase(
                "set it to what one hinge's clearance allows, 0.28 mm by default; hinges without "
                "play never turn floppy and need no target")),
            ("StrainLimit", self.strain_limit, phrase(
                "set it to 0 for no limit, or to the largest misfit / ‖AB‖ that may be")),
        ):  # fmt: skip
            none = name == "StrainLimit" and value == 0
            if not none and not (np.isfinite(value) and value > 0):
                raise Refusal(
                    "{name} is {value:.6g}: {why}.",
                    parameter=name,
                    name=name_of(name),
                    value=value,
                    why=cure,
                )

    def _check_made(self, theta: NDArray, lowest: NDArray) -> None:
        bad = np.flatnonzero(np.isnan(lowest) | (self.pitch > PITCH_RATIOS[-1] * self.edge_length))
        if len(bad):
            raise Refusal(
                "{Thickness}: panels of pitch {pitch:.4g} mm are too thick for the unit of theta "
                "{theta:.1f}° and {EdgeLength} {edge_length:.4g} mm; make {Thickness} smaller, "
                "{EdgeLength} longer or {Gamma} larger.",
                parameter="Thickness",
                pitch=self.pitch,
                theta=np.degrees(theta[bad[0]]),
                edge_length=self.edge_length,
            )

    def _warnings(self, found: Choice, by_strain: NDArray, goals: NDArray) -> "Iterator[Phrase]":
        for units, why in (
            (by_strain, phrase("more would pass the {StrainLimit} of {limit:.1%}",
             limit=self.strain_limit)),
            (~found.reached & ~by_strain, phrase(
                "their ratio is as near to sin(theta/2) as can be made (share {share:.2g})",
                share=found.share.min())),
        ):  # fmt: skip
            if units.any():
                at = np.flatnonzero(units)[(found.achieved / goals)[units].argmin()]
                worst, wanted = found.achieved[at], goals[at]
                yield phrase(
                    "{units} cannot reach the snap margin: {worst:.2f} instead of {wanted:.2f}"
                    "{floppy}; {why}. Make {EdgeLength} about {longer:.3g} mm, {Gamma} larger "
                    "(wider units snap harder), or the play of the hinges {less:.2g} mm (steeper "
                    "cones, smaller {GapLength}).",
                    units=named(units),
                    worst=worst,
                    wanted=wanted,
                    floppy=phrase(" and are floppy") if worst < 1 else "",
                    why=why,
                    longer=self.edge_length * wanted / worst,
                    less=self.play * worst / wanted,
                )


@dataclass(frozen=True)
class TargetBarrier:
    """A wanted energy barrier of the zero-thickness unit, in EA·‖AB‖."""

    barrier: float

    def ratios(self, theta: NDArray, leaning: "Leaning | None" = None) -> Any:
        """Ratios for θ (radians, scalar or (n,)); arguments as for `choose`."""
        return self.choose(theta, leaning).ratio.reshape(np.shape(theta))[()]

    def choose(self, theta: NDArray, leaning: "Leaning | None" = None) -> Any:
        """The `Choice` for θ (radians, scalar or (n,)) and the units' `oblique.Leaning`.

        ValueError for a bad number.
        """
        if not (np.isfinite(self.barrier) and self.barrier > 0):
            raise Refusal(
                "{TargetBarrier} is {barrier:.6g}: set it above 0, in EA·‖AB‖; 1e-6 is weak, 1e-4 "
                "strong.",
                parameter="TargetBarrier",
                barrier=self.barrier,
            )
        theta = np.atleast_1d(np.asarray(theta, float))
        half_opening(theta)
        share = self._shares(theta)
        if leaning is not None:
            low = np.sin(theta / 2)
            least = leaning.least.max(1)
            least += SMALLEST_SHARE * (1 - least)
            share = np.where(least > low, np.maximum(share, (least - low) / (1 - low)), share)
        ratio, achieved, strain = _barriers(theta, share)
        reached = achieved >= _SHORT * self.barrier
        found = Choice(share, ratio, achieved, strain, reached)
        if not reached.all():
            found.warnings.append(
                phrase(
                    "{units} cannot reach the energy barrier: {worst:.2g} instead of {wanted:.2g} "
                    "EA·‖AB‖; make {Gamma} larger: wider units snap harder.",
                    units=named(~reached),
                    worst=achieved[~reached].min(),
                    wanted=self.barrier,
                )
            )
        return found

    def _shares(self, theta: NDArray) -> Any:
        """Shares (n,) for the barrier: by a table over all θ, then two secant steps in log-log."""
        nodes = np.log(_BARRIER_SHARES)
        rows = _log_barriers(theta[:, None], np.broadcast_to(nodes, (len(theta), len(nodes))))
        goal = np.log(self.barrier)
        before = read(nodes[None], first_below(rows, goal))
        value = _log_barriers(theta, before)
        slope = np.array([np.interp(b, nodes, np.gradient(r, nodes)) for b, r in
                          zip(before, rows, strict=True)])  # fmt: skip
        for _ in range(2):
            after = np.clip(before + (goal - value) / slope, nodes[0], nodes[-1])
            step, newer = after - before, _log_barriers(theta, after)
            moved = np.abs(step) > 1e-9
            slope = np.where(moved, (newer - value) / np.where(moved, step, 1.0), slope)
            before, value = after, newer
        return np.exp(before)


def _barriers(theta: NDArray, share: NDArray) -> Any:
    """Ratio, barrier (EA·‖AB‖) and the edges' largest strain."""
    low = np.sin(theta / 2)
    ratio = low + share * (1 - low)
    alpha, beta, _ = angles_for(np.broadcast_to(theta, ratio.shape), ratio)
    peak, _, strain = barrier(alpha, beta, _BARRIER_STEPS)
    return ratio, peak, strain


def _log_barriers(theta: NDArray, log_share: Any) -> Any:
    return np.log(_barriers(theta, np.exp(log_share))[1])


def named(units: NDArray) -> "Phrase":
    """The units of a mask (n,) bool, counted from 1, as the subject of a sentence."""
    numbers = (np.flatnonzero(units) + 1).tolist()
    if len(units) == 1:
        return phrase("The unit")
    more = phrase(" and {count} more", count=len(numbers) - _NAMED)
    return phrase(
        "Units {numbers}{more}" if len(numbers) > 1 else "Unit {numbers}{more}",
        numbers=", ".join(map(str, numbers[:_NAMED])),
        more=more if len(numbers) > _NAMED else "",
    )
