# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all pictures share: matplotlib, the page, the style, the scale bar."""

import math
from contextlib import contextmanager

import numpy as np

from .. import colours
from ..files import whole_file
from ..origami.errors import Refusal

DPI = 200
_STYLE = {
    "font.family": "DejaVu Sans",
    "mathtext.fontset": "dejavusans",
    "font.size": 9,
    "text.color": colours.INK,
    "axes.edgecolor": colours.MUTED,
    "axes.labelcolor": colours.INK,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": colours.FAINT,
    "grid.linewidth": 0.6,
    "xtick.color": colours.MUTED,
    "ytick.color": colours.MUTED,
    "xtick.labelcolor": colours.INK,
    "ytick.labelcolor": colours.INK,
    "svg.fonttype": "path",
}


class NoMatplotlib(Refusal):
    """matplotlib is not installed."""


def require():
    """Return the matplotlib package, or raise `NoMatplotlib`."""
    try:
        import matplotlib
    except ImportError:
        raise NoMatplotlib(
            "Pictures need matplotlib, which is not installed",
            cure="install it (Debian: apt install python3-matplotlib)",
        ) from None
    return matplotlib


@contextmanager
def figure(path, width, height):
    """A new figure of ``width`` × ``height`` inches, saved to ``path`` at the end."""
    matplotlib = require()
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with matplotlib.rc_context(_STYLE):
        sheet = Figure(figsize=(width, height), dpi=DPI, facecolor="white")
        FigureCanvasAgg(sheet)
        yield sheet
        metadata = {"Software": None} if path.suffix == ".png" else None
        with whole_file(path) as unfinished:
            sheet.savefig(unfinished, dpi=DPI, metadata=metadata)


def page(extent, widest=8.0, tallest=7.0, least=(3.6, 2.6)):
    """Width and height in inches (2,) of a page for an ``extent`` (2,) in mm."""
    scale = min(widest / extent[0], tallest / extent[1])
    return np.maximum(scale * np.asarray(extent), least)


def blank_axes(sheet, low, high):
    """Axes in mm that fill the page from corner ``low`` to ``high``, without a frame."""
    axes = sheet.add_axes((0, 0, 1, 1))
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    axes.axis("off")
    return axes


def scale_bar(axes, corner, length):
    """A bar ``length`` mm long with its left end at ``corner``."""
    x, y = corner
    axes.plot([x, x + length], [y, y], color=colours.INK, lw=2.2, solid_capstyle="butt", zorder=6)
    axes.annotate(
        f"{length:g} mm", (x + length / 2, y), xytext=(0, 4), textcoords="offset points",
        ha="center", va="bottom", fontsize=8, zorder=6, path_effects=halo(),
    )  # fmt: skip


def halo():
    """White around a text that stands on a drawing."""
    from matplotlib.patheffects import withStroke

    return [withStroke(linewidth=2.5, foreground="white")]


def round_length(wanted):
    """Largest of 1, 2, 5 · 10ⁿ that is not above ``wanted``."""
    power = 10.0 ** math.floor(math.log10(wanted))
    return max(step * power for step in (1, 2, 5) if step * power <= wanted * (1 + 1e-9))
