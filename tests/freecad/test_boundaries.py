# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundaries as solids of the kernel, against the same bodies sewn from the kernel's own faces."""

from collections import Counter

import FreeCAD as App
import numpy as np
import Part
import pytest
from sewn import link_solid, plate_solid

from BistableWB.designs import building, plain, reading
from BistableWB.exporters import export
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.hinges.boundary import CONE, CYLINDER, OBLIQUE, PLANE, WARPED
from BistableWB.origami.hinges.ends import Ends
from BistableWB.origami.hinges.joints import JOINTS, Joint
from BistableWB.origami.hinges.knuckles import plate_boundary
from BistableWB.origami.hinges.layout import unit_layout
from BistableWB.origami.hinges.links import link_boundary
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.parts import part_drawn
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit
from BistableWB.origami.units.contacts import contact_pairs
from BistableWB.origami.units.general import general_unit
from BistableWB.solids.joint import part_bodies
from BistableWB.solids.shapes import boundary_of, shape_of
from BistableWB.solids.tessellation import meshed_of
from BistableWB.solids.tube import bodies_of, tube_bodies

CONES = HingeParameters()
PINS = HingeParameters(pivot="Pin", face_thickness=1.8, gap_length=0.5)
FLEXIBLE = HingeParameters(hinge_type="Flexible")
KINDS = {
    Part.Plane: PLANE,
    Part.Cylinder: CYLINDER,
    Part.Cone: CONE,
    Part.SurfaceOfExtrusion: OBLIQUE,
    Part.BSplineSurface: WARPED,
}
RISING = Bezier([[0, 0, 0], [60, 120, 20], [180, 120, 60], [240, 0, 70]])


def plane_units(thetas, edge_length, parameters):
    unit = plane_unit(np.radians(thetas), 0.42, edge_length, edge_length / 2.5)
    t, g = parameters.face_thickness, parameters.gap_between_planes
    return ThickUnit(unit, t, g).compensated()


def units_in_space(parameters):
    placed = place(RISING, 80.0, np.radians(20.0), parameters.pitch)
    unit = general_unit(*contact_pairs(placed, 32.0), 0.6)
    t, g = parameters.face_thickness, parameters.gap_between_planes
    return ThickUnit(unit, t, g).compensated()


def kinds_of(shape):
    return [KINDS[type(face.Surface)] for face in shape.Faces]


def pairs(layout, parameters):
    """(name, boundary, sewn solid) of half of a unit's bodies: the others are mirror images."""
    for name, plate in layout.plates.items():
        if not name.endswith("_lower"):
            yield name, plate_boundary(plate, parameters), plate_solid(plate, parameters)
    for name in ("link_B", "link_upper"):
        link = layout.links[name]
        yield name, link_boundary(link, parameters), link_solid(link, parameters)


def assert_same_body(name, boundary, sewn):
    shape = shape_of(boundary)
    assert shape.isValid(), name
    assert shape.Volume == pytest.approx(sewn.Volume, rel=1e-9), name
    assert boundary.volume == pytest.approx(shape.Volume, rel=1e-9), name
    assert kinds_of(shape) == boundary.kinds, name
    assert Counter(boundary.kinds) == Counter(kinds_of(sewn)), name
    areas = [face.Area for face in shape.Faces]
    assert sorted(areas) == pytest.approx(sorted(f.Area for f in sewn.Faces), rel=1e-6), name
    assert areas == pytest.approx(boundary.areas.tolist(), rel=1e-5), name


@pytest.mark.parametrize(
    ("parameters", "edge_length"), [(CONES, 60.0), (PINS, 90.0)], ids=["cones", "pins"]
)
def test_solids_are_those_that_the_kernel_sews(parameters, edge_length):
    layout = unit_layout(plane_units([45.0], edge_length, parameters).axes[0], parameters)
    for body in pairs(layout, parameters):
        assert_same_body(*body)


def test_links_whose_axes_are_not_parallel_are_those_that_the_kernel_sews():
    units = units_in_space(CONES)
    layout = unit_layout(units.axes[1], CONES)
    link = layout.links["link_upper"]
    boundary = link_boundary(link, CONES)
    assert {OBLIQUE, WARPED} < set(boundary.kinds)
    assert_same_body("link_upper", boundary, link_solid(link, CONES))


def sound(bodies):
    for body in bodies:
        assert body.shape.isValid(), body.name
        assert len(body.shape.Solids) == 1, body.name
        assert body.shape.Volume == pytest.approx(body.volume, rel=1e-9), body.name
        assert body.boundary.bounds(body.place) == pytest.approx(box_of(body.shape), abs=1e-6), (
            body.name
        )


def box_of(shape):
    box = shape.BoundBox
    return np.array([[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]])


@pytest.mark.parametrize("parameters", [CONES, FLEXIBLE], ids=["cones", "flexures"])
def test_blocks_and_half_blocks_are_sound(parameters):
    units = plane_units([40.0, 43.0, 46.0], 60.0, parameters)
    whole = [body for body in tube_bodies(units, parameters) if body.kind == "block"]
    assert len(whole) == 2
    halves = [b for b in part_bodies(units, parameters, 1, 1) if b.name.startswith("half")]
    assert len(halves) == 2
    sound(whole + halves)


@pytest.mark.parametrize("kind", JOINTS)
def test_joints_and_end_parts_are_sound(kind):
    units = plane_units([40.0, 43.0], 60.0, CONES)
    ends = Ends(Joint(kind), start="Flange", end="Plate")
    for closed in (False, True):
        drawn = part_drawn(units, CONES, 0, 1, ends=ends, closed=closed).bodies
        made = [body for body in bodies_of(drawn) if body.kind in ("joint", "foot")]
        assert len(made) == 2
        sound(made)


def test_bodies_of_units_in_space_are_sound():
    sound(tube_bodies(units_in_space(CONES)[:2], CONES))


def test_flexures_and_pockets_are_sound():
    sound(tube_bodies(plane_units([45.0], 60.0, FLEXIBLE), FLEXIBLE))


def test_a_mirror_image_knows_its_boundary_wherever_it_is_moved():
    layout = unit_layout(plane_units([45.0], 60.0, CONES).axes[0], CONES)
    boundary = plate_boundary(layout.plates["border_left"], CONES)
    mirror = np.diag([1.0, 1.0, -1.0, 1.0])
    mirror[:3, 3] = 3, 4, 5
    shape = shape_of(boundary, mirror)
    assert shape.isValid()
    found, matrix = boundary_of(shape)
    assert found is boundary
    assert matrix == pytest.approx(mirror)
    assert boundary_of(shape_of(boundary)) is not None
    assert boundary_of(Part.makeBox(1, 2, 3)) is None


def test_the_kernel_s_own_mesh_lies_where_ours_does():
    units = plane_units([45.0], 60.0, CONES)
    body = tube_bodies(units, CONES)[1]
    kernel = meshed_of(body.shape.copy(), 0.005).mesh
    assert kernel.volume == pytest.approx(body.volume, rel=2e-3)
    assert kernel.bounds == pytest.approx(body.boundary.bounds(body.place), abs=0.02)


DESIGN = """
[curve]
points = [[0, 0], [60, 160], [240, 160], [300, 0]]
[triangles]
edge_length = 80
[hinges]
last_unit = 2
[output]
formats = ["stl"]
pictures = false
report = false
"""


def test_a_print_without_a_document_is_that_of_the_document(tmp_path):
    design = reading.check(tmp_path / "it.toml", DESIGN)
    (path,), problems = plain.files_of(design, tmp_path / "plain")
    assert problems == ["without FreeCAD there is no document, no checks"]
    document = App.newDocument("Plain", hidden=True)
    try:
        export([building.build(document, design)["hinges"]], tmp_path / "it.stl")
    finally:
        App.closeDocument(document.Name)
    record = np.dtype([("floats", "<f4", 12), ("attribute", "<u2")])
    one, other = (np.fromfile(p, record, offset=84)["floats"] for p in (path, tmp_path / "it.stl"))
    assert one.shape == other.shape
    assert np.abs(one[:, 3:] - other[:, 3:]).max() < 1e-4
