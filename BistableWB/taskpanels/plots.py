# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock with charts of a tube: opening angles, ratios, snap margins, unit by unit."""

import contextlib
import math
import re

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..objects import type_of
from ..viewproviders.bodies import bodies_shown
from .charts import MARGIN, RATIO, THETA, BarChart
from .texts import translate

_PANELS_A_UNIT = 12
_HINGES, _UNITS = "Bistable::HingeSet", "Bistable::BistableUnit"


class PlotsDock(QtGui.QDockWidget):
    """Charts of one tube; they follow the document and the selection."""

    def __init__(self, parent):
        super().__init__(translate("BistablePlots", "Tube charts"), parent)
        self.setObjectName("BistablePlots")
        self.obj = None
        body = QtGui.QWidget()
        column = QtGui.QVBoxLayout(body)
        column.setContentsMargins(4, 4, 4, 4)
        self.heading = QtGui.QLabel()
        self.heading.setWordWrap(True)
        column.addWidget(self.heading)
        self.thetas = BarChart(translate("BistablePlots", "Opening angle θ"), THETA, self.pick)
        self.ratios = BarChart(
            translate("BistablePlots", "Ratio c; line: limit sin(θ/2)"),
            RATIO,
            self.pick,
        )
        self.margins = BarChart(
            translate("BistablePlots", "Snap margin; floppy below 1"),
            MARGIN,
            self.pick,
        )
        self.charts = (self.thetas, self.ratios, self.margins)
        for chart in self.charts:
            column.addWidget(chart, 1)
        self.setWidget(body)
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.refresh)
        self.watch = Watch(self)

    # what is shown

    def show_tube(self, obj):
        """Show the charts of a BistableUnit or HingeSet object, of none for None."""
        self.obj = obj
        self.refresh()

    def refresh(self):
        """Read the numbers again."""
        units = _units_below(self.obj)
        if units is None:
            self.heading.setText(translate("BistablePlots", "Select a tube to see its numbers."))
            for chart in self.charts:
                chart.set_values([])
            return
        self.heading.setText(f"<b>{self.obj.Label}</b>")
        thetas = list(units.Triangles.Thetas) if units.Triangles else [units.Theta.Value]
        self.thetas.set_values(thetas, unit="°")
        limits = [math.sin(math.radians(theta) / 2) for theta in thetas]
        self.ratios.set_values(units.Ratios, limits)
        margins = list(getattr(self.obj, "SnapMargins", ()))
        self.margins.set_values(margins, [1.0] * len(margins))
        self.margins.setVisible(bool(margins))

    def refresh_soon(self):
        """Read the numbers when FreeCAD has finished what it does."""
        self._soon.start(50)

    def forget(self):
        """The tube is gone."""
        self.obj = None
        self.refresh_soon()

    # bars and faces

    def pick(self, index):
        """A bar was clicked: its unit is selected in the view."""
        if not is_there(self.obj):
            return
        faces = faces_of_unit(self.obj, index)
        Gui.Selection.clearSelection()
        if faces:
            Gui.Selection.addSelection(self.obj, faces)
        self.choose({index})

    def choose(self, indices):
        """Highlight the bars of some units."""
        for chart in self.charts:
            chart.choose(indices)


class Watch:
    """Tells the dock what FreeCAD tells its observers, which must not be widgets themselves."""

    def __init__(self, dock):
        self.dock = dock
        Gui.Selection.addObserver(self)
        App.addDocumentObserver(self)

    def addSelection(self, document, name, element, point):
        """Something was selected: show its tube, highlight its unit."""
        if not self.dock.isVisible():
            return
        obj = App.getDocument(document).getObject(name)
        if type_of(obj) in (_HINGES, _UNITS):
            if obj is not self.dock.obj:
                self.dock.show_tube(obj)
            if element.startswith("Face"):
                self.dock.choose({unit_of_face(obj, int(element[4:]))} - {None})

    def clearSelection(self, document):
        """Nothing is selected any more."""
        self.dock.choose(set())

    def slotRecomputedDocument(self, document):
        """The numbers may have changed."""
        dock = self.dock
        if dock.isVisible() and is_there(dock.obj) and dock.obj.Document is document:
            dock.refresh_soon()

    def slotDeletedObject(self, obj):
        """The tube may be gone."""
        if obj is self.dock.obj:
            self.dock.forget()

    def slotDeletedDocument(self, document):
        """The tube's document is closed."""
        obj = self.dock.obj
        if obj is not None and (not is_there(obj) or obj.Document is document):
            self.dock.forget()


def is_there(obj):
    """Whether a document object still exists."""
    with contextlib.suppress(ReferenceError, AttributeError):
        return obj is not None and bool(obj.Name)
    return False


def _units_below(obj):
    if not is_there(obj):
        return None
    units = obj.Unit if type_of(obj) == _HINGES else obj
    return units if units is not None and units.isValid() else None


def _body_faces(obj):
    """(units, first face, last face) of the bodies of a HingeSet; units and faces count from 1."""
    first, found = 1, []
    for name, shape in bodies_shown(obj):
        count = shape.countElement("Face")
        units = {int(digits) for digits in re.findall(r"(?:unit|block|_)(\d+)", name)}
        found.append((units, first, first + count - 1))
        first += count
    return found


def faces_of_unit(obj, index):
    """Names of the faces of a unit (counted from 0) of a tube."""
    if type_of(obj) == _UNITS:
        first = _PANELS_A_UNIT * index + 1
        return [f"Face{first + k}" for k in range(_PANELS_A_UNIT)]
    return [
        f"Face{face}"
        for units, first, last in _body_faces(obj)
        if index + 1 in units
        for face in range(first, last + 1)
    ]


def unit_of_face(obj, number):
    """Unit (counted from 0) that a face, counted from 1, belongs to; None where to none."""
    if type_of(obj) == _UNITS:
        return (number - 1) // _PANELS_A_UNIT
    for units, first, last in _body_faces(obj):
        if first <= number <= last and units:
            return min(units) - 1
    return None


def dock():
    """The dock, made when it is asked for first."""
    window = Gui.getMainWindow()
    found = window.findChild(QtGui.QDockWidget, "BistablePlots")
    if found is None:
        found = PlotsDock(window)
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, found)
        found.hide()
    return found
