# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands about the print: write it to a file, check it."""

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..exporters import FORMATS
from ..objects import type_of
from ..viewproviders import settings
from . import chosen
from .base import QT_TRANSLATE_NOOP, Command, by_name, quoted, translate

PRINTS = ("Bistable::HingeSet", "Bistable::HingeCoupon")
_EXPORTED = (*PRINTS, "Bistable::BistableUnit")
_FIRST = (".3mf", ".stl", ".step")  # what most people send to a printer


class ExportPrint(Command):
    """Write the flat-folded print, or the faces of a tube."""

    name = "Bistable_ExportPrint"
    icon = "ExportPrint"
    text = QT_TRANSLATE_NOOP("Bistable_ExportPrint", "Export print")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_ExportPrint",
        "Write the flat-folded print to a file for the slicer (3MF, STL, STEP) or as a crease "
        "pattern (FOLD, SVG, DXF)",
    )
    shortcut = "O, E"

    def IsActive(self):
        """With something to write."""
        return exported_object() is not None

    def run(self):
        """Ask for a file name and write."""
        obj = exported_object()
        path = ask_for_path(obj)
        if path:
            write(obj, path)


def exported_object():
    """The selected print or tube, else the newest print, else the newest tube."""
    for obj in Gui.Selection.getSelection():
        if type_of(obj) in _EXPORTED:
            return obj
    return next((obj for obj in map(chosen.newest, _EXPORTED) if obj is not None), None)


def ask_for_path(obj):
    """File name for the print of ``obj``, in the folder used last; empty where none is wanted."""
    known = [*_FIRST, *(suffix for suffix in FORMATS if suffix not in _FIRST)]
    filters = [f"{suffix[1:].upper()} (*{suffix})" for suffix in known]
    folder = settings.group().GetString("ExportFolder", str(Path.home()))
    title = translate("Bistable_ExportPrint", "Export print")
    start = str(Path(folder) / f"{obj.Document.Name}-{obj.Label}")
    path, pattern = QtGui.QFileDialog.getSaveFileName(
        Gui.getMainWindow(), title, start, ";;".join(filters)
    )
    if path and Path(path).suffix.lower() not in FORMATS:
        path += known[filters.index(pattern)] if pattern in filters else known[0]
    return path


def write(obj, path):
    """Write ``obj`` to ``path``; what became of it is in the report view."""
    settings.group().SetString("ExportFolder", str(Path(path).parent))
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        Gui.doCommand("from BistableWB.exporters import export")
        Gui.doCommand("doc = App.ActiveDocument")
        Gui.doCommand(f"export({by_name(obj)}, {quoted(str(path))})")
    except ValueError as error:
        App.Console.PrintError(f"{error}\n")
        return
    finally:
        QtGui.QApplication.restoreOverrideCursor()
    size = Path(path).stat().st_size
    text = translate("Bistable_ExportPrint", "{} was written to {} ({} kB).")
    App.Console.PrintMessage(text.format(obj.Label, path, max(1, round(size / 1000))) + "\n")


class Check(Command):
    """Say what is wrong with a print before it is printed."""

    name = "Bistable_Check"
    icon = "Check"
    text = QT_TRANSLATE_NOOP("Bistable_Check", "Check print")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Check",
        "Check the selected hinge set or coupon: closed solids, clearances, overlaps, size of the "
        "print bed",
    )
    shortcut = "O, X"

    def IsActive(self):
        """With a print to check."""
        return checked_object() is not None

    def run(self):
        """Open the panel of the checks."""
        from ..taskpanels.check import CheckPanel

        if not Gui.Control.activeDialog():
            Gui.Control.showDialog(CheckPanel(checked_object()))


def checked_object():
    """The selected print, else the newest one."""
    for obj in Gui.Selection.getSelection():
        if type_of(obj) in PRINTS:
            return obj
    return next((obj for obj in map(chosen.newest, PRINTS) if obj is not None), None)
