# SPDX-License-Identifier: LGPL-2.1-or-later
"""HingeCoupon: the paper's test prints (section 5, Tables 1 and 2)."""

import FreeCAD as App
import Part

from ..origami.hinge_parameters import PRESETS
from ..solids.coupons import KINDS, coupon_bodies
from .base import Prop, Result, set_result
from .hinge_inputs import HINGE_PROPERTIES, apply_preset, hinge_parameters, preset_remarks
from .self_drawn import SelfDrawn

CUSTOM = "Custom"


class HingeCoupon(SelfDrawn):
    """A hinged dihedral or four-degree vertex, to try a hinge before printing a tube."""

    Type = "Bistable::HingeCoupon"
    PROPERTIES = (
        Prop("Enumeration", "Kind", "Coupon", "Dihedral: two hinged plates. Vertex: four plates "
             "about a developable vertex; NonDevelopableVertex: about one that is not",
             list(KINDS)),
        Prop("Enumeration", "Preset", "Coupon", "Column of the paper's Tables 1 and 2 to take the "
             "hinge inputs from; Custom leaves them as they are", [CUSTOM, *PRESETS]),
        Prop("Length", "LengthX", "Coupon", "Length of the coupon along the hinge", 45.0),
        Prop("Length", "LengthY", "Coupon", "Width of the coupon", 36.0),
        *HINGE_PROPERTIES,
        Result("Integer", "BodyCount", "Results", "Number of separate moving bodies"),
        Result("StringList", "BodyNames", "Results", "Names of the bodies, in the order of the "
               "solids"),
        Result("Vector", "PrintSize", "Results", "Length, width and height of the print, mm"),
        Result("StringList", "Warnings", "Results", "What to look at before printing"),
    )  # fmt: skip

    def onChanged(self, obj, name):
        """A preset sets the inputs that the paper's table gives."""
        if name == "Preset" and self.ready(obj) and obj.Preset != CUSTOM:
            apply_preset(obj, obj.Preset)
            for prop, length in zip(("LengthX", "LengthY"), PRESETS[obj.Preset].size, strict=False):
                if length:
                    setattr(obj, prop, length)

    def generate(self, obj):
        """The coupon's bodies as it is printed, on the bed."""
        parameters, notes = hinge_parameters(obj), []
        bodies = self.bodies(obj, notes)
        remarks = preset_remarks(obj.Preset) if obj.Preset != CUSTOM else []
        shape = Part.makeCompound([body.shape for body in bodies])
        box = shape.BoundBox
        set_result(
            obj,
            BodyCount=len(bodies),
            BodyNames=[body.name for body in bodies],
            PrintSize=App.Vector(box.XLength, box.YLength, box.ZLength),
            Warnings=[*remarks, *parameters.warnings(), *notes],
        )
        obj.Shape = shape

    def bodies(self, obj, notes=None):
        """`solids.tube.Body` list of the coupon; ValueError where its hinge cannot be made."""
        lengths = obj.LengthX.Value, obj.LengthY.Value
        return coupon_bodies(obj.Kind, hinge_parameters(obj), *lengths, notes=notes)

    def export_bodies(self, obj):
        """[(name, shape), …] of the coupon."""
        return [(body.name, body.shape) for body in self.bodies(obj)]
