# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make it printable: one call from a drawn curve to prints that snap, whatever the curve."""

import json
import time
from pathlib import Path

import FreeCAD as App
import numpy as np
import Part
import pytest

from BistableWB import fitting, make
from BistableWB.origami.progress import Cancelled, Progress

CURVES = json.loads((Path(__file__).parents[1] / "data" / "curves.json").read_text())
BED = (250.0, 210.0, 210.0)
SECONDS = 60 * 3  # on slower machines, beside other work


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
    assert made.end_gap <= 0.01 * made.triangles.EdgeLength.Value
    end = made.curve.Shape.Vertexes[-1].Point
    last = made.triangles.Shape.Vertexes[-1].Point
    assert end.distanceToPoint(last) < made.triangles.EdgeLength.Value
    for hinges in made.hinge_sets:
        size = sorted(hinges.PrintSize[:2])
        assert hinges.PrintSize.z <= BED[2] + 1e-6
        assert size[0] <= np.hypot(*BED[:2])


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
def test_curves_that_designers_draw(doc, valid, name):
    curve = drawn(doc, name)
    valid(doc)
    start = time.process_time()
    made = fitting.make_printable(curve, BED)
    assert time.process_time() - start < SECONDS
    check(made)


@pytest.mark.slow
def test_a_curve_too_tight_says_what_stands_in_the_way(doc, valid):
    made = fitting.make_printable(drawn(doc, "bracelet"), BED)
    assert made.triangles is None or made.triangles.isValid()
    if made.blocked is not None:
        assert "margin" in made.blocked or "mm" in made.blocked
