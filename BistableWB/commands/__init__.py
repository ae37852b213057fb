# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands: toolbars, menus, context menus. Imported when the workbench is activated."""

import FreeCADGui as Gui

from .. import ICONS, TRANSLATIONS
from ..objects import TYPES, type_of
from .base import QT_TRANSLATE_NOOP
from .create import CurveCommand, CurveOnSphere, NewTube, TrianglePlacement, Units
from .drawing import DrawCurve
from .files import OpenExample, ShowHelp
from .fit import AutoFit, MakePrintable
from .hinges import Calibration, HingeCoupon, HingeSet
from .importing import Import
from .motion import Deploy
from .output import Check, ExportPrint, Report
from .plots import Plots
from .repair import Repair

COMMANDS = (
    NewTube(),
    DrawCurve(),
    CurveCommand(),
    CurveOnSphere(),
    Import(),
    TrianglePlacement(),
    Units(),
    MakePrintable(),
    AutoFit(),
    Deploy(),
    Plots(),
    HingeSet(),
    HingeCoupon(),
    Calibration(),
    ExportPrint(),
    Check(),
    Report(),
    Repair(),
    OpenExample(),
    ShowHelp(),
)

_DESIGN = [NewTube.name, "Separator", DrawCurve.name, CurveCommand.name, CurveOnSphere.name,
           Import.name, TrianglePlacement.name, Units.name, MakePrintable.name]  # fmt: skip
_PRINT = [Deploy.name, Plots.name, HingeSet.name, HingeCoupon.name, Calibration.name, Check.name,
          ExportPrint.name, Report.name]  # fmt: skip
_REST = [OpenExample.name, Repair.name, ShowHelp.name]

TOOLBARS = {
    QT_TRANSLATE_NOOP("Workbench", "Bistable design"): _DESIGN,
    QT_TRANSLATE_NOOP("Workbench", "Bistable print"): _PRINT,
}
MENUS = {
    QT_TRANSLATE_NOOP("Workbench", "&Bistable"): [
        *_DESIGN,
        "Separator",
        *_PRINT,
        "Separator",
        *_REST,
    ],
}

# Type of the selected object -> commands that go on from it.
CONTEXT = {
    type_name: [f"Bistable_{name}" for name in entry.menu] for type_name, entry in TYPES.items()
}


def initialise(workbench):
    """Register the commands and lay out toolbars and menus of ``workbench``."""
    Gui.addLanguagePath(str(TRANSLATIONS))
    Gui.updateLocale()
    _add_preferences()
    for command in COMMANDS:
        Gui.addCommand(command.name, command)
    for title, names in TOOLBARS.items():
        workbench.appendToolbar(title, names)
    for title, names in MENUS.items():
        workbench.appendMenu(title, names)
    from ..taskpanels.first_start import ask_later

    ask_later()


def _add_preferences():
    from ..taskpanels.preferences import PreferencesPage

    Gui.addIconPath(str(ICONS))  # the page's icon is preferences-bistable.svg by its group
    Gui.addPreferencePage(PreferencesPage, "Bistable")


def context_menu(workbench, recipient):
    """Offer the next step for the selected object, in the tree and in the 3D view."""
    selected = Gui.Selection.getSelection()
    if len(selected) == 1 and type_of(selected[0]) in CONTEXT:
        workbench.appendContextMenu("", CONTEXT[type_of(selected[0])])
