# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size of a print before anything is built, and how to split one that is too large for the bed."""

from dataclasses import dataclass

import numpy as np

from ..origami import print_stack, rigid
from ..origami.hinge_plan import link_section
from .findings import ERROR, NOTE, Finding

ANGLES = np.radians(np.arange(0, 180, 2.0))  # by which a print may be turned on the bed


@dataclass(frozen=True)
class Bed:
    """Printing room of a printer, mm: ``width`` × ``depth`` × ``height``."""

    width: float = 250.0
    depth: float = 210.0
    height: float = 210.0


@dataclass(frozen=True)
class PrintSize:
    """Extent of a flat-folded print, mm, and the angle (radians) it is turned by on the bed."""

    width: float
    depth: float
    height: float
    turn: float = 0.0


def outlines(thick, parameters, incoming_left=None):
    """Corners (n, 10, 2) of all units in the print's plan, mm, and what sticks out beyond them.

    Vertices lie within the plates' outline but for the barrels (their radius) and, at the leg at B
    and along P–B, the spines of the links.
    """
    frames = print_stack.frames(thick, incoming_left)
    flat = thick.unit.flat.reshape(-1, *thick.unit.flat.shape[-2:])
    shift = float(np.abs(thick.shifts).max())
    return rigid.apply(frames, flat)[..., :2], link_section(parameters).outer + shift


def stack_height(count, parameters):
    """Height of ``count`` units lying on each other: count · 4p − g (mm)."""
    return 4 * parameters.pitch * count - parameters.gap_between_planes


def print_size(corners, margin, parameters, bed=None, on_edge=False):
    """`PrintSize` of units whose outlines are ``corners`` (n, 10, 2), from `outlines`.

    With a ``bed`` the print is turned so that it fits best, else as it lies. ``on_edge``: it stands
    on its side, A–B of the first unit upright.
    """
    height = stack_height(len(corners), parameters)
    points = corners.reshape(-1, 2)
    low, high = points.min(0) - margin, points.max(0) + margin
    if on_edge:
        points = np.array([[x, y] for x in (0, height) for y in (low[1], high[1])])
        height, margin = float(high[0] - low[0]), 0.0
    best = None
    for turn in ANGLES if bed else ANGLES[:1]:
        axes = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        width, depth = (np.ptp(points @ axes.T, axis=0) + 2 * margin).tolist()
        over = max(width / bed.width, depth / bed.depth) if bed else 0.0
        if best is None or over < best[0]:
            best = over, PrintSize(width, depth, height, float(turn))
    return best[1]


def fits(size, bed):
    """Whether a print fits the printer's room."""
    return size.width <= bed.width and size.depth <= bed.depth and size.height <= bed.height


def split(thick, parameters, bed, incoming_left=None, on_edge=False):
    """Runs of units [(first, last)], counted from 0, each of which fits the bed by itself.

    As many units as possible go into every print; neighbouring runs are joined at the block between
    them. An empty list if a single unit does not fit.
    """
    corners, margin = outlines(thick, parameters, incoming_left)
    runs, first = [], 0
    while first < len(corners):
        last = first
        while last < len(corners) and fits(
            print_size(corners[first : last + 1], margin, parameters, bed, on_edge), bed
        ):
            last += 1
        if last == first:
            return []
        runs.append((first, last - 1))
        first = last
    return runs


def check_bed(thick, parameters, bed, incoming_left=None, on_edge=False):
    """List with one `Finding`: the print's size, or how many units fit and where to split it."""
    corners, margin = outlines(thick, parameters, incoming_left)
    size = print_size(corners, margin, parameters, bed, on_edge)
    room = f"{bed.width:g} × {bed.depth:g} × {bed.height:g} mm"
    extent = f"{size.width:.0f} × {size.depth:.0f} × {size.height:.1f} mm"
    if fits(size, bed):
        turned = f", turned by {np.degrees(size.turn):.0f}°" if size.turn else ""
        return [
            Finding(
                NOTE,
                "bed",
                (),
                size.height,
                bed.height,
                f"The print is {extent} large and fits the bed of {room}{turned}.",
            )
        ]
    runs = split(thick, parameters, bed, incoming_left, on_edge)
    if not runs:
        alone = print_size(corners[:1], margin, parameters, bed, on_edge)
        over = max(alone.width / bed.width, alone.depth / bed.depth, alone.height / bed.height)
        return [
            Finding(
                ERROR,
                "bed",
                ("unit01",),
                over,
                1.0,
                f"Not even one unit, {alone.width:.0f} × {alone.depth:.0f} × "
                f"{alone.height:.1f} mm large, fits the bed of {room}.",
                f"make EdgeLength at least {over:.2f} times shorter",
            )
        ]
    count = len(corners)
    prints = ", ".join(f"{a + 1}–{b + 1}" for a, b in runs)
    return [
        Finding(
            ERROR,
            "bed",
            (),
            size.height,
            bed.height,
            f"The print of {count} units is {extent} large, too large for the bed of "
            f"{room}: {runs[0][1] + 1} units fit.",
            f"split the tube at contact blocks into {len(runs)} prints of units {prints}",
        )
    ]
