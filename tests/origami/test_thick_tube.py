"""Thick tubes follow their curve when deployed, and lie flat in one stack."""

import numpy as np
import pytest

from BistableWB.origami import rigid
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.thick import blocks, print_stack
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.thick.thick_tube import thick_tube
from BistableWB.origami.units import tube as tubes
from BistableWB.origami.units.creases import BODIES
from BistableWB.origami.units.ratios import RatioRule

ARCH = np.array([(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)])
PITCH = 1.8


class OnSphere:
    def point(self, s):
        t = np.asarray(s, float) * 1.8
        p = np.stack([np.cos(t), np.sin(t), 0.4 * np.sin(2 * t)], -1)
        return 220 * p / np.linalg.norm(p, axis=-1, keepdims=True)


def made(curve, family, rule=None, legs=None, radius=None, compensate=True, edge=60):
    def placed(tuning):
        return place(curve, edge, np.radians(20), PITCH, legs, extra=tuning.extra)

    def tube(placement, tuning):
        return tubes.along(placement, family, 2.5, rule or RatioRule(), radius, tuning)

    return thick_tube(placed, tube, 1.2, 0.6, compensate)


V = ("point", (0, 0, 0))
SEEN = Bezier([(-240, -60, 390), (-90, 180, 480), (120, -180, 465), (270, 90, 375)])
RISING = Bezier(1.5 * ARCH + np.outer([0, 1, 2, 3], [0, 0, 40]))
MAKERS = {
    "plane": lambda: made(Bezier(ARCH), "Plane"),
    "sphere": lambda: made(OnSphere(), "Sphere", RatioRule("Exact"), V, 220),
    "rising": lambda: made(RISING, "General"),
    "viewpoint": lambda: made(SEEN, "General", legs=V),
}
_tubes = {}


@pytest.fixture(params=MAKERS)
def tube(request):
    """Each of these tubes in turn, made once."""
    name = request.param
    if name not in _tubes:
        _tubes[name] = MAKERS[name]()
    return _tubes[name]


def blocks_when_deployed(tube):
    """Mid-lines (2, 3) of all blocks by both their panels, from motions of the flat print."""
    found = []
    places = print_stack.frames(tube.thick, tube.tube.incoming_left)
    moved = tube.motions(1.0)
    for k, left in enumerate(tube.tube.incoming_left):
        for step, name in enumerate(print_stack.contact_names(left)):
            line = tube.thick.lines[k][0 if name == "contact_left" else 1][:: 1 - 2 * step]
            motion = moved[k, BODIES.index(name)] @ places[k]
            found.append((k + step, rigid.apply(motion, line)))
    return found


def test_every_block_stands_on_its_place_on_the_curve(tube):
    for k, line in blocks_when_deployed(tube):
        assert np.abs(line - tube.placement.segments[k]).max() < 1e-4
    assert tube.deviation() < 1e-4
    assert tube.thick.misfit(1.0).max() < 1e-6
    assert tube.tube.unit.isometry_error().max() <= 1e-12


def test_blocks_are_spanned_by_their_line_and_the_legs(tube):
    steps = blocks.steps(tube.thick, tube.tube.incoming_left)
    assert steps == pytest.approx(blocks.wanted_steps(tube.placement), abs=1e-5)


def test_blocks_lie_on_the_panels_of_both_their_units(tube):
    """The mid-line of a block runs along A-B of its contact panels, up to the shifts of hinges."""
    plain = ThickUnit(tube.tube.unit, 1.2, 0.6).lines
    off = tube.thick.lines - plain
    assert np.abs(off[..., 1]).max() == 0
    assert np.abs(off).max() < PITCH


def test_a_sphere_is_a_curve_seen_from_a_viewpoint():
    """Its units, contacts set apart by thickness, to 1e-9; with feedback to 1e-5 mm."""
    placed = place(OnSphere(), 60, np.radians(20), PITCH, V)
    units = [
        tubes.along(placed, family, 2.5, RatioRule("Exact"), 220).unit
        for family in ("General", "Sphere")
    ]
    for name in ("flat", "theta", "ratio", "alpha", "beta", "omega"):
        given, expected = (getattr(unit, name) for unit in units)
        assert given == pytest.approx(expected, rel=1e-9, abs=1e-9), name
    general, sphere = made(OnSphere(), "General", RatioRule("Exact"), V), MAKERS["sphere"]()
    assert general.thick.axes == pytest.approx(sphere.thick.axes, abs=1e-5)
    assert general.motions(1.0) == pytest.approx(sphere.motions(1.0), abs=1e-3)


def test_a_viewpoint_too_near_for_the_thickness_is_refused():
    near = Bezier(np.array([(-60, -15, 80), (-22, 45, 100), (30, -45, 96), (68, 22, 76)]))
    placed = place(near, 30, np.radians(20), 4.0, V)
    with pytest.raises(ValueError, match=r"Strip height h.*of unit \d+.*HeightRatio") as refused:
        tubes.along(placed, "General", 0.7, RatioRule())
    assert "\n" not in str(refused.value)


def test_without_compensation_the_tube_strays_and_does_not_close():
    tube = made(Bezier(ARCH), "Plane", RatioRule(share=0.06), compensate=False)
    assert tube.thick.misfit(1.0).max() > 0.3
    assert tube.deviation() > 1.0


@pytest.mark.parametrize("opening", [0.0, 0.3, 1.0])
def test_both_panels_of_a_block_move_alike(tube, opening):
    moved = tube.motions(opening)
    incoming = tube.tube.incoming_left
    for k in range(len(incoming) - 1):
        out = BODIES.index(print_stack.contact_names(incoming[k])[1])
        into = BODIES.index(print_stack.contact_names(incoming[k + 1])[0])
        assert moved[k, out] == pytest.approx(moved[k + 1, into], abs=1e-9)


def test_flat_print_stays_where_it_lies(tube):
    assert tube.motions(0.0) == pytest.approx(
        np.broadcast_to(np.eye(4), (len(tube.tube), 15, 4, 4)), abs=1e-9
    )


def test_a_part_of_a_tube_stands_where_it_stood_in_the_whole(tube):
    part = tube.part(2, 4)
    for k, line in blocks_when_deployed(part):
        assert np.abs(line - tube.placement.segments[2 + k]).max() < 1e-4
