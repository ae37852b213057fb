# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that 0.1.0 recorded into macros run unchanged."""

import FreeCAD as App

OPEN_EXAMPLE = """
from BistableWB import EXAMPLES, design, produce
doc = App.newDocument("recorded")
produce.build(doc, design.read(EXAMPLES / "plane-arch.toml"))
"""
MATHEMATICS = """
from BistableWB.origami import angles, bezier, linkage, placement, snap, unit
from BistableWB.origami.angles import angles_for
import BistableWB.origami.placement
assert angles.angles_for is angles_for and placement is BistableWB.origami.placement
assert bezier.Bezier and linkage.ThickUnit and unit.plane_unit and snap.energy_path
"""


def test_an_example_opened_by_a_macro_of_the_first_version():
    before = set(App.listDocuments())
    exec(OPEN_EXAMPLE, {"App": App})
    (name,) = set(App.listDocuments()) - before
    objects = App.getDocument(name).Objects
    assert {obj.BistableType for obj in objects} >= {"Bistable::Curve", "Bistable::BistableUnit"}
    assert all(obj.isValid() for obj in objects)
    App.closeDocument(name)


def test_the_mathematics_under_its_first_names():
    exec(MATHEMATICS, {})
