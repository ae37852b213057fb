# SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters of a printed hinge, by the paper's names, and what can be wrong with them.

Section 5 of the paper (Tables 1 and 2) and hinges.md 2 and 6. Lengths in mm, angles in radians.
Messages name properties as the document shows them (FaceThickness, GapLength, …).
"""

from dataclasses import dataclass, replace
from math import ceil, cos, degrees, floor, isfinite, pi, radians, tan
from typing import TYPE_CHECKING

from ..errors import Choice, Refusal, name_of, phrase
from .kinds import FLEXIBLE as FLEXIBLE  # its home is there
from .kinds import HINGE_KINDS, ROTATIONAL
from .processes import BY_STANDOFFS, BY_TIES, PROCESSES, SOLUBLE
from .standoff_inputs import StandOffs, check_standoffs

if TYPE_CHECKING:
    from ..errors import Phrase

CONE, PIN = "Cone", "Pin"

# A cone is this many gap lengths high where the segment has room, and never less than the second
# number: at 2 the far cone disengages when the knuckles are pushed to one side (hinges.md 2).
CONE_HEIGHT_IN_GAPS = (3.0, 2.1)
# Share of the barrel's radius, less the clearance, that a pin takes; the ring's wall has the rest.
PIN_SHARE = 0.6
MINIMUM_SEGMENTS = 3
# Wanted width of the knuckles of a new hinge set (mm): about four barrel radii.
SEGMENT_WIDTH = 5.0


@dataclass(frozen=True)
class HingeParameters:
    """How hinges are made (mm, radians).

    ``segmentations``: odd number of knuckles along a hinge, or instead ``segment_width``: how wide
    they should be, with short ones at both ends (0: by their number); ``gap_length``: axial gap
    between knuckles and clearance around barrels; ``gap_between_planes`` g and ``face_thickness``
    t give the pitch p = t + g; ``rotation_angle``: the angle at which a dihedral is printed (0:
    folded flat); ``cone_angle``: of the cone's surface against its base, 45°…60°;
    ``bond_width``: how far the fingers of a flexible hinge reach into the panel; ``process``: a
    name of `PROCESSES`.
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
    segment_width: float = 0.0
    process: str = SOLUBLE
    standoffs: StandOffs | None = None

    @property
    def has_knuckles(self) -> bool:
        """Whether the hinges turn on knuckles, with play, or bend."""
        return HINGE_KINDS[self.hinge_type].knuckles

    @property
    def is_tied(self) -> bool:
        """Whether ties hold what begins in mid-air when it is printed on edge."""
        return PROCESSES[self.process].held == BY_TIES and self.has_knuckles

    @property
    def has_pillars(self) -> bool:
        """Whether loose pillars hold, in the flat print, what no stand-off can."""
        return self.standoffs is not None and self.standoffs.pillars and self.has_knuckles

    @property
    def pitch(self) -> float:
        """Distance p = t + g between mid-planes of stacked panels (mm)."""
        return self.face_thickness + self.gap_between_planes

    @property
    def radius(self) -> float:
        """Radius of every barrel, t + g/2 (mm)."""
        return self.face_thickness + self.gap_between_planes / 2

    @property
    def cut_back(self) -> float:
        """Distance from an axis at which panels end: barrel radius + clearance (mm).

        Flexible: half the strip's wall, a beam as wide as the wall is thick, and the clearance.
        """
        if not self.has_knuckles:
            return 1.5 * self.strip_thickness + self.gap_length
        return self.radius + self.gap_length

    @property
    def strip_thickness(self) -> float:
        """Thickness of a flexible hinge's wall: two nozzle widths (mm)."""
        return 2 * self.nozzle_diameter

    @property
    def cone_base(self) -> float:
        """Radius of a cone's base: the recess leaves a wall of one nozzle diameter (mm)."""
        return self.radius - self.nozzle_diameter

    def tip_radius(self, cone_height: float) -> float:
        """Radius of the blunt tip of a cone ``cone_height`` mm high (mm)."""
        return self.cone_base - cone_height / tan(self.cone_angle)

    @property
    def cone_tip(self) -> float:
        """Smallest radius of a cone's blunt tip (mm)."""
        return self.nozzle_diameter / 4

    @property
    def full_cone_height(self) -> float:
        """Height of the largest cone that the barrel holds, at most three gap lengths (mm)."""
        by_radius = (self.cone_base - self.cone_tip) * tan(self.cone_angle)
        return min(by_radius, CONE_HEIGHT_IN_GAPS[0] * self.gap_length)

    @property
    def pin_radius(self) -> float:
        """Radius of a continuous pin (mm)."""
        return PIN_SHARE * (self.radius - self.gap_length)

    @property
    def shortest_segment(self) -> float:
        """Smallest axial length of one knuckle: its recess and a floor of one nozzle (mm)."""
        if self.pivot == PIN:
            return 2 * self.nozzle_diameter
        return CONE_HEIGHT_IN_GAPS[1] * self.gap_length + self.nozzle_diameter

    @property
    def smallest_clearance(self) -> float:
        """Smallest distance asked for between two moving bodies in the flat state (mm).

        Cones nearer to each other than their axial gap: ga cos θ (docs/theory/hinges.md 2).
        """
        least = min(self.gap_length, self.gap_between_planes)
        if self.has_knuckles and self.pivot == CONE:
            least = min(least, self.gap_length * cos(self.cone_angle))
        if self.standoffs is not None:
            least = min(least, self.standoffs.air_layers * self.layer_height)
        return least

    @property
    def play(self) -> float:
        """Radial play of one hinge (mm): ga / tan θ for cones, ga for a pin, none if flexible."""
        if not self.has_knuckles:
            return 0.0
        return self.gap_length / tan(self.cone_angle) if self.pivot == CONE else self.gap_length

    def check(self) -> None:
        """Raise ValueError, one sentence with the cure, where no hinge can be made."""
        _check_numbers(self)
        _check_process(self)
        if self.has_knuckles:
            _check_rotational(self)
            _check_pivot(self)
            check_standoffs(self)

    def warnings(self) -> "list[Phrase]":
        """Sentences on what will print less well than it could (a list, empty if all is well)."""
        return [*_layer_warnings(self), *_cone_warnings(self), *_process_warnings(self)]


def _check_numbers(p: HingeParameters) -> None:
    positive = {
        "GapLength": p.gap_length,
        "FaceThickness": p.face_thickness,
        "LayerHeight": p.layer_height,
        "NozzleDiameter": p.nozzle_diameter,
        "BondWidth": p.bond_width,
    }
    for name, value in positive.items():
        if not (isfinite(value) and value > 0):
            raise Refusal(
                "{name} is {value:.6g} mm: set it to a length above 0.",
                parameter=name,
                name=name_of(name),
                value=value,
            )
    if not (isfinite(p.gap_between_planes) and p.gap_between_planes >= 0):
        raise Refusal(
            "{GapBetweenPlanes} is {gap_between_planes:.6g} mm: set it to 0.6 mm or more.",
            parameter="GapBetweenPlanes",
            gap_between_planes=p.gap_between_planes,
        )
    if p.hinge_type not in HINGE_KINDS:
        raise Refusal(
            "{HingeType} {hinge_type!r} is unknown: use {known}.",
            parameter="HingeType",
            hinge_type=p.hinge_type,
            known=" or ".join(HINGE_KINDS),
        )
    if p.pivot not in (CONE, PIN):
        raise Refusal(
            "{Pivot} {pivot!r} is unknown: use Cone or Pin.",
            parameter="Pivot",
            pivot=p.pivot,
        )
    if not 0 <= p.rotation_angle < pi:
        raise Refusal(
            "{RotationAngle} is {rotation_angle:.6g}°: set it between 0° and 180°.",
            parameter="RotationAngle",
            rotation_angle=degrees(p.rotation_angle),
        )


def _check_process(p: HingeParameters) -> None:
    if p.process not in PROCESSES:
        raise Refusal(
            "{Process} {process!r} is unknown: use {known}.",
            parameter="Process",
            process=p.process,
            known=" or ".join(PROCESSES),
        )
    least = PROCESSES[p.process].least
    for name, gap in (("GapLength", p.gap_length), ("GapBetweenPlanes", p.gap_between_planes)):
        if gap < least:
            raise Refusal(
                "{name} is {gap:.4g} mm, and {process} keeps no gap below {least:.4g} mm open: set "
                "{name} to {least:.4g} mm or more, or choose another {Process}.",
                parameter=name,
                name=name_of(name),
                gap=gap,
                process=Choice(p.process),
                least=least,
            )


def _check_rotational(p: HingeParameters) -> None:
    n, width, least = p.segmentations, p.segment_width, p.shortest_segment
    if not (isfinite(width) and (width == 0 or width >= least)):
        raise Refusal(
            "{SegmentWidth} is {width:.6g} mm: set it to {least:.3g} mm or more, or to 0 to go by "
            "{Segmentations}.",
            parameter="SegmentWidth",
            width=width,
            least=ceil(10 * least) / 10,
        )
    if width == 0 and (n < MINIMUM_SEGMENTS or n % 2 == 0):
        raise Refusal(
            "{Segmentations} is {n}: knuckles alternate, so set it to an odd number, "
            "{odd} for example.",
            parameter="Segmentations",
            n=n,
            odd=max(MINIMUM_SEGMENTS, n + 1 - n % 2),
        )
    if p.gap_length < p.layer_height:
        raise Refusal(
            "{GapLength} {gap_length:.4g} mm is below the layer height: the printer closes it; "
            "set {GapLength} to {layer_height:.4g} mm or more, or {LayerHeight} to "
            "{gap_length:.4g} mm or less.",
            parameter="GapLength",
            gap_length=p.gap_length,
            layer_height=p.layer_height,
        )
    if p.rotation_angle == 0 and p.gap_between_planes < p.layer_height:
        raise Refusal(
            "{GapBetweenPlanes} {gap_between_planes:.4g} mm is below the layer height: stacked "
            "panels would fuse; set {GapBetweenPlanes} to {layer_height:.4g} mm or more.",
            parameter="GapBetweenPlanes",
            gap_between_planes=p.gap_between_planes,
            layer_height=p.layer_height,
        )


def _check_pivot(p: HingeParameters) -> None:
    if p.pivot == PIN:
        _check_pin(p)
        return
    if not radians(44.999) <= p.cone_angle <= radians(60.001):
        raise Refusal(
            "{ConeAngle} is {cone_angle:.4g}°: set it between 45° and 60°, so that cones print "
            "without support.",
            parameter="ConeAngle",
            cone_angle=degrees(p.cone_angle),
        )
    least = CONE_HEIGHT_IN_GAPS[1] * p.gap_length
    if p.full_cone_height < least - 1e-9:
        radius = least / tan(p.cone_angle) + p.nozzle_diameter + p.cone_tip
        raise Refusal(
            "Every hinge: cones are {height:.3g} mm high and must exceed two gap "
            "lengths, or they disengage; set {FaceThickness} to {thicker:.4g} mm or more{steeper}.",
            parameter="FaceThickness",
            height=max(p.full_cone_height, 0),
            thicker=_thicker(radius, p),
            steeper=_steeper(p),
        )


def _steeper(p: HingeParameters) -> "Phrase | str":
    steep = replace(p, cone_angle=radians(60))
    least = CONE_HEIGHT_IN_GAPS[1] * p.gap_length
    return phrase(", or {ConeAngle} to 60°") if steep.full_cone_height >= least else ""


_PIN_CURE = "set {FaceThickness} to {thicker:.4g} mm or more, or {Pivot} to Cone"


def _check_pin(p: HingeParameters) -> None:
    room = p.radius - p.gap_length
    wall, pin = (1 - PIN_SHARE) * room, 2 * PIN_SHARE * room
    needed = p.nozzle_diameter * max(1 / PIN_SHARE, 1 / (1 - PIN_SHARE)) + p.gap_length
    thicker = _thicker(needed, p)
    if pin < 2 * p.nozzle_diameter - 1e-9:
        raise Refusal(
            "Every hinge: the pin is {pin:.3g} mm thick, less than two nozzle widths.",
            cure=_PIN_CURE,
            parameter="FaceThickness",
            pin=max(pin, 0),
            thicker=thicker,
        )
    if wall < p.nozzle_diameter - 1e-9:
        raise Refusal(
            "Every hinge: the wall around the pin is {wall:.3g} mm thick, less than one nozzle "
            "width.",
            cure=_PIN_CURE,
            parameter="FaceThickness",
            wall=wall,
            thicker=thicker,
        )


def _thicker(radius: float, p: HingeParameters) -> float:
    """Face thickness (mm), a multiple of the layer height, whose barrels have this radius."""
    return ceil((radius - p.gap_between_planes / 2) / p.layer_height - 1e-9) * p.layer_height


def _layer_warnings(p: HingeParameters) -> "list[Phrase]":
    found = []
    for name, value in (
        ("FaceThickness", p.face_thickness),
        ("GapBetweenPlanes", p.gap_between_planes),
    ):
        layers = value / p.layer_height
        if abs(layers - round(layers)) < 1e-6:
            continue
        low, high = floor(layers) * p.layer_height, ceil(layers) * p.layer_height
        nearest = phrase("{low:.4g} or {high:.4g}" if low > 0 else "{high:.4g}", low=low, high=high)
        found.append(
            phrase(
                "{name} {value:.4g} mm is not a multiple of the layer height {layer:.4g} mm, so "
                "panels slice to different thicknesses: use {nearest} mm.",
                name=name_of(name),
                value=value,
                layer=p.layer_height,
                nearest=nearest,
            )
        )
    return found


def _cone_warnings(p: HingeParameters) -> "list[Phrase]":
    if not p.has_knuckles or p.pivot != CONE:
        return []
    clearance = p.gap_length * cos(p.cone_angle)
    if clearance >= p.layer_height - 1e-9:
        return []
    return [
        phrase(
            "Cones are {clearance:.3g} mm apart, less than a layer of {layer:.4g} mm: raise "
            "{GapLength} to {gap:.4g} mm or lower {ConeAngle} towards 45°.",
            clearance=clearance,
            layer=p.layer_height,
            gap=ceil(p.layer_height / cos(p.cone_angle) * 20 - 1e-9) / 20,
        )
    ]


def _process_warnings(p: "HingeParameters") -> list:
    if p.has_knuckles or PROCESSES[p.process].held != BY_STANDOFFS:
        return []
    return [
        phrase(
            "Stand-offs are for knuckles: set {Process} to {soluble}, so that the gaps of flexible "
            "hinges are filled.",
            soluble=Choice(SOLUBLE),
        )
    ]
