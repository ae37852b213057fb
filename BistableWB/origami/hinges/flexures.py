# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flexible hinges in plan and section: TPU strips and the fingers that bond them to the panels.

theory/hinges.md 2 (the paper's Hinge 6): a wall or web that bends on the hinge's axis, a beam along
each panel's edge, and dovetailed fingers that reach into the panel, each half as high as the panel,
by turns in its lower and upper half. Between two fingers there is always panel material, so that
no two meet at an edge only, and every finger hangs on its beam.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..errors import Refusal
from . import polygons
from .room import size_property
from .unit_layout import inward_of

if TYPE_CHECKING:
    from .parameters import HingeParameters
    from .unit_layout import Hinge, Layout, Plate


@dataclass(frozen=True)
class Finger:
    """One finger: plan ``corners`` (counter-clockwise), ``low`` and ``high`` heights (mm)."""

    corners: tuple
    low: float
    high: float


@dataclass(frozen=True)
class Strip:
    """One flexible hinge between two plates.

    ``boxes``: its section, disjoint rectangles (n0, n1, v0, v1) mm with n across the axis along
    ``across`` and v the height; ``hinge.segments[0]`` is its length along the axis; ``fingers``:
    {plate name: fingers}; ``plates``: {plate name: (height of its middle, 1 where it lies along
    ``across``, else −1)}.
    """

    name: str
    hinge: "Hinge"
    across: complex
    boxes: tuple
    fingers: dict
    plates: dict


def strips(layout: "Layout", parameters: "HingeParameters") -> dict[str, Strip]:
    """{name: Strip} of a unit's or coupon's layout; a double hinge is one strip with its link."""
    taken: dict[str, list[tuple[complex, ...]]] = {name: [] for name in layout.plates}
    doubles = {hinge.name: link for link in layout.links.values() for hinge in link.hinges}
    found = {}
    for hinge in layout.hinges.values():
        link = doubles.get(hinge.name)
        if link is None:
            plates = [layout.plates[name] for name in hinge.bodies]
            name = hinge.name
        else:
            if hinge is not link.hinges[0]:
                continue
            plates = [layout.plates[h.bodies[0]] for h in link.hinges]
            name = link.name
        found[name] = _strip(name, hinge, plates, link is not None, taken, parameters)
    return found


def _strip(
    name: str,
    hinge: "Hinge",
    plates: "Sequence[Plate]",
    double: bool,
    taken: Mapping[str, list[tuple[complex, ...]]],
    parameters: "HingeParameters",
) -> Strip:
    across = inward_of(hinge, plates[0].core)
    sides = [1 if polygons.dot(inward_of(hinge, p.core), across) > 0 else -1 for p in plates]
    boxes = _web(hinge, plates, sides, double, parameters)
    half, edge = parameters.strip_thickness / 2, parameters.cut_back
    thick = parameters.face_thickness / 2
    fingers = {}
    for plate, side in zip(plates, sides, strict=True):
        n0, n1 = (half, edge) if side > 0 else (-edge, -half)
        boxes.append((n0, n1, plate.height - thick, plate.height + thick))
        fingers[plate.name] = _fingers(hinge, plate, taken[plate.name], parameters)
        if not fingers[plate.name]:
            raise Refusal(
                "Hinge {hinge}: no finger of {bond_width:.3g} mm fits into panel {panel}; set "
                "BondWidth to {narrower:.3g} mm, or {larger}.",
                hinge=name,
                bond_width=parameters.bond_width,
                panel=plate.name,
                narrower=parameters.bond_width / 2,
                larger=size_property(hinge, 1.5),
            )
    own = {plate.name: (plate.height, side) for plate, side in zip(plates, sides, strict=True)}
    return Strip(name, hinge, across, tuple(boxes), fingers, own)


def _web(
    hinge: "Hinge",
    plates: "Sequence[Plate]",
    sides: Sequence[int],
    double: bool,
    parameters: "HingeParameters",
) -> list[tuple[float, float, float, float]]:
    """The part that bends: an upright wall between stacked plates, a web between level ones."""
    half, gap = parameters.strip_thickness / 2, parameters.gap_between_planes
    if sides[0] != sides[1]:
        reach = parameters.cut_back - parameters.gap_length
        return [(-reach, reach, hinge.height - gap / 2, hinge.height + gap / 2)]
    heights = [plate.height for plate in plates]
    thick = parameters.face_thickness / 2
    boxes = [(-half, half, min(heights) - thick, max(heights) + thick)]
    if double:
        middle, stiff = sum(heights) / 2, parameters.radius
        boxes.append((-3 * half, -half, middle - stiff, middle + stiff))
    return boxes


def _fingers(
    hinge: "Hinge", plate: "Plate", taken: list[tuple[complex, ...]], parameters: "HingeParameters"
) -> list[Finger]:
    """Fingers of one strip in one plate; ``taken`` are the plate's fingers so far (grows)."""
    nozzle = parameters.nozzle_diameter
    inward = inward_of(hinge, plate.core)
    start, end = hinge.segments[0]
    step = 6 * nozzle
    count = int((end - start) / step)
    first = (start + end) / 2 - (count - 1) * step / 2
    half = parameters.face_thickness / 2
    made = []
    for k in range(count):
        points = _dovetail(hinge, first + k * step, inward, parameters)
        corners = tuple(points if polygons.area(points) > 0 else points[::-1])
        if not _has_room(corners, points[2:], plate.core, taken, nozzle):
            continue
        low = plate.height - half if k % 2 else plate.height
        made.append(Finger(corners, low, low + half))
        taken.append(corners)
    return made


def _dovetail(
    hinge: "Hinge", along: float, inward: complex, parameters: "HingeParameters"
) -> list[complex]:
    """Plan corners of a finger, root first, wider at its tip so that it cannot be drawn out."""
    nozzle = parameters.nozzle_diameter
    root = parameters.cut_back - parameters.strip_thickness / 2
    tip = parameters.cut_back + parameters.bond_width
    wide, narrow = 2 * nozzle, 1.5 * nozzle
    corners = (-narrow, root), (narrow, root), (wide, tip), (-wide, tip)
    return [hinge.point(along + s) + n * inward for s, n in corners]


def _has_room(
    corners: Sequence[complex],
    tip: Sequence[complex],
    core: Sequence[complex],
    taken: Sequence[Sequence[complex]],
    nozzle: float,
) -> bool:
    """Whether a finger's tip keeps two nozzle widths from the core's edges, and it from others."""
    if min(_depth(point, core) for point in tip) < 2 * nozzle:
        return False
    return not any(
        polygons.intersection(list(corners), list(other), inset=-nozzle) for other in taken
    )


def _depth(point: complex, polygon: Sequence[complex]) -> float:
    """Distance (mm) of a point inside a convex polygon from its nearest edge, negative outside."""
    ring = zip(polygon, [*polygon[1:], polygon[0]], strict=True)
    return min(polygons.cross(polygons.unit(b - a), point - a) for a, b in ring)
