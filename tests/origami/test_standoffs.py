# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stand-offs: closed bodies of the volume that was predicted, which hold up and stay clear."""

import json
from dataclasses import replace
from math import radians
from pathlib import Path

import numpy as np
import pytest

from BistableWB.checks.layering import Layering
from BistableWB.checks.printer import Printer
from BistableWB.checks.printing import Print
from BistableWB.origami import unit
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.rules import PlacementRule
from BistableWB.origami.design import CurveGeometry, Placing, Thickness, TubeDesign
from BistableWB.origami.errors import Refusal
from BistableWB.origami.hinges import standoffs, volumes
from BistableWB.origami.hinges.bodies import printed_layouts, tube_drawn
from BistableWB.origami.hinges.meshing import mesh_of
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.processes import STANDOFFS
from BistableWB.origami.hinges.standoff_inputs import StandOffs
from BistableWB.origami.hinges.sweeping import swept
from BistableWB.origami.hinges.triangulation import cut_of
from BistableWB.origami.meshes import PlacedMesh, unpaired_edges
from BistableWB.origami.thick.linkage import ThickUnit

RIBS = HingeParameters(segment_width=5.0, process=STANDOFFS, standoffs=StandOffs())


def thick_units(count=1, edge=60.0, theta=50.0):
    ratio = np.sin(radians(theta) / 2) + 0.08
    made = unit.plane_unit(np.full(count, radians(theta)), np.full(count, ratio), edge, edge / 2.5)
    return ThickUnit(made, RIBS.face_thickness, RIBS.gap_between_planes).compensated()


@pytest.fixture(scope="module")
def thick():
    return thick_units()


def meshes(drawn):
    return [
        PlacedMesh(b.name, mesh_of(b.boundary).mesh, b.place, b.unit, b.members, b.kind)
        for b in drawn
    ]


def findings(drawn):
    layering = Layering(meshes(drawn), Printer(), None, "stand-offs", alone=True)
    return {finding.code: finding for finding in layering.findings()}


def test_bodies_with_ribs_are_closed_and_have_the_predicted_volume(thick):
    layout = printed_layouts(thick, RIBS)[0]
    predicted = {n: volumes.plate_volume(p, RIBS) for n, p in layout.plates.items()}
    predicted |= {n: volumes.link_volume(link, RIBS) for n, link in layout.links.items()}
    drawn = tube_drawn(thick, RIBS)
    plain = tube_drawn(thick, replace(RIBS, standoffs=None))
    assert sum(b.boundary.volume for b in drawn) > 1.04 * sum(b.boundary.volume for b in plain)
    for body in drawn:
        assert not len(body.boundary.unpaired())
        mesh = mesh_of(body.boundary).mesh
        assert not len(unpaired_edges(mesh.triangles)), body.name
        assert body.boundary.volume == pytest.approx(predicted[body.name[7:]], rel=1e-9)
        assert mesh.volume == pytest.approx(body.boundary.volume, rel=0.005)


@pytest.mark.slow
@pytest.mark.parametrize(("edge", "theta"), [(62, 35), (72, 58), (80, 66), (90, 48), (103.7, 41.3)])
def test_bodies_of_any_size_are_closed(edge, theta):
    for body in tube_drawn(thick_units(2, edge, theta), RIBS):
        mesh = mesh_of(body.boundary).mesh
        assert not len(unpaired_edges(mesh.triangles)), body.name
        assert mesh.volume == pytest.approx(body.boundary.volume, rel=0.005)


@pytest.mark.slow
def test_ribs_keep_clear_of_the_next_block_where_a_tube_climbs():
    """Units of a climbing curve lie aside of each other: a block sees past the one above it."""
    points = [(0, 0, 0), (33, 66, 6), (84, 96, 13), (133, 89, 20)]
    curve = CurveGeometry(Bezier(points), "General", ("parallel", (0.0, 0.0, 1.0)))
    panels = Thickness(RIBS.face_thickness, RIBS.gap_between_planes)
    where = Placing(curve, 75.0, radians(30), panels.pitch, rule=PlacementRule("EndFit"))
    tube = TubeDesign(where, thickness=panels).thick()
    printed = Print(meshes(tube_drawn(tube.thick, RIBS, tube.tube.incoming_left)), RIBS)
    assert [str(found) for found in printed.check_flat() if found.severity == "error"] == []
    found = printed.check_poses(tube.motions(0.25), 0.25)
    assert [str(one) for one in found if one.severity != "note"] == []


@pytest.mark.slow
def test_nothing_starts_in_mid_air_or_hangs_too_far(thick):
    bare = findings(tube_drawn(thick, replace(RIBS, standoffs=None)))
    assert "island" in bare
    assert bare["overhang"].limit is not None
    found = findings(tube_drawn(thick, RIBS))
    assert "island" not in found
    assert found["fused"].number == 0
    assert found["overhang"].limit is None, str(found["overhang"].message)


@pytest.mark.slow
def test_a_rib_that_touches_what_it_holds_is_found(thick, monkeypatch):
    made = standoffs.with_standoffs

    def touching(*args):
        return [
            replace(layout, plates={
                name: replace(plate, studs=tuple(s._replace(height=s.height + 0.2)
                                                 for s in plate.studs))
                for name, plate in layout.plates.items()
            })
            for layout in made(*args)
        ]  # fmt: skip

    monkeypatch.setattr("BistableWB.origami.hinges.bodies.with_standoffs", touching)
    assert findings(tube_drawn(thick, RIBS))["fused"].number > 50


@pytest.mark.slow
def test_equal_units_in_equal_company_are_worked_out_once(monkeypatch):
    asked = []
    found = standoffs._Stack.standing
    monkeypatch.setattr(standoffs, "_KNOWN", {})
    monkeypatch.setattr(
        standoffs._Stack, "standing", lambda self, k: asked.append(k) or found(self, k)
    )
    tube = thick_units(6)
    printed_layouts(tube, RIBS)
    assert len(asked) < 6
    asked.clear()
    printed_layouts(tube, RIBS)
    assert not asked


@pytest.mark.parametrize(("given", "name"), [
    ({"spacing": 12.0}, "StandOffSpacing"), ({"spacing": float("nan")}, "StandOffSpacing"),
    ({"width": 0.3}, "StandOffWidth"), ({"air_layers": 0}, "AirLayers"),
    ({"air_layers": 3}, "AirLayers"),
])  # fmt: skip
def test_ribs_that_cannot_be_are_refused(given, name):
    with pytest.raises(Refusal) as said:
        replace(RIBS, standoffs=StandOffs(**given)).check()
    assert said.value.parameter == name


@pytest.mark.parametrize("turn", [0.0, 0.3, np.pi / 4])
def test_faces_with_many_holes_in_line_are_cut_well(turn):
    rng = np.random.default_rng(7)
    loops = [[0j, 60 + 0j, 60 + 40j, 40j]]
    for corner in (10 * x + 10j * y for x in range(6) for y in range(4)):
        (x, w), (y, h) = (sorted(rng.choice(np.arange(1, 10), 2, replace=False)) for _ in "xy")
        loops.append([corner + x + 1j * y, corner + x + 1j * h, corner + w + 1j * h,
                      corner + w + 1j * y])  # fmt: skip
    points = np.array([p for loop in loops for p in loop]) * np.exp(1j * turn)
    cut = swept(np.stack([points.real, points.imag], 1), tuple(map(len, loops)))
    a, b, c = points[cut].T
    twice = ((b - a).conj() * (c - a)).imag
    holes = sum(abs(loop[2].real - loop[0].real) * abs(loop[1].imag - loop[0].imag)
                for loop in loops[1:])  # fmt: skip
    assert len(cut) == len(points) + 2 * (len(loops) - 1) - 2
    assert twice.min() > 0.01
    assert twice.sum() / 2 == pytest.approx(2400 - holes)


def test_a_face_that_crosses_itself_is_told_and_never_hangs():
    box = [0j, 60 + 0j, 60 + 40j, 40j]
    ribs = [[x + 5j, x + 35j, x + 1 + 35j, x + 1 + 5j] for x in range(5, 55, 3)]
    hole = [17 + 20j + 3 * np.exp(-1j * a) for a in np.linspace(0, 2 * np.pi, 22, endpoint=False)]
    loops = [box, hole, *ribs]
    points = np.array([p for loop in loops for p in loop])
    with pytest.raises(RuntimeError, match="crosses itself"):
        swept(np.stack([points.real, points.imag], 1), tuple(map(len, loops)))


def test_corners_all_but_in_one_line_leave_no_flat_triangle():
    """The top of a block of the arch: knuckles along an edge that is straight but for 1e-5 mm."""
    face = json.loads((Path(__file__).parents[1] / "data" / "flat_corners.json").read_text())
    plan = np.array(face["plan"])
    cut = cut_of(plan, face["size"])
    (ax, ay), (bx, by), (cx, cy) = plan[cut].transpose(1, 2, 0)
    twice = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    longest = np.sqrt(((plan[cut] - plan[np.roll(cut, 1, 1)]) ** 2).sum(-1).max(-1))
    assert len(cut) == len(plan)
    assert (twice / longest).min() > 5e-5
