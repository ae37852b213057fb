# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects whose faces are coloured by kind of panel, whatever FreeCAD version draws them."""

import contextlib

from PySide import QtCore

from ..scene import faces
from .base import BistableView


class ColouredView(BistableView):
    """Colours follow the number of faces; as long as that stays, the user's own ones stay too.

    Subclasses give ``wanted_colours(obj)``: RGB of every face, an empty list for none yet.
    """

    def count(self, obj):
        """How many colours there are: faces of the shape."""
        return obj.Shape.countElement("Face")

    def wanted_colours(self, obj):
        """RGB in 0…1 of every face of the object's shape, in their order."""
        raise NotImplementedError

    def refresh(self, obj):
        """Colour anew when the number of faces has changed, unless the user gave one to all."""
        count, there = self.count(obj), len(faces.face_colours(obj.ViewObject))
        if there == 1 and getattr(self, "_has_coloured", False):
            return
        if count and there != count:
            wanted = self.wanted_colours(obj)
            if len(wanted) == count:
                faces.set_face_colours(obj.ViewObject, wanted)
                self._has_coloured = count > 1
                self._colour_again_soon()

    def onChanged(self, view_object, name):
        """Shown: FreeCAD now draws the faces that changed while they were hidden."""
        if name == "Visibility" and view_object.Visibility:
            self._colour_again_soon()

    def _colour_again_soon(self):
        """FreeCAD 0.20 draws new faces after it has told us of them, and then without colours."""
        if faces.NEEDS_REMINDER:
            QtCore.QTimer.singleShot(0, self._colour_again)

    def _colour_again(self):
        with contextlib.suppress(ReferenceError):  # deleted in the meantime
            faces.remind(self.ViewObject)
