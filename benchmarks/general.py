# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time of general units and proposed rulings: ``python3 benchmarks/general.py``."""

import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.curves.ruling import default_ruling
from BistableWB.origami.unit import general_unit
from BistableWB.origami.units.contacts import contact_pairs

ALLOWED_SECONDS = 0.3
CURVE = Bezier([[0, 0, 0], [60, 120, 20], [180, 120, 60], [240, 0, 70]])


def best_of(repeats, function):
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        result = function()
        times.append(time.perf_counter() - start)
    return min(times), result


def main():
    placed = place(CURVE, 40.0, np.radians(20))
    left, right = contact_pairs(placed, 16.0)
    hundred = np.arange(100) % len(left)
    seconds, unit = best_of(5, lambda: general_unit(left[hundred], right[hundred], 0.5))
    print(f"general_unit, 100 units of a rising arch: {seconds:.3f} s (allowed {ALLOWED_SECONDS})")
    print(f"  largest relative change of a length: {unit.isometry_error().max():.1e}")
    ruling_seconds, legs = best_of(3, lambda: default_ruling(CURVE, 40.0))
    print(f"default_ruling: {ruling_seconds:.3f} s, {legs[0]} {np.round(legs[1], 4)}")
    return 0 if seconds <= ALLOWED_SECONDS else 1


if __name__ == "__main__":
    sys.exit(main())
