# SPDX-License-Identifier: LGPL-2.1-or-later
"""Joints and end parts: watertight, of the volume that is known, and never in anybody's way."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from shapes import ARCH, Heart, Ring
from test_steering import UP, closed_tube

from BistableWB.origami.curves.corners import Rounded
from BistableWB.origami.errors import Refusal
from BistableWB.origami.hinges.clips import clip_for
from BistableWB.origami.hinges.ends import END_PARTS, Ends, plate_plan
from BistableWB.origami.hinges.joints import JOINTS, Joint, clearance_hole, half_thickness
from BistableWB.origami.hinges.meshing import mesh_of
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.parts import part_drawn
from BistableWB.origami.hinges.processes import STANDOFFS
from BistableWB.origami.hinges.standoff_inputs import StandOffs
from BistableWB.origami.meshes import unpaired_edges
from BistableWB.origami.snap.materials import material
from BistableWB.origami.units.creases import BODIES
from tests.judges import judge

P = HingeParameters()
FLEXIBLE = HingeParameters(hinge_type="Flexible", bond_width=1.5)
# What single precision of the judge makes of faces that touch, mm³.
TOUCHING = 2e-3


@pytest.fixture(scope="module")
def ring():
    return closed_tube(Ring(190), UP, "Plane", None, 60)


@pytest.fixture(scope="module")
def arch():
    return closed_tube(ARCH, UP, "Plane", None, 60)


def print_of(tube, ends, parameters=P, first=0, last=None):
    last = len(tube.tube) - 1 if last is None else last
    given = tube.thick, parameters, first, last, tube.tube.incoming_left
    part = part_drawn(*given, ends=ends, closed=tube.is_closed)
    return part.bodies, replace(tube.part(first, last), lift=part.lift)


def solid(body, motion=None):
    manifold3d = judge("manifold3d")
    mesh = mesh_of(body.boundary).mesh.moved((np.eye(4) if motion is None else motion) @ body.place)
    found = manifold3d.Manifold(
        manifold3d.Mesh(np.float32(mesh.vertices), np.uint32(mesh.triangles))
    )
    assert found.status() == manifold3d.Error.NoError, body.name
    return found


def lowest(bodies):
    return min(b.boundary.bounds(b.place)[0, 2] for b in bodies if b.unit == 0)


def motion_of(tube, body, opening):
    unit, name = body.members[0]
    return tube.motions(opening)[unit, BODIES.index(name)]


def overlap(tube, bodies, kind, opening):
    """mm³ that bodies of a kind share with any other near the ends."""
    last = len(tube.tube) - 1
    motions = tube.motions(opening)
    near = [b for b in bodies if b.kind == kind or b.unit in (0, 1, last - 1, last)]
    stand = {
        b.name: solid(b, motions[b.unit, BODIES.index(b.members[0][1])] if opening else None)
        for b in near
        if b.members
    }
    ours = [b.name for b in near if b.kind == kind]
    assert len(ours) == 2
    return sum((stand[a] ^ stand[b]).volume() for a in ours for b in stand if a != b)


@pytest.mark.slow
@pytest.mark.parametrize("kind", JOINTS)
def test_halves_never_meet_another_body_and_fit_when_deployed(ring, kind):
    bodies, tube = print_of(ring, Ends(Joint(kind)))
    assert lowest(bodies) == pytest.approx(0, abs=1e-4)
    assert max(overlap(tube, bodies, "joint", o) for o in (0, 0.25, 0.75, 1)) < TOUCHING
    halves = [b for b in bodies if b.kind == "joint"]
    low, high = (solid(b, motion_of(tube, b, 1)) for b in halves)
    for half, body in zip((low, high), halves, strict=True):
        assert half.volume() == pytest.approx(body.boundary.volume, rel=2e-3)
    assert low.min_gap(high, 1.0) < 2e-3  # face to face
    plain = [b for b in print_of(ring, Ends(Joint("None")))[0] if b.kind == "joint"]
    missing = sum(b.boundary.volume for b in plain) - sum(b.boundary.volume for b in halves)
    through = 2 * half_thickness(P)
    known = {
        "None": 0.0,
        "Dowel": 2 * pi / 4 * 1.95**2 * through,
        "Screw": 2 * pi / 4 * clearance_hole(3.0) ** 2 * through,
        "Magnet": 4 * pi / 4 * 5.2**2 * 1.1,
    }
    if kind in known:
        assert missing == pytest.approx(known[kind], abs=1e-6)


class LargeHeart(Heart):
    def point(self, s):
        return 2.5 * super().point(s)


@pytest.mark.slow
@pytest.mark.parametrize(("curve", "family", "edge"), [
    (Ring(240, 160), "Plane", 60), (Rounded(LargeHeart(), Heart.kinks, 75), "Plane", 60),
    (Ring(400, 400, 40), "General", 120),
], ids=["ellipse", "heart", "loop in space"])  # fmt: skip
def test_closed_tubes_of_any_shape_join_face_to_face(curve, family, edge):
    """On the exported meshes: the halves stand against each other, and nothing is in their way."""
    tube = closed_tube(curve, UP, family, None, edge)
    bodies, tube = print_of(tube, Ends(Joint("Clip")))
    touching = 2e-6 * edge**2  # the judge's single precision, over faces that touch when deployed
    assert max(met_by_the_other_end(tube, bodies, o) for o in np.linspace(0, 1, 9)) < touching
    assert max(overlap(tube, bodies, "joint", o) for o in (0, 0.25)) < touching
    low, high = (solid(b, motion_of(tube, b, 1)) for b in bodies if b.kind == "joint")
    assert low.min_gap(high, 1.0) < 2e-3
    plain, _ = print_of(tube, Ends(Joint("None")))
    faces = [outer_face(tube, b) for b in plain if b.kind == "joint"]
    (first, normal, area), (second, against, other) = faces
    assert normal @ against == pytest.approx(-1, abs=1e-7)
    assert abs((second - first) @ normal) < 1e-3
    assert area == pytest.approx(other, rel=1e-6)
    assert np.linalg.norm(second - first) < 1e-3


def met_by_the_other_end(tube, bodies, opening):
    """mm³ that a joint's halves share with the bodies of the tube's other end."""
    last, motions = len(tube.tube) - 1, tube.motions(opening)
    ends = [
        [b for b in bodies if b.members and b.unit in units] for units in ((0, 1), (last - 1, last))
    ]
    stand = [
        {b.name: solid(b, motions[b.unit, BODIES.index(b.members[0][1])]) for b in end}
        for end in ends
    ]
    halves = [next(b.name for b in end if b.kind == "joint") for end in ends]
    return sum(
        (stand[k][half] ^ other).volume()
        for k, half in enumerate(halves)
        for other in stand[1 - k].values()
    )


def outer_face(tube, body):
    """(middle, normal, area) of the face by which half a block meets the other, deployed."""
    mesh = mesh_of(body.boundary).mesh.moved(motion_of(tube, body, 1) @ body.place)
    flat = mesh_of(body.boundary).mesh.moved(body.place)
    level = flat.vertices[:, 2].min() if body.unit == 0 else flat.vertices[:, 2].max()
    on = (np.abs(flat.corners[:, :, 2] - level) < 1e-6).all(1)
    corners = mesh.corners[on]
    areas = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    size = np.linalg.norm(areas, axis=1)
    middle = (corners.mean(1) * size[:, None]).sum(0) / size.sum()
    return middle, areas.sum(0) / size.sum(), size.sum()


@pytest.mark.parametrize("kind", JOINTS)
def test_stand_offs_keep_beside_what_goes_through_their_panel(arch, kind):
    ribbed = HingeParameters(segment_width=5.0, process=STANDOFFS, standoffs=StandOffs())
    halves = []
    for parameters in (ribbed, replace(ribbed, standoffs=None)):
        bodies, _ = print_of(arch, Ends(Joint(kind)), parameters, 3, 4)
        halves.append([body for body in bodies if body.kind == "joint"])
        for body in halves[-1]:
            mesh = mesh_of(body.boundary).mesh
            assert not len(unpaired_edges(mesh.triangles))
            assert solid(body).volume() == pytest.approx(body.boundary.volume, rel=2e-3)
    with_ribs, without = ([b.boundary.volume for b in some] for some in halves)
    assert max(np.subtract(with_ribs, without)) > 5


def test_clips_hold_what_they_join(ring):
    bodies, tube = print_of(ring, Ends(Joint("Clip")))
    halves = [b for b in bodies if b.kind == "joint"]
    low, high = (solid(b, motion_of(tube, b, 1)) for b in halves)
    away = tube.placement.reaches[0]
    normal = np.cross(away, [0, 0, 1.0])
    normal *= np.sign(normal @ (centre(low) - centre(high)))
    for direction, far in ((normal, 0.4), (away, 0.4), (-away, 0.4)):
        pulled = low.translate((far * direction / np.linalg.norm(direction)).tolist())
        assert (pulled ^ high).volume() > 0.1
    plain = [b for b in print_of(ring, Ends(Joint("Dowel")))[0] if b.kind == "joint"]
    free, other = (solid(b, motion_of(tube, b, 1)) for b in plain)
    assert (free.translate((0.4 * normal).tolist()) ^ other).volume() == 0


def centre(found):
    box = np.array(found.bounding_box()).reshape(2, 3)
    return box.mean(0)


def test_a_clips_strain_is_what_the_material_bears():
    for name in ("PLA", "PETG", "TPU"):
        own = material(name)
        clip = clip_for(own.snap_strain, half_thickness(P), P)
        assert clip.strain <= own.snap_strain * (1 + 1e-9)
        arm = clip.length - 0.15 - 1.5  # to the middle of the post
        force = 3 * own.young * clip.width**3 * clip.ledge / 12 * clip.overhang / arm**3
        stress = force * arm / (clip.ledge * clip.width**2 / 6)
        assert stress / own.young == pytest.approx(clip.strain)


@pytest.mark.slow
@pytest.mark.parametrize("kind", [kind for kind, part in END_PARTS.items() if part.has_plate])
def test_end_parts_never_meet_another_body(arch, kind):
    bodies, tube = print_of(arch, Ends(start=kind, end=kind))
    assert lowest(bodies) == pytest.approx(0, abs=1e-4)
    assert max(overlap(tube, bodies, "foot", o) for o in (0, 0.1, 0.5, 0.9, 1)) < TOUCHING
    for body in bodies:
        if body.kind == "foot":
            assert solid(body).volume() == pytest.approx(body.boundary.volume, rel=1e-3)


def test_screw_holes_of_a_flange_lie_outside_the_panels():
    quad = [0, 60, 60 + 24j, 24j]
    outline, holes = plate_plan(quad, Joint(), "Flange", P)
    assert len(holes) == 4
    for place, radius in holes:
        outside = max(-place.real, place.real - 60, -place.imag, place.imag - 24)
        assert outside > radius
        sides = zip(outline, [*outline[1:], outline[0]], strict=True)
        walls = [((b - a).conjugate() * (place - a)).imag / abs(b - a) for a, b in sides]
        assert min(walls) > radius + 0.8 - 1e-9


def test_parts_of_a_cut_tube_are_lifted_in_every_state(arch):
    """A part that lies on its half block deploys to where the whole tube has it."""
    bodies, part = print_of(arch, Ends(), first=1, last=2)
    whole_bodies, whole = print_of(arch, Ends())
    name = "border_left"
    found = next(b for b in bodies if b.name == f"unit01_{name}")
    goal = next(b for b in whole_bodies if b.name == f"unit02_{name}")
    points = mesh_of(found.boundary).mesh.moved(motion_of(part, found, 1) @ found.place).vertices
    other = mesh_of(goal.boundary).mesh.moved(motion_of(whole, goal, 1) @ goal.place).vertices
    assert points == pytest.approx(other, abs=0.02)
    start = motion_of(part, found, 0)
    assert start == pytest.approx(np.eye(4), abs=1e-9)


def test_flexible_halves_are_watertight(arch):
    for kind in ("Dowel", "Magnet"):
        bodies, _ = print_of(arch, Ends(Joint(kind), start="Flange"), FLEXIBLE, 0, 1)
        for body in bodies:
            if body.kind in ("joint", "foot"):
                assert solid(body).volume() == pytest.approx(body.boundary.volume, rel=2e-3)


@pytest.mark.parametrize(
    ("ends", "parameter"),
    [
        (lambda: Ends(Joint("Glue")), "Joint"),
        (lambda: Ends(Joint("Magnet", magnet_depth=3)), "MagnetDepth"),
        (lambda: Ends(Joint("Magnet", magnet_diameter=30)), "MagnetDiameter"),
        (lambda: Ends(Joint("Screw", screw_diameter=25)), "ScrewDiameter"),
        (lambda: Ends(Joint("Dowel", dowel_diameter=0)), "DowelDiameter"),
        (lambda: Ends(Joint("Clip", strain=1e-4)), "Joint"),
        (lambda: Ends(start="Hook"), "StartPart"),
        (lambda: Ends(thickness=-1), "PlateThickness"),
    ],
)
def test_what_cannot_be_is_refused_with_a_cure(ring, ends, parameter):
    with pytest.raises(Refusal) as error:
        print_of(ring, ends())
    assert error.value.parameter == parameter
    assert "set" in str(error.value) or "choose" in str(error.value)


def test_the_size_that_a_refusal_names_fits(ring):
    for kind, field in (("Magnet", "magnet_diameter"), ("Screw", "screw_diameter")):
        with pytest.raises(Refusal) as error:
            print_of(ring, Ends(Joint(kind, **{field: 40.0})))
        most = round(float(error.value.message.pieces["most"]), 1)
        print_of(ring, Ends(Joint(kind, **{field: most})))
