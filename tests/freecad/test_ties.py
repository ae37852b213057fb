# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ties of a HingeSet: valid solids of one colour, exported, checked, told where to cut."""

import pytest

from BistableWB import checking, exporters, make
from BistableWB.reports.tie_section import tie_section


def test_a_unit_on_edge_is_tied_checked_and_exported(doc, valid, tmp_path):
    unit = make.make_bistable_unit(doc, theta=50, ratio=0.5, edge_length=50)
    hinges = make.make_hinge_set(doc, unit)
    hinges.Process = "FDM, ties"
    assert hinges.Orientation == "OnEdge"
    valid(doc)
    model = hinges.Proxy.model(hinges)
    found = model.tied()
    assert found.ties
    shape = model.tie_shape()
    assert all(solid.isValid() for solid in shape.Solids)
    volume = sum(tie.boundary().volume for tie in found.ties)
    assert shape.Volume == pytest.approx(volume, rel=1e-6)
    name, _, kind = hinges.Proxy.export_bodies(hinges)[-1]
    assert (name, kind) == ("ties", "foot")
    exporters.export([hinges], tmp_path / "unit.3mf")
    codes = {f.code: f.severity for f in checking.check(hinges)}
    assert codes["start"] == "note"
    assert "tie" not in codes
    assert shape.BoundBox.ZMin > -1e-6
    names = [body.name for body in model.bodies]
    plastic = sum(body.volume for body in model.bodies)
    material = hinges.Proxy.conditions(hinges).material
    told = tie_section(found, names, plastic, model.parameters, material)
    assert sum(int(row[2]) for row in told.rows) == len(found.ties)
    hinges.Orientation = "Flat"
    valid(doc)
    assert hinges.Proxy.export_bodies(hinges)[-1][2] != "foot"
    assert "start" not in {f.code for f in checking.check(hinges)}
