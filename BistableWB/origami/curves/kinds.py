# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which family a curve is of: in a plane, on a sphere, or any (section 5)."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from .crossing import CurveTable
from .tightness import where

if TYPE_CHECKING:
    from .curve import Curve

PLANAR = 1e-6  # of the curve's extent
ROUND = 1e-4  # of the sphere's radius
_LARGEST = 50.0  # radius of a sphere that is seen as one, in lengths of the curve


def found_kind(curve: "Curve") -> tuple[str, NDArray | None, float | None]:
    """Kind ("Plane", "Sphere", "General"); the sphere's centre and radius, else None.

    Planar within `PLANAR` of its extent; on a sphere within `ROUND` of the radius of the one that
    fits best, which is no larger than fifty lengths of the curve.
    """
    points = evenly(curve)
    if off_plane(points)[1] <= PLANAR:
        return "Plane", None, None
    sphere = fitted_sphere(points)
    if sphere is not None:
        centre, radius = sphere
        off = np.abs(np.linalg.norm(points - centre, axis=1) - radius).max()
        length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
        if off <= ROUND * radius and radius <= _LARGEST * length:
            return "Sphere", centre, float(radius)
    return "General", None, None


def evenly(curve: "Curve", count: int = 512) -> NDArray:
    """Points (count + 1, 3) of a curve at even lengths."""
    table = CurveTable(curve, 1e9)
    lengths = np.linspace(0, table.lengths[-1], count + 1)
    s = np.interp(lengths, table.lengths, table.parameters)
    return np.asarray(curve.point(s), float)


def off_plane(points: NDArray) -> tuple[NDArray | None, float]:
    """Normal of the plane that fits points (m, 3) best, and their largest distance / extent.

    Straight lines lie in many planes: the normal is None, the distance 0.
    """
    centre = points.mean(0)
    _, spread, axes = np.linalg.svd(points - centre, full_matrices=False)
    if spread[1] <= 1e-9 * spread[0]:
        return None, 0.0
    extent = np.ptp((points - centre) @ axes[0])
    return axes[2], float(np.abs((points - centre) @ axes[2]).max() / extent)


def fitted_sphere(points: NDArray) -> tuple[NDArray, float] | None:
    """Centre and radius of the sphere that fits points best (least squares), None for a plane."""
    middle = points.mean(0)
    offset = points - middle
    size = np.sqrt((offset * offset).sum(1).mean())
    offset = offset / size
    system = np.column_stack([2 * offset, np.ones(len(offset))])
    solution, _, _, singular = np.linalg.lstsq(system, (offset * offset).sum(1), rcond=None)
    if singular[-1] < 1e-3 * singular[0]:
        return None
    centre = middle + size * solution[:3]
    return centre, np.sqrt(((points - centre) ** 2).sum(1).mean())


def plane_normal(curve: "Curve") -> NDArray:
    """Normal of the plane of ``curve``, towards +z (or +y, +x) where it can.

    `Refusal`, with the place and General as the cure, for a curve that lies in none.
    """
    points = evenly(curve)
    normal, off = off_plane(points)
    if normal is None:  # straight: any plane will do, prefer the horizontal one
        along = points[-1] - points[0]
        along = along / np.linalg.norm(along)
        helper = np.array([0, 0, 1.0]) if abs(along[2]) < 0.999 else np.array([0, 1.0, 0])
        normal = helper - (helper @ along) * along
        return normal / np.linalg.norm(normal)
    if off > PLANAR:
        distance = np.abs((points - points.mean(0)) @ normal)
        k = int(distance.argmax())
        raise Refusal(
            "Curve is not planar: near {place} it lies {off:.4g} mm off its best plane",
            cure="set {Kind} to General, or to Automatic, which finds it, or flatten the curve",
            parameter="Kind",
            place=where(points[k]),
            off=float(distance[k]),
        )
    normal = np.where(np.abs(normal) < 1e-12, 0, normal)
    first = normal[2] or normal[1] or normal[0]
    return normal * np.sign(first)
