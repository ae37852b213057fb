# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each unit's ratio for a wanted snap: a snap margin within a strain limit, or an energy barrier.

``hinges.md`` 4, *target snap*. On a plane the ratio c of a unit is free between sin(θ/2) and 1; the
margin and the peak strain both fall as its share (c − sin(θ/2)) / (1 − sin(θ/2)) grows. So a wanted
margin has one share, and a strain limit a smallest one; the larger of the two is chosen.
"""

from dataclasses import dataclass, field

import numpy as np

from .angles import angles_for, half_opening
from .snap import PLA_STRAIN, barrier
from .snap_table import GRID, PITCH_RATIOS, SHARES, first_below, profile, read

SMALLEST_SHARE, LARGEST_SHARE = SHARES[0], SHARES[-1]
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
    """A wanted snap margin: needed play / play of a hinge.

    ``edge_length`` ‖AB‖, ``pitch`` (face thickness + gap between planes) and ``play`` in mm;
    ``strain_limit``: peak strain that the material bears. Margins hold for compensated units and
    are within 5 % of `snap.assess`; between leaning contacts (curves of kind General) within 15 %,
    where they lean by more than 40° within 25 %.
    """

    edge_length: float
    pitch: float
    margin: float = 1.5
    play: float = 0.28
    strain_limit: float = PLA_STRAIN

    def ratios(self, theta, leaning=None):
        """Ratios for θ (radians, scalar or (n,)); arguments as for `choose`."""
        return self.choose(theta, leaning).ratio.reshape(np.shape(theta))[()]

    def choose(self, theta, leaning=None):
        """The `Choice` for θ (radians, scalar or (n,)) and the units' `leaning.Leaning`.

        ValueError for bad numbers.
        """
        self._check()
        theta = np.atleast_1d(np.asarray(theta, float))
        low = half_opening(theta) if leaning is None else leaning.least.max(1)
        needed, limit = self.margin * self.play / self.edge_length, _RESERVE * self.strain_limit
        shares, plays, strains, lowest = self._profile(theta, leaning)
        self._check_made(theta, lowest)
        soft = first_below(np.log(plays), np.log(needed))
        strained = first_below(np.log(strains), np.log(limit))
        place = np.maximum(soft, strained)
        place = np.maximum(place, np.interp(np.log(lowest), GRID, np.arange(len(GRID))))
        share, play, strain = (read(rows, place) for rows in (shares[None], plays, strains))
        margin = play * self.edge_length / self.play
        reached = margin >= _SHORT * self.margin
        by_strain = ~reached & (strained >= place - 1e-9) & (strained > 0)
        found = Choice(share, low + share * (1 - low), margin, strain, reached)
        found.warnings.extend(self._warnings(found, by_strain))
        return found

    def expected(self, theta, ratio, leaning=None):
        """Snap margins (n,) to expect of units of given ratios; other arguments as for `choose`."""
        theta, ratio = np.broadcast_arrays(np.atleast_1d(theta), np.asarray(ratio, float))
        low = half_opening(theta) if leaning is None else leaning.least.max(1)
        share = np.maximum((ratio - low) / (1 - low), SMALLEST_SHARE)
        plays = self._profile(theta, leaning)[1]
        place = np.interp(np.log(share), GRID, np.arange(len(GRID)))
        # Beyond the table the needed play falls with the inverse of the share.
        beyond = np.minimum(LARGEST_SHARE / share, 1)
        return read(plays, place) * beyond * self.edge_length / self.play

    def floppy(self, theta, ratio, leaning=None, free=True):
        """Sentences (at most one) that name the units which are expected to be floppy.

        ``free``: their ratio can be chosen. Other arguments as for `expected`.
        """
        margin = self.expected(theta, ratio, leaning)
        units = margin < 1
        if not units.any():
            return []
        verb = "are" if units.sum() > 1 else "is"
        ratios = "choose RatioRule TargetSnap or a smaller ratio, or " if free else ""
        return [
            f"{named(units)} {verb} floppy: hinges with a play of {self.play:.2g} mm swallow the "
            f"snap (snap margin about {margin[units].min():.2g}, below 1); {ratios}make EdgeLength "
            "or Gamma larger."
        ]

    def _profile(self, theta, leaning):
        """`snap_table.profile`; of leaning units the mean of both sub-units at their own shares."""
        shares, plays, strains, lowest = profile(theta, self.pitch / self.edge_length)
        if leaning is None:
            return shares, plays, strains, lowest
        least, most = leaning.least.min(1)[:, None], leaning.least.max(1)[:, None]
        own = np.log((most + shares * (1 - most) - least) / (1 - least))
        plays, strains = (
            np.sqrt(rows * [np.interp(x, GRID, row) for row, x in zip(rows, own, strict=True)])
            for rows in (plays, strains)
        )
        return shares, plays * leaning.size[:, None], strains, lowest

    def _check(self):
        for name, value, cure in (
            ("EdgeLength", self.edge_length, "set it to a length above 0"),
            ("Thickness", self.pitch, "without thickness there is no snap margin: set it to face "
             "thickness + gap between planes, 1.8 mm for example, or aim for a TargetBarrier"),
            ("TargetMargin", self.margin, "set it above 0; 1.5 is firm, below 1 is floppy"),
            ("HingePlay", self.play, "set it to what one hinge's clearance allows, 0.28 mm by "
             "default; hinges without play never turn floppy and need no target"),
            ("StrainLimit", self.strain_limit, "set it to what the material bears, 0.02 for PLA"),
        ):  # fmt: skip
            if not (np.isfinite(value) and value > 0):
                raise ValueError(f"{name} is {value:.6g}: {cure}.")

    def _check_made(self, theta, lowest):
        bad = np.flatnonzero(np.isnan(lowest) | (self.pitch > PITCH_RATIOS[-1] * self.edge_length))
        if len(bad):
            raise ValueError(
                f"Thickness: panels of pitch {self.pitch:.4g} mm are too thick for the unit of "
                f"theta {np.degrees(theta[bad[0]]):.1f}° and EdgeLength {self.edge_length:.4g} mm; "
                "make Thickness smaller, EdgeLength longer or Gamma larger."
            )

    def _warnings(self, found, by_strain):
        wanted = f"instead of {self.margin:.2f}"
        for units, why in (
            (by_strain, f"more would strain the panels beyond {self.strain_limit:.1%}"),
            (~found.reached & ~by_strain, f"their ratio is as near to sin(theta/2) as can be made "
             f"(share {found.share.min():.2g})"),
        ):  # fmt: skip
            if units.any():
                worst = found.achieved[units].min()
                floppy = " and are floppy" if worst < 1 else ""
                longer = self.edge_length * self.margin / worst
                less = self.play * worst / self.margin
                yield (
                    f"{named(units)} cannot reach the snap margin: {worst:.2f} {wanted}{floppy}; "
                    f"{why}. Make EdgeLength about {longer:.3g} mm, Gamma larger (wider units snap "
                    f"harder), or the play of the hinges {less:.2g} mm (steeper cones, smaller "
                    "GapLength)."
                )


@dataclass(frozen=True)
class TargetBarrier:
    """A wanted energy barrier of the zero-thickness unit, in EA·‖AB‖."""

    barrier: float

    def ratios(self, theta, leaning=None):
        """Ratios for θ (radians, scalar or (n,)); arguments as for `choose`."""
        return self.choose(theta, leaning).ratio.reshape(np.shape(theta))[()]

    def choose(self, theta, leaning=None):
        """The `Choice` for θ (radians, scalar or (n,)) and the units' `leaning.Leaning`.

        ValueError for a bad number.
        """
        if not (np.isfinite(self.barrier) and self.barrier > 0):
            raise ValueError(
                f"TargetBarrier is {self.barrier:.6g}: set it above 0, in EA·‖AB‖; 1e-6 is weak, "
                "1e-4 strong."
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
                f"{named(~reached)} cannot reach the energy barrier: "
                f"{achieved[~reached].min():.2g} instead of {self.barrier:.2g} EA·‖AB‖; make Gamma "
                "larger: wider units snap harder."
            )
        return found

    def _shares(self, theta):
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


def _barriers(theta, share):
    """Ratio, barrier (EA·‖AB‖) and the edges' largest strain."""
    low = np.sin(theta / 2)
    ratio = low + share * (1 - low)
    alpha, beta, _ = angles_for(np.broadcast_to(theta, ratio.shape), ratio)
    peak, _, strain = barrier(alpha, beta, _BARRIER_STEPS)
    return ratio, peak, strain


def _log_barriers(theta, log_share):
    return np.log(_barriers(theta, np.exp(log_share))[1])


def named(units):
    """The units of a mask (n,) bool, counted from 1, as the subject of a sentence."""
    numbers = (np.flatnonzero(units) + 1).tolist()
    if len(units) == 1:
        return "The unit"
    shown = ", ".join(map(str, numbers[:_NAMED]))
    more = f" and {len(numbers) - _NAMED} more" if len(numbers) > _NAMED else ""
    return f"Unit{'s'[: len(numbers) > 1]} {shown}{more}"
