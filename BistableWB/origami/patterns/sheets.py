# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sheets to cut and score: the nets of tubes, packed to scale, with labels, legend and scale bar.

Coordinates are millimetres from the sheet's lower left corner, as complex numbers x + i y.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from ..units.creases import kind_of
from .nets import MOUNTAIN, VALLEY, unit_nets
from .surface import OUTWARD

if TYPE_CHECKING:
    from ..units.tube import Tube
    from .nets import Net, Seam

CUT, LABEL, SHEET = "cut", "label", "sheet"
LAYERS = (CUT, MOUNTAIN, VALLEY, LABEL, SHEET)
DIN = {"A4": (297, 210), "A3": (420, 297), "A2": (594, 420), "A1": (841, 594), "A0": (1189, 841)}
SMALLEST = (170, 60)  # mm: the legend's width, and something above it
MARGIN, GAP, FOOTER = 8.0, 5.0, 12.0
SCALE_BAR = 50.0
_SMALLEST_TEXT = 1.1  # mm
_TEXT_WIDTH = 0.85  # of its size, per letter


class Line(NamedTuple):
    """A line through ``points`` on a layer; ``look``: the layer that it looks like, if another."""

    layer: str
    points: np.ndarray
    closed: bool = False
    look: str = ""


class Text(NamedTuple):
    """Text on a layer at ``angle`` (radians), its capitals ``size`` mm high.

    ``position``: its middle, or with ``anchor`` "start" the middle of its left side.
    """

    layer: str
    text: str
    position: complex
    angle: float
    size: float
    anchor: str = "middle"


class Circle(NamedTuple):
    """A hole to drill, on a layer of its own."""

    layer: str
    centre: complex
    radius: float


class Sheet(NamedTuple):
    """One sheet: ``size`` (width, height), `Line`, `Text`, `Net` and `Circle` lists."""

    size: tuple
    lines: list
    texts: list
    nets: list
    circles: Sequence[Circle] = ()

    def layers(self) -> tuple:
        """Layers that it has, with those of its holes."""
        return (*LAYERS, *sorted({circle.layer for circle in self.circles}))


class _UnitNets(NamedTuple):
    """Nets of unit ``k`` (from 0) of a tube of ``count`` units, and what its contacts are."""

    k: int
    count: int  # type: ignore[assignment]  # not how often a value occurs
    incoming: str
    nets: list


def lay_out(
    tubes: "Sequence[tuple[str, Tube]]", sheet: str | None = None, tab_depth: float = 0.0
) -> list:
    """`Sheet` list of all units of ``tubes``, a list of (name, `tube.Tube`).

    ``sheet``: "A4" … "A0" (landscape), "600x400", (width, height) in mm, or None for the smallest
    DIN sheet that holds every unit in one piece; ``tab_depth`` in mm, 0: no glue tabs.
    ValueError for an unknown sheet or one too small for a panel.
    """
    if not (np.isfinite(tab_depth) and tab_depth >= 0):
        raise Refusal(
            "Tabs are {tab_depth:.4g} mm deep: give 0 for none, or 4 to 10 mm.",
            tab_depth=tab_depth,
        )
    size, made = _nets_on(sheet, tubes, tab_depth)
    pieces = []
    for unit in made:
        for net in unit.nets:
            turned = _turned(net, _area(size))
            pieces.append((turned, _labels(turned, unit)))
    title = ", ".join(name for name, _ in tubes)
    pages = _packed(pieces, _area(size))
    return [_sheet(size, page, title, i + 1, len(pages)) for i, page in enumerate(pages)]


def sheet_size(sheet: Any) -> tuple:
    """(width, height) in mm of "A4", "600x400" or a pair; ValueError for anything else."""
    if isinstance(sheet, str) and sheet.upper() in DIN:
        return DIN[sheet.upper()]
    try:
        pair = sheet.lower().split("x") if isinstance(sheet, str) else sheet
        width, height = (float(v) for v in pair)
    except (TypeError, ValueError, AttributeError):
        width = height = np.nan
    if not (SMALLEST[0] <= width < np.inf and SMALLEST[1] <= height < np.inf):
        raise Refusal(
            "Sheet {sheet!r} is unknown: use {names}, or width x height in mm such as 600x400, at "
            "least {width} x {height}.",
            sheet=sheet,
            names=", ".join(DIN),
            width=SMALLEST[0],
            height=SMALLEST[1],
        )
    return width, height


def _nets_on(
    sheet: str | None, tubes: "Sequence[tuple[str, Tube]]", tab_depth: float
) -> tuple[tuple[int, int], list[_UnitNets]]:
    """Size of the sheets, and `_UnitNets` of all units."""
    if sheet is not None:
        size = sheet_size(sheet)
        return size, _all_nets(tubes, size, tab_depth)
    best: Any = None
    refusal: Any = None
    for size in DIN.values():
        try:
            made = _all_nets(tubes, size, tab_depth)
        except Refusal as error:
            refusal = error
            continue
        pieces = sum(len(unit.nets) for unit in made)
        if best is None or pieces < best[0]:
            best = pieces, size, made
        if pieces == len(made):
            break
    if best is None:
        raise refusal
    return best[1:]


def _all_nets(
    tubes: "Sequence[tuple[str, Tube]]", size: Sequence[int], tab_depth: float
) -> list[_UnitNets]:
    area = _area(size)

    def fits(points: NDArray) -> bool:
        return _turn_into(points, area) is not None

    made = []
    for _, tube in tubes:
        for k, left in enumerate(tube.incoming_left):
            try:
                nets = unit_nets(tube.unit[k], fits, tab_depth)
            except Refusal as error:
                raise Refusal(
                    "Unit {unit}: {refused} It is {width:g} x {height:g} mm.",
                    unit=k + 1,
                    refused=error,
                    width=size[0],
                    height=size[1],
                ) from error
            made.append(_UnitNets(k, len(tube), "left" if left else "right", nets))
    return made


def _area(size: Sequence[int]) -> tuple[float, float]:
    """Width and height that nets may take."""
    return size[0] - 2 * MARGIN, size[1] - 2 * MARGIN - FOOTER


def _turn_into(points: NDArray, area: Sequence[float], first: Sequence[complex] = ()) -> Any:
    """Complex turn with which points fit ``area``; of those, ``first`` ones are preferred."""
    for turn in (*first, *np.exp(1j * np.radians(np.arange(0, 180, 3)))):
        spun = points * turn
        if np.ptp(spun.real) <= area[0] and np.ptp(spun.imag) <= area[1]:
            return turn
    return None


def _turned(net: "Net", area: Sequence[float]) -> "Net":
    """The net with its strip across the sheet where that fits, its lower left corner at 0."""
    up = _up(net)
    points = np.concatenate(net.shapes)
    turn = _turn_into(points, area, (1j / up, 1 / up))
    if (turn * up).imag < -1e-9:
        turn = -turn
    spun = points * turn
    return net.moved(turn, -complex(spun.real.min(), spun.imag.min()))


def _up(net: "Net") -> complex:
    """Direction of the mean leg of a net, lower to upper; along some edge if it has no leg."""
    for name, polygon in net.polygons.items():
        if kind_of(name) in ("border", "contact"):
            ends = [1 if v.endswith("upper") else -1 for v in OUTWARD[name]]
            leg = (ends * polygon).sum()
            return leg / abs(leg)
    side = polygon[1] - polygon[0]
    return 1j * side / abs(side)


def _labels(net: "Net", unit: _UnitNets) -> list[Text]:
    """`Text` list of a net: names in the panels, numbers along the seams."""
    along = _up(net) / 1j
    first = next(n for n in ("border_left", "border_right", *net.polygons) if n in net.polygons)
    texts = []
    for name, polygon in net.polygons.items():
        text, largest = _panel_label(name, unit)
        if name == first:
            text, largest = f"unit {unit.k + 1} {text}".rstrip(), 4.0
        if text:
            texts.append(fitted(text, polygon, along, largest))
    texts += [_seam_label(seam, net.polygons[seam.panel]) for seam in net.seams]
    return [t for t in texts if t.size >= _SMALLEST_TEXT]


def _panel_label(name: str, unit: _UnitNets) -> tuple[str, float]:
    """Text of a panel's label and its largest size (mm)."""
    kind = kind_of(name)
    if kind != "contact":
        return ("" if kind == "border" else kind), 2.0
    if name.endswith(unit.incoming):
        return ("start" if unit.k == 0 else f"to unit {unit.k}"), 3.0
    return ("end" if unit.k == unit.count - 1 else f"to unit {unit.k + 2}"), 3.0


def fitted(text: str, polygon: NDArray, along: complex, largest: float) -> Text:
    """Text in the middle of a polygon, along a direction, as large as there is room for."""
    middle, reach = _middle(polygon)
    room = 0.75 * _chord(polygon, middle, along) / (_TEXT_WIDTH * len(text))
    share = 0.22 if len(polygon) == 3 else 0.4  # leave the edges to the seams' numbers
    return Text(LABEL, text, middle, float(np.angle(along)), min(largest, share * reach, room))


def _chord(polygon: NDArray, middle: complex, along: complex) -> float:
    """Length of the line through ``middle`` inside a convex polygon."""
    offset = (polygon - middle) / along
    ahead = np.roll(offset, -1)
    crossing = (offset.imag > 0) != (ahead.imag > 0)
    a, b = offset[crossing], ahead[crossing]
    return float(np.ptp(a.real - a.imag * (b.real - a.real) / (b.imag - a.imag)))


def _middle(polygon: NDArray) -> tuple[complex, float]:
    """The middle of the largest circle in a triangle, or of a quadrilateral; and its radius."""
    if len(polygon) == 3:
        weights = np.abs(np.roll(polygon, -1) - np.roll(polygon, -2))
        middle = (weights * polygon).sum() / weights.sum()
    else:
        middle = polygon.mean()
    along = np.roll(polygon, -1) - polygon
    heights = ((middle - polygon) * along.conj() / np.abs(along)).imag
    return complex(middle), float(heights.min())


def _seam_label(seam: "Seam", polygon: NDArray) -> Text:
    along = (seam.end - seam.start) / abs(seam.end - seam.start)
    _, reach = _middle(polygon)
    size = min(2.2, 0.45 * reach, 0.3 * abs(seam.end - seam.start))
    angle = np.angle(along)
    if not -np.pi / 2 + 1e-6 < angle <= np.pi / 2 + 1e-6:
        angle += np.pi
    position = (seam.start + seam.end) / 2 + 1j * along * 0.85 * size
    number = f"{seam.number}." if seam.number in (6, 9) else str(seam.number)  # 6 is no 9
    return Text(LABEL, number, complex(position), float(angle), float(size))


def _packed(
    pieces: "Sequence[tuple[Net, Sequence[Text]]]", area: Sequence[float]
) -> "list[list[tuple[Net, list[Any], complex]]]":
    """Pages of [(net, texts, shift)]: rows from the top left, each as high as its highest net."""
    pages: Any
    pages, row_top, x, row_height = [[]], area[1], 0.0, 0.0
    for net, texts in pieces:
        points = np.concatenate(net.shapes)
        width, height = np.ptp(points.real), np.ptp(points.imag)
        if x > 0 and x + width > area[0] + 1e-9:
            row_top, x, row_height = row_top - row_height - GAP, 0.0, 0.0
        if row_top - height < -1e-9:
            pages.append([])
            row_top, x, row_height = area[1], 0.0, 0.0
        shift = complex(x + MARGIN, row_top - height + MARGIN + FOOTER)
        pages[-1].append((net, texts, shift))
        x += width + GAP
        row_height = max(row_height, height)
    return pages


def _sheet(
    size: Any,
    page: "Sequence[tuple[Net, Sequence[Text], complex]]",
    title: str,
    number: int,
    count: int,
) -> Sheet:
    lines, texts, nets = [], [], []
    for net, labels, shift in page:
        placed = net.moved(1, shift)
        nets.append(placed)
        lines.append(Line(CUT, placed.outline, True))
        folds = [*placed.folds, *((s.start, s.end, s.fold) for s in placed.seams if s.tab)]
        lines += [Line(fold, np.array([a, b])) for a, b, fold in folds]
        texts += [t._replace(position=t.position + shift) for t in labels]
    more_lines, more_texts = _footer(size, title, number, count)
    return Sheet(size, lines + more_lines, texts + more_texts, nets)


def _footer(
    size: Sequence[int], title: str, number: int, count: int
) -> tuple[list[Line], list[Text]]:
    """Frame of the sheet, title, legend and scale bar."""
    width, height = size
    corners = np.array([0, width, width + 1j * height, 1j * height])
    base = MARGIN + 2.0
    lines, texts = [Line(SHEET, corners, True)], []

    def left_aligned(text: str, x: float, size_mm: float) -> None:
        texts.append(Text(SHEET, text, complex(x, base), 0.0, size_mm, "start"))

    x = width - MARGIN - SCALE_BAR
    lines.append(Line(SHEET, np.array([x + 1j * base, x + SCALE_BAR + 1j * base])))
    for end in (x, x + SCALE_BAR):
        lines.append(Line(SHEET, np.array([end + 1j * (base - 1), end + 1j * (base + 1)])))
    texts.append(Text(SHEET, f"{SCALE_BAR:g} mm", complex(x + SCALE_BAR / 2, base + 2.6), 0.0, 2.2))
    for layer in (VALLEY, MOUNTAIN, CUT):
        x -= 34
        ends = np.array([x + 1j * base, x + 12 + 1j * base])
        lines.append(Line(SHEET, ends, look=layer))  # not on its layer: it is not to be cut
        left_aligned(layer, x + 13.5, 2.2)
    room = (x - MARGIN - 4) / (_TEXT_WIDTH * 2.4)
    sheet = f"  {number}/{count}"
    keep = max(int(room) - len(sheet), 0)
    short = title if len(title) <= keep else title[: max(keep - 2, 0)] + ".."
    left_aligned(short + sheet, MARGIN, 2.4)
    return lines, texts
