# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers and units as people, spreadsheets and instruments write them."""

import math
import re

from ..origami.errors import Refusal

UNITS = {  # in mm
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), 1.0),
    **dict.fromkeys(("cm", "centimeter", "centimeters", "centimetre", "centimetres", "zentimeter"),
                    10.0),
    **dict.fromkeys(("dm", "decimeter", "decimetre", "dezimeter"), 100.0),
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), 1000.0),
    **dict.fromkeys(("km", "kilometer", "kilometers", "kilometre", "kilometres"), 1e6),
    **dict.fromkeys(("µm", "μm", "um", "micron", "microns", "micrometer", "micrometre"), 0.001),
    **dict.fromkeys(("in", "inch", "inches", "zoll", '"', '""', "″", "''"), 25.4),
    **dict.fromkeys(("ft", "foot", "feet", "fuß", "fuss", "'", "′"), 304.8),
    **dict.fromkeys(("yd", "yard", "yards"), 914.4),
    **dict.fromkeys(("mil", "mils", "thou"), 0.0254),
    "pt": 25.4 / 72,
}  # fmt: skip
_CELL = re.compile(r"([+-]?[\d.,'’ \u00a0\u202f\u2009]*\d[.,]?(?:e[+-]?\d+)?)\s*([^\d\s]*)", re.I)
_MINUS = str.maketrans({"\u2212": "-", "\u2013": "-", "\u2012": "-", "\ufe63": "-", "\uff0d": "-"})
_BLANKS = re.compile(r"(?<=\d)['’ \u00a0\u202f\u2009](?=\d{3}(?!\d))")


def split_cell(cell: str) -> tuple[str, float | None] | None:
    """The number of a cell as text, and the unit behind it in mm; None where it is no number."""
    match = _CELL.fullmatch(cell.translate(_MINUS).strip())
    if match is None:
        return None
    unit = match[2].lower()
    if unit and unit not in UNITS:
        return None
    text = _BLANKS.sub("", match[1])
    if re.search(r"[^\d.,e+-]", text, re.I):
        return None
    return text, UNITS[unit] if unit else None


def decimal_mark(cells: list[str], where: str) -> str:
    """The decimal mark, "." or ",", that all numbers of a table agree on.

    `Refusal` where both are used, or where 1,234 may be 1234 as well as 1.234.
    """
    commas = [cell for cell in cells if "," in cell]
    if not commas:
        return "."
    marks = {_mark(cell) for cell in cells}
    if "," in marks and "." in marks:
        sure = {_mark(cell) for cell in cells if _is_sure(cell)}
        if len(sure) == 1:
            return sure.pop()
        raise Refusal(
            "{where} has points and commas in its numbers, as {one} and {other}", where=where,
            one=next(c for c in cells if _mark(c) == "."), other=commas[0],
            cure="export it with one decimal mark and no thousands separators",
        )  # fmt: skip
    if any(_is_sure(cell) for cell in commas):
        return "," if any(_mark(cell) == "," for cell in commas if _is_sure(cell)) else "."
    if all("," in cell for cell in cells):
        return ","  # all with three decimals
    raise Refusal(
        "{where}: {cell} may be {large} or {small}", where=where, cell=commas[0],
        large=commas[0].replace(",", ""), small=commas[0].replace(",", "."),
        cure="export it without thousands separators",
    )  # fmt: skip


def _mark(cell):
    """The decimal mark that a number seems to have; "" where it has none."""
    point, comma = cell.rfind("."), cell.rfind(",")
    if point < 0 and comma < 0:
        return ""
    mark = "." if point > comma else ","
    if cell.count(mark) > 1:
        return "," if mark == "." else "."  # 1.234.567
    return mark


def _is_sure(cell):
    """Whether a number can be read in one way only."""
    if ("." in cell and "," in cell) or max(cell.count("."), cell.count(",")) > 1:
        return True
    mark = _mark(cell)
    whole, _, rest = cell.lstrip("+-").partition(mark) if mark else (cell, "", "")
    grouped = re.fullmatch(r"[1-9]\d{0,2}", whole) and re.fullmatch(r"\d{3}", rest)
    return bool(mark) and not grouped


def value_of(text: str, mark: str) -> float | None:
    """A number with the decimal mark ``mark``; the other one separates thousands."""
    text = text.replace("," if mark == "." else ".", "").replace(mark, ".")
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
