# SPDX-License-Identifier: LGPL-2.1-or-later
"""Will it snap? Three designs in numbers, and the table behind the target snap.

    python3 benchmarks/snap.py                 the three designs of docs/will-it-snap.md
    python3 benchmarks/snap.py --charts DIR    and their charts
    python3 benchmarks/snap.py --write-table   make origami/snap_data.py anew (some minutes)

Run the last one when `origami.snap` or the model of thick units has changed its results.
"""

import argparse
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from BistableWB.origami import snap, snap_table
from BistableWB.origami import tube as tubes
from BistableWB.origami.bezier import Bezier
from BistableWB.origami.hinge_parameters import HingeParameters
from BistableWB.origami.linkage import ThickUnit
from BistableWB.origami.placement import place
from BistableWB.origami.ratios import RatioRule
from BistableWB.origami.target_snap import TargetMargin

HINGE = HingeParameters()
ARCH = Bezier([[0, 0, 0], [90, 180, 0], [270, 180, 0], [360, 0, 0]])
# Name, ‖AB‖ (mm), gamma (degrees), rule for the ratios.
DESIGNS = (
    ("floppy", 60.0, 20.0, RatioRule("Adaptive", share=0.15)),
    ("borderline", 60.0, 20.0, RatioRule("Adaptive", share=0.04)),
    ("firm", 80.0, 25.0, RatioRule("TargetSnap", target=TargetMargin(80.0, HINGE.pitch))),
)
TABLE = Path(__file__).parents[1] / "BistableWB/origami/snap_data.py"
HEAD = '''# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of `snap_table`, made by ``benchmarks/snap.py --write-table``: do not edit.

A line for each pitch / ‖AB‖ and θ: needed play for every share, in thousandths of ‖AB‖, then peak
strain in thousandths; nan where no such unit can be made.
"""

TABLE = """
'''


def design(edge_length, gamma, rule):
    """Tube, its compensated thick units, and their snap."""
    placed = place(ARCH, edge_length, np.radians(gamma), HINGE.pitch)
    tube = tubes.along(placed, "Plane", 2.5, rule)
    thick = ThickUnit(tube.unit, HINGE.face_thickness, HINGE.gap_between_planes).compensated()
    return tube, snap.assess(thick, HINGE.play)


def report(name, edge_length, gamma, rule, folder):
    start = time.process_time()
    tube, found = design(edge_length, gamma, rule)
    theta, margin = np.degrees(tube.unit.theta), found.margin
    weakest = int(margin.argmin())
    print(f"{name}: ‖AB‖ {edge_length:g} mm, gamma {gamma:g}°, {rule.name}, {len(tube)} units")
    print(f"  theta {theta.min():.1f}° to {theta.max():.1f}°, play {HINGE.play:.2f} mm")
    print(f"  needed play {found.needed_play.min():.2f} to {found.needed_play.max():.2f} mm")
    print(f"  snap margin {margin.min():.2f} (unit {weakest + 1}) to {margin.max():.2f}, "
          f"{found.floppy.sum()} floppy")  # fmt: skip
    print(f"  peak strain up to {np.max(found.strain):.2%}")
    print(f"  {time.process_time() - start:.1f} s")
    if folder is not None:
        charts(name, tube, margin, rule, folder)


def charts(name, tube, margin, rule, folder):
    from BistableWB.pictures import snap_charts

    unit = tube.unit
    fractions, energies = snap.energy_path(unit.alpha, unit.beta, n=60)
    target = rule.target.margin if rule.target else None
    snap_charts.margin_chart(folder / f"snap-{name}.png", margin, target)
    snap_charts.energy_chart(folder / f"energy-{name}.png", fractions, energies)


def write_table():
    """Measure all nodes and write them as a module."""
    lines = []
    for pitch_ratio in snap_table.PITCH_RATIOS:
        for theta in snap_table.THETAS:
            shares = np.array(snap_table.SHARES)
            found = snap_table.measure(np.full(len(shares), theta), shares, pitch_ratio)
            lines.append(" ".join(f"{1000 * x:.4g}" for x in found.ravel()))
        print(f"pitch / edge length {pitch_ratio:.4f} done", file=sys.stderr)
    TABLE.write_text(HEAD + "\n".join(lines) + '\n"""\n', encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--charts", type=Path, metavar="DIR")
    parser.add_argument("--write-table", action="store_true")
    options = parser.parse_args()
    if options.write_table:
        write_table()
        return 0
    if options.charts:
        options.charts.mkdir(parents=True, exist_ok=True)
    for name, *values in DESIGNS:
        report(name, *values, options.charts)
    return 0


if __name__ == "__main__":
    sys.exit(main())
