# SPDX-License-Identifier: LGPL-2.1-or-later
"""One hinge close up: on its unit, and cut along its axis so that cones and gaps show."""

import math

import numpy as np

from .. import colours
from ..origami.curves.bezier import normalised
from . import stage
from .page import DPI, blank_axes, figure, scale_bar
from .rendering import camera
from .shading import render_solids

_WIDTH, _HEIGHT, _FOOT = 9.0, 3.3, 0.62  # inches
_GAP = 0.15


def hinge_detail(path, bodies, motions, pair, axis, parameters):
    """A hinge as it stands at ``motions``, and the flat print cut along the hinge.

    ``bodies``: `PlacedMesh` of one unit; ``pair``: names of the two that the hinge joins; ``axis``:
    its ends (2, 3) in the print; ``parameters``: `HingeParameters`.
    """
    whole = stage.solids(bodies, motions)
    index = [body.name for body in bodies].index(pair[0])
    moved = np.asarray(axis) @ motions[index][:3, :3].T + motions[index][:3, 3]
    two = stage.solids([body for body in bodies if body.name in pair])
    names = [body.name for body, motion in zip(bodies, motions, strict=True) if motion is not None]
    joined = [whole[names.index(name)] for name in pair]
    with figure(path, _WIDTH, _HEIGHT) as sheet:
        width = (_WIDTH - 3 * _GAP) / 2
        length = np.linalg.norm(axis[1] - axis[0])
        views = (
            (_outside_view(moved, joined), whole, moved, 1.12 * length, None,
             "a hinge, printed in place", _facts(parameters)),
            (_section_view(axis), two, np.asarray(axis), 0.66 * length, _plane(axis),
             "the same hinge, flat, cut along its axis", _pivot_facts(parameters)),
        )  # fmt: skip
        for k, (view, things, line, reach, cut, name, note) in enumerate(views):
            left = _GAP + k * (width + _GAP)
            _close_up(sheet, view, things, line, (left, width, reach), cut)
            _text(sheet, left + width / 2, name, note)
    return path


def _close_up(sheet, view, things, line, room, cut):
    """One picture ``room`` = (left, width) inches and reach (mm) wide, its middle at the line's."""
    left, width, reach = room
    per_mm, height = width / reach, _HEIGHT - _FOOT - _GAP
    ends = view.seen(line)[:, :2]
    middle, half = ends.mean(0), np.array([width, height]) / per_mm / 2
    beside = np.mean([view.seen(thing.corners).mean((0, 1))[1] for thing in things]) - middle[1]
    middle[1] += 0.5 * half[1] * np.sign(beside) if cut is not None else 0.0
    frame = np.stack([middle - half, middle + half])
    image, _ = render_solids(view, things, per_mm * DPI, frame=frame, cut=cut, samples=3, bold=True)
    sheet.figimage(image, round(left * DPI), round(_FOOT * DPI), origin="upper", zorder=-1)
    origin = frame[0] - np.array([left, _FOOT]) / per_mm
    axes = blank_axes(sheet, origin, origin + np.array([_WIDTH, _HEIGHT]) / per_mm)
    axes.patch.set_alpha(0)
    if cut is not None:
        axes.plot(frame[:, 0], [ends[:, 1].mean()] * 2, color=colours.CURVE, lw=1.0,
                  ls=(0, (9, 3, 2, 3)))  # fmt: skip
    scale_bar(axes, frame[0] + 0.08 / per_mm, 5 if reach > 20 else 2)


def _text(sheet, x, name, note):
    place = {"ha": "center", "va": "top"}
    sheet.text(x / _WIDTH, (_FOOT - 0.08) / _HEIGHT, name, fontsize=10.5, weight="bold", **place)
    sheet.text(x / _WIDTH, (_FOOT - 0.30) / _HEIGHT, note, fontsize=8.5, color=colours.MUTED,
               linespacing=1.35, **place)  # fmt: skip


def _outside_view(line, pair):
    """From outside onto the ridge between the two panels, the hinge from left to right."""
    along = normalised(line[1] - line[0])
    inward = np.zeros(3)
    for panel in pair:
        arm = panel.corners.mean((0, 1)) - line.mean(0)
        inward += normalised(arm - (arm @ along) * along)
    up = np.cross(along, normalised(inward))
    up = up if up[2] > 0 else -up
    return camera(normalised(inward) + 0.30 * along, up, math.radians(16))


def _section_view(axis):
    """From above, tilted a little; the hinge from left to right."""
    return camera(np.cross([0, 0, 1.0], axis[1] - axis[0]), (0, 0, 1), math.radians(68))


def _plane(axis):
    return np.mean(axis, 0), np.array([0, 0, 1.0])


def _facts(p):
    return (
        f"panels {p.face_thickness:g} mm thick, {p.gap_between_planes:g} mm apart; "
        f"barrels {2 * p.radius:g} mm"
    )


def _pivot_facts(p):
    angle = math.degrees(p.cone_angle)
    pivot = f"cones of {angle:.0f}° in their recesses" if p.pivot == "Cone" else "a continuous pin"
    return f"{pivot}; gaps {p.gap_length:g} mm, play {p.play:.2f} mm"
