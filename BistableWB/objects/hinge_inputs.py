# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hinge inputs that HingeSet and HingeCoupon share, with the paper's names, and its presets."""

import math

from ..origami.hinge_parameters import PRESETS, HingeParameters
from .base import Prop

_DEFAULTS = HingeParameters()
HINGE_PROPERTIES = (
    Prop("Enumeration", "HingeType", "Hinge", "Rotational: print-in-place knuckles. Flexible: a "
         "strip of soft material (TPU) along every crease", ["Rotational", "Flexible"]),
    Prop("Enumeration", "Pivot", "Hinge", "Cone: each knuckle turns on a cone. Pin: a continuous "
         "pin, for thick panels", ["Cone", "Pin"]),
    Prop("Angle", "ConeAngle", "Hinge", "Angle of the cones' surface against their base, 45° to "
         "60°: steeper has less play", math.degrees(_DEFAULTS.cone_angle)),
    Prop("Integer", "Segmentations", "Hinge", "Number of knuckles along a hinge, odd; fewer where "
         "a hinge is short", _DEFAULTS.segmentations),
    Prop("Length", "GapLength", "Hinge", "Axial gap between knuckles and clearance around them",
         _DEFAULTS.gap_length),
    Prop("Length", "GapBetweenPlanes", "Hinge", "Gap between stacked panels",
         _DEFAULTS.gap_between_planes),
    Prop("Length", "FaceThickness", "Hinge", "Thickness of the panels", _DEFAULTS.face_thickness),
    Prop("Angle", "RotationAngle", "Hinge", "Angle at which a dihedral is printed, 0° is folded "
         "flat; tubes and vertices are always printed flat", 0.0),
    Prop("Length", "LayerHeight", "Printer", "Layer height (the paper's profile)",
         _DEFAULTS.layer_height),
    Prop("Length", "NozzleDiameter", "Printer", "Nozzle diameter: the thinnest wall",
         _DEFAULTS.nozzle_diameter),
)  # fmt: skip

# Field of `HingeParameters` -> property, where a preset may set it.
_PROPERTY_OF = {
    "hinge_type": "HingeType",
    "segmentations": "Segmentations",
    "gap_length": "GapLength",
    "gap_between_planes": "GapBetweenPlanes",
    "face_thickness": "FaceThickness",
    "layer_height": "LayerHeight",
    "rotation_angle": "RotationAngle",
}


def hinge_parameters(obj):
    """`HingeParameters` from the properties of a HingeSet or HingeCoupon object."""
    return HingeParameters(
        hinge_type=obj.HingeType,
        pivot=obj.Pivot,
        cone_angle=math.radians(obj.ConeAngle.Value),
        segmentations=obj.Segmentations,
        gap_length=obj.GapLength.Value,
        gap_between_planes=obj.GapBetweenPlanes.Value,
        face_thickness=obj.FaceThickness.Value,
        layer_height=obj.LayerHeight.Value,
        nozzle_diameter=obj.NozzleDiameter.Value,
        rotation_angle=math.radians(obj.RotationAngle.Value),
    )


def check_preset(name):
    """ValueError, with the names there are, for an unknown preset."""
    if name not in PRESETS:
        raise ValueError(f"Preset {name!r} is unknown: choose one of {', '.join(PRESETS)}.")


def apply_preset(obj, name):
    """Set the inputs of ``obj`` to the readable cells of a column of the paper's tables."""
    check_preset(name)
    for field, value in PRESETS[name].given.items():
        if field == "rotation_angle":
            value = math.degrees(value)
        setattr(obj, _PROPERTY_OF[field], value)


def preset_remarks(name):
    """Sentences on cells of a preset that the paper's text leaves unreadable."""
    return [
        f"{name}: the paper's table does not settle {_PROPERTY_OF.get(field, field)}; the value "
        "that was set stays."
        for field in PRESETS[name].doubtful
    ]
