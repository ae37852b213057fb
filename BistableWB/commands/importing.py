# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves and units out of files of other programs and of our own."""

from pathlib import Path

import FreeCADGui as Gui
from PySide import QtGui

from .. import imports
from ..viewproviders import settings
from .base import QT_TRANSLATE_NOOP, Command, Script, fit_view, print_error, quoted, translate

_FOLD = ".fold"
_LISTED = 20  # curves of a file that are offered


class Import(Command):
    """A curve from a drawing or a table of points, or units from a FOLD file."""

    name = "Bistable_Import"
    icon = "Import"
    text = QT_TRANSLATE_NOOP("Bistable_Import", "Import curve")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Import",
        "Make a curve from an SVG, DXF or CSV file, or units from a FOLD file of this workbench",
    )
    shortcut = "O, I"

    def run(self):
        """Ask for a file and import it; of several curves one is chosen from a menu."""
        patterns = " ".join(f"*{suffix}" for suffix in (*imports.SUFFIXES, _FOLD))
        kinds = translate("Bistable_Import", "Curves and units ({})").format(patterns)
        folder = settings.group().GetString("ExportFolder", str(Path.home()))
        title = translate("Bistable_Import", "Import curve")
        path, _ = QtGui.QFileDialog.getOpenFileName(Gui.getMainWindow(), title, folder, kinds)
        if path:
            self.menu = import_file(path)


def import_file(path):
    """Import a file; returns the menu that asks which of several curves, None where none is asked.

    What is wrong with the file is in the report view.
    """
    try:
        if Path(path).suffix.lower() == _FOLD:
            _import_units(path, imports.unit_count(path))
            return None
        found = imports.curves_in(path)
    except ValueError as error:
        print_error(error)
        return None
    if len(found) == 1:
        _import_curve(path, found[0].kind)
        return None
    menu = QtGui.QMenu(Gui.getMainWindow())
    for number, curve in enumerate(found[:_LISTED], 1):
        text = translate("Bistable_Import", "Curve {}: {:.4g} mm").format(number, curve.length)
        menu.addAction(text).triggered.connect(
            lambda checked=False, number=number, kind=curve.kind: _import_curve(path, kind, number)
        )
    menu.popup(QtGui.QCursor.pos())
    return menu


def _import_curve(path, kind, number=None):
    chosen = f", number={number}" if number else ""
    with Script(translate("Bistable_Import", "Import curve")) as script:
        script.add("from BistableWB import imports")
        script.add(f"curve = imports.import_curve(doc, {quoted(path)}, {quoted(kind)}{chosen})")
        script.view("Gui.Selection.clearSelection()")
        script.view("Gui.Selection.addSelection(curve)")
    fit_view()


def _import_units(path, count):
    numbers = f"range(1, {count + 1})" if count > 1 else "[1]"
    with Script(translate("Bistable_Import", "Import units")) as script:
        script.add("from BistableWB import imports")
        script.add(f"for k in {numbers}: imports.import_fold(doc, {quoted(path)}, k)")
    fit_view(isometric=True)
