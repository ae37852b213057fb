"""HingeCoupon: the paper's test prints, and which failures of its tables our checks explain."""

import json
import re
from pathlib import Path

import pytest

from BistableWB import make
from BistableWB.origami.hinges.presets import PRESETS

TABLES = json.loads((Path(__file__).parents[1] / "data" / "tables.json").read_text())

# What the workbench says of the paper's columns. None: it can be made.
VERDICTS = [
    ("Dihedral", "Hinge1", None),
    ("Dihedral", "Hinge2", "cones are 1 mm high"),
    ("Dihedral", "Hinge3", "GapLength 0.2 mm is below the layer height"),
    ("Dihedral", "Hinge4", None),
    ("Dihedral", "Hinge5", "cones are 0.143 mm high"),
    ("Dihedral", "Hinge6", None),
    ("Dihedral", "Recommended", None),
    ("Vertex", "Hinge7", "cones are 0.714 mm high"),
    ("Vertex", "Hinge8", None),
    ("Vertex", "Hinge9", None),
    ("Vertex", "RecommendedVertex", None),
    ("NonDevelopableVertex", "RecommendedVertex", None),
]


@pytest.mark.parametrize(("kind", "preset", "words"), VERDICTS)
def test_every_column_of_the_tables(doc, kind, preset, words):
    coupon = make.make_hinge_coupon(doc, kind, preset)
    doc.recompute()
    if words:
        assert not coupon.isValid()
        assert re.search(words, coupon.getStatusString())
        return
    assert coupon.isValid(), coupon.getStatusString()
    assert coupon.BodyCount == len(coupon.Shape.Solids) == len(coupon.BodyNames)
    assert all(solid.isValid() for solid in coupon.Shape.Solids)
    assert coupon.Shape.BoundBox.ZMin == pytest.approx(0, abs=1e-6)
    for field in PRESETS[preset].doubtful:
        assert any("does not settle" in w for w in coupon.Warnings), field


def test_readable_cells_are_the_tables():
    names = {
        "rotation_angle_deg": None, "segmentations": "segmentations",
        "gap_length_mm": "gap_length", "gap_between_planes_mm": "gap_between_planes",
        "face_thickness_mm": "face_thickness", "profile_mm": "layer_height",
    }  # fmt: skip
    for table in ("table1_dihedral", "table2_four_degree_vertex"):
        rows = TABLES[table]["rows"]
        for preset, cells in TABLES[table].items():
            if not preset.startswith("Hinge"):
                continue
            doubted = " ".join(d for d in TABLES[table]["doubtful"] if d.startswith(preset))
            for row, cell in zip(rows, cells, strict=True):
                field = names.get(row)
                if field and cell is not None and field not in doubted.replace(" ", "_"):
                    assert PRESETS[preset].given[field] == cell, (preset, row)


def test_dihedral_printed_partly_open_is_higher(doc, valid):
    coupon = make.make_hinge_coupon(doc, preset=None)
    valid(doc)
    flat = coupon.PrintSize.z
    coupon.RotationAngle = 20
    valid(doc)
    assert coupon.PrintSize.z > flat + 5


def test_preset_can_be_changed_afterwards(doc, valid):
    coupon = make.make_hinge_coupon(doc, preset="Recommended")
    valid(doc)
    coupon.Segmentations = 9
    valid(doc)
    assert coupon.Segmentations == 9
    coupon.Preset = "Hinge4"
    valid(doc)
    assert coupon.Segmentations == 7


def test_refusals(doc, refused):
    coupon = make.make_hinge_coupon(doc, preset=None)
    coupon.LengthX = 3
    assert re.search("too small|LengthX|Segmentations|segments", refused(doc, coupon))
    with pytest.raises(ValueError, match="Preset 'Hinge0' is unknown"):
        make.make_hinge_coupon(doc, preset="Hinge0")
