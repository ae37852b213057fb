# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids of units, tubes, coupons, flexible hinges and support: bodies, volumes and clearances."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import Part
import pytest
import sewn
from FreeCAD import Vector

from BistableWB.origami.hinges.layout import unit_layout
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.presets import PRESETS
from BistableWB.origami.progress import Cancelled, Progress
from BistableWB.origami.thick import print_stack
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit, sphere_unit
from BistableWB.origami.units.creases import BODIES, CREASES
from BistableWB.solids.coupons import KINDS, coupon_bodies
from BistableWB.solids.support import support_body
from BistableWB.solids.tube import layout_solids, moved, tube_bodies
from tests.judges import judge

DEFAULT = HingeParameters()
FLEXIBLE = HingeParameters(hinge_type="Flexible")


def thick(theta, ratio=0.42, edge_length=60.0, height=24.0, parameters=DEFAULT):
    unit = plane_unit(np.radians(theta), ratio, edge_length, height)
    return ThickUnit(unit, parameters.face_thickness, parameters.gap_between_planes).compensated()


@pytest.fixture(scope="module")
def single():
    units = thick([45.0])
    return units, tube_bodies(units, DEFAULT)


@pytest.fixture(scope="module")
def pair():
    units = thick([40.0, 46.0])
    return units, tube_bodies(units, DEFAULT)


def placed(bodies, units, opening):
    """Shapes of the bodies at an opening of the tube, None for those without a pose."""
    moves = print_stack.motions(units, opening)
    return {
        b.name: moved(b.shape, moves[b.members[0][0], BODIES.index(b.members[0][1])])
        for b in bodies
    }


def near(shapes, margin):
    """Pairs of names whose boxes are less than ``margin`` mm apart."""
    boxes = {}
    for name, shape in shapes.items():
        box = shape.BoundBox
        box.enlarge(margin / 2)
        boxes[name] = box
    return [(a, b) for a, b in combinations(shapes, 2) if boxes[a].intersect(boxes[b])]


def nearest(shapes, pairs):
    return min((shapes[a].distToShape(shapes[b])[0], a, b) for a, b in pairs)


def overlaps(shapes, pairs):
    """(depth mm, names) of overlaps; the depth is that of a sheet of the overlap's volume."""
    found = []
    for a, b in pairs:
        common = shapes[a].common(shapes[b])
        if common.Volume > 1e-6:
            found.append((2 * common.Volume / common.Area, a, b))
    return found


def lower_left(pairs):
    """The pairs that mirror images of a plane unit do not repeat."""
    return [p for p in pairs if "_lower" not in p[0] + p[1] and "right" not in p[0]]


def hinged():
    """The pairs that share a hinge, once for all mirror images (distances cost 0.3 s each)."""
    kinds = [c.bodies for c in CREASES if "_lower" not in c.name and "_right" not in c.name]
    return [(f"unit01_{a}", f"unit01_{b}") for a, b in kinds]


def sound(bodies):
    for body in bodies:
        assert body.shape.ShapeType == "Solid", body.name
        assert body.shape.isValid(), body.name
        assert body.shape.Volume > 0, body.name


def test_one_unit_is_fifteen_sound_bodies(single):
    _, bodies = single
    assert [name for b in bodies for _, name in b.members] == list(BODIES)
    sound(bodies)


def test_print_stands_on_the_bed_and_is_as_high_as_the_layers(single, pair):
    for count, (_, bodies) in enumerate((single, pair), 1):
        box = Part.makeCompound([b.shape for b in bodies]).BoundBox
        assert box.ZMin == pytest.approx(0, abs=1e-6)
        high = count * 4 * DEFAULT.pitch - DEFAULT.gap_between_planes
        assert box.ZMax == pytest.approx(high, abs=1e-6)


def test_flat_bodies_keep_the_clearance(single):
    _, bodies = single
    shapes = {b.name: b.shape for b in bodies}
    distance, *names = nearest(shapes, hinged())
    assert distance > DEFAULT.smallest_clearance - 0.02, names


def test_deployed_bodies_do_not_overlap(single):
    units, bodies = single
    shapes = placed(bodies, units, 1.0)
    assert overlaps(shapes, lower_left(near(shapes, 0.0))) == []


@pytest.mark.parametrize("opening", [0.35, 0.75])
def test_bodies_on_the_way_overlap_less_than_the_play(single, opening):
    units, bodies = single
    shapes = placed(bodies, units, opening)
    for depth, *names in overlaps(shapes, lower_left(near(shapes, 0.0))):
        assert depth < DEFAULT.play, names


def boolean_volume(plate, parameters):
    """Volume of a panel by OCC's booleans of boxes, cylinders and cones."""
    half = parameters.face_thickness / 2
    up = Vector(0, 2 * half, 0)
    core = sewn.polygon([sewn.at(p, plate.height - half) for p in plate.core]).extrude(up)
    add, cut = [core], []
    for tab in plate.tabs:
        start, end = tab.hinge.segments[tab.index]
        axis = sewn.at(tab.hinge.direction, 0.0)
        corners = [tab.corner(0, 0.0), tab.corner(0), tab.corner(1), tab.corner(1, 0.0)]
        floor = sewn.polygon([sewn.at(p, plate.height - half) for p in corners])
        low = sewn.at(tab.hinge.point(start), tab.hinge.height)
        high = sewn.at(tab.hinge.point(end), tab.hinge.height)
        add += [floor.extrude(up), Part.makeCylinder(parameters.radius, end - start, low, axis)]
        cone = parameters.cone_base, parameters.tip_radius(tab.hinge.cone_height)
        if tab.index < len(tab.hinge.segments) - 1:
            add.append(Part.makeCone(*cone, tab.hinge.cone_height, high, axis))
        if tab.index:
            cut.append(Part.makeCone(*cone, tab.hinge.cone_height, low, axis))
    return add[0].multiFuse(add[1:]).cut(Part.makeCompound(cut)).Volume


@pytest.mark.parametrize("name", ["contact_left", "border_right", "secondary_right_lower"])
def test_volume_agrees_with_booleans_of_primitives(single, name):
    units, bodies = single
    layout = unit_layout(units.axes[0], DEFAULT)
    shape = next(b.shape for b in bodies if b.members[0][1] == name)
    expected = boolean_volume(layout.plates[name], DEFAULT)
    assert shape.Volume == pytest.approx(expected, rel=1e-3)


def test_volume_agrees_with_that_of_the_mesh(single):
    for body in single[1][1::5]:
        points, triangles = body.shape.tessellate(0.02)
        corners = np.array([tuple(p) for p in points])[np.array(triangles)]
        volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
        assert volume == pytest.approx(body.shape.Volume, rel=1e-3), body.name


def test_a_mesh_kernel_finds_the_flat_bodies_apart(single):
    manifold3d = judge("manifold3d")
    trimesh = judge("trimesh")
    total = 0.0
    solids = []
    for body in single[1]:
        points, triangles = body.shape.tessellate(0.05)
        mesh = trimesh.Trimesh([tuple(p) for p in points], triangles)
        mesh.merge_vertices()
        solid = manifold3d.Manifold(
            manifold3d.Mesh(np.float32(mesh.vertices), np.uint32(mesh.faces))
        )
        total += solid.volume()
        solids.append(solid)
    union = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add)
    assert union.volume() == pytest.approx(total, rel=1e-6)
    assert len(union.decompose()) == len(BODIES)


def test_units_of_a_tube_share_blocks_and_stay_apart(pair):
    _, bodies = pair
    assert len(bodies) == 2 * 15 - 1
    sound(bodies)
    block = next(b for b in bodies if b.name.startswith("block"))
    assert block.members == ((0, "contact_right"), (1, "contact_right"))
    thickness = 2 * DEFAULT.face_thickness + DEFAULT.gap_between_planes
    # barrels of both units belong to the block; between them it is 2t + g thick
    assert block.shape.BoundBox.ZLength == pytest.approx(2 * thickness + 0.6, abs=1e-6)
    shapes = {b.name: b.shape for b in bodies}
    pairs = [(block.name, "unit01_primary_right_upper"), (block.name, "unit02_link_B")]
    distance, *names = nearest(shapes, pairs)
    assert distance > DEFAULT.smallest_clearance - 0.02, names


def test_progress_counts_units_and_can_cancel():
    units, seen = thick([45.0, 45.0]), []

    progress = Progress(lambda text, fraction: seen.append(fraction), lambda: len(seen) == 1)
    with pytest.raises(Cancelled):
        tube_bodies(units, DEFAULT, progress=progress)
    assert seen == [0.5]


def test_another_thickness_than_the_unit_s_is_refused(single):
    with pytest.raises(ValueError, match="FaceThickness"):
        tube_bodies(single[0], replace(DEFAULT, face_thickness=1.0))


def test_a_unit_without_room_is_named():
    with pytest.raises(ValueError, match=r"Unit 1: Hinge \w+.*EdgeLength"):
        tube_bodies(thick([45.0], edge_length=30.0, height=20.0), DEFAULT)


@pytest.mark.parametrize("pivot", ["Cone", "Pin"])
def test_spherical_units_with_both_pivots(pivot):
    parameters = HingeParameters(pivot=pivot, face_thickness=1.8, gap_length=0.5)
    unit = sphere_unit(np.radians([45.0]), 90.0, np.radians(80), 36.0)
    bodies = tube_bodies(ThickUnit(unit, 1.8, 0.6).compensated(), parameters)
    assert len(bodies) == 15
    sound(bodies)


def test_flexible_strips_fill_what_the_panels_leave():
    layout = unit_layout(thick([45.0], parameters=FLEXIBLE).axes[0], FLEXIBLE)
    solids = layout_solids(layout, FLEXIBLE)
    panels = [(n, s) for n, s, kind in solids if kind != "flexure"]
    strips = [(n, s) for n, s, kind in solids if kind == "flexure"]
    assert (len(panels), len(strips)) == (12, 20)
    contact = dict(panels)["contact_left"]
    assert contact.isValid()
    whole = contact
    for name, strip in strips:
        assert strip.isValid()
        assert len(strip.Solids) == 1, name
        if name in ("flexure_leg_A_left", "flexure_AB_left_upper", "flexure_link_B"):
            assert contact.common(strip).Volume < 1e-6, name
            assert contact.distToShape(strip)[0] < 1e-6, name
            whole = whole.fuse(strip)
    parts = [contact, *(s for n, s in strips if n in _BESIDE_CONTACT)]
    assert whole.Volume == pytest.approx(sum(part.Volume for part in parts), rel=1e-6)
    assert len(whole.Solids) == 1


_BESIDE_CONTACT = ("flexure_leg_A_left", "flexure_AB_left_upper", "flexure_link_B")


@pytest.mark.parametrize(
    ("kind", "preset", "size"),
    [
        ("Dihedral", "Hinge4", (45, 36, 2.4)),
        ("Vertex", "Hinge8", (20, 36, 5.6)),
        ("NonDevelopableVertex", "Hinge9", (50, 32, 6.6)),
    ],
)
def test_coupons_have_the_paper_s_size(kind, preset, size):
    chosen = PRESETS[preset]
    bodies = coupon_bodies(kind, chosen.parameters(), *chosen.size[:2])
    sound(bodies)
    assert len(bodies) == (2 if kind == "Dihedral" else 5)
    box = Part.makeCompound([b.shape for b in bodies]).BoundBox
    assert (box.XMin, box.YMin, box.ZMin) == pytest.approx((0, 0, 0), abs=1e-6)
    assert box.ZLength == pytest.approx(size[2], abs=1e-6)
    assert box.XLength == pytest.approx(size[0], abs=1.2)
    assert box.YLength == pytest.approx(size[1], abs=0.1)
    shapes = {b.name: b.shape for b in bodies}
    distance, *names = nearest(shapes, near(shapes, 0.3))
    assert distance > chosen.parameters().smallest_clearance - 0.02, names


def test_a_dihedral_is_printed_partly_open():
    parameters = replace(PRESETS["Hinge4"].parameters(), rotation_angle=np.radians(30))
    bodies = coupon_bodies("Dihedral", parameters)
    box = bodies[1].shape.BoundBox
    assert box.ZMax > 36 * np.sin(np.radians(30))
    shapes = {b.name: b.shape for b in bodies}
    assert nearest(shapes, near(shapes, 0.3))[0] > parameters.smallest_clearance - 0.02


@pytest.mark.parametrize("kind", KINDS)
def test_coupons_with_flexible_hinges(kind):
    bodies = coupon_bodies(kind, FLEXIBLE)
    sound(bodies)
    assert {b.material for b in bodies} == {"rigid", "flexible"}


def test_support_fills_gaps_and_nothing_else(pair):
    units, bodies = pair
    support = support_body(units, DEFAULT)
    assert support.shape.isValid()
    assert len(support.shape.Solids) > 20
    for body in bodies:
        assert body.shape.common(support.shape).Volume < 1e-6, body.name
    lowest = bodies[0]
    assert lowest.shape.distToShape(support.shape)[0] < 1e-6
