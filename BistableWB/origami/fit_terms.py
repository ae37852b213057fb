# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a search for designs is asked and what it answers: see `auto_fit`."""

from dataclasses import dataclass, field

import numpy as np

from .ratios import RatioRule
from .snap import PLA_STRAIN
from .target_snap import TargetMargin

COVERAGE_ALLOWANCE = 0.25  # of the curve that may stay uncovered
DEVIATION_ALLOWANCE = 0.03  # of the curve's length


@dataclass(frozen=True)
class Wanted:
    """What a print should be: bed (x, y, z), panels, gaps and the play of hinges in mm.

    ``margin``: smallest snap margin; ``strain_limit``: largest peak strain; ``height_ratio``:
    ‖AB‖ / h.
    """

    bed: tuple = (250.0, 210.0, 210.0)
    margin: float = 1.5
    face_thickness: float = 1.2
    gap_between_planes: float = 0.6
    play: float = 0.28
    strain_limit: float = PLA_STRAIN
    height_ratio: float = 2.5

    @property
    def pitch(self):
        """Face thickness + gap between planes, mm."""
        return self.face_thickness + self.gap_between_planes

    @property
    def reach(self):
        """What a print reaches beyond its creases, mm: barrels, and 1 mm of compensation."""
        return self.face_thickness + self.gap_between_planes / 2 + 1.0

    def height(self, count):
        """Height of the flat-folded print of so many units, mm."""
        return count * 4 * self.pitch - self.gap_between_planes

    def holds(self, length, width):
        """Whether the bed holds this plan, as it is or turned by 90°."""
        return any(length <= x and width <= y for x, y in (self.bed[:2], self.bed[1::-1]))

    def check(self):
        """ValueError for numbers that cannot be."""
        positive = {
            "Bed": min(self.bed),
            "Margin": self.margin,
            "FaceThickness": self.face_thickness,
            "GapBetweenPlanes": self.gap_between_planes,
            "HingePlay": self.play,
            "StrainLimit": self.strain_limit,
            "HeightRatio": self.height_ratio,
        }
        for name, value in positive.items():
            if not (np.isfinite(value) and value > 0):
                raise ValueError(f"{name} is {value:.6g}: set it to a number above 0.")


@dataclass(frozen=True)
class Course:
    """The curve, as `objects.curve.CurveGeometry` has it, and how the triangles start on it."""

    curve: object
    family: str = "Plane"
    legs: tuple | None = None
    sphere_radius: float | None = None
    flip: bool = False
    level: bool = False


@dataclass(frozen=True)
class Candidate:
    """One proposal, measured. Lengths in mm, ``gamma`` and ``thetas`` (least, largest) in radians.

    ``rule``: Adaptive with ``share``, TargetSnap, or Exact; ``weakest``: number of the weaker of
    the two measured units, from 1; ``print_size``: x, y, z of the flat-folded print;
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
    def score(self):
        """Sum of ``used``: the smaller the better."""
        return float(sum(self.used))


@dataclass
class Trial:
    """A placement that fits the bed, one rule for its ratios, and its snap as far as is known."""

    placed: object
    gamma: float
    deviation: float
    length: float
    rule: str
    share: float | None = None
    margin: float = np.nan
    strain: float = np.nan

    def used(self, wanted, margin, strain):
        placed = self.placed
        return (
            wanted.height(len(placed)) / wanted.bed[2],
            strain / wanted.strain_limit,
            wanted.margin / margin,
            self.deviation / (DEVIATION_ALLOWANCE * self.length),
            (1 - placed.followed / self.length) / COVERAGE_ALLOWANCE,
        )


@dataclass
class Refusals:
    """Why combinations are out: {reason: [texts]}, and what each kind asks for."""

    found: dict = field(default_factory=dict)

    def add(self, reason, text=""):
        self.found.setdefault(reason, []).append(text)


def target_of(wanted, edge_length):
    """`TargetMargin` of the rule TargetSnap for these wishes and an edge length (mm)."""
    return TargetMargin(edge_length, wanted.pitch, wanted.margin, wanted.play, wanted.strain_limit)


def rule_of(rule, share, wanted, edge_length):
    """`RatioRule` by the name and the share of a candidate."""
    return RatioRule(rule, share=share or 0.0, target=target_of(wanted, edge_length))
