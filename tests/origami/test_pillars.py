# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pillars: what no stand-off holds in a stack is held, by loose posts that touch nothing."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from BistableWB.checks.layering import Layering
from BistableWB.checks.printer import Printer
from BistableWB.origami import unit
from BistableWB.origami.hinges.bodies import tube_drawn
from BistableWB.origami.hinges.meshing import mesh_of
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.pillars import BED, Pillar, boundary_of
from BistableWB.origami.hinges.processes import STANDOFFS
from BistableWB.origami.hinges.propping import propped_print
from BistableWB.origami.hinges.standoff_inputs import StandOffs
from BistableWB.origami.meshes import PlacedMesh, unpaired_edges
from BistableWB.origami.thick.linkage import ThickUnit

RIBS = HingeParameters(segment_width=5.0, process=STANDOFFS, standoffs=StandOffs())


@pytest.fixture(scope="module")
def stack():
    """Bodies of three units of an arch, and what holds them."""
    theta = radians(50) + np.array([0.0, 0.02, 0.05])
    made = unit.plane_unit(theta, np.sin(theta / 2) + 0.08, 60.0, 24.0)
    thick = ThickUnit(made, RIBS.face_thickness, RIBS.gap_between_planes).compensated()
    drawn = tube_drawn(thick, RIBS)
    return drawn, propped_print(drawn, RIBS)


def meshes(drawn, pillars=()):
    made = [
        PlacedMesh(b.name, mesh_of(b.boundary).mesh, b.place, b.unit, b.members, b.kind)
        for b in drawn
    ]
    return made + [
        PlacedMesh(f"pillar{k}", mesh_of(p.boundary()).mesh, np.eye(4), drawn[p.holds].unit, (),
                   "foot")
        for k, p in enumerate(pillars)
    ]  # fmt: skip


def findings(bodies):
    found = Layering(bodies, Printer(), None, "stand-offs", alone=True).findings()
    return {finding.code: finding for finding in found}


@pytest.mark.slow
def test_everything_in_a_stack_is_held_and_nothing_touches(stack):
    drawn, made = stack
    bare = findings(meshes(drawn))
    assert "island" in bare
    held = findings(meshes(drawn, made.pillars))
    assert "island" not in held
    assert held["fused"].number == 0
    assert held["overhang"].limit is None
    assert made.left_area < 1.0
    plastic = sum(b.boundary.volume for b in drawn)
    assert 0 < boundary_of(made.pillars).volume < 0.02 * plastic


@pytest.mark.slow
def test_the_check_finds_a_pillar_that_touches_or_is_too_short(stack):
    drawn, made = stack
    tall = [p._replace(high=p.high + 0.2) for p in made.pillars]
    assert findings(meshes(drawn, tall))["fused"].number > 0.15
    short = [p._replace(high=p.high - 0.4) for p in made.pillars if p.high - p.low > 1]
    flat = [p for p in made.pillars if p.high - p.low <= 1]
    assert short
    assert "island" in findings(meshes(drawn, [*short, *flat]))


@pytest.mark.slow
def test_pillars_keep_clear_of_all_bodies_on_their_meshes(stack):
    """Corners of every body against the boxes of all pillars: none lies within 0.15 mm."""
    drawn, made = stack
    for pillar in made.pillars:
        half = pillar.width / 2 + 0.15
        low = np.array([pillar.x - half, pillar.y - half, pillar.low - (pillar.low > 0) * 0.15])
        high = np.array([pillar.x + half, pillar.y + half, pillar.high + 0.15])
        for body in meshes(drawn):
            points = body.placed.vertices
            assert not ((points > low) & (points < high)).all(1).any(), body.name


@pytest.mark.parametrize(("base", "volume"), [
    (0.0, 1.2**2 * 6), (1.0, 1.2**2 * 5.6 + 3.2**2 * 0.4),
])  # fmt: skip
def test_a_pillar_is_a_closed_body(base, volume):
    pillar = Pillar(3.0, -2.0, 0.0, 6.0, 1.2, 0, BED, base, 0.2)
    mesh = mesh_of(boundary_of([pillar, pillar._replace(x=20.0)])).mesh
    assert not len(unpaired_edges(mesh.triangles))
    assert mesh.volume == pytest.approx(2 * volume)


def test_without_pillars_there_are_none():
    bare = replace(RIBS, standoffs=StandOffs(pillars=False))
    assert propped_print([], bare).pillars == []
    assert propped_print([], replace(RIBS, standoffs=None)).pillars == []
