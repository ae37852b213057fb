# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects of a document as a design file that makes the same again: the way back of `building`."""

import json
from collections.abc import Mapping
from typing import Any

import FreeCAD as App
import Part

from ..objects import TYPES, type_of
from ..objects.base import global_placement
from ..objects.curve import geometry_of
from ..objects.edges import edges_of
from ..origami.curves.families import FAMILIES, counts, wraps
from ..origami.errors import Refusal
from .keys import RULE_OF, SINGLE_UNIT, TABLES

# Table -> type of the object that it makes, and the property by which that links to the one before.
_CHAIN = {entry.table: (name, entry.input) for name, entry in TYPES.items() if entry.table}
CURVE_FILE = "curve.brep"


def objects_of(obj: App.DocumentObject) -> Any:
    """{table: object}: a print or a tube of ours with all that it is made from, inputs first.

    As `building.build` returns them; ValueError for other objects.
    """
    table = next((table for table, (kind, _) in _CHAIN.items() if kind == type_of(obj)), None)
    if table is None or table in ("curve", "triangles"):
        raise Refusal(
            "{label} is no tube: choose a BistableUnit, a HingeSet or a HingeCoupon.",
            label=obj.Label,
        )
    found = {}
    while obj is not None:
        table = next(table for table, (kind, _) in _CHAIN.items() if kind == type_of(obj))
        found[table] = obj
        obj = getattr(obj, _CHAIN[table][1], None) if _CHAIN[table][1] else None
    return dict(reversed(found.items()))


def text_of(objects: Mapping[str, App.DocumentObject], title: Any) -> Any:
    """The text of a design file for ``objects`` {table: object}, and its curve's file.

    The second is the content of `CURVE_FILE`, to lie beside the design file, or empty where the
    curve has control points. ValueError where a design file cannot say what the document does.
    """
    tables = {"design": {"name": title}}
    curve_file = ""
    for table, obj in objects.items():
        if table == "curve":
            tables[table], curve_file = _curve(obj)
        else:
            tables[table] = _values(obj, table, unused(obj))
    parts = [
        "\n".join([f"[{table}]", *(f"{key} = {_toml(value)}" for key, value in values.items())])
        for table, values in tables.items()
    ]
    return "\n\n".join(parts) + "\n", curve_file


def unused(obj: App.DocumentObject) -> set[str]:
    """Names of properties that have no effect as the object stands."""
    names = set()
    curve = getattr(obj, "Curve", None) or obj
    kind, found = (getattr(curve, name, "") for name in ("Kind", "FoundKind"))
    for name, family in FAMILIES.items():
        names |= set() if counts(name, kind, found) else set(family.keys.values())
    if not counts("General", kind, found):
        names.add("Level")
    if getattr(obj, "PlacementRule", "") != "Steered":
        names |= {"Tolerance", "Symmetric", "StartDirection", "EndDirection"}
    if getattr(obj, "Source", None) is None:
        names.add("CornerRadius")
    rule = getattr(obj, "RatioRule", "")
    names |= {TABLES["unit"][key].property for key, r in RULE_OF.items() if r != rule}
    if getattr(obj, "Triangles", None) is not None:
        names |= {TABLES["unit"][key].property for key in SINGLE_UNIT}
    if getattr(obj, "SegmentWidth", 0):
        names.add("Segmentations")
    if getattr(obj, "PreloadRule", "") == "Automatic":
        names.add("Preload")
    if getattr(obj, "Preset", "") == "Custom":
        names.add("Preset")
    return names


def _values(obj: App.DocumentObject, table: str, leave_out: Any) -> Any:
    """{key: plain value} of the properties of an object."""
    return {
        key: _plain(getattr(obj, entry.property))
        for key, entry in TABLES[table].items()
        if entry.property and entry.property not in leave_out
    }


def _plain(value: Any) -> Any:
    if isinstance(value, App.Units.Quantity):
        return _rounded(value.Value)
    if isinstance(value, App.Vector):
        return list(value)
    if isinstance(value, list):
        return [_plain(item) for item in value]
    return _rounded(value) if isinstance(value, float) else value


def _rounded(number: Any) -> Any:
    """``number`` without the last digits of sums and of inches, 1.8 for 1.7999999999999998."""
    return float(f"{number:.13g}")


def _curve(obj: App.DocumentObject) -> Any:
    """Values of [curve], in global coordinates, and the content of its file if it needs one."""
    values = _values(obj, "curve", unused(obj) | {"Points"})
    place = global_placement(obj)
    if wraps(obj.Kind):
        values["sphere_center"] = list(place.multVec(obj.SphereCenter))
    moved = not place.isIdentity()
    general = "General" in (obj.Kind, obj.FoundKind)
    if general and (moved or obj.RulingKind != "Automatic" or obj.Source):
        kind, vector = geometry_of(obj).legs
        values["ruling_kind"] = "Direction" if kind == "parallel" else "Viewpoint"
        values["ruling"] = [float(x) for x in vector]
    elif general:
        del values["ruling"]
    if obj.Source is not None:
        values["source"] = CURVE_FILE
        return values, Part.makeCompound(edges_of(obj.Source)[0]).exportBrepToString()
    values["points"] = [list(p) for p in _global_points(obj, place)]
    return values, ""


def _global_points(obj: App.DocumentObject, place: Any) -> Any:
    plan = wraps(obj.Kind) and not any(p.z for p in obj.Points)
    if not plan:
        return [place.multVec(p) for p in obj.Points]
    if place.Rotation.Angle > 1e-12:
        raise Refusal(
            "A design file cannot turn a plan on a sphere: set the rotation of {label} to 0, or "
            "give its points heights.",
            label=obj.Label,
        )
    return list(obj.Points)


def _toml(value: Any) -> Any:
    if isinstance(value, list):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return json.dumps(value, ensure_ascii=False)
