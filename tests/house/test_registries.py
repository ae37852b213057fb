# SPDX-License-Identifier: LGPL-2.1-or-later
"""A new format, check, hinge kind or family is one line: a stranger in a table is seen everywhere.

What panels show of them is tests/gui/test_registries.py.
"""

import importlib
import sys
from pathlib import Path

import pytest

from BistableWB.checks.suite import Suite
from BistableWB.checks.table import ALL, CHECKS, Check, Finds
from BistableWB.exporters.formats import FORMATS, SOLIDS, Format
from BistableWB.origami.curves.families import FAMILIES, Family
from BistableWB.origami.hinges.kinds import HINGE_KINDS, HingeKind
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.processes import BY_POWDER, PROCESSES, Process

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def tables(monkeypatch):
    """docs/tables.py."""
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    yield importlib.import_module("tables")
    sys.modules.pop("tables")


@pytest.fixture
def keys(monkeypatch):
    """The keys of design files, read anew from the registries as they are now."""

    def fresh():
        monkeypatch.delitem(sys.modules, "BistableWB.designs.keys", raising=False)
        return importlib.import_module("BistableWB.designs.keys")

    yield fresh
    monkeypatch.undo()


def test_a_new_format(monkeypatch, keys, tables):
    stranger = Format("stranger", SOLIDS, "what nobody knows", keys=("tabs",))
    monkeypatch.setitem(FORMATS, ".strange", stranger)
    now = keys()
    assert "strange" in now.TABLES["output"]["formats"].choices
    assert "strange" in now.PRINT_FORMATS
    assert "strange" in now.FORMATS_OF["tabs"]
    assert "what nobody knows" in tables.page_with("formats")


def test_a_new_check(monkeypatch, tables):
    row = Finds("strange", "something odd", "none", "note")
    monkeypatch.setitem(CHECKS, "strange", Check("Odd things…", "check_strange", ALL, (row,)))
    monkeypatch.setattr(Suite, "check_strange", lambda self: ["odd"], raising=False)
    steps = dict(Suite([], [], HingeParameters(), None).steps())
    assert steps["strange"]() == ["odd"]
    assert "something odd" in tables.page_with("checks")


def test_a_new_kind_of_hinge(monkeypatch, keys, tables):
    monkeypatch.setitem(HINGE_KINDS, "Magnetic", HingeKind("magnets on both sides", knuckles=False))
    for table in ("hinges", "coupon"):
        assert "Magnetic" in keys().TABLES[table]["hinge_type"].choices
    parameters = HingeParameters(hinge_type="Magnetic")
    parameters.check()
    assert parameters.play == 0
    assert "magnets on both sides" in tables.page_with("hinge kinds")


def test_a_new_family(monkeypatch, keys, tables):
    stranger = Family("on a torus", "square to it", keys={"torus_radius": "TorusRadius"})
    monkeypatch.setitem(FAMILIES, "Torus", stranger)
    assert "Torus" in keys().TABLES["curve"]["kind"].choices
    assert "on a torus" in tables.page_with("families")


def test_a_new_process(monkeypatch, keys, tables):
    given = PROCESSES["Powder"].gives
    stranger = Process("cast in clay", given, "Flat", "PLA", BY_POWDER, 0.0, "nowhere")
    monkeypatch.setitem(PROCESSES, "Clay", stranger)
    assert "Clay" in keys().TABLES["hinges"]["process"].choices
    HingeParameters(process="Clay").check()
    assert "cast in clay" in tables.page_with("processes")


@pytest.mark.parametrize(
    "name", ["formats", "checks", "hinge kinds", "processes", "families", "parts"]
)
def test_tables_of_pages_are_up_to_date(tables, name):
    page, _ = tables.TABLES[name]
    assert (ROOT / "docs" / page).read_text(encoding="utf-8") == tables.page_with(name), "make docs"


def test_the_picture_of_the_architecture_is_up_to_date(tables):
    drawn = (ROOT / "docs/architecture.svg").read_text(encoding="utf-8")
    assert drawn == tables.picture(), "make docs"
    assert all(f">{part}</text>" in drawn for part in tables.walls())
