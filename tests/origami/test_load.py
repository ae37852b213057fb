# SPDX-License-Identifier: LGPL-2.1-or-later
"""Free motion of deployed units, and whether a tube carries itself."""

import numpy as np
import pytest

from BistableWB.origami.errors import Refusal
from BistableWB.origami.hinges.layout import unit_layout
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.snap import load
from BistableWB.origami.snap.forces import SnapForces, Weakest
from BistableWB.origami.snap.slop import standing, tube_slop
from BistableWB.origami.thick import print_stack
from BistableWB.origami.units.creases import BODIES
from tests.origami.shapes import arch_of_examples

HINGES = HingeParameters()
DOWN, UP = (0, 0, -1), (0, 0, 1)


@pytest.fixture(scope="module")
def arch():
    """Part of the arch of the examples, and its layouts."""
    made = arch_of_examples().part(0, 3)
    return made, [unit_layout(axes, HINGES, 90) for axes in made.thick.axes]


def firm(torque, angle=0.9):
    """A unit that takes ``torque`` to fold, either way (N·mm)."""
    openings = np.array([0, 0.5, 0.9, 1.0])
    torques = np.array([0.0, torque / 2, -torque, 0])
    flat = np.zeros(4)
    weakest = Weakest(0.1, 5.0, 1.0, "PC_upper", "secondary_left_upper", 1, 0.9)
    return SnapForces(openings, flat, flat, torques, torques, angle, 90.0, weakest, True, 1e4)


def carried(arch, gravity, torques=100.0, fixed="Start"):
    tube, layouts = arch
    units = [firm(t) for t in np.broadcast_to(torques, len(layouts))]
    return load.carried(tube.thick, layouts, HINGES, 1.24, units, gravity, fixed,
                        tube.tube.incoming_left)  # fmt: skip


def test_weight_is_that_of_the_bodies(arch):
    """Volumes of the print, and the centre of mass in the middle of its bodies."""
    found = carried(arch, DOWN)
    per_unit = found.weight / 4
    assert 20 < per_unit < 45  # 15 bodies of 1.2 mm, ‖AB‖ 90, h 36
    assert abs(found.centre[1]) < 0.5


@pytest.mark.parametrize("gravity", [DOWN, UP, (1, 0, 0), (0.3, 0, 0.8)])
def test_moments_are_what_the_weight_gains_by_folding(arch, gravity):
    """Fold one unit a little: the work of the weight beyond it is the moment about its leg."""
    tube, layouts = arch
    thick, left = tube.thick, tube.tube.incoming_left
    found = carried(arch, gravity)
    mass = load.masses(layouts, HINGES, 1.24)
    way = np.asarray(gravity) / np.linalg.norm(gravity)
    k, step = 0, 1e-4
    angle = float(np.abs(thick._closure.turn[k]))
    heights = []
    for opening in (1 - step, 1 + step):
        poses = thick.poses(1.0).copy()
        poses[k] = thick[k : k + 1].poses(opening)[0]
        moved = print_stack.motions(_Posed(thick, poses), 1.0, left)
        points = moved @ print_stack.frames(thick, left)[:, None]
        middles = np.array(
            [[[*load._middle(layout, name), 1] for name in BODIES] for layout in layouts]
        )
        there = (points @ middles[..., None])[..., :3, 0]
        own = BODIES.index(print_stack.contact_names(left[k])[0])
        heights.append(load.GRAVITY * mass[..., None] * there @ way)
        heights[-1][k, own] = 0
    work = (heights[0] - heights[1]).sum() / (2 * step * angle)
    # inside the folding unit, panels do not turn with the block: its own weight counts in part
    slack = 1.2 * np.abs(load.GRAVITY * mass[k].sum() * 90)
    assert found.moments[k] == pytest.approx(work, abs=slack)
    assert np.sign(found.moments[k]) == np.sign(work) or abs(work) < slack


class _Posed:
    """A `ThickUnit` with other poses when deployed."""

    def __init__(self, thick, poses):
        self._thick, self._poses = thick, poses

    def __getattr__(self, name):
        return getattr(self._thick, name)

    def poses(self, opening):
        return self._poses


def test_a_tube_that_hangs_straight_down_is_not_folded_by_its_weight(arch):
    """Along the chord: every unit is pulled open about as much as it is folded, none gives way."""
    tube, _ = arch
    chord = carried(arch, DOWN)
    end = load._Standing(tube.thick, arch[1], tube.tube.incoming_left,
                         load.masses(arch[1], HINGES, 1.24)).end  # fmt: skip
    hanging = carried(arch, end / np.linalg.norm(end))
    assert hanging.factors.min() > chord.factors.min()
    assert hanging.stands


def test_the_weakest_unit_decides_and_a_held_end_helps(arch):
    free = carried(arch, (-1, 0, 0.2), (100, 20, 100, 100))
    both = carried(arch, (-1, 0, 0.2), (100, 20, 100, 100), "Both")
    assert both.factors.min() > free.factors.min()
    assert free.factors == pytest.approx(np.minimum(free.bears / np.abs(free.moments), load.MOST))


@pytest.mark.parametrize("fixed", ["Start", "Both"])
def test_turned_any_way_is_what_a_search_of_all_directions_finds(arch, fixed):
    """Directions all over the sphere, each by itself."""
    number = np.arange(400) + 0.5
    height, turn = 1 - number / 200, np.pi * (1 + 5**0.5) * number
    round_ = np.sqrt(1 - height**2)
    ways = np.stack([round_ * np.cos(turn), round_ * np.sin(turn), height], 1)
    each = [carried(arch, way, (300, 90, 200, 400), fixed) for way in ways]
    factors = np.min([found.factors for found in each], 0)
    turned = each[0].turned
    assert (factors >= turned * (1 - 1e-9)).all()
    assert factors == pytest.approx(turned, rel=0.02)


def test_the_free_load_brings_the_weakest_unit_to_its_limit(arch):
    found = carried(arch, (1, 0, 0), 400.0)
    tube, layouts = arch
    standing = load._Standing(tube.thick, layouts, tube.tube.incoming_left,
                              load.masses(layouts, HINGES, 1.24))  # fmt: skip
    levers = standing.about_legs(standing.at_end(np.array([1.0, 0, 0])))
    there = found.moments + found.free * levers
    limits = np.where(there > 0, firm(400.0).closing_torque, 1e4)
    assert (np.abs(there) / limits).max() == pytest.approx(1, rel=1e-2)


@pytest.mark.parametrize(
    ("gravity", "fixed", "parameter"),
    [
        ((0, 0, 0), "Start", "Gravity"),
        (DOWN, "None", "FixedAt"),
        ((np.nan, 0, 0), "Both", "Gravity"),
    ],
)
def test_no_support_and_no_gravity_are_refused(arch, gravity, fixed, parameter):
    with pytest.raises(Refusal) as refused:
        carried(arch, gravity, fixed=fixed)
    assert refused.value.parameter == parameter


@pytest.mark.slow
def test_free_motion_keeps_every_cone_in_its_recess(arch):
    """And a little more of it would not: the ends of the freedom are ends."""
    tube, layouts = arch
    part = tube.part(0, 1)
    found = tube_slop(part.thick, layouts[:2], HINGES, part.tube.incoming_left)
    assert (found.angles[..., 0] < 0).all()
    assert (found.angles[..., 1] > 0).all()
    # left and right, upper and lower: twist and sway are symmetric on a plane
    assert found.angles[:, 1:, 0] == pytest.approx(-found.angles[:, 1:, 1], rel=0.02)
    assert np.degrees(found.twist) == pytest.approx([2.8, 2.8], abs=0.4)
    assert found.usual < found.end


@pytest.mark.slow
def test_the_extremes_are_where_the_free_end_goes(arch):
    """Bodies of the ghost: the first stays, the last is about where the units' ends add up to."""
    part = arch[0].part(0, 1)
    thick, left = part.thick, part.tube.incoming_left
    found = tube_slop(thick, arch[1][:2], HINGES, left)
    deployed, end = print_stack.motions(thick, 1.0, left), standing(thick, left)[1]
    entry, leave = (BODIES.index(print_stack.contact_names(left[k])[k]) for k in (0, 1))
    row = int(np.abs(found.ends.sum(0)).max(-1).argmax())
    for side, motions in enumerate(found.extremes(thick, left)):
        assert motions[0, entry] == pytest.approx(deployed[0, entry], abs=1e-9)
        carried = motions[1, leave] @ np.linalg.inv(deployed[1, leave]) @ [*end, 1]
        gone = (carried[:3] - end) @ found.directions[row]
        assert gone == pytest.approx(found.ends[:, row, side].sum(), rel=0.1)
