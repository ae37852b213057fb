# SPDX-License-Identifier: LGPL-2.1-or-later
"""SVG crease patterns: nets of all units on sheets, to scale in millimetres.

Layers (groups that Inkscape and cutters' programs show as such): cut, mountain, valley, label,
sheet. Mountains are dash-dotted and red, valleys dashed and blue, seen from the tube's outside.
"""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import escape

import numpy as np
from numpy.typing import NDArray

from ..colours import PANELS
from ..origami.errors import Refusal
from ..origami.patterns.sheets import lay_out
from ..origami.units.creases import kind_of
from .thin import thin_models

if TYPE_CHECKING:
    from ..origami.patterns.sheets import Circle, Line, Sheet, Text

BETWEEN = 10.0  # mm between sheets
_STYLES = {
    "cut": "fill:none;stroke:#14283c;stroke-width:0.3;stroke-linejoin:round",
    "mountain": "fill:none;stroke:#c8102e;stroke-width:0.25;stroke-dasharray:4 1 0.6 1",
    "valley": "fill:none;stroke:#1f5f99;stroke-width:0.25;stroke-dasharray:2 1.2",
    "label": "fill:#6b7a89;stroke:none",
    "sheet": "fill:none;stroke:#9aa7b4;stroke-width:0.2",
    "drill": "fill:none;stroke:#c8102e;stroke-width:0.3",
    "below": "fill:none;stroke:#1f5f99;stroke-width:0.3;stroke-dasharray:1 0.6",
}
_FONT = "font-family:'DejaVu Sans','Liberation Sans',Arial,sans-serif"


def write(
    bodies: Sequence[Any],
    path: Path,
    sheet: str | None = None,
    tabs: bool = False,
    tab_depth: float = 6.0,
    page: Any = None,
    colours: bool = False,
) -> None:
    """Write the nets of ``bodies``.

    ``sheet``: "A4" … "A0", "600x400" (mm), or the smallest DIN sheet; ``tabs``: glue tabs, of
    ``tab_depth`` mm; ``page``: only this sheet (from 1), else all, one below the other;
    ``colours``: fill the panels by their kind (for paper: some laser programs engrave fills).
    """
    models = [(m.name, m.tube) for m in thin_models(bodies)]
    sheets = chosen(lay_out(models, sheet, tab_depth if tabs else 0.0), page)
    title = ", ".join(name for name, _ in models)
    path.write_text(drawn(sheets, title, colours), encoding="utf-8")


def drawn(sheets: "Sequence[Sheet]", title: str, colours: bool = False) -> str:
    """Sheets, one below the other, as the text of an SVG."""
    width = sheets[0].size[0]
    height = sum(s.size[1] for s in sheets) + BETWEEN * (len(sheets) - 1)
    parts = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        f'width="{width:g}mm" height="{height:g}mm" viewBox="0 0 {width:g} {height:g}">',
        f"<title>{escape(title)}</title>",
    ]
    if colours:
        parts.append('<g id="panel" inkscape:groupmode="layer" inkscape:label="panel">')
        for i, one in enumerate(sheets):
            parts += _panels(one, one.size[1] + i * (one.size[1] + BETWEEN))
        parts.append("</g>")
    layers = {layer: None for one in sheets for layer in one.layers()}
    for layer in reversed(list(layers)):
        parts.append(
            f'<g id="{layer}" inkscape:groupmode="layer" inkscape:label="{layer}" '
            f'style="{_STYLES[layer]}">'
        )
        for i, one in enumerate(sheets):
            base = one.size[1] + i * (one.size[1] + BETWEEN)
            parts += [_path(line, base) for line in one.lines if line.layer == layer]
            parts += [_text(text, base) for text in one.texts if text.layer == layer]
            parts += [_circle(hole, base) for hole in one.circles if hole.layer == layer]
        parts.append("</g>")
    return "\n".join([*parts, "</svg>"]) + "\n"


def chosen(sheets: "Sequence[Sheet]", page: Any) -> "Any":
    """All sheets, or the one with number ``page`` (from 1)."""
    if page is None:
        return sheets
    if not 1 <= int(page) <= len(sheets):
        raise Refusal(
            "There is no sheet {page}: choose page 1 to {count}, or none.",
            page=page,
            count=len(sheets),
        )
    return [sheets[int(page) - 1]]


def _path(line: "Line", base: float) -> str:
    look = f' style="{_STYLES[line.look]}"' if line.look else ""
    return f'<path d="M {_points(line.points, base)}{" Z" if line.closed else ""}"{look}/>'


def _circle(hole: "Circle", base: float) -> str:
    x, y = hole.centre.real, base - hole.centre.imag
    return f'<circle cx="{x:.4f}" cy="{y:.4f}" r="{hole.radius:.4f}"/>'


def _panels(sheet: Any, base: float) -> Iterator[Any]:
    for net in sheet.nets:
        for name, polygon in net.polygons.items():
            points = _points(polygon, base)
            yield f'<path d="M {points} Z" fill="{PANELS[kind_of(name)]}" fill-opacity="0.35"/>'


def _points(points: NDArray, base: float) -> str:
    return " ".join(f"{p.real:.4f},{base - p.imag:.4f}" for p in points.tolist())


def _text(text: "Text", base: float) -> str:
    x, y = text.position.real, base - text.position.imag
    turn = f' transform="rotate({-np.degrees(text.angle):.3f} {x:.3f} {y:.3f})"'
    colour = ' style="fill:#6b7a89;stroke:none"' if text.layer == "sheet" else ""
    # capitals are 0.72 of the font's size; the baseline lies half a capital below the middle
    return (
        f'<g{colour}><text x="{x:.3f}" y="{y + text.size / 2:.3f}" '
        f'font-size="{text.size / 0.72:.3f}" style="{_FONT};text-anchor:{text.anchor}"'
        f"{turn if abs(text.angle) > 1e-6 else ''}>{escape(text.text)}</text></g>"
    )
