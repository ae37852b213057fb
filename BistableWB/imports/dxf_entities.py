# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entities of a DXF as exact pieces, in the units and the world coordinates of their block."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from .pieces import Arc, Array, Line, Piece
from .splines import clamped, through

_FRAME_POINT = 16  # of a vertex: a control point of a spline that is drawn by other vertices
_CLOSED, _IS_3D, _MESH, _POLYFACE = 1, 8, 16, 64  # of a POLYLINE
_NO_BULGE = 1e-9


def frame(extrusion: Any) -> Array:
    """Axes (3, 3, as columns) of an object coordinate system: DXF's arbitrary axis algorithm."""
    z = np.array(list(extrusion), float)
    size = float(np.linalg.norm(z))
    if size == 0:
        return np.eye(3)
    z = z / size
    near_z = abs(z[0]) < 1 / 64 and abs(z[1]) < 1 / 64
    x = np.cross([0.0, 1.0, 0.0] if near_z else [0.0, 0.0, 1.0], z)
    x = x / np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


def _point(vector) -> Array:
    return np.array([*vector, 0.0][:3], float)


def _line(entity) -> list[Piece]:
    return [Line(_point(entity.dxf.start), _point(entity.dxf.end))]


def _arc(entity) -> list[Piece]:
    dxf = entity.dxf
    first, last = math.radians(dxf.start_angle), math.radians(dxf.end_angle)
    return [_circular(dxf, first, first + ((last - first) % (2 * math.pi) or 2 * math.pi))]


def _circle(entity) -> list[Piece]:
    return [_circular(entity.dxf, 0.0, 2 * math.pi)]


def _circular(dxf, first, last):
    axes = frame(dxf.get("extrusion", (0, 0, 1)))
    radius = abs(dxf.radius)
    return Arc(axes @ _point(dxf.center), axes[:, 0] * radius, axes[:, 1] * radius, first, last)


def _ellipse(entity) -> list[Piece]:
    dxf = entity.dxf
    major = _point(dxf.major_axis)
    normal = _point(dxf.get("extrusion", (0, 0, 1)))
    minor = np.cross(normal / np.linalg.norm(normal), major) * dxf.get("ratio", 1.0)
    first, last = dxf.get("start_param", 0.0), dxf.get("end_param", 2 * math.pi)
    span = (last - first) % (2 * math.pi)
    whole = abs(last - first) > 1e-9 and min(span, 2 * math.pi - span) < 1e-9
    return [Arc(_point(dxf.center), major, minor, first, first + (2 * math.pi if whole else span))]


def _lwpolyline(entity) -> list[Piece]:
    dxf = entity.dxf
    axes = frame(dxf.get("extrusion", (0, 0, 1)))
    z = dxf.get("elevation", 0.0)
    rows = [(np.array([x, y, z]), bulge) for x, y, bulge in entity.get_points("xyb")]
    return _bulged(rows, bool(dxf.get("flags", 0) & _CLOSED), axes)


def _polyline(entity) -> list[Piece] | None:
    flags = entity.dxf.get("flags", 0)
    if flags & (_MESH | _POLYFACE):
        return None
    vertices = [v for v in entity.vertices if not v.dxf.get("flags", 0) & _FRAME_POINT]
    closed = bool(flags & _CLOSED)
    if flags & _IS_3D:
        return _bulged([(_point(v.dxf.location), 0.0) for v in vertices], closed, np.eye(3))
    z = _point(entity.dxf.get("elevation", (0, 0, 0)))[2]
    rows = [
        (np.array([v.dxf.location.x, v.dxf.location.y, z]), v.dxf.get("bulge", 0.0))
        for v in vertices
    ]
    return _bulged(rows, closed, frame(entity.dxf.get("extrusion", (0, 0, 1))))


def _bulged(rows, closed, axes):
    """Pieces between points with bulges: tangents of a quarter of the angle of an arc."""
    pairs = list(zip(rows, rows[1:] + rows[:1] if closed else rows[1:], strict=False))
    return [_bulge(axes, a, b, bulge) for (a, bulge), (b, _) in pairs]


def _bulge(axes, a, b, bulge):
    chord = b - a
    if abs(bulge) < _NO_BULGE or not chord[:2].any():
        return Line(axes @ a, axes @ b)
    across = np.array([-chord[1], chord[0], 0.0])
    centre = (a + b) / 2 + across * (1 - bulge**2) / (4 * bulge)
    u = a - centre
    v = np.array([-u[1], u[0], 0.0])
    return Arc(axes @ centre, axes @ u, axes @ v, 0.0, 4 * math.atan(bulge))


def _spline(entity) -> list[Piece]:
    dxf = entity.dxf
    poles = [_point(p) for p in entity.control_points]
    if len(poles) < 2:
        return _through_fit_points(entity)
    degree = int(dxf.get("degree", 3))
    knots = np.array(list(entity.knots), float)
    weights = [float(w) for w in entity.weights] or None
    if not 1 <= degree <= 25 or len(knots) != len(poles) + degree + 1 or (np.diff(knots) < 0).any():
        raise ValueError("knots")
    if weights is not None and (len(weights) != len(poles) or min(weights) <= 0):
        raise ValueError("weights")
    return [clamped(degree, knots, np.array(poles), weights)]


def _through_fit_points(entity):
    points = [_point(p) for p in entity.fit_points]
    points = [p for k, p in enumerate(points) if k == 0 or (p != points[k - 1]).any()]
    if entity.dxf.get("flags", 0) & _CLOSED and len(points) > 1 and (points[0] != points[-1]).any():
        points.append(points[0])
    if len(points) < 2:
        raise ValueError("points")
    tangents = [entity.dxf.get(name) for name in ("start_tangent", "end_tangent")]
    tangents = [None if tangent is None else _point(tangent) for tangent in tangents]
    return [through(np.array(points), tuple(tangents))]


def _mline(entity) -> list[Piece]:
    points = [_point(vertex.location) for vertex in entity.vertices]
    closed = bool(entity.dxf.get("flags", 0) & 2)
    return _bulged([(p, 0.0) for p in points], closed, np.eye(3))


PIECES: dict[str, Callable[[Any], list[Piece] | None]] = {
    "LINE": _line,
    "ARC": _arc,
    "CIRCLE": _circle,
    "ELLIPSE": _ellipse,
    "LWPOLYLINE": _lwpolyline,
    "POLYLINE": _polyline,
    "SPLINE": _spline,
    "HELIX": _spline,
    "MLINE": _mline,
}
