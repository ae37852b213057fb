# SPDX-License-Identifier: LGPL-2.1-or-later
"""All parts of a long tube from one design file: a HingeSet for every print."""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import FreeCAD as App

from .. import make
from ..objects import type_of
from ..objects.base import Result
from ..objects.hinge_set import HingeSet, parts_for
from .reading import DesignError

if TYPE_CHECKING:
    from .reading import Design

USUAL_BED = (250.0, 210.0, 210.0)  # mm
_OWN = ("Unit", "FirstUnit", "LastUnit")


def hinge_sets(objects: Mapping[str, App.DocumentObject]) -> Any:
    """All HingeSets on the unit of ``objects`` {table: object}, in the order of their units."""
    hinges = objects.get("hinges")
    if hinges is None or hinges.Unit is None:
        return [hinges] if hinges is not None else []
    found = [obj for obj in hinges.Unit.InList if type_of(obj) == HingeSet.Type]
    return sorted(found, key=lambda obj: obj.FirstUnit)


def in_parts(
    doc: App.Document, design: "Design", objects: Mapping[str, App.DocumentObject]
) -> None:
    """`make_parts` where the design asks for them and there is a tube to split."""
    below = [objects[table] for table in ("curve", "triangles", "unit") if table in objects]
    if "hinges" in objects and "curve" in objects and _is_split(design):
        doc.recompute(below)
        if all(obj.isValid() for obj in below):  # else the recompute of all says what is wrong
            make_parts(doc, objects)


def _is_split(design: "Design") -> bool:
    """Whether the prints are yet to be made; make_printable has made its own."""
    searched = design.get("design", "make_printable", False)
    return bool(design.get("output", "parts", False) and not searched)


def make_parts(doc: App.Document, objects: Mapping[str, App.DocumentObject]) -> None:
    """Split the HingeSet of ``objects`` into as many as its bed asks for; not recomputed.

    Its own `Bed` counts, else a usual one. `DesignError` where not even one unit fits.
    """
    hinges = objects["hinges"]
    bed = tuple(hinges.Bed) if any(hinges.Bed) else USUAL_BED
    runs = parts_for(hinges, bed)
    if not runs:
        raise DesignError(
            "[output] parts: not even one unit fits the bed of {size} mm; make edge_length "
            "shorter or the bed larger",
            size=" × ".join(f"{x:g}" for x in bed),
        )
    for first, last in runs:
        part = hinges if first == 0 else make.make_hinge_set(doc, hinges.Unit)
        if part is not hinges:
            _alike(part, hinges)
        part.FirstUnit, part.LastUnit = first + 1, last + 1
        part.Bed = App.Vector(*bed)


def _alike(part: Any, hinges: Any) -> None:
    for prop in HingeSet.PROPERTIES:
        if not isinstance(prop, Result) and prop.name not in _OWN:
            value = getattr(hinges, prop.name)
            if getattr(part, prop.name) != value:
                setattr(part, prop.name, value)
