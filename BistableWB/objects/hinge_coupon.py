# SPDX-License-Identifier: LGPL-2.1-or-later
"""HingeCoupon: the paper's test prints (section 5, Tables 1 and 2)."""

import FreeCAD as App
import Part

from ..origami.hinges.presets import PRESETS
from ..solids.coupons import KINDS, coupon_bodies
from .base import Prop, Result, set_result, set_warnings
from .hinge_inputs import (
    HINGE_PROPERTIES,
    apply_preset,
    apply_process,
    count_segments,
    hinge_parameters,
    preset_remarks,
)
from .self_drawn import BODY_RESULTS, SelfDrawn, body_results

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
        *BODY_RESULTS,
        Result("Vector", "PrintSize", "Results", "Length, width and height of the print, mm"),
        Result("StringList", "Warnings", "Results", "What to look at before printing"),
    )  # fmt: skip

    def onChanged(self, obj, name):
        """A preset sets the inputs that the paper's table gives; a count of knuckles counts."""
        super().onChanged(obj, name)
        if not self.ready(obj):
            return
        count_segments(obj, name)
        apply_process(obj, name)
        if name == "Preset" and obj.Preset != CUSTOM:
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
            **body_results(bodies),
            PrintSize=App.Vector(box.XLength, box.YLength, box.ZLength),
        )
        set_warnings(obj, [*remarks, *parameters.warnings(), *notes])
        obj.Shape = shape

    def bodies(self, obj, notes=None, opening=0.0):
        """`solids.tube.Body` list of the coupon; ValueError where its hinge cannot be made."""
        lengths = obj.LengthX.Value, obj.LengthY.Value
        return coupon_bodies(obj.Kind, hinge_parameters(obj), *lengths, notes, opening)

    def export_bodies(self, obj):
        """[(name, shape, kind), …] of the coupon."""
        return self.bodies_at(obj, 0.0)

    def bodies_at(self, obj, opening):
        """The same at an opening: 0 as printed, 1 with the plates of a dihedral in one plane."""
        made = self.bodies(obj, opening=opening)
        return [(body.name, body.shape, body.kind) for body in made]
