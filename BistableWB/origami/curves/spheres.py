# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves on a sphere: plans wrapped onto it, and curves projected from its centre."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from .crossing import CurveTable

if TYPE_CHECKING:
    from .curve import Curve

_OFF_SPHERE = 0.25  # of the radius: further away, central projection is no longer what one sees


class Wrapped:
    """A plan curve wrapped onto a sphere from its top (azimuthal equidistant).

    A plan point (x, y) goes in the direction of (x, y) down from the top of the sphere by an arc
    of length √(x² + y²): distances from the top are kept.
    """

    def __init__(self, curve: "Curve", centre: NDArray, radius: float) -> None:
        self.curve, self.centre, self.radius = curve, centre, radius
        reach = np.linalg.norm(curve.point(np.linspace(0, 1, 257))[:, :2], axis=1).max()
        if reach >= np.pi * radius:
            raise Refusal(
                "{Points} reach {reach:.4g} mm from the top of the sphere, beyond its bottom at "
                "{furthest:.4g} mm: make {SphereRadius} larger or the curve smaller.",
                parameter="Points",
                reach=reach,
                furthest=np.pi * radius,
            )

    def point(self, s: NDArray) -> NDArray:
        plan = self.curve.point(s)[..., :2]
        arc = np.linalg.norm(plan, axis=-1, keepdims=True) / self.radius
        direction = np.concatenate([plan / self.radius * np.sinc(arc / np.pi), np.cos(arc)], -1)
        return self.centre + self.radius * direction


class Projected:
    """A curve in space projected from the centre onto a sphere."""

    def __init__(self, curve: Any, centre: NDArray | Sequence[float], radius: float) -> None:
        self.curve, self.centre, self.radius = curve, centre, radius
        points = CurveTable(curve, radius / 4).points
        distance = np.linalg.norm(points - centre, axis=1)
        k = int(np.argmax(np.abs(distance - radius)))
        if abs(distance[k] - radius) > _OFF_SPHERE * radius:
            at = ", ".join(f"{x:.4g}" for x in points[k])
            raise Refusal(
                "Curve is not on the sphere: at ({at}) mm it is {distance:.4g} mm from "
                "{SphereCenter}, {SphereRadius} is {radius:.4g} mm; correct {SphereRadius} and "
                "{SphereCenter}, or bring the curve within a quarter of the radius.",
                parameter="SphereCenter",
                at=at,
                distance=distance[k],
                radius=radius,
            )

    def point(self, s: NDArray) -> Any:
        offset = self.curve.point(s) - self.centre
        return self.centre + self.radius * offset / np.linalg.norm(offset, axis=-1, keepdims=True)
