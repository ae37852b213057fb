"""Thick tubes follow their curve when deployed, and lie flat in one stack."""

import numpy as np
import pytest

from BistableWB.origami import print_stack, rigid
from BistableWB.origami import tube as tubes
from BistableWB.origami.bezier import Bezier
from BistableWB.origami.creases import BODIES
from BistableWB.origami.placement import place
from BistableWB.origami.ratios import RatioRule
from BistableWB.origami.thick_tube import thick_tube

ARCH = np.array([(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)])
PITCH = 1.8


class OnSphere:
    def point(self, s):
        t = np.asarray(s, float) * 1.8
        p = np.stack([np.cos(t), np.sin(t), 0.4 * np.sin(2 * t)], -1)
        return 220 * p / np.linalg.norm(p, axis=-1, keepdims=True)


def plane(compensate=True):
    return thick_tube(
        lambda tuning: place(Bezier(ARCH), 60, np.radians(20), PITCH, extra=tuning.extra),
        lambda placed, tuning: tubes.along(
            placed, "Plane", 2.5, RatioRule(share=0.06), tuning=tuning
        ),
        1.2,
        0.6,
        compensate,
    )


def sphere():
    legs = ("point", (0, 0, 0))
    return thick_tube(
        lambda tuning: place(OnSphere(), 60, np.radians(20), PITCH, legs, extra=tuning.extra),
        lambda placed, tuning: tubes.along(placed, "Sphere", 2.5, RatioRule("Exact"), 220, tuning),
        1.2,
        0.6,
    )


@pytest.fixture(scope="module")
def plane_tube():
    return plane()


def block_middles(tube, end):
    """Midpoints of all contact blocks in the deployed tube, from motions of the flat print."""
    lines = []
    places = print_stack.frames(tube.thick, tube.tube.incoming_left)
    moved = tube.motions(1.0)
    for k, left in enumerate(tube.tube.incoming_left):
        names = print_stack.contact_names(left)
        for name in names if k == len(places) - 1 else names[:1]:
            side = name.split("_")[1]
            rows = [f"{corner}_{e}" for corner in (f"A_{side}", "B") for e in end]
            corners = tube.thick.unit.flat[k][[tubes.INDEX[r] for r in rows]]
            lift = (-2 if side == "left" else 2) * PITCH
            middle = corners.mean(0) + np.array([0, lift, 0])
            motion = moved[k, BODIES.index(name)] @ places[k]
            lines.append(rigid.apply(motion, middle[None])[0])
    return np.array(lines)


def test_compensated_plane_tube_follows_its_curve(plane_tube):
    middles = block_middles(plane_tube, ("upper", "lower"))
    assert np.abs(middles - plane_tube.placement.midpoints).max() < 1e-3
    assert plane_tube.thick.misfit(1.0).max() < 1e-6
    assert plane_tube.deviation() < 1e-3


def test_sphere_tube_follows_its_curve():
    tube = sphere()
    middles = block_middles(tube, ("upper",))
    assert len(middles) > 10
    assert np.linalg.norm(middles - tube.placement.midpoints, axis=1).max() < 0.5
    assert tube.thick.misfit(1.0).max() < 1e-6


def test_without_compensation_the_tube_strays_and_does_not_close():
    tube = plane(compensate=False)
    assert tube.thick.misfit(1.0).max() > 0.3
    assert tube.deviation() > 1.0


@pytest.mark.parametrize("opening", [0.0, 0.3, 1.0])
def test_both_panels_of_a_block_move_alike(plane_tube, opening):
    moved = plane_tube.motions(opening)
    incoming = plane_tube.tube.incoming_left
    for k in range(len(incoming) - 1):
        out = BODIES.index(print_stack.contact_names(incoming[k])[1])
        into = BODIES.index(print_stack.contact_names(incoming[k + 1])[0])
        assert moved[k, out] == pytest.approx(moved[k + 1, into], abs=1e-9)


def test_flat_print_stays_where_it_lies(plane_tube):
    assert plane_tube.motions(0.0) == pytest.approx(
        np.broadcast_to(np.eye(4), (len(plane_tube.tube), 15, 4, 4)), abs=1e-9
    )
