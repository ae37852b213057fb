# SPDX-License-Identifier: LGPL-2.1-or-later
"""What begins in mid-air in stacks, without and with loose pillars: the table of docs/slicing.md.

.ci/in-freecad host --script benchmarks/pillars.py [arch] [s] [climbing]
"""

import sys
import time
from math import radians

import numpy as np

from BistableWB.checks.layering import Layering
from BistableWB.checks.printer import Printer
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.rules import PlacementRule
from BistableWB.origami.design import CurveGeometry, Placing, Thickness, TubeDesign
from BistableWB.origami.hinges.bodies import tube_drawn
from BistableWB.origami.hinges.meshing import mesh_of
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.pillars import BED
from BistableWB.origami.hinges.processes import STANDOFFS
from BistableWB.origami.hinges.propping import propped_print
from BistableWB.origami.hinges.standoff_inputs import StandOffs
from BistableWB.origami.meshes import PlacedMesh

HINGES = HingeParameters(segment_width=5.0, process=STANDOFFS, standoffs=StandOffs())
UP = ("parallel", (0.0, 0.0, 1.0))
TUBES = {  # name: (control points, kind and ruling, ‖AB‖)
    "arch": ([(0, 0, 0), (0, 240, 0), (600, 240, 0), (600, 0, 0)], ("Plane",), 60.0),
    "s": ([(0, 0, 0), (300, 400, 0), (500, -400, 0), (800, 0, 0)], ("Plane",), 64.0),
    "climbing": ([(0, 0, 0), (200, 320, 40), (500, 320, 60), (660, 40, 90)], ("General", UP), 72.0),
}


def drawn(name):
    """Bodies of a tube by its name."""
    points, family, edge = TUBES[name]
    panels = Thickness(HINGES.face_thickness, HINGES.gap_between_planes)
    curve = CurveGeometry(Bezier(points), *family)
    where = Placing(curve, edge, radians(30), panels.pitch, rule=PlacementRule("EndFit"))
    tube = TubeDesign(where, thickness=panels).thick()
    return tube_drawn(tube.thick, HINGES, tube.tube.incoming_left)


def judged(bodies):
    """(places, mm², wide hangs) by the check that looks at the meshes."""
    layering = Layering(bodies, Printer(), None, "stand-offs", alone=True)
    layering.findings()
    areas = [area for *_, area in layering._islands]
    return len(areas), sum(areas), sum(hang.wide for hang, *_ in layering._hangs)


for name in sys.argv[1:] or TUBES:
    made = drawn(name)
    plastic = sum(body.boundary.volume for body in made)
    start = time.process_time()
    pillars = propped_print(made, HINGES).pillars
    seconds = time.process_time() - start
    bodies = [
        PlacedMesh(b.name, mesh_of(b.boundary).mesh, b.place, b.unit, b.members, b.kind)
        for b in made
    ]
    feet = [
        PlacedMesh(f"pillar{k}", mesh_of(p.boundary()).mesh, np.eye(4), made[p.holds].unit, (),
                   "foot")
        for k, p in enumerate(pillars)
    ]  # fmt: skip
    units = 1 + max(body.unit for body in made)
    without, held = judged(bodies), judged(bodies + feet)
    volume = sum(pillar.boundary().volume for pillar in pillars)
    print(f"{name}, {units} units: (places, mm², wide) {without} → {held}; {len(pillars)} pillars,")
    print(f"  {sum(p.on == BED for p in pillars)} on the bed, {volume / 1000:.2f} of "
          f"{plastic / 1000:.0f} cm³; found in {seconds:.1f} s of CPU", flush=True)  # fmt: skip
