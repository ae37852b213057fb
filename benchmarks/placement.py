# SPDX-License-Identifier: LGPL-2.1-or-later
"""Placing and solving units along the example arch: milliseconds, best of five."""

import time

import numpy as np

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.units import tube
from BistableWB.origami.units.ratios import RatioRule

ARCH = [(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)]
TARGETS = {100: 30.0, 1000: 500.0}  # units -> ms


def main():
    for units, target in TARGETS.items():
        edge = 40 * 22 / units
        best = np.inf
        for _ in range(5):
            start = time.perf_counter()
            placed = place(Bezier(ARCH), edge, np.radians(20))
            made = tube.along(placed, "Plane", 2.5, RatioRule())
            best = min(best, time.perf_counter() - start)
        print(f"{len(made)} units placed and solved: {1e3 * best:.1f} ms (target {target:.0f} ms)")
    start = time.perf_counter()
    made.state(0.5)
    print(f"{len(made)} units at Deployment 0.5: {1e3 * (time.perf_counter() - start):.1f} ms")


main()
