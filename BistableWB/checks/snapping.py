# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the units of a print snap, as a finding that names the floppy ones."""

import numpy as np

from ..origami.target_snap import named
from .findings import NOTE, WARNING, Finding


def check_snap(snap):
    """List with one `Finding` on a `origami.snap.Snap`: all units snap, or which are floppy."""
    margin = np.atleast_1d(snap.margin)
    two_states = np.atleast_1d(snap.bistable)
    loose = (margin < 1) | ~two_states
    least, count = float(margin.min()), len(margin)
    if not loose.any():
        each = "The unit snaps" if count == 1 else f"All {count} units snap"
        text = f"{each}: margin {least:.2f} or more."
        if np.isinf(least):
            text = f"{each}: its hinges have no play."
        return [Finding(NOTE, "snap", (), least, 1.0, text)]
    of = f" of {count}" if count > 1 else ""
    are = "are" if loose.sum() > 1 else "is"
    if two_states.all():
        trouble = f"margin {least:.2f} at the least"
        cure = "make EdgeLength larger, Ratio nearer to sin(theta/2), or GapLength smaller"
    else:
        trouble = "without a second stable state"
        cure = "switch Compensate on"
    message = (
        f"{named(loose)}{of} {are} floppy, {trouble}, and nothing but friction holds the deployed "
        "state."
    )
    place = tuple(f"unit{k + 1:02d}" for k in np.flatnonzero(loose))
    return [Finding(WARNING, "snap", place, least, 1.0, message, cure)]
