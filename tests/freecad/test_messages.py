# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refusals of document objects: kept as data, marked by FreeCAD, one line in the report view."""

import string
import sys
from pathlib import Path

import FreeCAD as App
import Part
import pytest

import BistableWB
from BistableWB import exporters, make
from BistableWB.designs import building, reading
from BistableWB.designs.wording import with_keys
from BistableWB.objects import TYPES, proxy_class
from BistableWB.objects.curve import Curve
from BistableWB.objects.refused import refusal_of, warnings_of
from BistableWB.origami.errors import Refusal
from tests.hostile import HOSTILE
from tests.translations import load

PACKAGE = Path(BistableWB.__file__).parent
# Inputs of the mathematics that no object has: said by these words.
NO_PROPERTY: set[str] = set()


def in_two_pieces():
    lines = (((0, 0, 0), (100, 0, 0)), ((100, 50, 0), (100, 150, 0)))
    return Part.makeCompound([Part.makeLine(*map(App.Vector, line)) for line in lines])


@pytest.fixture
def triangles(doc):
    return make.make_triangle_placement(doc, make.make_curve(doc))


def test_every_parameter_of_a_message_is_a_property(doc):
    """So that a panel has a label for it."""
    known = {prop.name for name in TYPES for prop in proxy_class(name).PROPERTIES} | NO_PROPERTY
    assert len(known) > 50
    sentences = load("sentences")
    for text in sentences.templates(PACKAGE):
        fields = {field for _, field, _, _ in string.Formatter().parse(text) if field}
        assert {field for field in fields if field[:1].isupper()} <= known, text


def test_a_refusal_stays_on_the_proxy(doc, triangles):
    triangles.Gamma = 120
    doc.recompute()
    refusal = refusal_of(triangles)
    assert not triangles.isValid()
    assert triangles.getStatusString() == str(refusal)
    assert refusal.parameter == "Gamma"
    assert refusal.message.pieces["value"] == pytest.approx(120)
    triangles.Gamma = 20
    doc.recompute()
    assert triangles.isValid()
    assert refusal_of(triangles) is None


def test_a_refusal_is_one_line_without_traceback(doc, triangles, capfd):
    doc.recompute()
    capfd.readouterr()
    triangles.Gamma = 120
    doc.recompute()
    said = "".join(capfd.readouterr())
    assert "Traceback" not in said
    assert 'File "' not in said
    assert said.count("Refused: Gamma is 120") == 1
    assert not hasattr(sys, "tracebacklimit")


def test_a_mistake_of_the_program_has_a_traceback(doc, triangles, capfd, monkeypatch):
    def broken(self, obj):
        raise ValueError("an index out of its place")

    triangles.Gamma = 120
    doc.recompute()  # a refusal before it holds nothing back
    capfd.readouterr()
    monkeypatch.setattr(Curve, "generate", broken)
    curve = triangles.Curve
    curve.touch()
    doc.recompute()
    said = "".join(capfd.readouterr())
    assert "Traceback (most recent call last)" in said
    assert "in broken" in said
    assert str(refusal_of(curve)) == "an index out of its place"


@pytest.mark.parametrize("label", HOSTILE)
def test_a_label_stays_as_it_is(doc, label):
    """In what FreeCAD says, in the words of a design file, and in other names for parameters."""
    source = doc.addObject("Part::Feature", "Pieces")
    source.Shape = in_two_pieces()
    source.Label = label
    label = source.Label  # FreeCAD makes labels unique
    curve = make.make_curve(doc, source=source)
    doc.recompute()
    told = f"Source {label} falls into 2 separate pieces (the smallest gap is 50 mm at (100, "
    assert curve.getStatusString().startswith(told)
    design = reading.check("x.toml", "[curve]\nsource = 'x.brep'\n")
    assert with_keys(design, "curve", refusal_of(curve)) == str(refusal_of(curve)).replace(
        "Source", "source", 1
    )
    assert label in refusal_of(curve).in_words(
        lambda text: text.replace("pieces", "Teile"), str.swapcase
    )
    curve.Label = label
    with pytest.raises(Refusal) as refused:
        exporters.export([curve], "tube.step")
    assert str(refused.value) == f"{curve.Label} is invalid, correct it first: {refusal_of(curve)}"


@pytest.mark.parametrize("name", [name for name in HOSTILE if "/" not in name])
def test_a_file_name_stays_as_it_is_in_the_words_of_the_command_line(tmp_path, name):
    in_two_pieces().exportBrep(str(tmp_path / f"{name}.brep"))
    path = tmp_path / f"{name}.toml"
    path.write_text(f"[curve]\nsource = '{name}.brep'\n[triangles]\ngamma = 20\n", encoding="utf-8")
    with pytest.raises(reading.DesignError) as refused:
        building.produce(reading.read(path), tmp_path / "out")
    assert str(refused.value).startswith(f"{path}: [curve] source {name} falls into 2 separate ")


def test_the_words_of_a_design_file_name_its_keys(tmp_path):
    path = tmp_path / "long.toml"
    path.write_text(
        "[curve]\npoints = [[0, 0], [100, 0]]\n"
        "[triangles]\nedge_length = 500\nplacement_rule = 'Paper'\n"
    )
    with pytest.raises(reading.DesignError) as refused:
        building.produce(reading.read(path), tmp_path / "out")
    said = str(refused.value)
    assert "edge_length ‖AB‖ = 500 mm is too long" in said
    assert "or gamma smaller" in said


def test_warnings_stay_data_in_a_file(doc, triangles, tmp_path):
    triangles.Thickness = 1.8
    unit = make.make_bistable_unit(doc, triangles)
    unit.HingePlay = 2
    doc.recompute()
    assert [str(one) for one in warnings_of(unit)] == unit.Warnings
    assert "{ratios}" in warnings_of(unit)[0].template
    kept, unit = warnings_of(unit), unit.Name
    doc.saveAs(str(tmp_path / "x.FCStd"))
    App.closeDocument(doc.Name)
    again = App.openDocument(str(tmp_path / "x.FCStd"))
    try:
        found = again.getObject(unit)
        assert warnings_of(found)[0] == kept[0]
        found.Proxy.loads(None)  # as of a file of 0.1.0
        found.Proxy.warnings = ()
        assert [one.template for one in warnings_of(found)] == ["{text}"] * len(found.Warnings)
        assert [str(one) for one in warnings_of(found)] == found.Warnings
    finally:
        App.closeDocument(again.Name)
