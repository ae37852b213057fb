# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several prints in one file: laid out on one plate, checked and reported on together."""

import FreeCAD as App
import Mesh
import pytest

from BistableWB import document_report, make
from BistableWB.exporters import bodies, export


@pytest.fixture
def coupons(doc, valid):
    """Three coupons where they are made: all at the origin."""
    kinds = ("Dihedral", "Vertex", "Dihedral")
    found = [make.make_hinge_coupon(doc, kind) for kind in kinds]
    valid(doc)
    return found


def boxes(objects):
    """The box of every object's exported bodies."""
    found = {}
    for body in bodies.bodies_of(objects):
        found.setdefault(body.source.Name, App.BoundBox()).add(body.shape.BoundBox)
    return list(found.values())


def test_prints_that_lie_in_each_other_are_laid_out(coupons, tmp_path):
    found = boxes(coupons)
    for k, one in enumerate(found):
        assert one.ZMin == pytest.approx(0, abs=1e-6)
        for other in found[k + 1 :]:
            apart = max(other.XMin - one.XMax, other.YMin - one.YMax, one.XMin - other.XMax)
            assert apart == pytest.approx(10, abs=1e-6) or apart > 10
    path = export(coupons, tmp_path / "plate.stl")
    mesh = Mesh.Mesh(str(path))
    single = sum(
        Mesh.Mesh(str(export(coupon, tmp_path / f"{k}.stl"))).Volume
        for k, coupon in enumerate(coupons)
    )
    assert mesh.Volume == pytest.approx(single, rel=1e-5)
    assert mesh.BoundBox.XLength > sum(box.XLength for box in found)


def test_rows_are_as_wide_as_the_bed(doc, coupons, valid):
    for coupon in coupons:
        if "Bed" not in coupon.PropertiesList:
            coupon.addProperty("App::PropertyVector", "Bed")
        coupon.Bed = App.Vector(110, 200, 200)
    valid(doc)
    found = boxes(coupons)
    assert max(box.XMax for box in found) <= 110
    assert len({round(box.YMin, 3) for box in found}) > 1


def test_prints_that_somebody_has_placed_stay_there(doc, coupons, valid):
    for k, coupon in enumerate(coupons):
        part = doc.addObject("App::Part", "Part")
        part.addObject(coupon)
        part.Placement.Base = App.Vector(0, 300 * k, 5)
    valid(doc)
    assert [box.ZMin for box in boxes(coupons)] == pytest.approx([5] * 3, abs=1e-6)
    assert boxes(coupons)[1].YMin > 200


@pytest.mark.slow
def test_one_report_on_several_prints(coupons, tmp_path):
    path = document_report.write(coupons[:2], tmp_path / "report.html")
    text = path.read_text(encoding="utf-8")
    for coupon in coupons[:2]:
        assert f"{coupon.Document.Label}: {coupon.Label}" in text
    with pytest.raises(ValueError, match="Nothing is selected to report on"):
        document_report.write([], tmp_path / "report.html")
