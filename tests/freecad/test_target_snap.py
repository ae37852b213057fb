"""The rule TargetSnap and auto-fit on document objects."""

import re
import time

import numpy as np
import pytest

from BistableWB import fitting, make
from BistableWB.origami.fit import steps
from BistableWB.origami.snap.table import LEGACY
from BistableWB.origami.snap.targets import TargetMargin
from BistableWB.origami.units.ratios import RULES

ARCH = [(0, 0, 0), (90, 180, 0), (270, 180, 0), (360, 0, 0)]


def chain(doc, edge_length=80.0, thickness=1.8, gamma=28.0, **options):
    curve = make.make_curve(doc, points=ARCH, **options)
    triangles = make.make_triangle_placement(doc, curve, edge_length, gamma)
    triangles.Thickness = thickness
    unit = make.make_bistable_unit(doc, triangles)
    unit.RatioRule = "TargetSnap"
    return triangles, unit


def test_each_unit_gets_its_own_ratio(doc, valid):
    triangles, unit = chain(doc)
    valid(doc)
    low = np.sin(np.radians(triangles.Thetas) / 2)
    shares = (np.array(unit.Ratios) - low) / (1 - low)
    assert np.ptp(shares) > 0.01
    assert unit.Warnings == []
    firm = np.array(unit.Ratios)
    unit.TargetMargin = 1.2
    valid(doc)
    assert (np.array(unit.Ratios) > firm).all()


def test_units_that_fall_short_are_named(doc, valid):
    _, unit = chain(doc, edge_length=40.0)
    valid(doc)
    assert len(unit.Warnings) == 1
    assert "cannot reach the snap margin" in unit.Warnings[0]
    unit.HingePlay = 0.05
    valid(doc)
    assert unit.Warnings == []


def test_a_hinge_set_aims_for_a_firm_snap_unless_ratios_were_chosen(doc, valid):
    """All by defaults, as *New tube* and *Hinge set* make it: no unit of it is floppy."""
    triangles = make.make_triangle_placement(doc, make.make_curve(doc), **make.NEW_TUBE)
    unit = make.make_bistable_unit(doc, triangles)
    hinges = make.make_hinge_set(doc, unit)
    hinges.FirstUnit = hinges.LastUnit = 2  # one of those that open little
    valid(doc)
    assert unit.RatioRule == "TargetSnap"
    assert min(hinges.SnapMargins) >= 1.4
    assert not any("floppy" in text for text in [*unit.Warnings, *hinges.Warnings])
    unit.RatioRule, triangles.Gamma, triangles.EdgeLength = "Adaptive", 20, 40
    hinges.Preload = 0
    valid(doc)
    assert min(hinges.SnapMargins) < 1
    assert re.match(r"Units .* are floppy", unit.Warnings[0])


def test_chosen_ratios_stay(doc):
    for choice, value in {"RatioShare": 0.1, "RatioRule": "Paper"}.items():
        curve = make.make_curve(doc, points=ARCH)
        unit = make.make_bistable_unit(doc, make.make_triangle_placement(doc, curve))
        setattr(unit, choice, value)
        make.make_hinge_set(doc, unit)
        assert unit.RatioRule != "TargetSnap"


def test_without_thickness_it_says_what_to_set(doc, refused):
    triangles, unit = chain(doc, thickness=0.0)
    assert f"Thickness of {triangles.Label} is 0 mm" in refused(doc, unit)
    unit.TargetBarrier = 1e-5
    doc.recompute()
    assert unit.isValid()
    assert unit.Barriers == pytest.approx([1e-5] * triangles.Count, rel=0.02)


def test_a_single_unit_has_its_own_thickness(doc, valid, refused):
    unit = make.make_bistable_unit(doc, theta=45, edge_length=60)
    unit.RatioRule = "TargetSnap"
    assert "Thickness is 0" in refused(doc, unit)
    unit.Thickness = 1.8
    valid(doc)
    assert 0.385 < unit.Ratios[0] < 0.42


def test_on_a_sphere_the_ratio_is_as_free_as_on_a_plane(doc, valid):
    _, unit = chain(doc, kind="Sphere", sphere_radius=300)
    valid(doc)
    assert unit.RatioRule == "TargetSnap"
    assert unit.IsometryError < 1e-12
    assert len(set(unit.Ratios)) > 1


def test_barriers_of_every_rule(doc, valid):
    curve = make.make_curve(doc, points=ARCH)
    triangles = make.make_triangle_placement(doc, curve)
    unit = make.make_bistable_unit(doc, triangles)
    for rule in ("Adaptive", "Fixed", "Paper"):
        unit.RatioRule = rule
        valid(doc)
        assert len(unit.Barriers) == triangles.Count
        assert min(unit.Barriers) > 0
        assert unit.Warnings == []


def test_a_hundred_units_stay_quick(doc, valid):
    triangles, unit = chain(doc, edge_length=11.0, thickness=0.2, gamma=20.0)
    unit.HingePlay = 0.02
    valid(doc)
    assert triangles.Count > 85
    times = []
    for margin in (1.4, 1.3, 1.2):
        unit.TargetMargin = margin
        start = time.process_time()
        doc.recompute()
        times.append(time.process_time() - start)
    assert min(times) < 0.3


def test_a_file_from_before_the_rule_gets_it(doc):
    unit = make.make_bistable_unit(doc)
    unit.RatioRule = ["Adaptive", "Fixed", "Exact", "Paper"]
    unit.RatioRule = "Exact"
    unit.Proxy.onDocumentRestored(unit)
    assert unit.getEnumerationsOfProperty("RatioRule") == list(RULES)
    assert unit.RatioRule == "Exact"


def test_auto_fit_and_apply(doc, valid, monkeypatch):
    monkeypatch.setattr(steps, "EDGES", 4)
    monkeypatch.setattr(steps, "GAMMAS", (np.radians(22),))
    monkeypatch.setattr(steps, "_MEASURED", 2)
    triangles, unit = chain(doc, thickness=0.0)
    fit = fitting.auto_fit(triangles, bed=(250, 210, 210), margin=1.4)
    assert triangles.Thickness.Value == 0  # nothing is changed by looking
    best = fit.recommended
    fitting.apply(best, triangles, unit, fit.wanted)
    valid(doc)
    assert triangles.Count == best.count
    assert triangles.Coverage == pytest.approx(best.coverage)
    assert unit.RatioRule == best.rule
    assert unit.Warnings == []


def test_auto_fit_wants_triangles_or_a_curve(doc):
    with pytest.raises(ValueError, match="choose the TrianglePlacement"):
        fitting.auto_fit(make.make_bistable_unit(doc))


def test_a_tube_of_an_older_file_stays_as_it_was(doc, valid):
    """Ratios by the old measure, knuckles by their number; new ones go by what is real."""
    _, unit = chain(doc)
    hinges = make.make_hinge_set(doc, unit)
    assert (unit.MarginMeasure, hinges.SegmentWidth.Value) == ("Contact", 5)
    assert hinges.PreloadRule == "Automatic"
    for obj, name in (
        (unit, "MarginMeasure"), (hinges, "SegmentWidth"), (hinges, "PreloadRule"),
        (hinges, "Preload"),
    ):  # fmt: skip
        obj.removeProperty(name)
        obj.Proxy.onDocumentRestored(obj)
    assert (unit.MarginMeasure, hinges.SegmentWidth.Value) == ("Crease", 0)
    assert (hinges.PreloadRule, hinges.Preload) == ("Given", 0)
    hinges.LastUnit, unit.TargetMargin = 1, 1.5
    valid(doc)
    old = list(unit.Ratios)
    theta = np.radians(unit.Triangles.Thetas)
    legacy = TargetMargin(80.0, 1.8, 1.5, unit.HingePlay.Value, measure=LEGACY).ratios(theta)
    assert old == pytest.approx(legacy, abs=2e-3)
    unit.MarginMeasure = "Contact"
    valid(doc)
    assert (np.array(unit.Ratios) < old).all()


def test_a_count_of_knuckles_is_meant(doc):
    hinges = make.make_hinge_set(doc, make.make_bistable_unit(doc))
    hinges.Segmentations = 5
    assert hinges.SegmentWidth.Value == 0
    assert make.make_hinge_set(doc, hinges.Unit, preset="Hinge4").SegmentWidth.Value == 0
