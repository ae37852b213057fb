# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strain energy of a zero-thickness unit on its way from flat to deployed (theory/hinges.md 4).

Edges are bars of energy ½·EA·L₀·ε² with Green strain ε = (L² − L₀²)/(2 L₀²). Both pyramids stand on
one planar base A_left-B-A_right-C', mirrored in it; every edge counts once, so that the edges
at the two apices count twice. By symmetry four unknowns are left at a prescribed opening 2ψ: with B
at the origin, A at r (−cos ψ, ±sin ψ, 0), C' at (−q, 0, 0) and P at (−u, 0, ±√s), every squared
length is quadratic in (r, q, u, s). Lengths are in ‖AB‖.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import angles

_COUNTS = np.array([2.0, 2.0, 4.0, 2.0, 2.0])  # edges AB, AC', PA, PB, PC' of a unit
_ROUNDS = 60


def edge_lengths(alpha: NDArray | float, beta: NDArray | float) -> NDArray:
    """Lengths of AB, AC', PA, PB, PC' in ‖AB‖: (…, 5). ``alpha``, ``beta`` in radians."""
    alpha, beta = np.broadcast_arrays(np.asarray(alpha, float), np.asarray(beta, float))
    c = angles.ratio_for(alpha, beta)
    pa = np.sin(beta) / np.sin(alpha + beta)
    pb = np.sin(alpha) / np.sin(alpha + beta)
    pc = np.sqrt(np.clip(pa**2 + c**2 - 2 * pa * c * np.cos(alpha), 0, None))
    return np.stack([np.ones_like(pa), c, pa, pb, pc], -1)


def path(alpha: NDArray | float, beta: NDArray | float, fractions: ArrayLike) -> tuple:
    """Least energy and the strains at prescribed openings.

    ``alpha``, ``beta`` radians, scalars or arrays of one shape; ``fractions`` (m,) of the opening
    θ of (3). Returns energy/(EA·‖AB‖) (…, m) and Green strains of the five edges (…, m, 5).
    ValueError where no unit has these angles (`angles.theta_for`).
    """
    fractions = np.asarray(fractions, float)
    theta = np.asarray(angles.theta_for(alpha, beta))
    lengths = edge_lengths(alpha, beta)
    shape = (*theta.shape, len(fractions))
    half = (theta[..., None] * fractions / 2).ravel()
    rest = np.broadcast_to(lengths[..., None, :], (*shape, 5)).reshape(-1, 5)
    strains = _relaxed(half, rest)
    energy = (_COUNTS * rest * strains**2).sum(-1) / 2
    return energy.reshape(shape), strains.reshape(*shape, 5)


def _start(half: NDArray, rest: NDArray) -> NDArray:
    """Unknowns with all edges at rest but P-C': (n, 4)."""
    cosine, sine = np.cos(half), np.sin(half)
    r = np.ones_like(half)
    q = cosine - np.sqrt(np.clip(rest[:, 1] ** 2 - sine**2, 0, None))
    u = (1 + rest[:, 3] ** 2 - rest[:, 2] ** 2) / (2 * cosine)
    return np.stack([r, q, u, rest[:, 3] ** 2 - u**2], -1)


def _strains(unknowns: NDArray, cosine: NDArray, rest: NDArray) -> tuple[NDArray, NDArray]:
    """Green strains (n, 5) and their gradients (n, 5, 4)."""
    r, q, u, s = unknowns.T
    zero, one = np.zeros_like(r), np.ones_like(r)
    squares = np.stack(
        [
            r * r,
            r * r - 2 * r * q * cosine + q * q,
            r * r - 2 * r * u * cosine + u * u + s,
            u * u + s,
            (u - q) ** 2 + s,
        ],
        -1,
    )
    slopes = [
        (2 * r, zero, zero, zero),
        (2 * r - 2 * q * cosine, 2 * q - 2 * r * cosine, zero, zero),
        (2 * r - 2 * u * cosine, zero, 2 * u - 2 * r * cosine, one),
        (zero, zero, 2 * u, one),
        (zero, 2 * q - 2 * u, 2 * u - 2 * q, one),
    ]
    slopes = np.stack([np.stack(row, -1) for row in slopes], 1)
    return (squares / rest**2 - 1) / 2, slopes / (2 * rest**2)[..., None]


def _bends(cosine: NDArray) -> NDArray:
    """Second derivatives of the squared lengths by (r, q, u, s): (n, 5, 4, 4)."""
    bends = np.zeros((len(cosine), 5, 4, 4))
    bends[:, :3, 0, 0] = 2
    bends[:, 1, 1, 1] = bends[:, 4, 1, 1] = 2
    bends[:, 2:, 2, 2] = 2
    bends[:, 1, 0, 1] = bends[:, 1, 1, 0] = bends[:, 2, 0, 2] = bends[:, 2, 2, 0] = -2 * cosine
    bends[:, 4, 1, 2] = bends[:, 4, 2, 1] = -2
    return bends


def _relaxed(half: NDArray, rest: NDArray) -> NDArray:
    """Strains (n, 5) of least energy, by damped Newton steps on all states at once."""
    cosine, weight = np.cos(half), _COUNTS * rest
    bends = _bends(cosine) / (2 * rest**2)[..., None, None]
    unknowns = _start(half, rest)
    strains, slopes = _strains(unknowns, cosine, rest)
    damping = np.zeros(len(half))
    active = np.arange(len(half))
    for _ in range(_ROUNDS):
        k = active
        pull = weight[k] * strains[k]
        gradient = np.einsum("ne,nei->ni", pull, slopes[k])
        matrix = np.swapaxes(weight[k][..., None] * slopes[k], 1, 2) @ slopes[k]
        matrix += (pull[:, None] @ bends[k].reshape(len(k), 5, 16)).reshape(-1, 4, 4)
        matrix += damping[k, None, None] * np.eye(4)
        step = -np.linalg.solve(matrix, gradient[..., None])[..., 0]
        found, found_slopes = _strains(unknowns[k] + step, cosine[k], rest[k])
        size = np.abs(step).max(-1)
        better = (weight[k] * found**2).sum(-1) <= (weight[k] * strains[k] ** 2).sum(-1)
        better |= size < 1e-9
        moved = k[better]
        unknowns[moved] += step[better]
        strains[moved], slopes[moved] = found[better], found_slopes[better]
        damping[k] = np.where(better, damping[k] / 10, 10 * damping[k] + 1e-3)
        active = k[~(better & (size < 1e-12))]
        if not len(active):
            break
    return strains
