# SPDX-License-Identifier: LGPL-2.1-or-later
"""How hard tubes snap, wobble and stand, by what holds the deployed state.

    python3 benchmarks/strength.py [--tube new|arch] [--units N] [--against]
    python3 benchmarks/strength.py --barrels

Needs no FreeCAD. Prints the numbers of docs/strength.md and the time a unit takes; ``--against``:
also what else than preload could hold it, smaller clearance and steeper cones; ``--barrels``: how
near to each other the barrels of double hinges come in states that know nothing of them.
"""

import argparse
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.rules import PlacementRule
from BistableWB.origami.design import CurveGeometry, Placing, Single, Thickness, TubeDesign
from BistableWB.origami.hinges.standoff_inputs import StandOffs
from BistableWB.origami.snap import barrels
from BistableWB.origami.snap.contact import contacts, holding
from BistableWB.origami.snap.elastic import elastic_unit
from BistableWB.origami.snap.forces import OPENINGS, follow
from BistableWB.origami.snap.load import BOTH, START, carried
from BistableWB.origami.snap.margin import assess
from BistableWB.origami.snap.materials import material
from BistableWB.origami.snap.slop import tube_slop
from BistableWB.origami.snap.study import Conditions, layouts_of, study
from BistableWB.origami.snap.table import USUAL as BARE
from BistableWB.origami.snap.targets import FIRM, TargetMargin
from BistableWB.origami.units.creases import BODIES
from BistableWB.origami.units.ratios import RatioRule

NEW = Bezier([(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)])
ARCH = Bezier([(0, 0, 0), (90, 180, 0), (270, 180, 0), (360, 0, 0)])
# as new hinge sets have it: what bodies weigh with their stand-offs
USUAL = replace(BARE, process="FDM, stand-offs", standoffs=StandOffs())
TUBES = {"new": (NEW, 70.0, 30.0, FIRM), "arch": (ARCH, 80.0, 29.0, 2.5)}
WAYS = ((0, 0, -1), (0, 0, 1), (1, 0, 0), (-1, 0, 0), (0, 1, 0))
AUTOMATIC = None


def main():
    """Study a tube in some ways and print what came out."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--tube", choices=TUBES, default="new")
    parser.add_argument("--units", type=int, default=0, help="only so many of its units")
    parser.add_argument("--against", action="store_true")
    parser.add_argument("--barrels", action="store_true")
    options = parser.parse_args()
    if options.barrels:
        _barrels()
        return
    ways = {"no preload": (USUAL, 0.0), "preload Automatic": (USUAL, AUTOMATIC)}
    if options.against:
        ways |= {
            "no preload, GapLength 0.3": (replace(USUAL, gap_length=0.3), 0.0),
            "no preload, cones of 60°": (replace(USUAL, cone_angle=np.radians(60)), 0.0),
        }
    for name, (hinges, preload) in ways.items():
        _one(name, options, hinges, preload)


def _one(name, options, hinges, preload):
    curve, edge, gamma, wanted = TUBES[options.tube]
    pla = material("PLA")
    where = Placing(CurveGeometry(curve), edge, np.radians(gamma), hinges.pitch,
                    rule=PlacementRule("EndFit"))  # fmt: skip
    thickness = Thickness(hinges.face_thickness, hinges.gap_between_planes, True, preload,
                          None if preload == 0 else hinges)  # fmt: skip
    rule = RatioRule("TargetSnap", target=TargetMargin(edge, USUAL.pitch, wanted, USUAL.play))
    tube = TubeDesign(where, rule, 2.5, thickness).thick()
    if options.units:
        tube = tube.part(0, min(options.units, len(tube.tube)) - 1)
    begun = time.process_time()
    found = study(tube, hinges, Conditions(pla))
    took = (time.process_time() - begun) / len(tube.tube)
    begun = time.process_time()
    margin = assess(tube.thick, holding(tube.thick, hinges)).margin
    measured = 1000 * (time.process_time() - begun) / len(tube.tube)
    print(
        f"\n{options.tube}, {name}: {took:.2f} s of processor a unit, its margin {measured:.0f} ms"
    )
    _print(found, margin, tube)
    layouts = layouts_of(tube, hinges)
    for way in WAYS:
        least = [
            carried(tube.thick, layouts, hinges, pla.density, found.units, way, fixed,
                    tube.tube.incoming_left).factors.min()
            for fixed in (START, BOTH)
        ]  # fmt: skip
        print(f"  gravity {way}: least safety {least[0]:.2f} held at the start, "
              f"{least[1]:.2f} at both ends")  # fmt: skip


def _barrels():
    """Least room (mm) between them on the elastic way, and where a loose unit is pulled to."""
    rule = RatioRule("TargetSnap", target=TargetMargin(80.0, BARE.pitch, FIRM, BARE.play))
    for cone in (45, 55, 60):
        hinges = replace(BARE, cone_angle=np.radians(cone))
        for preload in (0.0, AUTOMATIC):
            panels = Thickness(hinges.face_thickness, hinges.gap_between_planes, True, preload,
                               None if preload == 0 else hinges)  # fmt: skip
            where = Single(np.radians(55), 80.0, pitch=hinges.pitch)
            tube = TubeDesign(where, rule, 2.5, panels).thick()
            thick, layouts = tube.thick, layouts_of(tube, hinges)
            unit = elastic_unit(thick, layouts[0], contacts(layouts, hinges), hinges,
                                material("PLA"))  # fmt: skip
            poses = thick.states(OPENINGS[None])[0]
            poses[..., :3, 3] *= thick.scale
            apart = holding(thick, hinges).barrels
            rests = follow(unit, OPENINGS[::-1], poses[::-1])
            bent = [_room(unit, apart, rest.state).min() for rest in rests]
            pulled = tube_slop(thick, layouts, hinges).poses.reshape(-1, len(BODIES), 4, 4)
            loose = min(apart.room(each[None])[0].min() for each in pulled)
            name = "no preload" if preload == 0 else "preload Automatic"
            print(
                f"cones of {cone}°, {name}: on the way {min(bent):.2f} mm at "
                f"{rests[int(np.argmin(bent))].energy:.1f} N·mm, pulled {loose:.2f} mm"
            )


def _room(unit, apart, state):
    """Room between barrels whose panels are bent: their ends move as the nearest contact does."""
    moved = []
    for side, (ends, bodies) in enumerate(
        ((apart.first[0], barrels.FIRST), (apart.second[0], barrels.SECOND))
    ):
        there = ends.copy()
        for link, body in enumerate(bodies):
            hinge = barrels.HINGES[link, side]
            valid = unit.valid[hinge]
            shift = unit.modes[0][hinge][valid] @ state.modes[body]
            away = np.linalg.norm(unit.points[hinge][valid] - ends[link][:, None], axis=-1)
            there[link] += shift[away.argmin(1)]
        moved.append(there[None])
    return replace(apart, first=moved[0], second=moved[1]).room(state.poses[None])[0]


def _print(found, margin, tube):
    rows = {
        "theta, °": np.degrees(tube.tube.unit.theta),
        "snap margin": margin,
        "barrier, N·mm": [unit.barrier for unit in found.units],
        "torque to open, N·mm": [unit.torque for unit in found.units],
        "torque to fold back, N·mm": [unit.closing_torque for unit in found.units],
        "stress / strength": [unit.weakest.share for unit in found.units],
        "free bend, ± °": np.degrees(found.slop.bend),
        "free twist, ± °": np.degrees(found.slop.twist),
    }
    if tube.thick.rest is not None:
        rows["preload, mm"] = tube.thick.rest.amounts
    for name, values in rows.items():
        print(f"  {name:26s}", *(f"{value:8.2f}" for value in values))
    print(
        f"  free end ± {found.slop.end:.1f} mm of {found.length:.0f} mm ({found.slop_share:.1%}), "
        f"{found.load.weight:.0f} g"
    )
    print(f"  turned the worst way: least safety {found.load.turned.min():.2f}")


if __name__ == "__main__":
    main()
