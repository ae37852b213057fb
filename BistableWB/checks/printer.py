# SPDX-License-Identifier: LGPL-2.1-or-later
"""The printer that a print is checked for."""

from dataclasses import dataclass, field

from .bed import Bed


@dataclass(frozen=True)
class Printer:
    """What a printer can do, mm and degrees.

    ``resolution``: gaps in a layer that slicers close (twice PrusaSlicer's closing radius);
    ``steepest``: angle from the vertical up to which a face may hang over its layer below;
    ``bridge``: how far a layer spans from hold to hold, and how wide it may droop.
    """

    layer_height: float = 0.2
    nozzle_diameter: float = 0.4
    bed: Bed = field(default_factory=Bed)
    resolution: float = 0.1
    steepest: float = 60.0
    bridge: float = 5.0
