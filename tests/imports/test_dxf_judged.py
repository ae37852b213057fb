# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random DXF files: lengths here against what ezdxf itself makes of entities and of blocks.

ezdxf reads the tags for us too; what entities mean, and where blocks stand, it works out by itself.
"""

import math
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from BistableWB.imports.dxf import read_dxf

ezdxf = pytest.importorskip("ezdxf")
disassemble = pytest.importorskip("ezdxf.disassemble")

coordinate = st.floats(-100, 100).map(lambda x: round(x, 4))
point = st.tuples(coordinate, coordinate, coordinate)
plan = st.tuples(coordinate, coordinate)
angle = st.floats(0, 360).map(lambda x: round(x, 3))
size = st.floats(0.5, 60).map(lambda x: round(x, 3))
normal = st.sampled_from([(0, 0, 1), (0, 0, -1), (1, 0, 0), (0, 1, 0.2), (0.005, 0.01, 1)])
factor = st.sampled_from([1.0, -1.0, 2.5, -0.5])


@st.composite
def entities(draw):
    """A function that adds one entity to a layout."""
    kind = draw(st.sampled_from(["line", "arc", "circle", "ellipse", "lw", "poly3d", "spline"]))
    attribs = {"extrusion": draw(normal)}
    a, b, r = draw(point), draw(point), draw(size)
    first, last = draw(angle), draw(angle)
    if kind == "line":
        return lambda layout: layout.add_line(a, b)
    if kind == "arc" and abs(first - last) > 0.1:
        return lambda layout: layout.add_arc(a, r, first, last, dxfattribs=attribs)
    if kind == "circle":
        return lambda layout: layout.add_circle(a, r, dxfattribs=attribs)
    if kind == "ellipse" and abs(first - last) > 0.1:
        ratio = draw(st.floats(0.05, 1).map(lambda x: round(x, 3)))
        axis = (r, r / 2, 0)
        ends = math.radians(first), math.radians(last)
        return lambda layout: layout.add_ellipse(a, axis, ratio, *ends)
    points = draw(st.lists(point, min_size=4, max_size=7, unique=True))
    if kind == "spline":
        weights = draw(st.lists(size, min_size=len(points), max_size=len(points)))
        if draw(st.booleans()):
            return lambda layout: layout.add_rational_spline(points, weights)
        return lambda layout: layout.add_open_spline(points)
    if kind == "poly3d":
        return lambda layout: layout.add_polyline3d(points)
    bulges = draw(st.lists(st.sampled_from([0, 0.4, -1, 1, 2.5, -3]), min_size=4, max_size=4))
    rows = [(x, y, bulge) for (x, y, _), bulge in zip(points, bulges, strict=False)]
    attribs["elevation"] = a[2]
    closed = draw(st.booleans())
    return lambda layout: layout.add_lwpolyline(
        rows, format="xyb", close=closed, dxfattribs=attribs
    )


@st.composite
def references(draw, alike=False):
    """Attributes of a block reference: mirrored, turned, scaled, in an array.

    ``alike``: by one factor along all axes. ezdxf 0.18 stumbles over others of nested blocks.
    """
    factors = [draw(factor)] * 3 if alike else [draw(factor) for _ in "xyz"]
    found = {f"{axis}scale": f for axis, f in zip("xyz", factors, strict=True)}
    found |= {"rotation": draw(angle), "extrusion": draw(normal)}
    if draw(st.booleans()):
        found |= {"row_count": 2, "column_count": 3, "row_spacing": 11, "column_spacing": -7}
    return draw(point), found


def judged(entity):
    """Length of an entity as ezdxf has placed it: in closed form, or of ezdxf's points on it."""
    kind, dxf = entity.dxftype(), entity.dxf
    if kind in ("LWPOLYLINE", "POLYLINE"):
        return sum(map(judged, entity.virtual_entities()))
    if kind == "LINE":
        return dxf.start.distance(dxf.end)
    if kind == "CIRCLE":
        return 2 * math.pi * dxf.radius
    if kind == "ARC":
        return dxf.radius * math.radians((dxf.end_angle - dxf.start_angle) % 360)
    curve = entity.construction_tool()
    if kind == "ELLIPSE":
        span = (curve.end_param - curve.start_param) % (2 * math.pi) or 2 * math.pi
        return polygons(curve.vertices, curve.start_param, curve.start_param + span)
    return polygons(curve.points, *between(curve.knots(), curve.order - 1))


def between(knots, degree):
    return knots[degree], knots[-degree - 1]


def polygons(points, low, high):
    """Length by two inscribed polygons, whose errors are as four to one."""
    vertices = np.array([tuple(p) for p in points(np.linspace(low, high, 2401).tolist())])
    coarse, fine = (
        float(np.linalg.norm(np.diff(vertices[::step], axis=0), axis=1).sum()) for step in (2, 1)
    )
    return (4 * fine - coarse) / 3


@pytest.mark.slow  # ezdxf makes a document in a tenth of a second
@settings(max_examples=40)
@given(st.lists(entities(), min_size=1, max_size=3), references(), references(alike=True), point,
       st.sampled_from(["R2000", "R2010"]))  # fmt: skip
def test_entities_in_blocks_in_blocks_are_as_long_as_ezdxf_says(drawn, one, two, base, version):
    document = ezdxf.new(version)
    document.header["$INSUNITS"] = 4
    inner = document.blocks.new("INNER", base_point=base)
    outer = document.blocks.new("OUTER")
    for add in drawn:
        add(inner)
    outer.add_blockref("INNER", one[0], dxfattribs=one[1])
    model = document.modelspace()
    model.add_blockref("OUTER", two[0], dxfattribs=two[1])
    drawn[0](model)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "random.dxf"
        document.saveas(path)
        found = read_dxf(path)
        again = ezdxf.readfile(path)
    total = sum(piece.length for stroke in found.strokes for piece in stroke.pieces)
    other = sum(map(judged, disassemble.recursive_decompose(again.modelspace())))
    assert total == pytest.approx(other, rel=1e-6, abs=1e-5)


@settings(max_examples=10)
@given(st.lists(point, min_size=5, max_size=9, unique=True), st.integers(2, 4))
def test_a_closed_spline_with_knots_beyond_its_ends_runs_where_ezdxf_says(points, degree):
    document = ezdxf.new("R2010")
    document.header["$INSUNITS"] = 4
    spline = document.modelspace().add_spline()
    spline.set_closed(points, degree=degree)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "closed.dxf"
        document.saveas(path)
        ((piece,),) = (stroke.pieces for stroke in read_dxf(path).strokes)
    curve = spline.construction_tool()
    low, high = between(curve.knots(), degree)
    t = np.linspace(0, 1, 41)
    points = np.array([tuple(p) for p in curve.points((low + t * (high - low)).tolist())])
    assert piece.at(t) == pytest.approx(points, abs=1e-7)
    assert piece.start == pytest.approx(piece.end, abs=1e-9)
