# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects with so many faces that their view provider draws them, and FreeCAD need not."""

import re

from ..colours import PANELS
from .base import BistableObject, OfShape

_SHAPE = 2  # what FreeCAD wants: its own code for a shape, not an object


BODY_RESULTS = (
    OfShape("Integer", "BodyCount", "Results", "Number of separate moving bodies"),
    OfShape("StringList", "BodyNames", "Results", "Names of the bodies, in the order of the "
            "solids"),
    OfShape("StringList", "BodyKinds", "Results", "What each body is: a panel of one of four "
            "kinds, a block, a link, a flexure"),
    OfShape("IntegerList", "BodyUnits", "Results", "Number of each body's unit; of a block the "
            "first of its two"),
)  # fmt: skip


def body_results(bodies):
    """Values of `BODY_RESULTS` for `solids.tube.Body` objects."""
    return {
        "BodyCount": len(bodies),
        "BodyNames": [body.name for body in bodies],
        "BodyKinds": [body.kind for body in bodies],
        "BodyUnits": [body.unit + 1 for body in bodies],
    }


class SelfDrawn(BistableObject):
    """Withholds its shape from FreeCAD's drawing when the view provider asks for that.

    FreeCAD draws what it finds as the shape of the whole object right after it has told the view
    provider of a change. It takes 0.1 ms for every face, seconds for a tube.
    """

    _withheld = False

    def migrate(self, obj, version):
        """Give bodies of files of before 0.2 the kinds and units that only their names told."""
        super().migrate(obj, version)
        is_older = "BodyKinds" not in obj.PropertiesList
        self.ensure_properties(obj)
        if is_older:
            obj.BodyKinds = _kinds_by_old_names(obj.BodyNames)
            obj.BodyUnits = [_unit_by_old_name(name) for name in obj.BodyNames]

    def withhold_shape(self, on=True):
        """The next question for the shape of the whole object gets no answer: it is to be drawn."""
        self._withheld = on

    def getSubObject(self, obj, name, kind, *_):
        """What FreeCAD asks: None for nothing, False to let it find the answer itself."""
        if self._withheld and not name and kind == _SHAPE:
            self._withheld = False
            return None
        return False


def _kinds_by_old_names(names):
    """Kinds of bodies by the names that version 0.1 gave them; plates of coupons had none."""
    words = ("strip", "block", "link", *PANELS)
    found = [next((word for word in words if word in name), None) for name in names]
    plates = list(PANELS)
    kinds = [word or plates[k % len(plates)] for k, word in enumerate(found)]
    return ["flexure" if kind == "strip" else kind for kind in kinds]


def _unit_by_old_name(name):
    """Number of the unit that version 0.1 wrote into a body's name; 1 in coupons."""
    found = re.search(r"(?:unit|block)(\d+)", name)
    return int(found.group(1)) if found else 1
