# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves and units out of files of other programs and of our own.

Readers and panel are imported when somebody imports a file: not when the workbench starts.
"""

from functools import partial
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui

from .. import settings
from ..origami.errors import Refusal
from .base import QT_TRANSLATE_NOOP, Command, Script, fit_view, print_error, quoted, translate

_FOLD = ".fold"


class Import(Command):
    """A curve from a drawing or a table of points, or units from a FOLD file."""

    name = "Bistable_Import"
    icon = "Import"
    text = QT_TRANSLATE_NOOP("Bistable_Import", "Import curve")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Import",
        "Make a curve from a drawing (SVG, DXF), a model (Rhino, STEP, IGES) or a table of points "
        "(CSV), or units from a FOLD file of this workbench",
    )
    shortcut = "O, I"

    def run(self):
        """Ask for a file and show its curves in a panel."""
        from .. import imports

        patterns = " ".join(f"*{suffix}" for suffix in (*imports.SUFFIXES, _FOLD))
        kinds = translate("Bistable_Import", "Curves and units ({})").format(patterns)
        folder = settings.group().GetString("ExportFolder", str(Path.home()))
        title = translate("Bistable_Import", "Import curve")
        path, _ = QtGui.QFileDialog.getOpenFileName(Gui.getMainWindow(), title, folder, kinds)
        if path:
            import_file(path)


def import_file(path):
    """Import a file; returns the panel that shows its curves, None where there is none to show.

    What is wrong with the file is in the report view.
    """
    from .. import imports

    try:
        if Path(path).suffix.lower() == _FOLD:
            _import_units(path, imports.unit_count(path))
            return None
        first = imports.curves_in(path)
    except Refusal as error:
        if error.parameter != "scale":  # else the panel asks for one
            print_error(error)
            return None
        first = None
    if Gui.Control.activeDialog():
        text = translate("Bistable_Import", "{}: close the panel that is open, then import it.")
        print_error(text.format(Path(path).name))
        return None
    panel = _panel(path, first)
    Gui.Control.showDialog(panel)
    return panel


def _panel(path, first):
    from ..taskpanels.import_curve import ImportPanel

    made = _document()
    return ImportPanel(
        path, partial(_read, path, first), partial(_import_curves, path), partial(_forget, made)
    )


def _document():
    """The name of a document that had to be made: FreeCAD 1.1 shows no panel without one."""
    if App.ActiveDocument is not None:
        return None
    Gui.doCommand('App.newDocument("BistableTube")')
    return App.ActiveDocument.Name


def _forget(name):
    """Close a document that was made for a panel that was cancelled."""
    if name in App.listDocuments() and not App.getDocument(name).Objects:
        App.closeDocument(name)


def _read(path, first, scale, join):
    """Curves of a file; those that were read ``first`` where nothing is asked for beyond that."""
    from .. import imports

    plain = scale is None and first is not None and abs(join - first.receipt.join) < 1e-9
    return first if plain else imports.curves_in(path, scale=scale, join=join)


def _import_curves(path, numbers, scale, join, radius, curves):
    """Make the curves of these numbers in one step; True where that went well."""
    from .. import imports

    options = f", scale={scale:.9g}" if scale is not None else ""
    options += f", join={join:.9g}" if abs(join - imports.JOIN) > 1e-9 else ""
    title = translate("Bistable_Import", "Import curve")
    with Script(title) as script:
        script.add("from BistableWB import imports")
        script.view("Gui.Selection.clearSelection()")
        for number in numbers:
            chosen = f", number={number}" if len(curves) > 1 else ""
            kind = quoted(curves[number - 1].kind)
            script.add(
                f"curve = imports.import_curve(doc, {quoted(path)}, {kind}{chosen}{options})"
            )
            if radius:
                script.add(f"curve.CornerRadius = {radius:.9g}")
            script.view("Gui.Selection.addSelection(curve)")
    fit_view()
    return script.done


def _import_units(path, count):
    numbers = f"range(1, {count + 1})" if count > 1 else "[1]"
    with Script(translate("Bistable_Import", "Import units")) as script:
        script.add("from BistableWB import imports")
        script.add(f"for k in {numbers}: imports.import_fold(doc, {quoted(path)}, k)")
    fit_view(isometric=True)
