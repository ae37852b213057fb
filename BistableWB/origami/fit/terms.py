# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a search for designs is asked and what it answers: see `auto_fit`."""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ..design import CurveGeometry, Placing, TubeDesign
from ..errors import Refusal, name_of
from ..hinges.parameters import HingeParameters
from ..snap.table import USUAL
from ..snap.targets import TargetMargin
from ..units.ratios import RatioRule

if TYPE_CHECKING:
    from ..curves.curve import Curve
    from ..curves.placement import Placement

COVERAGE_ALLOWANCE = 0.25  # of the curve that may stay uncovered
DEVIATION_ALLOWANCE = 0.03  # of the curve's length
_SAME_PLAY = 0.02  # relative: a field shows two decimals


@dataclass(frozen=True)
class Wanted:
    """What a print should be: bed (x, y, z), panels, gaps and the play of hinges in mm.

    ``margin``: smallest snap margin; ``hinges``: `HingeParameters` of which panels, gaps and play
    are as given here (None: those of new hinge sets); ``strain_limit``: largest peak misfit /
    ‖AB‖, 0: none; ``height_ratio``: ‖AB‖ / h.
    """

    bed: tuple = (250.0, 210.0, 210.0)
    margin: float = 1.5
    face_thickness: float = 1.2
    gap_between_planes: float = 0.6
    play: float = 0.28
    strain_limit: float = 0.0
    height_ratio: float = 2.5
    hinges: HingeParameters | None = None

    @property
    def parameters(self) -> HingeParameters:
        """`HingeParameters` with these panels, gaps and play."""
        found = replace(
            self.hinges or USUAL,
            face_thickness=self.face_thickness,
            gap_between_planes=self.gap_between_planes,
        )
        if found.play and abs(found.play / self.play - 1) > _SAME_PLAY:
            found = replace(found, gap_length=found.gap_length * self.play / found.play)
        return found

    @property
    def pitch(self) -> float:
        """Face thickness + gap between planes, mm."""
        return self.face_thickness + self.gap_between_planes

    @property
    def reach(self) -> float:
        """What a print reaches beyond its creases, mm: barrels, and 1 mm of compensation."""
        return self.face_thickness + self.gap_between_planes / 2 + 1.0

    def bears(self, strain: float) -> bool:
        """Whether a peak misfit / ‖AB‖ is within the limit, if there is one."""
        return not self.strain_limit or strain <= self.strain_limit

    def height(self, count: int) -> float:
        """Height of the flat-folded print of so many units, mm."""
        return count * 4 * self.pitch - self.gap_between_planes

    def holds(self, length: float, width: float) -> bool:
        """Whether the bed holds this plan, as it is or turned by 90°."""
        return any(length <= x and width <= y for x, y in (self.bed[:2], self.bed[1::-1]))

    def check(self) -> None:
        """ValueError for numbers that cannot be."""
        positive = {
            "Bed": min(self.bed),
            "Margin": self.margin,
            "FaceThickness": self.face_thickness,
            "GapBetweenPlanes": self.gap_between_planes,
            "HingePlay": self.play,
            "HeightRatio": self.height_ratio,
        }
        for name, value in positive.items():
            if not (np.isfinite(value) and value > 0):
                raise Refusal(
                    "{name} is {value:.6g}: set it to a number above 0.",
                    parameter=name,
                    name=name_of(name),
                    value=value,
                )


@dataclass(frozen=True)
class Course:
    """The curve, as `design.CurveGeometry` has it, and how the triangles start on it."""

    curve: "Curve"
    family: str = "Plane"
    legs: tuple | None = None
    sphere_radius: float | None = None
    flip: bool = False
    level: bool = False

    @cached_property
    def geometry(self) -> CurveGeometry:
        """The `design.CurveGeometry`."""
        return CurveGeometry(self.curve, self.family, self.legs, self.sphere_radius)

    def placing(self, edge_length: float, gamma: float, wanted: Wanted) -> Placing:
        """`design.Placing` of triangles that leave room for the wanted panels."""
        return Placing(self.geometry, edge_length, gamma, wanted.pitch, self.flip, self.level)


@dataclass(frozen=True)
class Candidate:
    """One proposal, measured. Lengths in mm, ``gamma`` and ``thetas`` (least, largest) in radians.

    ``rule``: Adaptive with ``share``, TargetSnap, or Exact; ``weakest``: number of the weakest
    unit, from 1; ``print_size``: x, y, z of the flat-folded print;
    ``coverage``: part of the curve that is followed; ``deviation``: largest distance of the curve
    from the straight lines between the tube's blocks; ``used``: parts used of five allowances
    (height of the bed, strain limit, wanted margin / margin, 3 % of the length for the deviation,
    25 % of the curve uncovered).
    """

    edge_length: float
    gamma: float
    rule: str
    share: float | None
    count: int
    thetas: tuple
    margin_min: float
    strain_max: float
    weakest: int
    print_size: tuple
    coverage: float
    deviation: float
    used: tuple

    @property
    def score(self) -> float:
        """Sum of ``used``: the smaller the better."""
        return float(sum(self.used))


@dataclass
class Trial:
    """A placement that fits the bed, one rule for its ratios, and its snap as far as is known."""

    placing: Placing
    placed: "Placement"
    deviation: float
    length: float
    rule: str
    share: float | None = None
    margin: float = np.nan
    strain: float = np.nan

    def used(self, wanted: Wanted, margin: float, strain: float) -> tuple[float, ...]:
        placed = self.placed
        return (
            wanted.height(len(placed)) / wanted.bed[2],
            strain / wanted.strain_limit if wanted.strain_limit else 0.0,
            wanted.margin / margin,
            self.deviation / (DEVIATION_ALLOWANCE * self.length),
            (1 - placed.followed / self.length) / COVERAGE_ALLOWANCE,
        )


@dataclass
class Refusals:
    """Why combinations are out: {reason: [texts]}, and what each kind asks for."""

    found: dict = field(default_factory=dict)

    def add(self, reason: str, text: Exception | float | str = "") -> None:
        self.found.setdefault(reason, []).append(text)


def target_of(wanted: Wanted, edge_length: float) -> TargetMargin:
    """`TargetMargin` of the rule TargetSnap for these requirements and an edge length (mm)."""
    return TargetMargin(edge_length, wanted.pitch, wanted.margin, wanted.play, wanted.strain_limit)


def rule_of(rule: str, share: float | None, wanted: Wanted, edge_length: float) -> RatioRule:
    """`RatioRule` by the name and the share of a candidate."""
    return RatioRule(rule, share=share or 0.0, target=target_of(wanted, edge_length))


def design_of(course: Course, candidate: Candidate, wanted: Wanted) -> TubeDesign:
    """The `TubeDesign` that a `Candidate` proposes along a `Course`."""
    placing = course.placing(candidate.edge_length, candidate.gamma, wanted)
    rule = rule_of(candidate.rule, candidate.share, wanted, candidate.edge_length)
    return TubeDesign(placing, rule, wanted.height_ratio)
