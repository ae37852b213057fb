# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw a curve in the 3D view; the zigzag of its tube follows every click."""

import FreeCAD as App
import FreeCADGui as Gui

from .base import QT_TRANSLATE_NOOP, Command, by_name, translate


class DrawCurve(Command):
    """A new curve, by clicks."""

    name = "Bistable_DrawCurve"
    icon = "DrawCurve"
    text = QT_TRANSLATE_NOOP("Bistable_DrawCurve", "Draw curve")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_DrawCurve",
        "Click the control points of a curve into the 3D view and drag them; the zigzag of the "
        "tube follows",
    )
    shortcut = "O, D"

    def IsActive(self):
        """While no other panel is open."""
        return not Gui.Control.activeDialog()

    def run(self):
        """Make curve and triangles without points, and open the curve's panel."""
        if App.ActiveDocument is None:
            Gui.doCommand('App.newDocument("BistableTube")')
        doc = App.ActiveDocument
        view = Gui.ActiveDocument.ActiveView
        if hasattr(view, "viewTop"):
            animated = view.isAnimationEnabled()
            view.setAnimationEnabled(False)
            view.viewTop()
            view.setAnimationEnabled(animated)
            if not doc.Objects:
                _show_millimetres(view, 300)
        doc.openTransaction(translate("Bistable_DrawCurve", "Draw curve"))
        Gui.doCommand("from BistableWB import make")
        Gui.doCommand("doc = App.ActiveDocument")
        Gui.doCommand("curve = make.make_curve(doc, points=[])")
        Gui.doCommand("triangles = make.make_triangle_placement(doc, curve, **make.NEW_TUBE)")
        curve = doc.Objects[-2]
        Gui.doCommandGui(f"Gui.ActiveDocument.setEdit({by_name(curve)}.Name)")


def _show_millimetres(view, height):
    """Let an empty view show the plane from above, ``height`` mm of it."""
    view.setCamera(
        "#Inventor V2.1 ascii\n\nOrthographicCamera {\n"
        f"viewportMapping ADJUST_CAMERA\nposition 0 0 {height}\norientation 0 0 1 0\n"
        f"nearDistance 1\nfarDistance {2 * height}\naspectRatio 1\nfocalDistance {height}\n"
        f"height {height}\n}}\n"
    )
