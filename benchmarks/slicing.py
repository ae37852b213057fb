# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the slicer says of prints: the numbers of docs/slicing.md.

    .ci/in-freecad host --script benchmarks/slicing.py           hinges, then the three designs
    .ci/in-freecad host --script benchmarks/slicing.py contact   only what makes hinges fuse
    .ci/in-freecad host --script benchmarks/slicing.py DESIGN.toml [UNITS [TRIES]]

The last one compares one design, of which only the first UNITS are printed (0: all), with it
deployed in TRIES orientations. All of it takes twenty minutes, nearly all of it PrusaSlicer's.
"""

import sys
import time
from dataclasses import replace
from pathlib import Path

import FreeCAD as App
import numpy as np

from BistableWB import slicing
from BistableWB.checks.printer import Printer
from BistableWB.designs import building, reading
from BistableWB.origami import unit
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.presets import PRESETS
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.slicing import toolpaths
from BistableWB.slicing.contact import contacts
from BistableWB.slicing.section import section
from BistableWB.solids.tessellation import placed_meshes
from BistableWB.solids.tube import tube_bodies

EXAMPLES = Path(__file__).parents[1] / "resources/examples"
# Design, number of units (0: all), deployed orientations that are sliced.
DESIGNS = (("spherical-unit", 0, 4), ("hinged-arch", 3, 4), ("hinged-arch", 0, 1))
HINGE = HingeParameters()
# What, hinge, layer height, settings of the slicer that are changed.
CONTACTS = (
    ("defaults", HINGE, 0.2, {}),
    ("preset Recommended", PRESETS["Recommended"].parameters(HINGE), 0.2, {}),
    ("preset RecommendedVertex", PRESETS["RecommendedVertex"].parameters(HINGE), 0.2, {}),
    ("pins", replace(HINGE, pivot="Pin"), 0.2, {}),
    ("cones of 45°", replace(HINGE, cone_angle=np.radians(45)), 0.2, {}),
    ("cones of 60°", replace(HINGE, cone_angle=np.radians(60)), 0.2, {}),
    ("GapLength 0.3", replace(HINGE, gap_length=0.3), 0.2, {}),
    ("GapLength 0.25", replace(HINGE, gap_length=0.25), 0.2, {}),
    ("GapLength 0.2", replace(HINGE, gap_length=0.2), 0.2, {}),
    ("layers of 0.3", HINGE, 0.3, {}),
    ("classic perimeters", HINGE, 0.2, {"perimeter_generator": "classic"}),
    ("lines of 0.6", HINGE, 0.2, {"extrusion_width": 0.6}),
    ("without support", HINGE, 0.2, {"support_material": 0}),
    ("xy_size_compensation 0.05", HINGE, 0.2, {"xy_size_compensation": 0.05}),
    ("xy_size_compensation 0.1", HINGE, 0.2, {"xy_size_compensation": 0.1}),
    ("slice_closing_radius 0.2", HINGE, 0.2, {"slice_closing_radius": 0.2}),
)


def contact():
    """Largest contact in a joint of one unit, ‖AB‖ 60 mm, θ 45°."""
    plane = unit.plane_unit(np.radians([45.0]), np.array([0.42]), 60.0, 24.0)
    for what, hinge, layer, changed in CONTACTS:
        thick = ThickUnit(plane, hinge.face_thickness, hinge.gap_between_planes).compensated()
        meshes = [body.placed for body in placed_meshes(tube_bodies(thick, hinge))]
        lines, _ = toolpaths.sliced(meshes, Printer(layer), extra=changed.items())
        start = time.time()
        areas = [one.area for one in contacts(lines, meshes, layer)]
        took = time.time() - start
        print(f"| {what} | {max(areas, default=0):.2f} mm² |   {took:.1f} s to find", flush=True)


def compare(path, units, tries):
    """The comparison of one design."""
    doc = App.newDocument("Slicing", hidden=True)
    try:
        hinges = building.build(doc, reading.read(path))["hinges"]
        hinges.Process = "FDM, soluble"
        hinges.LastUnit = units
        doc.recompute()
        start = time.time()
        compared = slicing.compare(hinges, tries=tries)
        told = section(compared)
        print(f"\n{path.stem}, {len(hinges.SnapMargins)} unit(s), {hinges.BodyCount} bodies")
        print(told.text)
        for row in (told.columns, ["---"] * len(told.columns), *told.rows):
            print(f"| {' | '.join(map(str, row))} |")
        print(*compared.findings, f"{time.time() - start:.0f} s", sep="\n", flush=True)
    finally:
        App.closeDocument(doc.Name)


def main(args):
    if args in ([], ["contact"]):
        contact()
        for name, units, tries in () if args else DESIGNS:
            compare(EXAMPLES / f"{name}.toml", units, tries)
        return
    path, units, tries = [*args, *("0", "4")[len(args) - 1 :]]
    compare(Path(path), int(units), int(tries))


main(sys.argv[1:])
