# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of a printed hinge, by the paper's names, and what can be wrong with them.

Section 5 of the paper (Tables 1 and 2) and ``hinges.md`` 2 and 6. Lengths in mm, angles in radians.
Messages name properties as the document shows them (FaceThickness, GapLength, …).
"""

from dataclasses import dataclass, replace
from math import ceil, cos, degrees, floor, isfinite, pi, radians, tan

ROTATIONAL, FLEXIBLE = "Rotational", "Flexible"
CONE, PIN = "Cone", "Pin"

# A cone is this many gap lengths high where the segment has room, and never less than the second
# number: at 2 the far cone disengages when the knuckles are pushed to one side (hinges.md 2).
CONE_HEIGHT_IN_GAPS = (3.0, 2.1)
# Share of the barrel's radius, less the clearance, that a pin takes; the ring's wall has the rest.
PIN_SHARE = 0.6
MINIMUM_SEGMENTS = 3


@dataclass(frozen=True)
class HingeParameters:
    """How hinges are made (mm, radians).

    ``segmentations``: odd number of knuckles along a hinge; ``gap_length``: axial gap between
    knuckles and clearance around barrels; ``gap_between_planes`` g and ``face_thickness`` t give
    the pitch p = t + g; ``rotation_angle``: the angle at which a dihedral is printed (0: folded
    flat); ``cone_angle``: of the cone's surface against its base, 45°…60°;
    ``bond_width``: how far the fingers of a flexible hinge reach into the panel.
    """

    hinge_type: str = ROTATIONAL
    pivot: str = CONE
    segmentations: int = 7
    gap_length: float = 0.4
    gap_between_planes: float = 0.6
    face_thickness: float = 1.2
    layer_height: float = 0.2
    nozzle_diameter: float = 0.4
    cone_angle: float = radians(55)
    rotation_angle: float = 0.0
    bond_width: float = 3.0

    @property
    def pitch(self):
        """Distance p = t + g between mid-planes of stacked panels (mm)."""
        return self.face_thickness + self.gap_between_planes

    @property
    def radius(self):
        """Radius of every barrel, t + g/2 (mm)."""
        return self.face_thickness + self.gap_between_planes / 2

    @property
    def cut_back(self):
        """Distance from an axis at which panels end: barrel radius + clearance (mm).

        Flexible: half the strip's wall, a beam as wide as the wall is thick, and the clearance.
        """
        if self.hinge_type == FLEXIBLE:
            return 1.5 * self.strip_thickness + self.gap_length
        return self.radius + self.gap_length

    @property
    def strip_thickness(self):
        """Thickness of a flexible hinge's wall: two nozzle widths (mm)."""
        return 2 * self.nozzle_diameter

    @property
    def cone_base(self):
        """Radius of a cone's base: the recess leaves a wall of one nozzle diameter (mm)."""
        return self.radius - self.nozzle_diameter

    def tip_radius(self, cone_height):
        """Radius of the blunt tip of a cone ``cone_height`` mm high (mm)."""
        return self.cone_base - cone_height / tan(self.cone_angle)

    @property
    def cone_tip(self):
        """Smallest radius of a cone's blunt tip (mm)."""
        return self.nozzle_diameter / 4

    @property
    def full_cone_height(self):
        """Height of the largest cone that the barrel holds, at most three gap lengths (mm)."""
        by_radius = (self.cone_base - self.cone_tip) * tan(self.cone_angle)
        return min(by_radius, CONE_HEIGHT_IN_GAPS[0] * self.gap_length)

    @property
    def pin_radius(self):
        """Radius of a continuous pin (mm)."""
        return PIN_SHARE * (self.radius - self.gap_length)

    @property
    def shortest_segment(self):
        """Smallest axial length of one knuckle: its recess and a floor of one nozzle (mm)."""
        if self.pivot == PIN:
            return 2 * self.nozzle_diameter
        return CONE_HEIGHT_IN_GAPS[1] * self.gap_length + self.nozzle_diameter

    @property
    def smallest_clearance(self):
        """Smallest distance asked for between two moving bodies in the flat state (mm).

        Cones nearer to each other than their axial gap: ga cos θ (``hinges.md`` 2).
        """
        least = min(self.gap_length, self.gap_between_planes)
        if self.hinge_type == ROTATIONAL and self.pivot == CONE:
            least = min(least, self.gap_length * cos(self.cone_angle))
        return least

    @property
    def play(self):
        """Radial play of one hinge (mm): ga / tan θ for cones, ga for a pin, none if flexible."""
        if self.hinge_type == FLEXIBLE:
            return 0.0
        return self.gap_length / tan(self.cone_angle) if self.pivot == CONE else self.gap_length

    def check(self):
        """Raise ValueError, one sentence with the cure, where no hinge can be made."""
        _check_numbers(self)
        if self.hinge_type == ROTATIONAL:
            _check_rotational(self)
            _check_pivot(self)

    def warnings(self):
        """Sentences on what will print less well than it could (a list, empty if all is well)."""
        return [*_layer_warnings(self), *_cone_warnings(self)]


def segments_for(length, parameters):
    """Largest odd number of segments, at most Segmentations, that fits ``length`` mm (0: none)."""
    gap, least = parameters.gap_length, parameters.shortest_segment
    fitting = floor((length + gap) / (least + gap) + 1e-9)
    fitting -= 1 - fitting % 2
    return max(0, min(fitting, parameters.segmentations))


def cone_height_for(segment, parameters):
    """Height (mm) of the cones of a hinge whose segments are ``segment`` mm long."""
    lowest = CONE_HEIGHT_IN_GAPS[1] * parameters.gap_length
    room = max(segment - parameters.nozzle_diameter, lowest)
    return min(parameters.full_cone_height, room)


def _check_numbers(p):
    positive = {
        "GapLength": p.gap_length,
        "FaceThickness": p.face_thickness,
        "LayerHeight": p.layer_height,
        "NozzleDiameter": p.nozzle_diameter,
        "BondWidth": p.bond_width,
    }
    for name, value in positive.items():
        if not (isfinite(value) and value > 0):
            raise ValueError(f"{name} is {value:.6g} mm: set it to a length above 0.")
    if not (isfinite(p.gap_between_planes) and p.gap_between_planes >= 0):
        raise ValueError(
            f"GapBetweenPlanes is {p.gap_between_planes:.6g} mm: set it to 0.6 mm or more."
        )
    if p.hinge_type not in (ROTATIONAL, FLEXIBLE):
        raise ValueError(f"HingeType {p.hinge_type!r} is unknown: use Rotational or Flexible.")
    if p.pivot not in (CONE, PIN):
        raise ValueError(f"Pivot {p.pivot!r} is unknown: use Cone or Pin.")
    if not 0 <= p.rotation_angle < pi:
        raise ValueError(
            f"RotationAngle is {degrees(p.rotation_angle):.6g}°: set it between 0° and 180°."
        )


def _check_rotational(p):
    n = p.segmentations
    if n < MINIMUM_SEGMENTS or n % 2 == 0:
        raise ValueError(
            f"Segmentations is {n}: knuckles alternate, so set it to an odd number, "
            f"{max(MINIMUM_SEGMENTS, n + 1 - n % 2)} for example."
        )
    if p.gap_length < p.layer_height:
        raise ValueError(
            f"GapLength {p.gap_length:.4g} mm is below the layer height: the printer closes it; "
            f"set GapLength to {p.layer_height:.4g} mm or more, or LayerHeight to "
            f"{p.gap_length:.4g} mm or less."
        )
    if p.rotation_angle == 0 and p.gap_between_planes < p.layer_height:
        raise ValueError(
            f"GapBetweenPlanes {p.gap_between_planes:.4g} mm is below the layer height: stacked "
            f"panels would fuse; set GapBetweenPlanes to {p.layer_height:.4g} mm or more."
        )


def _check_pivot(p):
    if p.pivot == PIN:
        _check_pin(p)
        return
    if not radians(44.999) <= p.cone_angle <= radians(60.001):
        raise ValueError(
            f"ConeAngle is {degrees(p.cone_angle):.4g}°: set it between 45° and 60°, so that "
            "cones print without support."
        )
    least = CONE_HEIGHT_IN_GAPS[1] * p.gap_length
    if p.full_cone_height < least - 1e-9:
        radius = least / tan(p.cone_angle) + p.nozzle_diameter + p.cone_tip
        raise ValueError(
            f"Every hinge: cones are {max(p.full_cone_height, 0):.3g} mm high and must exceed two "
            f"gap lengths, or they disengage; set FaceThickness to "
            f"{_thicker(radius, p):.4g} mm or more{_steeper(p)}."
        )


def _steeper(p):
    steep = replace(p, cone_angle=radians(60))
    least = CONE_HEIGHT_IN_GAPS[1] * p.gap_length
    return ", or ConeAngle to 60°" if steep.full_cone_height >= least else ""


def _check_pin(p):
    room = p.radius - p.gap_length
    wall, pin = (1 - PIN_SHARE) * room, 2 * PIN_SHARE * room
    needed = p.nozzle_diameter * max(1 / PIN_SHARE, 1 / (1 - PIN_SHARE)) + p.gap_length
    cure = f"set FaceThickness to {_thicker(needed, p):.4g} mm or more, or Pivot to Cone"
    if pin < 2 * p.nozzle_diameter - 1e-9:
        raise ValueError(
            f"Every hinge: the pin is {max(pin, 0):.3g} mm thick, less than two nozzle widths; "
            f"{cure}."
        )
    if wall < p.nozzle_diameter - 1e-9:
        raise ValueError(
            f"Every hinge: the wall around the pin is {wall:.3g} mm thick, less than one nozzle "
            f"width; {cure}."
        )


def _thicker(radius, p):
    """Face thickness (mm), a multiple of the layer height, whose barrels have this radius."""
    return ceil((radius - p.gap_between_planes / 2) / p.layer_height - 1e-9) * p.layer_height


def _layer_warnings(p):
    found = []
    for name, value in (
        ("FaceThickness", p.face_thickness),
        ("GapBetweenPlanes", p.gap_between_planes),
    ):
        layers = value / p.layer_height
        if abs(layers - round(layers)) < 1e-6:
            continue
        low, high = floor(layers) * p.layer_height, ceil(layers) * p.layer_height
        nearest = f"{low:.4g} or {high:.4g}" if low > 0 else f"{high:.4g}"
        found.append(
            f"{name} {value:.4g} mm is not a multiple of the layer height {p.layer_height:.4g} mm, "
            f"so panels slice to different thicknesses: use {nearest} mm."
        )
    return found


def _cone_warnings(p):
    if p.hinge_type != ROTATIONAL or p.pivot != CONE:
        return []
    clearance = p.gap_length * cos(p.cone_angle)
    if clearance >= p.layer_height - 1e-9:
        return []
    return [
        f"Cones are {clearance:.3g} mm apart, less than a layer of {p.layer_height:.4g} mm: raise "
        f"GapLength to {ceil(p.layer_height / cos(p.cone_angle) * 20 - 1e-9) / 20:.4g} mm or lower "
        "ConeAngle towards 45°."
    ]


@dataclass(frozen=True)
class Preset:
    """One column of the paper's Tables 1 and 2 (``table``; 0: Hinge6, which has no column).

    ``given``: the cells that are readable (parameter name → value; mm, radians); ``size``: printed
    length x, y, z (mm; None where unreadable); ``doubtful``: cells that the paper's text does not
    settle, never filled in by us; ``worked``: True, False (failed) or None (not said).
    """

    table: int
    given: dict
    size: tuple
    doubtful: tuple = ()
    worked: bool | None = None

    def parameters(self, base=None):
        """`HingeParameters` with this column's cells; unreadable cells keep those of ``base``."""
        return replace(base or HingeParameters(), **self.given)


def _given(angle, segments, gap, between, thickness, profile):
    cells = {
        "rotation_angle": None if angle is None else radians(angle),
        "segmentations": segments,
        "gap_length": gap,
        "gap_between_planes": between,
        "face_thickness": thickness,
        "layer_height": profile,
    }
    return {name: value for name, value in cells.items() if value is not None}


PRESETS = {
    "Hinge1": Preset(
        1, _given(0, 3, None, 3, 1.5, 0.3), (45, 36, 6), ("gap_length", "face_thickness")
    ),
    "Hinge2": Preset(
        1, _given(8, 5, 0.6, 0, None, 0.2), (45, 36, 7), ("face_thickness",)
    ),
    "Hinge3": Preset(1, _given(0, 5, 0.2, 1.2, 0.8, 0.3), (45, 36, None), ("length_z",)),
    "Hinge4": Preset(1, _given(0, 7, 0.4, 0.8, 0.8, 0.3), (45, 36, 2.4), (), True),
    "Hinge5": Preset(1, _given(5, 7, 0.4, 0, 0.6, 0.3), (45, 36, 4)),
    "Hinge6": Preset(
        0, {"hinge_type": FLEXIBLE}, (None, None, None),
        ("gap_between_planes", "face_thickness", "layer_height"),
    ),
    # Table 1 recommends "> 5" segments: 7 is the fewest; Table 2's cell is printed as a fraction.
    "Recommended": Preset(
        1, _given(0, 7, 0.4, 0.8, 0.8, None), (45, 36, None), ("segmentations",), True
    ),
    "Hinge7": Preset(
        2, _given(None, 5, None, 0.4, 0.8, None), (30, 25, None),
        ("rotation_angle", "gap_length", "length_z"), False,
    ),
    "Hinge8": Preset(
        2, _given(None, 5, None, 0.8, 0.8, None), (20, 36, 5.6), ("rotation_angle", "gap_length"),
        False,
    ),
    "Hinge9": Preset(
        2, _given(None, 5, None, 0.6, 1.2, None), (50, 32, 6.6),
        ("rotation_angle", "gap_length", "face_thickness"), True,
    ),
    "RecommendedVertex": Preset(
        2, _given(0, 5, None, 0.6, 1.2, None), (50, 32, None), ("segmentations", "gap_length"),
        True,
    ),
}  # fmt: skip
