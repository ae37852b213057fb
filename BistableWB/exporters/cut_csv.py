# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut list as a table: pieces with sizes and places, then hinges to cut."""

import csv
import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ..origami.patterns.cut_plan import CutPlan, carried
from .cut import plan_of

PIECES = (
    "piece", "unit", "panel", "length_mm", "width_mm", "area_mm2", "sheet", "x_mm", "y_mm",
    "turn_deg",
)  # fmt: skip
HINGES = "hinge", "unit", "crease", "length_mm", "strip_mm", "screws"


def write(
    bodies: Sequence[Any],
    path: Path,
    panel_thickness: float = 18.0,
    panel_hinge: str = "Piano",
    stock: Any = "2500x1250",
    kerf: float = 0.0,
    edge_gap: float = 0.5,
) -> None:
    """Write the list; options as of `cut_plan.CutWishes`."""
    plan = plan_of(bodies, panel_thickness, panel_hinge, stock, edge_gap, kerf)
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\r\n")
    table.writerow(PIECES)
    table.writerows(piece_rows(plan))
    table.writerow(())
    table.writerow(HINGES)
    table.writerows(hinge_rows(plan))
    path.write_text(text.getvalue(), encoding="utf-8", newline="")


def piece_rows(plan: CutPlan) -> list[tuple]:
    """A row of `PIECES` for every piece, in the order of their units."""
    rows = []
    for place in plan.placed:
        piece = plan.pieces[place.piece]
        laid = carried(np.array(piece.outline), place)
        sizes = sorted((np.ptp(laid.real), np.ptp(laid.imag)), reverse=True)
        rows.append((
            piece.label, piece.unit + 1, piece.name, *(f"{size:.1f}" for size in sizes),
            f"{piece.area:.0f}", place.sheet + 1, f"{laid.real.min():.1f}",
            f"{laid.imag.min():.1f}", f"{np.degrees(np.angle(place.turn)):.2f}",
        ))  # fmt: skip
    return rows


def hinge_rows(plan: CutPlan) -> list[tuple]:
    """A row of `HINGES` for every hinge to cut."""
    return [
        (plan.wishes.hinge, hinge.unit + 1, hinge.crease, f"{hinge.length:.1f}",
         f"{hinge.strip:.1f}" if hinge.strip else "", 2 * hinge.screws)
        for hinge in plan.hinges
    ]  # fmt: skip
