# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same curve drawn larger: where nothing along a curve holds, how much longer it must be."""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..design import CurveGeometry

if TYPE_CHECKING:
    from ..curves.curve import Curve

SCALES = (1.15, 1.35, 1.6, 2.0, 2.5, 3.2, 4.5, 7.0, 12.0)


class _Scaled:
    def __init__(self, curve: "Curve", scale: float, about: NDArray) -> None:
        self.curve, self.scale, self.about = curve, scale, about

    def point(self, s: ArrayLike) -> NDArray:
        return self.about + self.scale * (self.curve.point(s) - self.about)


def larger(geometry: CurveGeometry, scale: float) -> CurveGeometry:
    """A `CurveGeometry` drawn ``scale`` times as large about its start, or its legs' viewpoint."""
    curve = geometry.curve
    kind, vector = geometry.ruling
    about = np.array(vector if kind == "point" else curve.point(np.zeros(1))[0], float)
    radius = geometry.sphere_radius
    return replace(
        geometry,
        curve=_Scaled(curve, scale, about),
        sphere_radius=None if radius is None else scale * radius,
    )
