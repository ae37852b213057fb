# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening a zero-thickness unit: the least-misfit state at a prescribed opening (section 5).

Both contact panels stay rigid and turn about the leg at B; C' and P of both sub-units go where the
squared change of length of all other edges and diagonals is smallest. At opening 0 and 1 the
change is zero: those states are taken from the unit itself, exactly.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from .closed_forms import BARS, bar_lengths
from .creases import INDEX, PANELS, VERTICES

if TYPE_CHECKING:
    from .closed_forms import Unit

_FREE = [INDEX[name] for name in ("C_upper", "C_lower", "P_upper", "P_lower")]
_COLUMN = {vertex: 3 * k for k, vertex in enumerate(_FREE)}
_CHANGING = np.array([i for i, (a, b) in enumerate(BARS) if a in _FREE or b in _FREE])
_LEFT = [INDEX[name] for name in PANELS["contact_left"]]
_RIGHT = [INDEX[name] for name in PANELS["contact_right"]]
_A_LEFT = [INDEX["A_left_upper"], INDEX["A_left_lower"]]
_A_RIGHT = [INDEX["A_right_upper"], INDEX["A_right_lower"]]
_BARS_OF_PANELS = [
    [i for i, bar in enumerate(BARS) if set(bar) <= {INDEX[corner] for corner in corners}]
    for corners in PANELS.values()
]
_ITERATIONS = 40


def contact_frame(points: NDArray, side: str) -> NDArray:
    """Rigid frame (…, 4, 4) of a contact panel of units ``points`` (…, 10, 3).

    Origin at B_upper, x towards A in the panel, y down the leg at B, z normal.
    """
    return quad_frame(points[..., _LEFT if side == "left" else _RIGHT, :])


def quad_frame(quad: NDArray) -> NDArray:
    """Rigid frame (…, 4, 4) of a quad A_upper, B_upper, B_lower, A_lower: see `contact_frame`."""
    origin = quad[..., 1, :]
    y = _unit(quad[..., 2, :] - origin)
    x = quad[..., 0, :] - origin
    x = _unit(x - (x * y).sum(-1, keepdims=True) * y)
    frame = np.zeros((*origin.shape[:-1], 4, 4))
    frame[..., :3, 0], frame[..., :3, 1], frame[..., :3, 2] = x, y, np.cross(x, y)
    frame[..., :3, 3], frame[..., 3, 3] = origin, 1
    return frame


def opening_state(unit: "Unit", opening: float) -> NDArray:
    """Vertices (…, 10, 3) of a unit (or batch) opened to the fraction ``opening`` in [0, 1].

    0 and 1 are the unit's own flat and deployed states, exactly, moved to the common frame in
    which both contact panels turn by equal angles out of the plane y = 0 about the leg at B.
    """
    flat, goal = unit.flat, _registered(unit)
    if opening == 0:
        return flat.copy()
    if opening == 1:
        return goal
    points = flat + opening * (goal - flat)
    half = opening * _half_opening(unit)
    points[..., _A_LEFT, :] = _turned(flat, _A_LEFT, -half)
    points[..., _A_RIGHT, :] = _turned(flat, _A_RIGHT, half)
    return _relaxed(points, bar_lengths(flat)[..., _CHANGING])


def misfit(unit: "Unit", points: NDArray) -> NDArray:
    """Largest change of length of any edge or diagonal in state ``points``, unit of ‖AB‖: (…)."""
    return np.abs(bar_lengths(points) - bar_lengths(unit.flat)).max(-1)


def panel_strains(unit: "Unit", points: NDArray) -> NDArray:
    """Largest relative change of length of any edge or diagonal of every panel: (…, 12).

    ``points`` (…, 10, 3): a state of ``unit``, as `opening_state` gives it; panels in the order of
    the crease table.
    """
    strains = np.abs(bar_lengths(points) / bar_lengths(unit.flat) - 1)
    return np.stack([strains[..., bars].max(-1) for bars in _BARS_OF_PANELS], -1)


def _relaxed(points: NDArray, lengths: NDArray) -> NDArray:
    """Damped Gauss-Newton over the four free vertices; batched over leading axes."""
    shape = points.shape
    points = points.reshape(-1, len(VERTICES), 3).copy()
    lengths = np.broadcast_to(lengths, (*shape[:-2], len(_CHANGING))).reshape(len(points), -1)
    scale = lengths.max()
    bars = BARS[_CHANGING]
    damping = 1e-9 * np.eye(12)
    for _ in range(_ITERATIONS):
        offset = points[:, bars[:, 0]] - points[:, bars[:, 1]]
        now = np.linalg.norm(offset, axis=-1)
        along = offset / now[..., None]
        jacobian = np.zeros((len(points), len(bars), 12))
        for row, (a, b) in enumerate(bars):
            if a in _COLUMN:
                jacobian[:, row, _COLUMN[a] : _COLUMN[a] + 3] = along[:, row]
            if b in _COLUMN:
                jacobian[:, row, _COLUMN[b] : _COLUMN[b] + 3] = -along[:, row]
        transposed = np.swapaxes(jacobian, 1, 2)
        gradient = (transposed @ (lengths - now)[..., None])[..., 0]
        step = np.linalg.solve(transposed @ jacobian + damping, gradient[..., None])[..., 0]
        points[:, _FREE] += step.reshape(-1, 4, 3)
        if np.abs(step).max() < 1e-12 * scale:
            break
    return points.reshape(shape)


def _half_opening(unit: "Unit") -> NDArray | float:
    """Half the angle between the two contact panels about the leg at B, deployed: (…)."""
    left, right = contact_frame(unit.deployed, "left"), contact_frame(unit.deployed, "right")
    cosine = (left[..., :3, 0] * right[..., :3, 0]).sum(-1)
    sine = np.linalg.norm(np.cross(left[..., :3, 0], right[..., :3, 0]), axis=-1)
    return np.arctan2(sine, cosine) / 2


def _turned(points: NDArray, rows: Sequence[int], angle: NDArray | float) -> NDArray:
    """Rows of ``points`` turned by ``angle`` about the leg at B so that positive goes to +y."""
    origin = points[..., [INDEX["B_upper"]], :]
    axis = _unit(points[..., INDEX["B_lower"], :] - origin[..., 0, :])
    offset = points[..., rows, :] - origin
    cos, sin = np.cos(angle)[..., None, None], np.sin(angle)[..., None, None]
    axis = axis[..., None, :]
    across = np.cross(axis, offset)
    across = np.where(across[..., [0], 1:2] < 0, -across, across)
    along = (offset * axis).sum(-1, keepdims=True) * axis
    return origin + along + cos * (offset - along) + sin * across


def _registered(unit: "Unit") -> NDArray:
    """Deployed vertices moved so that the left contact panel is the flat one, turned by −θ/2."""
    turned = unit.flat.copy()
    turned[..., _A_LEFT, :] = _turned(unit.flat, _A_LEFT, -_half_opening(unit))
    motion = contact_frame(turned, "left") @ rigid.inverse(contact_frame(unit.deployed, "left"))
    return rigid.apply(motion, unit.deployed)


def _unit(vectors: NDArray) -> NDArray:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
