# SPDX-License-Identifier: LGPL-2.1-or-later
"""How strongly units snap: energy on the way, snap margin of every unit, designs of a search."""

from math import degrees

import numpy as np

from .. import colours
from .page import figure, halo

_LEGEND = {"framealpha": 1, "edgecolor": "none", "fontsize": 8.5, "borderaxespad": 0.1}
_LINES = 8  # more units than this become a band
_BARS = 40  # more units than this get no numbers on their bars


def energy_chart(path, fractions, energies):
    """Energy of every unit against its opening; the weakest and the strongest unit are named.

    ``fractions`` (m,) of the opening θ, ``energies`` (n, m) in EA·‖AB‖, both as `snap.energy_path`
    returns them. A line for each unit, or a band for more than eight.
    """
    energies = np.atleast_2d(energies)
    peaks = energies.max(1)
    weakest, strongest = int(peaks.argmin()), int(peaks.argmax())
    power = int(np.floor(np.log10(max(peaks.max(), 1e-300))))
    scaled = energies / 10.0**power
    with figure(path, 8.0, 4.4) as sheet:
        axes = sheet.add_axes((0.085, 0.125, 0.875, 0.845))
        if len(energies) > _LINES:
            axes.fill_between(
                100 * fractions, scaled.min(0), scaled.max(0), color=colours.PANELS["border"],
                alpha=0.45, lw=0, label=f"all {len(energies)} units",
            )  # fmt: skip
        else:
            axes.plot(100 * fractions, scaled.T, color=colours.MUTED, lw=1.0)
        if len(energies) > 1:
            _energy_line(axes, fractions, scaled[strongest], f"strongest: unit {strongest + 1}",
                         power, colours.PANELS["contact"], "--")  # fmt: skip
        name = f"weakest: unit {weakest + 1}" if len(energies) > 1 else "unit"
        _energy_line(axes, fractions, scaled[weakest], name, power, colours.CURVE, "-")
        axes.set_xlim(0, 100 * fractions[-1])
        axes.set_ylim(0, 1.2 * scaled.max())
        axes.xaxis.set_major_formatter("{x:g} %")
        axes.set_xlabel(r"opening, of $\theta_k$ (0: flat-folded, 100 %: deployed)")
        axes.set_ylabel(rf"energy / ($10^{{{power}}}$ EA·‖AB‖)")
        axes.legend(loc="upper left", **_LEGEND)
    return path


def _energy_line(axes, fractions, values, name, power, colour, style):
    top = int(values.argmax())
    peak = rf"${values[top]:.1f}\cdot10^{{{power}}}$"
    axes.plot(100 * fractions, values, color=colour, lw=1.8, ls=style, label=name, zorder=3)
    axes.annotate(
        f"{name}, barrier {peak}", (100 * fractions[top], values[top]), xytext=(0, 5),
        textcoords="offset points", ha="center", fontsize=8.5, path_effects=halo(), zorder=4,
    )  # fmt: skip


def margin_chart(path, margins, target=None, reference=None):
    """Snap margin of every unit as bars, floppy ones (below 1) hatched and named.

    ``margins`` (n,): needed clearance / clearance of the hinges; infinite ones are without play.
    ``target``: a wanted margin to draw; ``reference``: what the bars are, for the axis.
    """
    margins = np.atleast_1d(np.asarray(margins, float))
    number = np.arange(1, len(margins) + 1)
    finite = margins[np.isfinite(margins)]
    top = 1.28 * max(2.0, target or 0.0, finite.max(initial=0.0))
    floppy, shown = margins < 1, np.where(np.isfinite(margins), margins, 0.85 * top)
    with figure(path, 8.0, 4.0) as sheet:
        axes = sheet.add_axes((0.085, 0.135, 0.9, 0.775))
        axes.axhspan(0, 1, color=colours.REFUSED, lw=0, zorder=1)
        axes.bar(number[~floppy], shown[~floppy], 0.72, color=colours.PANELS["contact"],
                 zorder=2, label="snaps")  # fmt: skip
        if floppy.any():
            axes.bar(
                number[floppy], shown[floppy], 0.72, color="white", edgecolor=colours.CURVE,
                hatch="////", lw=1.0, zorder=2, label="floppy: the hinges' play swallows the snap",
            )  # fmt: skip
        _levels(axes, len(margins), target)
        _name_bars(axes, number, margins, shown, floppy)
        room = max(0.0, 6 - len(margins)) / 2  # a single bar is no wall
        axes.set_xlim(0.4 - room, len(margins) + 0.6 + room)
        axes.set_ylim(0, top)
        axes.xaxis.get_major_locator().set_params(integer=True, min_n_ticks=1)
        if len(margins) <= 24:
            axes.set_xticks(number)
        axes.xaxis.grid(False)
        axes.set_xlabel("unit k, along the curve")
        axes.set_ylabel(reference or "snap margin (needed clearance / clearance)")
        axes.legend(loc="upper right", ncols=3, **_LEGEND)
    return path


def _levels(axes, count, target):
    axes.axhline(1, color=colours.INK, lw=1.2, zorder=3)
    if target:
        axes.axhline(target, color=colours.PANELS["primary"], lw=1.4, ls="--", zorder=3,
                     label=f"wanted: {target:g}")  # fmt: skip


def _name_bars(axes, number, margins, shown, floppy):
    """Numbers on the bars, and the weakest unit by name."""
    weakest = int(margins.argmin())
    if len(margins) <= _BARS:
        size = 8.5 if len(margins) <= 24 else 6.5
        for k, value, height in zip(number, margins, shown, strict=True):
            text = f"{value:.2f}" if np.isfinite(value) else "∞"
            axes.annotate(text, (k, height), xytext=(0, 2), textcoords="offset points",
                          ha="center", fontsize=size, zorder=4, path_effects=halo())  # fmt: skip
    if not np.isfinite(margins[weakest]):
        said = "hinges without play: a margin tells nothing, measure how hard they snap"
    elif floppy.any():
        said = f"{floppy.sum()} of {len(margins)} units floppy, weakest: unit {weakest + 1}"
    else:
        said = f"weakest: unit {weakest + 1}, margin {margins[weakest]:.2f}"
    axes.set_title(said, loc="left", fontsize=9.5, fontweight="bold")


def fit_chart(path, fit):
    """Designs of a search: how high they print and how far they stray, with their numbers.

    ``fit``: `search.Fit`. Candidates are numbered as in ``fit.candidates``; 1 is recommended.
    """
    rows = fit.candidates
    with figure(path, 8.0, 3.9 + 0.2 * len(rows)) as sheet:
        tall = sheet.get_size_inches()[1]
        axes = sheet.add_axes((0.085, 1 - 3.0 / tall, 0.9, 2.85 / tall))
        for n, c in enumerate(rows, 1):
            first = n == 1
            axes.plot(
                c.deviation, c.print_size[2], marker="D" if first else "o", ms=13, ls="",
                mfc=colours.PANELS["primary"] if first else colours.PANELS["border"],
                mec=colours.INK, mew=1.6 if first else 0.7, zorder=3,
            )  # fmt: skip
            axes.annotate(str(n), (c.deviation, c.print_size[2]), ha="center", va="center",
                          fontsize=8, fontweight="bold", zorder=4)  # fmt: skip
        axes.annotate("recommended", (rows[0].deviation, rows[0].print_size[2]), xytext=(11, 7),
                      textcoords="offset points", fontsize=9, path_effects=halo(),
                      zorder=5)  # fmt: skip
        axes.set_xlim(0, 1.12 * max(c.deviation for c in rows))
        axes.set_ylim(0, 1.15 * max(c.print_size[2] for c in rows))
        axes.set_xlabel("largest distance of the curve from the tube's blocks (mm)")
        axes.set_ylabel("height of the print (mm)")
        _fit_table(sheet, rows, tall)
    return path


def _fit_table(sheet, rows, tall):
    axes = sheet.add_axes((0.03, 0.02 / tall, 0.955, (0.2 * len(rows) + 0.24) / tall))
    axes.axis("off")
    head = ("", "‖AB‖ mm", "γ", "ratio rule", "units", "margin ≥", "print mm", "covers")
    cells = [
        (
            str(n), f"{c.edge_length:.0f}", f"{degrees(c.gamma):.0f}°",
            c.rule if c.share is None else f"{c.rule}, share {c.share:g}", str(c.count),
            f"{c.margin_min:.2f}",
            " × ".join(f"{x:.0f}" for x in c.print_size), f"{c.coverage:.0%}",
        )
        for n, c in enumerate(rows, 1)
    ]  # fmt: skip
    widths = (0.05, 0.1, 0.08, 0.24, 0.08, 0.11, 0.21, 0.1)
    table = axes.table(cells, colLabels=head, colWidths=widths, loc="center", cellLoc="center",
                       bbox=(0, 0, 1, 1))  # fmt: skip
    table.auto_set_font_size(False)
    table.set_fontsize(8.5)
    for (row, _), cell in table.get_celld().items():
        cell.set_linewidth(0.5)
        cell.set_edgecolor(colours.FAINT)
        if row == 0:
            cell.get_text().set_color(colours.MUTED)
        if row == 1:
            cell.get_text().set_fontweight("bold")
