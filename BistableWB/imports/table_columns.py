# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the head of a table says: which column is which coordinate, and in which unit."""

import re
import unicodedata
from dataclasses import dataclass

from ..origami.errors import Refusal
from .table_numbers import UNITS

_AXES = {
    **dict.fromkeys(("x", "easting", "east", "ost", "ostwert", "rechtswert", "abscissa"), 0),
    **dict.fromkeys(("y", "northing", "north", "nord", "nordwert", "hochwert", "ordinate"), 1),
    **dict.fromkeys(("z", "elevation", "altitude", "höhe"), 2),
}
_ALONE = {"e": 0, "n": 1, "h": 2, "height": 2, "elev": 2}  # axes where nothing else stands there
_ORDER = {"order", "index", "vertex_index", "seq", "sequence", "reihenfolge"}
_ANGLES = {
    "lat", "lon", "lng", "long", "latitude", "longitude", "deg", "degree", "degrees", "°", "grad",
    "rad", "radians", "theta", "phi", "angle", "winkel", "azimuth", "breitengrad", "längengrad",
}  # fmt: skip
_PIXELS = {"px", "pixel", "pixels"}
_WORD = re.compile(r"[^\W\d_]+|°|''|[\"'″′]")
_GLUED = re.compile(r"([xyz])(mm|cm|dm|m|in|inch|ft)")
_SAID = re.compile(r"\b(?:length[ _]?)?(?:units?|einheit(?:en)?)\s*[:=;,\t ]\s*([^\s;,]+)", re.I)


@dataclass
class Columns:
    """``places``: column of x, y, z (None: there is none); ``factors``: mm of their units.

    ``order``: column to sort by, or None; ``unit``: as the head has it, or "".
    """

    places: list
    factors: list
    order: int | None = None
    unit: str = ""


def columns_of(heads: list[list[str]], said: str, where: str) -> Columns | None:
    """Columns by the rows of a head, of which the last with x and y counts; None without such.

    ``said``: the unit that the file has for all its lengths, or "". `Refusal` for angles, pixels,
    and units that are not known.
    """
    names = next((row for row in reversed(heads) if _axes(row, where)), None)
    if names is None:
        for row in heads:
            _refuse_angles(row, where)
        return None
    found = _axes(names, where)
    _refuse_angles([names[k] for k in found.values()], where)
    below = heads[len(heads) - 1 - heads[::-1].index(names) + 1 :]
    places = [found.get(axis) for axis in range(3)]
    units = [_unit(place, names, below, said, where) for place in places]
    order = next((k for k, name in enumerate(names) if _plain(name) in _ORDER), None)
    unit = next((u for u, p in zip(units, places, strict=True) if u and p is not None), "")
    return Columns(places, [UNITS[unit] if unit else 1.0 for unit in units], order, unit)


def unit_said(lines: list[str], where: str) -> str:
    """The unit of a line such as "# units: inch", or ""."""
    for line in lines:
        match = _SAID.search(line)
        word = _plain(match[1]) if match else ""
        if word in UNITS:
            return word
        if word in _PIXELS | _ANGLES:
            raise no_length(where, word)
    return ""


def unit_in(cell: str, where: str) -> str:
    """The unit in a head's cell, of whatever name: "Distance (m)"; "" where there is none."""
    words = _words(cell)
    bracket = re.search(r"[(\[{<]\s*([^)\]}>]*?)\s*[)\]}>]", cell)
    if bracket:
        word = _plain(bracket[1])
        if word in _PIXELS | _ANGLES:
            raise no_length(where, word)
        if word not in UNITS and word:
            raise Refusal(
                "{where} has a column {cell} in a unit that is not known", where=where,
                cell=cell.strip()[:30], cure="convert it to mm, and write (mm) or nothing behind",
            )  # fmt: skip
        return word
    glued = _GLUED.fullmatch(words[0]) if len(words) == 1 else None
    units = [word for word in words[1:] if word in UNITS]
    return glued[2] if glued else units[-1] if units else ""


def _unit(place, names, below, said, where):
    if place is None:
        return ""
    own = unit_in(names[place], where)
    for row in below:
        if place < len(row) and not own:
            own = _plain(row[place].strip("()[]{}<> ")) if row[place].strip() else ""
            own = own if own in UNITS else ""
    return own or said


def _axes(row, where):
    """{axis: column} of a row of names; empty without two axes of which one is x or y."""
    found = {}
    for k, cell in enumerate(row):
        words = _words(cell)
        glued = _GLUED.fullmatch(words[0]) if len(words) == 1 else None
        axes = {_AXES[word] for word in ([glued[1]] if glued else words) if word in _AXES}
        if not axes and len(words) == 1 and words[0] in _ALONE:
            axes = {_ALONE[words[0]]}
        if len(axes) != 1:
            continue
        axis = axes.pop()
        if axis in found:
            if _plain(cell) == _plain(row[found[axis]]) or axis < 2:
                raise Refusal(
                    "{where} has two columns for one axis, {one} and {other}", where=where,
                    one=row[found[axis]].strip(), other=cell.strip(),
                    cure="keep those of one curve",
                )  # fmt: skip
            continue
        found[axis] = k
    return found if len(found) > 1 and (0 in found or 1 in found) else {}


def _refuse_angles(row, where):
    for cell in row:
        words = set(_words(cell))
        if words & _ANGLES:
            raise no_length(where, cell.strip())
        if words & _PIXELS:
            raise no_length(where, cell.strip())


def no_length(where, word):
    """The refusal of angles and pixels."""
    return Refusal(
        "{where} has angles or pixels ({word}), not lengths", where=where, word=word[:30],
        cure="convert them to coordinates in mm or m (a projection such as UTM for a map)",
    )  # fmt: skip


def _words(cell):
    text = unicodedata.normalize("NFC", cell).strip().strip("\"'").lower()
    return _WORD.findall(text)


def _plain(cell):
    return unicodedata.normalize("NFC", cell).strip().strip("()[]{}").strip().lower()
