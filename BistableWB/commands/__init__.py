# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands: toolbars, menus, context menus. Imported when the workbench is activated."""

import FreeCADGui as Gui

from .. import TRANSLATIONS
from ..objects import type_of
from .base import QT_TRANSLATE_NOOP
from .create import CurveCommand, CurveOnSphere, NewTube, TrianglePlacement, Units
from .files import OpenExample, ShowHelp
from .repair import Repair

COMMANDS = (
    NewTube(),
    CurveCommand(),
    CurveOnSphere(),
    TrianglePlacement(),
    Units(),
    Repair(),
    OpenExample(),
    ShowHelp(),
)

_DESIGN = [NewTube.name, "Separator", CurveCommand.name, CurveOnSphere.name,
           TrianglePlacement.name, Units.name]  # fmt: skip
_REST = [OpenExample.name, Repair.name, ShowHelp.name]

TOOLBARS = {
    QT_TRANSLATE_NOOP("Workbench", "Bistable design"): _DESIGN,
}
MENUS = {
    QT_TRANSLATE_NOOP("Workbench", "&Bistable"): [*_DESIGN, "Separator", *_REST],
}

# Type of the selected object -> commands that go on from it.
CONTEXT = {
    "Bistable::Curve": [TrianglePlacement.name, Units.name],
    "Bistable::TrianglePlacement": [Units.name],
}


def initialise(workbench):
    """Register the commands and lay out toolbars and menus of ``workbench``."""
    Gui.addLanguagePath(str(TRANSLATIONS))
    Gui.updateLocale()
    for command in COMMANDS:
        Gui.addCommand(command.name, command)
    for title, names in TOOLBARS.items():
        workbench.appendToolbar(title, names)
    for title, names in MENUS.items():
        workbench.appendMenu(title, names)


def context_menu(workbench, recipient):
    """Offer the next step for the selected object, in the tree and in the 3D view."""
    selected = Gui.Selection.getSelection()
    if len(selected) == 1 and type_of(selected[0]) in CONTEXT:
        workbench.appendContextMenu("", CONTEXT[type_of(selected[0])])
