# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refusals of bends that units cannot follow: where, and what to change."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from . import bezier

if TYPE_CHECKING:
    from .crossing import CurveTable


def too_tight(table: "CurveTable", low: float, high: float, edge_length: float) -> None:
    """Refuse a bend that the units cannot follow, naming its sharpest place."""
    radius, point = _sharpest(table, low, high)
    if radius > edge_length:  # the bend is wide enough
        raise Refusal(
            "Curve: units run into each other near {point}, where they tilt too much; make "
            "{EdgeLength} shorter or {Gamma} smaller, or along a General curve move {Ruling} "
            "nearer to square with the curve or switch {Level} on.",
            parameter="EdgeLength",
            point=where(point),
        )
    raise Refusal(
        "Curve: the radius of curvature is too small near {point} (about {radius:.4g} mm, "
        "{EdgeLength} {edge_length:.6g} mm needs more than {least:.4g} mm); make "
        "{EdgeLength} shorter or the bend wider.",
        parameter="EdgeLength",
        point=where(point),
        radius=radius,
        edge_length=edge_length,
        least=edge_length / 2,
    )


def _sharpest(table: "CurveTable", low: float, high: float) -> tuple[float, NDArray]:
    """Smallest radius of curvature between two parameters, and where."""
    s = np.linspace(low, high, 201)
    points = np.asarray(table.curve.point(s), float)
    first, second = np.gradient(points, s, axis=0), None
    second = np.gradient(first, s, axis=0)
    bend = bezier.curvature(first, second)[2:-2]
    k = int(np.argmax(bend))
    return 1 / max(bend[k], 1e-12), points[k + 2]


def too_long(edge_length: float, length: float) -> None:
    """Refuse a curve on which not one unit fits."""
    raise Refusal(
        "{EdgeLength} ‖AB‖ = {edge_length:.6g} mm is too long for this curve of length "
        "{length:.6g} mm: not even one unit fits; make {EdgeLength} shorter, the curve "
        "longer, or {Gamma} smaller.",
        parameter="EdgeLength",
        edge_length=edge_length,
        length=length,
    )


def where(point: NDArray) -> str:
    """A point in words."""
    return "(" + ", ".join(f"{x:.4g}" for x in point) + ") mm"
