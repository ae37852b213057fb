# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that make what is printed: hinge sets and coupons."""

from .. import settings
from ..scene import chosen
from .base import QT_TRANSLATE_NOOP, Command, Script, by_name, fit_view, translate

UNIT = "Bistable::BistableUnit"


class HingeSet(Command):
    """Thick panels with hinges for the units of a tube."""

    name = "Bistable_HingeSet"
    icon = "HingeSet"
    text = QT_TRANSLATE_NOOP("Bistable_HingeSet", "Hinge set")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_HingeSet",
        "Turn the selected bistable units into thick panels with print-in-place hinges, "
        "flat-folded as they are printed",
    )
    shortcut = "O, H"

    def IsActive(self):
        """With units to make thick."""
        return chosen_units() is not None

    def run(self):
        """Make the solids and show them by themselves; Esc stops and leaves nothing behind."""
        units = chosen_units()
        with Script(translate("Bistable_HingeSet", "Hinge set")) as script:
            script.add(f"units = {by_name(units)}")
            script.add("hinges = make.make_hinge_set(doc, units)")
            for line in (*settings.hinge_lines("hinges"), *settings.air_lines("hinges")):
                script.add(line)
            script.add(settings.bed_line("hinges"))
            script.add("make.make_solids(hinges)")
            script.view("Gui.Selection.clearSelection()")
            script.view(
                "[o.ViewObject.hide() for o in hinges.OutListRecursive if hinges.Shape.Solids]"
            )
        fit_view(isometric=True)


def chosen_units():
    """The units that are selected, or that belong to a selected part of a tube."""
    return chosen.of_type(UNIT) or chosen.made_from_selection(UNIT)


class HingeCoupon(Command):
    """A small print to try a hinge with."""

    name = "Bistable_HingeCoupon"
    icon = "HingeCoupon"
    text = QT_TRANSLATE_NOOP("Bistable_HingeCoupon", "Hinge coupon")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_HingeCoupon",
        "Make a small test print of one hinge: try it on your printer before printing a tube",
    )
    shortcut = "O, K"

    def run(self):
        """Make a dihedral coupon with the workbench's own hinge."""
        with Script(translate("Bistable_HingeCoupon", "Hinge coupon")) as script:
            script.add('coupon = make.make_hinge_coupon(doc, "Dihedral", preset=None)')
            for line in settings.hinge_lines("coupon"):
                script.add(line)
            script.view("Gui.Selection.clearSelection()")
        fit_view(isometric=True)


class Calibration(Command):
    """A plate that tells what this printer keeps apart, and the question what came out."""

    name = "Bistable_Calibration"
    icon = "CalibrationPlate"
    text = QT_TRANSLATE_NOOP("Bistable_Calibration", "Calibration plate")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Calibration",
        "Make one small print that tells which clearance your printer keeps open. When it is "
        "printed, edit the plate and say which hinges turn: new hinges and checks follow",
    )
    shortcut = "O, Y"

    def run(self):
        """Make the plate with the printer's own numbers."""
        with Script(translate("Bistable_Calibration", "Calibration plate")) as script:
            script.add("plate = make.make_calibration_plate(doc)")
            for line in settings.hinge_lines("plate", without=("GapLength",)):
                script.add(line)
            script.view("Gui.Selection.clearSelection()")
        fit_view(isometric=True)
