# SPDX-License-Identifier: LGPL-2.1-or-later
"""What one knuckle gives way by, and what it bears: its tab as a short cantilever.

A tab runs from the core of its panel to the axis, as thick as the panel and as wide as the knuckle
is long; a force on the knuckle's cone bends, shears and twists it, most at its root. Frame of a
tab: x away from the panel, towards the axis, y along the stack, z = x × y along the hinge
(docs/theory/hinges.md 4).
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid

if TYPE_CHECKING:
    from ..hinges import unit_layout

SHEAR_SHARE = 5 / 6  # of a rectangle's area that bears shear


@dataclass(frozen=True)
class Tab:
    """The tab of one knuckle.

    ``frame`` (3, 3): columns x, y, z of the tab in the unit's flat frame; ``root`` (3,): middle of
    its root in that frame, mm; ``length``, ``width``, ``thickness``: mm.
    """

    frame: NDArray
    root: NDArray
    length: float
    width: float
    thickness: float


def tab_of(tab: "unit_layout.Tab", height: float, thickness: float) -> Tab:
    """`Tab` of a `unit_layout.Tab` of a plate whose mid-plane is at ``height``, mm."""
    ends = [tab.corner(k) for k in (0, 1)]
    middle, out = (ends[0] + ends[1]) / 2, -tab.inward
    x, y = np.array([out.real, 0.0, out.imag]), np.array([0.0, 1.0, 0.0])
    start, end = tab.hinge.segments[tab.index]
    return Tab(
        np.stack([x, y, np.cross(x, y)], -1),
        np.array([middle.real, height, middle.imag]),
        sum(tab.depths) / 2,
        end - start,
        thickness,
    )


def twisting(width: float, thickness: float) -> tuple[float, float]:
    """A rectangle's torsion constant, mm⁴, and its modulus for the largest shear stress, mm³."""
    b, t = max(width, thickness), min(width, thickness)
    return b * t**3 * (1 - 0.63 * t / b) / 3, b * t * t / (3 + 1.8 * t / b)


def compliance(tab: Any, point: NDArray, poisson: float) -> NDArray:
    """Compliance (3, 3) of a tab at a ``point`` of its knuckle (3,), for E = 1 MPa, mm/N.

    Both in the unit's flat frame; the root is held.
    """
    b, t, length = tab.width, tab.thickness, tab.length
    shear = 2 * (1 + poisson)  # E / G
    area, flat, upright = b * t, b * t**3 / 12, t * b**3 / 12
    tip = np.zeros((6, 6))  # force and moment at the axis -> displacement and rotation there
    tip[0, 0] = length / area
    for across, turn, sign, inertia in ((1, 5, 1, flat), (2, 4, -1, upright)):
        tip[across, across] = length**3 / (3 * inertia) + shear * length / (SHEAR_SHARE * area)
        tip[across, turn] = tip[turn, across] = sign * length**2 / (2 * inertia)
        tip[turn, turn] = length / inertia
    tip[3, 3] = shear * length / twisting(b, t)[0]
    arm = tab.frame.T @ (np.asarray(point) - tab.root) - [length, 0, 0]
    reach = np.hstack([np.eye(3), -rigid.skew(arm)])
    return tab.frame @ (reach @ tip @ reach.T) @ tab.frame.T


def stress(tab: Any, points: NDArray, forces: NDArray) -> float:
    """Largest equivalent stress (von Mises, MPa) at the root of a tab under forces, N.

    Forces (n, 3) act together at ``points`` (n, 3) of the knuckle, in the unit's flat frame.
    """
    local = forces @ tab.frame
    arms = (points - tab.root) @ tab.frame
    force, moment = local.sum(0), np.cross(arms, local).sum(0)
    b, t = tab.width, tab.thickness
    normal = abs(force[0]) / (b * t) + 6 * abs(moment[2]) / (b * t * t)
    normal += 6 * abs(moment[1]) / (t * b * b)
    twisted = abs(moment[0]) / twisting(b, t)[1]
    sheared = 1.5 * np.hypot(force[1], force[2]) / (b * t)  # where bending stress is nothing
    return float(max(np.hypot(normal, np.sqrt(3) * twisted), np.sqrt(3) * (sheared + twisted)))
