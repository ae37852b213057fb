# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curve: a Bézier by control points, or linked geometry; in a plane, on a sphere or in space."""

import math
import re
from functools import lru_cache

import FreeCAD as App
import numpy as np
import Part

from ..origami.curves.bezier import Bezier
from ..origami.curves.corners import RADII, Rounded
from ..origami.curves.crossing import CurveTable
from ..origami.curves.families import AUTOMATIC, FOUND_TIP, KINDS, KINDS_TIP
from ..origami.curves.kinds import found_kind, plane_normal
from ..origami.curves.ruling import check_ruling, default_ruling
from ..origami.curves.spheres import Projected, Wrapped
from ..origami.design import CurveGeometry
from ..origami.errors import Refusal
from ..origami.fit.defaults import usual_edge_length
from ..origami.units.closed_forms import contact_radius
from ..solids.matrices import array_of
from .base import BistableObject, Prop, Result, global_placement, set_result
from .edges import EdgeChain, edges_of
from .links import followed, linked

_MAX_OCC_DEGREE = 25
_ONE_POINT = re.compile(r"Points\[(\d+)\](?:\.([xyz]))?")
DEFAULT_POINTS = [
    App.Vector(0, 0, 0), App.Vector(60, 120, 0), App.Vector(180, 120, 0), App.Vector(240, 0, 0)
]  # fmt: skip


class Curve(BistableObject):
    """Curve that the tube follows (section 3.1 of the paper; section 5 for closed ones)."""

    Type = "Bistable::Curve"
    PROPERTIES = (
        Prop("VectorList", "Points", "Curve", "Control points of the Bézier curve, two or more. "
             "On a sphere: plan coordinates, wrapped from the top (see SphereCenter)",
             DEFAULT_POINTS),
        Prop("LinkSub", "Source", "Curve", "Edge, wire, sketch or Draft curve to follow instead "
             "of Points"),
        Prop("Enumeration", "Kind", "Curve", KINDS_TIP, list(KINDS)),
        Prop("Length", "CornerRadius", "Curve", "Radius by which kinks are rounded, so that the "
             "units can follow; 0: as much as units of the usual size ask for and fits", 0.0),
        Prop("Length", "SphereRadius", "Sphere", "Radius of the sphere that carries the curve",
             150.0),
        Prop("Angle", "Omega", "Sphere", "Base angle ω that the contact trapezoids shall have: "
             "sets SphereRadius to OmegaEdgeLength / 2 · tan ω. 0: SphereRadius is given", 0.0),
        Prop("Length", "OmegaEdgeLength", "Sphere", "EdgeLength ‖AB‖ of the units that Omega is "
             "wanted for", 60.0),
        Prop("Vector", "SphereCenter", "Sphere", "Centre of the sphere; all legs of the strips "
             "point to it", App.Vector(0, 0, 0)),
        Prop("Enumeration", "RulingKind", "General", "Automatic: the direction or viewpoint from "
             "which the curve is seen most openly. Direction, Viewpoint: as given by Ruling",
             ["Automatic", "Direction", "Viewpoint"]),
        Prop("Vector", "Ruling", "General", "Direction of all legs of the strips, or the point "
             "that they all pass (setting it turns Automatic off)", App.Vector(0, 0, 0)),
        Result("Length", "Length", "Results", "Length of the curve"),
        Result("Bool", "Closed", "Results", "The ends of the curve coincide: its tube is printed "
               "flat as an open chain and joined when deployed"),
        Result("String", "FoundKind", "Results", FOUND_TIP),
    )  # fmt: skip

    def onChanged(self, obj, name):
        """Whoever sets a ruling means it."""
        super().onChanged(obj, name)
        if name == "Ruling" and self.ready(obj) and obj.RulingKind == "Automatic":
            obj.RulingKind = "Direction"

    def execute(self, obj):
        """Recompute; expressions for single points count, as `driven` says."""
        driven(obj)
        super().execute(obj)

    def generate(self, obj):
        """Shape of the curve and its length; ValueError for a curve that no tube can follow."""
        if obj.Kind == "Sphere" and obj.Omega.Value:
            set_result(obj, SphereRadius=App.Units.Quantity(_radius_for(obj), App.Units.Length))
        geometry = self.held(local_geometry(obj))
        table = CurveTable(geometry.curve, 1e9)
        length = float(table.lengths[-1])
        closed = bool(np.linalg.norm(table.points[-1] - table.points[0]) <= 1e-6 * length)
        set_result(
            obj,
            Length=App.Units.Quantity(length, App.Units.Length),
            Closed=closed,
            FoundKind=geometry.family,
        )
        obj.Shape = _display_shape(obj, geometry)

    def onDocumentRestored(self, obj):
        """Migrate; files from before Automatic have a shorter list of kinds."""
        super().onDocumentRestored(obj)
        if obj.getEnumerationsOfProperty("Kind") != list(KINDS):
            chosen = obj.Kind
            obj.Kind = list(KINDS)
            obj.Kind = chosen


def driven(obj):
    """Give ``Points`` what expressions say of single points, as ``Points[1].x``.

    FreeCAD works such expressions out and keeps nothing of it; one for all of ``Points`` works
    without this.
    """
    points = [App.Vector(p) for p in obj.Points]
    for path, expression, *_ in obj.ExpressionEngine:
        match = _ONE_POINT.fullmatch(path.lstrip("."))
        if match is None:
            continue
        index, axis = int(match[1]), match[2]
        value = obj.evalExpression(expression)
        if axis is None:
            points[index] = App.Vector(value)
        else:
            setattr(points[index], axis, float(getattr(value, "Value", value)))
    if points != list(obj.Points):
        obj.Points = points


def geometry_of(obj):
    """`CurveGeometry` of a Curve object in the global frame; ValueError as on recompute.

    An App::Link to a Curve stands where the link stands.
    """
    return placed(local_geometry(followed(obj)), global_placement(obj))


def local_geometry(obj):
    """`CurveGeometry` of a Curve object in its own frame (before its Placement)."""
    curve = _own_curve(obj)
    kind, centre, radius = obj.Kind, None, None
    if kind == AUTOMATIC:
        kind, centre, radius = _found_kind(CurveGeometry(curve))
    elif kind == "Sphere":
        return _on_sphere(obj, curve)
    if kind == "Sphere":
        return CurveGeometry(Projected(curve, centre, radius), kind, ("point", centre), radius)
    if kind == "General":
        return CurveGeometry(curve, kind, _ruling(obj, curve))
    return CurveGeometry(curve, kind, ("parallel", _plane_normal(CurveGeometry(curve))))


def _own_curve(obj):
    if linked(obj, "Source") is None:
        return Bezier([tuple(p) for p in obj.Points])
    edges, label = edges_of(obj.Source)
    curve = EdgeChain(edges, label)
    if curve.kinks:
        most = RADII * usual_edge_length(curve.length)
        curve = Rounded(curve, curve.kinks, obj.CornerRadius.Value or None, most)
    inverse = global_placement(obj).inverse()
    return curve if inverse.isIdentity() else Moved(curve, inverse)


def _ruling(obj, curve):
    """Legs for a curve of kind General, in the object's own frame."""
    if obj.RulingKind == "Automatic":
        return _default_ruling(CurveGeometry(curve, "General"))
    kind = "parallel" if obj.RulingKind == "Direction" else "point"
    legs = kind, tuple(obj.Ruling)
    _check_ruling(CurveGeometry(curve, "General", legs))
    return legs


# What has been found of a curve is found again for an equal one: every object above asks for it.
@lru_cache(maxsize=16)
def _default_ruling(geometry):
    return default_ruling(geometry.curve)


@lru_cache(maxsize=16)
def _check_ruling(geometry):
    check_ruling(geometry.curve, geometry.legs)


@lru_cache(maxsize=16)
def _plane_normal(geometry):
    return tuple(plane_normal(geometry.curve).tolist())


@lru_cache(maxsize=16)
def _found_kind(geometry):
    return found_kind(geometry.curve)


def _radius_for(obj):
    """Radius (mm) of the sphere on which units have the wanted base angle ω."""
    omega, edge = obj.Omega.Value, obj.OmegaEdgeLength.Value
    if not 0 < omega < 90:
        raise Refusal(
            "{Omega} is {omega:.6g}°: set it between 0° and 90°, or to 0 to give {SphereRadius}.",
            parameter="Omega",
            omega=omega,
        )
    if not (math.isfinite(edge) and edge > 0):
        raise Refusal(
            "{OmegaEdgeLength} is {edge:.6g} mm: set it to the {EdgeLength} of the units.",
            parameter="OmegaEdgeLength",
            edge=edge,
        )
    return float(contact_radius(edge, np.radians(omega)))


def _on_sphere(obj, curve):
    radius, centre = obj.SphereRadius.Value, np.array(tuple(obj.SphereCenter))
    if not (np.isfinite(radius) and radius > 0 and np.isfinite(centre).all()):
        raise Refusal(
            "{SphereRadius} is {radius:.6g} mm: give the sphere a radius above 0 and a finite "
            "{SphereCenter}.",
            parameter="SphereRadius",
            radius=radius,
        )
    plan = obj.Source is None and not any(p.z for p in obj.Points)
    wrapped = Wrapped(curve, centre, radius) if plan else Projected(curve, centre, radius)
    return CurveGeometry(wrapped, "Sphere", ("point", centre), radius)


class Moved:
    """A curve moved by a FreeCAD placement."""

    def __init__(self, curve, placement):
        matrix = array_of(placement)
        self.curve, self.rotation, self.shift = curve, matrix[:3, :3], matrix[:3, 3]

    def point(self, s):
        return self.curve.point(s) @ self.rotation.T + self.shift


def placed(geometry, placement):
    """A `CurveGeometry` moved by a placement."""
    if placement.isIdentity():
        return geometry
    moved = Moved(geometry.curve, placement)
    kind, vector = geometry.legs
    vector = moved.rotation @ np.asarray(vector) + (moved.shift if kind == "point" else 0)
    return CurveGeometry(moved, geometry.family, (kind, vector), geometry.sphere_radius)


def _display_shape(obj, geometry):
    """Edge that shows the curve: the Bézier itself, or a fine interpolation of it."""
    straight = geometry.family != "Sphere" or obj.Kind == AUTOMATIC
    rounded = isinstance(geometry.curve, Rounded) or isinstance(
        getattr(geometry.curve, "curve", None), Rounded
    )
    if obj.Source is not None and straight and not rounded:
        pieces = EdgeChain(*edges_of(obj.Source)).pieces
        back = global_placement(obj).inverse().toMatrix()
        return Part.Wire([edge.transformGeometry(back) for edge, _, _ in pieces])
    if obj.Source is None and straight and len(obj.Points) <= _MAX_OCC_DEGREE + 1:
        bezier = Part.BezierCurve()
        bezier.setPoles(list(obj.Points))
        return bezier.toShape()
    points = geometry.curve.point(np.linspace(0, 1, 513 if rounded else 129))
    closed = np.linalg.norm(points[0] - points[-1]) < 1e-6 * np.ptp(points)
    spline = Part.BSplineCurve()
    vectors = [App.Vector(*p) for p in points.tolist()]
    spline.interpolate(vectors[:-1] if closed else vectors, PeriodicFlag=bool(closed))
    return spline.toShape()
