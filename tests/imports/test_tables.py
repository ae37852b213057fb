# SPDX-License-Identifier: LGPL-2.1-or-later
"""One arch of five points as spreadsheets, instruments and people write it."""

import pytest

from BistableWB.imports import curves_in
from BistableWB.imports.table import table_points

POINTS = [(0, 0), (60.5, 40.25), (120, 50.5), (180, 40.25), (240, 0)]


def rows(form, head=""):
    """A line a point: {x}, {y}, {i} (from 1), and {X}, {Y} with decimal commas."""
    return head + "\n".join(
        form.format(x=x, y=y, i=i, X=str(x).replace(".", ","), Y=str(y).replace(".", ","))
        for i, (x, y) in enumerate(POINTS, 1)
    )


@pytest.fixture
def table(tmp_path):
    def write(content):
        path = tmp_path / "points.csv"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return write


@pytest.mark.parametrize(
    "content",
    [
        rows('"{X}";"{Y}"', '"x";"y"\n'),
        rows("{x},{y}", "x_mm,y_mm\n"),
        rows("{x},{y}", "x-mm,y-mm\n"),
        rows("{x},{y}", "X (Millimeter), Y (Millimeter)\n"),
        rows("{X};{Y}", "x in mm;y in mm\n"),
        rows("{y},{x}", "y,x\n"),
        rows("{y},{x}", "Northing,Easting\n"),
        rows("{x},{y}", "E,N\n"),
        rows("{x},{y}", "X-Coordinate,Y-Coordinate\n"),
        rows("{x},{y},0", "x,y,z\n"),
        rows("{x},{y},5"),
        rows("{i},{x},{y},0", "t,x,y,z\n"),
        rows("{i},{x},{y},0"),
        rows("{i};{X};{Y}", "Nr;X;Y\n"),
        rows("P{i} {x} {y}"),
        "order,x,y\n3,120,50.5\n1,0,0\n5,240,0\n4,180,40.25\n2,60.5,40.25",
        rows("{x},{y}", "Instrument;ABC 12\nDate;2024-01-01\n\nx,y\n"),
        rows("{X};{Y}", "Messprotokoll\nDatum: 01.02.2024 10:00\n\nX [mm];Y [mm]\n"),
        rows("{x},{y},", "x,y,\n"),
        rows("{x:.5e},{y:.5e}"),
        rows("{x:.5e};{y:.5e}").replace(".", ","),
        rows("{x} mm, {y} mm"),
        rows("{X} {Y}"),
        rows("{x},{y}", "sep=,\n"),
        rows("{x}\t{y}", "sep=\t\n"),
        rows("{x} \t {y}"),
        rows("| {x} | {y} |", "| x | y |\n|---|---|\n"),
        rows("[{x}, {y}],"),
        "[" + rows("({x}, {y}),") + "]",
        rows("{x},{y}", "; comment\n"),
        rows("{x},{y} # point {i}"),
        rows("{x},{y}").replace("\n", "\r"),
        rows("{x},{y}").encode("utf-16"),
        rows("{x},{y}").encode("utf-16-le"),
        pytest.param(rows("{x},{y}").encode("utf-32"), id="utf-32"),
        rows("{X};{Y};Größe", "x;y;Länge\n").encode("cp1252"),
        rows("{x},{y}") + "\n\x1a",
    ],
)
def test_the_same_arch(table, content):
    found = table_points(table(content))
    assert [point[:2] for point in found] == [pytest.approx(point) for point in POINTS]
    assert len({point[2] for point in found}) == 1


@pytest.mark.parametrize(
    ("content", "unit"),
    [
        (rows("{x},{y}", "x/m,y/m\n"), 1000),
        (rows("{x},{y}", "x [in],y [in]\n"), 25.4),
        (rows("{x},{y}", 'x ("),y (")\n'), 25.4),
        (rows("{X};{Y}", "x in Zoll;y in Zoll\n"), 25.4),
        (rows("{x},{y}", "# units: inch\n"), 25.4),
        (rows("{x},{y}", "X,Y\n(cm),(cm)\n"), 10),
        (rows("{x} cm\t{y} cm"), 10),
        (rows("{x},{y}", "E [m],N [m]\n"), 1000),
        (rows("{x},{y}", "Distance (m),Height (m)\n"), 1000),
        (rows("{x},{y}", "x (µm),y (um)\n"), 0.001),
        (rows("{x},{y},inch", "x,y,unit\n"), 25.4),
        (rows("{x},{y}", "xft,yft\n"), 304.8),
    ],
)
def test_units_are_converted(table, content, unit):
    points = table_points(table(content))
    assert points == [pytest.approx((x * unit, y * unit, 0)) for x, y in POINTS]


@pytest.mark.parametrize(
    ("content", "last"),
    [
        ("x;y\n0,0;0,0\n1.060,5;40,25\n2.120,0;50,5\n", (2120, 50.5, 0)),
        ('x,y\n"0.0","0.0"\n"1,060.5","40.25"\n"2,120.0","50.5"\n', (2120, 50.5, 0)),
        ("x;y\n0;0\n1 060,5;40,25\n2 120;50,5\n", (2120, 50.5, 0)),
        ("x;y\n0;0\n1\u00a0060,5;40,25\n2\u202f120;50,5\n", (2120, 50.5, 0)),
        ("x;y\n0;0\n1'060.5;40.25\n2'120;50.5\n", (2120, 50.5, 0)),
        ("x;y\n0,000;0,000\n1,060;2,500\n", (1.06, 2.5, 0)),
        ("x,z\n0,0\n3,4\n", (3, 0, 4)),
        ("x,y\n0,0\n5,\u2212200\n", (5, -200, 0)),
        ("x,y\n0,0\n5,(200)\n", (5, -200, 0)),
    ],
)
def test_marks_of_numbers_and_lone_axes(table, content, last):
    assert table_points(table(content))[-1] == pytest.approx(last)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ("x;y\n0;0\n1,060;40\n2,120;50\n", "1,060 may be 1060 or 1.060"),
        ("x;y\n0;0\n1,5;40\n2.5;50\n", "has points and commas in its numbers"),
        (rows("{X},{Y}"), "with a semicolon between them where numbers have commas"),
        (rows("{x},{y}", "lat,lon\n"), "has angles or pixels"),
        ("N48.1,E11.5\nN48.2,E11.6\n", "has angles or pixels"),
        (rows("{x},{y}", "r,theta\n"), "has angles or pixels"),
        (rows("{x},{y}", "x (px),y (px)\n"), "has angles or pixels"),
        (rows("{x},{y}", "x (furlong),y\n"), "in a unit that is not known"),
        ("x,y,unit\n0,0,mm\n3,4,cm\n", "rows in several units"),
        (rows("{x},{y},{x},{y}", "x1,y1,x2,y2\n"), "two columns for one axis, x1 and x2"),
        ("x,y\n0,0\n#REF!,1\n2,3", "line 3: '#REF!' is not a coordinate"),
        ("x,y\n0,0\n1,\n2,3", "line 3: '' is not a coordinate"),
        ("x,y\n0,0\n1/2,3\n4,5\n", "line 3: '1/2' is not a coordinate"),
        (rows("{x},{y}") + "\nTotal,5\n", "line 6: 'Total' is not a coordinate"),
        ("0,0\n5,5\n9,0\n0,0\n", "the curve closes"),
        pytest.param(
            "".join(f"{k},{k % 7}\n" for k in range(9000)), "keep every 9th row", id="9000 rows"
        ),
        (b"(0, 0, 0)\n(60.5, 40.25, 0)\n(120, 50.\xcb, 0)\n(", "line 4: 0 columns"),
        (b"PK\x03\x04\x14\x00\x06\x00spreadsheet", "is not a text file: choose a CSV file"),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_reason(table, content, message):
    with pytest.raises(ValueError, match=message):
        curves_in(table(content))


def test_a_map_is_brought_to_the_origin_with_all_its_digits(table):
    rows = "".join(f"{500000.125 + x:.3f},{5400000.25 + y:.3f}\n" for x, y in POINTS)
    (here,) = curves_in(table("Easting (m),Northing (m)\n" + rows))
    (there,) = curves_in(table("".join(f"{x},{y}\n" for x, y in POINTS)))
    assert here.length == pytest.approx(1000 * there.length, rel=1e-9)
    assert "is moved by" in str(here.length and curves_in(table(rows)).receipt)
    assert max(abs(here.pieces[0].start)) < 1e6
