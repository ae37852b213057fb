# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cut panel as a solid: its outline as thick as the sheet, with a pilot hole for every screw."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..hinges.bodies import walls
from ..hinges.drafting import Draft
from ..hinges.outward import Outward

if TYPE_CHECKING:
    from ..hinges.boundary import Boundary

DEEP = 2 / 3  # of the thickness: a pilot hole does not come through


def panel_boundary(
    outline: Sequence[complex],
    holes: Sequence[tuple[complex, bool]],
    diameter: float,
    thickness: float,
) -> "Boundary":
    """`Boundary` of a panel between the heights 0 and ``thickness`` (mm).

    ``outline``: corners x + i y, counter-clockwise; ``holes``: (place, whether it is drilled from
    above), of a ``diameter``, `DEEP` of the thickness deep.
    """
    draft = Draft()
    rings = [[draft.vertex((p.real, p.imag, z)) for p in outline] for z in (0.0, thickness)]
    walls(draft, rings[0], rings[1])
    for upwards, ring, face in ((False, rings[0], 0.0), (True, rings[1], thickness)):
        side = Outward(draft, face, upwards)
        rims = []
        for centre, above in holes:
            if above != upwards:
                continue
            low, high = (side.circle(centre, diameter / 2, z) for z in (-DEEP * thickness, 0.0))
            side.round_walls(low, high, hole=True)
            side.plane(True, [low])
            rims.append(high)
        side.plane(True, draft.ring(ring), *([rim] for rim in rims))
    return draft.boundary()
