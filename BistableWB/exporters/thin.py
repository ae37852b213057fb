# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the formats of zero thickness write: the tubes of the chosen objects."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..origami.errors import Refusal
from ..origami.units.tube import Tube

if TYPE_CHECKING:
    import FreeCAD as App


class ThinModel(NamedTuple):
    """A BistableUnit object's ``name`` and its `Tube`; ``frame`` (4, 4) carries it into space."""

    name: str
    tube: Tube
    frame: np.ndarray


def thin_models(bodies: Sequence[Any]) -> list[ThinModel]:
    """`ThinModel` of every object that ``bodies`` come from, each once, in their order.

    What is a `ThinModel` already, made without FreeCAD, stays one. A HingeSet stands for its unit.
    ValueError for an object that has no panels of zero thickness.
    """
    if all(isinstance(body, ThinModel) for body in bodies):
        return list(bodies)
    from ..objects.base import global_placement
    from ..objects.bistable_unit import tube_of
    from ..solids.matrices import array_of

    found = {}
    for body in bodies:
        unit = unit_of(body.source)
        if unit.Name not in found:
            frame = np.eye(4)
            if unit.Triangles is None:
                frame = array_of(global_placement(unit))
            found[unit.Name] = ThinModel(unit.Label, tube_of(unit), frame)
    return list(found.values())


def unit_of(obj: "App.DocumentObject") -> "App.DocumentObject":
    """The BistableUnit that an object is, or that a HingeSet is made on."""
    kind = getattr(getattr(obj, "Proxy", None), "Type", obj.TypeId)
    unit = obj.Unit if kind == "Bistable::HingeSet" else obj
    kind = getattr(getattr(unit, "Proxy", None), "Type", unit.TypeId)
    if kind != "Bistable::BistableUnit":
        raise Refusal(
            "{label} has no panels of zero thickness to write: choose a BistableUnit, or a "
            "HingeSet on one.",
            label=obj.Label,
        )
    return unit
