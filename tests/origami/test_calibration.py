# SPDX-License-Identifier: LGPL-2.1-or-later
"""The calibration plate as it is meshed: closed, apart by what is engraved, readable numbers."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from BistableWB.checks.layering import Layering
from BistableWB.checks.layers import layers
from BistableWB.checks.printer import Printer, tighter_than_known
from BistableWB.checks.suite import Suite
from BistableWB.origami.errors import Refusal
from BistableWB.origami.hinges.calibration import Series, depth_of, plate_drawn
from BistableWB.origami.hinges.coupons import coupon_drawn
from BistableWB.origami.hinges.engraving import _DIGITS, COLUMNS, ROWS
from BistableWB.origami.hinges.meshing import mesh_of
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.presets import PRESETS
from BistableWB.origami.meshes import PlacedMesh, component_labels, unpaired_edges

HINGE = HingeParameters(segment_width=5.0)
SETS = {
    "default": HINGE,
    "pins": replace(HINGE, pivot="Pin"),
    "coarse": replace(
        HINGE, layer_height=0.3, nozzle_diameter=0.6, face_thickness=1.8, gap_between_planes=0.9
    ),
    "thick": replace(HINGE, face_thickness=2.4, cone_angle=radians(50)),
}


def meshes(drawn):
    return [
        PlacedMesh(body.name, mesh_of(body.boundary).mesh, body.place, body.unit, body.members,
                   body.kind)
        for body in drawn
    ]  # fmt: skip


@pytest.mark.parametrize("name", SETS)
def test_every_body_is_closed_whole_and_has_its_volume(name):
    drawn, clearances = plate_drawn(SETS[name], Series(least=0.3, count=5))
    assert clearances == [0.3, 0.35, 0.4, 0.45, 0.5]
    assert len(drawn) == 2 * 5 + 2 * 2
    for body in drawn:
        mesh = mesh_of(body.boundary).mesh
        assert len(unpaired_edges(mesh.triangles)) == 0
        assert component_labels(mesh.triangles, len(mesh.vertices)).max() == 0
        assert mesh.volume == pytest.approx(body.boundary.volume, rel=3e-3)
    low = np.min([mesh.placed.bounds[0] for mesh in meshes(drawn)], axis=0)
    assert low == pytest.approx(0, abs=1e-9)


def test_what_hinges_and_pairs_keep_apart_is_what_is_engraved():
    """Gaps along the axis of each hinge, and the air between ribs and plates, on the meshes."""
    by_name = {mesh.name: mesh.placed for mesh in meshes(plate_drawn(HINGE, Series())[0])}
    layer = HINGE.layer_height
    for hundredths in range(20, 51, 5):
        pair = [by_name[f"hinge_{hundredths:03d}_{side}"] for side in ("lower", "upper")]
        assert pair[0].bounds[0][2] == pytest.approx(pair[1].bounds[0][2], abs=1e-9)  # both lie
        across = np.sort([bounds[:, 1] for bounds in (mesh.bounds for mesh in pair)])
        axis = HINGE.radius
        line = (across[0, 1] + across[1, 0]) / 2  # y of the axis: barrels reach as far both ways
        crossings = sorted(x for mesh in pair for x in _along(mesh, line, axis))
        gaps = np.diff(crossings)[1::2]
        assert gaps == pytest.approx(hundredths / 100, abs=1e-6)
    for air in (1, 2):
        lower, upper = (by_name[f"pair_{air}_{side}"] for side in ("lower", "upper"))
        assert upper.bounds[0][2] - lower.bounds[1][2] == pytest.approx(air * layer)


def _along(mesh, y, z):
    """x at which a line along x leaves or enters a mesh, slightly off the axis and its cones."""
    y, z = y + 1.29 * 0.6, z + 1.29 * 0.8  # on the barrel, outside the largest cone's base
    a, b, c = np.moveaxis(mesh.corners, 1, 0)
    u, v, w = (
        (p[:, 1] - y) * (q[:, 2] - z) - (q[:, 1] - y) * (p[:, 2] - z)
        for p, q in ((b, c), (c, a), (a, b))
    )
    with np.errstate(divide="ignore", invalid="ignore"):
        x = (u * a[:, 0] + v * b[:, 0] + w * c[:, 0]) / (u + v + w)
    hit = ((u > 0) & (v > 0) & (w > 0)) | ((u < 0) & (v < 0) & (w < 0))
    return x[hit]


def test_numbers_can_be_read_in_the_layers():
    """The squares of the digits are found again in a layer through the engraved faces."""
    drawn, _ = plate_drawn(HINGE, Series())
    for mesh in meshes(drawn):
        if not mesh.name.endswith(("hinge_035_lower", "hinge_020_lower")):
            continue
        made = layers(mesh.placed, HINGE.layer_height)
        sunk = round(HINGE.face_thickness / HINGE.layer_height) - 1
        below = sunk - round(depth_of(HINGE) / HINGE.layer_height)
        pockets = made.inside[below] & ~made.inside[sunk]
        pockets[85:] = False  # beyond 8.5 mm are barrels, which are round
        rows, columns = (np.flatnonzero(pockets.any(k)) for k in (1, 0))
        box = pockets[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1][::-1]
        width = (2 * COLUMNS + 1) * 12
        assert box.shape == pytest.approx((ROWS * 12, width), abs=2)
        squares = box[6::12, 6::12][:ROWS, : 2 * COLUMNS + 1]
        text = "".join(
            str(_DIGITS.index("".join("01"[int(x)] for x in squares[:, k : k + COLUMNS].ravel())))
            for k in (0, COLUMNS + 1)
        )
        assert text == mesh.name[7:9]


def test_only_the_tightest_hinges_may_fuse_in_the_layers():
    drawn, _ = plate_drawn(HINGE, Series())
    layering = Layering(meshes(drawn), Printer())
    layering.findings()
    fused = {name[:9] for area, name, *_ in layering._contacts if area > 0.15}
    assert fused <= {"hinge_020", "hinge_025"}


def test_clearances_that_cannot_be_are_left_out_or_refused():
    notes = []
    _, clearances = plate_drawn(replace(HINGE, layer_height=0.3), Series(), notes)
    assert clearances == [0.3, 0.35, 0.4, 0.45, 0.5]
    assert all("Left out, clearance 0.2" in str(note) for note in notes)
    cases = (
        (HINGE, Series(count=4), "Count", "between 5 and 15"),
        (HINGE, Series(step=0.001), "Step", "hundredths"),
        (HINGE, Series(least=0.0), "Least", "above 0"),
        (replace(HINGE, hinge_type="Flexible"), Series(), "HingeType", "set HingeType to"),
        (HINGE, Series(least=1.0), "FaceThickness", "cones are"),
    )
    for parameters, series, parameter, words in cases:
        with pytest.raises(Refusal, match=words) as refused:
            plate_drawn(parameters, series)
        assert refused.value.parameter == parameter


def test_a_dihedral_opens_flat_about_its_hinge_and_a_vertex_says_why_not():
    flat, opened = (
        np.array([mesh.placed.bounds for mesh in meshes(coupon_drawn("Dihedral", HINGE,
                                                                   opening=x))])
        for x in (0, 1)
    )  # fmt: skip
    assert np.ptp(opened[:, :, 2]) == pytest.approx(2 * HINGE.radius, abs=0.02)
    length = np.ptp(flat[:, :, 1]) - HINGE.radius
    assert np.ptp(opened[:, :, 1]) == pytest.approx(2 * length, abs=0.02)
    with pytest.raises(Refusal, match="set Kind to Dihedral"):
        coupon_drawn("Vertex", HINGE, opening=1.0)


def test_the_coarse_preset_keeps_the_checks():
    """Of a dihedral in layers of 0.3 mm: apart, whole layers, walls of a nozzle, cones."""
    made = PRESETS["Coarse"].parameters(HINGE)
    assert made.segment_width == 5.0
    made.check()
    assert made.warnings() == []
    drawn = coupon_drawn("Dihedral", made)
    printer = Printer(made.layer_height, made.nozzle_diameter)
    volumes = [body.boundary.volume for body in drawn]
    suite = Suite(meshes(drawn), volumes, made, printer,
                  slacks=[0.01 * body.boundary.round_area for body in drawn])  # fmt: skip
    found = [f for _, step in suite.steps() for f in step() if f.code != "overhang"]
    assert {f.code for f in found} >= {"clearance", "layers", "fused", "wall", "cone"}
    assert {f.severity for f in found} == {"note"}, [str(f) for f in found]


def test_checks_ask_for_what_turned_on_the_plate():
    assert tighter_than_known(HINGE, Printer()) == []
    assert tighter_than_known(HINGE, Printer(clearance=0.4)) == []
    (found,) = tighter_than_known(HINGE, Printer(clearance=0.45))
    assert "nothing tighter than 0.45 mm turned" in str(found)
    assert "GapLength 0.45 mm or more" in str(found)
