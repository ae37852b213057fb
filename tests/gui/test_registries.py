# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strangers in the tables of formats, checks, hinges, families and types are seen in the window."""

import sys
import types

import FreeCAD as App
import pytest
from PySide import QtGui

from BistableWB import make, objects
from BistableWB.checks.suite import Suite
from BistableWB.checks.table import ALL, CHECKS, Check
from BistableWB.commands import output
from BistableWB.exporters.formats import FORMATS, SOLIDS, Format
from BistableWB.objects.base import BistableObject, Prop, make_object
from BistableWB.objects.curve import Curve
from BistableWB.objects.hinge_inputs import HINGE_PROPERTIES
from BistableWB.origami.curves.families import FAMILIES
from BistableWB.origami.hinges.kinds import HINGE_KINDS
from BistableWB.taskpanels import panel_for
from BistableWB.taskpanels.check import CheckPanel


@pytest.fixture
def doc(gui):
    """An empty document."""
    made = App.newDocument()
    yield made
    App.closeDocument(made.Name)


@pytest.fixture
def coupon(doc):
    made = make.make_hinge_coupon(doc)
    doc.recompute()
    return made


def test_a_new_format_is_in_the_dialog(coupon, monkeypatch):
    monkeypatch.setitem(FORMATS, ".strange", Format("stranger", SOLIDS, "what nobody knows"))
    asked = []
    monkeypatch.setattr(
        QtGui.QFileDialog, "getSaveFileName", lambda *given: asked.append(given[3]) or ("", "")
    )
    output.ask_for_path(coupon)
    assert "STRANGE (*.strange)" in asked[0].split(";;")


def test_a_new_check_is_made_and_named_by_the_panel(coupon, gui, monkeypatch):
    monkeypatch.setitem(CHECKS, "strange", Check("Odd things…", "check_strange", ALL, ()))
    monkeypatch.setattr(Suite, "check_strange", lambda self: [], raising=False)
    panel = CheckPanel(coupon)
    while not panel._steps:
        gui(0.1)
    panel.reject()
    assert "Odd things…" in [text for text, _ in panel._steps]


def test_panels_offer_all_kinds_of_hinges_and_families():
    choices = {prop.name: prop.default for prop in (*HINGE_PROPERTIES, *Curve.PROPERTIES)}
    assert choices["HingeType"] == list(HINGE_KINDS)
    assert set(FAMILIES) <= set(choices["Kind"])
    tips = {prop.name: prop.tip for prop in (*HINGE_PROPERTIES, *Curve.PROPERTIES)}
    assert all(f"{name}: {kind.what}" in tips["HingeType"] for name, kind in HINGE_KINDS.items())
    assert all(f"{name}: " in tips["Kind"] and name in tips["FoundKind"] for name in FAMILIES)


class Stranger(BistableObject):
    Type = "Bistable::Stranger"
    PROPERTIES = (Prop("Length", "Oddness", "Odd", "How odd it is", 3.0),)

    def generate(self, obj):
        pass


def test_a_new_type_has_an_object_a_look_and_a_panel(doc, monkeypatch):
    module = types.ModuleType("BistableWB.objects.stranger")
    module.Stranger = Stranger
    monkeypatch.setitem(sys.modules, module.__name__, module)
    monkeypatch.setitem(objects.TYPES, Stranger.Type, objects.Type("stranger", "Stranger"))
    assert objects.proxy_class(Stranger.Type) is Stranger
    made = make_object(doc, Stranger.Type, "Odd", Stranger)
    assert type(made.ViewObject.Proxy).__name__ == "BistableView"
    panel = panel_for(made)
    assert "Oddness" in panel.fields
    panel.reject()
