# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a CAD program shows of a DXF, kind by kind; lengths are worked out by hand."""

import io
import math
import time

import pytest

from BistableWB.imports import curves_in

ezdxf = pytest.importorskip("ezdxf")


@pytest.fixture
def drawing(tmp_path):
    """A function: (draw(document, model space), version, unit) → path of a DXF."""

    def make(draw, version="R2010", unit=4):
        document = ezdxf.new(version)
        document.header["$INSUNITS"] = unit
        draw(document, document.modelspace())
        path = tmp_path / "drawing.dxf"
        document.saveas(path)
        return path

    return make


def lengths(path, **options):
    return [curve.length for curve in curves_in(path, **options)]


def line(document, model):
    model.add_line((0, 0), (100, 0))


@pytest.mark.parametrize(
    ("unit", "length"),
    [(0, 100), (1, 2540), (2, 30480), (4, 100), (5, 1000), (6, 1e5), (8, 25.4e-4), (9, 2.54),
     (10, 91440), (13, 0.1), (14, 1e4), (21, 100 * 1200000 / 3937), (99, 100)],
)  # fmt: skip
def test_units(drawing, unit, length):
    assert lengths(drawing(line, unit=unit)) == pytest.approx([length])


@pytest.mark.parametrize("version", ["R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018"])
def test_versions_line_ends_and_binary(drawing, tmp_path, version):
    path = drawing(
        lambda d, m: m.add_arc((0, 0), 100, 0, 180, dxfattribs={"layer": "Bögen"}), version
    )
    assert lengths(path) == pytest.approx([100 * math.pi])
    content = path.read_bytes().replace(b"\r\n", b"\n")
    for name, end in (("cr.dxf", b"\r"), ("crlf.dxf", b"\r\n"), ("lf.DXF", b"\n")):
        other = tmp_path / name
        other.write_bytes(content.replace(b"\n", end) + b"trash" + end)
        (curve,) = curves_in(other)
        assert curve.length == pytest.approx(100 * math.pi)
        assert curve.layer == "Bögen"
    document = ezdxf.readfile(path)
    binary = io.BytesIO()
    document.write(binary, fmt="bin")
    other = tmp_path / "binary.dxf"
    other.write_bytes(binary.getvalue())
    assert lengths(other) == pytest.approx([100 * math.pi])


def block(document):
    found = document.blocks.new("B", base_point=(10, 0))
    found.add_line((10, 0), (20, 0))
    found.add_line((10, 5), (15, 5), dxfattribs={"layer": "hidden"})
    return found


def test_blocks_are_shown_where_they_are_referred_to(drawing):
    def draw(document, model):
        document.layers.add("hidden").off()
        block(document)
        document.blocks.new("UNUSED").add_circle((0, 0), 5)
        model.add_blockref("B", (0, 0), dxfattribs={"xscale": -3})
        model.add_blockref("B", (0, 50), dxfattribs={"row_count": 2, "row_spacing": 9})
        model.add_blockref("NOT THERE", (0, 0))

    path = drawing(draw)
    assert lengths(path) == pytest.approx([30, 10, 10])
    receipt = str(curves_in(path).receipt)
    assert "3 × LINE (layer hidden is off)" in receipt
    assert "block NOT THERE (it is not in the file)" in receipt


def test_what_lies_on_layer_zero_of_a_block_has_the_layer_of_its_reference(drawing):
    def draw(document, model):
        block(document)
        for name, hide in (("frozen", "freeze"), ("off", "off")):
            getattr(document.layers.add(name), hide)()
            model.add_blockref("B", (0, 0), dxfattribs={"layer": name})
        model.add_blockref("B", (0, 9), dxfattribs={"layer": "rail"})

    curves = curves_in(drawing(draw))
    # of the block on the layer that is off, what lies on another layer is still seen
    assert [(curve.layer, curve.length) for curve in curves] == [
        ("rail", pytest.approx(10)), ("hidden", pytest.approx(5)), ("hidden", pytest.approx(5))
    ]  # fmt: skip


def test_what_is_not_seen_is_no_curve(drawing):
    def draw(document, model):
        line(document, model)
        model.add_line((0, 9), (300, 9), dxfattribs={"layer": "unseen"})
        model.add_point((0, 0))
        model.add_ray((0, 0), (1, 0))
        model.add_text("300")
        model.add_3dface([(0, 0), (300, 0), (300, 300)])
        document.layout("Layout1").add_line((0, 0), (300, 0))

    path = drawing(draw)
    content = path.read_text().replace("  8\nunseen\n", "  8\nunseen\n 60\n1\n")
    path.write_text(content)  # ezdxf does not write it
    assert lengths(path) == pytest.approx([100])
    assert "LINE (invisible)" in str(curves_in(path).receipt)
    assert "in paper space" in str(curves_in(path).receipt)


@pytest.mark.parametrize(
    ("add", "length", "closed"),
    [
        (lambda m: m.add_circle((0, 0), 10), 20 * math.pi, True),
        (lambda m: m.add_arc((0, 0), 10, 350, 10), 10 * math.radians(20), False),
        (lambda m: m.add_ellipse((0, 0), (10, 0), 1, 0, math.tau), 20 * math.pi, True),
        (lambda m: m.add_ellipse((0, 0), (10, 0), 1, 6, 1), 10 * (1 - 6 + math.tau), False),
        (lambda m: m.add_lwpolyline([(0, 0, 1), (10, 0, 1)], format="xyb", close=True),
         10 * math.pi, True),
        (lambda m: m.add_lwpolyline([(0, 0), (30, 0), (30, 40)], close=True), 120, True),
        (lambda m: m.add_lwpolyline([(0, 0), (0, 0), (30, 40), (30, 40)]), 50, False),
        (lambda m: m.add_lwpolyline([(0, 0), (30, 40), (0, 0)]), 50, False),
        (lambda m: m.add_spline([(0, 0), (30, 40)]), 50, False),
        (lambda m: m.add_polyline2d([(0, 0), (30, 40)]), 50, False),
    ],
)  # fmt: skip
def test_entities(drawing, add, length, closed):
    (curve,) = curves_in(drawing(lambda document, model: add(model)))
    assert curve.length == pytest.approx(length, rel=1e-9)
    assert curve.closed == closed


def test_control_frames_of_fitted_polylines_are_not_drawn(drawing):
    def draw(document, model):
        polyline = model.add_polyline2d([(0, 0), (0, 90), (10, 0), (20, 0)])
        polyline.dxf.flags = 4
        polyline.vertices[1].dxf.flags = 16
        polyline.vertices[2].dxf.flags = 8

    assert lengths(drawing(draw)) == pytest.approx([20])


def test_pieces_of_one_path_in_any_order_and_direction_are_one_curve(drawing):
    def draw(document, model):
        model.add_line((100, 0), (60, 0))
        model.add_arc((100, 20), 20, 270, 360)
        model.add_line((0, 0), (60, 0.004))
        model.add_line((60, 0), (100, 0))

    path = drawing(draw)
    assert lengths(path) == pytest.approx([100 + 10 * math.pi], rel=1e-6)
    assert len(lengths(path, join=1e-4)) == 2
    receipt = str(curves_in(path).receipt)
    assert "1 exact duplicates are left out" in receipt
    assert "gaps of up to 0.004 mm are closed" in receipt


def test_branches_leave_the_straightest_path_alone(drawing):
    def draw(document, model):
        model.add_line((0, 0), (50, 0))
        model.add_line((50, 0), (100, 1))
        model.add_line((50, 0), (50, 30))

    assert lengths(drawing(draw)) == pytest.approx([50 + math.hypot(50, 1), 30])


def text(*entities):
    return "0\nSECTION\n2\nENTITIES\n" + "".join(entities) + "0\nENDSEC\n0\nEOF\n"


LINE = "0\nLINE\n8\n0\n10\n{}\n20\n0\n11\n{}\n21\n1\n"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("hello", "is not a whole DXF file: export it again"),
        (text(LINE.format(0, 1)).replace("EOF", ""), "is not a whole DXF file"),
        (text(), "holds no line or curve"),
        (text("0\nTEXT\n8\n0\n10\n0\n20\n0\n40\n1\n1\nhello\n"), r"only 1 × TEXT"),
        (text(*(LINE.format(k, k + 1) for k in range(12_000))), "draws more than 10000 entities"),
        ("\0" * 500_000, "is not a text file"),
        ("0\n" * 400_000, "is not a whole DXF file"),
    ],
    ids=["word", "half", "empty", "text", "many", "zeros", "noughts"],
)
def test_broken_and_huge_files_are_refused_at_once(tmp_path, content, message):
    path = tmp_path / "bad.dxf"
    path.write_text(content, encoding="ascii")
    start = time.process_time()
    with pytest.raises(ValueError, match=message):
        curves_in(path)
    assert time.process_time() - start < 5


@pytest.mark.parametrize("first", [0, 1])
def test_blocks_that_explode_are_refused_at_once(drawing, first):
    def draw(document, model):
        for k in range(9):
            document.blocks.new(f"B{k}")
        for k in range(9 - first):
            for x in range(10):
                document.blocks.get(f"B{k}").add_blockref(f"B{(k + 1) % 9}", (x, 0))
        document.blocks.get("B8").add_line((0, 0), (1, 0))
        model.add_blockref("B0", (0, 0))

    start = time.process_time()
    with pytest.raises(ValueError, match=r"holds itself|draws more than"):
        curves_in(drawing(draw))
    assert time.process_time() - start < 5
