# SPDX-License-Identifier: LGPL-2.1-or-later
"""Test prints in plan: the paper's hinged dihedral and hinged four-degree vertex (Tables 1 and 2).

Plan and heights as in `hinge_plan`; the footprint is the rectangle from 0 to ``length_x`` along x
and ``length_y`` along z, barrels and links included.
"""

from math import cos, isfinite, pi, radians, sin

from . import plan
from .hinge_plan import Hinge, finish, link_section

# Sector angles (outer, inner) of the four-degree vertex: plates 1 and 4, and 2 and 3. Opposite
# sectors differ by the same angle (flat-foldable); the developable one's add up to 360°.
VERTEX_ANGLES = {
    "Vertex": (radians(120), radians(60)),
    "NonDevelopableVertex": (radians(115), radians(42)),
}


def dihedral(parameters, length_x=45.0, length_y=36.0):
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
    return finish({"crease": hinge}, cores, heights, (), parameters)


def vertex(kind, parameters, length_x=50.0, length_y=32.0):
    """Four plates about a vertex, printed flat-folded in four layers (mm).

    ``kind``: "Vertex" (developable) or "NonDevelopableVertex". The plates follow each other round
    the vertex and up the stack, so the fourth and the first are joined by a double hinge.
    """
    if kind not in VERTEX_ANGLES:
        raise ValueError(f"Kind {kind!r} is unknown: use Vertex or NonDevelopableVertex.")
    parameters.check()
    _check_lengths(length_x, length_y)
    if parameters.rotation_angle:
        raise ValueError(
            "RotationAngle must be 0° for a four-degree vertex: it is printed flat-folded."
        )
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
    box = _rectangle(length_x, length_y)
    hinges = {}
    for name, angle, height, bodies in table:
        u = complex(cos(angle), sin(angle))
        length = min(
            plan.dot(origin + parameters.radius * normal - centre, normal) / plan.dot(u, normal)
            for origin, normal, _ in box
            if plan.dot(u, normal) < -1e-9
        )
        hinges[name] = Hinge(name, centre, u, height, bodies, (0.0, length), ("vertex", name))
    plates = {
        "plate_1": ("crease_12", "crease_41_lower"),
        "plate_2": ("crease_12", "crease_23"),
        "plate_3": ("crease_34", "crease_23"),
        "plate_4": ("crease_34", "crease_41_upper"),
    }
    cores, heights = {}, {}
    for i, (name, (left_name, right_name)) in enumerate(plates.items()):
        left_edge, right_edge = hinges[left_name], hinges[right_name]
        lines = list(box)
        for hinge, turn in ((left_edge, -1j), (right_edge, 1j)):
            normal = turn * hinge.direction
            lines.append((hinge.origin + parameters.cut_back * normal, normal, hinge.name))
        cores[name] = _core(name, lines, (left_name, right_name), length_x, length_y)
        heights[name] = (i - 1.5) * p
    return finish(hinges, cores, heights, ("link",), parameters)


def opening_clearance(parameters):
    """Smallest distance (mm) of the dihedral's plates beside the hinge as it is printed."""
    angle, half = parameters.rotation_angle, parameters.gap_between_planes / 2
    if angle >= pi / 2:
        return 2 * parameters.cut_back
    return 2 * (half * cos(angle / 2) + parameters.cut_back * sin(angle / 2))


def _rectangle(length_x, length_y):
    corner = complex(length_x, length_y)
    return [(0j, 1, None), (0j, 1j, None), (corner, -1, None), (corner, -1j, None)]


def _core(name, lines, hinges, length_x, length_y):
    found = plan.half_planes(lines, [0j, complex(length_x, length_y)], 1.0)
    if not all(hinge in found[1] for hinge in hinges):
        raise ValueError(
            f"Coupon of {length_x:.4g} x {length_y:.4g} mm leaves nothing of {name}; set "
            f"LengthX and LengthY to {1.5 * length_x:.4g} and {1.5 * length_y:.4g} mm."
        )
    return found


def _check_lengths(length_x, length_y):
    for name, value in (("LengthX", length_x), ("LengthY", length_y)):
        if not (isfinite(value) and value > 0):
            raise ValueError(f"{name} is {value:.6g} mm: set it to a length above 0.")
