# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a zigzag is placed on its curve (section 5): the paper's march, an end fit, or steered."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ..errors import Refusal, name_of

RULES = ("Paper", "EndFit", "Steered")
DIRECTIONS = ("Free", "Square")
TOLERANCE = 0.01  # of ‖AB‖


@dataclass(frozen=True)
class PlacementRule:
    """A rule by its ``name`` and what steering goes by.

    Paper: from the start, by gamma, as far as it goes. EndFit: the same with gamma taken near the
    wanted one, so that the last midpoint is the curve's end. Steered: midpoints may leave the curve
    by ``tolerance`` (mm; None or 0: 1 % of ‖AB‖), both ends are met, thetas are as even as can be
    and within ``band`` (radians); ``symmetric``: the same from both ends; ``start``, ``end``:
    "Square" for blocks that stand square on the curve. A closed curve is closed by all rules but
    Paper. ``near``: a `Placement` on the same curve that is to change little: as many units.
    """

    name: str = "Paper"
    tolerance: float | None = None
    symmetric: bool = False
    start: str = "Free"
    end: str = "Free"
    band: tuple = (np.radians(25.0), np.radians(80.0))
    near: Any = field(default=None, compare=False)

    def within(self, edge_length: float) -> float:
        """The tolerance in mm for an edge length ‖AB‖; `Refusal` for one that cannot be."""
        tolerance = TOLERANCE * edge_length if self.tolerance is None else self.tolerance
        if not (np.isfinite(tolerance) and tolerance > 0):
            raise Refusal(
                "{Tolerance} is {value:.4g} mm: midpoints exactly on the curve leave nothing to "
                "steer with, and both ends cannot be met",
                cure="set {Tolerance} above 0 (1 % of {EdgeLength} is {usual:.3g} mm), or choose "
                "EndFit as {PlacementRule}",
                parameter="Tolerance",
                value=float(tolerance),
                usual=TOLERANCE * edge_length,
            )
        return float(tolerance)

    def check(self) -> None:
        """`Refusal` for names that are none."""
        for parameter, value, known in (
            ("PlacementRule", self.name, RULES),
            ("StartDirection", self.start, DIRECTIONS),
            ("EndDirection", self.end, DIRECTIONS),
        ):
            if value not in known:
                raise Refusal(
                    "{name} {value!r} is unknown",
                    cure="choose one of {known}",
                    parameter=parameter,
                    name=name_of(parameter),
                    value=value,
                    known=", ".join(known),
                )


PAPER = PlacementRule()
END_FIT = PlacementRule("EndFit")
STEERED = PlacementRule("Steered")
