# SPDX-License-Identifier: LGPL-2.1-or-later
"""Faces from plan points and heights, and closed solids sewn from them."""

import Part
from FreeCAD import Vector

# A body whose volume differs by more than this share from the predicted one was sewn wrongly.
VOLUME_TOLERANCE = 1e-3


def at(plan_point, height):
    """Vector of a unit's flat frame from a plan point (x + i z) and a height (mm)."""
    return Vector(plan_point.real, height, plan_point.imag)


def polygon(points):
    """Plane face with the given corners."""
    return Part.Face(Part.makePolygon([*points, points[0]]))


def line(a, b):
    """Straight edge."""
    return Part.LineSegment(a, b).toShape()


def arc(a, middle, b):
    """Circular edge through three points."""
    return Part.Arc(a, middle, b).toShape()


def circle(radius, centre, axis):
    """Circular wire."""
    return Part.Wire(Part.makeCircle(radius, centre, axis))


def with_hole(outer, hole):
    """Plane face between an outer wire and a hole (``Part.Face`` of two wires is unreliable)."""
    return Part.makeFace([outer, hole], "Part::FaceMakerBullseye")


def tube(radius, start, axis, length):
    """Lateral face of a cylinder."""
    return Part.makeCylinder(radius, length, start, axis).Faces[0]


def cone(base, tip, height, start, axis):
    """Lateral face and tip disc of a blunt cone that stands on ``start``."""
    lateral = Part.makeCone(base, tip, height, start, axis).Faces[0]
    return [lateral, Part.Face(circle(tip, start + axis * height, axis))]


def solid(faces, volume, name):
    """One closed solid sewn from ``faces``.

    Raises RuntimeError unless it is closed and its volume is ``volume`` (mm³) to 0.1 %.
    """
    shell = Part.makeShell(faces)
    if shell.ShapeType != "Shell" or not shell.isClosed():
        raise RuntimeError(f"The faces of body {name} do not close.")
    body = Part.makeSolid(shell)
    found = body.Volume
    if found < 0:
        body.reverse()
        found = -found
    if abs(found - volume) > VOLUME_TOLERANCE * volume:
        raise RuntimeError(f"Body {name} has {found:.6g} mm³ instead of {volume:.6g} mm³.")
    return body
