# SPDX-License-Identifier: LGPL-2.1-or-later
"""The basic shapes of SVG 2 (chapter 10) and paths, as pieces in the element's own units."""

import math
from collections.abc import Callable, Iterator

import numpy as np

from . import svg_units
from .pieces import Arc, Line, Piece
from .svg_path import PathData

Shape = Iterator[tuple[list[Piece], bool]]  # connected pieces, and whether nothing was in error


def _lengths(style, view, where, *names, default="0"):
    """Lengths in pixels by their names; a percentage is of the width, the height, or both."""
    both = math.hypot(*view) / math.sqrt(2)
    whole = {"x": view[0], "y": view[1], "w": view[0], "h": view[1]}
    found = []
    for name in names:
        of = both if name == "r" else whole[name.removeprefix("c").removeprefix("r")[0]]
        found.append(svg_units.length(style.get(name, default), of, f"{where}: {name}"))
    return found


def _path(style, view, where) -> Shape:
    text = style.get("d", "")
    if text.startswith("path("):
        text = text[5:].rstrip(") ").strip("\"' ")
    data = PathData("" if text == "none" else text)
    last = len(data.subpaths) - 1
    for k, pieces in enumerate(data.subpaths):
        yield pieces, data.error is None or k < last
    if data.error is not None and not data.subpaths:
        yield [], False


def _rect(style, view, where) -> Shape:
    x, y, width, height = _lengths(style, view, where, "x", "y", "width", "height")
    if width <= 0 or height <= 0:
        return
    rx, ry = (style.get(name, "auto") for name in ("rx", "ry"))
    rx, ry = (ry if rx == "auto" else rx), (rx if ry == "auto" else ry)
    if "auto" in (rx, ry):
        rx = ry = "0"
    rx, ry = _lengths({"rx": rx, "ry": ry}, view, where, "rx", "ry")
    rx, ry = min(max(rx, 0), width / 2), min(max(ry, 0), height / 2)
    if rx == 0 or ry == 0:
        yield _polygon([(x, y), (x + width, y), (x + width, y + height), (x, y + height)]), True
        return
    left, right, top, bottom = x + rx, x + width - rx, y + ry, y + height - ry
    corners = [(right, top), (right, bottom), (left, bottom), (left, top)]
    arcs = [
        Arc(np.array([*c, 0.0]), np.array([rx, 0, 0.0]), np.array([0, ry, 0.0]),
            math.pi / 2 * (k - 1), math.pi / 2 * k)
        for k, c in enumerate(corners)
    ]  # fmt: skip
    pieces: list[Piece] = []
    for arc, after in zip(arcs, arcs[1:] + arcs[:1], strict=True):
        pieces += [arc, Line(arc.end, after.start)]
    yield pieces, True


def _circle(style, view, where) -> Shape:
    x, y, r = _lengths(style, view, where, "cx", "cy", "r")
    yield from _oval(x, y, r, r)


def _ellipse(style, view, where) -> Shape:
    x, y = _lengths(style, view, where, "cx", "cy")
    rx, ry = (style.get(name, "auto") for name in ("rx", "ry"))
    rx, ry = (ry if rx == "auto" else rx), (rx if ry == "auto" else ry)
    if "auto" not in (rx, ry):
        yield from _oval(x, y, *_lengths({"rx": rx, "ry": ry}, view, where, "rx", "ry"))


def _oval(x, y, rx, ry):
    if rx > 0 and ry > 0:
        u, v = np.array([rx, 0, 0.0]), np.array([0, ry, 0.0])
        yield [Arc(np.array([x, y, 0.0]), u, v, 0.0, 2 * math.pi)], True


def _line(style, view, where) -> Shape:
    x1, x2, y1, y2 = _lengths(style, view, where, "x1", "x2", "y1", "y2")
    yield [Line(np.array([x1, y1, 0.0]), np.array([x2, y2, 0.0]))], True


def _polyline(style, view, where, close=False) -> Shape:
    values = svg_units.numbers(style.get("points", ""))
    points = list(zip(values[::2], values[1::2], strict=False))
    if len(points) > 1:
        pieces = _polygon(points)
        yield pieces if close else pieces[:-1], len(values) % 2 == 0


def _closed_polygon(style, view, where) -> Shape:
    yield from _polyline(style, view, where, close=True)


def _polygon(points):
    corners = [np.array([x, y, 0.0]) for x, y in points]
    return [Line(a, b) for a, b in zip(corners, corners[1:] + corners[:1], strict=True)]


SHAPES: dict[str, Callable[..., Shape]] = {
    "path": _path,
    "rect": _rect,
    "circle": _circle,
    "ellipse": _ellipse,
    "line": _line,
    "polyline": _polyline,
    "polygon": _closed_polygon,
}
