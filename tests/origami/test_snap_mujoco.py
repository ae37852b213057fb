# SPDX-License-Identifier: LGPL-2.1-or-later
"""MuJoCo opens a floppy unit with a tiny torque, and is held up where the margin is above 1.

Every cone is a rigid body's convex mesh, every recess sixteen plates round it, without friction;
nothing else holds the fifteen bodies together.
"""

import numpy as np
import pytest

from BistableWB.origami import rigid
from BistableWB.origami.hinges.bodies import tube_layouts
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.snap import margin
from BistableWB.origami.snap.contact import holding
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit
from BistableWB.origami.units.creases import BODIES, CREASES
from tests.judges import judge

pytestmark = pytest.mark.slow

SIDES = 16
WALL = 0.3  # mm, half the plates' thickness
START, OPEN = 0.5, 0.93
TORQUE, STEPS = 3.0, 9000  # it presses cones 0.01 mm into their recesses, at the most
CONTACT = 'condim="1" margin="0" solref="-300 -20" solimp="1 1 .001"'
MODEL = """<mujoco><compiler angle="radian" inertiafromgeom="false"/>
<option timestep="0.01" gravity="0 0 0" integrator="implicitfast" cone="elliptic" iterations="60"/>
<default><geom contype="0" conaffinity="0" mass="0"/></default>
<asset>{meshes}</asset><worldbody>{bodies}</worldbody><contact>{pairs}</contact></mujoco>"""


def text(values):
    return " ".join(f"{value:.6g}" for value in np.ravel(values))


def cones(layout):
    """(name, frame at the base, carrier, other body, height) of the outer two at both ends."""
    for crease in CREASES:
        hinge = layout.hinges[crease.name]
        axis = np.array([hinge.direction.real, 0, hinge.direction.imag])
        up, last = np.array([0, 1.0, 0]), len(hinge.cones) - 1
        for k in sorted({0, 1, last - 1, last}):
            base, carrier = hinge.cones[k]
            place = hinge.point(base)
            turn = np.stack([up, np.cross(axis, up), axis], -1)
            frame = rigid.pose(turn, np.array([place.real, hinge.height, place.imag]))
            bodies = crease.bodies[carrier], crease.bodies[1 - carrier]
            yield f"{crease.name}_{k}", frame, *bodies, hinge.cone_height


def plate(parameters, frame, height, j):
    """One side of a recess as a box: its attributes."""
    angle, base = parameters.cone_angle, parameters.cone_base
    turn = 2 * np.pi * (j + 0.5) / SIDES
    out, along = (
        np.array([np.cos(turn), np.sin(turn), 0]),
        np.array([-np.sin(turn), np.cos(turn), 0]),
    )
    normal = np.sin(angle) * out + [0, 0, np.cos(angle)]
    middle = (base - height / 2 / np.tan(angle)) * out
    middle = middle + [0, 0, parameters.gap_length + height / 2] + WALL * normal
    size = WALL, base * np.tan(np.pi / SIDES), height / 2 / np.sin(angle)
    axes = frame[:3, :3] @ np.stack([normal, along], 1)
    place = rigid.apply(frame, middle[None])[0]
    return f'size="{text(size)}" pos="{text(place)}" xyaxes="{text(axes.T)}"'


def model_of(mujoco, thick, parameters):
    meshes, pairs, geoms = [], [], dict.fromkeys(BODIES, "")
    turn = np.pi * np.arange(2 * SIDES) / SIDES
    circle = np.stack([np.cos(turn), np.sin(turn), 0 * turn], 1)
    for name, frame, carrier, other, height in cones(tube_layouts(thick, parameters)[0]):
        tip = parameters.tip_radius(height) * circle + [0, 0, height]
        points = rigid.apply(frame, np.concatenate([parameters.cone_base * circle, tip]))
        meshes.append(f'<mesh name="{name}" vertex="{text(points)}"/>')
        geoms[carrier] += f'<geom name="{name}" type="mesh" mesh="{name}"/>'
        for j in range(SIDES):
            side = plate(parameters, frame, height, j)
            geoms[other] += f'<geom name="{name}_{j}" type="box" {side}/>'
            pairs.append(f'<pair geom1="{name}" geom2="{name}_{j}" {CONTACT}/>')
    bodies = ""
    for k, body in enumerate(BODIES):
        own = [thick.axes[0][i].mean(0) for i, c in enumerate(CREASES) if body in c.bodies]
        bodies += f'<body name="{body}">{"<freejoint/>" if k else ""}<inertial mass="1" '
        bodies += f'pos="{text(np.mean(own, 0))}" diaginertia="300 300 300"/>{geoms[body]}</body>'
    made = MODEL.format(meshes="".join(meshes), bodies=bodies, pairs="".join(pairs))
    model = mujoco.MjModel.from_xml_string(made)
    model.dof_damping[:] = np.tile([0.006] * 3 + [0.4] * 3, len(BODIES) - 1)
    return model


def furthest(mujoco, model, thick):
    """The furthest opening that the torque leads to."""
    data, right = mujoco.MjData(model), model.body("contact_right").id
    for k, pose in enumerate(thick.poses(START)[0][1:]):
        data.qpos[7 * k : 7 * k + 3] = pose[:3, 3]
        mujoco.mju_mat2Quat(data.qpos[7 * k + 3 : 7 * k + 7], pose[:3, :3].ravel())
    ends = thick.unit.flat[0, :2]  # B, upper and lower
    leg = (ends[0] - ends[1]) / np.linalg.norm(ends[0] - ends[1])
    turn, best = thick.turns[0], 0.0
    data.xfrc_applied[right, 3:] = np.sign(turn) * TORQUE * leg
    for _ in range(STEPS // 100):
        mujoco.mj_step(model, data, 100)
        best = max(best, rigid.twist_angle(data.xmat[right].reshape(3, 3), leg) / turn)
        if best > OPEN:
            break
    return best


@pytest.mark.parametrize("wanted", [0.8, 1.3])
def test_a_tiny_torque_passes_floppy_hinges_only(monkeypatch, wanted):
    monkeypatch.setenv("MUJOCO_GL", "disable")  # it needs no window
    mujoco = judge("mujoco")
    thick = ThickUnit(plane_unit(np.radians([55.0]), 0.513, 80.0, 32.0), 1.2, 0.6).compensated()
    hinges = HingeParameters(gap_length=0.4 * 0.978 / wanted)
    found = margin.needed_clearance(thick, holding(thick, hinges))[0]
    assert found[0] == pytest.approx(wanted, abs=0.02)
    reached = furthest(mujoco, model_of(mujoco, thick, hinges), thick)
    assert (reached > OPEN) if wanted < 1 else (reached < 0.75)
