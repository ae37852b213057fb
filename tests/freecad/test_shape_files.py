# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of STEP, IGES and BREP files: written by FreeCAD, and by hand as the standards say."""

import math

import FreeCAD as App
import Part
import pytest

from BistableWB import make
from BistableWB.imports import curves_in, import_curve

LENGTH = 100 + 40 * math.pi  # of `rail`, mm

STEP = """ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('rail.step','2026-01-01T00:00:00',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));
ENDSEC;
DATA;
#1=APPLICATION_CONTEXT('core data');
#2=PRODUCT_CONTEXT('',#1,'mechanical');
#3=PRODUCT('rail','rail','',(#2));
#4=PRODUCT_DEFINITION_FORMATION('','',#3);
#5=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#6=PRODUCT_DEFINITION('design','',#4,#5);
#7=PRODUCT_DEFINITION_SHAPE('','',#6);
#8=SHAPE_DEFINITION_REPRESENTATION(#7,#20);
{unit}
#12=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#13=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#14=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-05),#11,'','');
#15=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#14))
GLOBAL_UNIT_ASSIGNED_CONTEXT((#11,#12,#13))REPRESENTATION_CONTEXT('',''));
#20=GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE_REPRESENTATION('',(#21),#15);
#21=GEOMETRIC_CURVE_SET('',(#22));
#22=POLYLINE('',(#30,#31,#32));
#30=CARTESIAN_POINT('',(0.,0.,0.));
#31=CARTESIAN_POINT('',(3.,0.,0.));
#32=CARTESIAN_POINT('',(3.,0.,4.));
ENDSEC;
END-ISO-10303-21;
"""
_MM = "#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));"
_METRE = "#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));"
_INCH = """#9=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#10=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#9);
#16=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);
#11=(CONVERSION_BASED_UNIT('INCH',#10)LENGTH_UNIT()NAMED_UNIT(#16));"""


def iges(flag, unit):
    """A line from (1, 2, 0) to (4, 6, 12) as the standard's 80 columns have it."""

    def section(letter, lines, width=72):
        return [f"{text:<{width}}{letter}{k:7d}" for k, text in enumerate(lines, 1)]

    head = (
        f"1H,,1H;,4Hrail,8Hrail.igs,4Hhand,3H1.0,32,38,6,308,15,4Hrail,1.,{flag},"
        f"{len(unit)}H{unit},1,0.1,15H20260101.000000,1E-5,100.,2Hme,2Hus,11,0,15H20260101.000000;"
    )
    glob = [head[k : k + 72] for k in range(0, len(head), 72)]
    entry = [
        "".join(f"{n:>8}" for n in (110, 1, 0, 0, 0, 0, 0, 0, "00000000")),
        "".join(f"{n:>8}" for n in (110, 0, 0, 1, 0, "", "", "LINE", 0)),
    ]
    data = [f"{'110,1.,2.,0.,4.,6.,12.;':<64}{1:8d}"]
    parts = (("S", ["by hand"]), ("G", glob), ("D", entry), ("P", data))
    lines = [line for letter, texts in parts for line in section(letter, texts)]
    end = "".join(f"{letter}{len(texts):7d}" for letter, texts in parts)
    return "\n".join([*lines, f"{end:<72}T{1:7d}", ""])


def rail():
    """A straight line of 100 mm that goes over into a quarter of a circle of 80 mm."""
    line = Part.makeLine(App.Vector(0, 0, 5), App.Vector(100, 0, 5))
    arc = Part.Arc(
        App.Vector(100, 0, 5),
        App.Vector(100 + 80 * math.sin(math.pi / 4), 80 - 80 * math.cos(math.pi / 4), 5),
        App.Vector(180, 80, 5),
    ).toShape()
    return [line, arc]


def write(shape, path):
    """``shape`` as FreeCAD writes it into the format of ``path``."""
    kinds = {"step": "Step", "stp": "Step", "iges": "Iges", "igs": "Iges", "brep": "Brep"}
    getattr(shape, f"export{kinds[path.suffix[1:]]}")(str(path))
    return path


@pytest.mark.parametrize("suffix", ["step", "stp", "iges", "igs", "brep"])
def test_what_freecad_writes_becomes_the_curve_it_was(doc, valid, tmp_path, suffix):
    path = write(Part.Wire(rail()), tmp_path / f"rail.{suffix}")
    curve = import_curve(doc, path)
    valid(doc)
    assert curve.Label == "rail (curve)"
    assert curve.FoundKind == "Plane"
    assert curve.Length.Value == pytest.approx(LENGTH, rel=2e-6)
    first, *_, last = curve.Shape.Vertexes
    ends = sorted(tuple(round(x, 6) for x in vertex.Point) for vertex in (first, last))
    assert ends == [(0, 0, 5), (180, 80, 5)]
    make.make_triangle_placement(doc, curve, edge_length=30)
    valid(doc)


@pytest.mark.parametrize("suffix", ["step", "igs"])
def test_a_spline_in_space_stays_exact(doc, valid, tmp_path, suffix):
    spline = Part.BSplineCurve()
    spline.interpolate(
        [App.Vector(*p) for p in ((0, 0, 0), (80, 60, 10), (160, 0, 40), (240, 60, 0))]
    )
    path = write(spline.toShape(), tmp_path / f"s.{suffix}")
    curve = import_curve(doc, path)
    valid(doc)
    assert curve.FoundKind == "General"
    assert curve.Length.Value == pytest.approx(spline.length(), rel=1e-5)
    for t in (0.1, 0.5, 0.9):
        on = Part.Vertex(spline.value(t * spline.LastParameter))
        assert curve.Shape.distToShape(on)[0] < 1e-6


@pytest.mark.parametrize("suffix", ["step", "igs"])
def test_of_several_curves_one_is_chosen_joined_and_scaled(doc, valid, tmp_path, suffix):
    line, arc = rail()
    arc.translate(App.Vector(0.5, 0, 0))
    path = write(Part.makeCompound([line, arc]), tmp_path / f"two.{suffix}")
    with pytest.raises(ValueError, match=r"2 separate curves .* are 0\.5 mm apart"):
        import_curve(doc, path)
    assert doc.Objects == []
    assert import_curve(doc, path, number=2).Shape is not None
    doc.recompute()
    assert doc.Objects[-1].Length.Value == pytest.approx(100)
    curve = import_curve(doc, path, join=1.01, scale=2)
    valid(doc)
    assert curve.Length.Value == pytest.approx(2 * LENGTH, rel=0.01)


@pytest.mark.parametrize("suffix", ["step", "igs", "brep"])
def test_edges_of_surfaces_are_left_out_where_there_are_curves(tmp_path, suffix):
    face = Part.makePlane(50, 50, App.Vector(0, 300, 0))
    shape = Part.makeCompound([*rail(), face])
    found = curves_in(write(shape, tmp_path / f"face.{suffix}"))
    assert [curve.length for curve in found] == pytest.approx([LENGTH])
    assert "Left out: 4 × edge (of a surface)" in str(found.receipt)


def test_edges_of_a_surface_alone_are_curves(tmp_path):
    found = curves_in(write(Part.makePlane(50, 30), tmp_path / "plate.step"))
    assert [curve.length for curve in found] == pytest.approx([160])


@pytest.mark.parametrize(("unit", "factor"), [(_MM, 1), (_INCH, 25.4), (_METRE, 1000)])
def test_a_step_file_by_hand_is_read_in_its_unit(tmp_path, unit, factor):
    path = tmp_path / "rail.stp"
    path.write_text(STEP.format(unit=unit))
    found = curves_in(path)
    assert [curve.length for curve in found] == pytest.approx([7 * factor], rel=1e-9)
    assert sorted(found[0].size, reverse=True) == pytest.approx([4 * factor, 3 * factor, 0])


@pytest.mark.parametrize(("flag", "unit", "factor"), [(2, "MM", 1), (1, "IN", 25.4), (6, "M", 1e3)])
def test_an_iges_file_by_hand_is_read_in_its_unit(tmp_path, flag, unit, factor):
    path = tmp_path / "rail.igs"
    path.write_text(iges(flag, unit))
    found = curves_in(path)
    assert [curve.length for curve in found] == pytest.approx([13 * factor], rel=1e-9)
    assert found[0].size == pytest.approx([3 * factor, 4 * factor, 12 * factor])


@pytest.mark.parametrize("name", ["x.step", "x.iges", "x.brep"])
@pytest.mark.parametrize("content", ["", "hello", STEP.format(unit=_MM)[:900], iges(2, "MM")[:300]])
def test_broken_files_are_refused_in_one_sentence(doc, tmp_path, name, content):
    path = tmp_path / name
    path.write_text(content)
    with pytest.raises(ValueError, match=r"^x\.\w+ (has no edge|is empty)") as refused:
        import_curve(doc, path)
    assert "\n" not in str(refused.value)
    assert doc.Objects == []
