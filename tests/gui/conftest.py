# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests in FreeCAD's own window: see .ci/in-freecad --gui."""

import contextlib
import subprocess
import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtCore, QtGui

from BistableWB import make, settings
from tests.translations import load

SCREENSHOTS = Path(__file__).resolve().parents[2] / "build" / "screenshots"


def pump(seconds=0.05):
    """Let the window work for a while."""
    end = time.monotonic() + seconds
    while True:
        QtGui.QApplication.processEvents()
        Gui.updateGui()
        if time.monotonic() >= end:
            return
        time.sleep(0.01)


@pytest.fixture(scope="session")
def workbench():
    """The workbench, activated in a window that fills the screen, with tree and properties."""
    window = Gui.getMainWindow()
    window.showFullScreen()
    settings.keep_printer_asked()  # else a question comes up while tests type
    Gui.activateWorkbench("BistableWorkbench")
    pump(0.5)
    return Gui.activeWorkbench()


@pytest.fixture
def gui(workbench):
    """`pump`, with the workbench active, no document open, and nothing left open afterwards."""
    close_documents()
    yield pump
    close_documents()


@pytest.fixture
def unit(gui):
    """A BistableUnit by itself, in a document of its own."""
    doc = App.newDocument("One")
    made = make.make_bistable_unit(doc, theta=45, edge_length=60)
    doc.recompute()
    return made


@pytest.fixture
def headless(tmp_path):
    """``headless(code)``: runs it in a freecadcmd of its own, and gives the lines it printed.

    By a file: freecadcmd 1.1 takes what follows its ``-c`` for the name of a file first, and ends
    where that is longer than a name may be (255 bytes).
    """

    def running(code):
        macro = tmp_path / "headless.py"
        macro.write_text(code)
        short = f"exec(open({str(macro)!r}).read()); import os; os._exit(0)"
        command = ["freecadcmd", "-c", short]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        return done.stdout.splitlines()

    return running


@pytest.fixture
def escape():
    """``with escape(every) as asked``: Esc every so many ms, and Yes to what is asked."""

    @contextlib.contextmanager
    def pressing(every):
        asked = []
        timer = QtCore.QTimer()
        timer.timeout.connect(lambda: _press_escape(asked))
        timer.start(every)
        yield asked
        timer.stop()

    return pressing


def _press_escape(asked):
    box = QtGui.QApplication.activeModalWidget()
    if isinstance(box, QtGui.QMessageBox):
        asked.append(box.text())
        box.button(QtGui.QMessageBox.Yes).click()
        return
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        key = QtGui.QKeyEvent(kind, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier)
        QtGui.QApplication.postEvent(Gui.getMainWindow(), key)


def close_documents():
    """Close every document without asking."""
    for name in list(App.listDocuments()):
        App.closeDocument(name)
    for dock in Gui.getMainWindow().findChildren(QtGui.QDockWidget):
        if dock.windowTitle() == "Report view":
            dock.findChild(QtGui.QTextEdit).clear()
            dock.hide()
    pump()


@pytest.fixture
def screenshot():
    """``screenshot(name)`` writes build/screenshots/VERSION/name.png of the whole screen."""
    folder = SCREENSHOTS / ".".join(App.Version()[:2])
    folder.mkdir(parents=True, exist_ok=True)

    def write(name):
        pump(0.5)
        if not Gui.Control.activeDialog():  # the tree and a panel share their place
            _show_tree()
            pump(0.5)
        picture = QtGui.QApplication.primaryScreen().grabWindow(0)
        assert picture.save(str(folder / f"{name}.png"))
        return picture.toImage()

    return write


def _show_tree():
    """Bring the model's tree to the front and open all its branches."""
    window = Gui.getMainWindow()
    for tabs in window.findChildren(QtGui.QTabBar):
        for index in range(tabs.count()):
            if tabs.tabText(index) == "Model":
                tabs.setCurrentIndex(index)
    for tree in window.findChildren(QtGui.QTreeWidget):
        if tree.inherits("Gui::TreeWidget"):
            tree.expandAll()


def view_colours(path, size=(700, 500)):
    """Colours in the 3D view as a list of (red, green, blue) of its pixels."""
    pump(0.3)
    Gui.ActiveDocument.ActiveView.saveImage(str(path), *size, "White")
    image = QtGui.QImage(str(path))
    assert not image.isNull()
    return [
        image.pixelColor(x, y).getRgb()[:3]
        for x in range(0, image.width(), 2)
        for y in range(0, image.height(), 2)
    ]


class Mouse:
    """Sends what a hand on a mouse makes; positions are QPoints in the widget."""

    LEFT, RIGHT = QtCore.Qt.LeftButton, QtCore.Qt.RightButton

    @staticmethod
    def send(widget, kind, where, button, held):
        where = QtCore.QPointF(where)
        event = QtGui.QMouseEvent(
            kind, where, QtCore.QPointF(widget.mapToGlobal(where.toPoint())), button, held,
            QtCore.Qt.NoModifier,
        )  # fmt: skip
        QtGui.QApplication.sendEvent(widget, event)
        pump(0.05)

    def move(self, widget, where, held=QtCore.Qt.NoButton):
        self.send(widget, QtCore.QEvent.MouseMove, where, QtCore.Qt.NoButton, held)

    def press(self, widget, where, button=QtCore.Qt.LeftButton):
        self.send(widget, QtCore.QEvent.MouseButtonPress, where, button, button)

    def release(self, widget, where, button=QtCore.Qt.LeftButton):
        self.send(widget, QtCore.QEvent.MouseButtonRelease, where, button, QtCore.Qt.NoButton)

    def click(self, widget, where, button=QtCore.Qt.LeftButton):
        self.move(widget, where)
        self.press(widget, where, button)
        self.release(widget, where, button)

    def double_click(self, widget, where):
        self.click(widget, where)
        kind, button = QtCore.QEvent.MouseButtonDblClick, QtCore.Qt.LeftButton
        self.send(widget, kind, where, button, button)
        self.release(widget, where)

    def drag(self, widget, start, end):
        self.move(widget, start)
        self.press(widget, start)
        for share in (0.3, 0.7, 1.0):
            self.move(widget, start + (end - start) * share, QtCore.Qt.LeftButton)
        self.release(widget, end)


@pytest.fixture
def mouse():
    """A `Mouse`."""
    return Mouse()


@pytest.fixture
def pixels(tmp_path):
    """``pixels()``: what the 3D view shows, on white, as a list of (red, green, blue)."""
    return lambda: view_colours(tmp_path / "view.png")


@pytest.fixture(scope="session")
def update():
    return load("update")


@pytest.fixture
def german(gui):
    if not hasattr(Gui, "setLocale"):
        pytest.skip("this FreeCAD cannot change its language from Python")
    Gui.setLocale("German")
    gui(0.3)
    yield gui
    Gui.setLocale("English")
    gui(0.3)
