# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock with charts: numbers, clicks on bars, selection, changes."""

from types import SimpleNamespace

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
from PySide import QtGui

from BistableWB import make


@pytest.fixture
def charts(gui):
    from BistableWB.taskpanels.plots import dock

    Gui.runCommand("Bistable_NewTube")
    Gui.runCommand("Bistable_Plots")
    gui(0.3)
    yield dock()
    dock().hide()


def test_charts_show_the_numbers_and_follow(gui, charts, screenshot):
    doc = App.ActiveDocument
    assert charts.isVisible()
    assert charts.obj is doc.BistableUnit
    assert charts.thetas.values == list(doc.TrianglePlacement.Thetas)
    assert charts.ratios.values == list(doc.BistableUnit.Ratios)
    assert not charts.margins.isVisible()
    doc.TrianglePlacement.EdgeLength = 55
    doc.recompute()
    gui(0.3)
    assert charts.thetas.values == list(doc.TrianglePlacement.Thetas)
    charts.pick(4)
    screenshot("charts")


def test_a_click_on_a_bar_selects_its_unit_and_back(gui, charts, mouse):
    doc = App.ActiveDocument
    mouse.click(charts.thetas, charts.thetas.centre_of(4))
    (picked,) = Gui.Selection.getSelectionEx()
    assert picked.Object is doc.BistableUnit
    assert set(picked.SubElementNames) == {f"Face{k}" for k in range(49, 61)}
    assert charts.ratios.chosen == {4}
    Gui.Selection.clearSelection()
    assert charts.ratios.chosen == set()
    Gui.Selection.addSelection(doc.BistableUnit, "Face30")
    gui()
    assert charts.thetas.chosen == {2}


def test_energy_is_of_the_weakest_unit_and_of_those_chosen(gui, charts, screenshot):
    units = App.ActiveDocument.BistableUnit
    weakest = int(np.argmin(units.Barriers))
    (line,) = charts.energy.lines
    assert line[0] == f"weakest: unit {weakest + 1}"
    factor = 10.0 ** np.floor(np.log10(max(units.Barriers)))  # of the scale, in the title
    assert max(line[1]) * factor == pytest.approx(units.Barriers[weakest], rel=1e-2)
    assert (line[1][0], line[1][-1]) == pytest.approx((0, 0), abs=1e-9)
    other = int(np.argmax(units.Barriers))
    charts.pick(other)
    named = {name: max(ys) * factor for name, ys, _ in charts.energy.lines}
    assert named[f"unit {other + 1}"] == pytest.approx(max(units.Barriers), rel=1e-2)
    assert len(named) == 2
    screenshot("charts-energy")


def test_charts_in_a_dark_theme(gui, charts, screenshot):
    palette = QtGui.QPalette(charts.palette())
    palette.setColor(QtGui.QPalette.Window, QtGui.QColor("#2b2b2b"))
    palette.setColor(QtGui.QPalette.WindowText, QtGui.QColor("#eeeeee"))
    old = charts.palette()
    charts.setPalette(palette)
    charts.setAutoFillBackground(True)
    screenshot("charts-dark")
    image = charts.thetas.grab().toImage()
    light = [
        image.pixelColor(x, y).lightness() for x in range(0, image.width(), 2) for y in range(20)
    ]
    assert max(light) > 200  # the title can be read
    charts.setPalette(old)


def test_charts_of_thick_bodies(gui, charts):
    doc = App.newDocument("One")
    units = make.make_bistable_unit(doc, theta=45, edge_length=60)
    hinges = make.make_hinge_set(doc, units)
    doc.recompute()
    charts.show_tube(hinges)
    assert charts.thetas.values == [45]
    assert [name for name, _, _ in charts.energy.lines] == ["unit 1"]
    charts.pick(0)
    (picked,) = Gui.Selection.getSelectionEx()
    assert picked.Object is hinges
    assert set(picked.SubElementNames) == {f"Solid{k + 1}" for k in range(hinges.BodyCount)}


def test_charts_survive_the_end_of_their_tube(gui, charts):
    App.closeDocument(App.ActiveDocument.Name)
    gui(0.3)
    assert charts.obj is None
    assert charts.thetas.values == []
    assert charts.energy.lines == []
    charts.refresh()


def test_charts_of_hinges_without_play_are_drawn(gui, charts):
    """Their snap margins are infinite."""
    doc = App.newDocument("Soft")
    units = make.make_bistable_unit(doc, theta=45, edge_length=60)
    hinges = make.make_hinge_set(doc, units, hinge_type="Flexible")
    doc.recompute()
    charts.show_tube(hinges)
    assert charts.margins.values == [np.inf]
    gui(0.3)
    middle = charts.margins.centre_of(0)
    assert charts.margins.grab().toImage().pixelColor(middle) == charts.margins.colour


def test_aiming_at_a_force_gives_the_unit_its_margin_in_one_step(gui, charts):
    from BistableWB.taskpanels.aiming import AimRow

    doc = App.newDocument("Aim")
    unit = make.make_bistable_unit(doc, theta=55, ratio=0.49, edge_length=80)
    unit.Thickness = 1.8
    hinges = make.make_hinge_set(doc, unit)
    doc.recompute()
    errors = []
    row = AimRow(errors.append)
    row.ask_about(hinges)
    row.kind.setCurrentIndex(1)
    row.number.setValue(1.0)
    row.button.click()
    for _ in range(600):
        gui(0.2)
        if errors:
            break
    assert errors == [None]
    assert unit.RatioRule == "TargetSnap"
    assert len(unit.UnitMargins) == 1
    assert doc.UndoNames[0] == "Aim the snap"
    make.measure_snap(hinges)
    assert hinges.HandForces[0] > 0.9
    unit.TargetMargin = 1.6  # whoever sets one for all means it
    assert list(unit.UnitMargins) == []


def test_the_heading_says_in_which_order_units_open(gui):
    """The weakest first."""
    from BistableWB.taskpanels.plots import _order

    said = _order(SimpleNamespace(HandForces=[2.0, 1.04, 3.0]))
    assert said == "Units open in this order: 2, 1, 3; 1.0 N the first."
    assert _order(SimpleNamespace(HandForces=[2.0])) == ""
