# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pillars of a HingeSet: valid solids, exported as a body of their own, counted by the check."""

from pathlib import Path

import numpy as np
import pytest

from BistableWB import checking, exporters
from BistableWB.designs import building, reading
from BistableWB.reports.tie_section import pillar_section
from BistableWB.solids.tessellation import shared

ARCH = Path(__file__).parents[2] / "resources/examples/hinged-arch.toml"


@pytest.mark.slow
def test_a_stack_is_exported_with_its_pillars(doc, valid, tmp_path):
    hinges = building.build(doc, reading.read(ARCH))["hinges"]
    hinges.LastUnit = 2
    valid(doc)
    model = hinges.Proxy.model(hinges)
    pillars = model.propped().pillars
    assert pillars
    shape = model.pillar_shape()
    assert all(solid.isValid() for solid in shape.Solids)
    assert len(shape.Solids) == len(pillars)
    name, exported, kind = hinges.Proxy.export_bodies(hinges)[-1]
    assert (name, kind) == ("pillars", "foot")
    mesh = shared().mesh(exported)
    assert mesh.volume == pytest.approx(shape.Volume, rel=1e-6)
    assert exported.BoundBox.ZMin > -1e-6
    with_them, without = tmp_path / "with.stl", tmp_path / "without.stl"
    exporters.export([hinges], with_them)
    codes = {f.code for f in checking.check(hinges)}
    assert "pillar" in codes
    assert "island" not in codes
    told = pillar_section(model.propped(), sum(body.volume for body in model.bodies))
    assert str(len(pillars)) in str(told.text)
    hinges.Pillars = False
    valid(doc)
    assert hinges.Proxy.export_bodies(hinges)[-1][2] != "foot"
    exporters.export([hinges], without)
    assert with_them.stat().st_size - without.stat().st_size >= 50 * 12 * len(pillars)
    found = {f.code: f for f in checking.check(hinges)}
    assert "pillar" not in found
    assert np.isfinite(found["island"].number)
