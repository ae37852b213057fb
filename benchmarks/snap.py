# SPDX-License-Identifier: LGPL-2.1-or-later
"""Will it snap? Three designs in numbers, and the table behind the target snap.

    python3 benchmarks/snap.py                 the three designs of docs/will-it-snap.md
    python3 benchmarks/snap.py --charts DIR    and their charts
    python3 benchmarks/snap.py --fit           what Auto-fit proposes along the same arch
    python3 benchmarks/snap.py --write-table   make origami/snap/table_data.py anew (some minutes)

Run the last one when `origami.snap` or the model of thick units has changed its results.
"""

import argparse
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.fit import search
from BistableWB.origami.snap import margin as snap
from BistableWB.origami.snap import table
from BistableWB.origami.snap.contact import holding
from BistableWB.origami.snap.targets import TargetMargin
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.units import tube as tubes
from BistableWB.origami.units.ratios import RatioRule

HINGE = table.USUAL
ARCH = Bezier([[0, 0, 0], [90, 180, 0], [270, 180, 0], [360, 0, 0]])
# Name, ‖AB‖ (mm), gamma (degrees), rule for the ratios.
DESIGNS = (
    ("floppy", 60.0, 20.0, RatioRule("Adaptive", share=0.15)),
    ("borderline", 60.0, 20.0, RatioRule("Adaptive", share=0.04)),
    ("firm", 80.0, 25.0, RatioRule("TargetSnap", target=TargetMargin(80.0, HINGE.pitch))),
)
TABLE = Path(__file__).parents[1] / "BistableWB/origami/snap/table_data.py"
HEAD = '''# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of `snap.table`, made by ``benchmarks/snap.py --write-table``: do not edit.

A line for each pitch / ‖AB‖ and θ: needed radial play of the hinges' cones for every share, in
thousandths of ‖AB‖, then peak strain in thousandths; nan where no such unit can be made.
"""

TABLE = """
'''


def design(edge_length, gamma, rule):
    """Tube, its compensated thick units, and their snap."""
    placed = place(ARCH, edge_length, np.radians(gamma), HINGE.pitch)
    tube = tubes.along(placed, "Plane", 2.5, rule)
    thick = ThickUnit(tube.unit, HINGE.face_thickness, HINGE.gap_between_planes).compensated()
    return tube, snap.assess(thick, holding(thick, HINGE))


def report(name, edge_length, gamma, rule, folder):
    start = time.process_time()
    tube, found = design(edge_length, gamma, rule)
    theta, margin = np.degrees(tube.unit.theta), found.margin
    weakest = int(margin.argmin())
    print(f"{name}: ‖AB‖ {edge_length:g} mm, gamma {gamma:g}°, {rule.name}, {len(tube)} units")
    needed = found.needed_gap
    print(f"  theta {theta.min():.1f}° to {theta.max():.1f}°, clearance {HINGE.gap_length:.2f} mm")
    print(f"  needed clearance {needed.min():.2f} to {needed.max():.2f} mm")
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


def fit():
    """The proposals of Auto-fit along the arch, for a bed of 250 × 210 × 210 mm and margin 1.5."""
    start = time.process_time()
    found = search.auto_fit(search.Course(ARCH), search.Wanted(bed=(250.0, 210.0, 210.0)))
    for one in found.candidates:
        rule = one.rule if one.share is None else f"{one.rule}, share {one.share:g}"
        size = " × ".join(f"{side:.0f}" for side in one.print_size)
        print(f"‖AB‖ {one.edge_length:.0f} mm, gamma {np.degrees(one.gamma):.0f}°, {rule}: "
              f"{one.count} units, margin {one.margin_min:.2f}, strain {one.strain_max:.1%}, print "
              f"{size} mm, stays within {one.deviation:.1f} mm of the curve")  # fmt: skip
    print(f"{time.process_time() - start:.1f} s")


def write_table():
    """Measure all nodes and write them as a module."""
    shares, legacy = np.array(table.SHARES), table.table(table.LEGACY)
    found = np.empty_like(legacy)
    for i, pitch_ratio in enumerate(table.PITCH_RATIOS):
        for j, theta in enumerate(table.THETAS):
            found[i, j] = table.measure(np.full(len(shares), theta), shares, pitch_ratio)
        if i:  # units too small for the usual hinges: as the play at creases goes on
            without = np.isnan(found[i]) & np.isfinite(legacy[i])
            found[i][without] = (found[i - 1] * legacy[i] / legacy[i - 1])[without]
        print(f"pitch / edge length {pitch_ratio:.4f} done", file=sys.stderr)
    lines = [
        " ".join(f"{1000 * x:.4g}" for x in row.ravel())
        for row in found.reshape(-1, 2 * len(shares))
    ]
    TABLE.write_text(HEAD + "\n".join(lines) + '\n"""\n', encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--charts", type=Path, metavar="DIR")
    parser.add_argument("--fit", action="store_true")
    parser.add_argument("--write-table", action="store_true")
    options = parser.parse_args()
    if options.write_table:
        write_table()
        return 0
    if options.fit:
        fit()
        return 0
    if options.charts:
        options.charts.mkdir(parents=True, exist_ok=True)
    for name, *values in DESIGNS:
        report(name, *values, options.charts)
    return 0


if __name__ == "__main__":
    sys.exit(main())
