# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands about the print: write it to a file, check it, report on it."""

import re
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..exporters import FORMATS
from ..objects import type_of
from ..viewproviders import settings
from . import chosen
from .base import QT_TRANSLATE_NOOP, Command, by_name, is_cancel, print_error, quoted, translate

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
        """Ask for a file name and write; formats with choices of their own ask for these too."""
        from ..taskpanels.export import OPTIONS, ExportPanel

        obj = exported_object()
        path, options = ask_for_path(obj)
        if not path:
            return
        if Path(path).suffix.lower() in OPTIONS and not Gui.Control.activeDialog():
            Gui.Control.showDialog(ExportPanel(obj, path, write))
        else:
            write(obj, path, **options)


def exported_object():
    """The selected print or tube, else the newest print, else the newest tube."""
    for obj in Gui.Selection.getSelection():
        if type_of(obj) in _EXPORTED:
            return obj
    return next((obj for obj in map(chosen.newest, _EXPORTED) if obj is not None), None)


def ask_for_path(obj):
    """File name for ``obj``, in the folder used last, and options; empty where none is wanted."""
    suffixes = [*_FIRST, *(suffix for suffix in FORMATS if suffix not in _FIRST)]
    kinds = {_kind(suffix): (suffix, {}) for suffix in suffixes}
    if hasattr(obj.Proxy, "bodies_at"):
        for state, text in (
            ("deployed", translate("Bistable_ExportPrint", "deployed")),
            ("flat", translate("Bistable_ExportPrint", "flat")),
        ):
            if state == "deployed" or type_of(obj) not in PRINTS:  # which are flat anyway
                for suffix in (*_FIRST, ".obj"):
                    kinds[_kind(suffix, text)] = suffix, {"state": state}
    return _asked(translate("Bistable_ExportPrint", "Export print"), obj, kinds)


def _kind(suffix, state=""):
    """A line of the file dialog's list of formats."""
    return f"{suffix[1:].upper()}{', ' * bool(state)}{state} (*{suffix})"


def _asked(title, obj, kinds):
    """File name, and options of its kind, by ``kinds`` {line of the list: (suffix, options)}.

    The first kind counts where the name has no suffix and no kind was chosen.
    """
    folder = settings.group().GetString("ExportFolder", str(Path.home()))
    name = re.sub(r'[<>:"/\\|?*\x00-\x1f]', "-", obj.Label)  # what some system's file names forbid
    start = str(Path(folder) / f"{obj.Document.Name}-{name}")
    path, chosen = QtGui.QFileDialog.getSaveFileName(
        Gui.getMainWindow(), title, start, ";;".join(kinds)
    )
    suffix, options = kinds.get(chosen) or next(iter(kinds.values()))
    own = Path(path).suffix.lower()
    if path and own not in {known for known, _ in kinds.values()}:
        path += suffix
    return path, options if own in ("", suffix) else {}


def write(obj, path, **options):
    """Export ``obj`` to ``path``; what became of it is in the report view. True if it went well."""
    given = "".join(f", {name}={value!r}" for name, value in options.items())
    return _write(
        obj,
        path,
        "from BistableWB.exporters import export",
        f"export({by_name(obj)}, {quoted(str(path))}{given})",
    )


def _write(obj, path, *lines):
    """Run, and record, lines that write ``path``; say what became of it. True if it went well."""
    settings.group().SetString("ExportFolder", str(Path(path).parent))
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        for line in (f"doc = App.getDocument({quoted(obj.Document.Name)})", *lines):
            Gui.doCommand(line)
    except ValueError as error:
        print_error(error)
        return False
    except RuntimeError as error:
        if not is_cancel(error):
            raise
        text = translate("Bistable", "{}: cancelled, the document is as it was.")
        App.Console.PrintMessage(text.format(Path(path).name) + "\n")
        return False
    finally:
        QtGui.QApplication.restoreOverrideCursor()
    size = Path(path).stat().st_size
    text = translate("Bistable_ExportPrint", "{} was written to {} ({} kB).")
    App.Console.PrintMessage(text.format(obj.Label, path, max(1, round(size / 1000))) + "\n")
    return True


class Report(Command):
    """Everything about a tube or a print on one page."""

    name = "Bistable_Report"
    icon = "Report"
    text = QT_TRANSLATE_NOOP("Bistable_Report", "Report")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Report",
        "Write a report on the selected print or tube, one HTML file with pictures, numbers, "
        "checks and how to make it again, and open it in the browser",
    )
    shortcut = "O, R"

    def IsActive(self):
        """With something to report on."""
        return exported_object() is not None

    def run(self):
        """Ask for a file name, write, and show the page."""
        obj = exported_object()
        kinds = {_kind(".html"): (".html", {})}
        if type_of(obj) == PRINTS[0]:
            with_slicer = translate("Bistable_Report", "with the slicer's comparison (minutes)")
            kinds[_kind(".html", with_slicer)] = ".html", {"with_slicer": True}
        path, options = _asked(translate("Bistable_Report", "Report"), obj, kinds)
        if path:
            report(obj, path, **options)


def report(obj, path, **options):
    """Write the report on ``obj`` to ``path`` and open it; what became of it is in the report view.

    ``options`` as of `document_report.write`. Esc stops it, and leaves a file that is there as it
    was.
    """
    given = "".join(f", {name}={value!r}" for name, value in options.items())
    lines = (
        "from BistableWB import document_report",
        f"document_report.write({by_name(obj)}, {quoted(str(path))}{given})",
    )
    if _write(obj, path, *lines) and not QtGui.QDesktopServices.openUrl(
        QtCore.QUrl.fromLocalFile(str(path))
    ):
        text = translate("Bistable_Report", "No browser could be started: open {} yourself.")
        App.Console.PrintWarning(text.format(path) + "\n")


class Check(Command):
    """Say what is wrong with a print before it is printed."""

    name = "Bistable_Check"
    icon = "Check"
    text = QT_TRANSLATE_NOOP("Bistable_Check", "Check print")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Check",
        "Check the selected hinge set or coupon: size, snap, closed solids, clearances, walls, "
        "layers, overhangs, overlaps",
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
