# SPDX-License-Identifier: LGPL-2.1-or-later
"""MuJoCo lets the arch of the examples hang from its first block: it folds, or it does not.

Four bodies, hinged about the units' legs at B, each with the torque that its unit gives back on
the way to flat. Gravity grows slowly; where one of them folds is what the safety factor is about.
"""

from dataclasses import replace

import numpy as np
import pytest

from BistableWB.origami import rigid
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.snap import load
from BistableWB.origami.snap.forces import snap_forces
from BistableWB.origami.snap.materials import material
from BistableWB.origami.snap.slop import standing
from BistableWB.origami.snap.study import layouts_of
from BistableWB.origami.thick import print_stack
from BistableWB.origami.thick.preload import preloaded
from BistableWB.origami.units.creases import BODIES
from tests.judges import judge
from tests.origami.shapes import arch_of_examples

mujoco = judge("mujoco", absent=("glfw", "OpenGL", "OpenGL.GL"))
pytestmark = pytest.mark.slow

HINGES, PLA = HingeParameters(), material("PLA")
STEP, STEPS = 2.0, 3000  # ms; 6 s
FOLDED = 0.75  # opening below which a unit has snapped back
STIFF = 2e4  # N·mm a radian, of a unit that opens further


@pytest.fixture(scope="module")
def arch():
    """The first four units of the arch, preloaded: all that `load.carried` asks for."""
    tube = arch_of_examples().part(0, 3)
    tube = replace(tube, thick=preloaded(tube.thick, HINGES.gap_length))
    layouts = layouts_of(tube, HINGES)
    units = snap_forces(tube.thick, layouts, HINGES, PLA)
    return tube.thick, tube.tube.incoming_left, layouts, units


def text(values):
    return " ".join(f"{v:.9g}" for v in np.ravel(values))


def model_of(thick, left, layouts):
    """A chain of bodies in the print's frame, each with the point masses of its unit's panels."""
    poses = print_stack.motions(thick, 1.0, left) @ print_stack.frames(thick, left)[:, None]
    mass = load.masses(layouts, HINGES, PLA.density)
    opens, closed, xml = [], "", ""
    for k, layout in enumerate(layouts):
        entry, leave = print_stack.contact_names(left[k])
        legs = rigid.apply(poses[k, BODIES.index(entry)], thick.unit.flat[k, :2])
        points = [
            (poses[k, b] @ [*load._middle(layout, name), 1])[:3]
            for b, name in enumerate(BODIES) if name != entry
        ]  # fmt: skip
        weights = [mass[k, b] for b, name in enumerate(BODIES) if name != entry]
        axis = legs[0] - legs[1]
        turn = thick.turns[k]  # of the right contact panel against the left one
        opens.append(np.sign(turn) if leave == "contact_right" else -np.sign(turn))
        spots = "".join(
            f'<geom type="sphere" size="2" pos="{text(p)}" mass="{w:.9g}"/>'
            for p, w in zip(points, weights, strict=True)
        )
        xml += f'<body><joint type="hinge" pos="{text(legs[0])}" axis="{text(axis)}"/>{spots}'
        closed += "</body>"
    made = (
        f'<mujoco><option timestep="{STEP}" integrator="implicitfast"/>'
        '<default><geom contype="0" conaffinity="0"/><joint damping="2e4"/></default>'
        f"<worldbody>{xml}{closed}</worldbody></mujoco>"
    )
    return mujoco.MjModel.from_xml_string(made), np.array(opens)


def folds(model, opens, forces, gravity):
    """Whether a unit folds within six seconds under ``gravity`` (mm/ms²)."""
    data = mujoco.MjData(model)
    for step in range(STEPS):
        model.opt.gravity[:] = min(2 * step / STEPS, 1) * gravity
        opening = 1 + opens * data.qpos / [each.angle for each in forces]
        given = np.array([
            np.interp(x, each.openings, each.closing_torques) + STIFF * max(x - 1, 0) * each.angle
            for x, each in zip(opening, forces, strict=True)
        ])  # fmt: skip
        # g mm²/ms² is 1 N·mm
        data.qfrc_applied[:] = -opens * given
        mujoco.mj_step(model, data)
        if opening.min() < FOLDED:
            return True
    return False


@pytest.mark.parametrize("way", [(0, 0, -1), (-1, 0, 0)])
def test_a_cantilever_folds_where_its_safety_says(arch, way):
    """A little more than that many times its weight folds it, a little less does not."""
    thick, left, layouts, units = arch
    model, opens = model_of(thick, left, layouts)
    found = load.carried(thick, layouts, HINGES, PLA.density, units, way, "Start", left)
    assert found.moments[found.weakest] > 0  # it folds, it does not open
    limit = found.factors.min() * load.GRAVITY * np.array(way)
    assert folds(model, opens, units, 1.15 * limit)
    assert not folds(model, opens, units, limit / 1.15)


def test_a_tube_that_hangs_down_does_not_fold(arch):
    """Not even under ten times its weight."""
    thick, left, layouts, units = arch
    model, opens = model_of(thick, left, layouts)
    down = standing(thick, left)[1]
    assert not folds(model, opens, units, 10 * load.GRAVITY * down / np.linalg.norm(down))
