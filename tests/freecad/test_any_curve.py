# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any curve a designer draws: its kind is found, corners are rounded, ends are met, rings close."""

import FreeCAD as App
import numpy as np
import Part
import pytest

from BistableWB import make

V = App.Vector


def tube(doc, curve, edge=40.0):
    triangles = make.make_triangle_placement(doc, curve, edge)
    return triangles, make.make_bistable_unit(doc, triangles)


def linked(doc, shape, **options):
    feature = doc.addObject("Part::Feature", "Drawn")
    feature.Shape = shape
    return make.make_curve(doc, source=feature, **options)


def helix(turns, count, radius=80.0, pitch=60.0):
    t = 2 * np.pi * turns * np.linspace(0, 1, count)
    points = np.stack([radius * np.cos(t), radius * np.sin(t), pitch * t / (2 * np.pi)], -1)
    spline = Part.BSplineCurve()
    spline.interpolate([V(*p) for p in points.tolist()])
    return spline.toShape()


@pytest.mark.parametrize(("turns", "count"), [(0.5, 20), (1.5, 98), (1.5, 201), (3, 201), (4, 300)])
def test_a_helix_through_points_never_runs_along_its_own_axis(doc, valid, turns, count):
    curve = linked(doc, helix(turns, count))
    curve.Ruling = V(0, 0, 1)
    valid(doc)
    assert curve.FoundKind == "General"
    triangles, _ = tube(doc, curve)
    triangles.Level = True
    valid(doc)
    assert triangles.EndGap.Value < 1e-4


def test_the_kind_is_found_and_follows_the_shape(doc, valid):
    curve = make.make_curve(doc)
    triangles, unit = tube(doc, curve)
    triangles.Level = True
    valid(doc)
    assert curve.FoundKind == "Plane"
    curve.Points = [V(0, 0, 0), V(60, 120, 0), V(180, 120, 60), V(240, 0, 60)]
    valid(doc)
    assert curve.FoundKind == "General"
    assert unit.Omegas == [90.0] * triangles.Count or len(unit.Omegas) == triangles.Count
    on_ball = [V(150 * np.cos(t), 150 * np.sin(t) * np.cos(0.3 * t), 150 * np.sin(t) *
                 np.sin(0.3 * t)) for t in np.linspace(0, 2, 40)]  # fmt: skip
    spline = Part.BSplineCurve()
    spline.interpolate(on_ball)
    feature = doc.addObject("Part::Feature", "OnBall")
    feature.Shape = spline.toShape()
    curve.Source = (feature, [""])
    valid(doc)
    assert curve.FoundKind == "Sphere"
    assert max(unit.Omegas) < 90
    assert unit.IsometryError < 1e-11


def test_ends_are_met_and_what_was_taken_is_shown(doc, valid):
    triangles, _ = tube(doc, make.make_curve(doc))
    valid(doc)
    assert triangles.PlacementRule == "EndFit"
    assert triangles.EndGap.Value < 1e-5
    assert triangles.Coverage == pytest.approx(1)
    assert 15 < triangles.TakenGamma.Value < 25
    triangles.PlacementRule, triangles.Tolerance = "Steered", 0.3
    valid(doc)
    assert triangles.EndGap.Value < 1e-5
    assert 0 < triangles.MidpointDeviation.Value <= 0.31
    triangles.PlacementRule = "Paper"
    valid(doc)
    assert triangles.EndGap.Value > 1
    assert triangles.TakenGamma.Value == pytest.approx(20)


def test_the_tolerance_goes_with_the_edge_length_until_it_is_set(doc):
    triangles, _ = tube(doc, make.make_curve(doc))
    assert triangles.Tolerance.Value == pytest.approx(0.4)
    triangles.EdgeLength = 60
    assert triangles.Tolerance.Value == pytest.approx(0.6)
    triangles.Tolerance = 2
    triangles.EdgeLength = 50
    assert triangles.Tolerance.Value == 2


def test_corners_are_rounded_and_a_square_closes(doc, valid):
    square = Part.makePolygon([V(0, 0), V(200, 0), V(200, 200), V(0, 200), V(0, 0)])
    curve = linked(doc, square)
    triangles, unit = tube(doc, curve, 30)
    valid(doc)
    assert curve.Closed
    assert triangles.EndGap.Value < 1e-6
    assert triangles.Count % 2 == 0
    first, last = unit.Shape.Faces[0].BoundBox, unit.Shape.Faces[-12].BoundBox
    assert first.Center.distanceToPoint(last.Center) < 60
    curve.CornerRadius = 70
    valid(doc)
    assert curve.Length.Value == pytest.approx(800 - 8 * 70 + 2 * np.pi * 70, rel=1e-3)


def test_older_files_keep_the_rule_of_the_paper(doc, valid):
    triangles, _ = tube(doc, make.make_curve(doc))
    valid(doc)
    for name in ("PlacementRule", "Tolerance", "EndGap"):
        triangles.removeProperty(name)
    triangles.Proxy.onDocumentRestored(triangles)
    assert triangles.PlacementRule == "Paper"
