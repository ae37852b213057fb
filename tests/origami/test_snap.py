# SPDX-License-Identifier: LGPL-2.1-or-later
"""How strongly units snap (section 4 of the design notes on hinges)."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import nnls

from BistableWB.origami import angles, energy, snap
from BistableWB.origami.linkage import ThickUnit
from BistableWB.origami.play import smallest_largest
from BistableWB.origami.unit import plane_unit

A, B = np.radians(25), np.radians(35)


def thick(theta, ratio, edge, pitch=1.8):
    unit = plane_unit(np.radians(theta), np.asarray(ratio), edge, 20)
    return ThickUnit(unit, 2 / 3 * pitch, pitch / 3)


@pytest.fixture(scope="module")
def typical():
    return thick(45, 0.39, 100).compensated()


@pytest.fixture(scope="module")
def assessed(typical):
    return snap.assess(typical, play=0.4)


def test_known_barrier():
    assert snap.barrier(A, B)[0] == pytest.approx(5.893e-6, rel=2e-4)
    fractions, values = snap.energy_path(A, B, n=1000)
    assert values.max() == pytest.approx(5.893e-6, rel=2e-4)
    assert fractions[values.argmax()] == pytest.approx(snap.barrier(A, B)[1], abs=2e-3)


@given(st.floats(20, 80).map(np.radians), st.floats(0.02, 0.8))
def test_energy_is_zero_in_both_stable_states_only(theta, share):
    low = np.sin(theta / 2)
    alpha, beta, _ = angles.angles_for(theta, low + share * (1 - low))
    fractions, values = snap.energy_path(alpha, beta, n=21, end=1.1)
    stable = np.isclose(fractions % 1, 0, atol=0.02)
    deployed = np.abs(fractions - 1).argmin()
    assert values[0] < 1e-25
    assert energy.path(alpha, beta, [1.0])[0][0] < 1e-25
    assert (values[~stable] > 0).all()
    assert values[-1] > values[deployed]


def test_paths_are_batched():
    alpha, beta, _ = angles.angles_for(np.radians([40, 50]), np.array([0.4, 0.5]))
    fractions, values = snap.energy_path(alpha, beta, n=12)
    assert fractions.shape == (12,)
    assert values.shape == (2, 12)
    assert values[1] == pytest.approx(snap.energy_path(alpha[1], beta[1], n=12)[1])
    assert snap.barrier(alpha, beta)[0].shape == (2,)


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
        snap.energy_path(np.radians(25), np.radians(20))


@pytest.mark.parametrize(
    ("theta", "ratio", "edge", "needed"),
    [((45, 45, 60), (0.42, 0.39, 0.52), 100, (0.52, 0.94, 0.9)), ((45,), (0.42,), 60, (0.34,))],
)
def test_needed_play(theta, ratio, edge, needed):
    """Section 4 gives these as a rough computation."""
    delta, at = snap.needed_play(thick(theta, ratio, edge).compensated())
    assert delta == pytest.approx(np.array(needed), rel=0.1)
    assert ((at > 0.7) & (at < 0.9)).all()


def test_needed_play_is_a_true_minimum_of_the_maximum(typical):
    """Weights on the largest misfits balance: no motion makes all of them smaller at once."""
    closure, poses = typical.closures([[0.8]]), typical.states([[0.8]])[:, 0]
    delta, reached = smallest_largest(closure, poses, 1e-6)
    residual = closure.residual(reached)[0].reshape(-1, 3)
    gaps = np.linalg.norm(residual, axis=-1)
    assert gaps.max() == pytest.approx(delta[0])
    assert delta[0] < closure.gaps(poses).max()
    tight = np.flatnonzero(gaps > 0.999 * delta[0])
    jacobian = closure.jacobian(reached)[0].reshape(46, 3, -1)
    pulls = np.einsum("ei,eij->je", residual[tight] / gaps[tight, None], jacobian[tight])
    weights, unbalanced = nnls(np.vstack([pulls, np.ones(len(tight))]), np.r_[np.zeros(83), 1.0])
    assert weights.sum() == pytest.approx(1, abs=1e-3)
    assert unbalanced < 1e-3


def test_single_units_and_batches_agree(typical, assessed):
    batch = thick((50, 45), (0.48, 0.39), 100).compensated()
    peak, peak_at, hinge = snap.peak_misfit(batch)
    assert peak.shape == peak_at.shape == hinge.shape == (2,)
    assert peak[1] == pytest.approx(assessed.peak_misfit)
    assert batch.misfit(peak_at[0])[0].max() == pytest.approx(peak[0])
    assert assessed.needed_play < assessed.peak_misfit
    assert np.ndim(assessed.needed_play) == 0


def test_assessment(assessed):
    assert assessed.margin == pytest.approx(assessed.needed_play / 0.4)
    assert assessed.bistable
    assert not assessed.floppy
    assert assessed.strain == pytest.approx(assessed.peak_misfit / 100)
    assert not assessed.overstrained
    assert assessed.warnings() == []
    assert replace(assessed, play=0.0).margin == np.inf


def test_warnings_name_the_trouble_and_the_cure(assessed):
    first, second = replace(assessed, play=2.0, strain_limit=0.01).warnings()
    assert "floppy" in first
    assert "EdgeLength" in first
    assert "flexible hinges" in first
    assert "strains by 1.9%" in second
    (rising,) = replace(assessed, bistable=np.False_).warnings()
    assert "no second stable state" in rising
    assert "Compensate" in rising


def test_warnings_of_a_batch_name_the_unit(assessed):
    both = {name: np.full(2, value) for name, value in vars(assessed).items()}
    both |= {"play": 0.4, "strain_limit": 0.02, "needed_play": np.array([1.0, 0.1])}
    (sentence,) = snap.Snap(**both).warnings()
    assert sentence.startswith("Unit 2 is floppy")


def test_uncompensated_units_may_have_no_second_stable_state():
    """The table of section 3: the first row's misfit still rises, the second's has passed."""
    unit = plane_unit(np.radians([50, 40]), np.array([0.5, 0.36]), 45, 15)
    found = snap.assess(ThickUnit(unit, 2.8 / 3, 1.4 / 3), play=0)
    assert found.bistable.tolist() == [False, True]
    assert found.deployed_misfit == pytest.approx(np.array([0.43, 0.50]), rel=0.05)
    assert found.peak_at[0] == pytest.approx(1)
    assert found.peak_misfit == pytest.approx(np.array([0.43, 0.55]), rel=0.05)


def test_a_negative_play_is_refused(typical):
    with pytest.raises(ValueError, match="Play of a hinge is -1"):
        snap.assess(typical, play=-1)
