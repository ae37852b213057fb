# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hinge parameters, presets and layout in plan: no FreeCAD needed."""

import json
import re
from dataclasses import replace
from itertools import pairwise
from math import cos, radians, sin, sqrt
from pathlib import Path

import numpy as np
import pytest

from BistableWB.origami.hinges import polygons
from BistableWB.origami.hinges.coupons import dihedral, vertex
from BistableWB.origami.hinges.flexures import strips
from BistableWB.origami.hinges.layout import unit_layout
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.presets import PRESETS
from BistableWB.origami.hinges.room import TooSmall
from BistableWB.origami.thick import print_stack
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit, sphere_unit
from BistableWB.origami.units.creases import BODIES, CREASES, INDEX

TABLES = json.loads((Path(__file__).parents[1] / "data" / "tables.json").read_text())
DEFAULT = HingeParameters()


def thick(parameters=DEFAULT, theta=45.0, ratio=0.42, edge_length=60.0, height=24.0):
    unit = plane_unit(np.radians(theta), ratio, edge_length, height)
    return ThickUnit(unit, parameters.face_thickness, parameters.gap_between_planes)


@pytest.fixture(scope="module")
def layout():
    return unit_layout(thick().compensated().axes, DEFAULT)


def test_default_parameters_are_sound():
    DEFAULT.check()
    assert DEFAULT.warnings() == []
    assert DEFAULT.pitch == pytest.approx(1.8)
    assert DEFAULT.radius == pytest.approx(1.5)


@pytest.mark.parametrize(("angle", "play"), [(45, 0.40), (60, 0.23)])
def test_play_of_cones_is_that_of_the_design_notes(angle, play):
    assert replace(DEFAULT, cone_angle=radians(angle)).play == pytest.approx(play, abs=0.005)


@pytest.mark.parametrize(
    ("change", "names"),
    [
        ({"face_thickness": 0.0}, "FaceThickness"),
        ({"segmentations": 4}, "Segmentations.*5"),
        ({"segmentations": 1}, "Segmentations.*3"),
        ({"gap_length": 0.1}, "GapLength.*0.2 mm"),
        ({"gap_between_planes": 0.1}, "GapBetweenPlanes.*0.2 mm"),
        ({"cone_angle": radians(30)}, "ConeAngle"),
        ({"face_thickness": 0.6}, "cones.*FaceThickness to 0.8 mm"),
        ({"pivot": "Pin", "nozzle_diameter": 0.6}, "FaceThickness"),
        ({"pivot": "Pin", "face_thickness": 0.8}, "wall.*FaceThickness"),
        ({"pivot": "Screw"}, "Pivot"),
        ({"hinge_type": "Rope"}, "HingeType"),
        ({"rotation_angle": 4.0}, "RotationAngle"),
    ],
)
def test_impossible_hinges_are_refused_with_the_cure(change, names):
    with pytest.raises(ValueError, match=names):
        replace(DEFAULT, **change).check()


def test_the_cure_for_short_cones_cures():
    short = replace(DEFAULT, face_thickness=0.6)
    with pytest.raises(ValueError, match="FaceThickness") as refused:
        short.check()
    value = float(re.search(r"FaceThickness to ([\d.]+) mm", str(refused.value))[1])
    replace(short, face_thickness=value).check()


def test_lengths_that_are_no_whole_layers_are_warned_about_with_the_nearest():
    odd = replace(DEFAULT, layer_height=0.3, face_thickness=0.8)
    assert any("use 0.6 or 0.9 mm" in str(warning) for warning in odd.warnings())


@pytest.mark.parametrize("table", ["table1_dihedral", "table2_four_degree_vertex"])
def test_presets_are_the_paper_s_cells_and_nothing_else(table):
    data = TABLES[table]
    names = {
        "segmentations": "segmentations",
        "gap_length_mm": "gap_length",
        "gap_between_planes_mm": "gap_between_planes",
        "face_thickness_mm": "face_thickness",
        "profile_mm": "layer_height",
    }
    for name in (n for n in data if re.fullmatch(r"Hinge\d", n)):
        given = PRESETS[name].given
        cells = dict(zip(data["rows"], data[name], strict=True))
        for row, parameter in names.items():
            assert given.get(parameter) == cells.get(row), (name, row)
        angle = cells["rotation_angle_deg"]
        assert given.get("rotation_angle") == (None if angle is None else radians(angle))
        assert PRESETS[name].size == tuple(cells[f"length_{axis}_mm"] for axis in "xyz")
        missing = {p for row, p in names.items() if row in cells and cells[row] is None}
        assert missing <= set(PRESETS[name].doubtful)
    worked = [n for n, p in PRESETS.items() if p.worked and n in data and n[-1].isdigit()]
    assert worked == data["working_in_the_paper"]


def test_rays_from_one_vertex_start_where_the_design_notes_say():
    angle, reach = radians(40), 3.4
    start = polygons.free_start(0, 1, 0, complex(cos(angle), sin(angle)), reach)
    assert start == pytest.approx(reach / (2 * sin(angle / 2)))


def test_every_crease_has_knuckles_and_every_panel_some(layout):
    assert set(layout.hinges) == {crease.name for crease in CREASES}
    assert all(len(h.segments) >= 3 and len(h.segments) % 2 for h in layout.hinges.values())
    for hinge in layout.hinges.values():
        for body in hinge.bodies:
            if body in layout.plates:
                owned = [t for t in layout.plates[body].tabs if t.hinge.name == hinge.name]
                assert len(owned) == (len(hinge.segments) + 1 - hinge.bodies.index(body)) // 2


def test_knuckles_are_a_gap_apart_and_inside_their_stretch(layout):
    for hinge in layout.hinges.values():
        flat = np.array(hinge.segments)
        assert np.allclose(flat[1:, 0] - flat[:-1, 1], DEFAULT.gap_length)
        assert flat[0, 0] > hinge.stretch[0] - 1e-9
        assert flat[-1, 1] < hinge.stretch[1] + 1e-9
        assert hinge.cone_height > 2 * DEFAULT.gap_length


def barrel_distance(first, second):
    """Smallest distance of two finite axes in space (sampled)."""
    points = [
        np.linspace(h.point(h.segments[0][0]), h.point(h.segments[-1][1]), 400)
        for h in (first, second)
    ]
    flat = np.abs(points[0][:, None] - points[1][None]).min()
    return sqrt(flat**2 + (first.height - second.height) ** 2)


def test_barrels_whose_heights_overlap_keep_the_clearance(layout):
    hinges = list(layout.hinges.values())
    least = 2 * DEFAULT.radius + DEFAULT.gap_length
    for i, first in enumerate(hinges):
        for second in hinges[:i]:
            if abs(first.height - second.height) > 1.5 * DEFAULT.pitch:
                continue
            assert barrel_distance(first, second) > least - 0.01, (first.name, second.name)


def test_a_compensated_plane_unit_is_its_own_mirror_image_up_down(layout):
    for name, plate in layout.plates.items():
        if name.endswith("_upper"):
            other = layout.plates[name.replace("_upper", "_lower")]
            assert abs(polygons.area(plate.core) - polygons.area(other.core)) < 1e-6


@pytest.mark.parametrize(
    ("sizes", "names"),
    [
        ({"edge_length": 28.0, "height": 20.0}, "EdgeLength ‖AB‖ to"),
        ({"edge_length": 60.0, "height": 8.0}, "HeightRatio"),
    ],
)
def test_a_unit_too_small_names_the_hinge_and_a_value_that_helps(sizes, names):
    with pytest.raises(TooSmall, match=names) as refused:
        unit_layout(thick(**sizes).axes, DEFAULT, sizes["edge_length"])
    message = str(refused.value)
    if "HeightRatio" in message:
        larger = sizes | {"height": float(re.search(r"h is ([\d.]+) mm", message)[1])}
    else:
        factor = float(re.search(r"to ([\d.]+) mm", message)[1]) / sizes["edge_length"]
        larger = {name: value * factor for name, value in sizes.items()}
    unit_layout(thick(**larger).axes, DEFAULT)


def test_fewer_segments_are_said():
    found = unit_layout(thick(theta=20.0, ratio=0.3).compensated().axes, DEFAULT)
    assert any("room for 5 segments instead of 7" in str(note) for note in found.notes)


def test_stacked_units_turn_about_and_lie_four_pitches_higher():
    unit = plane_unit(np.radians([40.0, 45.0, 50.0]), 0.45, 60.0, 24.0)
    frames = print_stack.frames(ThickUnit(unit, 1.2, 0.6))
    assert np.allclose(np.diff(frames[:, 2, 3]), 4 * 1.8)
    assert np.allclose([np.linalg.det(f[:3, :3]) for f in frames], 1)
    a, b = INDEX["A_left_upper"], INDEX["B_upper"]
    ends = [
        (f @ np.append(unit.flat[k][[a, b]], [[1], [1]], 1).T)[:2].T for k, f in enumerate(frames)
    ]
    for lower, higher in pairwise(ends):
        assert np.allclose(lower, higher[::-1], atol=1e-9)


@pytest.mark.parametrize("first_left", [True, False])
def test_contact_panels_of_a_block_move_alike(first_left):
    unit = sphere_unit(np.radians([40.0, 42.0, 44.0]), 60.0, np.radians(80), 20.0)
    units = ThickUnit(unit, 1.2, 0.6).compensated()
    left = print_stack.alternating(3) == first_left
    moves = print_stack.motions(units, 1.0, left)
    for k in range(2):
        leave = BODIES.index(print_stack.contact_names(left[k])[1])
        entry = BODIES.index(print_stack.contact_names(left[k + 1])[0])
        assert np.allclose(moves[k, leave], moves[k + 1, entry], atol=1e-9)
    assert np.allclose(print_stack.motions(units, 0.0, left), np.eye(4), atol=1e-6)


def test_flexible_fingers_of_one_panel_keep_apart():
    parameters = replace(DEFAULT, hinge_type="Flexible")
    found = strips(unit_layout(thick(parameters).compensated().axes, parameters), parameters)
    assert len(found) == 20
    by_plate = {}
    for strip in found.values():
        for plate, fingers in strip.fingers.items():
            assert fingers
            by_plate.setdefault(plate, []).extend(fingers)
    for fingers in by_plate.values():
        for i, first in enumerate(fingers):
            for second in fingers[:i]:
                assert not polygons.intersection(first.corners, second.corners, inset=-0.3)


@pytest.mark.parametrize("kind", ["Vertex", "NonDevelopableVertex"])
def test_vertex_coupons_have_four_plates_and_a_double_hinge(kind):
    found = vertex(kind, DEFAULT)
    assert len(found.plates) == 4
    assert len(found.hinges) == 5
    assert set(found.links) == {"link"}


def test_dihedral_has_the_preset_s_segments():
    found = dihedral(PRESETS["Hinge4"].parameters())
    assert len(found.hinges["crease"].segments) == 7


@pytest.mark.parametrize("name", ["Hinge3", "Hinge5"])
def test_presets_that_cannot_turn_are_refused(name):
    with pytest.raises(ValueError, match="set"):
        dihedral(PRESETS[name].parameters())
