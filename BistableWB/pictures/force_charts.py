# SPDX-License-Identifier: LGPL-2.1-or-later
"""How hard units snap, and whether each holds: torque on the way, safety along the curve."""

import numpy as np

from .. import colours
from .page import figure, halo

_LEGEND = {"framealpha": 1, "edgecolor": "none", "fontsize": 8.5, "borderaxespad": 0.1}
_LISTED = 16  # units that a title names
_TOP = 5.0  # safety factors above this are drawn to here


def torque_chart(path, units):
    """Torque about the leg at B against the opening, of the weakest and of the strongest unit.

    ``units``: `snap.forces.SnapForces` of each; the title says in which order they open. Above the
    line a hand must push the unit open, below it the unit opens by itself: the unstable stretch,
    marked for the weakest.
    """
    order = sorted(range(len(units)), key=lambda k: units[k].torque)
    shown = [(order[0], "weakest", colours.CURVE)]
    if len(units) > 1:
        shown.append((order[-1], "strongest", colours.PANELS["contact"]))
    with figure(path, 8.0, 4.4) as sheet:
        axes = sheet.add_axes((0.1, 0.125, 0.86, 0.8))
        axes.axhline(0, color=colours.INK, lw=1.0)
        for k, word, colour in shown:
            unit = units[k]
            name = f"{word}: unit {k + 1}" if len(units) > 1 else "unit"
            at = 100 * unit.openings
            axes.plot(at, unit.opening_torques, color=colour, lw=1.8, marker="o", ms=3,
                      label=f"{name}, opening")  # fmt: skip
            axes.plot(at, unit.closing_torques, color=colour, lw=1.2, ls="--",
                      label=f"{name}, folding back")  # fmt: skip
        unstable = units[order[0]].unstable
        if unstable:
            low, high = (100 * value for value in unstable)
            axes.axvspan(low, high, color=colours.REFUSED, lw=0, zorder=0)
            axes.annotate(
                "opens by itself", ((low + high) / 2, 0), xytext=(0, 4), ha="center",
                textcoords="offset points", fontsize=8.5, path_effects=halo(),
            )  # fmt: skip
        if len(units) > 1:
            listed = ", ".join(str(k + 1) for k in order[:_LISTED])
            more = " …" if len(order) > _LISTED else ""
            axes.set_title(f"units open in this order: {listed}{more}", loc="left", fontsize=9.5,
                           fontweight="bold")  # fmt: skip
        axes.set_xlim(0, 100)
        axes.xaxis.set_major_formatter("{x:g} %")
        axes.set_xlabel(r"opening, of $\theta_k$ (0: flat-folded, 100 %: deployed)")
        axes.set_ylabel("torque about the leg at B, N·mm")
        axes.legend(loc="lower left", **_LEGEND)
    return path


def safety_chart(path, factors):
    """Safety of every unit against folding, as bars; those that fold (below 1) are hatched."""
    factors = np.atleast_1d(np.asarray(factors, float))
    number = np.arange(1, len(factors) + 1)
    shown, folds = np.minimum(factors, _TOP), factors < 1
    with figure(path, 8.0, 3.6) as sheet:
        axes = sheet.add_axes((0.085, 0.15, 0.9, 0.78))
        axes.axhspan(0, 1, color=colours.REFUSED, lw=0, zorder=1)
        axes.bar(number[~folds], shown[~folds], 0.72, color=colours.PANELS["contact"], zorder=2,
                 label="holds")  # fmt: skip
        if folds.any():
            axes.bar(number[folds], shown[folds], 0.72, color="white", edgecolor=colours.CURVE,
                     hatch="////", lw=1.0, zorder=2, label="folds under the weight")  # fmt: skip
        for k, value, height in zip(number, factors, shown, strict=True):
            text = f"{value:.2g}" if value <= _TOP else f"> {_TOP:g}"
            axes.annotate(text, (k, height), xytext=(0, 2), textcoords="offset points", ha="center",
                          fontsize=8 if len(number) <= 24 else 6)  # fmt: skip
        axes.axhline(1, color=colours.INK, lw=1.2, zorder=3)
        room = max(0.0, 6 - len(factors)) / 2
        axes.set_xlim(0.4 - room, len(factors) + 0.6 + room)
        axes.set_ylim(0, 1.25 * max(shown.max(), 1.2))
        axes.xaxis.get_major_locator().set_params(integer=True, min_n_ticks=1)
        axes.xaxis.grid(False)
        axes.set_xlabel("unit k, along the curve")
        axes.set_ylabel("safety against folding")
        axes.legend(loc="upper right", ncols=2, **_LEGEND)
    return path
