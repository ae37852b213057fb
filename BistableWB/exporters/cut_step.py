# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut panels as solids, one named shape a panel, lying on their sheets, with pilot holes."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..origami.patterns.cut_plan import carried
from ..origami.patterns.panel_solid import panel_boundary
from ..solids.shapes import shape_of
from . import step
from .bodies import Body
from .cut import plan_of

BETWEEN = 100.0  # mm between sheets


def write(
    bodies: Sequence[Any],
    path: Path,
    panel_thickness: float = 18.0,
    panel_hinge: str = "Piano",
    stock: Any = "2500x1250",
    edge_gap: float = 0.5,
) -> None:
    """Write the panels; options as of `cut_plan.CutWishes`."""
    plan = plan_of(bodies, panel_thickness, panel_hinge, stock, edge_gap)
    made = []
    for place in plan.placed:
        piece = plan.pieces[place.piece]
        down = 1j * place.sheet * (plan.stock[1] + BETWEEN)
        corners = (carried(np.array(piece.outline), place) - down).tolist()
        holes = [
            (complex(carried(np.array([p]), place)[0] - down), seen) for p, seen in piece.holes
        ]
        drilled = plan.wishes.panel_hinge.hole
        shape = shape_of(panel_boundary(corners, holes, drilled, panel_thickness))
        made.append(Body(piece.label, shape, (), None, piece.kind))
    step.write(made, path)
