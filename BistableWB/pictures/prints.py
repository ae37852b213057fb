# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of hinged prints as shaded solids: the stack and the tube, the way between, a hinge.

``bodies`` are `meshes.PlacedMesh`, ``motions`` one (4, 4) a body from the flat print, None for
what is left out, as in HingeSet's model.
"""

import math

import numpy as np

from .. import colours
from . import stage
from .page import DPI, blank_axes, figure, round_length, scale_bar
from .shading import Ground, render_solids, shadow_points

_WIDTH = 9.0  # inches
_TALLEST = 6.2
_ELEVATION = math.radians(34)
_TURN = math.radians(20)
_BED_MARGIN = 15.0  # mm around a print, at least
_FOOT = 0.92  # inches of text below a picture
_HEAD = 0.12


def stack_and_tube(path, bodies, motions, legs=None, forward=None, stand=None):
    """The flat print on a bed and, beside it, the deployed tube, in one light and at one scale.

    ``legs`` (3,): direction that points up in the picture (the print's own if None); ``forward``:
    horizontal direction to look along then; ``stand`` (4, 4): how the print stands on the bed.
    """
    tube = stage.solids(bodies, motions)
    flat = stage.solids(bodies, None if stand is None else [stand] * len(bodies))
    flat_size = stage.size(flat)
    if legs is not None:
        tube = stage.turned(tube, stage.upright(legs))
    view = stage.view_along((0, 1, 0) if forward is None else forward, _TURN, _ELEVATION)
    tube, flat = stage.set_down(tube), _facing(stage.set_down(flat), view)
    flat, tube, bed = _side_by_side(view, flat, tube)
    texts = [
        ("printed flat-folded", flat_size, f"one print, {len(bodies)} bodies"),
        ("deployed", stage.size(tube), _opened(bodies, motions)),
    ]
    _draw(path, view, [flat, tube], [bed], texts, stage.kinds_of(bodies))
    return path


def print_on_bed(path, bodies):
    """A print by itself on its bed."""
    view = stage.view_along((0, 1, 0), _TURN, _ELEVATION)
    things = stage.set_down(stage.solids(bodies))
    half = _bed_size(things)
    text = ("as printed", stage.size(things), f"{len(bodies)} bodies")
    _draw(path, view, [things], [Ground(-half, half, -0.02, bed=True)], [text], [], widest=5.5)
    return path


def print_with_ties(path, bodies, ties):
    """A print on edge seen from both sides; its ties stand out, its bodies are pale."""
    view = stage.view_along((0, 1, 0), _TURN, _ELEVATION)
    states, texts, right = [], [], 0.0
    for turn, name in ((0.0, "from one side"), (np.pi, "from the other")):
        move = np.eye(4)
        move[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
        held = [body._replace(place=move @ body.place, kind="support") for body in bodies]
        things = stage.solids([*held, *(tie._replace(place=move @ tie.place) for tie in ties)])
        left, wide = _reach(view, things)
        states.append(stage.shifted(things, (right - left) * view.axes[0]))
        right += wide + 10.0
        texts.append((name, stage.size(things), f"{len(ties)} ties"))
    _draw(path, view, states, [], texts, [])
    return path


def openings(path, bodies, motions):
    """One unit or tube in several states at one scale; ``motions`` {opening: motions}."""
    view = stage.view_along((1, 0, 0), -1.5 * _TURN, math.radians(24))
    states, texts, right = [], [], 0.0
    for opening, moves in motions.items():
        things = stage.set_down(stage.solids(bodies, moves))
        left, wide = _reach(view, things)
        states.append(stage.shifted(things, (right - left) * view.axes[0]))
        right += wide + 10.0
        name = {0: "flat, as printed", 1: "deployed"}.get(opening, f"{opening:.0%} open")
        texts.append((name, stage.size(things), ""))
    _draw(path, view, states, [], texts, stage.kinds_of(bodies))
    return path


def _opened(bodies, motions):
    if any(motion is None for motion in motions):
        return "the rigid bodies; the strips bend between them"
    return "the same bodies, opened"


def _facing(things, view):
    """The print turned on its bed so that its longer side faces the viewer, square to the bed."""
    right = view.axes[0]
    angle = math.atan2(right[1], right[0]) + math.radians(24)
    cos, sin = math.cos(angle), math.sin(angle)
    return stage.set_down(stage.turned(things, [[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]]))


def _reach(view, things):
    """Left end and width of solids as the view sees them, mm."""
    across = np.concatenate([(t.corners @ view.axes[0]).reshape(-1) for t in things])
    return across.min(), np.ptp(across)


def _side_by_side(view, flat, tube):
    """Both set beside each other, their fronts in line, and the bed below the flat one."""
    right, ahead = view.axes[0], np.cross([0, 0, 1.0], view.axes[0])
    half = _bed_size(flat)
    corners = np.array([[x, y, 0] for x in (-half[0], half[0]) for y in (-half[1], half[1])])
    left = _reach(view, tube)[0]
    depth = [np.concatenate([(t.corners @ ahead).reshape(-1) for t in ts]) for ts in (flat, tube)]
    gap = 0.05 * _reach(view, tube)[1]
    move = (left - gap - (corners @ right).max()) * right
    move += (depth[1].min() - (corners @ ahead).min()) * ahead
    flat = stage.shifted(flat, move)
    bed = Ground(move[:2] - half, move[:2] + half, -0.02, bed=True)
    return flat, tube, bed


def _bed_size(things):
    """Half the sides (2,) of a bed with room around a print, a multiple of 10 mm."""
    low, high = stage.box(things)[:, :2]
    return np.ceil((high - low + 2 * _BED_MARGIN) / 20) * 10


def _draw(path, view, groups, beds, texts, kinds, widest=_WIDTH):
    """Render groups of solids in one picture, with a text below each and a legend."""
    everything = [thing for group in groups for thing in group]
    low, high = stage.box(everything)
    reach = high[2] - low[2] + 20
    ground = Ground(low[:2] - reach, high[:2] + reach, -0.05)
    frame = frame_of(view, everything, beds)
    extent = frame[1] - frame[0]
    per_mm = min(widest / extent[0], (_TALLEST - _FOOT - _HEAD) / extent[1])
    image, seen = render_solids(view, everything, per_mm * DPI, [*beds, ground], frame=frame)
    height = extent[1] * per_mm + _FOOT + _HEAD
    with figure(path, widest, height) as sheet:
        left = (widest - extent[0] * per_mm) / 2
        sheet.figimage(image, round(left * DPI), round(_FOOT * DPI), origin="upper", zorder=-1)
        origin = np.array([seen[0] - left / per_mm, seen[2] - _FOOT / per_mm])
        axes = blank_axes(sheet, origin, origin + np.array([widest, height]) / per_mm)
        axes.patch.set_alpha(0)
        for group, text in zip(groups, texts, strict=True):
            _caption(axes, view, group, *text, seen[2])
        _legend(axes, kinds)
        corner = origin + np.array([0.25, 0.14]) / per_mm
        scale_bar(axes, corner, round_length(0.12 * widest / per_mm))


def frame_of(view, things, beds):
    """Lower left and upper right corner (2, 2) of the picture, mm of the view."""
    points = [view.seen(thing.corners.reshape(-1, 3))[:, :2] for thing in things]
    points.append(view.seen(shadow_points(view, things, 0.0))[:, :2])
    points += [view.seen(bed.corners.reshape(-1, 3))[:, :2] for bed in beds]
    low = np.min([p.min(0) for p in points], 0)
    high = np.max([p.max(0) for p in points], 0)
    margin = 0.02 * (high - low).max()
    return np.stack([low - margin, high + margin])


def _caption(axes, view, group, name, extent, note, bottom):
    """State, size and a note, below a group."""
    left, wide = _reach(view, group)
    x = left + wide / 2
    place = {"xycoords": "data", "textcoords": "offset points", "ha": "center", "va": "top"}
    axes.annotate(name, (x, bottom), xytext=(0, -1), fontsize=10.5, fontweight="bold", **place)
    text = " × ".join(f"{length:.0f}" for length in extent) + " mm"
    text += f"\n{note}" if note else ""
    axes.annotate(text, (x, bottom), xytext=(0, -16), fontsize=8.5, color=colours.MUTED, **place)


def _legend(axes, kinds):
    from matplotlib.patches import Patch

    if not kinds:
        return
    handles = [
        Patch(facecolor=colours.of(kind), edgecolor=colours.INK, linewidth=0.6, label=text)
        for kind, text in stage.LEGEND.items()
        if kind in kinds
    ]
    axes.legend(
        handles=handles, loc="lower right", ncols=len(handles), frameon=False, fontsize=8,
        handlelength=1.3, handleheight=1.0, columnspacing=1.4, borderaxespad=0.5,
    )  # fmt: skip
