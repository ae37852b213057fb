# SPDX-License-Identifier: LGPL-2.1-or-later
"""How two halves of a contact block are joined: where a tube is cut into prints, where it closes.

A block is cut in the middle of the gap between its two contact panels. Each half is the contact
panel with half the filler on it, t + g/2 thick; so two halves that meet fit face to face. To add a
kind of joint, add a line to `JOINTS`: what it does to both halves. Panels, objects, design files
and docs/hinges.md read the table. Places lie off the middle: the halves fit one way only.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ..errors import Refusal, name_of
from . import polygons
from .clips import Clip, clip_for, draw_post, draw_window

if TYPE_CHECKING:
    from .outward import Outward
    from .parameters import HingeParameters

Plan = Sequence[complex]
# Loops in a half's cap, and in its panel's inner face (or None).
Loops = tuple[list[int], list[int] | None]
Feature = Callable[["Outward", float, float, bool], Loops]

DOWEL = 1.75  # mm, the diameter of filament
DOWEL_PLAY = 0.2  # mm that a hole is wider
DOWEL_PLACES = (0.2, 0.7)  # shares of the filler's length
_MAGNET_DEPTH_PLAY = 0.1  # mm


@dataclass(frozen=True)
class Joint:
    """A kind of `JOINTS` and its sizes, mm: of pieces of filament, magnets, screws.

    ``strain``: that a clip's material bears again and again.
    """

    kind: str = "Dowel"
    dowel_diameter: float = DOWEL
    magnet_diameter: float = 5.0
    magnet_depth: float = 1.0
    screw_diameter: float = 3.0
    strain: float = 0.01

    def __post_init__(self) -> None:
        if self.kind not in JOINTS:
            raise Refusal(
                "{Joint} {kind} is unknown: choose one of {names}.",
                parameter="Joint", kind=repr(self.kind), names=", ".join(JOINTS),
            )  # fmt: skip
        for name, value in (
            ("DowelDiameter", self.dowel_diameter),
            ("MagnetDiameter", self.magnet_diameter),
            ("MagnetDepth", self.magnet_depth),
            ("ScrewDiameter", self.screw_diameter),
        ):
            if not (np.isfinite(value) and value > 0):
                raise Refusal(
                    "{name} is {value:.6g} mm: set it to a length above 0.",
                    parameter=name, name=name_of(name), value=value,
                )  # fmt: skip


class JointKind(NamedTuple):
    """``what`` it is; ``features(joint, corners, parameters)``: what it makes of two halves.

    That is a list of functions ``draw(outward, cap, inside, upper)`` → `Loops`; ``upper``: of the
    half that has the other one on it.
    """

    what: str
    features: Callable[["Joint", Plan, "HingeParameters"], list[Feature]]


def clearance_hole(screw_diameter: float) -> float:
    """Diameter (mm) of a hole that a screw goes through: about ISO 273, medium."""
    return 1.1 * screw_diameter + 0.1


def dowel_places(corners: Plan) -> list[complex]:
    """Plan points of the dowels on the longer middle line of a filler's corners (x + i y)."""
    middle, along, low, high = _middle_line(corners)
    return [middle + (low + share * (high - low)) * along for share in DOWEL_PLACES]


def _middle_line(corners: Plan) -> tuple[complex, complex, float, float]:
    """Middle of corners, direction of their longest side, and how far they reach along it."""
    n = len(corners)
    start = max(range(n), key=lambda i: abs(corners[(i + 1) % n] - corners[i]))
    along = polygons.unit(corners[(start + 1) % n] - corners[start])
    middle = sum(corners) / n
    reach = [polygons.dot(p - middle, along) for p in corners]
    return middle, along, min(reach), max(reach)


def _nothing(_joint: Joint, _corners: Plan, _parameters: "HingeParameters") -> list[Feature]:
    return []


def _dowels(joint: Joint, corners: Plan, parameters: "HingeParameters") -> list[Feature]:
    return _holes(joint.dowel_diameter + DOWEL_PLAY, corners, parameters, "DowelDiameter")


def _screws(joint: Joint, corners: Plan, parameters: "HingeParameters") -> list[Feature]:
    return _holes(clearance_hole(joint.screw_diameter), corners, parameters, "ScrewDiameter")


def _holes(
    diameter: float, corners: Plan, parameters: "HingeParameters", parameter: str
) -> list[Feature]:
    def draw(centre: complex) -> Feature:
        def hole(outward: "Outward", cap: float, inside: float, _upper: bool) -> Loops:
            low, high = (outward.circle(centre, diameter / 2, z) for z in (inside, cap))
            outward.round_walls(low, high, hole=True)
            return [high], [low]

        return hole

    return [draw(p) for p in _round_places(diameter, corners, parameters, parameter)]


def _magnets(joint: Joint, corners: Plan, parameters: "HingeParameters") -> list[Feature]:
    diameter, depth = joint.magnet_diameter + DOWEL_PLAY, joint.magnet_depth + _MAGNET_DEPTH_PLAY
    thickness = half_thickness(parameters)
    floor = thickness - depth
    if floor < 2 * parameters.layer_height - 1e-9:
        raise Refusal(
            "{MagnetDepth} is {depth:.4g} mm and half a contact block {thickness:.4g} mm thick: "
            "set {MagnetDepth} to {most:.3g} mm or less, or {FaceThickness} to {thicker:.4g} mm.",
            parameter="MagnetDepth", depth=joint.magnet_depth, thickness=thickness,
            most=max(thickness - 2 * parameters.layer_height - _MAGNET_DEPTH_PLAY, 0.0),
            thicker=parameters.face_thickness + 2 * parameters.layer_height - floor,
        )  # fmt: skip

    def draw(centre: complex) -> Feature:
        def pocket(outward: "Outward", cap: float, _inside: float, _upper: bool) -> Loops:
            low, high = (outward.circle(centre, diameter / 2, z) for z in (cap - depth, cap))
            outward.round_walls(low, high, hole=True)
            outward.plane(True, [low])
            return [high], None

        return pocket

    return [draw(p) for p in _round_places(diameter, corners, parameters, "MagnetDiameter")]


def _round_places(
    diameter: float, corners: Plan, parameters: "HingeParameters", parameter: str
) -> list[complex]:
    """Places for two round things with a wall of a nozzle's width around; a `Refusal`."""
    places, wall = dowel_places(corners), parameters.nozzle_diameter
    room = 2 * (min(_inside(p, corners) for p in places) - wall)
    if diameter > room:
        raise Refusal(
            "{Joint}: a hole of {diameter:.3g} mm leaves no wall in the contact blocks, whose "
            "joint is {length:.3g} × {width:.3g} mm",
            cure="set {name} to {most:.3g} mm or less, make {EdgeLength} longer, or set {Joint} "
            "to None",
            parameter=parameter, name=name_of(parameter), diameter=diameter,
            most=max(np.floor(10 * (room - diameter) + 1e-6) / 10 + _nominal(diameter, parameter),
                     0.0),
            **_extent(corners),
        )  # fmt: skip
    return places


def _nominal(diameter: float, parameter: str) -> float:
    """The size that a hole of this diameter is for."""
    return (diameter - 0.1) / 1.1 if parameter == "ScrewDiameter" else diameter - DOWEL_PLAY


def _inside(point: complex, corners: Plan) -> float:
    """Distance of a point from the nearest side of a convex polygon, negative outside."""
    sides = zip(corners, [*corners[1:], corners[0]], strict=True)
    return min(polygons.cross(polygons.unit(b - a), point - a) for a, b in sides)


def _extent(corners: Plan) -> dict[str, Any]:
    middle, along, low, high = _middle_line(corners)
    across = [polygons.cross(along, p - middle) for p in corners]
    return {"length": high - low, "width": max(across) - min(across)}


def _clips(joint: Joint, corners: Plan, parameters: "HingeParameters") -> list[Feature]:
    clip = clip_for(joint.strain, half_thickness(parameters), parameters)
    wall = 2 * parameters.nozzle_diameter
    places = _clip_places(clip, corners, wall)
    if places is None:
        raise Refusal(
            "{Joint}: two clips whose tongues are {tongue:.3g} mm long, so that they strain by "
            "{strain:.2%}, find no room in the joint of {length:.3g} × {width:.3g} mm",
            cure="make {EdgeLength} longer, choose a {Material} that bears more strain, or set "
            "{Joint} to Dowel, Magnet or Screw",
            parameter="Joint", tongue=clip.length, strain=clip.strain, **_extent(corners),
        )  # fmt: skip

    def draw(place: Callable[[complex], complex]) -> Feature:
        def one(outward: "Outward", cap: float, inside: float, upper: bool) -> Loops:
            if upper:
                return draw_post(outward, clip, place, cap), None
            return draw_window(outward, clip, place, cap, inside)

        return one

    return [draw(place) for place in places]


def _clip_places(
    clip: Clip, corners: Plan, wall: float
) -> list[Callable[[complex], complex]] | None:
    """Two functions that lay clips' plans into a filler, the second turned round; or None."""
    middle, along, low, high = _middle_line(corners)
    first, last = clip.size
    for turn in (1, 1j):
        found: list[Callable[[complex], complex]] = []
        for shares, sense in ((np.arange(0.1, 0.5, 0.02), 1), (np.arange(0.86, 0.5, -0.02), -1)):
            for share in shares:
                centre = middle + (low + share * (high - low)) * along
                spin = sense * turn * along
                start = centre - spin * (first + last) / 2
                box = [first, complex(last.real, 0), last, complex(first.real, last.imag)]
                laid = [start + spin * p for p in box]
                if min(_inside(p, corners) for p in laid) < wall:
                    continue
                reach = [sense * polygons.dot(p - middle, along) for p in laid]
                if max(reach) < -wall / 2 + sense * (low + high) / 2:
                    found.append(_laid(start, spin))
                break
        if len(found) == 2:
            return found
    return None


def _laid(start: complex, spin: complex) -> Callable[[complex], complex]:
    return lambda p: start + spin * p


JOINTS = {
    "Dowel": JointKind("two pieces of filament go through both halves", _dowels),
    "Clip": JointKind("two posts of one half snap behind tongues of the other", _clips),
    "Magnet": JointKind("two pockets in each half hold magnets", _magnets),
    "Screw": JointKind("two holes go through both halves, for screws and nuts", _screws),
    "None": JointKind("two plain faces, to glue", _nothing),
}


def half_thickness(parameters: "HingeParameters") -> float:
    """Thickness t + g/2 of half a contact block (mm)."""
    return parameters.face_thickness + parameters.gap_between_planes / 2


def features(joint: Joint, corners: Plan, parameters: "HingeParameters") -> list[Feature]:
    """What a joint does to both halves of a block, whose filler has these plan corners."""
    return JOINTS[joint.kind].features(joint, corners, parameters)
