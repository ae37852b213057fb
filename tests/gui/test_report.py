# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report command: what it writes, opens, says and records."""

import sys

import FreeCADGui as Gui
import pytest
from PySide import QtGui

from BistableWB import make
from BistableWB.commands import output
from BistableWB.origami.errors import Refusal


@pytest.fixture
def browser(monkeypatch):
    """Paths that were to be opened in a browser; ``browser.works`` says whether there is one."""

    class Browser(list):
        works = True

    opened = Browser()

    def open_url(url):
        opened.append(url.toLocalFile())
        return opened.works

    monkeypatch.setattr(QtGui.QDesktopServices, "openUrl", open_url)
    monkeypatch.setitem(sys.modules, "matplotlib", None)  # pictures take long, and are tested
    return opened


def test_the_report_is_written_opened_and_recorded(unit, browser, monkeypatch, tmp_path, capfd):
    recorded, do_command = [], Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (recorded.append(line), do_command(line)))
    target = tmp_path / "my report"
    monkeypatch.setattr(
        QtGui.QFileDialog, "getSaveFileName", lambda *_: (str(target), "HTML (*.html)")
    )
    Gui.runCommand("Bistable_Report")
    written = target.with_suffix(".html")
    assert browser == [str(written)]
    assert "theta = 45" in written.read_text(encoding="utf-8")
    assert "was written to" in capfd.readouterr().out
    written.unlink()
    exec("import FreeCAD as App\n" + "\n".join(recorded), {})
    assert written.exists()


def test_without_a_browser_the_report_view_says_so(unit, browser, tmp_path, capfd):
    browser.works = False
    output.report(unit, tmp_path / "x.html")
    assert (tmp_path / "x.html").exists()
    assert "No browser could be started" in capfd.readouterr().err


def test_a_report_that_cannot_be_says_why(unit, browser, tmp_path, capfd):
    output.report(unit, tmp_path / "missing" / "x.html")
    assert "There is no folder" in capfd.readouterr().err
    assert browser == []


@pytest.mark.provokes_errors
def test_escape_cancels_a_report(unit, browser, escape, gui, tmp_path, capfd):
    hinges = make.make_hinge_set(unit.Document, unit)
    unit.Document.recompute()
    path = tmp_path / "x.html"
    path.write_text("old")

    with escape(100):
        output.report(hinges, path)
    gui(0.2)
    assert "cancelled" in capfd.readouterr().out
    assert path.read_text() == "old"
    assert browser == []


def test_the_slicer_is_asked_where_that_kind_of_report_was_chosen(
    unit, browser, monkeypatch, tmp_path, capfd
):
    hinges = make.make_hinge_set(unit.Document, unit)
    hinges.Segmentations = 3
    unit.Document.recompute()
    told = []

    def compare(obj, progress, **_):
        for _ in range(50):  # as often as a slicer that runs for some seconds
            progress.step("slicing flat-folded")
        told.append(obj)
        raise Refusal("there is no slicer here.")

    monkeypatch.setattr("BistableWB.slicing.compare", compare)
    target = tmp_path / "sliced.html"
    monkeypatch.setattr(
        QtGui.QFileDialog,
        "getSaveFileName",
        lambda *given: (str(target), given[3].split(";;")[1]),
    )
    Gui.Selection.addSelection(hinges)
    Gui.runCommand("Bistable_Report")
    assert told == [hinges]
    page = target.read_text(encoding="utf-8")
    assert "slicer = true" in page
    assert "slicer: there is no slicer here." in page
