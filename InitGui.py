# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start with a window: names the workbench. All else is imported when it is activated.

FreeCAD executes this file inside a function: there is no ``__file__``, and names defined here are
gone inside the methods, which therefore import what they need.
"""

import FreeCADGui as Gui

from BistableWB import wiring


class BistableWorkbench(Gui.Workbench):
    """Curve → triangles → bistable units → printable tube."""

    def __init__(self):
        from BistableWB import ICONS

        self.__class__.Icon = str(ICONS / "BistableWorkbench.svg")
        self.__class__.MenuText = "Bistable"
        self.__class__.ToolTip = "Bistable flat-foldable tubes along curves, with printable hinges"

    def Initialize(self):
        """First activation: commands, toolbars and menu."""
        from BistableWB import commands

        commands.initialise(self)

    def ContextMenu(self, recipient):
        """Offer what goes with the selection, in the tree and in the 3D view."""
        from BistableWB import commands

        commands.context_menu(self, recipient)

    def GetClassName(self):
        """Tell FreeCAD that this is a workbench in Python."""
        return "Gui::PythonWorkbench"


wiring.join()
Gui.addWorkbench(BistableWorkbench())
