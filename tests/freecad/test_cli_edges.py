# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line at its edges: hostile names, an end from outside, every key there is."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from BistableWB import ROOT
from BistableWB.designs import keys as design_table
from BistableWB.objects.bistable_unit import BistableUnit
from BistableWB.origami.hinges.ends import END_PARTS
from BistableWB.origami.hinges.joints import JOINTS
from BistableWB.origami.units.ratios import RULES
from BistableWB.program import cli
from BistableWB.solids.coupons import KINDS

ARCH = """
[curve]
points = [[0, 0], [60, 120], [180, 120], [240, 0]]
[triangles]
edge_length = 80
"""
PYTHON = shutil.which("python3", path="/usr/bin") or shutil.which("python3")


@pytest.mark.parametrize("name", ["...", "a\x1b[31mred", "n\udcff"])
def test_names_that_steer_a_terminal_or_leave_the_folder_are_refused(capfd, tmp_path, name):
    path = tmp_path / f"{name}.toml"
    path.write_text(ARCH)
    assert cli.main([str(path), "--out", str(tmp_path / "out")]) == 2
    said = capfd.readouterr().err
    assert "rename it" in said
    assert said.rstrip("\n").isprintable()
    assert list((tmp_path / "out").iterdir()) == []


def test_an_end_from_outside_ends_freecad_too(tmp_path):
    design = tmp_path / "arch.toml"
    design.write_text(ARCH)
    environment = {**os.environ, "PATH": "/usr/bin:/bin"}
    program = subprocess.Popen(
        [PYTHON, "-m", "BistableWB", str(design), "--out", str(tmp_path / "out")],
        env=environment, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True,
        cwd=Path(__file__).parents[2],
    )  # fmt: skip
    assert "units" in program.stderr.readline()
    program.terminate()
    assert "Interrupted." in program.stderr.read()  # it is closed when both have ended
    assert program.wait(timeout=30) == 130
    assert [p for p in (tmp_path / "out").rglob("*") if "writing" in p.name] == []


def test_every_key_sets_a_property_that_exists_and_is_documented(doc):
    from BistableWB import make

    objects = {
        "curve": make.make_curve(doc),
        "triangles": make.make_triangle_placement(doc, None),
        "unit": make.make_bistable_unit(doc),
        "hinges": make.make_hinge_set(doc, None),
        "coupon": make.make_hinge_coupon(doc),
        "calibration": make.make_calibration_plate(doc),
    }
    text = (ROOT / "docs/design-files.md").read_text(encoding="utf-8")
    for table, keys in design_table.TABLES.items():
        part = text.split(f"### [{table}]")[1].split("\n### ")[0]
        for key, entry in keys.items():
            assert re.search(rf"^\|.*`{key}`.*\|.*\|.*\|$", part, re.M), (
                f"[{table}] {key} is not in docs/design-files.md"
            )
            if entry.property:
                assert entry.property in objects[table].PropertiesList
                if entry.choices:
                    known = objects[table].getEnumerationsOfProperty(entry.property)
                    assert set(entry.choices) <= set(known)
    assert design_table.RATIO_RULES == RULES
    assert design_table.COUPON_KINDS == KINDS
    assert tuple(JOINTS) == design_table.JOINT_KINDS
    assert tuple(END_PARTS) == design_table.END_KINDS
    assert BistableUnit.Type in objects["unit"].BistableType
