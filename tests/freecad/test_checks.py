"""Checks of hinged prints: silent on a good print, each loud on one that is broken on purpose."""

from dataclasses import replace

import numpy as np
import pytest

from BistableWB.checks import ERROR, NOTE, WARNING
from BistableWB.checks.printing import Print
from BistableWB.origami import unit
from BistableWB.origami.hinges import bed
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.meshes import Mesh
from BistableWB.origami.thick import print_stack
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.solids.joint import DOWEL, dowel_places, part_bodies
from BistableWB.solids.tessellation import placed_meshes
from BistableWB.solids.tube import tube_bodies

PARAMETERS = HingeParameters(segmentations=3)


def thick_units(count, edge_length=60.0, theta=45.0):
    thetas = np.radians(np.linspace(theta, theta + 3, count))
    units = unit.plane_unit(thetas, thetas / np.radians(45) * 0.42, edge_length, 0.4 * edge_length)
    thick = ThickUnit(units, PARAMETERS.face_thickness, PARAMETERS.gap_between_planes)
    return thick.compensated()


@pytest.fixture(scope="module")
def two():
    thick = thick_units(2)
    return thick, tube_bodies(thick, PARAMETERS)


@pytest.fixture(scope="module")
def meshes(two):
    return placed_meshes(two[1])


def pair(meshes, *names):
    return [next(mesh for mesh in meshes if mesh.name == name) for name in names]


def moved(body, x=0.0, y=0.0, z=0.0):
    shift = np.eye(4)
    shift[:3, 3] = x, y, z
    return body._replace(place=shift @ body.place)


def test_a_good_print_has_nothing_but_notes(two, meshes):
    volumes = [body.shape.Volume for body in two[1]]
    whole = Print(meshes, PARAMETERS)
    assert whole.check_soundness(volumes) == []
    (flat,) = whole.check_flat()
    assert (flat.severity, flat.code) == (NOTE, "clearance")
    assert flat.number >= PARAMETERS.smallest_clearance - 0.02
    for opening in (0.0, 1.0):
        (found,) = whole.check_poses(print_stack.motions(two[0], opening), opening)
        assert (found.severity, found.number) == (NOTE, 0)


def test_on_the_way_only_hinges_overlap_and_by_no_more_than_their_snap(two, meshes):
    whole = Print(meshes, PARAMETERS)
    deepest = []
    for opening in (0.4, 0.8):
        motions, misfits = print_stack.motions(two[0], opening), two[0].misfit(opening)
        (found,) = whole.check_poses(motions, opening, misfits)
        assert found.severity == NOTE
        deepest.append(found.number)
    assert deepest[0] == 0 < deepest[1]
    narrow = Print(meshes, replace(PARAMETERS, gap_length=0.05))
    motions = print_stack.motions(two[0], 0.8)
    assert {f.severity for f in narrow.check_poses(motions, 0.8)} == {WARNING}


def test_without_compensation_the_deployed_state_is_refused():
    thick = thick_units(2)
    plain = ThickUnit(thick.unit, PARAMETERS.face_thickness, PARAMETERS.gap_between_planes)
    whole = Print(placed_meshes(tube_bodies(plain, PARAMETERS)), PARAMETERS)
    found = whole.check_poses(print_stack.motions(plain, 1.0), 1.0)
    assert {finding.severity for finding in found} == {ERROR}
    assert found[0].number > 0.05
    assert len(found[0].bodies) == 2


def test_a_fused_hinge_an_overlap_and_a_small_gap_are_found(meshes):
    names = "unit01_border_left", "unit01_border_right"
    left, right = pair(meshes, *names)
    for shift, state in ((0.4, "in contact"), (0.3, "apart")):
        found = Print([left, moved(right, y=shift)], PARAMETERS).check_flat()
        assert [finding.bodies for finding in found] == [names]
        assert state in str(found[0].message)
        assert "GapLength" in str(found[0].cure)
        assert found[0].points
    still = np.broadcast_to(np.eye(4), (1, 15, 4, 4))
    for depth in (0.1, 0.3):
        found = Print([left, moved(right, y=0.4 + depth)], PARAMETERS).check_poses(still, 0)
        assert found[0].severity == ERROR
        assert found[0].number == pytest.approx(depth, abs=0.06)
    upper, lower = pair(meshes, "unit01_contact_left", "unit01_border_left")
    sunk = moved(lower, z=-0.5)
    found = Print([upper, sunk], PARAMETERS).check_flat()
    assert found[0].severity == ERROR


def test_a_panel_too_near_to_one_that_it_has_no_hinge_with(meshes):
    names = "unit01_border_left", "block01_02"
    below, block = pair(meshes, *names)
    found = Print([below, moved(block, z=-2 * PARAMETERS.pitch - 0.5)], PARAMETERS).check_flat()
    assert found[0].severity == ERROR
    assert "GapBetweenPlanes" in str(found[0].cure)


@pytest.mark.parametrize(
    ("code", "damage"),
    [
        ("open", lambda v, t: (v, t[1:])),
        ("orientation", lambda v, t: (v, np.concatenate([t[:1, ::-1], t[1:]]))),
        ("inside_out", lambda v, t: (v, t[:, ::-1])),
        ("self_intersection", lambda v, t: (np.where(np.arange(len(v))[:, None] == 7, -v, v), t)),
        ("volume", lambda v, t: (v * 1.01, t)),
    ],
)
def test_a_broken_mesh_is_found(two, meshes, code, damage):
    body, solid = meshes[2], two[1][2].shape
    broken = Mesh(*damage(*body.placed))
    broken = body._replace(mesh=broken, place=np.eye(4))
    found = Print([broken], PARAMETERS).check_soundness([solid.Volume])
    assert code in {finding.code for finding in found}
    assert {finding.bodies for finding in found} == {(body.name,)}


def test_print_size_is_known_before_anything_is_built(two):
    thick, bodies = two
    corners, margin = bed.outlines(thick, PARAMETERS)
    size = bed.print_size(corners, margin, PARAMETERS)
    boxes = np.array([[mesh.placed.bounds] for mesh in placed_meshes(bodies)])[:, 0]
    extent = boxes[:, 1].max(0) - boxes[:, 0].min(0)
    assert size.height == pytest.approx(extent[2], abs=1e-4)
    for planned, measured in zip((size.width, size.depth), extent, strict=False):
        assert measured <= planned + 1e-3
        assert planned < measured + 8
    assert boxes[:, 0].min(0)[2] == pytest.approx(0, abs=1e-4)


def test_a_print_that_fits_and_ones_that_do_not():
    thick = thick_units(6)
    (found,) = bed.check_bed(thick, PARAMETERS, bed.Bed())
    assert found.severity == NOTE
    low = bed.Bed(height=16)
    (found,) = bed.check_bed(thick, PARAMETERS, low)
    assert found.severity == ERROR
    assert "2 units fit" in str(found.message)
    assert "1–2, 3–4, 5–6" in str(found.cure)
    assert bed.split(thick, PARAMETERS, low) == [(0, 1), (2, 3), (4, 5)]
    # five of six would fit into the first: two prints of three are better than 5 and 1
    height = bed.print_size(*bed.outlines(thick[:5], PARAMETERS, None), PARAMETERS, low).height
    five = bed.Bed(height=height)
    assert bed.split(thick, PARAMETERS, five) == [(0, 2), (3, 5)]
    (found,) = bed.check_bed(thick, PARAMETERS, five)
    assert "5 units fit" in str(found.message)
    assert "1–3, 4–6" in str(found.cure)
    (found,) = bed.check_bed(thick, PARAMETERS, bed.Bed(20, 20, 20))
    assert "Not even one unit" in str(found.message)
    assert found.number > 1
    assert "EdgeLength" in str(found.cure)
    long = bed.Bed(64, 20, 200)
    turned = bed.print_size(*bed.outlines(thick, PARAMETERS), PARAMETERS, long)
    assert turned.width / long.width > 1 or turned.depth / long.depth > 1


def test_halves_of_a_cut_block_fit_and_take_dowels():
    thick = thick_units(4)
    whole = tube_bodies(thick, PARAMETERS)
    block = next(body for body in whole if body.name == "block02_03").shape
    parts = [part_bodies(thick, PARAMETERS, *run) for run in ((0, 1), (2, 3))]
    halves = [[b for b in part if b.name.startswith("half_")] for part in parts]
    assert [len(found) for found in halves] == [1, 1]
    holes = 2 * np.pi * ((DOWEL + 0.2) / 2) ** 2
    holes *= 2 * PARAMETERS.face_thickness + PARAMETERS.gap_between_planes
    assert sum(found[0].shape.Volume for found in halves) == pytest.approx(
        block.Volume - holes, rel=1e-3
    )
    # Laid on each other as in the whole tube, the halves meet in one plane and nowhere overlap.
    frames = (
        print_stack.frames(thick),
        [print_stack.frames(thick[2:4], print_stack.alternating(4)[2:])],
    )
    move = frames[0][2] @ np.linalg.inv(frames[1][0][0])
    move[2, 3] -= PARAMETERS.gap_between_planes / 2
    lower, upper = placed_meshes([halves[0][0], halves[1][0]])
    upper = upper._replace(place=move @ upper.place)
    assert lower.placed.bounds[1, 2] == pytest.approx(upper.placed.bounds[0, 2], abs=1e-3)
    outline = np.concatenate([lower.placed.vertices, upper.placed.vertices])
    box = block.BoundBox
    assert np.ptp(outline, axis=0) == pytest.approx(
        [box.XLength, box.YLength, box.ZLength], abs=0.1
    )
    holes_at = [_hole_centres(half.placed) for half in (lower, upper)]
    assert holes_at[0] == pytest.approx(holes_at[1], abs=1e-3)
    for part in parts:
        whole_part = Print(placed_meshes(part), PARAMETERS)
        assert [f.severity for f in whole_part.check_flat()] == [NOTE]
        assert whole_part.check_soundness() == []
        assert min(body.shape.BoundBox.ZMin for body in part) > -1e-3


def _hole_centres(mesh):
    """Plan positions of the two dowel holes: rings of points around them in the joint plane."""
    plane = mesh.bounds[1, 2] if mesh.bounds[1, 2] < 15 else mesh.bounds[0, 2]
    points = mesh.vertices[np.abs(mesh.vertices[:, 2] - plane) < 1e-3][:, :2]
    radius = (DOWEL + 0.2) / 2
    centres = []
    for point in points:
        near = points[np.linalg.norm(points - point, axis=1) < 2 * radius + 1e-3]
        if len(near) > 12:
            centre = (near.min(0) + near.max(0)) / 2
            if not centres or np.linalg.norm(centres - centre, axis=1).min() > 1:
                centres.append(centre)
    return np.array(sorted(map(tuple, centres)))


def test_dowels_tell_the_two_ends_apart():
    square = [0, 20, 20 + 8j, 8j]
    first, second = dowel_places(square)
    assert abs((first + second) / 2 - (10 + 4j)) > 0.5
    assert first.imag == second.imag == pytest.approx(4)
