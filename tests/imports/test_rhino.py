# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of Rhino files that rhino3dm writes."""

import math
import sys
import uuid

import numpy as np
import pytest

from BistableWB.imports import curves_in
from tests.judges import judge

rhino3dm = judge("rhino3dm")


@pytest.fixture
def model(tmp_path):
    """A function: (draw(model, attributes by layer), unit) → path of a .3dm."""

    def make(draw, unit="Millimeters"):
        file = rhino3dm.File3dm()
        file.Settings.ModelUnitSystem = getattr(rhino3dm.UnitSystem, unit)
        draw(file)
        path = tmp_path / "model.3dm"
        assert file.Write(str(path), 7)
        return path

    return make


def point(x, y, z=0.0):
    return rhino3dm.Point3d(x, y, z)


def on_layer(file, name, visible=True):
    layer = rhino3dm.Layer()
    layer.Name, layer.Visible = name, visible
    attributes = rhino3dm.ObjectAttributes()
    attributes.LayerIndex = file.Layers.Add(layer)
    return attributes


@pytest.mark.parametrize(
    ("unit", "factor"), [("Millimeters", 1), ("Inches", 25.4), ("Meters", 1e3)]
)
def test_lines_arcs_and_splines_in_the_unit_of_the_model(model, unit, factor):
    def draw(file):
        file.Objects.AddLine(point(0, -50), point(30, -10))
        file.Objects.AddCircle(rhino3dm.Circle(point(0, 0, 5), 10))
        poles = [point(0, 0), point(60, 120), point(180, 120), point(240, 0)]
        file.Objects.AddCurve(rhino3dm.NurbsCurve.Create(False, 3, poles))
        file.Objects.AddPolyline(rhino3dm.Polyline([point(0, 90), point(30, 90), point(30, 80)]))

    found = [curve.length / factor for curve in curves_in(model(draw, unit))]
    s = [k / 20_000 for k in range(20_001)]
    arch = [
        (240 * t**3 + 540 * t**2 * (1 - t) + 180 * t * (1 - t) ** 2, 360 * t * (1 - t)) for t in s
    ]
    assert found[0] == pytest.approx(sum(map(math.dist, arch, arch[1:])), rel=1e-7)
    assert found[1:] == pytest.approx([20 * math.pi, 50, 40], rel=1e-9)


def test_layers_and_what_is_hidden(model):
    def draw(file):
        line = rhino3dm.LineCurve(point(0, 0), point(100, 0))
        file.Objects.AddCurve(line, on_layer(file, "Rail"))
        file.Objects.AddCurve(
            rhino3dm.LineCurve(point(0, 5), point(300, 5)), on_layer(file, "Off", visible=False)
        )
        file.Objects.AddPoint(point(1, 1))

    curves = curves_in(model(draw))
    assert [(curve.layer, curve.length) for curve in curves] == [("Rail", pytest.approx(100))]
    receipt = str(curves.receipt)
    assert "Curve (hidden)" in receipt
    assert "Point (no curve)" in receipt


def test_a_curve_of_arcs_and_lines_is_one_curve(model):
    def draw(file):
        curve = rhino3dm.PolyCurve()
        curve.Append(rhino3dm.Line(point(0, 0), point(100, 0)))
        middle = point(100 + 20 / math.sqrt(2), 20 - 20 / math.sqrt(2))
        curve.Append(rhino3dm.Arc(point(100, 0), middle, point(120, 20)))
        file.Objects.AddCurve(curve)

    (curve,) = curves_in(model(draw))
    assert curve.length == pytest.approx(100 + 10 * math.pi, rel=1e-6)
    assert curve.kind == "Plane"


def test_broken_files_and_no_rhino3dm_are_one_sentence(tmp_path, monkeypatch):
    path = tmp_path / "model.3dm"
    path.write_bytes(b"hello")
    with pytest.raises(ValueError, match="is not a whole Rhino file: save it again"):
        curves_in(path)
    path.write_bytes(b"3D Geometry File Format " + b"x" * 100)
    with pytest.raises(ValueError, match="is not a whole Rhino file"):
        curves_in(path)
    monkeypatch.setitem(sys.modules, "rhino3dm", None)
    with pytest.raises(ValueError, match="needs the Python package rhino3dm"):
        curves_in(path)


@pytest.fixture
def block(model):
    """A function: (transforms, draw more) → path of a model with a block of a curve, 40 mm long."""

    def make(transforms, more=lambda file, index: None, unit="Millimeters"):
        def draw(file):
            arc = rhino3dm.NurbsCurve.CreateFromCircle(rhino3dm.Circle(point(0, 0), 20 / math.pi))
            line = rhino3dm.LineCurve(point(0, 0), point(0, 10))
            plain = rhino3dm.ObjectAttributes
            index = file.InstanceDefinitions.Add(
                "Rung", "", "", "", point(0, 0), (arc, line), (plain(), plain())
            )
            key = file.InstanceDefinitions.FindIndex(index).Id
            for transform in transforms:
                file.Objects.AddInstanceObject(rhino3dm.InstanceReference(key, transform))
            more(file, key)

        return model(draw, unit)

    return make


def test_blocks_are_drawn_where_they_are_inserted(block):
    """And their definitions, which Rhino does not show, are no curves."""
    moved = rhino3dm.Transform.Translation(100, 50, 0)
    larger = rhino3dm.Transform.Scale(point(0, 0), 3)
    curves = curves_in(block([moved, larger], unit="Centimeters"))
    assert [curve.length for curve in curves] == pytest.approx([1200, 400, 300, 100], rel=1e-9)
    line = curves[3].points()
    assert line[0] == pytest.approx((1000, 500, 0))
    assert line[-1] == pytest.approx((1000, 600, 0))
    assert not curves.receipt.left_out


def test_a_block_in_a_block_and_a_mirrored_one(block):
    mirror = rhino3dm.Transform.Mirror(point(0, 0), rhino3dm.Vector3d(0, 1, 0))

    def ladder(file, key):
        rung = rhino3dm.InstanceReference(key, rhino3dm.Transform.Translation(7, 0, 0))
        outer = file.InstanceDefinitions.Add(
            "Ladder", "", "", "", point(0, 0), (rung,), (rhino3dm.ObjectAttributes(),)
        )
        ladder = file.InstanceDefinitions.FindIndex(outer).Id
        file.Objects.AddInstanceObject(
            rhino3dm.InstanceReference(ladder, rhino3dm.Transform.Translation(0, 0, 5))
        )

    curves = curves_in(block([mirror], ladder))
    assert [curve.length for curve in curves] == pytest.approx([40, 40, 10, 10])
    ends = {tuple(np.round(curve.points()[-1], 9).tolist()) for curve in curves[2:]}
    assert ends == {(0, -10, 0), (7, 10, 5)}


def test_a_block_that_is_not_in_the_file_is_left_out_with_the_reason(block):
    def stranger(file, key):
        file.Objects.AddInstanceObject(
            rhino3dm.InstanceReference(uuid.uuid4(), rhino3dm.Transform.Identity())
        )

    curves = curves_in(block([rhino3dm.Transform.Identity()], stranger))
    assert [curve.length for curve in curves] == pytest.approx([40, 10])
    assert "Left out: 1 × block (it is not in the file)" in str(curves.receipt)
