# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tests in FreeCAD's own window: see .ci/in-freecad --gui."""

import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtCore, QtGui

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
    """The workbench, activated in a window of known size with tree and properties shown."""
    window = Gui.getMainWindow()
    window.setGeometry(0, 0, 1400, 900)
    Gui.activateWorkbench("BistableWorkbench")
    pump(0.5)
    return Gui.activeWorkbench()


@pytest.fixture
def gui(workbench):
    """`pump`, with the workbench active, no document open and nothing left open afterwards."""
    close_documents()
    yield pump
    close_documents()


def close_documents():
    """Close every document without asking."""
    for name in list(App.listDocuments()):
        App.closeDocument(name)
    pump()


@pytest.fixture
def screenshot(request):
    """``screenshot(name, widget=None)`` writes build/screenshots/VERSION/name.png."""
    folder = SCREENSHOTS / ".".join(App.Version()[:2])
    folder.mkdir(parents=True, exist_ok=True)

    def write(name, widget=None):
        pump(1.0)
        path = folder / f"{name}.png"
        picture = (widget or Gui.getMainWindow()).grab()
        if widget is None:
            _paint_view(picture)
        assert picture.save(str(path))
        return picture.toImage()

    return write


def _paint_view(picture):
    """Put the 3D view into ``picture``: an OpenGL surface is not part of a widget's grab."""
    window = Gui.getMainWindow()
    for area in window.findChildren(QtGui.QMdiArea):
        view = area.activeSubWindow()
        if view is None or Gui.ActiveDocument is None:
            continue
        surface = next((w for w in view.findChildren(QtGui.QWidget) if _is_gl(w)), None)
        if surface is None:
            continue
        size = surface.size()
        file = SCREENSHOTS / "view.png"
        Gui.ActiveDocument.ActiveView.saveImage(str(file), size.width(), size.height(), "Current")
        corner = surface.mapTo(window, QtCore.QPoint(0, 0))
        painter = QtGui.QPainter(picture)
        painter.drawImage(corner, QtGui.QImage(str(file)))
        painter.end()
        file.unlink()


def _is_gl(widget):
    return widget.inherits("QOpenGLWidget") or widget.inherits("QGLWidget")
