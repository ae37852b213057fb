# SPDX-License-Identifier: LGPL-2.1-or-later
"""The march along a curve: block after block, each at the first crossing outward (section 2)."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from . import bezier
from .tightness import too_tight

if TYPE_CHECKING:
    from .crossing import CurveTable
    from .curve import Curve
    from .legs import Legs

_START = 0.01  # part of the curve that tells in which direction it starts
_CHORD = 1e-6
_BESIDE = 1e-7  # of half an edge
_EPS = float(np.finfo(float).eps)


def _start_weights(nodes: int = 33, degree: int = 8) -> tuple[NDArray, ...]:
    """Nodes in [0, 1] and the weights of first and second derivative at 0 of the polynomial there.

    Least squares through many nodes: what rounds off far from the origin averages out.
    """
    u = (1 - np.cos(np.pi * np.arange(nodes) / (nodes - 1))) / 2
    powers = np.linalg.pinv(np.polynomial.chebyshev.chebvander(2 * u - 1, degree))
    ends = [np.polynomial.chebyshev.chebder(np.eye(degree + 1), k) for k in (1, 2)]
    return u, *(np.polynomial.chebyshev.chebval(-1.0, e) * 2**k @ powers for k, e in
                enumerate(ends, 1))  # fmt: skip


_NODES, _FIRST, _SECOND = _start_weights()


@dataclass
class Blocks:
    """Blocks found so far: parameters, midpoints, half mid-lines r e, and sin t of the units."""

    parameters: list
    midpoints: list
    reaches: list
    sines: list


def march(
    table: "CurveTable",
    legs: "Legs",
    edge_length: float,
    gamma: float,
    pitch: float,
    flip: bool,
    extra: NDArray | Sequence[Any],
    most: int | None = None,
) -> "Blocks":
    """All blocks along a tabulated curve, from its start to the last crossing; or ``most`` units.

    Arguments as of `placement.place`.
    """
    start = Start(table.curve, legs, flip)
    midpoint, (direction, normal) = start.midpoint, start.block(gamma)
    r = edge_length / 2
    blocks = Blocks([0.0], [midpoint], [r * direction], [])
    while most is None or len(blocks.sines) < most:
        count = len(blocks.sines)
        more = extra[min(count, len(extra) - 1)] if len(extra) else 0.0
        joint = r * direction + pitch * normal
        step = _next_block(table, blocks.parameters[-1], midpoint, joint, pitch + more)
        if step is None:
            break
        parameter, point = step
        y = bezier.normalised(point - midpoint)
        sine, cosine = float(direction @ y), float(normal @ y)
        if cosine <= 0 or sine <= 0 or sine >= 1:
            too_tight(table, blocks.parameters[-1], parameter, edge_length)
        direction = bezier.normalised(2 * sine * y - direction)
        normal = _forward_normal(direction, legs.at(point), 2 * cosine * y - normal)
        midpoint = point
        blocks.sines.append(sine)
        blocks.parameters.append(parameter)
        blocks.midpoints.append(point)
        blocks.reaches.append(r * direction)
    return blocks


class Start:
    """Where a zigzag starts, and how its first block stands for any gamma (steps 1-3)."""

    def __init__(self, curve: "Curve", legs: "Legs", flip: bool) -> None:
        self.midpoint = np.asarray(curve.point(np.array([0.0])), float)[0]
        self.tangent, self.leg = _start_tangent(curve), legs.at(self.midpoint)
        left = np.cross(self.leg, self.tangent)
        if np.linalg.norm(left) < 1e-3:
            raise Refusal(
                "{Ruling}: the legs run along the curve at its start; choose another direction or "
                "viewpoint for {Ruling}.",
                parameter="Ruling",
            )
        left = bezier.normalised(left)
        self.side = left * _concave_side(curve, left)
        if flip:
            self.side = -self.side
        self.ahead = bezier.normalised(self.tangent - (self.tangent @ self.leg) * self.leg)

    def block(self, gamma: float) -> tuple:
        """Direction to the joint and forward normal of the first block."""
        direction = np.cos(gamma) * self.side + np.sin(gamma) * self.ahead
        return direction, _forward_normal(direction, self.leg, self.tangent)


def _concave_side(curve: "Curve", left: NDArray) -> float:
    """1 where a curve bends to the ``left`` at its start, −1 to the right; 1 for a straight one.

    Where it hardly bends across, as beside an inflection, or changes its speed only, a longer piece
    tells it from rounding.
    """
    for step in (1e-4, 1e-3, 1e-2):
        start = np.asarray(curve.point(step * np.arange(3)), float)
        bend = (start[2] - start[1]) - (start[1] - start[0])
        rounding = max(1e-9 * np.linalg.norm(start[2] - start[0]), 1e-14 * np.abs(start).max())
        if np.linalg.norm(bend) < rounding:
            break
        if abs(bend @ left) > rounding:
            return float(np.sign(bend @ left))
    return 1.0


def _start_tangent(curve: "Curve") -> NDArray:
    """Direction in which the curve starts: the chord over its first millionth.

    A chord needs no derivative from the curve, and it is the convention of the reference numbers
    (the exact tangent differs by less than 1e-4 degrees). It is taken from a polynomial through
    many points of the first hundredth, where rounding does not count, however far off the curve
    lies. A curve that starts with speed zero gets a longer chord.
    """
    step = min([_START, *(b for b in getattr(curve, "breaks", ()) if b > _CHORD)])
    points = np.asarray(curve.point(step * _NODES), float)
    points -= points[0]
    chord = _FIRST @ points / step + _SECOND @ points / step**2 * (_CHORD / 2)
    size = np.linalg.norm(np.ptp(curve.point(np.linspace(0, 1, 4)), axis=0))
    if np.linalg.norm(chord) > 1e-3 * size:
        return bezier.normalised(chord)
    for step in (1e-4, 1e-2):
        first, then = np.asarray(curve.point(np.array([0.0, step])), float)
        if np.linalg.norm(then - first) > 1e-3 * step * size:
            break
    return bezier.normalised(then - first)


def _forward_normal(direction: NDArray, leg: NDArray, forward: NDArray) -> NDArray:
    """Normal of a contact panel (spanned by ``direction`` and ``leg``) on the ``forward`` side."""
    normal = bezier.normalised(np.cross(direction, leg))
    return normal if normal @ forward >= 0 else -normal


def _next_block(
    table: "CurveTable", start: float, midpoint: NDArray, joint: NDArray, link: float
) -> tuple[float, NDArray] | None:
    """Parameter and point of the next block's midpoint, or None at the end of the curve.

    ``joint`` = r e + p n leads from the midpoint to the axis at B, ``link`` is half the length of
    the double hinge's link (the pitch).
    """
    arm = float(np.linalg.norm(joint))

    def growth(points: NDArray) -> NDArray:
        d = points - midpoint
        square = (d * d).sum(-1)
        grown = square / 2 - link * np.sqrt(square) - d @ joint
        # beside the midpoint itself only rounding makes it positive
        return np.where(square < (_BESIDE * arm) ** 2, -np.abs(grown), grown)

    # |gradient| of growth within reach, plus what the link's term can bulge on a chord
    slope = 4 * (arm + link)
    rounding = 2 * _EPS * arm * (arm + float(np.abs(midpoint).max()))
    found = table.first_crossing(start, growth, slope, rounding)
    if found is None:
        return None
    return found, np.asarray(table.curve.point(np.array([found])), float)[0]
