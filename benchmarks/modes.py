# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways to print a tube: the table of docs/slicing.md, and the estimate against the slicer.

    .ci/in-freecad host --script benchmarks/modes.py [UNITS …]

A unit by itself (θ 55°, ‖AB‖ 80), then the first UNITS units of hinged-arch.toml (3; 0: all).
"""

import math
import sys
import time
from pathlib import Path

import FreeCAD as App

from BistableWB import make, slicing
from BistableWB.checks.printer import printer_of
from BistableWB.designs import building, reading
from BistableWB.slicing import ways
from BistableWB.slicing.estimate import guess
from BistableWB.solids.tessellation import placed_meshes

ARCH = Path(__file__).parents[1] / "resources/examples/hinged-arch.toml"


def unit(doc):
    """The unit that the numbers of issues and pages are of."""
    low = math.sin(math.radians(55) / 2)
    made = make.make_bistable_unit(doc, theta=55, ratio=low + 0.0953 * (1 - low), edge_length=80)
    return make.make_hinge_set(doc, made)


def arch(doc, units):
    """The first units of the arch of the examples."""
    hinges = building.build(doc, reading.read(ARCH))["hinges"]
    hinges.LastUnit = units
    return hinges


def show(what, hinges):
    """One table."""
    hinges.Document.recompute()
    start = time.time()
    for speed in ("quality", "fast"):
        told = ways.section(slicing.modes(hinges, speed=speed), speed)
        print(f"\n{what}: {told.text}\n| {' | '.join(map(str, told.columns))} |\n|{'---|' * 6}")
        print(*(f"| {' | '.join(map(str, row))} |" for row in told.rows), sep="\n", flush=True)
    meshes = [body.placed for body in placed_meshes(hinges.Proxy.model(hinges).bodies)]
    found = guess(meshes, printer_of(hinges))
    print(f"estimate {found.seconds / 3600:.2f} h   ({time.time() - start:.0f} s)", flush=True)


doc = App.newDocument("Modes", hidden=True)
show("unit", unit(doc))
for count in map(int, sys.argv[1:] or ["3"]):
    show(f"arch, {count} units", arch(doc, count))
