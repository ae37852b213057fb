# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a unit is that of section 1: no panel flipped, C' in its place, folds on their side.

For all θ, c and h the corners of the flat panels and the folds of the deployed unit turn the same
way; a unit of which one turns the other way is another shape, however isometric.
"""

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..curves.bezier import normalised
from ..errors import require
from .closed_forms import plane_unit
from .contacts import INPUT_SLACK, THINNEST
from .creases import CREASES, INDEX, PANELS, VERTICES


def _corners() -> NDArray:
    """Corners (before, at, after) of every panel and of the stretch C'-B, which keeps the order."""
    loops = [*PANELS.values(), ("C_upper", "B_upper", "B_lower", "C_lower")]
    return np.array(
        [
            [INDEX[v] for v in (loop[i - 1], loop[i], loop[(i + 1) % len(loop)])]
            for loop in loops
            for i in range(len(loop))
        ]
    ).T


def _folds() -> NDArray:
    """Both ends of every crease between two panels and one corner of each panel off it."""
    table: dict[Any, Any] = {}
    for crease in CREASES:
        panels = [body for body in crease.bodies if body in PANELS]
        table.setdefault(crease.vertices, []).extend(panels)
    rows = []
    for ends, panels in table.items():
        off = [next(v for v in PANELS[p] if v not in ends) for p in panels]
        rows.append([INDEX[v] for v in (*ends, *off)])
    return np.array(rows).T


_CORNERS, _FOLDS = _corners(), _folds()
_APEX = [k for k, ends in enumerate(_FOLDS[:2].T) if {VERTICES[i][0] for i in ends} == {"P", "C"}]


def _corner_sines(flat: NDArray) -> NDArray:
    """Signed sines of all panel corners in the flat state: (n, corners)."""
    a, b, c = (flat[:, i][..., [0, 2]] for i in _CORNERS)
    u, v = normalised(b - a), normalised(c - b)
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


def _fold_sines(deployed: NDArray) -> NDArray:
    """Signed sines of all fold angles in the deployed state: (n, folds)."""
    a, b, left, right = (deployed[:, i] for i in _FOLDS)
    axis = normalised(b - a)
    u, v = (normalised(np.cross(axis, p - a)) for p in (left, right))
    return (np.cross(u, v) * axis).sum(-1)


@cache
def _model_signs() -> tuple[NDArray, NDArray]:
    """Signs of corner and fold sines of every plane unit (they do not depend on θ, c and h)."""
    model = plane_unit(np.array([0.7]), 0.6, 1.0, 0.4)
    return np.sign(_corner_sines(model.flat)), np.sign(_fold_sines(model.deployed))


def apex_folds(deployed: NDArray) -> NDArray:
    """Sines of the folds P-C', upper and lower, above 0 where they turn as on a plane: (n, 2)."""
    return _turned(deployed)[:, _APEX]


def _turned(deployed: NDArray) -> NDArray:
    """Sines of all fold angles, above 0 where they turn as those of a plane unit: (n, folds)."""
    folds = _fold_sines(deployed) * _model_signs()[1]
    return folds * np.sign(folds[:, -1:])


def check_shape(deployed: NDArray, flat: NDArray) -> None:
    """ValueError where a panel is degenerate or flipped, or C' or a fold has changed its side."""
    sines = _corner_sines(flat) * _model_signs()[0]
    strip = sines[:, -4:].min(1)
    require(
        strip > THINNEST,
        "C'{at} would leave its place between A and B: make {EdgeLength} shorter, move {Ruling} "
        "nearer to square with the curve, or lower {Ratio}.",
        parameter="EdgeLength",
    )
    require(
        sines.min(1) > THINNEST,
        "A panel{at} would be flipped or have no area (sine of its corner {value:.2g}): make "
        "{EdgeLength} shorter, move {Ruling} nearer to square with the curve, or change {Ratio}.",
        sines.min(1),
        parameter="EdgeLength",
    )
    folds = _turned(deployed)
    require(
        folds.min(1) > -INPUT_SLACK,
        "A fold{at} would turn inside out (sine {value:.2g}): make {EdgeLength} shorter, move "
        "{Ruling} nearer to square with the curve, or raise {Ratio}.",
        folds.min(1),
        parameter="EdgeLength",
    )
