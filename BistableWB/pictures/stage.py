# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a print as coloured solids, set down on the ground beside each other."""

import numpy as np

from .. import colours
from ..origami.curves.bezier import normalised
from .rendering import camera
from .shading import Solid

# What a legend says of kinds of bodies.
LEGEND = {
    "contact": "contact panels and blocks",
    "border": "border panels",
    "primary": "primary triangles",
    "secondary": "secondary triangles",
    "link": "links of double hinges",
    "flexure": "flexures",
    "support": "soluble support",
    "foot": "ties and feet",
    "joint": "joints of parts",
}


def kinds_of(bodies):
    """Keys of `LEGEND` that there are, in its order; blocks are told as contact panels."""
    found = {"contact" if body.kind == "block" else body.kind for body in bodies}
    return [kind for kind in LEGEND if kind in found]


def solids(bodies, motions=None):
    """`Solid` of every `PlacedMesh` as printed, or moved by ``motions`` (None: left out)."""
    if motions is None:
        motions = [np.eye(4)] * len(bodies)
    found = []
    for body, motion in zip(bodies, motions, strict=True):
        if motion is not None:
            corners = body.mesh.moved(np.asarray(motion) @ body.place).corners
            found.append(Solid(corners.astype(np.float32), colours.of(body.kind)))
    return found


def sheets(polygons, fills):
    """`Solid` of every flat polygon (k, 3), which is seen from both sides, in its colour."""
    found = []
    for polygon, fill in zip(polygons, fills, strict=True):
        fan = np.array([polygon[[0, k, k + 1]] for k in range(1, len(polygon) - 1)])
        found.append(Solid(np.concatenate([fan, fan[:, ::-1]]).astype(np.float32), fill))
    return found


def box(things):
    """Lowest and highest corner (2, 3) of solids."""
    ends = [(thing.corners.min((0, 1)), thing.corners.max((0, 1))) for thing in things]
    low, high = zip(*ends, strict=True)
    return np.stack([np.min(low, 0), np.max(high, 0)])


def size(things):
    """Length, width, height (3,)."""
    return np.diff(box(things), axis=0)[0]


def shifted(things, by):
    """The solids moved by (3,)."""
    return [Solid(thing.corners + by, thing.colour) for thing in things]


def turned(things, axes):
    """The solids with rows of ``axes`` (3, 3) as their new x, y, z."""
    return [Solid(thing.corners @ np.asarray(axes).T, thing.colour) for thing in things]


def set_down(things, at=(0.0, 0.0)):
    """The solids with the middle of their plan at ``at`` and their lowest point at z = 0."""
    low, high = box(things)
    middle = (low + high) / 2
    return shifted(things, [at[0] - middle[0], at[1] - middle[1], -low[2]])


def upright(direction):
    """Rows (3, 3) of a frame whose z is ``direction``, turned as little as need be."""
    up = normalised(direction)
    if up[2] > 1 - 1e-9:
        return np.eye(3)
    helper = np.array([1.0, 0, 0]) if abs(up[0]) < 0.9 else np.array([0, 1.0, 0])
    right = normalised(helper - (helper @ up) * up)
    return np.stack([right, np.cross(up, right), up])


def view_along(forward, turn, elevation):
    """Camera that sees the ground from above its front, turned out of the front view (radians)."""
    cos, sin = np.cos(turn), np.sin(turn)
    turning = np.array([[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]])
    return camera(turning @ np.asarray(forward, float), (0, 0, 1), elevation)
