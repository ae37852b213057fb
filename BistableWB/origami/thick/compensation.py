# SPDX-License-Identifier: LGPL-2.1-or-later
"""The smallest shifts of hinge axes for which a unit of thick panels closes (theory/hinges.md 3).

Every hinge is five equations (its start meets in three directions, its end in the two across the
axis; along it the lengths agree by themselves) in the 83 unknowns of the poses and 46 shifts.
Newton's equations are split like the unit: the five bodies of the upper sub-unit and those of the
lower one meet only at contacts, borders and the link at B, so each half is reduced by itself
(orthogonally, which keeps twelve digits), then the rest.
"""

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..units.creases import BODIES, CREASES
from .closure import BODY, FIRST, KEPT, SECOND, UNKNOWNS, Closure

_FLOOR, _CEILING = 3e-7, 1e-2  # bounds of the regularisation, edge lengths
_LONGEST = 0.2  # step of a pose, radians or edge lengths


def _half(end: str) -> tuple[NDArray, NDArray]:
    """Rows (equations) and columns (unknown poses) of one sub-unit."""
    bodies = [b for b in BODIES if b.endswith(end)]
    hinges = [i for i, c in enumerate(CREASES) if set(bodies) & set(c.bodies)]
    unknowns = np.concatenate([6 * BODY[b] + np.arange(6) for b in bodies])
    rows = (5 * np.array(hinges)[:, None] + np.arange(5)).ravel()
    return rows, np.flatnonzero(np.isin(KEPT, unknowns))


_HALVES = tuple(_half(end) for end in ("upper", "lower"))
_IN_HALVES = np.concatenate([columns for _, columns in _HALVES])
_REST_ROWS = np.setdiff1d(
    np.arange(5 * len(CREASES)), np.concatenate([rows for rows, _ in _HALVES])
)
_REST = np.setdiff1d(np.arange(UNKNOWNS), _IN_HALVES)


def normals(axes: NDArray) -> NDArray:
    """Unit vectors across the axes in the flat plane, +y × (end − start): (n, 23, 3)."""
    along = axes[:, :, 1] - axes[:, :, 0]
    across = np.cross([0.0, 1.0, 0.0], along)
    return across / np.linalg.norm(across, axis=-1, keepdims=True)


def shifted(axes: NDArray, shifts: NDArray) -> NDArray:
    """Axes whose ends are moved across, in the flat plane, by ``shifts`` (n, 23, 2)."""
    return axes + shifts[..., None] * normals(axes)[:, :, None]


def compensate(
    closure: Closure, poses: NDArray, tolerance: float = 1e-12, rounds: int = 60
) -> tuple:
    """Shifts of least norm with which ``closure`` (axes not yet shifted) closes.

    ``poses``: a guess. Returns shifts (n, 23, 2) in edge lengths, the poses that close and which
    units converged (n,): misfit below ``tolerance`` and shifts settled to a millionth of ‖AB‖.
    """
    poses = closure.held(poses)
    shifts = np.zeros((*closure.axes.shape[:2], 2))
    active = np.arange(len(poses))
    for _ in range(rounds):
        part = closure.take(active)
        part = Closure(shifted(part.axes, shifts[active]), part.leg, part.turn)
        step, change = _step(part, poses[active], shifts[active], normals(closure.axes[active]))
        poses[active] = part.moved(poses[active], step)
        shifts[active] += change
        part = Closure(shifted(closure.axes[active], shifts[active]), part.leg, part.turn)
        gap = part.gaps(poses[active]).max((1, 2))
        done = (gap < tolerance) & (np.abs(change).max((1, 2)) < 1e-6)
        active = active[~done & np.isfinite(gap) & (np.abs(shifts[active]).max((1, 2)) < 1)]
        if not len(active):
            break
    final = Closure(shifted(closure.axes, shifts), closure.leg, closure.turn)
    converged = final.gaps(poses).max((1, 2)) < tolerance
    converged[active] = False
    return shifts, poses, converged


def _step(
    closure: Closure, poses: NDArray, shifts: NDArray, across: NDArray
) -> tuple[NDArray, NDArray]:
    """Step of the poses (n, 83) and change of the shifts (n, 23, 2) of one Gauss-Newton round."""
    n = len(poses)
    by_pose, by_shift, residual = _equations(closure, poses, across)
    # Unknown are the whole shifts, so that their norm, not the step's, is least.
    target = residual - (by_shift @ shifts.reshape(n, -1, 1))[..., 0]
    wide = np.concatenate([by_pose, by_shift, target[..., None]], -1)
    others = np.setdiff1d(np.arange(wide.shape[-1]), _IN_HALVES)
    halves, left = [], [wide[:, _REST_ROWS[:, None], others]]
    for rows, columns in _HALVES:
        q, r = np.linalg.qr(wide[:, rows[:, None], columns], mode="complete")
        turned = np.swapaxes(q, -1, -2) @ wide[:, rows[:, None], others]
        halves.append((r[:, : len(columns)], turned[:, : len(columns)]))
        left.append(turned[:, len(columns) :])
    left = np.concatenate(left, 1)
    inner = len(_REST)
    q, r = np.linalg.qr(left[..., :inner], mode="complete")
    turned = np.swapaxes(q, -1, -2) @ left[..., inner:]
    found = _least_norm(turned[:, inner:], np.abs(residual).max(-1))
    known = np.concatenate([found, np.ones((n, 1))], -1)[..., None]
    step = np.zeros((n, UNKNOWNS))
    rest = -np.linalg.solve(r[:, :inner], turned[:, :inner] @ known)
    step[:, _REST] = rest[..., 0]
    known = np.concatenate([rest, known], 1)
    for (_, columns), (r, turned) in zip(_HALVES, halves, strict=True):
        step[:, columns] = -np.linalg.solve(r, turned @ known)[..., 0]
    step *= np.minimum(1, _LONGEST / np.maximum(np.abs(step).max(-1, keepdims=True), 1e-300))
    return step, found.reshape(shifts.shape) - shifts


def _least_norm(system: NDArray, residual: NDArray) -> NDArray:
    """Least-norm x of system[:, :-1] x + system[:, -1] = 0.

    Six of the equations hold by themselves once the unit closes; before, their coefficients are
    of the residual's size, which the regularisation passes over.
    """
    matrix, target = system[..., :-1], system[..., -1:]
    floor = np.clip(residual, _FLOOR, _CEILING) ** 2
    square = matrix @ np.swapaxes(matrix, -1, -2)
    square += floor[:, None, None] * np.eye(matrix.shape[-2])
    return -(np.swapaxes(matrix, -1, -2) @ np.linalg.solve(square, target))[..., 0]


def _equations(closure: Closure, poses: NDArray, across: NDArray) -> tuple[NDArray, ...]:
    """Five equations a hinge: derivative by poses (n, 115, 83), by shifts (n, 115, 46), values."""
    n, hinges = len(poses), len(CREASES)
    pick = _pick(closure, poses)
    turns = poses[:, FIRST, :3, :3] - poses[:, SECOND, :3, :3]
    moves = (turns @ across[..., None])[..., 0]
    by_shift = np.zeros((n, hinges, 5, hinges, 2))
    index = np.arange(hinges)
    for end in (0, 1):
        effect = pick[..., 3 * end : 3 * end + 3] @ moves[..., None]
        by_shift[:, index, :, index, end] = np.moveaxis(effect[..., 0], 1, 0)
    by_pose = pick @ closure.jacobian(poses).reshape(n, hinges, 6, -1)
    values = pick @ closure.residual(poses).reshape(n, hinges, 6, 1)
    return (
        by_pose.reshape(n, 5 * hinges, -1),
        by_shift.reshape(n, 5 * hinges, -1),
        values.reshape(n, -1),
    )


def _pick(closure: Closure, poses: NDArray) -> NDArray:
    """Matrices (n, 23, 5, 6): start, and end relative to the start across the axis."""
    ends = rigid.apply(poses[:, FIRST], closure.axes)
    along = ends[:, :, 1] - ends[:, :, 0]
    along /= np.linalg.norm(along, axis=-1, keepdims=True)
    helper = np.eye(3)[np.abs(along).argmin(-1)]
    first = np.cross(along, helper)
    first /= np.linalg.norm(first, axis=-1, keepdims=True)
    across = np.stack([first, np.cross(along, first)], -2)
    pick = np.zeros((*along.shape[:2], 5, 6))
    pick[..., :3, :3] = np.eye(3)
    pick[..., 3:, :3] = -across
    pick[..., 3:, 3:] = across
    return pick
