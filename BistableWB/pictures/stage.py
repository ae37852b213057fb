# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of a print as coloured solids, set down on the ground beside each other."""

import numpy as np

from .. import colours
from ..origami.bezier import normalised
from ..origami.creases import BODIES, PANELS, kind_of
from .rendering import camera
from .shading import Solid

LINK = colours.MUTED
STRIP = colours.CURVE
MATERIALS = {
    "contact": "contact panels and blocks",
    "border": "border panels",
    "primary": "primary triangles",
    "secondary": "secondary triangles",
    "link": "links of double hinges",
    "strip": "flexible strips",
}


def colour_of(kind):
    """Colour of a kind of bodies, a key of `MATERIALS`."""
    return {"link": LINK, "strip": STRIP}.get(kind) or colours.PANELS[kind]


def kind_of_body(body):
    """Key of `MATERIALS` for a `PlacedMesh`; None for a plate of a test print."""
    if body.material != "rigid":
        return "strip"
    names = [name for _, name in body.members if name in BODIES]
    if not names:
        return None
    return kind_of(names[0]) if names[0] in PANELS else "link"


def kinds_of(bodies):
    """Keys of `MATERIALS` that there are, in its order."""
    found = {kind_of_body(body) for body in bodies}
    return [kind for kind in MATERIALS if kind in found]


def solids(bodies, motions=None):
    """`Solid` of every `PlacedMesh` as printed, or moved by ``motions`` (None: left out)."""
    if motions is None:
        motions = [np.eye(4)] * len(bodies)
    found = []
    for k, (body, motion) in enumerate(zip(bodies, motions, strict=True)):
        if motion is not None:
            kind = kind_of_body(body) or list(colours.PANELS)[k % len(colours.PANELS)]
            corners = body.mesh.moved(np.asarray(motion) @ body.place).corners
            found.append(Solid(corners.astype(np.float32), colour_of(kind)))
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
