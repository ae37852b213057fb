# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deployment slider: what it shows and solves, recording, OK and cancel."""

import re
import time

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
from pivy import coin
from PySide import QtCore, QtGui

from BistableWB import make, settings
from BistableWB.objects.bistable_unit import tube_of
from BistableWB.recording.frames import Recorder, has_pillow


def tube_with(units, size=1.0):
    """A tube of so many units along an arch, 420 mm wide or ``size`` of it."""
    doc = App.newDocument("Tube")
    arch = [(0, 0, 0), (60, 240, 0), (360, 240, 0), (420, 0, 0)]
    curve = make.make_curve(doc, points=[(size * x, size * y, z) for x, y, z in arch])
    triangles = make.make_triangle_placement(doc, curve, edge_length=50 * size)
    made = make.make_bistable_unit(doc, triangles)
    doc.recompute()
    triangles.EdgeLength = triangles.EdgeLength.Value * triangles.Count / units
    doc.recompute()
    for _ in range(40):
        if triangles.Count == units:
            break
        triangles.EdgeLength = triangles.EdgeLength.Value * (
            1.01 if triangles.Count > units else 0.993
        )
        doc.recompute()
    assert triangles.Count == units
    Gui.ActiveDocument.ActiveView.viewIsometric()
    Gui.ActiveDocument.ActiveView.fitAll()
    return doc, made


@pytest.fixture
def opened(gui):
    """``opened(obj)``: the panel of the Deploy command on an object."""
    panels = []

    def open_on(obj):
        from BistableWB.taskpanels.deploy import DeployPanel

        Gui.Selection.clearSelection()
        panel = DeployPanel(obj)
        panels.append(panel)
        Gui.Control.showDialog(panel)
        gui(0.2)
        return panel

    yield open_on
    if Gui.Control.activeDialog():
        panels[-1].reject()
        Gui.Control.closeDialog()
        gui()


def nodes_under(root):
    """How many nodes a picture consists of."""
    search = coin.SoSearchAction()
    search.setType(coin.SoNode.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(root)
    return search.getPaths().getLength()


def run_through(panel, solved):
    """Move the slider to and fro, every step drawn; the calls of ``solved`` on the way."""
    before = len(solved)
    for step in (*range(25), *range(24, -1, -1)):
        panel.set_opening(step / 24)
        panel.view.redraw()
        QtGui.QApplication.processEvents()
    return len(solved) - before


def counted(monkeypatch, owner, name):
    """A list that grows with every call of a method of a class."""
    calls, method = [], getattr(owner, name)

    def counting(self, *args):
        calls.append(args)
        return method(self, *args)

    monkeypatch.setattr(owner, name, counting)
    return calls


def test_the_faces_of_24_units_are_solved_once_and_drawn_by_the_same_nodes(
    gui, opened, screenshot, monkeypatch
):
    _, units = tube_with(24)
    solved = counted(monkeypatch, type(tube_of(units)), "state")
    panel = opened(units)
    assert run_through(panel, solved) <= 25
    nodes = nodes_under(panel.motion.root)
    assert run_through(panel, solved) == 0
    assert nodes_under(panel.motion.root) == nodes
    panel.set_opening(0.5)
    screenshot("deploy-faces")


def test_the_slider_shows_the_true_states(gui, opened):
    _, units = tube_with(12)
    panel = opened(units)
    tube = tube_of(units)
    for opening in (0, 0.25, 1):
        panel.slider.setValue(round(1000 * opening))
        drawn = np.array([tuple(p) for p in panel.motion.coordinates.point.getValues()])
        assert drawn == pytest.approx(tube.state(opening).reshape(-1, 3), abs=1e-3)
    between = panel.motion.state(0.3712)
    assert between == pytest.approx(tube.state(0.3712), abs=0.02)


def until(seen, gui, seconds=60):
    """Let the window work until something is seen."""
    end = time.monotonic() + seconds
    while not seen():
        assert time.monotonic() < end
        gui(0.05)


def test_play_runs_to_the_end_and_loops(gui, opened):
    _, units = tube_with(12)
    panel = opened(units)
    panel.set_opening(0.9)
    panel.play_button.click()
    until(lambda: not panel.play_button.isChecked(), gui)
    assert panel.opening == 1
    panel.loop.setChecked(True)
    panel.set_opening(0.95)
    panel.play_button.click()
    until(lambda: 0 < panel.opening < 0.95, gui)  # it has turned round
    panel.play_button.click()
    rest = panel.opening
    gui(0.2)
    assert panel.opening == rest
    assert panel.frame_rate > 0


def shown(obj):
    return obj.ViewObject.SwitchNode.whichChild.getValue()


def test_cancel_restores_and_ok_writes(gui, opened):
    doc, units = tube_with(12)
    steps, children = doc.UndoNames, Gui.ActiveDocument.ActiveView.getSceneGraph().getNumChildren()
    before = shown(units)
    panel = opened(units)
    assert shown(units) == -1
    panel.slider.setValue(300)
    Gui.Control.closeDialog() if panel.reject() else None
    gui()
    assert (units.Deployment, shown(units), doc.UndoNames) == (1, before, steps)
    assert Gui.ActiveDocument.ActiveView.getSceneGraph().getNumChildren() == children
    panel = opened(units)
    panel.slider.setValue(300)
    press_ok(gui)
    assert units.Deployment == pytest.approx(0.3)
    assert shown(units) == before
    assert doc.UndoNames[0] == "Deploy"
    assert units.isValid()


def press_ok(gui):
    box = next(b for b in Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox) if b.isVisible())
    box.button(QtGui.QDialogButtonBox.Ok).click()
    gui(0.2)


def test_misfit_is_coloured(gui, opened, screenshot):
    _, units = tube_with(12)
    panel = opened(units)
    panel.set_opening(0.5)
    panel.colours.setCurrentIndex(1)
    colours = {tuple(c) for c in panel.motion.material.diffuseColor.getValues()}
    assert 1 <= len(colours) <= 12
    assert re.search(r"misfit up to \d+\.\d\d mm \(full colour: \d+\.\d\d mm\)", panel.text.text())
    screenshot("deploy-misfit")
    panel.set_opening(1)
    assert "misfit up to < 0.01 mm" in panel.text.text()  # not the rounding, 1e-14
    panel.set_opening(0.5)
    panel.colours.setCurrentIndex(2)
    strained = [tuple(c) for c in panel.motion.material.diffuseColor.getValues()]
    assert len(strained) == 12 * 12
    assert len(set(strained)) > 20  # panel by panel
    assert "strain up to" in panel.text.text()
    screenshot("deploy-strain")
    panel.set_opening(1)
    relaxed = {tuple(c) for c in panel.motion.material.diffuseColor.getValues()}
    assert len({tuple(np.round(c, 4)) for c in relaxed}) == 1  # both stable states are free of it
    panel.colours.setCurrentIndex(0)
    assert len({tuple(c) for c in panel.motion.material.diffuseColor.getValues()}) == 4


@pytest.fixture
def record(gui):
    """``record(panel)``: record, and wait for the films."""

    def run(panel):
        panel.recorder.button.click()
        until(panel.recorder.button.isEnabled, gui)

    return run


def test_every_recording_has_a_folder_of_its_own_whatever_the_label(
    opened, record, unit, tmp_path, monkeypatch
):
    monkeypatch.setenv("FFMPEG", "no-such-program")
    unit.Label = "Arm 1/2: 50%"
    panel = opened(unit)
    panel.recorder.folder.setText(str(tmp_path / "missing"))
    panel.recorder.button.click()
    assert "There is no folder" in panel.recorder.state.text()
    panel.recorder.folder.setText(str(tmp_path))
    record(panel)
    first = tmp_path / "Arm 1-2- 50%"
    pictures = sorted(first.glob("*.png"))
    assert len(pictures) == 36
    assert not QtGui.QImage(str(pictures[-1])).isNull()
    assert len(list(first.glob("*.gif"))) == has_pillow()
    before = {path: path.read_bytes() for path in first.iterdir()}
    record(panel)
    assert {path: path.read_bytes() for path in first.iterdir()} == before
    assert sorted(path.name for path in tmp_path.iterdir()) == [first.name, f"{first.name} 2"]


def test_the_folder_is_asked_for_once(opened, unit, tmp_path, monkeypatch):
    settings.group().RemString("RecordFolder")
    asked = []

    def answer(*args):
        asked.append(args)
        return "" if len(asked) == 1 else str(tmp_path)

    monkeypatch.setattr(QtGui.QFileDialog, "getExistingDirectory", answer)
    panel = opened(unit)
    panel.recorder.button.click()
    assert len(asked) == 1
    assert list(tmp_path.iterdir()) == []  # no folder, no film
    panel.recorder.button.click()
    panel.recorder.cancel()
    assert settings.group().GetString("RecordFolder") == str(tmp_path)
    assert Recorder(panel).folder.text() == str(tmp_path)


def test_ffmpeg_is_given_every_picture_there_and_back(opened, record, unit, tmp_path, monkeypatch):
    program = tmp_path / "ffmpeg"
    program.write_text('#!/bin/sh\nfor out; do :; done\ncat > "$out"\n')
    program.chmod(0o755)
    monkeypatch.setenv("FFMPEG", str(program))
    panel = opened(unit)
    assert "MP4" in panel.recorder.button.text()
    panel.recorder.folder.setText(str(tmp_path))
    record(panel)
    folder = tmp_path / unit.Label
    pictures = [path.read_bytes() for path in sorted(folder.glob("*.png"))]
    film = (folder / f"{unit.Label}.mp4").read_bytes()
    assert film == b"".join([*pictures, *pictures[-2:0:-1]])
    program.write_text("#!/bin/sh\necho It hurts. >&2\nexit 3\n")
    record(panel)
    assert "ffmpeg made no film: It hurts." in panel.recorder.state.text()
    assert list((tmp_path / f"{unit.Label} 2").glob("*.mp4")) == []


def test_arrow_keys_open_by_one_per_cent(opened, unit):
    panel = opened(unit)
    panel.set_opening(0.5)
    for key in (QtCore.Qt.Key_Right, QtCore.Qt.Key_Right, QtCore.Qt.Key_Left):
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            event = QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier)
            QtGui.QApplication.sendEvent(panel.slider, event)
    assert panel.opening == pytest.approx(0.51)


def test_thick_bodies_move(gui, opened, screenshot, monkeypatch):
    doc, units = tube_with(5, 0.3)
    hinges = make.make_hinge_set(doc, units)
    doc.recompute()
    model = hinges.Proxy.model(hinges)
    panel = opened(hinges)
    solved = counted(monkeypatch, type(model), "motions")
    run_through(panel, solved)
    nodes = nodes_under(panel.motion.root)
    assert run_through(panel, solved) == 0
    assert nodes_under(panel.motion.root) == nodes
    assert shown(units) == shown(hinges) == -1
    panel.set_opening(0.5)
    screenshot("deploy-bodies")
    drawn = np.array(panel.motion.nodes.transforms[20].matrix.getValue().getValue()).T
    assert drawn == pytest.approx(model.motions(0.5)[20], abs=1e-4)
    panel.colours.setCurrentIndex(1)
    assert "mm" in panel.text.text()
    screenshot("deploy-bodies-misfit")
    panel.colours.setCurrentIndex(2)
    known = max(panel.motion.strain(k / 20).max() for k in range(21))
    assert known == pytest.approx(max(model.snap.strain), rel=0.05)
    screenshot("deploy-bodies-strain")


@pytest.fixture
def firm(gui):
    """The HingeSet of one firm unit."""
    doc = App.newDocument("Firm")
    unit = make.make_bistable_unit(doc, theta=55, ratio=0.4865, edge_length=80)
    hinges = make.make_hinge_set(doc, unit)
    doc.recompute()
    gui(0.3)
    return hinges


def measured(panel, gui):
    """Ask the panel how hard it snaps, and wait for it."""
    panel.snapping.measure.click()
    for _ in range(1000):
        gui(0.1)
        if not panel.snapping.measure.is_busy:
            return
    raise AssertionError("it did not end")


def test_the_slider_marks_where_a_unit_moves_on_by_itself(gui, opened, firm, screenshot):
    panel = opened(firm)
    strip = panel.snapping.strip
    assert not strip.isVisible()
    measured(panel, gui)
    assert firm.Barriers[0] > 1
    (stretch,) = strip.stretches
    assert 0.6 < stretch[0] < stretch[1] <= 1
    assert strip.isVisible()
    panel.set_opening(sum(stretch) / 2)
    assert "unit 1 moves on by itself" in panel.text.text()
    screenshot("deploy-unstable")
    panel.set_opening(stretch[0] - 0.02)
    assert "by itself" not in panel.text.text()


def test_the_ghost_shows_how_far_the_deployed_print_moves(gui, opened, firm, screenshot):
    make.measure_snap(firm)
    panel = opened(firm)
    panel.set_opening(1.0)
    panel.snapping.ghost.setChecked(True)
    ghosts = panel.motion.ghosts
    assert ghosts.getNumChildren() == 2
    assert ghosts.whichChild.getValue() == -3  # all of them
    assert f"{firm.EndSlop.Value:.1f} mm" in panel.text.text()
    screenshot("deploy-ghost")
    panel.set_opening(0.5)
    assert ghosts.whichChild.getValue() == -1


def test_a_study_that_is_stopped_leaves_no_results(gui, opened, firm):
    panel = opened(firm)
    button = panel.snapping.measure
    button.click()
    assert button.is_busy
    assert "Stop" in button.text()
    button.click()
    assert not button.is_busy
    gui(0.5)
    assert firm.Barriers == []
    assert "How hard" in button.text()
