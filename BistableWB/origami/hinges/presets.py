# SPDX-License-Identifier: LGPL-2.1-or-later
"""The columns of the paper's Tables 1 and 2, and a coarse hinge, to start from."""

from dataclasses import dataclass, replace
from math import radians
from typing import TYPE_CHECKING

from .kinds import FLEXIBLE
from .parameters import HingeParameters

if TYPE_CHECKING:
    pass


@dataclass(frozen=True)
class Preset:
    """One column of the paper's Tables 1 and 2 (``table``; 0: Hinge6 and Coarse, of no column).

    ``given``: the cells that are readable (parameter name → value; mm, radians); ``size``: printed
    length x, y, z (mm; None where unreadable); ``doubtful``: cells that the paper's text does not
    settle, never filled in by us; ``worked``: True, False (failed) or None (not said).
    """

    table: int
    given: dict
    size: tuple
    doubtful: tuple = ()
    worked: bool | None = None

    def parameters(self, base: HingeParameters | None = None) -> HingeParameters:
        """`HingeParameters` with this column's cells; unreadable cells keep those of ``base``."""
        return replace(base or HingeParameters(), **self.given)


def _given(
    angle: int | None,
    segments: int,
    gap: float | None,
    between: float,
    thickness: float | None,
    profile: float | None,
) -> dict[str, float]:
    cells = {
        "rotation_angle": None if angle is None else radians(angle),
        "segmentations": segments,
        "gap_length": gap,
        "gap_between_planes": between,
        "face_thickness": thickness,
        "layer_height": profile,
    }
    return {name: value for name, value in cells.items() if value is not None}


PRESETS = {
    "Hinge1": Preset(
        1, _given(0, 3, None, 3, 1.5, 0.3), (45, 36, 6), ("gap_length", "face_thickness")
    ),
    "Hinge2": Preset(
        1, _given(8, 5, 0.6, 0, None, 0.2), (45, 36, 7), ("face_thickness",)
    ),
    "Hinge3": Preset(1, _given(0, 5, 0.2, 1.2, 0.8, 0.3), (45, 36, None), ("length_z",)),
    "Hinge4": Preset(1, _given(0, 7, 0.4, 0.8, 0.8, 0.3), (45, 36, 2.4), (), True),
    "Hinge5": Preset(1, _given(5, 7, 0.4, 0, 0.6, 0.3), (45, 36, 4)),
    "Hinge6": Preset(
        0, {"hinge_type": FLEXIBLE}, (None, None, None),
        ("gap_between_planes", "face_thickness", "layer_height"),
    ),
    # Table 1 recommends "> 5" segments: 7 is the fewest; Table 2's cell is printed as a fraction.
    "Recommended": Preset(
        1, _given(0, 7, 0.4, 0.8, 0.8, None), (45, 36, None), ("segmentations",), True
    ),
    "Hinge7": Preset(
        2, _given(None, 5, None, 0.4, 0.8, None), (30, 25, None),
        ("rotation_angle", "gap_length", "length_z"), False,
    ),
    "Hinge8": Preset(
        2, _given(None, 5, None, 0.8, 0.8, None), (20, 36, 5.6), ("rotation_angle", "gap_length"),
        False,
    ),
    "Hinge9": Preset(
        2, _given(None, 5, None, 0.6, 1.2, None), (50, 32, 6.6),
        ("rotation_angle", "gap_length", "face_thickness"), True,
    ),
    "RecommendedVertex": Preset(
        2, _given(0, 5, None, 0.6, 1.2, None), (50, 32, None), ("segmentations", "gap_length"),
        True,
    ),
    # Not of the paper: thick lines, for large tubes in half the layers (docs/hinges.md).
    "Coarse": Preset(
        0,
        {"gap_length": 0.55, "gap_between_planes": 0.9, "face_thickness": 1.8,
         "layer_height": 0.3, "nozzle_diameter": 0.6},
        (None, None, None),
    ),
}  # fmt: skip
