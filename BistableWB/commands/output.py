# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands about the print: write it to a file, check it, report on it."""

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import settings
from ..exporters import FORMATS, suffix_of
from ..files import file_name
from ..objects import TYPES, type_of
from ..objects.links import followed
from ..origami.errors import Refusal
from ..origami.progress import Cancelled
from ..scene import chosen
from .base import QT_TRANSLATE_NOOP, Command, by_name, print_error, quoted, translate

PRINTS = tuple(name for name, entry in TYPES.items() if entry.is_print)
_EXPORTED = (*PRINTS, "Bistable::BistableUnit")


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
        return bool(exported_objects())

    def run(self):
        """Ask for a file name and write; formats with choices of their own ask for these too."""
        from ..taskpanels.export import ExportPanel

        objects = exported_objects()
        path, options = ask_for_path(objects[0])
        if not path:
            return
        if FORMATS[suffix_of(Path(path))].panel and not Gui.Control.activeDialog():
            Gui.Control.showDialog(ExportPanel(objects, path, write))
        else:
            write(objects, path, **options)


def exported_objects():
    """All selected prints and tubes, else the newest print, else the newest tube."""
    return _selected(_EXPORTED)


def _selected(types):
    """Selected objects of these types, what a link stands for; else the newest of the first type.

    They are of one document, that of the first.
    """
    picked = [followed(obj) for obj in Gui.Selection.getSelection("*")]
    picked = list(dict.fromkeys(obj for obj in picked if type_of(obj) in types))
    if picked:
        return [obj for obj in picked if obj.Document is picked[0].Document]
    newest = next((obj for obj in map(chosen.newest, types) if obj is not None), None)
    return [] if newest is None else [newest]


def ask_for_path(obj):
    """File name for ``obj``, in the folder used last, and options; empty where none is wanted."""
    kinds = {_kind(suffix): (suffix, {}) for suffix in FORMATS}
    shapes = [s for s, entry in FORMATS.items() if entry.has_states and not entry.same_as]
    if hasattr(obj.Proxy, "bodies_at"):
        for state, text in (
            ("deployed", translate("Bistable_ExportPrint", "deployed")),
            ("flat", translate("Bistable_ExportPrint", "flat")),
        ):
            if state == "deployed" or type_of(obj) not in PRINTS:  # which are flat anyway
                for suffix in shapes:
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
    start = str(Path(folder) / f"{obj.Document.Name}-{file_name(obj.Label)}")
    path, chosen = QtGui.QFileDialog.getSaveFileName(
        Gui.getMainWindow(), title, start, ";;".join(kinds)
    )
    suffix, options = kinds.get(chosen) or next(iter(kinds.values()))
    own = suffix_of(Path(path))
    if path and own not in {known for known, _ in kinds.values()}:
        path += suffix
    return path, options if own in ("", suffix) else {}


def write(objects, path, **options):
    """Export one object or a list; the report view says what became of it. True if it went well."""
    objects = _listed(objects)
    given = "".join(f", {name}={value!r}" for name, value in options.items())
    return _write(
        objects,
        path,
        "from BistableWB.exporters import export",
        f"export({_names(objects)}, {quoted(str(path))}{given})",
    )


def _listed(objects):
    return objects if isinstance(objects, list) else [objects]


def _names(objects):
    """The Python expression of one object, or of a list of them."""
    names = ", ".join(map(by_name, objects))
    return names if len(objects) == 1 else f"[{names}]"


def _write(objects, path, *lines):
    """Run, and record, lines that write ``path``; say what became of it. True if it went well."""
    settings.group().SetString("ExportFolder", str(Path(path).parent))
    QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        for line in (f"doc = App.getDocument({quoted(objects[0].Document.Name)})", *lines):
            Gui.doCommand(line)
    except Refusal as error:
        print_error(error)
        return False
    except Cancelled:
        text = translate("Bistable", "{}: cancelled, the document is as it was.")
        App.Console.PrintMessage(text.format(Path(path).name) + "\n")
        return False
    finally:
        QtGui.QApplication.restoreOverrideCursor()
    size = Path(path).stat().st_size
    labels = ", ".join(obj.Label for obj in objects)
    text = translate("Bistable_ExportPrint", "{} was written to {} ({} kB).")
    App.Console.PrintMessage(text.format(labels, path, max(1, round(size / 1000))) + "\n")
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
        return bool(exported_objects())

    def run(self):
        """Ask for a file name, write, and show the page."""
        objects = exported_objects()
        kinds = {_kind(".html"): (".html", {})}
        if any(type_of(obj) == PRINTS[0] for obj in objects):
            with_slicer = translate("Bistable_Report", "with the slicer's comparison (minutes)")
            kinds[_kind(".html", with_slicer)] = ".html", {"with_slicer": True}
        path, options = _asked(translate("Bistable_Report", "Report"), objects[0], kinds)
        if path:
            report(objects, path, **options)


def report(objects, path, **options):
    """Write the report on one object or a list to ``path``, and open it.

    ``options`` as of `document_report.write`. Esc stops it, and leaves a file that is there as it
    was.
    """
    objects = _listed(objects)
    given = "".join(f", {name}={value!r}" for name, value in options.items())
    lines = (
        "from BistableWB import document_report",
        f"document_report.write({_names(objects)}, {quoted(str(path))}{given})",
    )
    if _write(objects, path, *lines) and not QtGui.QDesktopServices.openUrl(
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
        return bool(_selected(PRINTS))

    def run(self):
        """Open the panel of the checks."""
        from ..taskpanels.check import CheckPanel, CheckPanels

        if Gui.Control.activeDialog():
            return
        panels = [CheckPanel(obj) for obj in _selected(PRINTS)]
        Gui.Control.showDialog(panels[0] if len(panels) == 1 else CheckPanels(panels))
