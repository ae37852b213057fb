# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock with charts of a tube: angles, ratios, snap margins and energy, unit by unit."""

import math

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

from ..language.labels import translate
from ..language.words import in_words
from ..objects import type_of
from ..origami.snap.margin import energy_path
from ..scene.shown import bodies_shown
from .aiming import AimRow
from .base import is_there
from .charts import CHOSEN, MARGIN, RATIO, THETA, WEAKEST, BarChart, LineChart
from .measure import MeasureButton

_PANELS_A_UNIT = 12
_HINGES, _UNITS = "Bistable::HingeSet", "Bistable::BistableUnit"
_STEADY = 1.2  # safety factor that is enough
_MOST_SAFE = 10.0  # safety factors are drawn to here
_STEPS = 60  # of the energy's path
_LISTED = 12  # units that the heading names
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


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
        self.barriers = BarChart(
            translate("BistablePlots", "Energy that opening takes, N·mm"), THETA, self.pick
        )
        self.safety = BarChart(
            translate("BistablePlots", "Safety under its own weight; folds below 1"),
            MARGIN,
            self.pick,
        )
        self.energy = EnergyChart()
        self.charts = (self.thetas, self.ratios, self.margins, self.barriers, self.safety,
                       self.energy)  # fmt: skip
        for chart in self.charts:
            column.addWidget(chart, 1)
        self.measure = MeasureButton(self._measured)
        self.aim = AimRow(self._measured)
        column.addWidget(self.measure)
        column.addWidget(self.aim)
        self.setWidget(body)
        self._soon = QtCore.QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self.refresh)
        self.watch = Watch(self)

    # what is shown

    def show_tube(self, obj):
        """Show the charts of a BistableUnit or HingeSet object, of none for None."""
        self.obj = obj
        self.measure.ask_about(obj)
        self.aim.ask_about(obj)
        self.refresh()

    def refresh(self):
        """Read the numbers again."""
        units = _units_below(self.obj)
        if units is None:
            self.heading.setText(translate("BistablePlots", "Select a tube to see its numbers."))
            for chart in self.charts[:-1]:
                chart.set_values([])
            self.energy.set_units([], [])
            return
        self.heading.setText(f"<b>{self.obj.Label}</b>")
        thetas = list(units.Triangles.Thetas) if units.Triangles else [units.Theta.Value]
        self.thetas.set_values(thetas, unit="°")
        limits = [math.sin(math.radians(theta) / 2) for theta in thetas]
        self.ratios.set_values(units.Ratios, limits)
        margins = list(getattr(self.obj, "SnapMargins", ()))
        self.margins.set_values(margins, [1.0] * len(margins))
        self.margins.setVisible(bool(margins))
        self._show_strength(bool(margins))
        self.energy.set_units(units.Alphas, units.Betas, margins)

    def _show_strength(self, is_print):
        """Results of the measurement, once known, or the button that asks for them."""
        barriers = list(getattr(self.obj, "Barriers", ())) if is_print else []
        factors = [min(f, _MOST_SAFE) for f in self.obj.SafetyFactors] if barriers else []
        self.barriers.set_values(barriers)
        self.safety.set_values(factors, [1.0] * len(factors))
        for chart in (self.barriers, self.safety):
            chart.setVisible(bool(barriers))
        self.measure.setVisible(is_print and not barriers)
        self.aim.setVisible(is_print)
        if factors:
            said = [self.heading.text(), _order(self.obj), _weakest(self.obj)]
            self.heading.setText("<br>".join(each for each in said if each))

    def _measured(self, error):
        """The strength of the tube that is shown is known; what cannot be is said."""
        self.refresh()
        if error is not None:
            self.heading.setText(in_words(error))

    def refresh_soon(self):
        """Read the numbers when FreeCAD has finished what it does."""
        self._soon.start(50)

    def forget(self):
        """The tube is gone."""
        self.obj = None
        self.measure.ask_about(None)
        self.aim.ask_about(None)
        self.refresh_soon()

    # bars and faces

    def pick(self, index):
        """A bar was clicked: its unit is selected in the view."""
        if not is_there(self.obj):
            return
        elements = elements_of_unit(self.obj, index)
        Gui.Selection.clearSelection()
        if elements:
            Gui.Selection.addSelection(self.obj, elements)
        self.choose({index})

    def choose(self, indices):
        """Highlight the bars of some units."""
        for chart in self.charts:
            chart.choose(indices)


def _weakest(obj):
    """Which unit gives way first under the tube's weight, and what helps if that is too soon."""
    factors = list(obj.SafetyFactors)
    least = min(factors)
    said = translate(
        "BistablePlots", "Unit {unit} gives way first, at {factor:.1f} times its load."
    )
    if least < _STEADY:
        said = translate(
            "BistablePlots", "Unit {unit} gives way first, at {factor:.1f} times its load: aim at "
            "more, make edges longer, the tube shorter, or hold both ends."
        )  # fmt: skip
    return said.format(unit=factors.index(least) + 1, factor=least)


def _order(obj):
    """In which order the units open: the weakest first."""
    forces = list(obj.HandForces)
    if len(forces) < 2:
        return ""
    order = [k + 1 for k in sorted(range(len(forces)), key=forces.__getitem__)]
    shown = ", ".join(map(str, order[:_LISTED])) + (" …" if len(order) > _LISTED else "")
    said = translate("BistablePlots", "Units open in this order: {order}; {force:.1f} N the first.")
    return said.format(order=shown, force=min(forces))


class EnergyChart(LineChart):
    """Energy on the way from flat to deployed: of the weakest unit, and of those that are chosen.

    Behind them a band from the weakest to the strongest of all units.
    """

    def __init__(self):
        super().__init__("", translate("BistablePlots", "opening: flat to deployed"))
        self.unit_across = "%"
        self.set_units([], [])

    def set_units(self, alphas, betas, margins=()):
        """Show units of these angles (degrees); the weakest one has the least snap margin.

        Without margins, which are of thick panels, it has the least energy barrier.
        """
        self.fractions, self.energies = [], np.zeros((0, _STEPS))
        if len(alphas):
            self.fractions, self.energies = energy_path(
                np.radians(alphas), np.radians(betas), _STEPS
            )
            known = margins if len(margins) == len(alphas) else self.energies.max(1)
            self.weakest = int(np.argmin(known))
        self.choose({k for k in self.chosen if k < len(alphas)})

    def choose(self, indices):
        """Show these units beside the weakest one."""
        super().choose(indices)
        if not len(self.energies):
            self.title = translate("BistablePlots", "Energy")
            self.set_lines([], [])
            return
        power = math.floor(math.log10(max(self.energies.max(), 1e-300)))
        scale = "10" + str(power).translate(_SUPERSCRIPTS)
        self.title = translate("BistablePlots", "Energy, {} EA·‖AB‖").format(scale)
        scaled = self.energies / 10.0**power
        lines = [(self._name(k), scaled[k], CHOSEN) for k in sorted(self.chosen - {self.weakest})]
        colour = CHOSEN if self.weakest in self.chosen else WEAKEST
        lines.append((self._name(self.weakest), scaled[self.weakest], colour))
        band = (scaled.min(0), scaled.max(0)) if len(scaled) > 1 else None
        self.set_lines([100 * f for f in self.fractions], lines, band)

    def _name(self, index):
        if index != self.weakest or len(self.energies) == 1:
            return translate("BistablePlots", "unit {}").format(index + 1)
        return translate("BistablePlots", "weakest: unit {}").format(index + 1)


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
            if element:
                self.dock.choose({unit_of_element(obj, element)} - {None})

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


def _units_below(obj):
    if not is_there(obj):
        return None
    units = obj.Unit if type_of(obj) == _HINGES else obj
    return units if units is not None and units.isValid() else None


def elements_of_unit(obj, index):
    """Names of what shows a unit (counted from 0) of a tube: faces of panels, or whole bodies."""
    if type_of(obj) == _UNITS:
        first = _PANELS_A_UNIT * index + 1
        return [f"Face{first + k}" for k in range(_PANELS_A_UNIT)]
    return [body.element for body in bodies_shown(obj) if index + 1 in body.units]


def unit_of_element(obj, element):
    """Unit (counted from 0) that an element belongs to; None where to none."""
    if type_of(obj) == _UNITS:
        is_face = element.startswith("Face")
        return (int(element[4:]) - 1) // _PANELS_A_UNIT if is_face else None
    units = {body.element: body.units for body in bodies_shown(obj)}.get(element)
    return min(units) - 1 if units else None


def dock():
    """The dock, made when it is asked for first."""
    window = Gui.getMainWindow()
    found = window.findChild(QtGui.QDockWidget, "BistablePlots")
    if found is None:
        found = PlotsDock(window)
        window.addDockWidget(QtCore.Qt.RightDockWidgetArea, found)
        found.hide()
    return found
