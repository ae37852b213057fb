# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a recompute may leave for later: solids that are made aside while the window goes on.

A recompute that FreeCAD's window started (a property, a sketch, a spreadsheet cell, undo) must not
freeze it. Python that calls one goes on with what it finds, so for Python it is made before the
call ends, and so it is where there is no window.
"""

import contextlib
import sys

LIVE, ON_DEMAND = "Live", "OnDemand"

# What makes models aside, set where there is a window: `scene.aside.Runner`.
runner = None
_leaving = 0


def nobody_waits():
    """Whether what goes on now may be finished later: the window started it, or `leaving`."""
    return runner is not None and (_leaving > 0 or not _python_waits())


@contextlib.contextmanager
def leaving():
    """Within it recomputes leave solids for later, although Python started them: our panels."""
    global _leaving
    _leaving += 1
    try:
        yield
    finally:
        _leaving -= 1


def _python_waits():
    """Whether Python called what FreeCAD calls back now: frames below the proxy's ``execute``."""
    frame = sys._getframe(1)
    while frame is not None and frame.f_code.co_name != "execute":
        frame = frame.f_back
    return frame is None or frame.f_back is not None
