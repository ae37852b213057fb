# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curve: an open Bézier by control points, or linked geometry; in a plane or on a sphere."""

from dataclasses import dataclass

import FreeCAD as App
import numpy as np
import Part

from ..origami.bezier import Bezier
from ..origami.crossing import CurveTable
from ..origami.ruling import check_ruling, default_ruling
from ..origami.tube import FAMILIES
from .base import BistableObject, Prop, Result, global_placement, set_result
from .edges import EdgeChain, edges_of

_PLANAR = 1e-6  # of the curve's length
_OFF_SPHERE = 0.25  # of the radius: further away, central projection is no longer what one sees
_MAX_OCC_DEGREE = 25
DEFAULT_POINTS = [
    App.Vector(0, 0, 0), App.Vector(60, 120, 0), App.Vector(180, 120, 0), App.Vector(240, 0, 0)
]  # fmt: skip


@dataclass(frozen=True)
class CurveGeometry:
    """A curve as the mathematics wants it: ``curve`` in space, its family, its strip's legs."""

    curve: object
    family: str
    legs: tuple
    sphere_radius: float | None = None


class Curve(BistableObject):
    """Open curve that the tube follows (section 3.1 of the paper)."""

    Type = "Bistable::Curve"
    PROPERTIES = (
        Prop("VectorList", "Points", "Curve", "Control points of the Bézier curve, two or more. "
             "On a sphere: plan coordinates, wrapped from the top (see SphereCenter)",
             DEFAULT_POINTS),
        Prop("LinkSub", "Source", "Curve", "Edge, wire, sketch or Draft curve to follow instead "
             "of Points"),
        Prop("Enumeration", "Kind", "Curve", "Plane: any plane in space. Sphere: on the sphere "
             "of SphereRadius about SphereCenter. General: any space curve, see Ruling",
             list(FAMILIES)),
        Prop("Length", "SphereRadius", "Sphere", "Radius of the sphere that carries the curve",
             150.0),
        Prop("Vector", "SphereCenter", "Sphere", "Centre of the sphere; all legs of the strips "
             "point to it", App.Vector(0, 0, 0)),
        Prop("Enumeration", "RulingKind", "General", "Automatic: the direction or viewpoint from "
             "which the curve is seen most openly. Direction, Viewpoint: as given by Ruling",
             ["Automatic", "Direction", "Viewpoint"]),
        Prop("Vector", "Ruling", "General", "Direction of all legs of the strips, or the point "
             "that they all pass (setting it turns Automatic off)", App.Vector(0, 0, 0)),
        Result("Length", "Length", "Results", "Length of the curve"),
        Result("Bool", "Closed", "Results", "The ends of the curve coincide (not allowed)"),
    )  # fmt: skip

    def onChanged(self, obj, name):
        """Whoever sets a ruling means it."""
        if name == "Ruling" and self.ready(obj) and obj.RulingKind == "Automatic":
            obj.RulingKind = "Direction"

    def generate(self, obj):
        """Shape of the curve and its length; ValueError for a curve that no tube can follow."""
        geometry = local_geometry(obj)
        table = CurveTable(geometry.curve, 1e9)
        length = float(table.lengths[-1])
        closed = bool(np.linalg.norm(table.points[-1] - table.points[0]) <= 1e-6 * length)
        set_result(obj, Length=App.Units.Quantity(length, App.Units.Length), Closed=closed)
        if closed:
            at = ", ".join(f"{x:.4g}" for x in table.points[0])
            raise ValueError(
                f"Curve is closed at ({at}) mm: a closed tube cannot be both bistable and "
                "flat-foldable; open it by a gap of a few EdgeLength."
            )
        shape = _display_shape(obj, geometry)
        obj.Shape = shape


def geometry_of(obj):
    """`CurveGeometry` of a Curve object in the global frame; ValueError as on recompute."""
    return placed(local_geometry(obj), global_placement(obj))


def local_geometry(obj):
    """`CurveGeometry` of a Curve object in its own frame (before its Placement)."""
    curve = _own_curve(obj)
    if obj.Kind == "Sphere":
        return _on_sphere(obj, curve)
    if obj.Kind == "General":
        return CurveGeometry(curve, "General", _ruling(obj, curve))
    return CurveGeometry(curve, "Plane", ("parallel", _plane_normal(curve)))


def _own_curve(obj):
    if obj.Source is None:
        return Bezier([tuple(p) for p in obj.Points])
    edges, label = edges_of(obj.Source)
    chain = EdgeChain(edges, label)
    inverse = global_placement(obj).inverse()
    return chain if inverse.isIdentity() else Moved(chain, inverse)


def _ruling(obj, curve):
    """Legs for a curve of kind General, in the object's own frame."""
    if obj.RulingKind == "Automatic":
        return default_ruling(curve)
    kind = "parallel" if obj.RulingKind == "Direction" else "point"
    legs = kind, np.array(tuple(obj.Ruling))
    check_ruling(curve, legs)
    return legs


def _plane_normal(curve):
    """Normal of the plane of ``curve``, towards +z (or +y, +x) where it can; ValueError if none."""
    points = CurveTable(curve, 1e9).points
    centre = points.mean(0)
    _, spread, axes = np.linalg.svd(points - centre, full_matrices=False)
    if spread[1] <= 1e-9 * spread[0]:  # straight: any plane will do, prefer the horizontal one
        along = axes[0]
        helper = np.array([0, 0, 1.0]) if abs(along[2]) < 0.999 else np.array([0, 1.0, 0])
        normal = helper - (helper @ along) * along
        return normal / np.linalg.norm(normal)
    normal = axes[2]
    distance = (points - centre) @ normal
    k = int(np.argmax(np.abs(distance)))
    extent = np.ptp(points @ axes[0])
    if abs(distance[k]) > _PLANAR * extent:
        at = ", ".join(f"{x:.4g}" for x in points[k])
        raise ValueError(
            f"Curve is not planar: near ({at}) mm it lies {abs(distance[k]):.4g} mm off its best "
            "plane; flatten it, or set Kind to Sphere if it lies on a sphere."
        )
    normal[np.abs(normal) < 1e-12] = 0
    first = normal[2] or normal[1] or normal[0]
    return normal * np.sign(first)


def _on_sphere(obj, curve):
    radius, centre = obj.SphereRadius.Value, np.array(tuple(obj.SphereCenter))
    if not (np.isfinite(radius) and radius > 0 and np.isfinite(centre).all()):
        raise ValueError(
            f"SphereRadius is {radius:.6g} mm: give the sphere a radius above 0 and a finite "
            "SphereCenter."
        )
    plan = obj.Source is None and not any(p.z for p in obj.Points)
    wrapped = Wrapped(curve, centre, radius) if plan else Projected(curve, centre, radius)
    return CurveGeometry(wrapped, "Sphere", ("point", centre), radius)


class Wrapped:
    """A plan curve wrapped onto a sphere from its top (azimuthal equidistant).

    A plan point (x, y) goes in the direction of (x, y) down from the top of the sphere by an arc
    of length √(x² + y²): distances from the top are kept.
    """

    def __init__(self, curve, centre, radius):
        self.curve, self.centre, self.radius = curve, centre, radius
        reach = np.linalg.norm(curve.point(np.linspace(0, 1, 257))[:, :2], axis=1).max()
        if reach >= np.pi * radius:
            raise ValueError(
                f"Points reach {reach:.4g} mm from the top of the sphere, beyond its bottom at "
                f"{np.pi * radius:.4g} mm: make SphereRadius larger or the curve smaller."
            )

    def point(self, s):
        plan = self.curve.point(s)[..., :2]
        arc = np.linalg.norm(plan, axis=-1, keepdims=True) / self.radius
        direction = np.concatenate([plan / self.radius * np.sinc(arc / np.pi), np.cos(arc)], -1)
        return self.centre + self.radius * direction


class Projected:
    """A curve in space projected from the centre onto a sphere."""

    def __init__(self, curve, centre, radius):
        self.curve, self.centre, self.radius = curve, centre, radius
        points = CurveTable(curve, radius / 4).points
        distance = np.linalg.norm(points - centre, axis=1)
        k = int(np.argmax(np.abs(distance - radius)))
        if abs(distance[k] - radius) > _OFF_SPHERE * radius:
            at = ", ".join(f"{x:.4g}" for x in points[k])
            raise ValueError(
                f"Curve is not on the sphere: at ({at}) mm it is {distance[k]:.4g} mm from "
                f"SphereCenter, SphereRadius is {radius:.4g} mm; correct SphereRadius and "
                "SphereCenter, or bring the curve within a quarter of the radius."
            )

    def point(self, s):
        offset = self.curve.point(s) - self.centre
        return self.centre + self.radius * offset / np.linalg.norm(offset, axis=-1, keepdims=True)


class Moved:
    """A curve moved by a FreeCAD placement."""

    def __init__(self, curve, placement):
        matrix = np.array(placement.toMatrix().A).reshape(4, 4)
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
    if obj.Source is not None and obj.Kind != "Sphere":
        edges, _ = edges_of(obj.Source)
        back = global_placement(obj).inverse().toMatrix()
        return Part.Wire(Part.__sortEdges__([e.transformGeometry(back) for e in edges]))
    if obj.Source is None and obj.Kind != "Sphere" and len(obj.Points) <= _MAX_OCC_DEGREE + 1:
        bezier = Part.BezierCurve()
        bezier.setPoles(list(obj.Points))
        return bezier.toShape()
    points = geometry.curve.point(np.linspace(0, 1, 129))
    spline = Part.BSplineCurve()
    spline.interpolate([App.Vector(*p) for p in points.tolist()])
    return spline.toShape()
