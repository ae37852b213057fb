# SPDX-License-Identifier: LGPL-2.1-or-later
"""The hinge inputs that HingeSet and HingeCoupon share, with the paper's names, and its presets."""

import math

from ..origami.errors import Choice, Refusal, name_of, phrase
from ..origami.hinges.kinds import HINGE_KINDS, KINDS_TIP, ROTATIONAL
from ..origami.hinges.parameters import SEGMENT_WIDTH, HingeParameters
from ..origami.hinges.presets import PRESETS
from ..origami.hinges.processes import BY_STANDOFFS, PROCESSES, SOLUBLE
from ..origami.hinges.standoff_inputs import LINE_IN_NOZZLES, StandOffs, usual_air
from .base import Prop

_DEFAULTS = HingeParameters()
HINGE_PROPERTIES = (
    Prop("Enumeration", "Process", "Printer", "How it is printed. Setting it sets gaps, thickness, "
         "layers, cones, orientation and material to what suits; change them afterwards",
         list(PROCESSES), SOLUBLE),
    Prop("Enumeration", "HingeType", "Hinge", KINDS_TIP, list(HINGE_KINDS)),
    Prop("Enumeration", "Pivot", "Hinge", "Cone: each knuckle turns on a cone. Pin: a continuous "
         "pin, for thick panels", ["Cone", "Pin"]),
    Prop("Angle", "ConeAngle", "Hinge", "Angle of the cones' surface against their base, 45° to "
         "60°: steeper has less play", math.degrees(_DEFAULTS.cone_angle)),
    Prop("Length", "SegmentWidth", "Hinge", "Wanted width of the knuckles, with short ones at the "
         "ends of each hinge, which hold it best; 0: equal knuckles by their number, Segmentations",
         SEGMENT_WIDTH, 0.0),
    Prop("Integer", "Segmentations", "Hinge", "Number of knuckles along a hinge, odd; fewer where "
         "a hinge is short (setting it sets SegmentWidth to 0)", _DEFAULTS.segmentations),
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

_STANDOFFS = StandOffs()
STANDOFF_PROPERTIES = (
    Prop("Length", "StandOffSpacing", "Stand-offs", "Between the ribs that hold up the panel above "
         "in the print, both ways", _STANDOFFS.spacing),
    Prop("Length", "StandOffWidth", "Stand-offs", "Width of the ribs; 0: one line of the nozzle",
         0.0),
    Prop("Integer", "AirLayers", "Stand-offs", "Layers of air between a rib and what it holds up, "
         "so that it comes free; 0: about 0.2 mm", 0),
    Prop("Bool", "StandOffRim", "Stand-offs", "Ribs along the panels' edges too", _STANDOFFS.rim),
    Prop("Bool", "Pillars", "Stand-offs", "Loose posts under what no rib can hold in the flat "
         "print; they fall out when the tube is opened", _STANDOFFS.pillars),
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
    "nozzle_diameter": "NozzleDiameter",
    "cone_angle": "ConeAngle",
}


def hinge_parameters(obj):
    """`HingeParameters` from the properties of a HingeSet or HingeCoupon object."""
    return HingeParameters(
        hinge_type=obj.HingeType,
        pivot=obj.Pivot,
        cone_angle=math.radians(obj.ConeAngle.Value),
        segmentations=obj.Segmentations,
        segment_width=obj.SegmentWidth.Value,
        gap_length=obj.GapLength.Value,
        gap_between_planes=obj.GapBetweenPlanes.Value,
        face_thickness=obj.FaceThickness.Value,
        layer_height=obj.LayerHeight.Value,
        nozzle_diameter=obj.NozzleDiameter.Value,
        rotation_angle=math.radians(obj.RotationAngle.Value),
        process=obj.Process,
        standoffs=_standoffs(obj),
    )


def _standoffs(obj):
    """`StandOffs` of an object that has some; None where its process wants none."""
    wants = hasattr(obj, "StandOffSpacing") and obj.HingeType == ROTATIONAL
    wanted = wants and PROCESSES[obj.Process].held == BY_STANDOFFS
    return standoffs_of(obj) if wanted else None


def standoffs_of(obj):
    """`StandOffs` by the properties of a HingeSet, whatever its process."""
    line = LINE_IN_NOZZLES * obj.NozzleDiameter.Value
    return StandOffs(
        obj.StandOffSpacing.Value,
        obj.StandOffWidth.Value or line,
        obj.AirLayers or usual_air(obj.LayerHeight.Value, obj.GapBetweenPlanes.Value),
        obj.StandOffRim,
        obj.Pillars,
    )


def count_segments(obj, name):
    """For `onChanged`: whoever sets the number of knuckles means it."""
    if name == "Segmentations" and obj.SegmentWidth.Value:
        obj.SegmentWidth = 0


def apply_process(obj, name):
    """For `onChanged`: a process sets what suits it, as far as ``obj`` has it."""
    if name != "Process":
        return
    process = PROCESSES[obj.Process]
    for field, value in process.gives.items():
        degrees = field in ("rotation_angle", "cone_angle")
        if hasattr(obj, _PROPERTY_OF[field]):
            setattr(obj, _PROPERTY_OF[field], math.degrees(value) if degrees else value)
    for name, value in (("Orientation", process.orientation), ("Material", process.material)):
        if hasattr(obj, name):
            setattr(obj, name, value)


def check_preset(name):
    """ValueError, with the names there are, for an unknown preset."""
    if name not in PRESETS:
        raise Refusal(
            "{Preset} {name!r} is unknown: choose one of {names}.",
            parameter="Preset",
            name=name,
            names=", ".join(PRESETS),
        )


def apply_preset(obj, name):
    """Set the inputs of ``obj`` to the readable cells of a column of the paper's tables."""
    check_preset(name)
    if "segmentations" in PRESETS[name].given:
        obj.SegmentWidth = 0
    for field, value in PRESETS[name].given.items():
        if field == "rotation_angle":
            value = math.degrees(value)
        setattr(obj, _PROPERTY_OF[field], value)


def preset_remarks(name):
    """Sentences on cells of a preset that the paper's text leaves unreadable."""
    return [
        phrase(
            "{preset}: the paper's table does not settle {name}; the value that was set stays.",
            preset=Choice(name),
            name=name_of(_PROPERTY_OF[field]) if field in _PROPERTY_OF else field,
        )
        for field in PRESETS[name].doubtful
    ]
