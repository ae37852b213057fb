# SPDX-License-Identifier: LGPL-2.1-or-later
"""BistableUnit in the view: twelve faces a unit, coloured by kind of panel."""

import contextlib

from PySide import QtCore

from .. import colours
from . import faces
from .base import BistableView


class BistableUnitView(BistableView):
    """Colours follow the number of faces; as long as that stays, the user's own ones stay too."""

    LOOK = {"LineColor": colours.rgb(colours.INK), "LineWidth": 1.0, "PointSize": 1.0}

    def updateData(self, obj, name):
        """Colour anew when the number of faces has changed."""
        if name != "Shape":
            return
        pattern = faces.unit_colours()
        count = len(obj.Shape.Faces)
        if count and len(faces.face_colours(obj.ViewObject)) != count:
            faces.set_face_colours(obj.ViewObject, pattern * (count // len(pattern)))
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
