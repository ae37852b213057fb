# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ties of units on edge: what they hold, that they come off, and checks that find broken ones."""

from math import radians

import numpy as np
import pytest

from BistableWB.checks.tying import check_ties
from BistableWB.origami.design import Single, Thickness, TubeDesign
from BistableWB.origami.hinges.bodies import tube_drawn
from BistableWB.origami.hinges.edge_turn import best_turn, edges_of, on_bed, wanted
from BistableWB.origami.hinges.meshing import mesh_of
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.processes import TIES
from BistableWB.origami.hinges.starts import labelled, starts_of
from BistableWB.origami.hinges.ties import BED, Tie, breaking_force, knuckle_bears
from BistableWB.origami.hinges.tying import tied
from BistableWB.origami.layers import Layers
from BistableWB.origami.meshes import Mesh, PlacedMesh, component_labels, unpaired_edges
from BistableWB.origami.snap.materials import PLA, material
from BistableWB.origami.units.ratios import RatioRule
from tests.judges import judge

HINGE = HingeParameters(segment_width=5.0, process=TIES)
LAYER, NECK = HINGE.layer_height, HINGE.nozzle_diameter
UNITS = ((50, 50),)  # theta, ‖AB‖


def flat_unit(theta, edge):
    """`PlacedMesh` of one unit, flat."""
    design = TubeDesign(
        Single(radians(theta), edge, radians(90), HINGE.pitch), RatioRule("Fixed", ratio=0.5), 2.5,
        thickness=Thickness(HINGE.face_thickness, HINGE.gap_between_planes, True, 0.0),
    )  # fmt: skip
    thick = design.thick()
    return [
        PlacedMesh(body.name, mesh_of(body.boundary).mesh, body.place, body.unit, body.members,
                   body.kind)
        for body in tube_drawn(thick.thick, HINGE, thick.tube.incoming_left)
    ]  # fmt: skip


@pytest.fixture(scope="module", params=UNITS, ids=str)
def print_on_edge(request):
    """(bodies on the bed, `Tied`, meshes of the ties) with the best turn."""
    flat = flat_unit(*request.param)
    bodies = on_bed(flat, best_turn(flat, LAYER, NECK))
    found = tied(bodies, LAYER, NECK)
    return bodies, found, [mesh_of(tie.boundary()).mesh for tie in found.ties]


@pytest.mark.slow
def test_ties_hold_all_but_a_square_millimetre_and_take_little(print_on_edge):
    bodies, found, meshes = print_on_edge
    assert len(found.starts) > 40
    assert found.left_area <= 1.0
    plastic = sum(body.mesh.volume for body in bodies)
    assert sum(mesh.volume for mesh in meshes) < 0.02 * plastic
    told = check_ties(bodies, meshes, LAYER, NECK)
    assert [f.severity for f in told] == ["note"], [str(f) for f in told]


@pytest.mark.slow
def test_every_tie_is_closed_steep_and_no_thicker_than_a_knuckle_bears(print_on_edge):
    _, found, meshes = print_on_edge
    for tie, mesh in zip(found.ties, meshes, strict=True):
        assert len(unpaired_edges(mesh.triangles)) == 0
        assert component_labels(mesh.triangles, len(mesh.vertices)).max() == 0
        assert mesh.volume == pytest.approx(tie.boundary().volume)
        way = tie.knee - tie.foot
        assert np.hypot(*way[:2]) <= way[2] + 0.3  # 45°, and the raster
        assert tie.on == BED or tie.foot[2] > 0
    pla = material(PLA)
    assert breaking_force(NECK, pla) <= knuckle_bears(HINGE.face_thickness, pla) / 2 + 1e-9


@pytest.mark.slow
def test_checks_find_ties_that_are_missing_or_stay(print_on_edge):
    """Prints broken for it: no ties, half of them, a block that joins two panels for good."""
    bodies, _, meshes = print_on_edge
    for kept in ([], meshes[::2]):
        start = check_ties(bodies, kept, LAYER, NECK)[0]
        assert (start.severity, start.code) == ("warning", "start")
        assert start.number > 1.0
    by_name = {body.name[7:]: body.placed for body in bodies}
    pair = [by_name[name] for name in ("contact_left", "border_left")]
    middle = (np.max([m.bounds[0] for m in pair], 0) + np.min([m.bounds[1] for m in pair], 0)) / 2
    for size in ((8, 4, 2), (40, 1, 1)):
        block = _box(middle, size)
        found = [f for f in check_ties(bodies, [*meshes, block], LAYER, NECK) if f.code == "tie"]
        assert [f.severity for f in found] == ["error"]
        assert "stay fused" in str(found[0])


def _box(middle, size):
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]) - 0.5
    triangles = np.array([
        [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
        [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
    ])  # fmt: skip
    return Mesh(middle + corners * size, triangles)


@pytest.mark.slow
def test_cutting_all_ties_gives_the_moving_bodies(print_on_edge):
    """On the meshes, by manifold3d: with ties all hang together; cut at their heads, none do."""
    manifold3d = judge("manifold3d")
    bodies, found, meshes = print_on_edge

    def solid(mesh):
        return manifold3d.Manifold(
            manifold3d.Mesh(np.float32(mesh.vertices), np.uint32(mesh.triangles))
        )

    def parts(ties):
        union = manifold3d.Manifold.batch_boolean(
            [*(solid(body.placed) for body in bodies), *ties], manifold3d.OpType.Add
        )
        return union.decompose()

    whole = [solid(mesh) for mesh in meshes]
    assert len(parts(whole)) == 1
    saw = [solid(_box(tie.cuts[0], (3, 3, 0.02))) for tie in found.ties]
    cut = parts([tie - blade for tie, blade in zip(whole, saw, strict=True)])
    on_bed_only = [part for part in cut if part.volume() < 10]
    assert len(cut) - len(on_bed_only) == len(bodies)
    assert all(part.bounding_box()[2] < 1e-6 for part in on_bed_only)  # pillars that are left over
    volumes = sorted(body.mesh.volume for body in bodies)
    found = sorted(part.volume() for part in cut)[len(on_bed_only) :]
    assert found == pytest.approx(volumes, abs=8)  # and stubs


@pytest.mark.slow
def test_a_turn_about_the_stack_saves_ties_and_stands_as_firmly():
    flat = flat_unit(*UNITS[0])
    turns = edges_of(flat)
    found = wanted(flat, turns)
    chosen = int(np.abs(turns - best_turn(flat, LAYER, NECK)).argmin())
    assert found.area[chosen] >= 0.9 * found.area[0]
    assert found.size[chosen, 0] <= found.size[0, 0] + 1e-6
    assert found.ties[chosen] <= found.ties[0]


def test_islands_and_ledges_of_a_layer():
    """A bridge of two pillars: its middle is a ledge, a drop under it an island."""
    inside = np.zeros((6, 20, 120), bool)
    inside[:4, :, :10] = inside[:4, :, -10:] = True
    inside[3, 8:12, 58:62] = True  # the drop
    inside[4:] = True
    starts = starts_of(3, Layers(inside, np.array([0, 0, 0])))
    island, *ledges = starts
    assert (island.layer, island.is_island, island.area) == (3, True, pytest.approx(0.16))
    assert all(start.layer == 4 and not start.is_island for start in ledges)
    assert sum(ledge.area for ledge in ledges) == pytest.approx(20 * (100 - 30) * 0.01, rel=0.6)
    carrier = Layers(inside[:4] * 0 + True, np.array([0, 0, 0]))
    assert starts_of(3, Layers(inside, np.array([0, 0, 0])), carrier) == []


def test_pieces_of_a_raster_are_counted():
    area = np.zeros((5, 7), bool)
    area[0, 0] = area[1, 1] = area[4, 2:5] = area[0, 6] = True
    labels, count = labelled(area)
    assert count == 3
    assert labels[0, 0] == labels[1, 1] != labels[0, 6]


@pytest.mark.parametrize("corners", [True, False])
@pytest.mark.parametrize("seed", range(6))
def test_pieces_of_any_raster_are_those_of_a_flood(corners, seed):
    """Filled pixel by pixel, in the order of their first pixels."""
    rng = np.random.default_rng(seed)
    area = rng.random(rng.integers(1, 24, 2)) < rng.uniform(0.2, 0.8)
    steps = [(a, b) for a in (-1, 0, 1) for b in (-1, 0, 1) if corners or a * b == 0]
    wanted, count = np.zeros(area.shape, int), 0
    for start in np.argwhere(area):
        if wanted[tuple(start)]:
            continue
        count += 1
        todo = [tuple(start)]
        while todo:
            row, column = todo.pop()
            inside = 0 <= row < area.shape[0] and 0 <= column < area.shape[1]
            if not inside or not area[row, column] or wanted[row, column]:
                continue
            wanted[row, column] = count
            todo += [(row + a, column + b) for a, b in steps]
    labels, found = labelled(area, corners)
    assert found == count
    assert (labels == wanted).all()


def test_a_long_tie_is_a_pillar_with_necks():
    tie = Tie((0.0, 0.0, 0.0), (0.0, 0.0, 12.0), 0.4, 1.2, 0, BED, 0.2)
    widths = [width for *_, width in tie.rings()]
    assert widths == [1.2, 1.2, 0.4, 0.4, 0.4]
    assert len(tie.cuts) == 1
    other = tie._replace(on=2)
    assert [w for *_, w in other.rings()] == [0.4, 0.4, 1.2, 1.2, 0.4, 0.4, 0.4]
    assert len(other.cuts) == 2
    for one in (tie, other):
        mesh = mesh_of(one.boundary()).mesh
        assert len(unpaired_edges(mesh.triangles)) == 0
        assert mesh.volume == pytest.approx(one.boundary().volume)
