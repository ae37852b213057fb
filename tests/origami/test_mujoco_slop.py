# SPDX-License-Identifier: LGPL-2.1-or-later
"""MuJoCo judges free motion: bodies with balls in cups of our hinges' clearance, pushed gently."""

import numpy as np
import pytest

from BistableWB.origami import rigid
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.snap.contact import contacts, outermost
from BistableWB.origami.snap.slop import _Loose, standing, tube_slop
from BistableWB.origami.snap.study import layouts_of
from BistableWB.origami.thick import print_stack
from BistableWB.origami.thick.closure import RIGHT
from tests.origami.mujoco_units import Model
from tests.origami.shapes import arch_of_examples
from tests.origami.test_elastic import HINGES, unit

pytestmark = pytest.mark.slow

STEPS = 6000  # 0.3 s
PUSH = 0.5  # N·mm
LONG, PULL, LIGHT = 9000, 0.03, 0.005  # N, of a tube's end, and damping
UNITS = {
    "firm": (0.4865, HINGES),
    "firmer": (0.475, HINGES),
    "cones of 60°": (0.49, HingeParameters(cone_angle=np.radians(60))),
}


@pytest.mark.parametrize("name", UNITS)
def test_free_turns_are_those_of_a_multibody_engine(name):
    ratio, hinges = UNITS[name]
    thick, layout = unit(ratio, hinges)
    loose = _Loose(thick, layout, hinges)
    found = outermost(contacts([layout], hinges))
    model = Model([found], loose.poses[None], (0, "contact_left"))
    was, nothing = loose.poses[RIGHT, :3, :3], np.zeros(3)
    ours, theirs = [], []
    for row, column in ((0, 0), (0, 1), (2, 1)):
        axis = loose.axes()[row]
        torque = (2 * column - 1) * PUSH * axis
        pose = model.pushed((0, "contact_right"), nothing, torque, nothing, STEPS)
        theirs.append(rigid.rotation_vector(pose[:3, :3] @ was.T) @ axis)
        ours.append(loose.turns()[row, column])
    assert ours == pytest.approx(theirs, rel=0.15)


def test_free_end_of_a_tube_goes_as_far_as_in_a_multibody_engine():
    """Two units of the arch, the first block at rest, the last one pulled to either side."""
    tube = arch_of_examples().part(0, 1)
    thick, left = tube.thick, tube.tube.incoming_left
    layouts = layouts_of(tube, HINGES)
    slop = tube_slop(thick, layouts, HINGES, left)
    _, end, ways = standing(thick, left)
    poses = print_stack.motions(thick, 1.0, left) @ print_stack.frames(thick, left)[:, None]
    entry, leave = zip(*(print_stack.contact_names(one) for one in left), strict=True)
    home = rigid.inverse(poses[0, 0] if left[0] else poses[0, RIGHT])
    poses, end, ways = home @ poses, rigid.apply(home, end[None])[0], ways @ home[:3, :3].T
    founds = [outermost(contacts([layout], HINGES)) for layout in layouts]
    model = Model(founds, poses, (0, entry[0]), {(1, entry[1]): (0, leave[0])}, LIGHT)
    last = poses[1, 0 if leave[1] == "contact_left" else RIGHT]
    point = rigid.apply(rigid.inverse(last), end[None])[0]
    ours, theirs = [], []
    for row, column in ((0, 0), (1, 1)):
        force = (2 * column - 1) * PULL * ways[row]
        pose = model.pushed((1, leave[1]), force, np.zeros(3), point, LONG)
        theirs.append((rigid.apply(pose, point[None])[0] - end) @ ways[row])
        ours.append(slop.ends.sum(0)[row, column])
    assert ours == pytest.approx(theirs, rel=0.15)
