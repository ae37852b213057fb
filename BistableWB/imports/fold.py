# SPDX-License-Identifier: LGPL-2.1-or-later
"""FOLD files of ours back into a single unit; see `exporters.fold`.

The numbers in the file say which unit it is, its coordinates must agree with them.
"""

import json
import math
from typing import NamedTuple

import FreeCAD as App
import numpy as np

from .. import make
from ..origami import rigid
from ..origami.errors import Refusal
from ..origami.units import tube
from ..origami.units.angles import exact_sphere_ratio
from ..origami.units.ratios import RatioRule
from ..solids.matrices import placement_of
from .text import file_at, text_of

_KEY = "bistable:units"
_SAME = 1e-8  # of ‖AB‖
_RATIO = 1e-9
_LEAST, _MOST = 1e-6, 1e8  # mm: lengths and places of what somebody has drawn


class SingleUnit(NamedTuple):
    """A unit by itself: angles in degrees, lengths in mm.

    ``rule`` of its ratio: "Fixed", "Exact" or "Paper"; ``place`` (4, 4): where the file has it.
    """

    theta: float
    ratio: float
    omega: float
    edge_length: float
    strip_height: float
    rule: str
    place: np.ndarray


def import_fold(doc, path, unit=None):
    """A BistableUnit object for one unit of a FOLD file of ours, where it stands in the file.

    ``unit``: its number, from 1, in a file of several. The document is not recomputed.
    """
    read = read_unit(path, unit)
    obj = make.make_bistable_unit(
        doc,
        theta=read.theta,
        edge_length=read.edge_length,
        height_ratio=read.edge_length / read.strip_height,
        ratio=read.ratio,
    )
    obj.Omega = read.omega
    obj.RatioRule = read.rule
    obj.Placement = placement_of(read.place)
    return obj


def insert(path, document):
    """FreeCAD's File → Import: every unit of the file, into the document of this name."""
    doc = App.getDocument(document)
    for unit in range(1, unit_count(path) + 1):
        import_fold(doc, path, unit)
    doc.recompute()


def open(path):
    """FreeCAD's File → Open: every unit of the file, in a new document."""
    doc = App.newDocument(file_at(path).stem)
    insert(path, doc.Name)
    return doc


def unit_count(path):
    """Number of units in a FOLD file of ours; ValueError for any other file."""
    return len(_content(file_at(path))[_KEY])


def read_unit(path, unit=None):
    """`SingleUnit` of a FOLD file of ours; ValueError for any other file or a changed one."""
    path = file_at(path)
    content = _content(path)
    entry, number = _entry(content, unit, path)
    try:
        rows = [range(len(content["vertices_coords"]))[int(i)] for i in entry["vertices"]]
        values = [float(entry[k]) for k in _NUMBERS]
        points = np.array(content["vertices_coords"], float)[rows]
    except (KeyError, TypeError, ValueError, IndexError, OverflowError) as error:
        raise Refusal(
            "{name}: unit {number} in {key} is broken ({error}): export the file again.",
            name=path.name,
            number=number,
            key=_KEY,
            error=error,
        ) from error
    if points.shape != (10, 3) or not (np.abs(points) <= _MOST).all():
        raise Refusal(
            "{name}: unit {number} has no ten corners in space: export it again.",
            name=path.name,
            number=number,
        )
    return _checked(values, points, path, number)


_NUMBERS = ("theta", "ratio", "omega", "edge_length", "strip_height")


def _content(path):
    try:
        content = json.loads(text_of(path, "FOLD"))
    except (json.JSONDecodeError, RecursionError) as error:
        raise Refusal(
            "{name} is not a whole FOLD file ({error}): save it again.",
            name=path.name,
            error=error,
        ) from error
    if not isinstance(content, dict) or not any(key.startswith("file_") for key in content):
        raise Refusal(
            "{name} is not a FOLD file: choose a file that is.",
            name=path.name,
        )
    if not isinstance(content.get(_KEY), list) or not content[_KEY]:
        creator = content.get("file_creator") or "another program"
        raise Refusal(
            "{name} was made by {creator}: only FOLD files exported by Bistable Workbench hold "
            "the units that can be read back.",
            name=path.name,
            creator=creator,
        )
    return content


def _entry(content, unit, path):
    entries = content[_KEY]
    if unit is None and len(entries) > 1:
        raise Refusal(
            "{name} holds {count} units: say which, 1 to {count}.",
            name=path.name,
            count=len(entries),
        )
    number = 1 if unit is None else int(unit)
    if not 1 <= number <= len(entries):
        raise Refusal(
            "{name} has no unit {number}: choose 1 to {count}.",
            name=path.name,
            number=number,
            count=len(entries),
        )
    return entries[number - 1], number


def _checked(values, points, path, number):
    theta, ratio, omega, edge, height = values
    if not (_LEAST <= edge <= _MOST and _LEAST <= height <= _MOST and np.isfinite(values).all()):
        raise Refusal(
            "{name}: unit {number} has lengths that no unit has: export it again.",
            name=path.name,
            number=number,
        )
    rule = _rule(theta, ratio, omega)
    family = "Plane" if omega == 90 else "Sphere"
    if rule:
        made = tube.make_unit(
            family,
            np.radians([theta]),
            edge,
            edge / height,
            RatioRule(rule, ratio),
            math.radians(omega),
        )
        place = rigid.fit(made.deployed[0], points)
        off = np.abs(rigid.apply(place, made.deployed[0]) - points).max()
        if off <= _SAME * edge:
            return SingleUnit(theta, ratio, omega, edge, height, rule, place)
    raise Refusal(
        "{name}: unit {number} is not the symmetric unit of its angles (it is one of a general "
        "curve, or the file was changed): only plane and spherical units can be read back.",
        name=path.name,
        number=number,
    )


def _rule(theta, ratio, omega):
    """The rule that gives this ratio, None if no single unit has it."""
    if omega == 90:
        return "Fixed"
    if not (0 < omega < 90 and 0 < theta <= 60):
        return None
    if abs(ratio - exact_sphere_ratio(math.radians(theta))) < _RATIO:
        return "Exact"
    return "Paper" if abs(ratio - 0.5) < _RATIO else None
