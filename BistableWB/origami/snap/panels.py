# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elastic panels: one convex plate element of high degree, condensed to its knuckles.

A panel's core is a convex polygon of one thickness. Its bending (Kirchhoff) and its stretching in
the plane (plane stress) are polynomials of one total degree over the whole core, so that nothing is
meshed; every knuckle moves as the best rigid motion of the root of its tab. What is left is the
compliance of the panel at its knuckles, and its softest modes (docs/theory/hinges.md 4).

Frame: the unit's flat frame, plan (x, z), stack along +y; rotations are vectors (ωx, ωy, ωz).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

DEGREE = 12  # of the polynomials: compliance of the softest modes to some percent
_TURN, _BAND, _MOST = 0.315, 3.0, 0.8
_ALONG, _ACROSS = np.polynomial.legendre.leggauss(4), np.polynomial.legendre.leggauss(2)


@dataclass(frozen=True)
class Plate:
    """A convex panel and the roots of its tabs.

    ``core``: corners (k, 2) in plan, mm, counter-clockwise in (x, z); ``thickness`` mm;
    ``roots``: (n, 2, 2) start and end of each tab on the core's edge, mm; ``stiffening``: of its
    stretching and its bending, by what it is fused to.
    """

    core: NDArray
    thickness: float
    roots: NDArray
    stiffening: tuple[float, float] = (1.0, 1.0)


def in_block(thickness: float, gap: float) -> tuple[float, float]:
    """Stiffening of a contact panel that is half of a block of two panels and their gap, mm."""
    whole = (2 * thickness + gap) / thickness
    return whole / 2, whole**3 / 2


def compliance(plate: Plate, poisson: float, degree: int = DEGREE) -> NDArray:
    """Compliance (6n, 6n) at the roots of n tabs, for Young's modulus 1 MPa.

    Rows of a tab: displacement (x, y, z) of its root's middle, mm, and rotation; its loads are
    force (N) and moment (N·mm) there. Loads that are not in balance are balanced by a body force
    (inertia relief), so that only the strain counts and no support is needed.
    """
    middle, scale = _box(plate.core)
    points, weights = _quadrature(plate.core, degree)
    stiffness, mass, rigid = _energy(points, weights, middle, scale, plate, poisson, degree)
    held = mass @ rigid
    inner = np.linalg.inv(rigid.T @ held)
    motions = _motions(plate, middle, scale, degree)
    balanced = motions - (motions @ rigid) @ inner @ held.T
    size = np.trace(stiffness) / len(stiffness) / (held**2).sum()
    solved = np.linalg.solve(stiffness + size * held @ held.T, balanced.T)
    found = balanced @ solved
    return (found + found.T) / 2


def modes(compliance_: NDArray, count: int) -> NDArray:
    """Columns (rows, count) Φ with compliance ≈ Φ Φᵀ: the softest modes, energy ½ |z|² each."""
    values, vectors = np.linalg.eigh(compliance_)
    kept = np.argsort(values)[::-1][:count]
    return vectors[:, kept] * np.sqrt(np.maximum(values[kept], 0.0))


def _box(core: NDArray) -> tuple[NDArray, NDArray]:
    low, high = core.min(0), core.max(0)
    return (low + high) / 2, (high - low) / 2


@lru_cache(maxsize=8)
def _unit_triangle(order: int) -> tuple[NDArray, NDArray]:
    """Quadrature of the triangle (0, 0), (1, 0), (0, 1), exact for polynomials of the order."""
    nodes, weights = np.polynomial.legendre.leggauss(order // 2 + 2)
    nodes, weights = (nodes + 1) / 2, weights / 2
    a, b = np.meshgrid(nodes, nodes, indexing="ij")
    return np.stack([a, b * (1 - a)], -1).reshape(-1, 2), (
        np.outer(weights * (1 - nodes), weights).ravel()
    )


def _quadrature(core: NDArray, degree: int) -> tuple[NDArray, NDArray]:
    """Points (m, 2) and weights (m,) that integrate products of two basis functions exactly."""
    at, weight = _unit_triangle(2 * degree)
    first, second = core[1:-1] - core[0], core[2:] - core[0]
    areas = np.abs(first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0])
    points = core[0] + at[:, :1] * first[:, None] + at[:, 1:] * second[:, None]
    return points.reshape(-1, 2), (areas[:, None] * weight).ravel()


@lru_cache(maxsize=8)
def _pairs(degree: int) -> tuple[NDArray, NDArray]:
    i, j = np.meshgrid(np.arange(degree + 1), np.arange(degree + 1), indexing="ij")
    kept = i + j <= degree
    return i[kept], j[kept]


@lru_cache(maxsize=8)
def _derivatives(degree: int) -> list[NDArray]:
    """Matrices that take Legendre values to those of the first and the second derivative."""
    eye = np.eye(degree + 1)
    found = [eye]
    for order in (1, 2):
        rows = np.polynomial.legendre.legder(eye, order)
        found.append(np.concatenate([rows, np.zeros((degree + 1 - len(rows), degree + 1))]))
    return found


def _values(points: NDArray, middle: NDArray, scale: NDArray, degree: int) -> dict[str, NDArray]:
    """Basis functions and their derivatives at points: {"": …, "x": …, "xz": …} (m, k) each."""
    i, j = _pairs(degree)
    local = (points - middle) / scale
    table = [np.polynomial.legendre.legvander(local[:, c], degree) for c in (0, 1)]
    by_x, by_z = (
        [table[c] @ matrix / scale[c] ** k for k, matrix in enumerate(_derivatives(degree))]
        for c in (0, 1)
    )
    orders = {"": (0, 0), "x": (1, 0), "z": (0, 1), "xx": (2, 0), "xz": (1, 1), "zz": (0, 2)}
    return {name: by_x[a][:, i] * by_z[b][:, j] for name, (a, b) in orders.items()}


def _energy(
    points: NDArray,
    weights: NDArray,
    middle: NDArray,
    scale: NDArray,
    plate: Plate,
    poisson: float,
    degree: int,
) -> tuple[NDArray, ...]:
    """Stiffness and mass (3k, 3k) of the fields (u_x, u_z, w), and rigid motions (3k, 6)."""
    f = _values(points, middle, scale, degree)
    k = f[""].shape[1]
    t = plate.thickness
    plane = np.array([[1, poisson, 0], [poisson, 1, 0], [0, 0, (1 - poisson) / 2]])
    plane = plane / (1 - poisson**2)
    zero = np.zeros_like(f[""])
    strain = np.stack(
        [np.hstack([f["x"], zero]), np.hstack([zero, f["z"]]), np.hstack([f["z"], f["x"]])]
    )
    bend = np.stack([f["xx"], f["zz"], 2 * f["xz"]])
    stiffness = np.zeros((3 * k, 3 * k))
    for rows, factor, part in (
        (strain, plate.stiffening[0] * t, slice(0, 2 * k)),
        (bend, plate.stiffening[1] * t**3 / 12, slice(2 * k, 3 * k)),
    ):
        turned = np.tensordot(plane, rows * (factor * weights)[:, None], 1)
        stiffness[part, part] = np.einsum("cmi,cmj->ij", rows, turned, optimize=True)
    stiffness[2 * k :, 2 * k :] -= _edges(plate, points, weights, f, poisson)
    gram = f[""].T @ (f[""] * weights[:, None])
    mass = np.kron(np.eye(3), gram)
    i, j = _pairs(degree)
    one, x, z = ((i == a) & (j == b) for a, b in ((0, 0), (1, 0), (0, 1)))
    rigid = np.zeros((3, k, 6))
    rigid[0, one, 0] = rigid[1, one, 1] = rigid[2, one, 2] = 1
    rigid[0, z, 3], rigid[1, x, 3] = scale[1], -scale[0]
    rigid[2, x, 4], rigid[2, z, 5] = scale[0], scale[1]
    return stiffness, mass, rigid.reshape(3 * k, 6)


def _edges(
    plate: Plate, points: NDArray, weights: NDArray, f: Mapping[str, NDArray], poisson: float
) -> NDArray:
    """Twisting stiffness (k, k) that thin plate theory finds too much along free edges.

    There shear stresses turn round, as if for twisting the plate were narrower by `_TURN` of its
    thickness: Saint-Venant's torsion of a strip, b t³ (1 − 0.63 t / b) / 3. Taken off a band of
    `_BAND` thicknesses, so that what is left stays stiff.
    """
    t, band = plate.thickness, _BAND * plate.thickness
    along = np.roll(plate.core, -1, 0) - plate.core
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    arms = points[:, None] - plate.core
    depths = np.abs(arms[..., 0] * along[:, 1] - arms[..., 1] * along[:, 0])
    shares = 2 * _TURN * t / band * np.maximum(1 - depths / band, 0)
    shares /= np.maximum(shares.sum(1, keepdims=True) / _MOST, 1)
    shear = plate.stiffening[1] * t**3 / (6 * (1 + poisson))
    taken = np.zeros((f["xz"].shape[1],) * 2)
    for share, (c, s) in zip(shares.T, along, strict=True):
        near = share > 0
        # of the edge and across it
        twist = (c * c - s * s) * f["xz"][near] + c * s * (f["zz"] - f["xx"])[near]
        taken += twist.T @ ((weights * share)[near, None] * shear * twist)
    return taken


def _motions(plate: Plate, middle: NDArray, scale: NDArray, degree: int) -> NDArray:
    """Matrix (6n, 3k) from the fields' coefficients to the best rigid motion of each root."""
    nodes, share = _ALONG
    levels, level_share = _ACROSS
    start, end = plate.roots[:, 0], plate.roots[:, 1]
    n, half = len(start), (end - start) / 2
    points = ((start + end) / 2)[:, None] + nodes[:, None] * half[:, None]
    f = _values(points.reshape(-1, 2), middle, scale, degree)
    k = f[""].shape[1]
    height = levels * plate.thickness / 2
    # displacement (n, along, levels, 3, 3k) of points of the root: u − y grad w, w
    field = np.zeros((n * len(nodes), len(height), 3, 3, k))
    field[:, :, 0, 0] = field[:, :, 2, 1] = field[:, :, 1, 2] = f[""][:, None]
    field[:, :, 0, 2] = -height[:, None] * f["x"][:, None]
    field[:, :, 2, 2] = -height[:, None] * f["z"][:, None]
    arms = np.zeros((n, len(nodes), len(height), 3))
    arms[..., [0, 2]] = (nodes[:, None] * half[:, None])[:, :, None]
    arms[..., 1] = height
    return _rigid_fit(arms.reshape(n, -1, 3), field.reshape(n, -1, 3, 3 * k),
                      np.outer(share, level_share).ravel() / 4)  # fmt: skip


def _rigid_fit(arms: NDArray, field: NDArray, share: NDArray) -> NDArray:
    """Least-squares rigid motions (6n, columns) of points with ``arms`` about their middle."""
    n = len(arms)
    x, y, z = np.moveaxis(arms, -1, 0)
    o = np.zeros_like(x)
    turn = np.stack([o, z, -y, -z, o, x, y, -x, o], -1).reshape(n, -1, 3, 3)  # ω × arm
    inertia = np.einsum("p,npki,npkj->nij", share, turn, turn)
    moment = np.einsum("p,npki,npkc->nic", share, turn, field, optimize=True)
    place = np.einsum("p,npkc->nkc", share, field, optimize=True)
    spin = np.linalg.solve(inertia, moment)
    return np.concatenate([place, spin], 1).reshape(6 * n, -1)
