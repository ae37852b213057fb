# SPDX-License-Identifier: LGPL-2.1-or-later
"""Size of a print before anything is built, and how to split one that is too large for the bed."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import ceil
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..errors import ERROR, NOTE, Finding, phrase
from ..thick import print_stack
from .link_section import link_section

if TYPE_CHECKING:
    from ..thick.linkage import ThickUnit
    from .parameters import HingeParameters

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


def outlines(
    thick: "ThickUnit", parameters: "HingeParameters", incoming_left: NDArray | None = None
) -> tuple[NDArray, float]:
    """Corners (n, 10, 2) of all units in the print's plan, mm, and what sticks out beyond them.

    Vertices lie within the plates' outline but for the barrels (their radius) and, at the leg at B
    and along P–B, the spines of the links.
    """
    frames = print_stack.frames(thick, incoming_left)
    flat = thick.unit.flat.reshape(-1, *thick.unit.flat.shape[-2:])
    shift = float(np.abs(thick.shifts).max())
    return rigid.apply(frames, flat)[..., :2], link_section(parameters).outer + shift


def stack_height(count: int, parameters: "HingeParameters") -> float:
    """Height of ``count`` units lying on each other: count · 4p − g (mm)."""
    return 4 * parameters.pitch * count - parameters.gap_between_planes


def print_size(
    corners: NDArray,
    margin: float,
    parameters: "HingeParameters",
    bed: Bed | None = None,
    on_edge: bool = False,
    more: tuple[float, float] = (0.0, 0.0),
) -> PrintSize:
    """`PrintSize` of units whose outlines are ``corners`` (n, 10, 2), from `outlines`.

    ``more``: by how much (mm) its ends stand out all round, and how much higher they make it.

    With a ``bed`` the print is turned so that it fits best, else as it lies. ``on_edge``: it stands
    on its side, A–B of the first unit upright.
    """
    height = stack_height(len(corners), parameters) + more[1]
    margin = margin + more[0]
    points = corners.reshape(-1, 2)
    low, high = points.min(0) - margin, points.max(0) + margin
    if on_edge:
        points = np.array([[x, y] for x in (0, height) for y in (low[1], high[1])])
        height, margin = float(high[0] - low[0]), 0.0
    best: Any = None
    for turn in ANGLES if bed else ANGLES[:1]:
        axes = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        width, depth = (np.ptp(points @ axes.T, axis=0) + 2 * margin).tolist()
        over = max(width / bed.width, depth / bed.depth) if bed else 0.0
        if best is None or over < best[0]:
            best = over, PrintSize(width, depth, height, float(turn))
    return best[1]


def fits(size: PrintSize, bed: Bed) -> bool:
    """Whether a print fits the printer's room."""
    return size.width <= bed.width and size.depth <= bed.depth and size.height <= bed.height


def split(
    thick: "ThickUnit",
    parameters: "HingeParameters",
    bed: Bed,
    incoming_left: NDArray | None = None,
    on_edge: bool = False,
    more: tuple[float, float] = (0.0, 0.0),
) -> list[tuple[int, int]]:
    """Runs of units [(first, last)], counted from 0, each of which fits the bed by itself.

    As few prints as possible, which differ by one unit at the most; where such do not fit, as many
    units as possible in each one after the other. Neighbouring runs are joined at the block between
    them. An empty list if a single unit does not fit.
    """
    corners, margin = outlines(thick, parameters, incoming_left)

    def fit(first: int, after: int) -> bool:
        size = print_size(corners[first:after], margin, parameters, bed, on_edge, more)
        return fits(size, bed)

    full = _full_runs(len(corners), fit)
    even = _even_runs(len(corners), len(full)) if full else []
    return even if all(fit(first, last + 1) for first, last in even) else full


def _even_runs(count: int, parts: int) -> list[tuple[int, int]]:
    """``count`` units in so many runs, the first ones a unit longer where it does not divide."""
    sizes = [count // parts + (k < count % parts) for k in range(parts)]
    return [(sum(sizes[:k]), sum(sizes[: k + 1]) - 1) for k in range(parts)]


def _full_runs(count: int, fit: Callable[[int, int], bool]) -> list[tuple[int, int]]:
    """The longest runs that ``fit(first, after)``, one after the other; [] if one does not."""
    runs: list[tuple[int, int]] = []
    first = 0
    while first < count:
        last = first
        while last < count and fit(first, last + 1):
            last += 1
        if last == first:
            return []
        runs.append((first, last - 1))
        first = last
    return runs


def check_bed(
    thick: "ThickUnit",
    parameters: "HingeParameters",
    bed: Bed,
    incoming_left: NDArray | None = None,
    on_edge: bool = False,
    more: tuple[float, float] = (0.0, 0.0),
) -> list[Finding]:
    """List with one `Finding`: the print's size, or how many units fit and where to split it.

    ``more`` as of `print_size`.
    """
    corners, margin = outlines(thick, parameters, incoming_left)
    size = print_size(corners, margin, parameters, bed, on_edge, more)
    if fits(size, bed):
        return [_fits(size, bed)]
    runs = split(thick, parameters, bed, incoming_left, on_edge, more)
    if runs:
        most = runs[0][1] + 1
        while fits(print_size(corners[: most + 1], margin, parameters, bed, on_edge, more), bed):
            most += 1  # ends: all of them do not fit
        return [_too_large(size, bed, len(corners), runs, most)]
    alone = [
        print_size(corners[k : k + 1], margin, parameters, bed, on_edge, more)
        for k in range(len(corners))
    ]
    over = [_over(one, bed) for one in alone]
    worst = int(np.argmax(over))
    return [_unit_too_large(worst, alone[worst], bed)]


def _room(bed: Bed) -> str:
    return f"{bed.width:g} × {bed.depth:g} × {bed.height:g} mm"


def _extent(size: PrintSize) -> str:
    return f"{size.width:.0f} × {size.depth:.0f} × {size.height:.1f} mm"


def _fits(size: PrintSize, bed: Bed) -> Finding:
    turned = phrase(", turned by {angle:.0f}°", angle=np.degrees(size.turn))
    return Finding(
        severity=NOTE,
        code="bed",
        number=size.height,
        limit=bed.height,
        message=phrase(
            "The print is {extent} large and fits the bed of {room}{turned}.",
            extent=_extent(size),
            room=_room(bed),
            turned=turned if size.turn else "",
        ),
    )


def _over(size: PrintSize, bed: Bed) -> float:
    return max(size.width / bed.width, size.depth / bed.depth, size.height / bed.height)


def _unit_too_large(number: int, alone: PrintSize, bed: Bed) -> Finding:
    over = _over(alone, bed)
    return Finding(
        severity=ERROR,
        code="bed",
        bodies=(f"unit{number + 1:02d}",),
        number=over,
        limit=1.0,
        message=phrase(
            "Not even one unit, {extent} large, fits the bed of {room}.",
            extent=_extent(alone),
            room=_room(bed),
        ),
        cure=phrase(
            "make {EdgeLength} at least {over:.2f} times shorter", over=ceil(100 * over) / 100
        ),
    )


def _too_large(
    size: PrintSize, bed: Bed, count: int, runs: Sequence[Sequence[int]], most: int
) -> Finding:
    return Finding(
        severity=ERROR,
        code="bed",
        number=size.height,
        limit=bed.height,
        message=phrase(
            "The print of {count} units is {extent} large, too large for the bed of {room}: "
            "{most} units fit.",
            count=count,
            extent=_extent(size),
            room=_room(bed),
            most=most,
        ),
        cure=phrase(
            "split the tube at contact blocks into {count} prints of units {prints}",
            count=len(runs),
            prints=", ".join(f"{a + 1}–{b + 1}" for a, b in runs),
        ),
    )
