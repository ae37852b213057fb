# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: resources, one undo step, lines that a macro can replay headless."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import ICONS
from ..recording.script import Script, by_name, print_error, quoted

__all__ = [
    "QT_TRANSLATE_NOOP", "Command", "Script", "by_name", "fit_view", "print_error",
    "quoted", "translate",
]  # fmt: skip
translate = App.Qt.translate


def QT_TRANSLATE_NOOP(context, text):
    """Mark ``text`` for the translators; FreeCAD translates it when it is shown."""
    return text


class Command:
    """One command: a row of resources and ``run``.

    ``icon`` names a file of resources/icons; ``shortcut`` is a Qt key sequence. The translation
    context of ``text`` and ``tip`` is ``name``, as FreeCAD wants it.
    """

    name = ""
    icon = ""
    text = ""
    tip = ""
    shortcut = ""

    def GetResources(self):
        """Menu text, icon, tips and shortcut as FreeCAD asks for them."""
        resources = {
            "Pixmap": str(ICONS / f"{self.icon}.svg"),
            "MenuText": self.text,
            "ToolTip": self.tip,
            "StatusTip": self.tip,
        }
        return resources | ({"Accel": self.shortcut} if self.shortcut else {})

    def IsActive(self):
        """Always, unless a command says otherwise. Asked many times a second: keep it cheap."""
        return True

    def Activated(self, index=0):
        """FreeCAD's entry."""
        self.run()

    def run(self):
        """Do it."""
        raise NotImplementedError


def fit_view(isometric=False):
    """Bring the whole document into view at once; on request seen from above at an angle."""
    view = Gui.ActiveDocument.ActiveView if Gui.ActiveDocument else None
    if not hasattr(view, "fitAll"):
        return
    animated = view.isAnimationEnabled()
    view.setAnimationEnabled(False)
    if isometric:
        view.viewIsometric()
    view.fitAll()
    view.setAnimationEnabled(animated)
