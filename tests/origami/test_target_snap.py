# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ratios for a wanted snap (section 4 of the design notes on hinges, target snap)."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from BistableWB.origami.snap import margin, table
from BistableWB.origami.snap.contact import holding
from BistableWB.origami.snap.targets import TargetBarrier, TargetMargin
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit
from BistableWB.origami.units import angles
from BistableWB.origami.units.ratios import RULES, RatioRule
from BistableWB.origami.units.tube import make_unit

pytestmark = pytest.mark.slow


def measured(theta, ratio, target):
    """What `snap.assess` says of compensated units."""
    unit = plane_unit(theta, ratio, target.edge_length, target.edge_length / 2)
    hinges = replace(
        table.USUAL,
        face_thickness=2 / 3 * target.pitch,
        gap_between_planes=target.pitch / 3,
        gap_length=target.play * np.tan(table.USUAL.cone_angle),
    )
    thick = ThickUnit(unit, hinges.face_thickness, hinges.gap_between_planes).compensated()
    return margin.assess(thick, holding(thick, hinges), strain_limit=target.strain_limit)


@pytest.mark.parametrize(
    ("target", "degrees"),
    [
        (TargetMargin(80, 1.8), (40.0, 55.0)),
        (TargetMargin(110, 1.8, margin=2.2, play=0.25), (40.0, 66.0)),
        (TargetMargin(60, 1.8, margin=1.2, play=0.23), (38.2, 57.3)),
    ],
)
def test_the_margin_comes_out_as_wanted(target, degrees):
    theta = np.radians(degrees)
    found = target.choose(theta)
    real = measured(theta, found.ratio, target)
    assert found.reached.all()
    assert found.warnings == []
    # the table knows nothing of barrels that meet, which adds to firm units
    assert (real.margin > 0.95 * target.margin).all()
    assert (real.margin < 1.07 * target.margin).all()
    assert real.strain == pytest.approx(found.strain, rel=0.05)
    assert not real.overstrained.any()


def test_the_table_is_what_assess_says():
    """Nodes of the table: if this fails, run ``benchmarks/snap.py --write-table``."""
    nodes = np.array([[3, 6, 2], [5, 9, 3]])  # pitch ratio, θ, share
    for i, j, k in nodes:
        theta, share = table.THETAS[j], table.SHARES[k]
        found = table.measure(np.array([theta]), share, table.PITCH_RATIOS[i])
        assert table.table()[i, j, :, k] == pytest.approx(found[:, 0], rel=5e-3)


@given(st.floats(0.012, 0.05), st.floats(25, 85), st.floats(0.011, 0.3))
@settings(max_examples=40, deadline=None)
def test_margin_and_strain_fall_with_the_share(pitch_ratio, degrees, share):
    theta = np.radians([degrees, degrees])
    play, strain = table.at(theta, [share, 1.05 * share], pitch_ratio)
    assert play[0] > play[1] > 0
    assert strain[0] > strain[1] > 0


def test_units_that_cannot_reach_it_are_named_with_the_reason_and_the_cure():
    target = TargetMargin(60, 1.8, margin=2.5, strain_limit=0.02)
    theta = np.radians([25, 30, 50, 45])
    found = target.choose(theta)
    assert not found.reached.any()
    by_strain, by_share = map(str, found.warnings)
    assert by_strain.startswith("Units 3, 4 cannot reach the snap margin")
    assert "pass the StrainLimit of 2.0%" in by_strain
    assert "EdgeLength about" in by_strain
    assert by_share.startswith("Units 1, 2 cannot")
    assert "sin(theta/2)" in by_share
    assert found.share[:2] == pytest.approx(table.SHARES[0])
    real = measured(theta[3:], found.ratio[3:], target)
    assert not real.overstrained.any()
    assert real.margin == pytest.approx(found.achieved[3:], rel=0.05)


def test_floppy_units_are_called_floppy():
    (warning,) = map(str, TargetMargin(40, 1.8).choose(np.radians(25)).warnings)
    assert warning.startswith("The unit cannot reach")
    assert "floppy" in warning


def test_the_cure_that_is_named_helps():
    theta = np.radians([27.0])
    weak = TargetMargin(60, 1.8, margin=1.8)
    found = weak.choose(theta)
    assert not found.reached[0]
    longer = float(str(found.warnings[0]).split("EdgeLength about ")[1].split(" mm")[0])
    better = TargetMargin(longer, 1.8, margin=1.8).choose(theta)
    assert better.achieved[0] > 0.9 * 1.8


def test_a_hundred_units_are_quick(benchmark_seconds):
    theta = np.radians(np.linspace(25, 70, 100))
    TargetMargin(60, 1.8).choose(theta)
    assert benchmark_seconds(lambda: TargetMargin(61, 1.8, 1.4).choose(theta)) < 0.1


@pytest.fixture
def benchmark_seconds():
    import time

    def seconds(function):
        start = time.process_time()
        function()
        return time.process_time() - start

    return seconds


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"pitch": 0}, "Thickness is 0: without thickness there is no snap margin"),
        ({"margin": 0}, "TargetMargin is 0"),
        ({"margin": np.nan}, "TargetMargin is nan"),
        ({"play": 0}, "HingePlay is 0"),
        ({"strain_limit": -1}, "StrainLimit is -1"),
        ({"edge_length": 0}, "EdgeLength is 0"),
        ({"pitch": 6.0}, "too thick for the unit of theta 45.0°"),
    ],
)
def test_bad_numbers_are_refused_with_the_cure(values, said):
    target = TargetMargin(**({"edge_length": 60, "pitch": 1.8} | values))
    with pytest.raises(ValueError, match=said):
        target.choose(np.radians(45))


def test_a_wanted_barrier():
    theta = np.radians(np.linspace(20, 80, 9))
    found = TargetBarrier(1e-5).choose(theta)
    alpha, beta, _ = angles.angles_for(theta, found.ratio)
    assert margin.barrier(alpha, beta)[0] == pytest.approx(1e-5, rel=0.02)
    assert found.warnings == []


def test_a_barrier_out_of_reach():
    found = TargetBarrier(1e-3).choose(np.radians([15, 20, 80]))
    assert found.reached.tolist() == [False, False, True]
    assert "Units 1, 2 cannot reach the energy barrier" in str(found.warnings[0])
    with pytest.raises(ValueError, match="TargetBarrier is -1"):
        TargetBarrier(-1.0).choose(0.8)


def test_the_rule():
    assert "TargetSnap" in RULES
    target = TargetMargin(60, 1.8)
    rule = RatioRule("TargetSnap", target=target)
    assert np.ndim(rule.ratios(0.8)) == 0
    thetas = np.radians([40, 50])
    assert rule.ratios(thetas) == pytest.approx(target.choose(thetas).ratio)
    unit = make_unit("Sphere", np.array([0.8, 1.5]), 60, 2.5, rule, 1.4)
    assert unit.isometry_error().max() < 1e-12
