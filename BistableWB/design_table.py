# SPDX-License-Identifier: LGPL-2.1-or-later
"""The keys of a design file: one table. To add a key, add a line here.

A key has a kind (a function that checks and returns its value), the property of the document object
that it sets (empty: it sets none), and limits, beyond which a value is a slip of the pen.
"""

import itertools
import math
from typing import Any, NamedTuple

from .origami.hinge_parameters import PRESETS

MAX_POINTS = 200
MAX_LENGTH = 100_000.0  # mm
MIN_LENGTH = 0.1


class BadValue(Exception):
    """Why a value cannot be: what follows the name of its key in a sentence."""


class Key(NamedTuple):
    """One key of a table; ``example`` is how it may be written."""

    kind: Any
    property: str
    example: str
    low: float = -math.inf
    high: float = math.inf
    choices: tuple = ()


def number(value, key, what="a number"):
    """A finite number within the key's limits."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise BadValue(f" is {_shown(value)}; give it {what}, for example {key.example}")
    if not math.isfinite(value):
        raise BadValue(f" is {value}; give it a finite number, for example {key.example}")
    if not key.low <= value <= key.high:
        raise BadValue(
            f" is {_shown(value)}; it must lie between {key.low:g} and {key.high:g}, for example "
            f"{key.example}"
        )
    return float(value)


def length(value, key):
    """A length in mm."""
    return number(value, key, "a length in mm as a number")


def angle(value, key):
    """An angle in degrees."""
    return number(value, key, "an angle in degrees as a number")


def whole(value, key):
    """A whole number."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise BadValue(f" is {_shown(value)}; give it a whole number, for example {key.example}")
    return int(number(value, key))


def flag(value, key):
    """True or false."""
    if not isinstance(value, bool):
        raise BadValue(f" is {_shown(value)}; set it to true or false")
    return value


def text(value, key):
    """A short text on one line."""
    if not isinstance(value, str) or not value.strip():
        raise BadValue(f" is {_shown(value)}; give it a text in quotes, for example {key.example}")
    if len(value) > 400 or not value.isprintable():
        raise BadValue(" is too long or has characters that do not print; give it one short line")
    return value.strip()


def choice(value, key):
    """One of the key's choices, whatever the case of its letters."""
    for known in key.choices:
        if isinstance(value, str) and value.lower() == known.lower():
            return known
    raise BadValue(f" is {_shown(value)}; choose one of {', '.join(key.choices)}")


def choices(value, key):
    """A list of the key's choices, each once, in the order of the table."""
    if not isinstance(value, list):
        raise BadValue(f" is {_shown(value)}; give it a list, for example {key.example}")
    wanted = {choice(item, key) for item in value}
    return [known for known in key.choices if known in wanted]


def vector(value, key):
    """Three coordinates in mm."""
    if not isinstance(value, list) or len(value) != 3:
        raise BadValue(f" is {_shown(value)}; give it three numbers in mm: {key.example}")
    return [length(x, key) for x in value]


def points(value, key):
    """Control points: lists of two or three coordinates in mm."""
    if not isinstance(value, list) or len(value) < 2:
        raise BadValue(f" is {_shown(value)}; give it two or more points: {key.example}")
    if len(value) > MAX_POINTS:
        raise BadValue(
            f" has {len(value)} control points; a Bézier curve is steered by a few, give it "
            f"{MAX_POINTS} at most"
        )
    found = []
    for index, point in enumerate(value, 1):
        if not isinstance(point, list) or len(point) not in (2, 3):
            raise BadValue(
                f", point {index}, is {_shown(point)}; give it two or three numbers in mm, as in "
                f"{key.example}"
            )
        try:
            coordinates = [length(x, key) for x in point]
        except BadValue as problem:
            raise BadValue(f", point {index}, has a coordinate that{problem}") from None
        found.append([*coordinates, 0.0][:3])
    for index, (one, two) in enumerate(itertools.pairwise(found), 1):
        if one == two:
            raise BadValue(f", points {index} and {index + 1}, coincide; move or remove one")
    return found


def _shown(value):
    """A value as it may stand in a sentence: short, and with its type where that is the trouble."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return f"{value:g}"
    if isinstance(value, int):
        return f"{value}" if abs(value) < 10**12 else "a number of very many digits"
    if isinstance(value, str):
        return f'the text "{value[:30]}{"…" if len(value) > 30 else ""}"'
    if isinstance(value, list):
        return f"a list of {len(value)}" if value else "an empty list"
    return "a table" if isinstance(value, dict) else "a date or time"


# As in origami.ratios, which needs numpy: a design is read before that is there.
RATIO_RULES = ("Adaptive", "Fixed", "Exact", "Paper", "TargetSnap")
COUPON_KINDS = ("Dihedral", "Vertex", "NonDevelopableVertex")  # as in solids.coupons
RULING_KINDS = ("Automatic", "Direction", "Viewpoint")
_PLACE = {"low": -MAX_LENGTH, "high": MAX_LENGTH}
_SIZE = {"low": MIN_LENGTH, "high": MAX_LENGTH}
_POINTS = "[[0, 0], [60, 120], [180, 120], [240, 0]]"

# Inputs of a hinge, with the paper's names. The object says what makes no hinge, and the cure.
_HINGE = {
    "hinge_type": Key(choice, "HingeType", '"Rotational"', choices=("Rotational", "Flexible")),
    "pivot": Key(choice, "Pivot", '"Cone"', choices=("Cone", "Pin")),
    "cone_angle": Key(angle, "ConeAngle", "55", 0, 90),
    "segmentations": Key(whole, "Segmentations", "7", 1, 99),
    "gap_length": Key(length, "GapLength", "0.4", 0, 100),
    "gap_between_planes": Key(length, "GapBetweenPlanes", "0.6", 0, 100),
    "face_thickness": Key(length, "FaceThickness", "1.2", 0, 100),
    "layer_height": Key(length, "LayerHeight", "0.2", 0, 10),
    "nozzle_diameter": Key(length, "NozzleDiameter", "0.4", 0, 10),
}

PRINT_FORMATS = ("stl", "3mf", "scad")  # of a print or a coupon, not of zero-thickness faces
NET_FORMATS = ("fold", "svg", "dxf")  # of the panels without thickness, in all states at once
FORMATS = ("step", "obj", *PRINT_FORMATS, *NET_FORMATS)
STATES = ("flat", "deployed")  # as in exporters.bodies

TABLES = {
    "design": {
        "name": Key(text, "", '"Garden arch"'),
        "description": Key(text, "", '"An arch of 20 units"'),
    },
    "curve": {
        "kind": Key(choice, "Kind", '"Plane"', choices=("Plane", "Sphere", "General")),
        "points": Key(points, "Points", _POINTS, **_PLACE),
        "source": Key(text, "", '"curve.step"'),
        "sphere_radius": Key(length, "SphereRadius", "150", **_SIZE),
        "sphere_center": Key(vector, "SphereCenter", "[0, 0, 0]", **_PLACE),
        "ruling_kind": Key(choice, "RulingKind", '"Automatic"', choices=RULING_KINDS),
        "ruling": Key(vector, "Ruling", "[0, 0, 1]", **_PLACE),
    },
    "triangles": {
        "edge_length": Key(length, "EdgeLength", "60", **_SIZE),
        "gamma": Key(angle, "Gamma", "20", 0, 90),
        "thickness": Key(length, "Thickness", "0", 0, MAX_LENGTH),
        "flip_side": Key(flag, "FlipSide", "false"),
        "level": Key(flag, "Level", "false"),
    },
    "unit": {
        "ratio_rule": Key(choice, "RatioRule", '"Adaptive"', choices=RATIO_RULES),
        "ratio": Key(number, "Ratio", "0.5", 0, 1),
        "ratio_share": Key(number, "RatioShare", "0.1", 0, 1),
        "target_margin": Key(number, "TargetMargin", "1.5", 0, 100),
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
        "preset": Key(choice, "", '"Recommended"', choices=tuple(PRESETS)),
        **_HINGE,
        "compensate": Key(flag, "Compensate", "true"),
        "orientation": Key(choice, "Orientation", '"Flat"', choices=("Flat", "OnEdge")),
        "bed": Key(vector, "Bed", "[250, 210, 210]", 0, MAX_LENGTH),
        "first_unit": Key(whole, "FirstUnit", "1", 1, 10_000),
        "last_unit": Key(whole, "LastUnit", "0", 0, 10_000),
        "support": Key(flag, "Support", "false"),
        "deployment": Key(number, "Deployment", "0", 0, 1),
    },
    "coupon": {
        "kind": Key(choice, "Kind", '"Dihedral"', choices=COUPON_KINDS),
        "preset": Key(choice, "Preset", '"Hinge4"', choices=tuple(PRESETS)),
        "length_x": Key(length, "LengthX", "45", **_SIZE),
        "length_y": Key(length, "LengthY", "36", **_SIZE),
        **_HINGE,
        "rotation_angle": Key(angle, "RotationAngle", "0", 0, 180),
    },
    "output": {
        "formats": Key(choices, "", '["stl", "3mf"]', choices=FORMATS),
        "states": Key(choices, "", '["flat", "deployed"]', choices=STATES),
        "print_states": Key(choices, "", '["flat", "deployed"]', choices=STATES),
        "sheet": Key(choice, "", '"A4"', choices=("A4", "A3", "A2", "A1", "A0")),
        "tabs": Key(flag, "", "false"),
        "tab_depth": Key(length, "", "6", 0.5, 100),
        "deployment_frames": Key(whole, "", "20", 0, 1000),
        "pictures": Key(flag, "", "true"),
        "report": Key(flag, "", "true"),
        "slicer": Key(flag, "", "false"),
        "openscad": Key(flag, "", "false"),
    },
}

# Keys of [unit] for one unit by itself; a tube has these from its curve and triangles.
SINGLE_UNIT = ("theta", "edge_length", "omega", "thickness")
# Keys of [unit] that only one ratio_rule uses.
RULE_OF = {
    "ratio": "Fixed",
    "ratio_share": "Adaptive",
    **dict.fromkeys(
        ("target_margin", "hinge_play", "strain_limit", "target_barrier"), "TargetSnap"
    ),
}
# Keys of [output] that only some formats use.
FORMATS_OF = {
    **dict.fromkeys(("sheet", "tabs", "tab_depth"), ("svg", "dxf")),
    "deployment_frames": ("fold",),
}


def example_of(table, key):
    """How a key may be written."""
    return TABLES[table][key].example


def key_of_property(table, name):
    """The key of ``[table]`` that sets the property ``name``, or None."""
    return next((key for key, entry in TABLES[table].items() if entry.property == name), None)
