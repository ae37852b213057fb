# SPDX-License-Identifier: LGPL-2.1-or-later
"""DXF (R12) crease patterns: the sheets of the SVG as polylines and texts; 1 drawing unit = 1 mm.

Layers CUT, MOUNTAIN (dash-dotted), VALLEY (dashed), LABEL, SHEET. R12 is what every cutter reads.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..origami.patterns.sheets import lay_out
from .svg import BETWEEN, chosen
from .thin import thin_models

if TYPE_CHECKING:
    from ..origami.patterns.sheets import Line, Sheet, Text

# AutoCAD colour number and line type of every layer.
_LAYERS = {
    "cut": (7, "CONTINUOUS"),
    "mountain": (1, "DASHDOT"),
    "valley": (5, "DASHED"),
    "label": (8, "CONTINUOUS"),
    "sheet": (9, "CONTINUOUS"),
    "drill": (1, "CONTINUOUS"),  # holes of the face that is seen
    "below": (5, "DASHED"),  # and of the other one
}
# Line type: description and the lengths (mm) of its dashes, gaps negative.
_LINE_TYPES = {
    "CONTINUOUS": ("Solid line", ()),
    "DASHDOT": ("__ . __ .", (4.0, -1.0, 0.6, -1.0)),
    "DASHED": ("__ __ __", (2.0, -1.2)),
}


def write(
    bodies: Sequence[Any],
    path: Path,
    sheet: str | None = None,
    tabs: bool = False,
    tab_depth: float = 6.0,
    page: Any = None,
) -> None:
    """Write the nets of ``bodies``; options as for SVG (`svg.write`)."""
    models = [(m.name, m.tube) for m in thin_models(bodies)]
    sheets = chosen(lay_out(models, sheet, tab_depth if tabs else 0.0), page)
    path.write_text(drawn(sheets), encoding="ascii", newline="\r\n")


def drawn(sheets: "Sequence[Sheet]") -> str:
    """Sheets, one below the other, as the text of a DXF."""
    low = -sum(one.size[1] + BETWEEN for one in sheets[1:])
    layers = list({layer: None for one in sheets for layer in one.layers()})
    extent = complex(0, low), complex(*sheets[0].size)
    groups = [(999, "Bistable Workbench; millimetres"), *_header(*extent), *_tables(layers)]
    groups += [(0, "SECTION"), (2, "ENTITIES")]
    for i, one in enumerate(sheets):
        shift = -1j * i * (one.size[1] + BETWEEN)
        for line in one.lines:
            groups += _polyline(line, shift)
        for text in one.texts:
            groups += _text(text, shift)
        for hole in one.circles:
            point = _point(hole.centre + shift)
            groups += [(0, "CIRCLE"), (8, hole.layer.upper()), *point, (40, float(hole.radius))]
    groups += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:>3}\n{_value(value)}\n" for code, value in groups)


def _value(value: float | str) -> str:
    return f"{value:.6f}" if isinstance(value, float) else str(value)


def _header(low: complex, high: complex) -> list[tuple[int, Any]]:
    return [
        (0, "SECTION"), (2, "HEADER"),
        (9, "$ACADVER"), (1, "AC1009"),
        (9, "$EXTMIN"), *_point(low), (9, "$EXTMAX"), *_point(high),
        (9, "$LIMMIN"), *_point(low)[:2], (9, "$LIMMAX"), *_point(high)[:2],
        (0, "ENDSEC"),
    ]  # fmt: skip


def _tables(layers: Sequence[str]) -> list[tuple[int, Any]]:
    groups: list[tuple[int, Any]] = [(0, "SECTION"), (2, "TABLES")]
    groups += [(0, "TABLE"), (2, "LTYPE"), (70, len(_LINE_TYPES))]
    for name, (description, dashes) in _LINE_TYPES.items():
        groups += [(0, "LTYPE"), (2, name), (70, 0), (3, description), (72, 65)]
        groups += [(73, len(dashes)), (40, float(np.abs(dashes).sum())), *((49, d) for d in dashes)]
    groups += [(0, "ENDTAB"), (0, "TABLE"), (2, "LAYER"), (70, len(layers) + 1)]
    for name, (colour, line_type) in {
        "0": (7, "CONTINUOUS"),
        **{k: _LAYERS[k] for k in layers},
    }.items():
        groups += [(0, "LAYER"), (2, name.upper()), (70, 0), (62, colour), (6, line_type)]
    groups += [(0, "ENDTAB"), (0, "TABLE"), (2, "STYLE"), (70, 1), (0, "STYLE"), (2, "STANDARD")]
    groups += [(70, 0), (40, 0.0), (41, 1.0), (50, 0.0), (71, 0), (42, 2.5), (3, "txt"), (4, "")]
    return [*groups, (0, "ENDTAB"), (0, "ENDSEC")]


def _point(z: complex) -> list[tuple[int, float]]:
    return [(10, float(z.real)), (20, float(z.imag)), (30, 0.0)]


def _polyline(line: "Line", shift: complex) -> list[tuple[int, Any]]:
    layer = line.layer.upper()
    groups: list[tuple[int, Any]] = [(0, "POLYLINE"), (8, layer)]
    if line.look:
        colour, line_type = _LAYERS[line.look]
        groups += [(6, line_type), (62, colour)]
    groups += [(66, 1), *_point(0j), (70, int(line.closed))]
    for z in (line.points + shift).tolist():
        groups += [(0, "VERTEX"), (8, layer), *_point(z)]
    return [*groups, (0, "SEQEND"), (8, layer)]


def _text(text: "Text", shift: complex) -> list[tuple[int, Any]]:
    """TEXT: 72 = 1 (centred) or 0 (left), 73 = 2 (middle), with alignment point 11."""
    z = text.position + shift
    plain = text.text.encode("ascii", "replace").decode()
    return [
        (0, "TEXT"), (8, text.layer.upper()), *_point(z), (40, float(text.size)), (1, plain),
        (50, float(np.degrees(text.angle))), (72, int(text.anchor == "middle")),
        (11, float(z.real)), (21, float(z.imag)), (31, 0.0), (73, 2),
    ]  # fmt: skip
