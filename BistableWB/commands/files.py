# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that open what comes with the workbench: examples and help."""

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import EXAMPLES, RESOURCES
from ..objects import type_of
from .base import QT_TRANSLATE_NOOP, Command, fit_view, quoted, translate

_HELP = RESOURCES / "help"


class OpenExample(Command):
    """A menu of the design files in resources/examples."""

    name = "Bistable_OpenExample"
    icon = "OpenExample"
    text = QT_TRANSLATE_NOOP("Bistable_OpenExample", "Open example")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_OpenExample", "Make one of the example tubes in a document of its own"
    )

    def run(self):
        """Show the names of the examples at the mouse; the chosen one is made."""
        from ..designs import reading

        self.menu = QtGui.QMenu(Gui.getMainWindow())
        for path in examples():
            action = self.menu.addAction(reading.read(path).title)
            action.triggered.connect(lambda checked=False, path=path: make_example(path))
        self.menu.popup(QtGui.QCursor.pos())


def examples():
    """Paths of the design files that come with the workbench."""
    return sorted(EXAMPLES.glob("*.toml"))


def make_example(path):
    """Make the example ``path``, a design file of ours, in a new document, and show it."""
    name = path.stem.title().replace("-", "")
    Gui.doCommand("from BistableWB import EXAMPLES")
    Gui.doCommand("from BistableWB.designs import building, reading")
    Gui.doCommand(f"doc = App.newDocument({quoted(name)})")
    Gui.doCommand(f"building.build(doc, reading.read(EXAMPLES / {quoted(path.name)}))")
    hinges = [obj for obj in App.ActiveDocument.Objects if type_of(obj) == "Bistable::HingeSet"]
    for part in (part for obj in hinges for part in obj.OutListRecursive):
        part.ViewObject.Visibility = False  # the flat print lies where they are
    fit_view(isometric=True)


class ShowHelp(Command):
    """The help page in a window of its own."""

    name = "Bistable_Help"
    icon = "Help"
    text = QT_TRANSLATE_NOOP("Bistable_Help", "Bistable help")
    tip = QT_TRANSLATE_NOOP("Bistable_Help", "Show how to get from a curve to a printed tube")

    def run(self):
        """Show the page; a second call brings it to the front."""
        window = getattr(self, "window", None)
        if window is None:
            self.window = window = _help_window()
        window.show()
        window.raise_()


def help_page():
    """Path of the first page, in FreeCAD's language: a translation names its own page."""
    return _HELP / translate("Bistable_Help", "index.md")


class _Pages(QtGui.QTextBrowser):
    """Shows pages with their pictures as wide as the text."""

    def loadResource(self, kind, url):
        """What a page asks for; pictures that are too wide become smaller."""
        found = super().loadResource(kind, url)
        if kind != QtGui.QTextDocument.ImageResource:
            return found
        image, width = QtGui.QImage(url.toLocalFile()), self.viewport().width() - 90
        smooth = QtCore.Qt.SmoothTransformation
        return image if image.width() <= width else image.scaledToWidth(width, smooth)


def _help_window():
    page = help_page()
    window = QtGui.QDialog(Gui.getMainWindow())
    window.setObjectName("BistableHelp")
    window.setWindowTitle(translate("Bistable_Help", "Bistable workbench: help"))
    window.resize(640, 720)
    browser = _Pages(window)
    browser.ensurePolished()  # a style sheet brings its colours only now
    palette = browser.palette()
    if palette.color(QtGui.QPalette.Text).lightness() > 128:
        palette.setColor(QtGui.QPalette.Link, QtGui.QColor("#7DB7FF"))
        browser.setPalette(palette)
    browser.setOpenExternalLinks(True)
    browser.setSearchPaths([str(page.parent)])
    browser.document().setDocumentMargin(16)
    browser.setSource(QtCore.QUrl.fromLocalFile(str(page)))
    layout = QtGui.QVBoxLayout(window)
    layout.setContentsMargins(0, 0, 0, 0)
    layout.addWidget(browser)
    return window
