# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stand-offs are made by (mm), and what cannot be: see `standoffs`."""

from dataclasses import dataclass
from math import floor, isfinite
from typing import TYPE_CHECKING

from ..errors import Refusal

if TYPE_CHECKING:
    from .parameters import HingeParameters

LINE_IN_NOZZLES = 1.125  # usual width of a line: 0.45 mm from a nozzle of 0.4 mm
_AIR = 0.2  # mm, a usual layer: prints come free of what lies that far below
MOST_SPACING = 10.0  # mm from rib to rib: nothing is further than 5 mm from one


@dataclass(frozen=True)
class StandOffs:
    """Ribs that hold up the panel above in the print: see `standoffs`.

    ``spacing`` of the ribs, both ways, and their ``width`` (mm); ``air_layers`` between them and
    what they hold; ``rim``: whether they run along the panels' edges too; ``pillars``: whether
    loose posts hold what no rib can (`propping`).
    """

    spacing: float = 8.0
    width: float = 0.45
    air_layers: int = 1
    rim: bool = True
    pillars: bool = True


def usual_air(layer_height: float, gap: float) -> int:
    """Layers of air that come free: 0.2 mm of them, as far as the ``gap`` (mm) leaves a rib."""
    layers = round(_AIR / layer_height) if layer_height > 0 else 1
    room = floor(gap / layer_height + 1e-6) - 1 if layer_height > 0 else 1
    return max(min(layers, room), 1)


def check_standoffs(p: "HingeParameters") -> None:
    """`Refusal` of stand-offs that a printer cannot make, or that hold nothing up."""
    given = p.standoffs
    if given is None:
        return
    if not (isfinite(given.spacing) and 2 * given.width < given.spacing <= MOST_SPACING):
        raise Refusal(
            "{StandOffSpacing} is {spacing:.4g} mm: a printer spans {most:.4g} mm from rib to rib; "
            "set {StandOffSpacing} between {least:.2g} and {most:.4g} mm.",
            parameter="StandOffSpacing",
            spacing=given.spacing,
            least=3 * given.width,
            most=MOST_SPACING,
        )
    if not (isfinite(given.width) and given.width >= p.nozzle_diameter):
        raise Refusal(
            "{StandOffWidth} is {width:.4g} mm, less than the nozzle: set it to {least:.4g} mm or "
            "more, or to 0 for one line.",
            parameter="StandOffWidth",
            width=given.width,
            least=p.nozzle_diameter,
        )
    gap = p.gap_between_planes / p.layer_height
    if not 1 <= given.air_layers <= gap - 1 + 1e-6:
        raise Refusal(
            "{AirLayers} is {air}: in a gap of {layers:.3g} layers set it between 1 and "
            "{most:.0f}, or {GapBetweenPlanes} to {gap:.4g} mm or more.",
            parameter="AirLayers",
            air=given.air_layers,
            layers=gap,
            most=max(floor(gap - 1 + 1e-6), 1),
            gap=(max(given.air_layers, 1) + 1) * p.layer_height,
        )
