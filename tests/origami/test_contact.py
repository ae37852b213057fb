# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where hinges touch, and what clearance poses need: against cones and rings sampled in space."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from BistableWB.origami import rigid
from BistableWB.origami.hinges.layout import unit_layout
from BistableWB.origami.hinges.parameters import FLEXIBLE, PIN, HingeParameters
from BistableWB.origami.snap import barrels
from BistableWB.origami.snap.contact import contacts, outermost
from BistableWB.origami.snap.margin import needed_clearance
from BistableWB.origami.thick.closure import FIRST, SECOND
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit

CONES = HingeParameters()
PINS = HingeParameters(pivot=PIN, face_thickness=2.4)
HINGE = 1  # AP_left_upper


def units(parameters, thetas=(45.0, 55.0)):
    theta = np.radians(thetas)
    low = np.sin(theta / 2)
    unit = plane_unit(theta, low + 0.1 * (1 - low), 80.0, 32.0)
    return ThickUnit(unit, parameters.face_thickness, parameters.gap_between_planes).compensated()


def held(parameters):
    thick = units(parameters)
    layouts = [unit_layout(axes, parameters, 80.0) for axes in thick.axes]
    return thick, layouts, contacts(layouts, parameters)


CONE_HELD, PIN_HELD = held(CONES), held(PINS)
HELD = {"Cone": CONE_HELD, "Pin": PIN_HELD}


def twisted(poses, twist):
    turn = rigid.rotation(twist[..., :3])
    place = (turn @ poses[..., :3, 3:])[..., 0] + twist[..., 3:]
    return rigid.pose(turn @ poses[..., :3, :3], place)


@pytest.mark.parametrize("pivot", HELD)
def test_derivatives_agree_with_differences(pivot):
    thick, _, found = HELD[pivot]
    poses = thick.poses(0.6)
    rng = np.random.default_rng(3)
    twist = rng.normal(size=(2, 15, 6)) * [1e-2, 1e-2, 1e-2, 1, 1, 1]
    step = 1e-5
    ahead, behind = (found.needed(twisted(poses, s * step * twist)) for s in (1, -1))
    slopes = found.needed_slopes(poses) @ (twist[:, SECOND] - twist[:, FIRST])[..., None]
    there = found.valid
    assert slopes[..., 0][there] == pytest.approx((ahead - behind)[there] / (2 * step), abs=2e-4)
    assert (slopes[..., 0][~there] == 0).all()


@pytest.mark.parametrize("pivot", HELD)
def test_closed_states_need_no_clearance(pivot):
    thick, _, found = HELD[pivot]
    for opening in (0.0, 1.0):
        # the layout lies on a grid of a tenth of a micrometre
        assert found.needed(thick.poses(opening)).max() < 2e-3
    assert found.needed(thick.poses(0.6)).max() > 0.5


@pytest.mark.parametrize("pivot", HELD)
def test_barrels_of_double_hinges_have_the_gap_between_planes(pivot):
    """Flat and deployed that is all there is; on the way a link leans, and there is less."""
    thick, _, found = HELD[pivot]
    for opening in (0.0, 1.0):
        room, _ = found.barrels.room(thick.poses(opening))
        assert room == pytest.approx(np.full_like(room, thick.gap_between_planes), abs=2e-3)
    assert found.barrels.room(thick.poses(0.6))[0].min() < 0.8 * thick.gap_between_planes


@pytest.mark.parametrize("pivot", HELD)
def test_barrels_part_as_their_derivatives_say(pivot):
    thick, _, found = HELD[pivot]
    poses, rng, step = thick.poses(0.6), np.random.default_rng(5), 1e-5
    twist = rng.normal(size=(2, 15, 6)) * [1e-2, 1e-2, 1e-2, 1, 1, 1]
    ahead, behind = (found.barrels.room(twisted(poses, s * step * twist))[0] for s in (1, -1))
    apart = (twist[:, barrels.SECOND] - twist[:, barrels.FIRST])[:, :, None]
    slopes = (found.barrels.room(poses)[1] * apart).sum(-1)
    assert slopes == pytest.approx((ahead - behind) / (2 * step), rel=0.02, abs=5e-3)


@pytest.mark.parametrize("angle", [45, 50, 55])
def test_barrels_only_ever_add_to_the_margin(angle):
    """Fine where play is small; with cones of 45° their play is more than half the gap."""
    thick, layouts, _ = CONE_HELD
    found = contacts(layouts, replace(CONES, cone_angle=np.radians(angle)))
    kept, _ = needed_clearance(thick, found)
    free, _ = needed_clearance(thick, replace(found, barrels=None))
    assert (kept >= free * (1 - 2e-3)).all()
    assert (kept < 1.05 * free).all()


def test_every_cone_and_ring_counts():
    for pivot, places in (("Cone", 2), ("Pin", 4)):
        _, layouts, found = HELD[pivot]
        for k, layout in enumerate(layouts):
            segments = [len(hinge.segments) for hinge in layout.hinges.values()]
            pivots = [n - 1 if pivot == "Cone" else n // 2 for n in segments]
            assert found.valid[k].sum() == places * sum(pivots)
        assert outermost(found).points.shape[2] <= found.points.shape[2]


@pytest.mark.parametrize("pivot", HELD)
@given(st.integers(0, 2**32 - 1))
@settings(max_examples=25, deadline=None)
def test_outermost_places_need_most(pivot, seed):
    _, _, found = HELD[pivot]
    rng = np.random.default_rng(seed)
    twist = rng.normal(size=(2, 15, 6)) * [1e-3, 1e-3, 1e-3, 0.1, 0.1, 0.1]
    poses = twisted(np.broadcast_to(np.eye(4), (2, 15, 4, 4)), twist)
    most = found.needed(poses).max(-1)
    assert outermost(found).needed(poses).max(-1) == pytest.approx(most, rel=1e-3, abs=1e-3)


def surface(parameters, height, low=0.0):
    """Points of a cone's surface on its axis z, base at 0, from ``low`` up to its tip."""
    z, turn = np.meshgrid(np.linspace(low, height, 60), np.linspace(0, 2 * np.pi, 120))
    radius = parameters.cone_base - z / np.tan(parameters.cone_angle)
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), z], -1).reshape(-1, 3)


def deepest(parameters, height, gap, pose):
    """How far (mm, axially) a cone runs into its recess, which ``pose`` carries: by points."""
    slope = np.tan(parameters.cone_angle)
    cone = rigid.apply(rigid.inverse(pose), surface(parameters, height)) - [0, 0, gap]
    inside = (cone[:, 2] >= 0) & (cone[:, 2] <= height)
    wall = parameters.cone_base - cone[:, 2] / slope
    one = (slope * (np.hypot(cone[:, 0], cone[:, 1]) - wall))[inside]
    recess = rigid.apply(pose, np.add(surface(parameters, height), [0, 0, gap]))
    inside = (recess[:, 2] >= 0) & (recess[:, 2] <= height)
    wall = parameters.cone_base - recess[:, 2] / slope
    other = (slope * (wall - np.hypot(recess[:, 0], recess[:, 1])))[inside]
    return max(one.max(), other.max())


@pytest.mark.parametrize("angle", [50, 55, 60])
@given(st.integers(0, 2**32 - 1))
@settings(max_examples=25, deadline=None)
def test_cones_need_what_their_surfaces_need(angle, seed):
    """Moved and tilted at random, cone and recess touch with just the clearance that is needed."""
    parameters = replace(CONES, cone_angle=np.radians(angle))
    _, layouts, _ = CONE_HELD
    rng = np.random.default_rng(seed)
    found = contacts(layouts, parameters)
    hinge = list(layouts[0].hinges.values())[HINGE]
    where = found.cones[0, HINGE] == 2
    assert (found.lean[0, HINGE][where] == 1).all()  # an even segment's, on the first body
    base, _ = hinge.cones[2]
    axis = np.array([hinge.direction.real, 0, hinge.direction.imag])
    frame = np.stack([np.cross([0, 1.0, 0], axis), [0, 1.0, 0], axis], -1)
    origin = np.array([hinge.point(base).real, hinge.height, hinge.point(base).imag])
    local = rigid.pose(rigid.rotation(rng.normal(size=3) * [0.01, 0.01, 1.0]), rng.normal(size=3))
    local[:3, 3] *= 0.02  # the law is one of first order
    to_unit = rigid.pose(frame, origin)
    poses = np.broadcast_to(np.eye(4), (2, 15, 4, 4)).copy()
    poses[:, SECOND[HINGE]] = to_unit @ local @ rigid.inverse(to_unit)
    gap = parameters.gap_length
    missing = (found.needed(poses)[0, HINGE][where].max() - 1) * gap
    assert missing == pytest.approx(deepest(parameters, hinge.cone_height, gap, local), abs=5e-3)


def test_flexible_hinges_are_refused():
    with pytest.raises(ValueError, match="Flexible hinges have no cones"):
        contacts([], replace(CONES, hinge_type=FLEXIBLE))
