# SPDX-License-Identifier: LGPL-2.1-or-later
"""Will it snap, will it stand: all of it for one deployed tube, asked once (hinges.md 4)."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..errors import Refusal
from ..hinges.bodies import printed_layouts
from ..hinges.parameters import HingeParameters
from ..progress import NOBODY, Progress
from ..thick.thick_tube import ThickTube, block_lines
from .bearing import holds_the_ends
from .flexing import flexible_forces
from .forces import FLAT, SnapForces, snap_forces
from .load import START, Load, carried
from .materials import TPU, Material, material
from .slop import Slop, no_slop, tube_slop

if TYPE_CHECKING:
    from ..thick.linkage import ThickUnit

_SHARE_OF_FORCES = 0.7  # of the time


@dataclass(frozen=True)
class Conditions:
    """What a tube is made of and how it is held.

    ``gravity``: its direction in the frame of the print, first block at rest; ``fixed``: "Start" or
    "Both"; ``orientation`` of the print: "Flat" or "OnEdge".
    """

    material: Material
    orientation: str = FLAT
    gravity: tuple[float, float, float] = (0.0, 0.0, -1.0)
    fixed: str = START


@dataclass(frozen=True)
class Study:
    """How a tube snaps, wobbles and stands.

    ``units``: `SnapForces` of each; ``slop`` and ``load`` of the whole tube; ``length``: mm from
    the first block to the last; ``holds``: whether automatic preload is for such hinges
    (`bearing.holds_the_ends`).
    """

    units: list[SnapForces]
    slop: Slop
    load: Load
    length: float
    holds: bool = True

    @property
    def flexible(self) -> bool:
        """Whether the hinges are strips, which have no play."""
        return not self.slop.ends.any()

    @property
    def order(self) -> list[int]:
        """Units, counted from 0, in the order in which they open: the weakest first."""
        return sorted(range(len(self.units)), key=lambda k: self.units[k].torque)

    @property
    def slop_share(self) -> float:
        """Free motion of the free end by the tube's length."""
        return self.slop.end / self.length


def study(tube: ThickTube, parameters: HingeParameters, conditions: Conditions,
          progress: Progress = NOBODY) -> Study:  # fmt: skip
    """The `Study` of a compensated `ThickTube`; flexible hinges are strips of TPU."""
    thick, left = tube.thick, tube.tube.incoming_left
    layouts = layouts_of(tube, parameters)
    parts = progress.part(0, _SHARE_OF_FORCES), progress.part(_SHARE_OF_FORCES, 1)
    if parameters.has_knuckles:
        units = snap_forces(thick, layouts, parameters, conditions.material,
                            conditions.orientation, parts[0])  # fmt: skip
        slop = tube_slop(thick, layouts, parameters, left, parts[1])
    else:
        units = _flexible(thick, layouts, parameters, parts[0])
        slop = no_slop(thick, left)
    load = carried(thick, layouts, parameters, conditions.material.density, units,
                   conditions.gravity, conditions.fixed, left)  # fmt: skip
    return Study(units, slop, load, length_of(tube), holds_the_ends(parameters))


def refuse_flexible(parameters: HingeParameters) -> None:
    """`Refusal` to aim at a force with hinges without cones."""
    if not parameters.has_knuckles:
        raise Refusal(
            "Flexible hinges have no cones: their force cannot be aimed at",
            cure="set {HingeType} to Rotational", parameter="HingeType",
        )  # fmt: skip


def _flexible(
    thick: "ThickUnit", layouts: list, parameters: HingeParameters, progress: Progress
) -> list[SnapForces]:
    """`SnapForces` of every unit with strips of TPU; units alike are computed once."""
    known: dict[bytes, SnapForces] = {}
    found, soft = [], material(TPU)
    for k, layout in enumerate(layouts):
        key = np.round(thick[k : k + 1]._flat, 4).tobytes()
        if key not in known:
            own = progress.part(k / len(layouts), (k + 1) / len(layouts))
            known[key] = flexible_forces(thick[k : k + 1], layout, parameters, soft,
                                         own.named("Energy of the units"))  # fmt: skip
        found.append(known[key])
    return found


def layouts_of(tube: ThickTube, parameters: HingeParameters) -> list:
    """`unit_layout.Layout` of every unit, with the stand-offs that weigh on it."""
    return printed_layouts(tube.thick, parameters, tube.tube.incoming_left)


def length_of(tube: ThickTube) -> float:
    """Length of the deployed tube's line of blocks, mm."""
    middles = block_lines(tube.thick, tube.tube.incoming_left).mean(1)
    return float(np.linalg.norm(np.diff(middles, axis=0), axis=1).sum())
