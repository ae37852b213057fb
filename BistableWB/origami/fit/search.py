# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proposals of EdgeLength, Gamma and ratio rule for a curve, a print bed and a wanted snap.

The search is a small grid, in three steps (`fit_steps`):

1. Eight edge lengths × six angles gamma: place the triangles. What does not follow the curve,
   covers less than 3/4 of it or does not fit the bed is out.
2. Each with six shares and with the rule TargetSnap: the snap of the narrowest and the widest unit,
   from a table. What snaps too weakly or strains too much is out. (On a sphere the ratio is fixed;
   the table of plane units then tells only roughly.)
3. The ten best, by what they use of five allowances (`Candidate.used`), are made and measured.

What is returned is measured, and none of it is beaten in all five allowances by another.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..errors import Refusal, joined, phrase
from ..progress import NOBODY
from .steps import looked_up, measured, placed_trials, undominated
from .terms import Candidate, Course, Refusals, Wanted, rule_of

if TYPE_CHECKING:
    from ..progress import Progress

__all__ = ["Candidate", "Course", "Fit", "Wanted", "auto_fit", "rule_of"]


@dataclass(frozen=True)
class Fit:
    """Result of `auto_fit`: ``candidates``, best first; ``tried`` combinations, the ``wanted``."""

    candidates: list
    tried: int
    wanted: Wanted

    @property
    def recommended(self) -> Candidate:
        """The candidate that uses least of its allowances."""
        return self.candidates[0]


def auto_fit(course: Course, wanted: Wanted | None = None, progress: "Progress" = NOBODY) -> Fit:
    """Search designs of tubes along a `Course` that are as `Wanted`. Returns a `Fit`.

    ``progress``: a `Progress`.
    ValueError where nothing fits: what limits, and what would help.
    """
    wanted = wanted or Wanted()
    wanted.check()
    refusals = Refusals()
    trials, tried = placed_trials(course, wanted, refusals, progress)
    trials = looked_up(course, wanted, trials, refusals)
    candidates = measured(wanted, trials, refusals, progress)
    if not candidates:
        raise _nothing_fits(wanted, tried, refusals)
    progress.step("Done", 1.0)
    front = undominated([c.used for c in candidates])
    best = sorted((candidates[i] for i in front), key=lambda c: c.score)
    return Fit(best, tried, wanted)


def _nothing_fits(wanted: Wanted, tried: int, refusals: Refusals) -> Refusal:
    """What limits, in the order of the search, and what would help those that came furthest."""
    found = refusals.found
    said = [text(found[why], wanted) for why, (text, _) in _REASONS.items() if why in found]
    furthest = [cure for why, (_, cure) in _REASONS.items() if why in found][-1]
    return Refusal(
        "Nothing fits. {tried} combinations tried; {reasons}. {furthest}",
        tried=tried,
        reasons=joined(said),
        furthest=furthest,
    )


# Why combinations are out -> what to say of it, and what would help; in the order of the search.
_REASONS = {
    "curve": (
        lambda errors, _: phrase(
            "cannot follow the curve: {count}, as “{error}”", count=len(errors), error=errors[-1]
        ),
        phrase("Make the curve gentler or longer."),
    ),
    "coverage": (
        lambda shares, _: phrase(
            "leave more than a quarter of the curve uncovered: {count}", count=len(shares)
        ),
        phrase("Make the curve longer, or the bed higher so that more, shorter units stack up."),
    ),
    "sphere": (
        lambda widest, _: phrase(
            "open wider than the 60° that a sphere allows: {count}", count=len(widest)
        ),
        phrase("Make the curve gentler."),
    ),
    "height": (
        lambda heights, w: phrase(
            "print higher than {height:.4g} mm: {count}, the lowest {lowest:.4g} mm",
            height=w.bed[2],
            count=len(heights),
            lowest=min(heights),
        ),
        phrase(
            "Make the panels thinner, the curve shorter (or cut it into parts), or use a higher "
            "bed."
        ),
    ),
    "plan": (
        lambda edges, w: phrase(
            "too large for the bed of {width:.4g} × {depth:.4g} mm: {count}, from {EdgeLength} "
            "{shortest:.4g} mm on",
            width=w.bed[0],
            depth=w.bed[1],
            count=len(edges),
            shortest=min(edges),
        ),
        phrase("Use a larger bed, a larger {HeightRatio} or a shorter curve."),
    ),
    "margin": (
        lambda best, w: phrase(
            "all others snap too weakly: margin {best:.2f} at best, {wanted:.2f} wanted",
            best=max(best),
            wanted=w.margin,
        ),
        phrase(
            "Give the hinges less play (steeper cones, smaller {GapLength}, or flexible hinges, "
            "which have none), ask for a smaller margin, or use a bed that holds longer edges."
        ),
    ),
    "strain": (
        lambda least, w: phrase(
            "those that snap hard enough strain by {least:.2%} or more, beyond {limit:.2%}",
            least=min(least),
            limit=w.strain_limit,
        ),
        phrase("Give the hinges less play, ask for a smaller margin, or use a tougher material."),
    ),
    "units": (
        lambda errors, _: phrase(
            "units cannot be made: {count}, as “{error}”", count=len(errors), error=errors[0]
        ),
        phrase("Make the curve gentler, or the panels thinner."),
    ),
}
