# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thick panels: poses, misfit and compensation (section 3 of the design notes on hinges)."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from BistableWB.origami import rigid
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.thick import compensation
from BistableWB.origami.thick.closure import Closure
from BistableWB.origami.thick.linkage import FURTHEST, ThickUnit
from BistableWB.origami.unit import Unit, plane_unit, sphere_unit
from BistableWB.origami.units.contacts import contact_pairs
from BistableWB.origami.units.creases import BODIES, CREASES, INDEX, PANELS
from BistableWB.origami.units.general import general_unit

HINGE = {c.name: i for i, c in enumerate(CREASES)}
few = settings(max_examples=8)
# Pitch p as two thirds thickness and a third gap.
THIN = (1.2, 0.6)


def thick(theta, ratio, edge, pitch, height=15.0):
    unit = plane_unit(np.radians(theta), ratio, edge, height)
    return ThickUnit(unit, 2 / 3 * pitch, pitch / 3)


@pytest.fixture(scope="module")
def typical():
    return thick(45, 0.42, 60, 1.8, 20).compensated()


def every_five_degrees(unit):
    """Openings of whole 5° from two thirds on, as fractions: where the table was taken."""
    full = np.degrees(unit.opening)
    openings = np.arange(5, full + 1e-9, 5) / full
    return openings[openings > 2 / 3]


# The table of section 3. Its peaks agree at openings of whole 5°; in between, those of the second
# row and of the first sphere reach 0.588 mm and 0.662 mm.
@pytest.mark.parametrize(
    ("theta", "ratio", "before", "peak", "true_peak", "shift"),
    [(50, 0.50, 0.43, 0.27, 0.2759, 0.46), (40, 0.36, 0.50, 0.55, 0.5878, 0.75)],
)
def test_table_of_plane_units(theta, ratio, before, peak, true_peak, shift):
    plain = thick(theta, ratio, 45, 1.4)
    assert plain.misfit(1).max() == pytest.approx(before, rel=0.05)
    unit = plain.compensated()
    assert unit.misfit(1).max() < 1e-9
    assert unit.misfit(every_five_degrees(unit)).max() == pytest.approx(peak, rel=0.05)
    fine = unit.misfit(np.linspace(0.75, 0.85, 21)).max()
    assert fine == pytest.approx(true_peak, rel=1e-3)
    assert np.abs(unit.shifts).max() == pytest.approx(shift, rel=0.05)


def test_uncompensated_misfits_on_the_way():
    rising = thick(50, 0.50, 45, 1.4).misfit([0.95, 1.0, 1.05]).max(-1)
    assert (np.diff(rising) > 0).all()  # no second stable state
    at_35 = thick(40, 0.36, 45, 1.4).misfit(35 / 40).max()
    assert at_35 == pytest.approx(0.55, rel=0.05)


@pytest.mark.parametrize(
    ("theta", "omega", "before", "peak"), [(45, 80, 0.63, 0.63), (55, 75, 0.76, 1.5)]
)
def test_table_of_spheres(theta, omega, before, peak):
    plain = ThickUnit(sphere_unit(np.radians(theta), 60, np.radians(omega), 15), *THIN)
    assert plain.misfit(1).max() == pytest.approx(before, rel=0.05)
    unit = plain.compensated()
    assert unit.misfit(1).max() < 1e-9
    assert np.abs(unit.shifts).max() < 1.3
    # The second one jumps at its peak: only steps finer than 5° show it.
    openings = every_five_degrees(unit) if theta == 45 else np.linspace(0.82, 0.86, 17)
    assert unit.misfit(openings).max() == pytest.approx(peak, rel=0.05)


def test_a_jumping_path_is_the_same_at_its_nodes_and_between():
    unit = ThickUnit(sphere_unit(np.radians(55), 60, np.radians(75), 15), *THIN).compensated()
    jump = 20 / 24  # past the fold at 0.844 θ
    beside = unit.misfit([jump, jump - 1e-6, jump + 1e-6]).max(-1)
    assert beside == pytest.approx(np.full(3, beside[0]), rel=1e-4)


def test_rising_arch_closes():
    placed = place(Bezier([[0, 0, 0], [60, 120, 20], [180, 120, 60], [240, 0, 70]]), 60, 0.35)
    units = general_unit(*contact_pairs(placed, 18.0), 0.5)
    unit = ThickUnit(units, *THIN).compensated()
    assert len(unit) == len(units) > 5
    assert unit.misfit(1).max() < 1e-9
    assert np.abs(unit.shifts).max() < 1.3


@few
@given(
    st.floats(20, 75).map(np.radians), st.floats(0.05, 0.6), st.floats(30, 120), st.floats(0.6, 2.4)
)
def test_compensation_closes_the_deployed_state(theta, share, edge, pitch):
    low = np.sin(theta / 2)
    ratio = low + share * (1 - low)
    unit = ThickUnit(plane_unit(theta, ratio, edge, edge / 3), pitch / 2, pitch / 2).compensated()
    assert unit.misfit(1).max() < 1e-9
    assert unit.shifts.shape == (23, 2)
    turns = unit.poses(1)[:, :3, :3]
    assert np.abs(turns @ np.swapaxes(turns, -1, -2) - np.eye(3)).max() < 1e-12
    assert np.linalg.det(turns) == pytest.approx(1)


def test_shifts_have_the_least_norm(typical):
    """Stationary: the shifts are a combination of what closing the hinges asks of them."""
    poses = typical.states(np.array([[1.0]]))[:, 0]
    nominal = ThickUnit(typical.unit, *THIN)
    closure, across = typical.closures([[1.0]]), nominal.normals[None]
    by_pose, by_shift, _ = compensation._equations(closure, poses, across)
    forces = np.concatenate([by_pose, by_shift], -1)[0].T
    wanted = np.concatenate([np.zeros(by_pose.shape[-1]), typical.shifts.ravel()])
    found = np.linalg.lstsq(forces, wanted, rcond=1e-9)[0]
    assert np.abs(forces @ found - wanted).max() < 1e-4 * np.abs(wanted).max()


def test_jacobian_agrees_with_differences():
    rng = np.random.default_rng(0)
    unit = ThickUnit(sphere_unit(np.radians([40, 50]), 60, np.radians(80), 15), *THIN)
    closure = unit.closures([[0.9]])
    poses = closure.moved(unit.states([[0.9]])[:, 0], 0.02 * rng.normal(size=(2, 83)))
    step, by = rng.normal(size=(2, 83)), 1e-5

    def residual(size):
        return closure.residual(closure.moved(poses, size * step)).reshape(2, -1)

    slope = (closure.jacobian(poses) @ step[..., None])[..., 0]
    assert slope == pytest.approx((residual(by) - residual(-by)) / (2 * by), abs=1e-8)
    matrix, gradient = closure.normal(poses, curvature=True)
    assert gradient[..., 0] == pytest.approx(
        (np.swapaxes(closure.jacobian(poses), 1, 2) @ residual(0)[..., None])[..., 0], abs=1e-12
    )
    by = 1e-3
    cost = [(residual(size) ** 2).sum(-1) / 2 for size in (-by, 0, by)]
    bend = np.einsum("ni,nij,nj->n", step, matrix, step)
    assert bend == pytest.approx((cost[0] - 2 * cost[1] + cost[2]) / by**2, rel=1e-4)


def test_flat_state_is_where_the_axes_are(typical):
    assert typical.poses(0) == pytest.approx(np.broadcast_to(np.eye(4), (15, 4, 4)))
    assert typical.misfit(0).max() == 0
    # The path arrives there by itself.
    assert np.abs(typical.poses(0.002) - np.eye(4)).max() < 0.2
    assert typical.misfit(0.002).max() < 0.002


def test_opening_is_the_angle_at_b_and_the_a_ends_move_apart(typical):
    for x in (0.3, 1.0, 1.05):
        turn = typical.poses(x)[BODIES.index("contact_right")]
        assert rigid.rotation_vector(turn[:3, :3]) == pytest.approx(
            [0, 0, -x * np.radians(45)], abs=1e-9
        )
        corner = typical.unit.flat[INDEX["A_right_upper"]]
        assert rigid.apply(turn, corner[None])[0, 1] > corner[1] + 10 * x
    assert np.degrees(typical.opening) == pytest.approx(45)


def test_least_misfit_is_stationary(typical):
    poses = typical.states([[0.7]])[:, 0]
    closure = typical.closures([[0.7]])
    assert np.abs(closure.normal(poses)[1]).max() < 1e-12


def test_thin_panels_go_where_the_zero_thickness_ones_go():
    unit = plane_unit(np.radians(45), 0.42, 60, 20)
    poses = ThickUnit(unit, 0.006, 0.004).compensated().poses(1)
    frame = rigid.fit(unit.flat[[INDEX[v] for v in PANELS["contact_left"]]], deployed_contact(unit))
    for panel, corners in PANELS.items():
        index = [INDEX[v] for v in corners]
        found = rigid.apply(frame @ poses[BODIES.index(panel)], unit.flat[index])
        assert found == pytest.approx(unit.deployed[index], abs=0.05)


def deployed_contact(unit):
    return unit.deployed[[INDEX[v] for v in PANELS["contact_left"]]]


@pytest.mark.parametrize("x", [0.4, 1.0])
def test_symmetric_unit_stays_symmetric(typical, x):
    misfit = typical.misfit(x)
    for name, i in HINGE.items():
        for a, b in (("left", "right"), ("upper", "lower")):
            assert misfit[i] == pytest.approx(misfit[HINGE[name.replace(a, b)]], abs=1e-7)


def test_batch_arrays_and_the_order_of_calls_make_no_difference(typical):
    units = plane_unit(np.radians([45, 40]), np.array([0.42, 0.40]), 60, 20)
    batch = ThickUnit(units, *THIN).compensated()
    assert batch.axes.shape == (2, 23, 2, 3)
    assert batch.shifts[0] == pytest.approx(typical.shifts, abs=1e-6)
    openings = [0.0, 0.31, 1.0]
    poses = batch.poses(openings)
    assert poses.shape == (2, 3, 15, 4, 4)
    assert poses[0] == pytest.approx(typical.poses(openings), abs=1e-5)
    assert typical.misfit(openings)[1] == pytest.approx(typical.misfit(0.31), abs=1e-9)
    assert batch.misfit(0.31).shape == (2, 23)
    assert batch.contact_transform().shape == (2, 4, 4)
    assert batch.block_lines().shape == (2, 2, 2, 3)


def test_shifted_axes_stay_in_their_plane(typical):
    plain = ThickUnit(typical.unit, *THIN)
    assert not plain.shifts.any()
    moved = typical.axes - plain.axes
    assert not moved[..., 1].any()
    assert np.linalg.norm(moved, axis=-1) == pytest.approx(np.abs(typical.shifts))
    heights = np.array([c.height for c in CREASES]) * 1.8
    assert plain.axes[:, 0, 1] == pytest.approx(heights)


def test_blocks_stand_where_the_placement_rule_says(typical):
    """Section 5: half the distance of the blocks' midpoints, up to the shifts."""
    lines = typical.block_lines()
    half = np.linalg.norm(np.diff(lines.mean(1), axis=0)) / 2
    t = np.radians(45) / 2
    rule = 1.8 * (1 + np.cos(t)) + 30 * np.sin(t)
    assert half == pytest.approx(rule, abs=2 * np.abs(typical.shifts).max())
    assert lines[0, 0] == pytest.approx([0, -3.6, 0])
    tapered = ThickUnit(sphere_unit(np.radians(45), 60, np.radians(80), 20), *THIN)
    assert tapered.block_lines()[0, 1] == pytest.approx([60, -3.6, 10])


def test_refusals():
    unit = plane_unit(np.radians(45), 0.42, 60, 20)
    with pytest.raises(ValueError, match="FaceThickness is 0 mm"):
        ThickUnit(unit, 0, 0.6)
    with pytest.raises(ValueError, match="GapBetweenPlanes is -1 mm"):
        ThickUnit(unit, 1.2, -1)
    for x in (-0.1, FURTHEST + 0.1, np.nan):
        with pytest.raises(ValueError, match="Deployment is"):
            ThickUnit(unit, *THIN).poses(x)


def test_panels_too_thick_are_refused_by_unit():
    pair = plane_unit(np.radians([20, 45]), np.array([0.3, 0.42]), 60, 20)
    with pytest.raises(ValueError, match=r"unit 2 .*FaceThickness .* 18 mm.*EdgeLength .*60 mm"):
        ThickUnit(pair, 12, 6).compensated()
    with pytest.raises(
        ValueError, match=r"deployed state of unit 1 does not fold flat.*FaceThickness"
    ):
        thick(45, 0.39, 60, 9).compensated().misfit(0.04)


def test_opening_inside_out_is_refused():
    unit = plane_unit(np.radians(45), 0.42, 60, 20)
    mirrored = Unit(**{**vars(unit), "deployed": unit.deployed * np.array([1, -1, 1])})
    with pytest.raises(ValueError, match="inside out"):
        ThickUnit(mirrored, *THIN).poses(1)


def test_closure_takes_parts_of_a_batch():
    unit = ThickUnit(plane_unit(np.radians([40, 45]), np.array([0.42, 0.42]), 60, 20), *THIN)
    part = unit.closures([[1.0]]).take([1])
    assert isinstance(part, Closure)
    assert part.axes.shape == (1, 23, 2, 3)
