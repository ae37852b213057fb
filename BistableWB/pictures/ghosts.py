# SPDX-License-Identifier: LGPL-2.1-or-later
"""The deployed tube between the two places that its play lets it move to, drawn as pale ghosts."""

import math

import numpy as np

from .. import colours
from . import stage
from .page import DPI, blank_axes, figure, round_length, scale_bar
from .prints import frame_of
from .rendering import camera
from .shading import Solid, render_solids

_WIDTH, _TALLEST = 8.0, 6.0  # inches
_FOOT = 0.45
_GHOST = "#8FA3B3"
_STILL = 1e-3  # mm
_PALE = 0.45  # how much of a ghost covers what is behind it


def slop_picture(path, bodies, motions, extremes, end):
    """The deployed tube, and pale behind it where its free end is ``end`` mm away, to both sides.

    ``bodies``: `PlacedMesh`; ``motions``: of the deployed tube; ``extremes``: the same at both ends
    of its play (`snap.slop.Slop.extremes`). Seen square to the tube and to the way it goes.
    """
    tube, *ghosts = (stage.solids(bodies, moves) for moves in (motions, *extremes))
    frame = _frame(tube, ghosts[1])
    tube, *ghosts = (stage.turned(things, frame) for things in (tube, *ghosts))
    pale = [[Solid(thing.corners, _GHOST) for thing in ghost] for ghost in ghosts]
    view = camera((0, 1, 0), (0, 0, 1), math.radians(80))
    window = frame_of(view, [*tube, *pale[0], *pale[1]], [])
    extent = window[1] - window[0]
    per_mm = min(_WIDTH / extent[0], (_TALLEST - _FOOT) / extent[1])
    image = np.zeros(1)
    for things, share in ((pale[0], _PALE), (pale[1], _PALE), (tube, 1.0)):
        drawn, seen = render_solids(view, things, per_mm * DPI, frame=window)
        drawn[..., 3] *= share
        image = drawn if image.ndim == 1 else _over(drawn, image)
    with figure(path, _WIDTH, extent[1] * per_mm + _FOOT) as sheet:
        left = (_WIDTH - extent[0] * per_mm) / 2
        sheet.figimage(image, round(left * DPI), round(_FOOT * DPI), origin="upper", zorder=-1)
        origin = np.array([seen[0] - left / per_mm, seen[2] - _FOOT / per_mm])
        size = np.array([_WIDTH, extent[1] * per_mm + _FOOT]) / per_mm
        axes = blank_axes(sheet, origin, origin + size)
        axes.patch.set_alpha(0)
        text = f"free end ± {end:.1f} mm before anything bears, all units the same way"
        axes.annotate(text, (1, 0), xycoords="axes fraction", xytext=(-8, 8), ha="right",
                      textcoords="offset points", fontsize=9, color=colours.MUTED)  # fmt: skip
        corner = origin + np.array([0.25, 0.14]) / per_mm
        scale_bar(axes, corner, round_length(0.12 * _WIDTH / per_mm))
    return path


def _frame(tube, ghost):
    """Rows (3, 3): along the tube, the way that its end goes, and what is square to both."""
    was, now = (np.array([t.corners.mean((0, 1)) for t in things]) for things in (tube, ghost))
    gone = np.linalg.norm(now - was, axis=1)
    along = was[gone.argmax()] - was[gone.argmin()]
    along /= np.linalg.norm(along)
    way = (now - was)[gone.argmax()]
    if np.linalg.norm(way) < _STILL:
        way = np.eye(3)[np.abs(along).argmin()]
    way -= (way @ along) * along
    way /= np.linalg.norm(way)
    return np.stack([along, way, np.cross(along, way)])


def _over(front, back):
    """RGBA image of one in front of another."""
    a, b = front[..., 3:], back[..., 3:]
    alpha = a + b * (1 - a)
    colour = front[..., :3] * a + back[..., :3] * b * (1 - a)
    return np.concatenate([colour / np.maximum(alpha, 1e-6), alpha], -1)
