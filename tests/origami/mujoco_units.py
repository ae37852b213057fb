# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models of units and tubes for MuJoCo: free bodies that only balls in cups hold together.

Every cone is a small ball on one body in a cup of twelve boxes on the other, as large as the
clearance is. Units: mm, g, ms, N. Contact panels that are one block are one body.
"""

import numpy as np

from BistableWB.origami import rigid
from BistableWB.origami.thick.closure import FIRST, SECOND
from BistableWB.origami.units.creases import BODIES
from tests.judges import judge

mujoco = judge("mujoco", absent=("glfw", "OpenGL", "OpenGL.GL"))

SIDES, BALL = 12, 0.2
STEP = 0.05  # ms


def text(values):
    return " ".join(f"{v:.9g}" for v in values)


def whole(unit, name):
    """Name of a body in a tube: (number of the unit, name)."""
    return f"{unit}_{name}"


class Model:
    """A model of units; ``founds``: outermost contacts of each; ``poses``: (n, 15, 4, 4).

    ``blocks``: {(unit, body): (unit, body) that it is one with}; ``fixed``: the body at rest, whose
    pose must be the identity.
    """

    def __init__(self, founds, poses, fixed, blocks=None, damping=0.02):
        self.poses, self.blocks = poses, blocks or {}
        self.geoms, self.pairs = {}, []
        for unit, found in enumerate(founds):
            self._add(unit, found)
        own = [(u, b) for u in range(len(founds)) for b in BODIES if (u, b) not in self.blocks]
        bodies = []
        for body in own:
            geoms = "".join(self.geoms.get(body, ()))
            middle = '<inertial pos="0 0 0" mass="1" diaginertia="150 150 150"/>'
            free = "" if body == fixed else f'<joint type="free" damping="{damping}"/>'
            bodies.append(f'<body name="{whole(*body)}">{free}{middle}{geoms}</body>')
        self.model = mujoco.MjModel.from_xml_string(
            f'<mujoco><option timestep="{STEP}" gravity="0 0 0" integrator="implicitfast"/>'
            '<default><geom contype="0" conaffinity="0"/></default><size memory="128M"/>'
            f"<worldbody>{''.join(bodies)}</worldbody>"
            f"<contact>{''.join(self.pairs)}</contact></mujoco>"
        )
        self.own, self.fixed = own, fixed

    def _host(self, unit, body):
        """The body that carries a part, and the motion from the part's frame into the body's."""
        host = self.blocks.get((unit, body), (unit, body))
        at = self.poses[host[0]][BODIES.index(host[1])]
        return host, rigid.inverse(at) @ self.poses[unit][BODIES.index(body)]

    def _put(self, unit, body, geom, point, axis):
        host, motion = self._host(unit, body)
        where = rigid.apply(motion, np.asarray(point)[None])[0]
        along = f'zaxis="{text(motion[:3, :3] @ axis)}"' if axis is not None else ""
        self.geoms.setdefault(host, []).append(
            f'<geom {geom} pos="{text(where)}" {along} mass="0"/>'
        )

    def _add(self, unit, found):
        # the circle between the polygon's inner and its outer one
        shrink = (1 + np.cos(np.pi / SIDES)) / 2
        for hinge, place in zip(*np.nonzero(found.valid[0]), strict=True):
            slope, lean = found.slope[0, hinge, place], found.lean[0, hinge, place]
            point, axis = found.points[0, hinge, place], found.axes[0, hinge]
            ball = f"ball{unit}_{hinge}_{place}"
            shape = f'name="{ball}" type="sphere" size="{BALL}"'
            self._put(unit, BODIES[SECOND[hinge]], shape, point, None)
            across = np.cross(axis, [0.0, 1.0, 0.0])
            for k, angle in enumerate(2 * np.pi * np.arange(SIDES) / SIDES):
                out = np.cos(angle) * across + np.sin(angle) * np.array([0.0, 1.0, 0.0])
                normal = slope * out - lean * axis
                length = np.linalg.norm(normal)
                normal = normal / length
                away = shrink * found.gap / length + BALL + 1.0
                cup = f"cup{unit}_{hinge}_{place}_{k}"
                shape = f'name="{cup}" type="box" size="4 4 1"'
                self._put(unit, BODIES[FIRST[hinge]], shape, point + away * normal, normal)
                self.pairs.append(
                    f'<pair geom1="{ball}" geom2="{cup}" condim="1" solref="0.12 1"/>'
                )

    def start(self):
        """Data with every body at its pose."""
        data = mujoco.MjData(self.model)
        at = 0
        for unit, body in self.own:
            if (unit, body) == self.fixed:
                continue
            pose, quat = self.poses[unit][BODIES.index(body)], np.zeros(4)
            mujoco.mju_mat2Quat(quat, pose[:3, :3].ravel())
            data.qpos[at : at + 7] = [*pose[:3, 3], *quat]
            at += 7
        mujoco.mj_forward(self.model, data)
        return data

    def pushed(self, body, force, torque, point, steps):
        """Pose (4, 4) of a body after a gentle push: force on its ``point`` (in its frame)."""
        data, number = self.start(), self.model.body(whole(*body)).id
        for step in range(steps):
            arm = data.xmat[number].reshape(3, 3) @ point
            share = min(step / 1000, 1)
            data.xfrc_applied[number, :3] = share * force
            data.xfrc_applied[number, 3:] = share * (torque + np.cross(arm, force))
            mujoco.mj_step(self.model, data)
        return rigid.pose(data.xmat[number].reshape(3, 3), data.xpos[number].copy())
