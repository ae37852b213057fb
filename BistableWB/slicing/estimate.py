# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a print takes, without a slicer: an estimate from the layers of its meshes.

Every layer is two walls along its outlines, the rest is filled; each kind of line at the speed of
`profile`. What starting, stopping and moving take is one share, fitted to PrusaSlicer on the
examples (benchmarks/modes.py).
"""

from collections.abc import Sequence
from math import pi
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ..checks.layers import PIXEL, layers
from .profile import line_width, speeds

if TYPE_CHECKING:
    from ..checks.printer import Printer
    from ..origami.meshes import Mesh

_REST = 1.5  # of the lines' own time: corners, travel, seams
_LAYER = 2.0  # s for every layer


class Guess(NamedTuple):
    """``seconds``, and ``volume`` of plastic, mm³."""

    seconds: float
    volume: float


def guess(meshes: "Sequence[Mesh]", printer: "Printer", speed: str = "quality") -> Guess:
    """`Guess` of a print of ``meshes`` as they stand, ``speed`` as of `profile.SPEEDS`."""
    height, width, kept = printer.layer_height, line_width(printer), speeds(speed)
    seconds, volume, count = 0.0, 0.0, 0
    for mesh in meshes:
        made = layers(mesh, height)
        if not made.inside.size:
            continue
        area, outline = _measured(made.inside)
        filled = np.maximum(area - 2 * width * outline, 0) / width
        lines = outline / kept["external_perimeter_speed"] + outline / kept["perimeter_speed"]
        lines += filled / kept["solid_infill_speed"]
        if made.first[0] == 0:
            lines[0] = (2 * outline[0] + filled[0]) / kept["first_layer_speed"]
        seconds += float(lines.sum())
        volume += float(area.sum()) * height
        count = max(count, int(made.end[0]))
    return Guess(_REST * seconds + _LAYER * count, volume)


def _measured(inside):
    """Area (mm²) and length of the outlines (mm) of every layer (layers,)."""
    padded = np.pad(inside, ((0, 0), (1, 1), (1, 1)))
    edges = (padded[:, 1:] != padded[:, :-1]).sum((1, 2))
    edges += (padded[:, :, 1:] != padded[:, :, :-1]).sum((1, 2))
    return inside.sum((1, 2)) * PIXEL**2, edges * PIXEL * pi / 4
