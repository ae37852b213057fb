# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kinds of hinges: one table, pure data (docs/theory/hinges.md 2).

To add one, add a line; `unit_layout` and `bodies` lay out and draw it by what the entry says.
Objects, panels, design files and docs/hinges.md read the table.
"""

from typing import NamedTuple


class HingeKind(NamedTuple):
    """``what`` it is; ``knuckles``: whether it turns on knuckles, which have play.

    Without them a flexure bends on the axis: no play, and no single pose holds for it.
    """

    what: str
    knuckles: bool


ROTATIONAL, FLEXIBLE = "Rotational", "Flexible"
HINGE_KINDS = {
    ROTATIONAL: HingeKind("print-in-place knuckles", knuckles=True),
    FLEXIBLE: HingeKind("a strip of soft material (TPU) along every crease", knuckles=False),
}
KINDS_TIP = ". ".join(f"{name}: {kind.what}" for name, kind in HINGE_KINDS.items())  # of panels
