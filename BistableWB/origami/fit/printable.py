# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search for a printable tube along a curve: every number measured on every unit.

Kind and ruling, Level, side, ‖AB‖, gamma, rule, hinge and panel numbers are varied (`options`) and
looked up; the most promising are made thick, laid out and measured with the hinges' own contacts
until one holds. What comes nearest is returned where none does.
"""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from time import thread_time
from typing import TYPE_CHECKING, NamedTuple, cast

import numpy as np

from ..curves.crossing import CurveTable
from ..curves.gentler import gentler
from ..curves.spheres import Projected
from ..design import CurveGeometry, TubeDesign
from ..errors import NOTHING, Phrase, message_of, phrase
from ..progress import NOBODY, Progress
from ..snap.contact import holding
from ..snap.margin import needed_clearance
from .larger import SCALES, larger
from .options import Option, Wish, expected, options

if TYPE_CHECKING:
    from ..curves.curve import Curve
    from ..hinges.parameters import HingeParameters
    from ..snap.contact import Contacts
    from ..thick.thick_tube import ThickTube

Split = Callable[["ThickTube", "HingeParameters"], list]  # [] if a unit does not fit
Bend = Callable[[float], tuple[CurveGeometry, float]]  # width → gentler curve, its change (mm)

_MEASURED, _A_FEW = 8, 2  # tubes
_FIRST = 2  # that are measured whatever the table says
_TRIED = 30  # with those that are refused at once
_PROMISING = 0.95  # of the margin, by the table, once the placement is known
_HOPELESS = 0.8  # of the margin, by the table
_HALF, _WHOLE, _LAST = 22.0, 50.0, 56.0  # seconds after which nothing new is begun
_LEAST_BENT, _FIRST_BENT, _MOST_BENT = 0.008, 0.045, 0.19  # of the length
_WIDER, _SAME_BEND, _TRIALS = 1.6, 1.09, 9
_ALIKE = 1.12  # edge lengths and gammas nearer than this fail alike
_ENOUGH = 0.999
_NOT_BENT = 1e-9  # mm: a curve that is not the drawn one, though not gentler
_MOST_UNITS = 400
_GAP = 0.01  # of ‖AB‖ that may be left at the end


@dataclass(frozen=True)
class Printable:
    """A design that was measured.

    ``margins`` (n,) snap margins of all units; ``parts`` [(first, last)] units of each print, from
    0; ``end_gap`` mm; ``blocked``: None, or the one number that stands in the way, as a `Phrase`.
    """

    option: Option
    design: TubeDesign
    margins: np.ndarray
    parts: list
    end_gap: float
    blocked: Phrase | None = None

    @property
    def margin(self) -> float:
        """The weakest."""
        return float(self.margins.min())


@dataclass
class Search:
    """What has been tried: ``refused`` [(option, sentence)] and the ``best`` so far."""

    wish: Wish
    split: Split
    refused: list = field(default_factory=list)
    best: Printable | None = None

    def measure(self, option: Option) -> Printable | None:
        """The `Printable` of an option; None where it cannot be made, and `refused` says why.

        Where the strip is too low for its hinges, as where curves climb, higher ones are tried.
        """
        for ratio in (self.wish.height_ratio, *self.wish.higher):
            try:
                found = self._firm(option, option.design(self.wish, ratio))
            except ValueError as error:
                self.refused.append((option, error))
                if _low_strip(error):
                    continue
                return None
            if self.best is None or _rank(found) > _rank(self.best):
                self.best = found
            return found
        return None

    def promises(self, option: Option, change: float) -> bool:
        """Whether the option's placement, as it really comes out, may hold what is wished."""
        try:
            thetas = option.design(self.wish, self.wish.height_ratio).placement().thetas
        except ValueError as error:
            self.refused.append((option, error))
            return False
        narrow = float(thetas.min())
        margin = expected(narrow, option.edge_length, option.hinges)
        enough = margin >= _PROMISING * self.wish.margin
        # Something has to be measured, or nobody could say what comes near.
        return enough or (self.best is None and not change)

    def _firm(self, option: Option, design: TubeDesign) -> Printable:
        found = self._measured(option, design)
        if found.margin < _ENOUGH * self.wish.margin:
            firmer = self._measured(option, option.firmer(design))
            found = firmer if firmer.margin > found.margin else found
        return found

    def _measured(self, option: Option, design: TubeDesign) -> Printable:
        tube = design.thick()
        held = cast("Contacts", holding(tube.thick, option.hinges))  # options have knuckles
        margins = np.atleast_1d(needed_clearance(tube.thick, held, 5e-3)[0])
        parts = self.split(tube, option.hinges)
        gap = design.placement().end_gap + tube.deviation()
        blocked = None
        if not parts:
            blocked = phrase("one unit with {EdgeLength} {edge:.3g} mm is larger than the bed of "
                             "{x:.4g} × {y:.4g} mm", edge=option.edge_length, x=self.wish.bed[0],
                             y=self.wish.bed[1])  # fmt: skip
        elif margins.min() < _ENOUGH * self.wish.margin:
            blocked = phrase(
                "unit {unit} snaps with a margin of {margin:.3g} where {wanted:.3g} is wanted",
                unit=int(margins.argmin()) + 1, margin=float(margins.min()),
                wanted=self.wish.margin,
            )  # fmt: skip
        elif gap > _GAP * option.edge_length:
            blocked = phrase("the tube ends {gap:.3g} mm from the curve's end", gap=gap)
        return Printable(option, design, margins, parts, gap, blocked)


def _rank(found: Printable) -> tuple[bool, bool, float]:
    return found.blocked is None, bool(found.parts), found.margin


def _low_strip(error: BaseException | None) -> bool:
    """Whether a hinge along the legs has no room."""
    while error is not None:
        hinge = getattr(error, "hinge", None)
        if hinge is not None:
            return hinge.name.startswith("leg")
        error = error.__cause__ or error.__context__
    return False


class Answer(NamedTuple):
    """What a search comes to.

    ``found``: the first `Printable` that holds all that is wished, else the best that comes near,
    None where nothing at all could be made. ``refused``: [(option, refusal)]. ``cure``: where
    nothing holds, how much larger the curve would have to be, or nothing if that is not known.
    """

    found: Printable | None
    refused: list
    cure: Phrase = NOTHING

    @property
    def blocked(self) -> Phrase | None:
        """The one number that stands in the way, and what would help; None where nothing does."""
        if self.found is not None and self.found.blocked is None:
            return None
        why = self.found.blocked if self.found is not None else self._refused()
        if not self.cure.template:
            return why
        return phrase("{why}; {cure}", why=why, cure=self.cure)

    def _refused(self) -> Phrase:
        if self.refused:
            return message_of(self.refused[-1][1])
        return phrase("the curve is too short, or too tight, for two units with hinges")


def printable(
    geometry: CurveGeometry,
    wish: Wish,
    split: Split,
    progress: Progress = NOBODY,
    bend: Bend | None = None,
) -> Answer:
    """The `Answer` for the curve of ``geometry``, a `design.CurveGeometry`.

    ``split(thick tube, hinges)`` → units of each print, [] if one does not fit. Where no tube along
    the curve itself holds, gentler ones are tried, those that change least first:
    ``bend(width)`` → gentler `CurveGeometry` and its change (mm); by default those of `gentler`.
    """
    start = thread_time()
    search = Search(wish, split)
    found = _searched(search, geometry, _MEASURED, start + _HALF, progress.part(0, 0.5))
    if found is None:
        bend = bend or (lambda width: _bent(geometry, width))
        found = _gentler(search, geometry, bend, start + _WHOLE, progress.part(0.5, 0.9))
    if found is not None:
        return Answer(found, search.refused)
    cure = _larger(search, geometry, start + _LAST, progress.part(0.9, 1))
    return Answer(search.best, search.refused, cure)


def _searched(
    search: Search,
    geometry: CurveGeometry,
    most: int,
    until: float,
    progress: Progress,
    change: float = 0.0,
    width: float = 0.0,
) -> Printable | None:
    wish = search.wish
    tried: list[Option] = []
    measured = 0
    for option in options(geometry, wish, progress.part(0, 0.3), change > 0):
        late = thread_time() > until
        if measured >= most or len(tried) >= _TRIED or late:
            break
        if option.count > _MOST_UNITS or any(_alike(option, other) for other in tried):
            continue
        if option.expected < _HOPELESS * wish.margin and (measured >= _FIRST or change):
            break
        progress.step("Measuring a tube…", 0.3 + 0.7 * min(len(tried) / _TRIED, 1.0))
        tried.append(option)
        if not search.promises(option, change):
            continue
        found = search.measure(replace(option, change=change, width=width))
        measured += found is not None
        if found is not None and found.blocked is None:
            return found
    return None


def _bent(geometry: CurveGeometry, width: float) -> tuple[CurveGeometry, float]:
    curve: Curve
    curve, change = gentler(geometry.curve, width)
    if geometry.family == "Sphere":
        radius = cast(float, geometry.sphere_radius)
        curve = Projected(curve, np.asarray(geometry.ruling[1]), radius)
    return replace(geometry, curve=curve), change


def _gentler(
    search: Search, geometry: CurveGeometry, bend: Bend, until: float, progress: Progress
) -> Printable | None:
    """The tube along the gentler curve of least change that holds: by halving what is not known.

    The more a curve may change the better units follow it, by and large.
    """
    length = float(CurveTable(geometry.curve, 1e9).lengths[-1])
    best: Printable | None = None
    low, high = _LEAST_BENT, _MOST_BENT
    share, trials = _FIRST_BENT, 0
    while trials < _TRIALS and thread_time() < until:
        part = progress.part(trials / _TRIALS, (trials + 1) / _TRIALS)
        bent, change = bend(share * length)
        found = _searched(search, bent, _A_FEW, until, part, change, share * length)
        best = found or best
        low, high = (low, share) if found else (share, high)
        if high / low < _SAME_BEND:
            break
        share = float(np.sqrt(low * high)) if best else min(_WIDER * share, high)
        trials += 1
        if low >= _MOST_BENT:
            break
    return best


def _larger(search: Search, geometry: CurveGeometry, until: float, progress: Progress) -> Phrase:
    """By how much the curve would have to be drawn larger for a tube that holds."""
    length = float(CurveTable(geometry.curve, 1e9).lengths[-1])
    trial = Search(search.wish, search.split)
    for n, scale in enumerate(SCALES):
        if thread_time() > until:
            break
        part = progress.part(n / len(SCALES), (n + 1) / len(SCALES))
        if _searched(trial, larger(geometry, scale), _A_FEW, until, part, _NOT_BENT):
            return phrase(
                "drawn {scale:.3g} times as large, {more:.3g} mm longer, the curve would do",
                scale=scale,
                more=(scale - 1) * length,
            )
    return NOTHING


def _alike(one: Option, other: Option) -> bool:
    same = (one.geometry.legs, one.level, one.flip, one.hinges, one.rule.name) == (
        other.geometry.legs, other.level, other.flip, other.hinges, other.rule.name
    )  # fmt: skip
    near = max(one.edge_length / other.edge_length, other.edge_length / one.edge_length) < _ALIKE
    return same and near and abs(one.gamma - other.gamma) < 0.08
