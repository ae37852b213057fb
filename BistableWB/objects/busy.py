# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's progress bar as a `Progress`."""

import contextlib

import FreeCAD as App

from ..origami.progress import Cancelled, Progress


@contextlib.contextmanager
def progress_bar(title, steps):
    """A `Progress` that moves FreeCAD's bar at each of ``steps``; Esc there is `Cancelled`."""
    indicator = App.Base.ProgressIndicator()
    indicator.start(title, steps)

    def move(text, fraction):
        try:
            indicator.next(True)
        except RuntimeError as error:  # what FreeCAD makes of Esc
            raise Cancelled from error

    try:
        yield Progress(move)
    finally:
        indicator.stop()
