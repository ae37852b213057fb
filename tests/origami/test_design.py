# SPDX-License-Identifier: LGPL-2.1-or-later
"""A design is one value: equal inputs are equal, any other is not, and nothing is done twice."""

from dataclasses import replace

import numpy as np
import pytest

from BistableWB.origami import design as designs
from BistableWB.origami import memory
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.design import CurveGeometry, Placing, Single, Thickness, TubeDesign
from BistableWB.origami.errors import Refusal
from BistableWB.origami.progress import Cancelled, Progress
from BistableWB.origami.snap.targets import TargetMargin
from BistableWB.origami.thick.thick_tube import thick_tube
from BistableWB.origami.units.ratios import RatioRule
from BistableWB.origami.units.tube import along

POINTS = [(0, 0), (40, 60), (90, 60), (130, 0)]
PANELS = Thickness(1.2, 0.6)


def design(points=POINTS, **changes):
    placing = Placing(CurveGeometry(Bezier(points)), 50.0, np.radians(20), PANELS.pitch)
    return replace(TubeDesign(placing, thickness=PANELS), **changes)


@pytest.fixture
def solved(monkeypatch):
    """Names of the solvers that were called, in their order."""
    memory.forget()
    calls = []

    def counted(name, function):
        def call(*args, **kwargs):
            calls.append(name)
            return function(*args, **kwargs)

        return call

    monkeypatch.setattr(designs, "place", counted("place", place))
    monkeypatch.setattr(designs.tubes, "along", counted("along", along))
    monkeypatch.setattr(designs, "thick_tube", counted("thick", thick_tube))
    return calls


def test_equal_inputs_made_anew_are_equal_and_solve_nothing(solved):
    first = design()
    first.thick()
    before = list(solved)
    again = design()
    assert again is not first
    assert again == first
    assert hash(again) == hash(first)
    assert again.thick() is first.thick()
    assert again.tube() is first.tube()
    assert again.placement() is first.placement()
    assert solved == before


def test_every_input_makes_another_design():
    base = design()
    where, target = base.where, TargetMargin(50.0, 1.8)
    geometry = where.geometry
    others = [
        design([*POINTS[:-1], (130, 1e-9)]),
        *(
            replace(base, where=replace(where, **change))
            for change in (
                {"edge_length": 50.1}, {"gamma": 0.3}, {"pitch": 0.0}, {"flip": True},
                {"level": True}, {"geometry": replace(geometry, family="General")},
                {"geometry": replace(geometry, legs=("parallel", (0, 0.1, 1)))},
                {"geometry": replace(geometry, legs=("point", (0, 0, 1)))},
                {"geometry": replace(geometry, sphere_radius=9.0)},
            )
        ),
        replace(base, height_ratio=2.6),
        *(
            replace(base, rule=rule)
            for rule in (
                RatioRule(share=0.05), RatioRule("Fixed", 0.4), RatioRule("TargetSnap"),
                RatioRule("TargetSnap", target=target),
                RatioRule("TargetSnap", target=replace(target, margin=1.6)),
            )
        ),
        *(
            replace(base, thickness=replace(PANELS, **change))
            for change in ({"face": 1.4}, {"gap": 0.8}, {"compensate": False})
        ),
        replace(base, where=Single(0.8)),
        replace(base, where=Single(0.8, omega=1.2)),
    ]  # fmt: skip
    assert len({base, *others}) == len(others) + 1
    assert base not in others


def test_pieces_of_a_curve_too_short_for_even_samples_are_seen():
    class Pieces:
        """Two curves that differ within one short piece only."""

        breaks = (0.0, 0.5, 0.5005, 1.0)

        def __init__(self, bump):
            self.bump = bump

        def point(self, s):
            s = np.asarray(s, float)
            inside = np.clip((s - 0.5) / 0.0005, 0, 1)
            return np.stack([100 * s, self.bump * inside * (1 - inside), 0 * s], -1)

    assert CurveGeometry(Pieces(0.0)) == CurveGeometry(Pieces(0.0))
    assert CurveGeometry(Pieces(0.0)) != CurveGeometry(Pieces(1e-6))


def test_another_ratio_places_nothing_and_another_thickness_makes_no_thin_tube(solved):
    base = design()
    base.tube()
    assert solved == ["place", "along"]
    other = replace(base, rule=RatioRule(share=0.05))
    other.tube()
    assert solved == ["place", "along", "along"]
    uncompensated = replace(base, thickness=replace(PANELS, compensate=False))
    assert uncompensated.thick().tube is base.tube()
    assert uncompensated.thick().placement is not None
    assert solved == ["place", "along", "along", "thick"]


def test_a_thick_tube_is_what_the_functions_below_make():
    found = design().thick()
    curve, gamma, pitch = Bezier(POINTS), np.radians(20), PANELS.pitch
    wanted = thick_tube(
        lambda tuning: place(curve, 50.0, gamma, pitch, extra=tuning.extra),
        lambda placed, tuning: along(placed, "Plane", 2.5, RatioRule(), tuning=tuning),
        PANELS.face,
        PANELS.gap,
    )
    assert np.array_equal(found.placement.points, wanted.placement.points)
    assert np.array_equal(found.thick.axes, wanted.thick.axes)
    assert found.deviation() < 1e-3


def test_a_thickness_that_the_triangles_do_not_know_makes_the_tube_stray():
    base = design()
    stray = replace(base, where=replace(base.where, pitch=0.0))
    assert not stray.allows_for_thickness
    assert stray.thick().deviation() > 1 > 100 * base.thick().deviation()


def test_a_single_unit_is_a_design_too():
    alone = TubeDesign(Single(np.radians(45), 60.0), RatioRule("Fixed", 0.42), thickness=PANELS)
    assert alone.placement() is None
    assert len(alone.tube()) == 1
    assert alone.thick().placement is None
    assert alone.thick().thick.misfit(1.0).max() < 1e-6
    assert Single(0.8, omega=1.2).family == "Sphere"
    assert alone.barriers().shape == (1,)


def test_what_was_cancelled_is_not_remembered():
    memory.forget()
    wanted = design()
    with pytest.raises(Cancelled):
        wanted.thick(Progress(cancelled=lambda: True))
    assert not TubeDesign.thick.known(wanted)
    wanted.thick()
    assert TubeDesign.thick.known(design())


def test_what_is_refused_is_refused_again_without_a_search(solved):
    tight = design()
    tight = replace(tight, where=replace(tight.where, edge_length=1e4))
    for _ in range(2):
        with pytest.raises(Refusal, match="EdgeLength") as refused:
            replace(tight).placement()
        assert refused.value.parameter == "EdgeLength"
    assert solved == ["place"]


def test_old_results_go_when_newer_ones_come():
    memory.forget()
    kept = [replace(design(), height_ratio=2.5 + k / 100) for k in range(20)]
    for one in kept:
        one.tube()
    fresh = [replace(one) for one in kept]
    known = [TubeDesign._tube.known(one.thin()) for one in fresh]
    assert known == [False] * 4 + [True] * 16
