# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the units of a print snap, as a finding that names the floppy ones."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ..origami.errors import NOTE, WARNING, Finding, phrase
from ..origami.snap.targets import named

if TYPE_CHECKING:
    from ..origami.snap.margin import Snap


_STRIPS = phrase(
    "The hinges are strips without play, so no snap margin tells whether units stay open: strips "
    "of usual walls take more to bend than panels resist, and fold the print back."
)
_MEASURE = phrase(
    "measure how hard it snaps (Tube charts); thinner strips ({NozzleDiameter}) bend more easily"
)


def check_snap(snap: "Snap | Any") -> list[Finding]:
    """List with one `Finding` on a `margin.Snap`: all units snap, or which are floppy.

    Of hinges without play no margin tells, and none is given.
    """
    margin = np.atleast_1d(snap.margin)
    two_states = np.atleast_1d(snap.bistable)
    loose = (margin < 1) | ~two_states
    least, count = float(margin.min()), len(margin)
    if not loose.any():
        each = phrase("The unit snaps" if count == 1 else "All {count} units snap", count=count)
        text = phrase("{each}: margin {least:.2f} or more.", each=each, least=least)
        if np.isinf(least):
            return [Finding(severity=NOTE, code="snap", message=_STRIPS, cure=_MEASURE)]
        return [
            Finding(
                severity=NOTE,
                code="snap",
                number=least,
                limit=1.0,
                message=text,
            )
        ]
    if two_states.all():
        trouble = phrase("margin {least:.2f} at the least", least=least)
        cure = phrase(
            "make {EdgeLength} larger, {Ratio} nearer to sin(theta/2), or {GapLength} smaller"
        )
    else:
        trouble = phrase("without a second stable state")
        cure = phrase("switch {Compensate} on").setting(Compensate=True)
    message = phrase(
        "{units}{of} {are} floppy, {trouble}, and nothing but friction holds the deployed state.",
        units=named(loose),
        of=phrase(" of {count}", count=count) if count > 1 else "",
        are=phrase("are" if loose.sum() > 1 else "is"),
        trouble=trouble,
    )
    place = tuple(f"unit{k + 1:02d}" for k in np.flatnonzero(loose))
    return [
        Finding(
            severity=WARNING,
            code="snap",
            bodies=place,
            number=least,
            limit=1.0,
            message=message,
            cure=cure,
        )
    ]
