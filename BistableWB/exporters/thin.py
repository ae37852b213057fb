# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the formats of zero thickness write: the tubes of the chosen objects."""

from typing import NamedTuple

import numpy as np

from ..objects.base import global_placement
from ..objects.bistable_unit import tube_of
from ..origami.tube import Tube


class ThinModel(NamedTuple):
    """A BistableUnit object's ``name`` and its `Tube`; ``frame`` (4, 4) carries it into space."""

    name: str
    tube: Tube
    frame: np.ndarray


def thin_models(bodies):
    """`ThinModel` of every object that ``bodies`` come from, each once, in their order.

    A HingeSet stands for its unit. ValueError for an object that has no panels of zero thickness.
    """
    found = {}
    for body in bodies:
        unit = _unit_of(body.source)
        if unit.Name not in found:
            frame = np.eye(4)
            if unit.Triangles is None:
                frame = np.array(global_placement(unit).toMatrix().A).reshape(4, 4)
            found[unit.Name] = ThinModel(unit.Label, tube_of(unit), frame)
    return list(found.values())


def _unit_of(obj):
    kind = getattr(getattr(obj, "Proxy", None), "Type", obj.TypeId)
    unit = obj.Unit if kind == "Bistable::HingeSet" else obj
    kind = getattr(getattr(unit, "Proxy", None), "Type", unit.TypeId)
    if kind != "Bistable::BistableUnit":
        raise ValueError(
            f"{obj.Label} has no panels of zero thickness to write: choose a BistableUnit, or a "
            "HingeSet on one."
        )
    return unit
