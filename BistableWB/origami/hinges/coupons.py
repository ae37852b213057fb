# SPDX-License-Identifier: LGPL-2.1-or-later
"""Test prints in plan: the paper's hinged dihedral and hinged four-degree vertex (Tables 1 and 2).

Plan and heights as in `unit_layout`; the footprint is the rectangle from 0 to ``length_x`` along x
and ``length_y`` along z, barrels and links included.
"""

from collections.abc import Mapping, Sequence
from math import cos, isfinite, pi, radians, sin
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Phrase, Refusal, name_of, phrase
from ..units.creases import KINDS
from . import polygons
from .bodies import Drawn, layout_drawn
from .link_section import link_section
from .unit_layout import Hinge, finish

if TYPE_CHECKING:
    from .parameters import HingeParameters

if TYPE_CHECKING:
    from .parameters import HingeParameters
    from .unit_layout import Layout

# Sector angles (outer, inner) of the four-degree vertex: plates 1 and 4, and 2 and 3. Opposite
# sectors differ by the same angle (flat-foldable); the developable one's add up to 360°.
VERTEX_ANGLES = {
    "Vertex": (radians(120), radians(60)),
    "NonDevelopableVertex": (radians(115), radians(42)),
}

COUPONS = ("Dihedral", *VERTEX_ANGLES)
# Plan x + i z and height y of a layout → print frame x, y, z; the plan is mirrored back by −z.
UPRIGHT = np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])


def coupon_drawn(
    kind: str,
    parameters: "HingeParameters",
    length_x: float | None = None,
    length_y: float | None = None,
    notes: list[Any] | None = None,
    opening: float = 0.0,
) -> list[Drawn]:
    """`Drawn` bodies of a test print, on the bed (z = 0) and in the quadrant x, y ≥ 0.

    ``kind``: one of `COUPONS`; lengths in mm (the paper's 45 x 36 and 50 x 32 if not given);
    ``notes``: a list that takes remarks. The dihedral is printed ``rotation_angle`` open;
    ``opening``: how far it is opened from there, 1: both plates in one plane.
    `Refusal` where the hinge cannot be made.
    """
    if kind == "Dihedral":
        layout = dihedral(parameters, length_x or 45.0, length_y or 36.0)
    else:
        layout = vertex(kind, parameters, length_x or 50.0, length_y or 32.0)
        if opening:
            raise Refusal(
                "A four-degree vertex is made as it is printed; set {Kind} to Dihedral for one "
                "that opens.",
                parameter="Kind",
            )
    angle = parameters.rotation_angle + opening * (pi - parameters.rotation_angle)
    if notes is not None:
        notes += [*layout.notes, *_opening_notes(kind, parameters)]
    bodies = []
    for name, boundary, matrix, of_kind in layout_drawn(layout, parameters):
        if name == "plate_upper" and angle:
            matrix = _partly_open(layout.hinges["crease"], angle, parameters) @ matrix
        members = () if of_kind == "flexure" else ((0, name),)
        bodies.append(Drawn(name, boundary, UPRIGHT @ matrix, 0, members, of_kind))
    low = np.min([body.boundary.bounds(body.place)[0] for body in bodies], axis=0)
    to_bed = np.eye(4)
    to_bed[:3, 3] = -low
    return [body._replace(place=to_bed @ body.place) for body in bodies]


def _partly_open(hinge: Hinge, angle: float, parameters: "HingeParameters") -> NDArray:
    """Motion (4, 4) of the upper plate of a dihedral that is not folded."""
    if not parameters.has_knuckles:
        raise Refusal(
            "{RotationAngle} must be 0° for a flexible hinge: it is printed folded.",
            parameter="RotationAngle",
        )
    return opened(hinge, angle)


def opened(hinge: Hinge, angle: float) -> NDArray:
    """Motion (4, 4) that opens the upper plate of a dihedral about its hinge, radians."""
    axis = np.array([hinge.direction.real, 0.0, hinge.direction.imag])
    centre = np.array([hinge.origin.real, hinge.height, hinge.origin.imag])
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    turn = np.eye(4)
    turn[:3, :3] += (1 - cos(angle)) * cross @ cross - sin(angle) * cross
    turn[:3, 3] = centre - turn[:3, :3] @ centre
    return turn


def _opening_notes(kind: str, parameters: "HingeParameters") -> list[Phrase]:
    if kind != "Dihedral" or opening_clearance(parameters) >= parameters.layer_height:
        return []
    return [
        phrase(
            "Plates are {clearance:.2g} mm apart beside the hinge, less than a layer: raise "
            "{GapBetweenPlanes} to {layer:.4g} mm, or {RotationAngle}.",
            clearance=opening_clearance(parameters),
            layer=parameters.layer_height,
        )
    ]


def dihedral(
    parameters: "HingeParameters", length_x: float = 45.0, length_y: float = 36.0
) -> "Layout":
    """Two plates that lie on each other, hinged along x (mm); printed ``rotation_angle`` open."""
    parameters.check()
    _check_lengths(length_x, length_y)
    half = parameters.pitch / 2
    edge = complex(0, parameters.radius)
    hinge = Hinge(
        "crease", edge, 1, 0.0, ("plate_lower", "plate_upper"), (0.0, length_x), ("", " ")
    )
    lines = [*_rectangle(length_x, length_y), (edge + 1j * parameters.cut_back, 1j, "crease")]
    core = _core("plate", lines, ("crease",), length_x, length_y)
    cores = {"plate_lower": core, "plate_upper": core}
    heights = {"plate_lower": -half, "plate_upper": half}
    return finish({"crease": hinge}, cores, heights, _kinds(cores), (), parameters)


def vertex(
    kind: str, parameters: "HingeParameters", length_x: float = 50.0, length_y: float = 32.0
) -> "Layout":
    """Four plates about a vertex, printed flat-folded in four layers (mm).

    ``kind``: "Vertex" (developable) or "NonDevelopableVertex". The plates follow each other round
    the vertex and up the stack, so the fourth and the first are joined by a double hinge.
    """
    if kind not in VERTEX_ANGLES:
        raise Refusal(
            "{Kind} {kind!r} is unknown: use Vertex or NonDevelopableVertex.",
            parameter="Kind",
            kind=kind,
        )
    parameters.check()
    _check_lengths(length_x, length_y)
    if parameters.rotation_angle:
        raise Refusal(
            "{RotationAngle} must be 0° for a four-degree vertex: it is printed flat-folded.",
            parameter="RotationAngle",
        )
    box, p = _rectangle(length_x, length_y), parameters.pitch
    hinges = _about_vertex(kind, parameters, length_x, length_y, box)
    plates = {
        "plate_1": ("crease_12", "crease_41_lower"),
        "plate_2": ("crease_12", "crease_23"),
        "plate_3": ("crease_34", "crease_23"),
        "plate_4": ("crease_34", "crease_41_upper"),
    }
    cores, heights = {}, {}
    for i, (name, (left_name, right_name)) in enumerate(plates.items()):
        left_edge, right_edge = hinges[left_name], hinges[right_name]
        lines: list[Any] = list(box)
        for hinge, turn in ((left_edge, -1j), (right_edge, 1j)):
            normal = turn * hinge.direction
            lines.append((hinge.origin + parameters.cut_back * normal, normal, hinge.name))
        cores[name] = _core(name, lines, (left_name, right_name), length_x, length_y)
        heights[name] = (i - 1.5) * p
    return finish(hinges, cores, heights, _kinds(cores), ("link",), parameters)


def _kinds(plates: Mapping[str, tuple[Sequence[complex], Sequence[Any]]]) -> dict[str, str]:
    """A kind of panel for each plate, so that they can be told apart: {plate: kind}."""
    return dict(zip(plates, KINDS, strict=False))


def _about_vertex(
    kind: str,
    parameters: "HingeParameters",
    length_x: float,
    length_y: float,
    box: Sequence[tuple[complex, complex, None]],
) -> dict[str, Hinge]:
    """{name: Hinge} of the five axes that meet in the vertex."""
    outer, inner = VERTEX_ANGLES[kind]
    base = link_section(parameters).outer
    left = parameters.radius - (length_y - base) * min(0.0, cos(outer) / sin(outer))
    centre = complex(min(left, length_x / 2), base)
    p = parameters.pitch
    table = (
        ("crease_12", outer, -p, ("plate_1", "plate_2")),
        ("crease_23", outer - inner, 0.0, ("plate_2", "plate_3")),
        ("crease_34", outer, p, ("plate_3", "plate_4")),
        ("crease_41_lower", 0.0, -p, ("plate_1", "link")),
        ("crease_41_upper", 0.0, p, ("plate_4", "link")),
    )
    hinges = {}
    for name, angle, height, bodies in table:
        u = complex(cos(angle), sin(angle))
        length = min(
            polygons.dot(origin + parameters.radius * normal - centre, normal)
            / polygons.dot(u, normal)
            for origin, normal, _ in box
            if polygons.dot(u, normal) < -1e-9
        )
        hinges[name] = Hinge(name, centre, u, height, bodies, (0.0, length), ("vertex", name))
    return hinges


def opening_clearance(parameters: "HingeParameters") -> float:
    """Smallest distance (mm) of the dihedral's plates beside the hinge as it is printed."""
    angle, half = parameters.rotation_angle, parameters.gap_between_planes / 2
    if angle >= pi / 2:
        return 2 * parameters.cut_back
    return 2 * (half * cos(angle / 2) + parameters.cut_back * sin(angle / 2))


def _rectangle(length_x: float, length_y: float) -> list[tuple[complex, complex, None]]:
    corner = complex(length_x, length_y)
    return [(0j, 1, None), (0j, 1j, None), (corner, -1, None), (corner, -1j, None)]


def _core(
    name: str,
    lines: Sequence[tuple[complex, complex, Any]],
    hinges: Sequence[str],
    length_x: float,
    length_y: float,
) -> tuple[list[complex], list[Any]]:
    found = polygons.half_planes(lines, [0j, complex(length_x, length_y)], 1.0)
    if not all(hinge in found[1] for hinge in hinges):
        raise Refusal(
            "Coupon of {length_x:.4g} x {length_y:.4g} mm leaves nothing of {name}; set {LengthX} "
            "and {LengthY} to {longer_x:.4g} and {longer_y:.4g} mm.",
            parameter="LengthX",
            length_x=length_x,
            length_y=length_y,
            name=name,
            longer_x=1.5 * length_x,
            longer_y=1.5 * length_y,
        )
    return found


def _check_lengths(length_x: float, length_y: float) -> None:
    for name, value in (("LengthX", length_x), ("LengthY", length_y)):
        if not (isfinite(value) and value > 0):
            raise Refusal(
                "{name} is {value:.6g} mm: set it to a length above 0.",
                parameter=name,
                name=name_of(name),
                value=value,
            )
