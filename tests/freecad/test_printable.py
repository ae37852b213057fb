# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make it printable: one call from a drawn curve to prints that snap, whatever the curve."""

import json
from pathlib import Path

import FreeCAD as App
import numpy as np
import Part
import pytest

from BistableWB import fitting, make
from BistableWB.origami.fit import printable
from BistableWB.origami.progress import Cancelled, Progress

CURVES = json.loads((Path(__file__).parents[1] / "data" / "curves.json").read_text())
BED = (250.0, 210.0, 210.0)
TRIED = 40  # prints that are solved and measured on the way to one answer, at most


def drawn(doc, name):
    """A Curve as a designer draws it: control points, or a spline through points."""
    case = CURVES[name]
    if case["bezier"]:
        return make.make_curve(doc, points=case["points"])
    spline = Part.BSplineCurve()
    spline.interpolate([App.Vector(*p) for p in case["points"]])
    feature = doc.addObject("Part::Feature", "Drawn")
    feature.Shape = spline.toShape()
    return make.make_curve(doc, source=feature)


def check(made, margin=1.2):
    """What was promised, by the document's own measurement."""
    assert made.blocked is None
    for obj in (made.curve, made.triangles, made.unit, *made.hinge_sets):
        assert obj.isValid(), obj.getStatusString()
    margins = [m for hinges in made.hinge_sets for m in hinges.SnapMargins]
    assert len(margins) == made.triangles.Count
    assert made.margin == pytest.approx(min(margins), rel=0.01)
    assert made.promised == pytest.approx(min(margins), rel=0.01)
    assert min(margins) >= 0.999 * margin
    if not made.curve.Closed:
        edge = made.triangles.EdgeLength.Value
        for vertex in made.curve.Shape.Vertexes[0], made.curve.Shape.Vertexes[-1]:
            assert distance_of_bases(made.triangles, vertex.Point) <= 0.01 * edge
        for hinges in made.hinge_sets:
            assert hinges.CurveDeviation.Value <= 0.01 * edge
    for hinges in made.hinge_sets:
        size = sorted(hinges.PrintSize[:2])
        assert hinges.PrintSize.z <= BED[2] + 1e-6
        assert size[0] <= np.hypot(*BED[:2])


def distance_of_bases(triangles, point):
    """From a point to the nearest middle of the bases A–B that are drawn of the triangles."""
    assert len(triangles.Shape.Edges) == triangles.Count + 1  # lines of thick tubes: bases only
    return min(point.distanceToPoint(base.CenterOfMass) for base in triangles.Shape.Edges)


def test_an_arch_is_made_printable_in_one_step_of_undo(doc, valid):
    curve = drawn(doc, "arch")
    doc.UndoMode = 1
    before = {o.Name for o in doc.Objects}
    made = fitting.make_printable(curve)
    check(made)
    assert made.changes
    assert any("EdgeLength" in sentence for sentence in made.changes)
    again = fitting.make_printable(curve)
    assert again.triangles == made.triangles
    assert len(again.hinge_sets) == len(made.hinge_sets)
    doc.undo()
    doc.undo()
    assert {o.Name for o in doc.Objects} == before


@pytest.mark.slow
def test_what_is_promised_is_what_hinge_sets_with_their_own_numbers_measure(doc, valid):
    """With hinges and preload of the user's, on a plane, in space and on a sphere."""
    for kind, points in (
        ("Plane", [(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)]),
        ("General", [(0, 0, 0), (120, 240, 40), (360, 240, 120), (480, 0, 140)]),
        ("Sphere", [(-110, -30, 0), (-50, 75, 0), (50, -75, 0), (110, 30, 0)]),
    ):
        curve = make.make_curve(doc, points=points, kind=kind, sphere_radius=150)
        unit = make.make_bistable_unit(doc, make.make_triangle_placement(doc, curve))
        hinges = make.make_hinge_set(doc, unit)
        hinges.ConeAngle, hinges.Preload = 58, 0.5
        made = fitting.make_printable(hinges)
        check(made)
        assert made.hinge_sets[0] is hinges
        assert (hinges.ConeAngle.Value, hinges.Preload) == (58, 0.5)


def test_a_new_tube_is_as_wide_as_its_curve_and_the_printer_ask_for(doc, valid):
    def edge(scale, bed=(250, 210, 210)):
        points = [(scale * x, scale * y, 0) for x, y in ((0, 0), (60, 120), (180, 120), (240, 0))]
        return make.new_tube(make.make_curve(doc, points=points), bed)["edge_length"]

    assert edge(1) == 60
    assert edge(0.2) == 25
    assert 75 <= edge(2.5) <= 80
    assert edge(20) == 100
    assert edge(20, (400, 300, 300)) == 160
    curve = make.make_curve(doc)
    make.make_bistable_unit(doc, make.make_triangle_placement(doc, curve, **make.new_tube(curve)))
    valid(doc)


def test_a_search_can_be_cancelled_and_changes_nothing(doc, valid):
    curve = drawn(doc, "arch")
    before = len(doc.Objects)
    with pytest.raises(Cancelled):
        fitting.make_printable(curve, progress=Progress(cancelled=lambda: True))
    assert len(doc.Objects) == before


@pytest.mark.slow
@pytest.mark.parametrize("name", [n for n in CURVES if n not in ("arch", "bracelet")])
def test_curves_that_designers_draw(doc, valid, name, monkeypatch):
    curve = drawn(doc, name)
    valid(doc)
    tried = []
    measure = printable.Search._measured
    monkeypatch.setattr(
        printable.Search, "_measured", lambda self, *a: tried.append(a) or measure(self, *a)
    )
    made = fitting.make_printable(curve, BED)
    check(made)
    assert 0 < len(tried) <= TRIED


@pytest.mark.slow
def test_a_bracelet_is_printed_by_finer_hinges(doc, valid):
    made = fitting.make_printable(drawn(doc, "bracelet"), BED)
    check(made)
    assert made.hinge_sets[0].FaceThickness.Value < 1.2
