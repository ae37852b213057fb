# SPDX-License-Identifier: LGPL-2.1-or-later
"""The paper's test prints as solids: hinged dihedral and hinged four-degree vertex (section 5)."""

from math import degrees

from FreeCAD import Matrix, Vector

from ..origami.coupon_layout import dihedral, opening_clearance, vertex
from ..origami.hinge_parameters import FLEXIBLE
from .tube import Body, layout_solids

# Plan x + i z and height y of a layout → print frame x, y, z; the plan is mirrored back by −z.
_UPRIGHT = Matrix(1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1)
KINDS = ("Dihedral", "Vertex", "NonDevelopableVertex")


def coupon_bodies(kind, parameters, length_x=None, length_y=None, notes=None):
    """Bodies of a test print, on the bed (z = 0) and in the quadrant x, y ≥ 0.

    ``kind``: one of `KINDS`; lengths in mm (the paper's 45 x 36 and 50 x 32 if not given);
    ``notes``: a list that takes remarks. The dihedral is printed ``rotation_angle`` open.
    ValueError where the hinge cannot be made.
    """
    if kind == "Dihedral":
        layout = dihedral(parameters, length_x or 45.0, length_y or 36.0)
    else:
        layout = vertex(kind, parameters, length_x or 50.0, length_y or 32.0)
    if notes is not None:
        notes += [*layout.notes, *_opening_notes(kind, parameters)]
    bodies = []
    for name, shape, material in layout_solids(layout, parameters):
        if name == "plate_upper" and parameters.rotation_angle:
            hinge = layout.hinges["crease"]
            shape = _opened(shape, hinge, parameters)
        bodies.append((name, shape.transformed(_UPRIGHT), material))
    low = [min(getattr(s.BoundBox, f"{axis}Min") for _, s, _ in bodies) for axis in "XYZ"]
    return [
        Body(name, shape.translated(-Vector(*low)), 0, ((0, name),) if m == "rigid" else (), m)
        for name, shape, m in bodies
    ]


def _opened(shape, hinge, parameters):
    if parameters.hinge_type == FLEXIBLE:
        raise ValueError("RotationAngle must be 0° for a flexible hinge: it is printed folded.")
    opened = shape.copy()
    axis = Vector(hinge.direction.real, 0, hinge.direction.imag)
    centre = Vector(hinge.origin.real, hinge.height, hinge.origin.imag)
    opened.rotate(centre, axis, -degrees(parameters.rotation_angle))
    return opened


def _opening_notes(kind, parameters):
    if kind != "Dihedral" or opening_clearance(parameters) >= parameters.layer_height:
        return []
    return [
        f"Plates are {opening_clearance(parameters):.2g} mm apart beside the hinge, less than a "
        f"layer: raise GapBetweenPlanes to {parameters.layer_height:.4g} mm, or RotationAngle."
    ]
