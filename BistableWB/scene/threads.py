# SPDX-License-Identifier: LGPL-2.1-or-later
"""Threads beside the window, with Python's collector of cycles off as long as one runs.

The collector frees what it finds in the thread that it happens to run in. Things of the window
(Qt's, Coin's, FreeCAD's) may be freed by the window's own thread only: elsewhere FreeCAD ends with
a segmentation fault.
"""

import gc
import sys
import threading

from PySide import QtCore

_LOOK = 200  # ms between two looks whether all have ended
_TURN = 0.001  # s after which a thread lets the window go on; Python's own 5 ms are felt


class _Collector:
    def __init__(self):
        self._threads = set()
        self._timer = None
        self._turn = sys.getswitchinterval()

    def hold(self, thread):
        """No collection until ``thread`` has ended; called in the window's thread."""
        if self._timer is None:
            self._timer = QtCore.QTimer()
            self._timer.timeout.connect(self._look)
        self._threads.add(thread)
        gc.disable()
        sys.setswitchinterval(_TURN)
        self._timer.start(_LOOK)

    def _look(self):
        self._threads = {thread for thread in self._threads if thread.is_alive()}
        if not self._threads:
            self._timer.stop()
            gc.enable()
            sys.setswitchinterval(self._turn)


_collector = _Collector()


def start(work, *args):
    """Start ``work(*args)`` in a thread, which must touch no document and nothing of Qt or Coin.

    Called in the window's thread; returns the thread, which ends with the program.
    """
    thread = threading.Thread(target=work, args=args, daemon=True)
    _collector.hold(thread)
    thread.start()
    return thread
