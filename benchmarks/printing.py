"""From a curve to the STL of a hinged tube, and its checks: seconds (CPU and wall) and memory.

    .ci/in-freecad host --script benchmarks/printing.py [UNITS]

The units' angles all differ, so that no body is a copy of another unit's: the slowest case.
"""

import resource
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from BistableWB.checks.printer import Printer
from BistableWB.checks.printing import Print
from BistableWB.checks.suite import Suite
from BistableWB.exporters import stl, threemf
from BistableWB.exporters.bodies import Body
from BistableWB.origami import unit
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.thick import print_stack
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.solids.tessellation import placed_meshes
from BistableWB.solids.tube import tube_bodies

OPENINGS = np.linspace(0.05, 1.0, 20)


def timed(what, work):
    cpu, wall = time.process_time(), time.time()
    result = work()
    used, passed = time.process_time() - cpu, time.time() - wall
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{what:34} {used:7.2f} s CPU {passed:7.2f} s  peak {peak:5.0f} MB", flush=True)
    return result


def _files(bodies, count, start):
    exported = [Body(body.name, body.shape, (), None) for body in bodies]
    with tempfile.TemporaryDirectory() as folder:
        for suffix, write in ((".stl", stl.write), (".3mf", threemf.write)):
            path = Path(folder) / f"print{suffix}"
            timed(f"meshes and {suffix}", lambda w=write, p=path: w(exported, p))
            print(f"{'':34} {path.stat().st_size / 1e6:7.1f} MB")
            if suffix == ".stl":
                print(f"{count} units, {len(bodies)} bodies to STL: {time.time() - start:.1f} s")


def main(count):
    parameters = HingeParameters()
    thetas = np.radians(np.linspace(40, 50, count))
    units = unit.plane_unit(thetas, 0.05 + thetas / np.radians(45) * 0.37, 60.0, 24.0)
    thick = ThickUnit(units, parameters.face_thickness, parameters.gap_between_planes)
    start = time.time()
    thick = timed("compensation", thick.compensated)
    bodies = timed("solids", lambda: tube_bodies(thick, parameters))
    _files(bodies, count, start)
    meshes = timed("meshes", lambda: placed_meshes(bodies))
    print(f"{'triangles':34} {sum(len(m.mesh.triangles) for m in meshes):7d}")
    volumes = [body.shape.Volume for body in bodies]
    whole = timed("trees", lambda: Print(meshes, parameters))
    found = timed("sound", lambda: whole.check_soundness(volumes))
    found += timed("flat", whole.check_flat)
    for opening in (0.8, 1.0):
        motions, misfits = print_stack.motions(thick, opening), thick.misfit(opening)
        found += timed(
            f"opened to {opening:.0%}",
            lambda o=opening, m=motions, g=misfits: whole.check_poses(m, o, g),
        )
    suite = Suite(meshes, volumes, parameters, Printer())
    found += timed("layers and overhangs", suite.check_layers)
    found += timed("walls and cones", suite.check_walls)
    for finding in found[:20]:
        print(f"  {finding.severity}: {finding}")
    one = ThickUnit(units[:1], parameters.face_thickness, parameters.gap_between_planes)
    one = one.compensated()
    single = Print(placed_meshes(tube_bodies(one, parameters)), parameters)

    def unfold():
        for opening in OPENINGS:
            single.check_poses(print_stack.motions(one, opening), opening)

    timed(f"one unit at {len(OPENINGS)} openings", unfold)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 24)
