# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours, tree, overlay, and all of them after save and reopen."""

import FreeCAD as App
import FreeCADGui as Gui
import pytest

from BistableWB import ICONS, colours, make
from BistableWB.origami.units.creases import PANELS, kind_of
from BistableWB.scene import faces
from BistableWB.viewproviders import attach_missing


@pytest.fixture
def tube(gui):
    Gui.runCommand("Bistable_NewTube")
    gui()
    return App.ActiveDocument


def assert_coloured_by_kind(unit):
    shown = faces.face_colours(unit.ViewObject)
    assert len(shown) == len(unit.Shape.Faces) > 0
    kinds = [kind_of(panel) for panel in PANELS]
    for index, colour in enumerate(shown):
        expected = colours.rgb(colours.PANELS[kinds[index % len(kinds)]])
        assert colour == pytest.approx(expected, abs=0.01)
    assert len(set(shown)) == 4


def assert_drawn_in_colours(pixels):
    """Orange and blue panels are really drawn, not only set (FreeCAD 0.20 forgets to)."""
    seen = pixels()
    drawn = [p for p in seen if min(p) < 250]
    orange = [p for p in drawn if p[0] - p[2] > 50 and p[0] > p[1]]
    blue = [p for p in drawn if p[2] - p[0] > 30]
    assert len(drawn) > 2000
    assert len(orange) > 0.2 * len(drawn)
    assert len(blue) > 0.1 * len(drawn)


def test_faces_are_coloured_by_panel_kind(tube, pixels):
    assert_coloured_by_kind(tube.BistableUnit)
    assert_drawn_in_colours(pixels)


def test_colours_follow_the_number_of_faces(gui, tube, pixels):
    before = len(tube.BistableUnit.Shape.Faces)
    tube.TrianglePlacement.EdgeLength = 55
    tube.recompute()
    gui()
    assert len(tube.BistableUnit.Shape.Faces) != before
    assert_coloured_by_kind(tube.BistableUnit)
    assert_drawn_in_colours(pixels)


def test_colours_follow_while_hidden(gui, tube, pixels):
    tube.BistableUnit.ViewObject.Visibility = False
    tube.TrianglePlacement.EdgeLength = 55
    tube.recompute()
    gui()
    tube.BistableUnit.ViewObject.Visibility = True
    assert_coloured_by_kind(tube.BistableUnit)
    assert_drawn_in_colours(pixels)


def test_one_colour_that_a_user_gave_to_all_stays(gui, tube):
    view, before = tube.BistableUnit.ViewObject, len(tube.BistableUnit.Shape.Faces)
    faces.set_face_colours(view, [(1.0, 0.0, 0.0)])
    tube.TrianglePlacement.EdgeLength = 55
    tube.recompute()
    gui()
    assert len(tube.BistableUnit.Shape.Faces) != before
    assert faces.face_colours(view) == [(1.0, 0.0, 0.0)]


def test_deployment_keeps_the_colours_that_a_user_chose(gui, tube):
    view = tube.BistableUnit.ViewObject
    wanted = [(1.0, 0.0, 0.0)] * len(tube.BistableUnit.Shape.Faces)
    faces.set_face_colours(view, wanted)
    tube.BistableUnit.Deployment = 0.5
    tube.recompute()
    gui()
    assert faces.face_colours(view) == wanted


@pytest.mark.parametrize("deployment", [0, 0.5])
def test_folded_states_look_right(gui, tube, screenshot, deployment):
    tube.BistableUnit.Deployment = deployment
    tube.recompute()
    Gui.activeDocument().activeView().fitAll()
    gui()
    assert tube.BistableUnit.isValid()
    screenshot(f"deployment-{deployment}")


def test_the_tree_goes_from_the_unit_down_to_the_source(gui):
    doc = App.newDocument("Tree")
    import Part

    arc = doc.addObject("Part::Feature", "Arc")
    arc.Shape = Part.makeCircle(150, App.Vector(), App.Vector(0, 0, 1), 0, 120)
    curve = make.make_curve(doc, source=arc)
    triangles = make.make_triangle_placement(doc, curve)
    unit = make.make_bistable_unit(doc, triangles)
    doc.recompute()
    assert unit.ViewObject.Proxy.claimChildren() == [triangles]
    assert triangles.ViewObject.Proxy.claimChildren() == [curve]
    assert curve.ViewObject.Proxy.claimChildren() == [arc]
    curve.Source = (arc, ["Edge1"])
    assert curve.ViewObject.Proxy.claimChildren() == []


def test_icons_follow_the_type(tube):
    for name in ("Curve", "TrianglePlacement", "BistableUnit"):
        proxy = tube.getObject(name).ViewObject.Proxy
        assert proxy.getIcon() == str(ICONS / f"{name}.svg")
    tube.Curve.Kind = "Sphere"
    assert tube.Curve.ViewObject.Proxy.getIcon() == str(ICONS / "CurveOnSphere.svg")


def overlay_points(obj):
    return [tuple(p) for p in obj.ViewObject.Proxy.points.point.getValues()]


def test_the_zigzag_over_the_tube_follows_the_shape(gui, tube):
    triangles = tube.TrianglePlacement
    for edge_length in (55, 40):
        triangles.EdgeLength = edge_length
        tube.recompute()
        corners = [tuple(v.Point) for v in triangles.Shape.Vertexes]
        drawn = overlay_points(triangles)
        assert len(drawn) == 2 * len(triangles.Shape.Edges)
        assert drawn[0] == pytest.approx(corners[0], abs=1e-3)
        assert drawn[-1] == pytest.approx(corners[-1], abs=1e-3)


def test_the_curve_over_the_tube_can_be_seen_and_hidden(gui, tube, pixels):
    def pink():
        return sum(p[0] - p[1] > 120 and p[2] - p[1] > 50 for p in pixels())

    assert pink() > 50
    tube.Curve.ViewObject.Visibility = False
    assert pink() == 0


def test_save_and_reopen_keeps_colours_icons_and_overlay(gui, tube, tmp_path, pixels, screenshot):
    path = str(tmp_path / "tube.FCStd")
    tube.saveAs(path)
    faces_before = len(tube.BistableUnit.Shape.Faces)
    App.closeDocument(tube.Name)
    gui()
    doc = App.openDocument(path)
    gui(0.2)
    unit = doc.BistableUnit
    assert len(unit.Shape.Faces) == faces_before
    assert_coloured_by_kind(unit)
    assert_drawn_in_colours(pixels)
    assert unit.ViewObject.Proxy.getIcon() == str(ICONS / "BistableUnit.svg")
    assert unit.ViewObject.Proxy.claimChildren() == [doc.TrianglePlacement]
    assert len(overlay_points(doc.Curve)) > 10
    doc.TrianglePlacement.EdgeLength = 55
    doc.recompute()
    gui()
    assert_coloured_by_kind(unit)
    screenshot("reopened")


def test_a_saved_file_names_no_path(gui, tube, tmp_path):
    import zipfile

    path = tmp_path / "tube.FCStd"
    tube.saveAs(str(path))
    with zipfile.ZipFile(path) as archive:
        text = archive.read("GuiDocument.xml").decode()
    assert str(ICONS) not in text
    assert ".svg" not in text


def file_made_without_a_window(headless, path):
    headless(
        "import FreeCAD as App; from BistableWB import make; doc = App.newDocument('H'); "
        "t = make.make_triangle_placement(doc, make.make_curve(doc)); "
        "make.make_bistable_unit(doc, t); doc.recompute(); "
        f"doc.saveAs({str(path)!r})"
    )


def test_a_file_made_headless_gets_its_view_providers(gui, tmp_path, pixels, headless):
    path = tmp_path / "headless.FCStd"
    file_made_without_a_window(headless, path)
    doc = App.openDocument(str(path))
    gui(0.2)
    for obj in doc.Objects:
        attach_missing(obj)
    Gui.activeDocument().activeView().viewIsometric()
    Gui.activeDocument().activeView().fitAll()
    gui(0.2)
    assert_coloured_by_kind(doc.BistableUnit)
    assert_drawn_in_colours(pixels)


def test_repair_brings_back_objects_that_lost_their_proxies(gui, tube, tmp_path):
    for obj in tube.Objects:
        obj.Proxy = None
        obj.ViewObject.Proxy = None
    path = str(tmp_path / "lost.FCStd")
    tube.saveAs(path)
    App.closeDocument(tube.Name)
    doc = App.openDocument(path)
    Gui.runCommand("Bistable_Repair")
    gui()
    assert all(obj.isValid() for obj in doc.Objects)
    doc.TrianglePlacement.EdgeLength = 55
    doc.recompute()
    gui()
    assert doc.BistableUnit.isValid()
    assert_coloured_by_kind(doc.BistableUnit)
    assert doc.BistableUnit.ViewObject.Proxy.claimChildren() == [doc.TrianglePlacement]
