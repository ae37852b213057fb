# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects with so many faces that their view provider draws them, and FreeCAD need not."""

from .base import BistableObject

_SHAPE = 2  # what FreeCAD wants: its own code for a shape, not an object


class SelfDrawn(BistableObject):
    """Withholds its shape from FreeCAD's drawing when the view provider asks for that.

    FreeCAD draws what it finds as the shape of the whole object right after it has told the view
    provider of a change. It takes 0.1 ms for every face, seconds for a tube.
    """

    _withheld = False

    def withhold_shape(self, on=True):
        """The next question for the shape of the whole object gets no answer: it is to be drawn."""
        self._withheld = on

    def getSubObject(self, obj, name, kind, *_):
        """What FreeCAD asks: None for nothing, False to let it find the answer itself."""
        if self._withheld and not name and kind == _SHAPE:
            self._withheld = False
            return None
        return False
