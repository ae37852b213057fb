# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hinges that are bought, for tubes of cut panels: one table, pure data (docs/cut-panels.md).

Panels lie in the layers of theory/hinges.md 1, and every axis runs in the middle of the gap between
two layers. A hinge on the panels' faces therefore sets that gap: twice the height of its pin over
the face. None of them has play.
"""

from typing import NamedTuple


class PanelHinge(NamedTuple):
    """``what`` it is; ``gap`` (mm) between layers: twice its axis' height over the face.

    ``leaf`` (mm): how far it reaches onto a panel; ``screw_pitch`` (mm; 0: none), ``screw_inset``
    (mm from the axis), ``hole`` (mm, diameter to drill); ``has_slats``: double hinges are a slat
    between two of them; else a strip of the hinge's own stuff does.
    """

    what: str
    gap: float
    leaf: float
    screw_pitch: float = 0.0
    screw_inset: float = 0.0
    hole: float = 0.0
    has_slats: bool = True


PANEL_HINGES = {
    "Piano": PanelHinge(
        "piano hinge, 32 mm wide open, knuckle 5 mm: leaves on the faces, screws every 80 mm",
        gap=5.0, leaf=16.0, screw_pitch=80.0, screw_inset=10.0, hole=2.0,
    ),
    "Textile": PanelHinge(
        "strip of cloth or belt, 1 mm thick, glued 40 mm onto both faces", gap=1.0, leaf=40.0,
        has_slats=False,
    ),
    "Tape": PanelHinge("fabric tape, 0.3 mm thick, 25 mm onto both faces", gap=0.3, leaf=25.0),
}  # fmt: skip
