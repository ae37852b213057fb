# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundaries as data: closed, of the right volume, and meshes of them that are watertight.

Volumes are compared with closed forms of the layout, which know no faces; meshes with manifold3d,
which knows nothing of boundaries.
"""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.hinges.boundary import CONE, CYLINDER, PLANE
from BistableWB.origami.hinges.drafting import Draft
from BistableWB.origami.hinges.knuckles import plate_boundary
from BistableWB.origami.hinges.layout import unit_layout
from BistableWB.origami.hinges.links import link_boundary
from BistableWB.origami.hinges.meshing import chords_for, meshed
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.triangulation import cut_of
from BistableWB.origami.hinges.volumes import link_volume, plate_volume
from BistableWB.origami.meshes import component_labels, unpaired_edges
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit
from BistableWB.origami.units.contacts import contact_pairs
from BistableWB.origami.units.general import general_unit
from tests.judges import judge

PIN = HingeParameters(pivot="Pin", face_thickness=1.8, gap_length=0.5)
FINE = HingeParameters(
    face_thickness=0.8, gap_between_planes=0.2, gap_length=0.2, layer_height=0.05,
    nozzle_diameter=0.2,
)  # fmt: skip
RISING = Bezier([[0, 0, 0], [60, 120, 20], [180, 120, 60], [240, 0, 70]])


def layout_of(theta, ratio, edge_length, parameters):
    unit = plane_unit(np.radians([theta]), ratio, edge_length, edge_length / 2.5)
    t, g = parameters.face_thickness, parameters.gap_between_planes
    return unit_layout(ThickUnit(unit, t, g).compensated().axes[0], parameters, edge_length)


def rising_layouts(parameters):
    """Layouts of units of a curve in space, whose double hinges are not quite parallel."""
    placed = place(RISING, 80.0, np.radians(20.0), parameters.pitch)
    left, right = contact_pairs(placed, 32.0)
    unit = general_unit(left, right, 0.6)
    t, g = parameters.face_thickness, parameters.gap_between_planes
    thick = ThickUnit(unit, t, g).compensated()
    return [unit_layout(axes, parameters, 80.0) for axes in thick.axes]


def boundaries(layout, parameters):
    """(name, boundary, volume in closed form) of all plates and links."""
    for name, plate in layout.plates.items():
        yield name, plate_boundary(plate, parameters), plate_volume(plate, parameters)
    for name, link in layout.links.items():
        yield name, link_boundary(link, parameters), link_volume(link, parameters)


def test_bodies_of_a_unit_are_planes_cylinders_and_cones():
    found = boundaries(layout_of(45, 0.42, 60.0, HingeParameters()), HingeParameters())
    kinds = [kind for _, body, _ in found for kind in body.kinds]
    assert set(kinds) == {PLANE, CYLINDER, CONE}
    assert len(kinds) == 1314


@pytest.mark.slow
@settings(max_examples=8)
@given(
    st.floats(30, 55), st.floats(0.0, 0.3), st.sampled_from([60.0, 80.0, 110.0]),
    st.sampled_from([HingeParameters(), PIN, HingeParameters(segmentations=5, face_thickness=1.6)]),
)  # fmt: skip
def test_every_body_is_closed_and_has_its_volume(theta, above, edge_length, parameters):
    if parameters is PIN:
        edge_length = 110.0
    ratio = np.sin(np.radians(theta) / 2) + 0.02 + above
    for name, body, volume in boundaries(
        layout_of(theta, ratio, edge_length, parameters), parameters
    ):
        assert len(body.unpaired()) == 0, name
        assert body.volume == pytest.approx(volume, rel=1e-12), name
        mesh = meshed(body).mesh
        assert len(unpaired_edges(mesh.triangles)) == 0, name
        assert component_labels(mesh.triangles, len(mesh.vertices)).max() == 0, name


@pytest.mark.parametrize("parameters", [HingeParameters(), FINE, PIN])
def test_a_mesh_kernel_agrees(parameters):
    manifold3d = judge("manifold3d")
    edge_length = {0.8: 40.0, 1.2: 60.0, 1.8: 90.0}[parameters.face_thickness]
    for name, body, volume in boundaries(layout_of(45, 0.42, edge_length, parameters), parameters):
        chord = 0.05 * parameters.layer_height / 0.2
        mesh = meshed(body, chord).mesh
        solid = manifold3d.Manifold(
            manifold3d.Mesh(np.float32(mesh.vertices), np.uint32(mesh.triangles))
        )
        assert solid.status() == manifold3d.Error.NoError, name
        assert len(solid.decompose()) == 1, name
        off = abs(solid.volume() - volume)
        assert off < chord * body.round_area, name
        assert solid.volume() == pytest.approx(mesh.volume, rel=1e-5), name


@pytest.mark.slow
def test_links_of_units_in_space_are_closed_though_their_axes_are_not_parallel():
    parameters, skewest = HingeParameters(), 0.0
    for layout in rising_layouts(parameters):
        for name, link in layout.links.items():
            body = link_boundary(link, parameters)
            assert len(body.unpaired()) == 0, name
            fine = meshed(body, 1e-4).mesh
            assert len(unpaired_edges(fine.triangles)) == 0
            assert fine.volume == pytest.approx(body.volume, rel=1e-4), name
            first, second = (hinge.direction for hinge in link.hinges)
            skewest = max(skewest, abs(first - second))
    assert skewest > 1e-4


@given(st.floats(0.3, 9.0), st.floats(0.1, 2 * np.pi), st.floats(0.001, 0.2))
def test_chords_keep_their_error_and_none_is_wasted(radius, sweep, error):
    count = chords_for(radius, sweep, error)
    sagitta = radius * (1 - np.cos(sweep / count / 2))
    assert sagitta <= error * (1 + 1e-9) + 1e-12
    if count > max(1, np.ceil(8 * sweep / (2 * np.pi))):
        wider = radius * (1 - np.cos(sweep / (count - 1) / 2))
        assert wider > error


def test_the_mesh_lies_within_the_chord_error_of_the_round_faces():
    parameters = HingeParameters()
    body = plate_boundary(layout_of(45, 0.42, 60.0, parameters).plates["border_left"], parameters)
    found = meshed(body, 0.01)
    cylinders = [k for k, kind in enumerate(body.kinds) if kind == CYLINDER]
    worst = 0.0
    for k in cylinders:
        row = body.arc_of[body.faces[k].first]
        middles = found.mesh.corners[found.faces == k].mean(1)
        arm = middles - body.arcs.centre[row]
        axis = body.arcs.axis[row]
        across = np.linalg.norm(arm - np.outer(arm @ axis, axis), axis=1)
        worst = max(worst, np.abs(across - body.arcs.radius[row]).max())
    assert 0.003 < worst <= 0.01


def test_a_mirror_image_is_closed_and_not_inside_out():
    parameters = HingeParameters()
    body = plate_boundary(layout_of(45, 0.42, 60.0, parameters).plates["border_left"], parameters)
    image = body.moved(np.diag([1.0, 1.0, -1.0, 1.0]))
    assert image.volume == pytest.approx(body.volume, rel=1e-12)
    assert meshed(image).mesh.volume == pytest.approx(meshed(body).mesh.volume, rel=1e-9)


def box(draft, size):
    """A box with corners at the origin and ``size``."""
    corner = {
        (x, y, z): draft.vertex((x * size[0], y * size[1], z * size[2]))
        for x in (0, 1)
        for y in (0, 1)
        for z in (0, 1)
    }
    for axis in range(3):
        for side in (0, 1):
            ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
            places = [tuple(np.insert(point, axis, side).tolist()) for point in ring]
            if (side == 1) != (axis != 1):
                places.reverse()
            draft.polygon(*(corner[place] for place in places))


def test_a_warped_prism_has_the_volume_of_its_sections():
    draft = Draft()
    corners = [[(0, 0), (2, 0), (2, 1), (0, 1)], [(0.3, 0), (2, 0.2), (2.4, 1), (0, 1.1)]]
    rings = [
        draft.ring([draft.vertex((x, y, 3.0 * k)) for x, y in ring])
        for k, ring in enumerate(corners)
    ]
    draft.plane([~edge for edge in reversed(rings[0])])
    draft.plane(rings[1])
    for first, second in zip(*rings, strict=True):
        draft.ruled(first, second, 1)
    body = draft.boundary()
    assert len(body.unpaired()) == 0

    def area(v):
        x, y = np.moveaxis((1 - v) * np.array(corners[0]) + v * np.array(corners[1]), -1, 0)
        return (x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2

    simpson = 3.0 * (area(0) + 4 * area(0.5) + area(1)) / 6
    assert body.volume == pytest.approx(simpson, rel=1e-12)


def test_an_open_body_is_seen():
    draft = Draft()
    box(draft, (1, 2, 3))
    body = draft.boundary()
    assert body.volume == pytest.approx(6.0)
    assert len(body.unpaired()) == 0
    assert body.areas.sum() == pytest.approx(22.0)
    torn = replace(body, faces=body.faces[1:])
    assert len(torn.unpaired()) == 4


@given(st.integers(0, 10**6), st.integers(3, 25), st.integers(0, 3))
def test_stars_with_holes_are_cut_into_triangles_that_fill_them(seed, corners, holes):
    random = np.random.default_rng(seed)
    turns = 2 * np.pi * np.arange(corners) / corners
    loops = [random.uniform(2, 4, corners) * np.exp(1j * turns)]
    for k in range(holes):
        middle = np.exp(2j * np.pi * (k + 0.2) / holes) * 0.6
        turn = np.exp(-2j * np.pi * np.arange(6) / 6)
        loops.append(middle + 0.2 * turn)
    points = np.concatenate(loops)
    plan = np.stack([points.real, points.imag], 1)
    cut = cut_of(plan, tuple(map(len, loops)))
    a, b, c = plan[cut[:, 0]], plan[cut[:, 1]], plan[cut[:, 2]]
    areas = ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
    whole = sum((loop.conj() * np.roll(loop, -1)).imag.sum() / 2 for loop in loops)
    assert (areas > 0).all()
    assert areas.sum() == pytest.approx(whole)
    assert len(cut) == len(points) + 2 * holes - 2
