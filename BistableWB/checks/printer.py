# SPDX-License-Identifier: LGPL-2.1-or-later
"""The printer that a print is checked for."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from ..origami.errors import WARNING, Finding, phrase
from ..origami.hinges.bed import Bed

if TYPE_CHECKING:
    from ..origami.hinges.parameters import HingeParameters

if TYPE_CHECKING:
    import FreeCAD as App


@dataclass(frozen=True)
class Printer:
    """What a printer can do, mm and degrees.

    ``resolution``: gaps in a layer that slicers close (twice PrusaSlicer's closing radius);
    ``steepest``: angle from the vertical up to which a face may hang over its layer below;
    ``bridge``: how far a layer spans from hold to hold, and how wide it may droop; ``clearance``:
    of the tightest hinge that turned on its calibration plate (0: not known).
    """

    layer_height: float = 0.2
    nozzle_diameter: float = 0.4
    bed: Bed = field(default_factory=Bed)
    resolution: float = 0.1
    steepest: float = 60.0
    bridge: float = 5.0
    clearance: float = 0.0


def printer_of(
    obj: "App.DocumentObject", bed: Bed | None = None, clearance: float = 0.0
) -> Printer:
    """`Printer` by the object's own properties; ``bed`` where it has none, and its clearance."""
    own = getattr(obj, "Bed", None)
    room = Bed(*own) if own and any(own) else bed or Bed()
    return Printer(obj.LayerHeight.Value, obj.NozzleDiameter.Value, room, clearance=clearance)


def tighter_than_known(parameters: "HingeParameters", printer: Printer) -> Any:
    """`Finding`s where hinges are tighter than what turned on the printer's calibration plate."""
    known = printer.clearance
    if not (known and parameters.has_knuckles) or parameters.gap_length >= known - 1e-6:
        return []
    return [
        Finding(
            severity=WARNING,
            code="clearance",
            number=parameters.gap_length,
            limit=known,
            message=phrase(
                "{GapLength} is {gap:.3g} mm, and on this printer's calibration plate nothing "
                "tighter than {known:.3g} mm turned.",
                gap=parameters.gap_length,
                known=known,
            ),
            cure=phrase("make {GapLength} {known:.3g} mm or more", known=known).setting(
                GapLength=known
            ),
        )
    ]
