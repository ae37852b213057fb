# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time of compensation, poses and snap of thick units: ``python3 benchmarks/linkage.py``."""

import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from BistableWB.origami.snap import margin
from BistableWB.origami.snap.contact import holding
from BistableWB.origami.snap.table import USUAL
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit
from BistableWB.origami.units import angles

COUNT = 20
ALLOWED_COMPENSATION = 5e-3  # seconds a unit, batched
ALLOWED_ENERGY = 0.2  # seconds for 100 units, 100 steps


def timed(function):
    start = time.perf_counter()
    result = function()
    return time.perf_counter() - start, result


def best_of(repeats, function):
    """Shortest time, and the last result."""
    tries = [timed(function) for _ in range(repeats)]
    return min(seconds for seconds, _ in tries), tries[-1][1]


def energies():
    theta = np.radians(np.linspace(20, 60, 100))
    alpha, beta, _ = angles.angles_for(theta, np.sin(theta / 2) + 0.03)
    return margin.energy_path(alpha, beta, n=100)


def main():
    theta = np.radians(np.linspace(35, 50, COUNT))
    unit = plane_unit(theta, np.sin(theta / 2) + 0.03, 60, 20)
    closing, thick = best_of(3, lambda: ThickUnit(unit, 1.2, 0.6).compensated())
    print(f"compensation, {COUNT} units: {1e3 * closing / COUNT:.1f} ms a unit (allowed 5)")
    print(f"  deployed misfit {thick.misfit(1).max():.1e} mm")
    path, _ = timed(lambda: thick.poses(0.05))
    print(f"path from deployed to flat, once: {1e3 * path / COUNT:.1f} ms a unit")
    slider, _ = best_of(5, lambda: thick.poses(0.333))
    print(f"poses at one opening after that: {1e3 * slider:.0f} ms for {COUNT} units")
    peak, _ = timed(lambda: margin.peak_misfit(thick))
    print(f"peak misfit: {1e3 * peak / COUNT:.1f} ms a unit")
    held = holding(thick, USUAL)
    needed, _ = timed(lambda: margin.needed_clearance(thick, held))
    print(f"needed clearance: {1e3 * needed / COUNT:.1f} ms a unit")
    energy, _ = best_of(3, energies)
    print(f"energy paths, 100 units, 100 steps: {energy:.3f} s (allowed {ALLOWED_ENERGY})")
    return 0 if closing / COUNT <= ALLOWED_COMPENSATION and energy <= ALLOWED_ENERGY else 1


if __name__ == "__main__":
    sys.exit(main())
