# SPDX-License-Identifier: LGPL-2.1-or-later
"""The section of the links that join two hinges."""

from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .parameters import HingeParameters


@dataclass(frozen=True)
class LinkSection:
    """Sizes (mm) of a link's section, from each of its two axes, outwards (away from the panels).

    ``web``: half-width of the web on the panels' side; ``clear``: barrel radius + clearance;
    ``inner``, ``outer``: the spine that joins the dogbones runs between them, outside ``clear``.
    """

    web: float
    clear: float
    inner: float
    outer: float


def link_section(parameters: "HingeParameters") -> LinkSection:
    """Section of every link.

    Narrow enough on the panels' side to keep the clearance from barrels at height 0, and with a
    spine that no knuckle of the panels can reach.
    """
    r, p, clear = parameters.radius, parameters.pitch, parameters.cut_back
    beside = sqrt(max((2 * r + parameters.gap_length) ** 2 - p * p, 0.0)) - clear
    narrow = max(p - parameters.nozzle_diameter, 0.0)
    inner = max(sqrt(max(clear**2 - narrow**2, 0.0)), r / 2)
    outer = clear + 2 * parameters.nozzle_diameter
    return LinkSection(min(0.6 * r, max(beside, 0.0)), clear, inner, outer)
