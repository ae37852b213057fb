# SPDX-License-Identifier: LGPL-2.1-or-later
"""What may be varied to make a tube along a curve printable: see `printable`."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from math import radians
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..curves.crossing import CurveTable
from ..curves.gentler import smooth
from ..curves.legs import Legs, SeenAlong
from ..curves.quick import Quick, QuickMarch
from ..curves.rules import END_FIT, PlacementRule
from ..curves.ruling import default_ruling, openness
from ..design import CurveGeometry, Placing, Thickness, TubeDesign
from ..hinges.parameters import HingeParameters
from ..snap.contact import holding
from ..snap.table import USUAL
from ..snap.targets import TargetMargin
from ..thick.linkage import ThickUnit
from ..units.closed_forms import plane_unit
from ..units.ratios import RatioRule

if TYPE_CHECKING:
    from ..curves.curve import Curve
    from ..curves.paths import Path
    from ..progress import Progress

GAMMAS = tuple(radians(g) for g in (16, 19, 22, 25, 28, 31, 34, 38))
EDGES = 11
# Face, gap between planes, gap length; finer ones for tubes round tight bends, whose cones come
# nearer to each other than a usual layer: they are printed in fine ones.
_PANELS = (
    (1.2, 0.6, 0.4), (1.2, 0.6, 0.3), (0.8, 0.4, 0.3), (0.8, 0.4, 0.25), (0.6, 0.4, 0.2)
)  # fmt: skip
_FINE_GAP, _FINE_LAYER = 0.35, 0.1
_OF_BED = 0.55  # of the bed's longer side: ‖AB‖ of the widest print
_LEAST_OPENNESS = radians(25)
_BAND = radians(18), radians(95)  # of thetas that may come out
_SHARE = 0.012  # as near to the least ratio as units are made well
_SPARE = 1.12  # of the margin, for what a table does not know
_PER_CURVE = 1.8  # edge lengths that a curve must have
_STEERED = 0.03  # of ‖AB‖: tolerance where ends alone leave thetas too far apart
_NARROW = radians(9)  # by which steering brings the narrowest unit up
_UNEVEN = radians(28)
_NODES = 640


def finer(first: HingeParameters, least_gap: float = 0.0) -> tuple:
    """`HingeParameters` to try: those that are there ``first``, then ones with less play.

    ``least_gap`` (mm): what the printer keeps open.
    """
    found = [first]
    for face, gap_between, gap in _PANELS:
        try:
            layer = first.layer_height
            tried = replace(
                first,
                face_thickness=face,
                gap_between_planes=gap_between,
                gap_length=gap,
                layer_height=min(layer, _FINE_LAYER) if gap < _FINE_GAP else layer,
            )
            tried.check()
        except ValueError:  # finer than its process keeps open
            continue
        if tried.play < first.play and gap >= least_gap:
            found.append(tried)
    return tuple(found)


@dataclass(frozen=True)
class Wish:
    """``bed`` (x, y, z mm) of the printer, smallest ``margin`` of all units, ``height_ratio``.

    ``panels``: what hinges and panels may be, `HingeParameters`, those to prefer first;
    ``higher``: height ratios of strips that have to be higher, along curves that climb;
    ``preload`` as of a HingeSet: how much of their play deployed hinges take up, None: as each
    unit needs it.
    """

    bed: tuple = (250.0, 210.0, 210.0)
    margin: float = 1.2
    height_ratio: float = 2.5
    higher: tuple = (2.0, 1.6)
    panels: tuple = finer(USUAL)
    preload: float | None = None

    def edges(self, length: float) -> NDArray:
        """Edge lengths ‖AB‖ (mm) to try along a curve of ``length``."""
        high = min(_OF_BED * max(self.bed[:2]), length / _PER_CURVE)
        low = min(max(length / 60, 18.0), high / 1.3)
        return np.round(np.geomspace(low, high, EDGES), 1)

    def room(self, hinges: HingeParameters, edge: float, theta: float) -> bool:
        """Whether a unit of ``edge`` (mm) and ``theta`` has room for its hinges."""
        return _room(hinges, self.height_ratio, round(edge, 1), round(theta, 2))

    def stacked(self, count: int, hinges: HingeParameters) -> float:
        """Height (mm) of a print of ``count`` units."""
        return 4 * hinges.pitch * count - hinges.gap_between_planes

    def in_one(self, hinges: HingeParameters) -> int:
        """How many units lie on each other in the printer's height."""
        return int((self.bed[2] + hinges.gap_between_planes) // (4 * hinges.pitch))


@dataclass(frozen=True)
class Option:
    """One combination, with what a quick march along the curve and a table of snap say of it.

    ``expected``: snap margin of its narrowest unit; ``cost``: the less the better; ``change`` (mm)
    by which the curve is gentler than the drawn one, made so by `gentler` over a ``width`` (mm).
    """

    geometry: CurveGeometry
    level: bool
    flip: bool
    edge_length: float
    gamma: float
    hinges: HingeParameters
    rule: PlacementRule
    count: int
    thetas: tuple
    expected: float
    cost: float = field(compare=False, default=0.0)
    change: float = 0.0
    width: float = 0.0

    def design(self, wish: Wish, height_ratio: float) -> TubeDesign:
        """The `TubeDesign`, of units that aim for a margin a little above the wanted one."""
        target = TargetMargin(
            self.edge_length, self.hinges.pitch, _SPARE**2 * wish.margin, self.hinges.play
        )
        where = Placing(
            self.geometry, self.edge_length, self.gamma, self.hinges.pitch, self.flip, self.level,
            self.rule,
        )  # fmt: skip
        thickness = Thickness(
            self.hinges.face_thickness,
            self.hinges.gap_between_planes,
            preload=None if wish.preload is None else wish.preload * self.hinges.gap_length,
            hinges=None if wish.preload == 0 else self.hinges,
        )
        return TubeDesign(where, RatioRule("TargetSnap", target=target), height_ratio,
                          thickness)  # fmt: skip

    def firmer(self, design: TubeDesign) -> TubeDesign:
        """The same design with ratios as near to the least as can be made."""
        return replace(design, rule=RatioRule("Adaptive", share=_SHARE))


@lru_cache(maxsize=4096)
def _room(hinges: HingeParameters, height_ratio: float, edge: float, theta: float) -> bool:
    low = np.sin(theta / 2)
    try:
        unit = plane_unit(np.array([theta]), low + _SHARE * (1 - low), edge, edge / height_ratio)
        thick = ThickUnit(unit, hinges.face_thickness, hinges.gap_between_planes)
        holding(thick, hinges)
    except ValueError:
        return False
    return True


def views(geometry: CurveGeometry) -> list[tuple[CurveGeometry, bool]]:
    """[(`CurveGeometry`, level)] to try: rulings of a space curve, with and without Level."""
    if geometry.family != "General":
        return [(geometry, False)]
    found, seen = [], []
    axes = [("parallel", tuple(axis)) for axis in np.eye(3)[::-1]]
    try:
        proposed = [geometry.ruling, default_ruling(geometry.curve)]
    except ValueError:
        proposed = [geometry.ruling]
    for legs in [*proposed, *axes]:
        key = legs[0], tuple(np.round(np.asarray(legs[1], float), 6))
        if key in seen or openness(geometry.curve, legs) < _LEAST_OPENNESS:
            continue
        seen.append(key)
        found += [(replace(geometry, legs=legs), level) for level in _levels(legs)]
    return found or [(geometry, level) for level in _levels(geometry.ruling)]


def _levels(legs: tuple) -> tuple[bool, ...]:
    return (True, False) if legs[0] == "parallel" else (False,)


def options(
    geometry: CurveGeometry, wish: Wish, progress: "Progress", coarse: bool = False
) -> list[Option]:
    """All `Option` that follow the curve, those to try first in front; ``coarse``: fewer."""
    found: list[Option] = []
    chosen = views(geometry)
    quick = smooth(geometry.curve, _NODES)  # a kernel's curve takes its time for every point
    for n, (view, level) in enumerate(chosen):
        progress.step("Looking for a tube along the curve…", n / len(chosen))
        legs = Legs(view.legs)
        curve: Curve = SeenAlong(quick, legs) if level else quick
        length = float(CurveTable(curve, 1e9).lengths[-1])
        for edge in wish.edges(length)[:: 1 + coarse]:
            table = CurveTable(curve, edge)
            for flip in (False, True):
                gammas = GAMMAS[coarse :: 1 + coarse]
                found += _marched(view, level, flip, table, legs, float(edge), wish, gammas)
    return sorted(found, key=lambda option: option.cost)


def _marched(
    view: CurveGeometry,
    level: bool,
    flip: bool,
    table: CurveTable,
    legs: Legs,
    edge: float,
    wish: Wish,
    gammas: Sequence[float],
) -> Iterator[Option]:
    closed = bool(np.linalg.norm(table.points[-1] - table.points[0]) <= 1e-6 * table.lengths[-1])
    for pitch in sorted({hinges.pitch for hinges in wish.panels}):
        if edge < 10 * pitch:
            continue
        try:
            march = QuickMarch(table, legs, edge, pitch, flip, closed=closed)
        except ValueError:
            return
        for gamma in gammas:
            most = 4 * int(table.lengths[-1] / (edge * np.sin(gamma))) + 8
            found = march.march(gamma, most if closed else None)
            if closed:
                inside = int((found.lengths <= march.path.length).sum())
                found = replace(found, lengths=found.lengths[:inside],
                                thetas=found.thetas[: inside - 1])  # fmt: skip
            left = march.path.length - found.lengths[-1]
            if len(found.thetas) < 2 or (found.tight and left > edge / 2):
                continue
            for hinges in wish.panels:
                if hinges.pitch == pitch:
                    yield from _judged(view, level, flip, edge, gamma, hinges, found, march, wish)


def _judged(
    view: CurveGeometry,
    level: bool,
    flip: bool,
    edge: float,
    gamma: float,
    hinges: HingeParameters,
    found: Quick,
    march: QuickMarch,
    wish: Wish,
) -> Iterator[Option]:
    """Options of one march: with the ends met alone, and steered where thetas differ much."""
    low, high = float(found.thetas.min()), float(found.thetas.max())
    rules = [(END_FIT, low, high)]
    if high - low > _UNEVEN and not (view.ruling[0] == "point" and view.family == "General"):
        steered = PlacementRule("Steered", _STEERED * edge)
        rules.append((steered, low + _NARROW, high - _NARROW))
    for rule, narrow, wide in rules:
        if narrow < _BAND[0] or wide > _BAND[1]:
            continue
        if not wish.room(hinges, 1.02 * edge, (narrow + wide) / 2):
            continue
        margin = expected(narrow, edge, hinges)
        count = len(found.thetas)
        parts = -(-count // max(wish.in_one(hinges), 1))
        weak = max(0.0, np.log(_SPARE**2 * wish.margin / margin))
        steps = np.diff(found.lengths)
        bow = float((steps**2).max() / 8 * _bend(march.path)) / edge
        cost = (
            40 * weak
            + parts
            + 0.5 * wish.stacked(count, hinges) / wish.bed[2]
            + (0.6 * wish.panels.index(hinges))
            + 4 * bow
            + 0.5 * (rule is not END_FIT)
            + 0.02 * abs(np.degrees(gamma) - 24)
            + 0.3 * flip
            + 0.3 * (not level and view.family == "General" and view.ruling[0] == "parallel")
        )
        yield Option(
            view, level, flip, edge, gamma, hinges, rule, count, (narrow, wide), margin, cost
        )


def _bend(path: "Path") -> float:
    """Largest curvature of a path."""
    tangents = path.slopes / np.linalg.norm(path.slopes, axis=1, keepdims=True)
    return np.percentile(np.linalg.norm(np.diff(tangents, axis=0), axis=1), 99) / path.step


def expected(theta: float, edge: float, hinges: HingeParameters) -> float:
    """Snap margin that a table knows of a unit of opening ``theta`` and the least ratio."""
    target = TargetMargin(edge, hinges.pitch, play=hinges.play)
    low = np.sin(theta / 2)
    try:
        margin = float(target.expected(theta, low + _SHARE * (1 - low))[0])
    except ValueError:
        return 1e-3
    return margin if np.isfinite(margin) and margin > 0 else 1e-3
