# SPDX-License-Identifier: LGPL-2.1-or-later
"""How every unit's ratio c = ‖A'C'‖/‖AB‖ is chosen: on a plane it is free in [sin(θ/2), 1)."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Choice, Refusal
from .angles import exact_sphere_ratio, half_opening

if TYPE_CHECKING:
    from .oblique import Leaning

RULES = ("Adaptive", "Fixed", "Exact", "Paper", "TargetSnap")
SPHERE_RULES = ("Exact", "Paper")
DEFAULT_SHARE = 0.03


@dataclass(frozen=True)
class RatioRule:
    """A rule by its ``name`` and its number.

    Adaptive: c lies at the fraction ``share`` of the way from the least ratio to 1, so that it is
    in range for every unit; the least is sin(θ/2), more between leaning contacts. Fixed: the given
    ``ratio``. Exact: 1/(3 − 4 sin²(θ/2)), which closes on a sphere. Paper: 1/2. TargetSnap: as
    ``target`` chooses, a `targets.TargetMargin` or `targets.TargetBarrier`.
    """

    name: str = "Adaptive"
    ratio: float | None = None
    share: float = DEFAULT_SHARE
    target: Any = None

    def ratios(self, theta: NDArray, leaning: "Leaning | None" = None) -> Any:
        """Ratios for ``theta`` (radians, scalar or array) and `oblique.Leaning` (None: upright).

        ValueError for a bad rule or number.
        """
        if self.name == "Adaptive":
            if not (np.isfinite(self.share) and 0 <= self.share < 1):
                raise Refusal(
                    "{RatioShare} is {share:.6g}: it must be at least 0 and below 1; 0.05 to 0.2 "
                    "is usual, smaller snaps harder.",
                    parameter="RatioShare",
                    share=self.share,
                )
            low = half_opening(theta) if leaning is None else leaning.least.max(1)
            return low + self.share * (1 - low)
        if self.name == "Fixed":
            return self.ratio
        if self.name == "Exact":
            return exact_sphere_ratio(theta)
        if self.name == "Paper":
            return 0.5
        if self.name == "TargetSnap":
            return self.target.ratios(theta, leaning)
        raise Refusal(
            "{RatioRule} {name!r} is unknown: choose one of {names}.",
            parameter="RatioRule",
            name=self.name,
            names=", ".join(RULES),
        )

    @property
    def is_sphere_rule(self) -> bool:
        """Whether it is one of the paper's rules for spheres, with closed forms up to 60°."""
        return self.name in SPHERE_RULES

    def for_sphere(self) -> str:
        """The rule's name for `unit.sphere_unit`; ValueError for a rule that does not close."""
        if not self.is_sphere_rule:
            raise Refusal(
                "{RatioRule} {name} does not close on a sphere, where theta leaves no choice of "
                "ratio: choose Exact (or Paper for the paper's 1/2).",
                parameter="RatioRule",
                name=Choice(self.name),
            )
        return self.name.lower()
