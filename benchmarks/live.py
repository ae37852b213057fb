# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edits of hinged units in FreeCAD's window: how long, and the longest stall of its event loop.

.ci/in-freecad --gui bookworm --script benchmarks/live.py [--json FILE] [UNITS…]

A stall is the longest time between two ticks of a timer of 10 ms in the window's own loop. Edits
are made as a user makes them: nobody waits for the solids. *solids*: until they are there and
drawn; *all*: until their margins are there too; *CPU*: seconds of processor for all of it, which
other work on the machine changes least. *slider*: pictures a second of the thick tube, all drawn.
"""

import json
import sys
import tempfile
import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore

from BistableWB import make
from BistableWB.objects import later
from BistableWB.origami import memory

REACH = 32.0  # mm of curve a unit
PICTURES = 48  # of one run of the slider
_QUIET = 5  # looks in a row at which nothing is left to do


class Stalls:
    """The longest time between two ticks."""

    def __init__(self):
        self.longest, self.last = 0.0, time.monotonic()
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self.tick)
        self.timer.start(10)

    def tick(self):
        now = time.monotonic()
        self.longest, self.last = max(self.longest, now - self.last), now

    def read(self):
        """The longest since the last reading, seconds."""
        found, self.longest, self.last = self.longest, 0.0, time.monotonic()
        return found


def settle(obj, first=None):
    """Let the window's loop run until nothing is left; seconds to the solids and to the end.

    ``first``: work that the loop is to start with, as it starts what a user does.
    """
    loop, look = QtCore.QEventLoop(), QtCore.QTimer()
    start, seen, quiet = time.monotonic(), [], [0]

    def looked():
        there = obj.UpToDate and not obj.ViewObject.Proxy.is_drawing()
        if there and not seen:
            seen.append(time.monotonic() - start)
        quiet[0] = quiet[0] + 1 if there and not later.runner.is_busy() else 0
        if quiet[0] == _QUIET:
            loop.quit()

    def begin():
        if first is not None:
            first()
        look.start(20)

    look.timeout.connect(looked)
    QtCore.QTimer.singleShot(0, begin)
    (loop.exec_ if hasattr(loop, "exec_") else loop.exec)()
    return seen[0], time.monotonic() - start - 0.02 * _QUIET


def edited(obj, name, value, hinges, stalls):
    """One row: seconds until the solids and everything are there, CPU, the longest stall."""

    def edit():
        setattr(obj, name, value)
        obj.Document.recompute()

    memory.forget()
    settle(hinges)
    stalls.read()
    cpu = time.process_time()
    solids, everything = settle(hinges, edit)
    return {"solids": solids, "seconds": everything, "cpu": time.process_time() - cpu,
            "stall": stalls.read()}  # fmt: skip


def slider(hinges):
    """Pictures a second while the slider of the thick tube runs from flat to deployed."""
    from BistableWB.scene.motion import motion_of

    motion = motion_of(hinges)
    view = Gui.ActiveDocument.ActiveView
    hinges.ViewObject.hide()
    view.getSceneGraph().addChild(motion.root)
    Gui.SendMsgToActiveView("ViewFit")
    for _ in range(5):
        Gui.updateGui()
    start, cpu = time.monotonic(), time.process_time()
    for k in range(PICTURES):
        motion.show(k / (PICTURES - 1))
        view.redraw() if hasattr(view, "redraw") else Gui.updateGui()
        Gui.updateGui()
    took = time.monotonic() - start
    moving = time.monotonic()
    for k in range(PICTURES):
        motion.show(k / (PICTURES - 1))
    ours = (time.monotonic() - moving) / took
    view.getSceneGraph().removeChild(motion.root)
    hinges.ViewObject.show()
    return {"seconds": took / PICTURES, "per second": PICTURES / took, "share of ours": ours,
            "cpu": (time.process_time() - cpu) / PICTURES / 2}  # fmt: skip


def reopened(doc):
    """Seconds to open the file again, and how many solids that made."""
    from BistableWB.solids import shapes

    path = str(Path(tempfile.mkdtemp()) / "bench.FCStd")
    doc.saveAs(path)
    made, read = [0], shapes._read

    def counted(boundary):
        made[0] += 1
        return read(boundary)

    shapes._read = counted
    start = time.monotonic()
    again = App.openDocument(path)
    took = time.monotonic() - start
    again.recompute()
    shapes._read = read
    App.closeDocument(again.Name)
    return {"seconds": took, "solids made": made[0]}


def bench(count):
    """Rows {name: row} of a tube of about so many units."""
    doc = App.newDocument("Bench")
    width = REACH * count / 1.2
    points = [(0, 0), (width / 3, width / 4), (2 * width / 3, width / 5), (width, 0)]
    curve = make.make_curve(doc, points=[(*point, 0) for point in points])
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    units = make.make_bistable_unit(doc, triangles)
    hinges = make.make_hinge_set(doc, units)
    make.make_solids(hinges)
    doc.recompute()
    Gui.SendMsgToActiveView("ViewFit")
    settle(hinges)
    stalls, rows = Stalls(), {}
    name = f"{triangles.Count} units"
    for obj, prop, value in (
        (triangles, "EdgeLength", 61.0),
        (triangles, "Gamma", 21.0),
        (hinges, "GapLength", 0.45),
        (hinges, "Deployment", 0.5),
    ):
        rows[f"{name}, {prop}"] = edited(obj, prop, value, hinges, stalls)
    stalls.timer.stop()
    rows[f"{name}, slider"] = slider(hinges)
    rows[f"{name}, open again"] = reopened(doc)
    return rows


def main(arguments):
    """Print the table, and write it as JSON where asked for."""
    path = None
    if arguments[:1] == ["--json"]:
        path, arguments = Path(arguments[1]), arguments[2:]
    later._python_waits = lambda: False
    Gui.activateWorkbench("BistableWorkbench")
    rows = {}
    for count in [int(text) for text in arguments] or [4, 13, 24]:
        found = bench(count)
        for name, row in found.items():
            numbers = ", ".join(f"{what} {value:.3g}" for what, value in row.items())
            print(f"{name}: {numbers}", flush=True)
        rows |= found
    if path is not None:
        path.write_text(json.dumps(rows), encoding="utf-8")


main(sys.argv[1:])
