# SPDX-License-Identifier: LGPL-2.1-or-later
"""The keys of a design file: one table. To add a key, add a line here.

A key has a kind (a function that checks and returns its value), the property of the document object
that it sets (empty: it sets none), and limits, beyond which a value is a slip of the pen.
"""

from typing import Any

from ..exporters.formats import NETS, SOLIDS, formats_with, named
from ..origami.curves.families import AUTOMATIC, FAMILIES
from ..origami.hinges.kinds import HINGE_KINDS
from ..origami.hinges.presets import PRESETS
from ..origami.hinges.processes import PROCESSES, STANDOFFS
from ..origami.patterns.panel_hinges import PANEL_HINGES
from .values import (
    MAX_LENGTH,
    MIN_LENGTH,
    Key,
    angle,
    choice,
    choices,
    flag,
    length,
    number,
    numbers,
    points,
    text,
    vector,
    whole,
)

# As in origami.ratios, which needs numpy: a design is read before that is there.
RATIO_RULES = ("Adaptive", "Fixed", "Exact", "Paper", "TargetSnap")
PLACEMENT_RULES = ("EndFit", "Steered", "Paper")
COUPON_KINDS = ("Dihedral", "Vertex", "NonDevelopableVertex")  # as in solids.coupons
JOINT_KINDS = ("Dowel", "Clip", "Magnet", "Screw", "None")  # as origami.hinges.joints.JOINTS
END_KINDS = ("Plain", "Plate", "Flange", "Foot")  # as origami.hinges.ends.END_PARTS
RULING_KINDS = ("Automatic", "Direction", "Viewpoint")
_PLACE: dict[str, Any] = {"low": -MAX_LENGTH, "high": MAX_LENGTH}
_SIZE: dict[str, Any] = {"low": MIN_LENGTH, "high": MAX_LENGTH}
_POINTS = "[[0, 0], [60, 120], [180, 120], [240, 0]]"

_PROCESS = Key(choice, "Process", f'"{STANDOFFS}"', choices=tuple(PROCESSES))
# Inputs of a hinge, with the paper's names. The object says what makes no hinge, and the cure.
_HINGE = {
    "hinge_type": Key(choice, "HingeType", '"Rotational"', choices=tuple(HINGE_KINDS)),
    "pivot": Key(choice, "Pivot", '"Cone"', choices=("Cone", "Pin")),
    "cone_angle": Key(angle, "ConeAngle", "55", 0, 90),
    "segmentations": Key(whole, "Segmentations", "7", 1, 99),
    "segment_width": Key(length, "SegmentWidth", "5", 0, 100),
    "gap_length": Key(length, "GapLength", "0.4", 0, 100),
    "gap_between_planes": Key(length, "GapBetweenPlanes", "0.6", 0, 100),
    "face_thickness": Key(length, "FaceThickness", "1.2", 0, 100),
    "layer_height": Key(length, "LayerHeight", "0.2", 0, 10),
    "nozzle_diameter": Key(length, "NozzleDiameter", "0.4", 0, 10),
}
_OF_PLATE = (
    "pivot", "cone_angle", "segment_width", "gap_between_planes", "face_thickness", "layer_height",
    "nozzle_diameter",
)  # fmt: skip
TEST_PRINTS = ("coupon", "calibration")  # tables of prints that are no tubes
PRINTS = ("hinges", *TEST_PRINTS)

PRINT_FORMATS = named(SOLIDS)  # of a print or a coupon, not of zero-thickness faces
NET_FORMATS = named(NETS)  # of the panels without thickness, in all states at once
STATES = ("flat", "deployed")  # as in exporters.bodies

TABLES = {
    "design": {
        "name": Key(text, "", '"Garden arch"'),
        "description": Key(text, "", '"An arch of 20 units"'),
        "make_printable": Key(flag, "", "false"),
        "snap_margin": Key(number, "", "1.2", 0.1, 10),
    },
    "curve": {
        "kind": Key(choice, "Kind", '"Automatic"', choices=(AUTOMATIC, *FAMILIES)),
        "corner_radius": Key(length, "CornerRadius", "20", 0, MAX_LENGTH),
        "points": Key(points, "Points", _POINTS, **_PLACE),
        "source": Key(text, "", '"curve.step"'),
        "number": Key(whole, "", "1", 1, 10_000),
        "layer": Key(text, "", '"Rail"'),
        "scale": Key(number, "", "25.4", 1e-6, 1e6),
        "join": Key(length, "", "0.01", 0, 1000),
        "sphere_radius": Key(length, "SphereRadius", "150", **_SIZE),
        "sphere_center": Key(vector, "SphereCenter", "[0, 0, 0]", **_PLACE),
        "omega": Key(angle, "Omega", "0", 0, 90),
        "omega_edge_length": Key(length, "OmegaEdgeLength", "60", **_SIZE),
        "ruling_kind": Key(choice, "RulingKind", '"Automatic"', choices=RULING_KINDS),
        "ruling": Key(vector, "Ruling", "[0, 0, 1]", **_PLACE),
    },
    "triangles": {
        "edge_length": Key(length, "EdgeLength", "60", **_SIZE),
        "gamma": Key(angle, "Gamma", "20", 0, 90),
        "thickness": Key(length, "Thickness", "0", 0, MAX_LENGTH),
        "flip_side": Key(flag, "FlipSide", "false"),
        "level": Key(flag, "Level", "false"),
        "placement_rule": Key(choice, "PlacementRule", '"EndFit"', choices=PLACEMENT_RULES),
        "tolerance": Key(length, "Tolerance", "0.4", 0, MAX_LENGTH),
        "symmetric": Key(flag, "Symmetric", "false"),
        "start_direction": Key(choice, "StartDirection", '"Free"', choices=("Free", "Square")),
        "end_direction": Key(choice, "EndDirection", '"Free"', choices=("Free", "Square")),
    },
    "unit": {
        "ratio_rule": Key(choice, "RatioRule", '"Adaptive"', choices=RATIO_RULES),
        "ratio": Key(number, "Ratio", "0.5", 0, 1),
        "ratio_share": Key(number, "RatioShare", "0.1", 0, 1),
        "target_margin": Key(number, "TargetMargin", "1.8", 0, 100),
        "unit_margins": Key(numbers, "UnitMargins", "[1.8, 2.1]", 0, 100),
        "margin_measure": Key(choice, "MarginMeasure", '"Contact"', choices=("Contact", "Crease")),
        "hinge_play": Key(length, "HingePlay", "0.28", 0, 100),
        "strain_limit": Key(number, "StrainLimit", "0.02", 0, 1),
        "target_barrier": Key(number, "TargetBarrier", "0.00001", 0, 1),
        "height_ratio": Key(number, "HeightRatio", "2.5", 0.01, 1000),
        "deployment": Key(number, "Deployment", "1", 0, 1),
        "theta": Key(angle, "Theta", "45", 0, 180),
        "edge_length": Key(length, "EdgeLength", "60", **_SIZE),
        "thickness": Key(length, "Thickness", "1.8", 0, MAX_LENGTH),
        "omega": Key(angle, "Omega", "90", 0, 90),
    },
    "hinges": {
        "process": _PROCESS,  # before what it sets
        "preset": Key(choice, "", '"Recommended"', choices=tuple(PRESETS)),
        **_HINGE,
        "standoff_spacing": Key(length, "StandOffSpacing", "8", 0, 100),
        "standoff_width": Key(length, "StandOffWidth", "0", 0, 10),
        "air_layers": Key(whole, "AirLayers", "0", 0, 100),
        "standoff_rim": Key(flag, "StandOffRim", "true"),
        "pillars": Key(flag, "Pillars", "true"),
        "compensate": Key(flag, "Compensate", "true"),
        "preload": Key(number, "Preload", "0", 0, 1.5),
        "preload_rule": Key(choice, "PreloadRule", '"Automatic"', choices=("Automatic", "Given")),
        "orientation": Key(choice, "Orientation", '"Flat"', choices=("Flat", "OnEdge")),
        "bed": Key(vector, "Bed", "[250, 210, 210]", 0, MAX_LENGTH),
        "first_unit": Key(whole, "FirstUnit", "1", 1, 10_000),
        "last_unit": Key(whole, "LastUnit", "0", 0, 10_000),
        "support": Key(flag, "Support", "false"),
        "joint": Key(choice, "Joint", '"Dowel"', choices=JOINT_KINDS),
        "dowel_diameter": Key(length, "DowelDiameter", "1.75", 0, 100),
        "magnet_diameter": Key(length, "MagnetDiameter", "5", 0, 100),
        "magnet_depth": Key(length, "MagnetDepth", "1", 0, 100),
        "screw_diameter": Key(length, "ScrewDiameter", "3", 0, 100),
        "start_part": Key(choice, "StartPart", '"Plain"', choices=END_KINDS),
        "end_part": Key(choice, "EndPart", '"Flange"', choices=END_KINDS),
        "plate_thickness": Key(length, "PlateThickness", "0", 0, 1000),
        "foot_point": Key(vector, "FootPoint", "[0, 0, 0]", **_PLACE),
        "foot_normal": Key(vector, "FootNormal", "[0, 0, 1]", **_PLACE),
        "deployment": Key(number, "Deployment", "0", 0, 1),
    },
    "coupon": {
        "kind": Key(choice, "Kind", '"Dihedral"', choices=COUPON_KINDS),
        "process": _PROCESS,
        "preset": Key(choice, "Preset", '"Hinge4"', choices=tuple(PRESETS)),
        "length_x": Key(length, "LengthX", "45", **_SIZE),
        "length_y": Key(length, "LengthY", "36", **_SIZE),
        **_HINGE,
        "rotation_angle": Key(angle, "RotationAngle", "0", 0, 180),
    },
    "calibration": {
        "process": _PROCESS,
        "least": Key(length, "Least", "0.2", 0, 5),
        "step": Key(length, "Step", "0.05", 0, 1),
        "count": Key(whole, "Count", "7", 1, 99),
        **{key: _HINGE[key] for key in _OF_PLATE},
    },
    "output": {
        "formats": Key(choices, "", '["stl", "3mf"]', choices=named()),
        "states": Key(choices, "", '["flat", "deployed"]', choices=STATES),
        "print_states": Key(choices, "", '["flat", "deployed"]', choices=STATES),
        "sheet": Key(choice, "", '"A4"', choices=("A4", "A3", "A2", "A1", "A0")),
        "tabs": Key(flag, "", "false"),
        "tab_depth": Key(length, "", "6", 0.5, 100),
        "panel_thickness": Key(length, "", "18", 0.1, 1000),
        "panel_hinge": Key(choice, "", '"Piano"', choices=tuple(PANEL_HINGES)),
        "stock": Key(text, "", '"2500x1250"'),
        "kerf": Key(length, "", "0.2", 0, 1000),
        "edge_gap": Key(length, "", "0.5", 0, 1000),
        "deployment_frames": Key(whole, "", "20", 0, 1000),
        "pictures": Key(flag, "", "true"),
        "report": Key(flag, "", "true"),
        "slicer": Key(flag, "", "false"),
        "openscad": Key(flag, "", "false"),
        "parts": Key(flag, "", "false"),
    },
}

# Keys of [unit] for one unit by itself; a tube has these from its curve and triangles.
SINGLE_UNIT = ("theta", "edge_length", "omega", "thickness")
# Keys of [curve] that choose in a file: as of `imports.import_curve`.
OF_SOURCE = ("number", "layer", "scale", "join")
# Keys of [unit] that only one ratio_rule uses.
RULE_OF = {
    "ratio": "Fixed",
    "ratio_share": "Adaptive",
    **dict.fromkeys(
        (
            "target_margin",
            "unit_margins",
            "margin_measure",
            "hinge_play",
            "strain_limit",
            "target_barrier",
        ),
        "TargetSnap",
    ),
}
# Keys that make_printable chooses.
CHOSEN = {
    "triangles": tuple(TABLES["triangles"]),
    "unit": tuple(key for key in TABLES["unit"] if key != "deployment"),
    "hinges": ("first_unit", "last_unit", "compensate"),
}
# Keys of [output] that only some formats use.
FORMATS_OF = {key: formats_with(key) for key in TABLES["output"] if formats_with(key)}


def example_of(table: str, key: Any) -> Any:
    """How a key may be written."""
    return TABLES[table][key].example


def key_of_property(table: str, name: str) -> Any:
    """The key of ``[table]`` that sets the property ``name``, or None."""
    return next((key for key, entry in TABLES[table].items() if entry.property == name), None)
