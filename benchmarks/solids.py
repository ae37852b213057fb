# SPDX-License-Identifier: LGPL-2.1-or-later
r"""How long solids take: one panel of each kind, and a tube of 24 different units.

    freecadcmd -c "import sys; sys.path[:0] = ['.']; import runpy; \\
        runpy.run_path('benchmarks/solids.py', run_name='__main__')"

Times are those of the processor (one core), so that other work on the machine does not count.
"""

import time

import numpy as np

from BistableWB.origami.hinge_parameters import HingeParameters
from BistableWB.origami.hinge_volume import link_volume, plate_volume
from BistableWB.origami.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit
from BistableWB.solids.links import link_solid
from BistableWB.solids.plates import plate_solid
from BistableWB.solids.tube import tube_bodies, tube_layouts

PANEL_LIMIT, TUBE_LIMIT, UNITS = 0.08, 25.0, 24


def timed(work, repeats=5):
    """Shortest of some runs, seconds of processor time."""
    times = []
    for _ in range(repeats):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return min(times)


def main():
    parameters = HingeParameters()
    unit = plane_unit(np.radians(np.linspace(40, 48, UNITS)), 0.42, 60.0, 24.0)
    units = ThickUnit(unit, parameters.face_thickness, parameters.gap_between_planes).compensated()
    layout_time = timed(lambda: tube_layouts(units, parameters), 3)
    print(f"layout of {UNITS} units: {layout_time:.3f} s")
    layout = tube_layouts(units, parameters)[0]
    for name in ("contact_left", "border_left", "primary_left_upper", "secondary_left_upper"):
        plate = layout.plates[name]
        volume = plate_volume(plate, parameters)
        seconds = timed(lambda p=plate, v=volume: plate_solid(p, parameters, v))
        print(f"{name}: {seconds:.3f} s (limit {PANEL_LIMIT} s)")
    link = layout.links["link_B"]
    volume = link_volume(link, parameters)
    print(f"link_B: {timed(lambda: link_solid(link, parameters, volume)):.3f} s")
    start = time.process_time()
    bodies = tube_bodies(units, parameters)
    total = time.process_time() - start
    print(f"{UNITS} units, {len(bodies)} bodies: {total:.1f} s (limit {TUBE_LIMIT} s)")


if __name__ == "__main__":
    main()
