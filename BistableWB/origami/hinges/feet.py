# SPDX-License-Identifier: LGPL-2.1-or-later
"""A foot: what stands between the flange of an end and a plane, square on it, when deployed.

It is a body of its own, printed on its sole beside the stack, and screwed to the flange through
its pilot holes. Its walls are upright on the plane; its top is as large as the flange, and larger
by what the leaning holes need.
"""

from collections.abc import Sequence
from math import sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..errors import Phrase, Refusal
from . import polygons
from .bodies import walls
from .boundary import Boundary
from .drafting import Draft

PILOT = 0.85  # of a screw's diameter: it cuts its own thread
_DEEP = 2.5  # screw diameters that a pilot hole goes in
_SHARE = 0.7  # of the way to the plane at most
_STEEPEST = 0.5  # least cosine between the end's direction and the plane's: 60°


class Plane(NamedTuple):
    """A plane by a ``point`` and its ``normal``, which points to the tube; global, mm."""

    point: tuple = (0.0, 0.0, 0.0)
    normal: tuple = (0.0, 0.0, 1.0)


class Flange(NamedTuple):
    """The outer face of an end's flange in the flat print: its ``outline`` and ``holes``.

    ``outline``: corners x + i y; ``holes``: their centres; ``level``: height of the face (mm);
    ``way``: 1 or −1, where it looks; ``motion`` (4, 4): from there to where it is deployed.
    """

    outline: Sequence[complex]
    holes: Sequence[complex]
    level: float
    way: float
    motion: NDArray


class Foot(NamedTuple):
    """``boundary`` in the foot's own frame, its sole on z = 0, and its ``seat``.

    That (4, 4) carries it to where it sits on the flange of the flat print.
    """

    boundary: Boundary
    seat: NDArray


def foot_for(flange: Flange, plane: Plane, screw: float, least: float, end: Phrase) -> Foot:
    """The `Foot` of a flange; ``screw``: diameter, ``least``: height that it needs (mm).

    ``end``: which one, for sentences. `Refusal` where the plane misses the end.
    """
    normal = _unit(plane)
    outward = flange.motion[:3, :3] @ [0.0, 0.0, flange.way]
    facing = float(-outward @ normal)
    if facing < _STEEPEST:
        x, y, z = -outward
        raise Refusal(
            "The foot's plane misses the {end} of the tube: that looks {angle:.0f}° away from it, "
            "60° at most; set {FootNormal} to about ({x:.2f}, {y:.2f}, {z:.2f}).",
            parameter="FootNormal",
            end=end,
            angle=float(np.degrees(np.arccos(np.clip(facing, -1, 1)))),
            x=float(x), y=float(y), z=float(z),
        )  # fmt: skip
    lean = sqrt(max(1 - facing**2, 0.0))
    outline = polygons.intersection(
        flange.outline, flange.outline, inset=-_DEEP * screw * lean - screw / 2
    )
    own = _frame(normal, np.asarray(plane.point, float), _carried(flange, outline).mean(0))
    top = rigid.apply(rigid.inverse(own), _carried(flange, outline))
    missing = least - float(top[:, 2].min())
    if missing > 0:
        raise Refusal(
            "The foot's plane is too near to the {end} of the tube, or cuts it: move {FootPoint} "
            "by {missing:.3g} mm against {FootNormal}, or more.",
            parameter="FootPoint",
            end=end,
            missing=missing,
        )
    if polygons.area([complex(x, y) for x, y, _ in top]) < 0:
        top = top[::-1]
    centres = rigid.apply(rigid.inverse(own), _carried(flange, flange.holes))
    inwards = own[:3, :3].T @ outward
    boundary = _drawn(top, centres, inwards, screw)
    return Foot(boundary, rigid.inverse(flange.motion) @ own)


def _unit(plane: Plane) -> NDArray:
    normal = np.asarray(plane.normal, float)
    length = float(np.linalg.norm(normal))
    if not (np.isfinite(length) and length > 0):
        raise Refusal(
            "{FootNormal} has no direction: set it to one that points from the plane to the tube.",
            parameter="FootNormal",
        )
    return normal / length


def _carried(flange: Flange, points: Sequence[complex]) -> NDArray:
    """Points (n, 3) of the flange's outer face, deployed."""
    flat = np.array([(p.real, p.imag, flange.level) for p in points])
    return rigid.apply(flange.motion, flat)


def _frame(normal: NDArray, point: NDArray, above: NDArray) -> NDArray:
    """(4, 4) from the foot's frame: z along the normal, the origin on the plane below ``above``."""
    aside = np.eye(3)[np.abs(normal).argmin()]
    x = aside - (aside @ normal) * normal
    x /= np.linalg.norm(x)
    found = np.eye(4)
    found[:3, :3] = np.stack([x, np.cross(normal, x), normal], 1)
    found[:3, 3] = above - ((above - point) @ normal) * normal
    return found


def _drawn(top: NDArray, centres: NDArray, inwards: NDArray, screw: float) -> Boundary:
    draft = Draft()
    sole = [draft.vertex((float(x), float(y), 0.0)) for x, y, _ in top]
    upper = [draft.vertex(tuple(map(float, p))) for p in top]
    walls(draft, sole, upper)
    draft.polygon(*reversed(sole))
    along = np.cross(inwards, np.eye(3)[np.abs(inwards).argmin()])
    along /= np.linalg.norm(along)
    along, across = (PILOT * screw / 2 * v for v in (along, np.cross(along, inwards)))
    rims = []
    for centre in centres:
        deep = min(_DEEP * screw, _SHARE * float(centre[2] / -inwards[2]))
        low, high = (
            draft.circle(tuple(c.tolist()), tuple(along.tolist()), tuple(across.tolist()))
            for c in (centre + deep * inwards, centre)
        )
        draft.ruled(low, high, -1)
        draft.plane([low])
        rims.append([~high])
    draft.plane(draft.ring(upper), *rims)
    return draft.boundary()
