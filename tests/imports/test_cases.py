# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files as other programs write them, with the length and the number of curves a person sees.

The table in tests/data/import was made by hand, after faults that users of other programs reported.
"""

import csv
import math
from pathlib import Path

import pytest

from BistableWB.imports import curves_in
from BistableWB.imports.table import table_points

CASES = Path(__file__).resolve().parents[1] / "data" / "import"

# Entries of the table that are not the length of what the file holds: 0 where nobody measured, or
# the length of the plain arch where the file holds another curve. Chords bound the curve below.
NOT_MEASURED = {
    "50-ellipse-arc-rot.svg", "77-solidworks-polyline.svg", "04-tab-decimal-comma-nohead.txt",
    "14-unicode-minus.csv", "26-noisy-many.csv",
}  # fmt: skip
# The last row is the first again: a closed curve makes no tube.
CLOSED = {"24-closed-loop.csv"}


def cases():
    for table in sorted(CASES.glob("*/expected.tsv")):
        with table.open(encoding="utf-8") as file:
            for name, length, count in csv.reader(file, delimiter="\t"):
                yield pytest.param(table.parent / name, float(length), int(count), id=name)


@pytest.mark.parametrize(("path", "length", "count"), list(cases()))
def test_a_file_is_read_as_a_person_sees_it(path, length, count):
    if path.suffix.lower() == ".dxf":
        pytest.importorskip("ezdxf")
    if path.name in CLOSED:
        with pytest.raises(ValueError, match="the curve closes"):
            curves_in(path)
        return
    curves = curves_in(path)
    assert len(curves) == count
    if path.name not in NOT_MEASURED:
        assert curves[0].length == pytest.approx(length, rel=1e-3)
    assert curves.receipt.unit
    told = str(curves.receipt).splitlines()
    assert told[:2] == [path.name, str(curves.receipt.read()[0])]
    assert f"{curves[0].length:.6g} mm long" in told[1]
    assert any(line.startswith("Unit: ") for line in told)


@pytest.mark.parametrize(
    ("name", "low", "high"),
    [  # sums of the chords, worked out by hand from the rows
        ("csv/04-tab-decimal-comma-nohead.txt", 265.5, 268),
        ("csv/14-unicode-minus.csv", 441.2, 490),
        ("csv/26-noisy-many.csv", 199.501, 199.503),
        ("svg/77-solidworks-polyline.svg", 99.9, 100.1),
    ],
)
def test_what_the_table_does_not_know_lies_between_bounds(name, low, high):
    (curve,) = curves_in(CASES / name)
    assert low < curve.length < high
    if name.startswith("csv"):
        points = table_points(CASES / name)
        assert curve.length >= sum(map(math.dist, points, points[1:]))


def test_an_arc_that_was_rotated_and_scaled_up_is_an_ellipse_through_its_ends():
    """Half the ellipse with half axes 60 a and 30 a whose diameter the chord is."""
    (curve,) = curves_in(CASES / "svg/50-ellipse-arc-rot.svg")
    (arc,) = curve.pieces
    assert arc.start == pytest.approx([50, -100, 0])
    assert arc.end == pytest.approx([150, -120, 0])
    major, minor = (math.hypot(*axis) for axis in arc.radii)
    assert major / minor == pytest.approx(2)


def test_layers_and_kinds_are_told():
    pytest.importorskip("ezdxf")
    assert curves_in(CASES / "dxf/43-helix.dxf")[0].kind == "General"
    assert curves_in(CASES / "dxf/03-bulge-pos.dxf")[0].kind == "Plane"
    assert "LINE (layer OFF is off)" in str(curves_in(CASES / "dxf/15-layer-off.dxf").receipt)
    (curve,) = found = curves_in(CASES / "svg/24-inkscape-guides-page.svg")
    assert curve.layer == "Ebene 1"
    assert "Curve 1: 316.102 mm long, 240 × 90 mm, layer Ebene 1" in str(found.receipt)
