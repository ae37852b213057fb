# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut panels nested on sheets as DXF: layers cut, label, drill, below (of the other face)."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .cut import plan_of
from .dxf import drawn
from .svg import chosen


def write(
    bodies: Sequence[Any],
    path: Path,
    panel_thickness: float = 18.0,
    panel_hinge: str = "Piano",
    stock: Any = "2500x1250",
    kerf: float = 0.0,
    edge_gap: float = 0.5,
    page: Any = None,
) -> None:
    """Write the sheets; options as of `cut_plan.CutWishes`; ``page``: only this sheet (from 1)."""
    plan = plan_of(bodies, panel_thickness, panel_hinge, stock, edge_gap, kerf)
    path.write_text(drawn(chosen(plan.sheets, page)), encoding="ascii", newline="\r\n")
