# SPDX-License-Identifier: LGPL-2.1-or-later
"""While work goes on beside the window, nothing of the window is freed in another thread."""

import gc
import threading
import weakref

from BistableWB.scene import threads


class Knot:
    """Freed by the collector of cycles only; notes the thread in which that happens."""

    freed_in = []

    def __init__(self):
        self.itself = self
        weakref.finalize(self, lambda: Knot.freed_in.append(threading.current_thread()))


def test_cycles_are_freed_in_the_thread_of_the_window_only(gui):
    Knot.freed_in.clear()
    stop = threading.Event()

    def work():  # makes as much rubbish as a search does
        while not stop.is_set():
            for _ in range(2000):
                Knot()

    started = threads.start(work)
    for _ in range(20):
        gui(0.02)
    assert not gc.isenabled()
    assert Knot.freed_in == []
    stop.set()
    started.join()
    gui(0.5)
    assert gc.isenabled()
    gc.collect()
    assert set(Knot.freed_in) == {threading.main_thread()}
