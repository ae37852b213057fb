# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening angle and ratio of every unit along the curve."""

import numpy as np

from .. import colours
from .page import figure

_LEGEND = {"framealpha": 1, "edgecolor": "none", "fontsize": 8.5, "borderaxespad": 0.1}


def angle_chart(path, thetas, ratios, sides=None):
    """θ_k above, ratio c_k with its limit sin(θ_k/2) below, by the number of the unit.

    ``thetas`` radians (n,), ``ratios`` (n,), ``sides`` (n,) +1 / −1 as in `placement.Placement`.
    """
    thetas = np.atleast_1d(thetas)
    ratios = np.broadcast_to(ratios, thetas.shape)
    number = np.arange(1, len(thetas) + 1)
    with figure(path, 8.0, 5.0) as sheet:
        above, below = sheet.subplots(2, 1, sharex=True, height_ratios=(1.25, 1))
        sheet.subplots_adjust(0.085, 0.095, 0.985, 0.965, hspace=0.14)
        _draw_thetas(above, number, np.degrees(thetas), sides)
        _draw_ratios(below, number, ratios, np.sin(thetas / 2))
        below.set_xlabel("unit k, along the curve")
        below.set_xlim(0.4, len(thetas) + 0.6)
        below.xaxis.get_major_locator().set_params(integer=True, min_n_ticks=1)
        sheet.align_ylabels()
    return path


def _draw_thetas(axes, number, degrees, sides):
    axes.plot(number, degrees, color=colours.FAINT, lw=1.2, zorder=2)
    size = 7 if len(number) <= 40 else 4
    sides = np.zeros(len(number)) if sides is None else np.asarray(sides)
    for side, marker, fill, name in (
        (1, "^", colours.PANELS["primary"], "joint B left of the curve"),
        (-1, "v", colours.PANELS["contact"], "joint B right of the curve"),
        (0, "o", colours.PANELS["contact"], None),
    ):
        chosen = sides == side
        if chosen.any():
            axes.plot(
                number[chosen], degrees[chosen], ls="", marker=marker, ms=size, mfc=fill,
                mec=colours.INK, mew=0.7, label=name, zorder=3,
            )  # fmt: skip
    low, high = degrees.min(), degrees.max()
    room = max(0.12 * (high - low), 2.0)
    axes.set_ylim(low - room, high + room * 2.4)
    axes.yaxis.set_major_formatter("{x:g}°")
    axes.set_ylabel(r"opening angle $\theta_k$")
    if (sides != 0).any():
        axes.legend(loc="upper right", ncols=2, **_LEGEND)


def _draw_ratios(axes, number, ratios, limits):
    edges = np.repeat(np.concatenate([number - 0.5, number[-1:] + 0.5]), 2)[1:-1]
    steps = np.repeat(limits, 2)
    axes.fill_between(edges, steps, 0, color=colours.REFUSED, lw=0, zorder=1)
    axes.plot(edges, steps, color=colours.CURVE, lw=1.2, zorder=2,
              label=r"limit sin($\theta_k$/2): none below; near it, hardest snap")  # fmt: skip
    size = 5 if len(number) <= 40 else 3
    axes.plot(
        number, ratios, ls="", marker="o", ms=size, mfc=colours.INK, mec="white", mew=0.5, zorder=3,
        label=r"ratio $c_k$ = ‖A′C′‖ / ‖AB‖",
    )  # fmt: skip
    low, high = limits.min(), ratios.max()
    room = max(0.18 * (high - low), 0.02)
    axes.set_ylim(low - room, high + 3.2 * room)
    axes.set_ylabel("ratio c")
    axes.legend(loc="upper right", ncols=2, **_LEGEND)
