# SPDX-License-Identifier: LGPL-2.1-or-later
"""The processes that print a tube: one table, pure data (docs/slicing.md).

To add one, add a line: objects, panels, design files and docs/slicing.md read it. A process gives
the hinges' numbers, how the print lies and its material; all of them can be changed afterwards.
"""

from math import radians
from typing import NamedTuple

STANDOFFS, TIES, SOLUBLE, POWDER, RESIN = (
    "FDM, stand-offs", "FDM, ties", "FDM, soluble", "Powder", "Resin",
)  # fmt: skip
# What holds up what is laid over a gap.
BY_STANDOFFS, BY_TIES, BY_SUPPORT, BY_POWDER = "stand-offs", "ties", "support", "powder"


class Process(NamedTuple):
    """``what`` it is; ``gives``: {field of `HingeParameters`: value}, mm and radians.

    ``orientation``: Flat or OnEdge; ``material``: a name of `snap.materials`; ``held``: by what
    that which is laid over a gap; ``least``: the smallest clearance (mm) that it keeps open, 0
    where that is the layer; ``sources``: of these numbers.
    """

    what: str
    gives: dict
    orientation: str
    material: str
    held: str
    least: float
    sources: str

    @property
    def has_layers_of_lines(self) -> bool:
        """Whether it lays lines that sag, fuse and want support: filament."""
        return self.held != BY_POWDER and self.material != "Resin"


def _gives(
    gap: float, planes: float, thickness: float, layer: float, nozzle: float, cone: float = 55
) -> dict[str, float]:
    return {
        "gap_length": gap,
        "gap_between_planes": planes,
        "face_thickness": thickness,
        "layer_height": layer,
        "nozzle_diameter": nozzle,
        "cone_angle": radians(cone),
    }


_FILAMENT = _gives(0.4, 0.6, 1.2, 0.2, 0.4)
_PAPER = "the paper's tables 1 and 2; toolpaths, docs/slicing.md"
PROCESSES = {
    STANDOFFS: Process(
        "filament, one material, flat: ribs between the panels stay in the tube", _FILAMENT,
        "Flat", "PLA", BY_STANDOFFS, 0.0, _PAPER,
    ),
    TIES: Process(
        "filament, one material, on edge: ties are broken off", _FILAMENT,
        "OnEdge", "PLA", BY_TIES, 0.0, _PAPER,
    ),
    SOLUBLE: Process(
        "filament, flat: a second nozzle fills the gaps with soluble support", _FILAMENT,
        "Flat", "PLA", BY_SUPPORT, 0.0, _PAPER,
    ),
    POWDER: Process(
        "sintered or fused powder (SLS, MJF): no support, powder is blown out of the gaps",
        _gives(0.5, 0.7, 1.5, 0.1, 0.7), "Flat", "PA12", BY_POWDER, 0.3,
        "gaps of moving parts 0.5 to 1.0 mm, walls 0.7 mm: HLH, *SLS design tips*, 2019; slits of "
        "0.5 mm, layers of 0.08 mm: HP's rules for MJF, as Xometry and Tronix3D give them; 0.3 mm "
        "at the least, between walls below 3 mm: HP's rules, as amuse3d gives them",
    ),
    RESIN: Process(
        "cured resin (SLA, PolyJet), as the paper's unit of acrylic: support is washed off",
        _gives(0.5, 0.5, 1.5, 0.1, 0.6), "Flat", "Resin", BY_SUPPORT, 0.2,
        "gaps of moving parts 0.5 mm, free walls 0.6 mm: addema, *Guides SLA*; features of 0.6 mm: "
        "Objet, *Tips and tricks* (PolyJet); accuracy 0.05 to 0.15 mm to either side: UC Davis, "
        "*Polyjet system*",
    ),
}  # fmt: skip
