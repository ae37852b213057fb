# SPDX-License-Identifier: LGPL-2.1-or-later
"""How strongly units snap (section 4 of the design notes on hinges)."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import minimize

from BistableWB.origami.hinges.parameters import PIN, SEGMENT_WIDTH, HingeParameters
from BistableWB.origami.snap import margin, targets
from BistableWB.origami.snap.clearance import least_clearance
from BistableWB.origami.snap.contact import holding, outermost
from BistableWB.origami.snap.table import LEGACY
from BistableWB.origami.thick.closure import FIRST, SECOND
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit
from BistableWB.origami.units import angles, energy

A, B = np.radians(25), np.radians(35)
HINGE = HingeParameters()  # equal knuckles, as in version 0.1


def thick(theta, ratio, edge, pitch=1.8):
    unit = plane_unit(np.radians(theta), np.asarray(ratio), edge, 20)
    return ThickUnit(unit, 2 / 3 * pitch, pitch / 3)


@pytest.fixture(scope="module")
def typical():
    return thick(45, 0.39, 100).compensated()


@pytest.fixture(scope="module")
def assessed(typical):
    return margin.assess(typical, holding(typical, HINGE))


def test_known_barrier():
    assert margin.barrier(A, B)[0] == pytest.approx(5.893e-6, rel=2e-4)
    fractions, values = margin.energy_path(A, B, n=1000)
    assert values.max() == pytest.approx(5.893e-6, rel=2e-4)
    assert fractions[values.argmax()] == pytest.approx(margin.barrier(A, B)[1], abs=2e-3)


@given(st.floats(20, 80).map(np.radians), st.floats(0.02, 0.8))
def test_energy_is_zero_in_both_stable_states_only(theta, share):
    low = np.sin(theta / 2)
    alpha, beta, _ = angles.angles_for(theta, low + share * (1 - low))
    fractions, values = margin.energy_path(alpha, beta, n=21, end=1.1)
    stable = np.isclose(fractions % 1, 0, atol=0.02)
    deployed = np.abs(fractions - 1).argmin()
    assert values[0] < 1e-25
    assert energy.path(alpha, beta, [1.0])[0][0] < 1e-25
    assert (values[~stable] > 0).all()
    assert values[-1] > values[deployed]


def test_paths_are_batched():
    alpha, beta, _ = angles.angles_for(np.radians([40, 50]), np.array([0.4, 0.5]))
    fractions, values = margin.energy_path(alpha, beta, n=12)
    assert fractions.shape == (12,)
    assert values.shape == (2, 12)
    assert values[1] == pytest.approx(margin.energy_path(alpha[1], beta[1], n=12)[1])
    assert margin.barrier(alpha, beta)[0].shape == (2,)


def test_no_state_without_the_symmetry_has_less_energy():
    """Six nodes free in space, the angle A_left-B-A_right apart: perturbations only cost."""
    fraction = 0.7
    rest = energy.edge_lengths(A, B)
    half = angles.theta_for(A, B) * fraction / 2
    r, q, u, s = relaxed(half, rest)
    nodes = np.array(
        [
            [0, 0, 0],
            [-r * np.cos(half), -r * np.sin(half), 0],
            [-r * np.cos(half), r * np.sin(half), 0],
            [-q, 0, 0],
            [-u, 0, np.sqrt(s)],
            [-u, 0, -np.sqrt(s)],
        ]
    )
    bars = [(0, 1, 0), (0, 2, 0), (1, 3, 1), (2, 3, 1), (4, 1, 2), (4, 2, 2), (5, 1, 2), (5, 2, 2)]
    bars += [(4, 0, 3), (5, 0, 3), (4, 3, 4), (5, 3, 4)]

    def stored(points):
        return sum(
            rest[k] / 2 * ((((points[i] - points[j]) ** 2).sum() / rest[k] ** 2 - 1) / 2) ** 2
            for i, j, k in bars
        )

    least = stored(nodes)
    assert least == pytest.approx(energy.path(A, B, [fraction])[0][0], rel=1e-9)
    rng = np.random.default_rng(1)
    for size in (1e-2, 1e-3, 1e-4):
        for _ in range(20):
            moved = nodes.copy()
            moved[3, :2] += size * rng.normal(size=2)
            moved[4:] += size * rng.normal(size=(2, 3))
            moved[1:3] *= 1 + size * rng.normal(size=(2, 1))
            assert stored(moved) >= least


def relaxed(half, rest):
    """(r, q, u, s) from the lengths that the strains of least energy leave."""
    strains = energy._relaxed(np.array([half]), rest[None])[0]
    squares = rest**2 * (1 + 2 * strains)
    r = np.sqrt(squares[0])
    q = r * np.cos(half) - np.sqrt(squares[1] - (r * np.sin(half)) ** 2)
    u = (squares[3] + squares[0] - squares[2]) / (2 * r * np.cos(half))
    return r, q, u, squares[3] - u**2


def test_angles_out_of_range_are_refused():
    with pytest.raises(ValueError, match="beta"):
        margin.energy_path(np.radians(25), np.radians(20))


def plain(theta, edge, ratio):
    unit = plane_unit(np.radians([theta]), np.asarray([ratio]), edge, edge / 2.5)
    return ThickUnit(unit, 1.2, 0.6).compensated()


def as_aimed_by_0_1(theta, edge, wanted):
    """The unit that TargetSnap chose in version 0.1, its ratio and what it was called."""
    choice = targets.TargetMargin(edge, 1.8, wanted, measure=LEGACY).choose(np.radians([theta]))
    assert choice.achieved == pytest.approx(wanted, rel=1e-3)
    return plain(theta, edge, choice.ratio[0])


@pytest.mark.parametrize(
    ("edge", "claimed", "real"), [(80.0, 1.5, 0.98), (80.0, 2.51, 1.71), (130.0, 2.01, 1.40)]
)
def test_what_was_called_firm(edge, claimed, real):
    """The table of section 4: claimed at the creases' ends, real where the cones are."""
    thick = as_aimed_by_0_1(55.0, edge, claimed)
    found, at = margin.needed_clearance(thick, holding(thick, HINGE))
    assert found[0] == pytest.approx(real, abs=0.03)
    assert 0.7 < at[0] < 0.9


def test_margin_is_inverse_to_the_gap_and_follows_the_cones():
    thick = as_aimed_by_0_1(55.0, 80.0, 1.5)
    base = margin.needed_clearance(thick, holding(thick, HINGE))[0]
    for change, factor in (
        ({"gap_length": 0.3}, 0.4 / 0.3),
        ({"gap_length": 0.5}, 0.4 / 0.5),
        ({"cone_angle": np.radians(60)}, np.tan(np.radians(60)) / np.tan(np.radians(55))),
        ({"cone_angle": np.radians(45)}, 1 / np.tan(np.radians(55))),
    ):
        found = margin.needed_clearance(thick, holding(thick, replace(HINGE, **change)))[0]
        assert found == pytest.approx(factor * base, rel=0.02), change


def test_short_ends_hold_better_for_the_same_clearance():
    thick = as_aimed_by_0_1(55.0, 80.0, 1.5)
    equal, short = (
        margin.needed_clearance(thick, holding(thick, replace(HINGE, segment_width=width)))[0]
        for width in (0.0, SEGMENT_WIDTH)
    )
    assert short > 1.12 * equal


@pytest.mark.slow
@pytest.mark.parametrize("parameters", [HINGE, replace(HINGE, pivot=PIN, face_thickness=2.4)])
def test_least_clearance_is_what_a_slow_solver_finds(parameters):
    """Sequential quadratic programming by scipy, from differences only, on few unknowns less."""
    t, g = parameters.face_thickness, parameters.gap_between_planes
    thick = ThickUnit(plane_unit(np.radians(50.0), 0.47, 80.0, 30.0), t, g).compensated()
    held = outermost(holding(thick, parameters)).scaled(1 / thick.scale)
    closure, poses = thick.closures([[0.75]]), thick.states([[0.75]])[:, 0]
    found, _, reached = least_clearance(held, closure, poses, 1e-5)
    along, across = held.displacement(poses)
    arms = held.arms(poses)[0]
    unit = np.eye(83)
    moves = np.array([_twists(closure, poses, 1e-7 * u) / 1e-7 for u in unit])  # (83, 23, 6)
    by = np.einsum("hmij,khj->hmik", arms, moves)[held.valid[0]]
    start = (along[..., None] * held.axes[:, :, None] + across)[0][held.valid[0]]
    axes = np.broadcast_to(held.axes[0, :, None], held.points[0].shape)[held.valid[0]]
    slope, lean = held.slope[0][held.valid[0]], held.lean[0][held.valid[0]]

    def room(x):
        moved = start + by @ x[:-1]
        a = (moved * axes).sum(-1)
        r = moved - a[:, None] * axes
        return 1e3 * (x[-1] * held.gap + lean * a - slope * np.sqrt((r**2).sum(-1) + 1e-16))

    first = np.r_[np.zeros(83), 1.1 * held.needed(poses).max()]
    best = minimize(
        lambda x: x[-1], first, jac=lambda x: np.eye(84)[-1], method="SLSQP",
        constraints={"type": "ineq", "fun": room}, options={"maxiter": 400, "ftol": 1e-7},
    )  # fmt: skip
    assert best.success
    assert found[0] == pytest.approx(best.x[-1], rel=0.01)
    assert held.needed(reached).max() == pytest.approx(found[0], rel=1e-9)


def _twists(closure, poses, step):
    """Relative twists (23, 6) of the hinges' bodies after a small step (83,)."""
    there = closure.moved(poses, step[None])[0]
    turn = there[:, :3, :3] @ np.swapaxes(poses[0][:, :3, :3], -1, -2)
    spin = np.stack([turn[:, 2, 1] - turn[:, 1, 2], turn[:, 0, 2] - turn[:, 2, 0],
                     turn[:, 1, 0] - turn[:, 0, 1]], -1) / 2  # fmt: skip
    shift = there[:, :3, 3] - np.einsum("bij,bj->bi", turn, poses[0][:, :3, 3])
    twist = np.concatenate([spin, shift], -1)
    return twist[SECOND] - twist[FIRST]


def test_slope_of_the_least_clearance():
    thick = plain(50.0, 80.0, 0.47)
    held = outermost(holding(thick, HINGE)).scaled(1 / 80.0)
    levels = []
    for x in (0.699, 0.7, 0.701):
        closure, poses = thick.near(np.array([0]), np.array([x]))
        found, slope, _ = least_clearance(held, closure, poses, 1e-7)
        levels.append((found[0], slope[0] * thick.turns[0]))
    assert levels[1][1] == pytest.approx((levels[2][0] - levels[0][0]) / 0.002, rel=0.03)


def test_single_units_and_batches_agree(typical, assessed):
    batch = thick((50, 45), (0.48, 0.39), 100).compensated()
    peak, peak_at, hinge = margin.peak_misfit(batch)
    assert peak.shape == peak_at.shape == hinge.shape == (2,)
    assert peak[1] == pytest.approx(assessed.peak_misfit)
    assert batch.misfit(peak_at[0])[0].max() == pytest.approx(peak[0])
    assert np.ndim(assessed.margin) == 0
    both = margin.needed_clearance(batch, holding(batch, HINGE))[0]
    assert both[1] == pytest.approx(assessed.margin, rel=2e-3)


def test_assessment(assessed):
    assert assessed.needed_gap == pytest.approx(assessed.margin * HINGE.gap_length)
    assert assessed.bistable
    assert not assessed.floppy
    assert assessed.strain == pytest.approx(assessed.peak_misfit / 100)
    assert not assessed.overstrained
    assert assessed.warnings() == []


def test_warnings_name_the_trouble_and_the_cure(assessed):
    first, second = map(str, replace(assessed, margin=0.9, strain_limit=0.01).warnings())
    assert "floppy" in first
    assert "EdgeLength" in first
    assert "flexible hinges" in first
    assert "strains by 1.9%" in second
    (rising,) = map(str, replace(assessed, bistable=np.False_).warnings())
    assert "no second stable state" in rising
    assert "Compensate" in rising


def test_warnings_of_a_batch_name_the_unit(assessed):
    both = {name: np.full(2, value) for name, value in vars(assessed).items()}
    both |= {"gap": 0.4, "strain_limit": 0.02, "margin": np.array([1.2, 0.3])}
    (sentence,) = map(str, margin.Snap(**both).warnings())
    assert sentence.startswith("Unit 2 is floppy")


def test_uncompensated_units_may_have_no_second_stable_state():
    """The table of section 3: the first row's misfit still rises, the second's has passed."""
    unit = plane_unit(np.radians([50, 40]), np.array([0.5, 0.36]), 45, 15)
    found = margin.assess(ThickUnit(unit, 2.8 / 3, 1.4 / 3))
    assert found.bistable.tolist() == [False, True]
    assert found.deployed_misfit == pytest.approx(np.array([0.43, 0.50]), rel=0.05)
    assert found.peak_at[0] == pytest.approx(1)
    assert found.peak_misfit == pytest.approx(np.array([0.43, 0.55]), rel=0.05)


def test_hinges_without_play_are_never_floppy(typical):
    found = margin.assess(typical, None)
    assert found.margin == np.inf
    assert not found.floppy
