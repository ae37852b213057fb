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

from .fit_steps import looked_up, measured, placed_trials, undominated
from .fit_terms import Candidate, Course, Refusals, Wanted, rule_of

__all__ = ["Candidate", "Course", "Fit", "Wanted", "auto_fit", "rule_of"]


@dataclass(frozen=True)
class Fit:
    """Result of `auto_fit`: ``candidates``, best first; ``tried`` combinations, the ``wanted``."""

    candidates: list
    tried: int
    wanted: Wanted

    @property
    def recommended(self):
        """The candidate that uses least of its allowances."""
        return self.candidates[0]


def auto_fit(course, wanted=None, progress=None):
    """Search designs of tubes along a `Course` that are as `Wanted`. Returns a `Fit`.

    ``progress(fraction, text)`` is called now and then; an exception of its ends the search.
    ValueError where nothing fits: what limits, and what would help.
    """
    wanted = wanted or Wanted()
    wanted.check()
    progress = progress or (lambda fraction, text: None)
    refusals = Refusals()
    trials, tried = placed_trials(course, wanted, refusals, progress)
    trials = looked_up(course, wanted, trials, refusals)
    candidates = measured(course, wanted, trials, refusals, progress)
    if not candidates:
        raise ValueError(_nothing_fits(wanted, tried, refusals))
    progress(1.0, "Done")
    front = undominated([c.used for c in candidates])
    best = sorted((candidates[i] for i in front), key=lambda c: c.score)
    return Fit(best, tried, wanted)


def _nothing_fits(wanted, tried, refusals):
    """What limits, in the order of the search, and what would help those that came furthest."""
    found = refusals.found
    said = [text(found[why], wanted) for why, (text, _) in _REASONS.items() if why in found]
    furthest = [cure for why, (_, cure) in _REASONS.items() if why in found][-1]
    return f"Nothing fits. {tried} combinations tried; {'; '.join(said)}. {furthest}"


# Why combinations are out -> what to say of it, and what would help; in the order of the search.
_REASONS = {
    "curve": (
        lambda texts, _: f"cannot follow the curve: {len(texts)}, as “{texts[-1]}”",
        "Make the curve gentler or longer.",
    ),
    "coverage": (
        lambda texts, _: f"leave more than a quarter of the curve uncovered: {len(texts)}",
        "Make the curve longer, or the bed higher so that more, shorter units stack up.",
    ),
    "sphere": (
        lambda texts, _: f"open wider than the 60° that a sphere allows: {len(texts)}",
        "Make the curve gentler.",
    ),
    "height": (
        lambda heights, w: (
            f"print higher than {w.bed[2]:.4g} mm: {len(heights)}, the lowest {min(heights):.4g} mm"
        ),
        "Make the panels thinner, the curve shorter (or cut it into parts), or use a higher bed.",
    ),
    "plan": (
        lambda edges, w: (
            f"too large for the bed of {w.bed[0]:.4g} × {w.bed[1]:.4g} mm: {len(edges)}, from "
            f"EdgeLength {min(edges):.4g} mm on"
        ),
        "Use a larger bed, a larger HeightRatio or a shorter curve.",
    ),
    "margin": (
        lambda best, w: (
            f"all others snap too weakly: margin {max(best):.2f} at best, {w.margin:.2f} wanted"
        ),
        "Give the hinges less play (steeper cones, smaller GapLength, or flexible hinges, which "
        "have none), ask for a smaller margin, or use a bed that holds longer edges.",
    ),
    "strain": (
        lambda least, w: (
            f"those that snap hard enough strain by {min(least):.2%} or more, beyond "
            f"{w.strain_limit:.2%}"
        ),
        "Give the hinges less play, ask for a smaller margin, or use a tougher material.",
    ),
    "units": (
        lambda texts, _: f"units cannot be made: {len(texts)}, as “{texts[0]}”",
        "Make the curve gentler, or the panels thinner.",
    ),
}
