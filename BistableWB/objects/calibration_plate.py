# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalibrationPlate: one small print that tells which clearance a printer keeps open."""

import math
from dataclasses import replace

import FreeCAD as App
import Part

from ..origami.hinges.calibration import Series
from ..origami.hinges.parameters import HingeParameters
from ..solids.coupons import calibration_bodies
from .base import Prop, Result, set_result, set_warnings
from .hinge_inputs import HINGE_PROPERTIES, apply_process
from .self_drawn import BODY_RESULTS, SelfDrawn, body_results

_SERIES = Series()
_OF_HINGES = (
    "Process", "Pivot", "ConeAngle", "SegmentWidth", "GapBetweenPlanes", "FaceThickness",
    "LayerHeight", "NozzleDiameter",
)  # fmt: skip


class CalibrationPlate(SelfDrawn):
    """Hinges with growing clearance and pairs of plates with growing air, numbers engraved."""

    Type = "Bistable::CalibrationPlate"
    PROPERTIES = (
        Prop("Length", "Least", "Calibration", "Clearance of the tightest hinge", _SERIES.least),
        Prop("Length", "Step", "Calibration", "How much looser every next hinge is", _SERIES.step),
        Prop("Integer", "Count", "Calibration", "Number of hinges, 5 or more", _SERIES.count),
        *(prop for prop in HINGE_PROPERTIES if prop.name in _OF_HINGES),
        *BODY_RESULTS,
        Result("FloatList", "Clearances", "Results", "Clearances of the plate's hinges, mm; "
               "their hundredths are engraved"),
        Result("Vector", "PrintSize", "Results", "Length, width and height of the print, mm"),
        Result("StringList", "Warnings", "Results", "What to look at before printing"),
    )  # fmt: skip

    def onChanged(self, obj, name):
        """A process sets the numbers that suit it."""
        super().onChanged(obj, name)
        if self.ready(obj):
            apply_process(obj, name)

    def generate(self, obj):
        """The plate's bodies as they are printed, on the bed."""
        notes = []
        bodies, clearances = self._made(obj, notes)
        shape = Part.makeCompound([body.shape for body in bodies])
        box = shape.BoundBox
        set_result(
            obj,
            **body_results(bodies),
            Clearances=clearances,
            PrintSize=App.Vector(box.XLength, box.YLength, box.ZLength),
        )
        set_warnings(obj, notes)
        obj.Shape = shape

    def _made(self, obj, notes=None):
        series = Series(obj.Least.Value, obj.Step.Value, obj.Count)
        return calibration_bodies(_hinge(obj), series, notes)

    def parameters(self, obj):
        """`HingeParameters` of the tightest hinge: what checks may ask of all."""
        clearances = self._made(obj)[1]
        return replace(_hinge(obj), gap_length=min(clearances))

    def bodies(self, obj):
        """`solids.tube.Body` list of the plate; ValueError where it cannot be made."""
        return self._made(obj)[0]

    def export_bodies(self, obj):
        """[(name, shape, kind), …] of the plate."""
        return [(body.name, body.shape, body.kind) for body in self.bodies(obj)]


def _hinge(obj):
    """`HingeParameters` of all hinges, but for their gap length."""
    return HingeParameters(
        pivot=obj.Pivot,
        cone_angle=math.radians(obj.ConeAngle.Value),
        segment_width=obj.SegmentWidth.Value,
        gap_between_planes=obj.GapBetweenPlanes.Value,
        face_thickness=obj.FaceThickness.Value,
        layer_height=obj.LayerHeight.Value,
        process=obj.Process,
        nozzle_diameter=obj.NozzleDiameter.Value,
    )
