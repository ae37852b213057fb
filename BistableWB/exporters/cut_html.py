# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut list as a page: what to buy, every sheet as a picture, every piece and hinge."""

from collections.abc import Iterable, Sequence
from html import escape
from pathlib import Path
from typing import Any

from ..origami.patterns.cut_plan import CutPlan
from .cut import plan_of
from .cut_csv import HINGES, PIECES, hinge_rows, piece_rows
from .svg import drawn

_STYLE = """
body { margin: 2rem auto; max-width: 1080px; padding: 0 1rem; color: #14283c;
       font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; }
svg { width: 100%; height: auto; margin: .5rem 0 1.5rem; }
svg path, svg circle { vector-effect: non-scaling-stroke; stroke-width: 1px !important; }
table { border-collapse: collapse; width: 100%; font-size: .85rem; }
th, td { text-align: left; padding: .15rem .6rem .15rem 0; border-bottom: 1px solid #d9e0e6; }
"""


def write(
    bodies: Sequence[Any],
    path: Path,
    panel_thickness: float = 18.0,
    panel_hinge: str = "Piano",
    stock: Any = "2500x1250",
    kerf: float = 0.0,
    edge_gap: float = 0.5,
) -> None:
    """Write the page; options as of `cut_plan.CutWishes`."""
    path.write_text(
        page_of(plan_of(bodies, panel_thickness, panel_hinge, stock, edge_gap, kerf)),
        encoding="utf-8",
    )


def page_of(plan: CutPlan) -> str:
    """The page as HTML."""
    name = escape(plan.name)
    pictures = [
        drawn([sheet], plan.name).split("\n", 1)[1]  # without the XML declaration
        for sheet in plan.sheets
    ]
    return "\n".join([
        "<!DOCTYPE html>", f'<html lang="en"><meta charset="utf-8"><title>{name}</title>',
        f"<style>{_STYLE}</style>", f"<h1>{name}: cut list</h1>",
        *(f"<p>{escape(line)}</p>" for line in facts(plan)),
        "<h2>Sheets</h2>", *pictures,
        "<h2>Pieces</h2>", _table(PIECES, piece_rows(plan)),
        "<h2>Hinges</h2>", _table(HINGES, hinge_rows(plan)), "</html>", "",
    ])  # fmt: skip


def facts(plan: CutPlan) -> list[str]:
    """Sentences on what to buy and what the tube will be like."""
    wishes, hinge, thick = plan.wishes, plan.wishes.panel_hinge, plan.tube.thick
    total = sum(one.length for one in plan.hinges) / 1000
    screws = 2 * sum(one.screws for one in plan.hinges)
    width, height = plan.stock
    edge = float(thick.unit.edge_length)
    return [
        f"{len(plan.pieces)} pieces {wishes.panel_thickness:g} mm thick on {plan.sheet_count} "
        f"sheets of {width:g} × {height:g} mm, {plan.utilisation:.0%} of which is used.",
        f"{len(plan.hinges)} pieces of {wishes.hinge.lower()} hinge, {total:.1f} m together"
        + (f", {screws} screws" if screws else "") + f": {hinge.what}.",
        f"Hinge axes lie {hinge.gap / 2:g} mm over the faces; panels of two layers are "
        f"{hinge.gap:g} mm apart, and so are the two contact panels between neighbouring units: "
        "put spacers of that thickness between them.",
        "Holes drawn red are on the face that is seen, blue dashed ones on the other. Labels: "
        "unit, then C contact, B border, P primary, S secondary, L slat of a double hinge; "
        "L/R left or right, U/L upper or lower.",
        "These hinges have no play, so there is no snap margin to give: rigid panels would not "
        f"pass at all. On the way panels and hinges give up to {plan.misfit:.1f} mm "
        f"({plan.misfit / edge:.1%} of the edge length); that is the snap.",
        f"Deployed, the tube is within {max(plan.tube.deviation(), 0.01):.2g} mm of its curve.",
    ]  # fmt: skip


def _table(head: Iterable[str], rows: Iterable[Iterable[Any]]) -> str:
    lines = ["<tr>" + "".join(f"<th>{escape(cell)}</th>" for cell in head) + "</tr>"]
    lines += [
        "<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>" for row in rows
    ]
    return "<table>" + "\n".join(lines) + "</table>"
