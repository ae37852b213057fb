# SPDX-License-Identifier: LGPL-2.1-or-later
"""Batched rigid motions: rotations as (…, 3, 3), poses as (…, 4, 4) that act on column vectors."""

import numpy as np
from numpy.typing import NDArray

_TINY = 1e-24
_LATER, _EARLIER = np.array([2, 0, 1]), np.array([1, 2, 0])


def skew(v: NDArray) -> NDArray:
    """Matrices [v]× with [v]× u = v × u: (…, 3) → (…, 3, 3)."""
    v = np.asarray(v, float)
    found = np.zeros((*v.shape, 3))
    found[..., 0, 1], found[..., 0, 2], found[..., 1, 2] = -v[..., 2], v[..., 1], -v[..., 0]
    found[..., 1, 0], found[..., 2, 0], found[..., 2, 1] = v[..., 2], -v[..., 1], v[..., 0]
    return found


def vee(matrices: NDArray) -> NDArray:
    """Twice the axial vector of the skew part, inverse of `skew` up to the factor 2."""
    found: NDArray = matrices[..., _LATER, _EARLIER] - matrices[..., _EARLIER, _LATER]
    return found


def rotation(vector: NDArray) -> NDArray:
    """Rotation by |vector| radians about vector (Rodrigues): (…, 3) → (…, 3, 3)."""
    vector = np.asarray(vector, float)
    square = (vector * vector).sum(-1)[..., None, None]
    angle = np.sqrt(square)
    small = square < _TINY
    safe = np.where(small, 1.0, angle)
    k = skew(vector)
    first = np.where(small, 1.0, np.sin(safe) / safe)
    second = np.where(small, 0.5, 2 * (np.sin(safe / 2) / safe) ** 2)
    return np.eye(3) + first * k + second * (k @ k)


def rotation_vector(matrices: NDArray) -> NDArray:
    """Inverse of `rotation` for angles below π: (…, 3, 3) → (…, 3)."""
    twice = vee(matrices)
    sine = np.linalg.norm(twice, axis=-1)  # 2 sin(angle)
    cosine = np.trace(matrices, axis1=-2, axis2=-1) - 1  # 2 cos(angle)
    small = sine < 1e-12
    factor = np.where(small, 0.5, np.arctan2(sine, cosine) / np.where(small, 1.0, sine))
    return factor[..., None] * twice


def tangent(vector: NDArray) -> NDArray:
    """Matrices J with rotation(vector + d) ≈ rotation(J d) rotation(vector): (…, 3) → (…, 3, 3)."""
    vector = np.asarray(vector, float)
    square = (vector * vector).sum(-1)[..., None, None]
    small = square < 1e-6
    safe = np.where(small, 1.0, square)
    angle = np.sqrt(safe)
    first = np.where(small, 0.5 - square / 24, 2 * np.sin(angle / 2) ** 2 / safe)
    second = np.where(small, 1 / 6 - square / 120, (angle - np.sin(angle)) / (safe * angle))
    k = skew(vector)
    return np.eye(3) + first * k + second * (k @ k)


def twist_angle(matrices: NDArray, axis: NDArray) -> NDArray:
    """Angle about the unit vector ``axis`` in rotation = swing · twist: (…, 3, 3), (…, 3) → (…)."""
    along = (vee(matrices) * axis).sum(-1)
    return 2 * np.arctan2(along, 1 + np.trace(matrices, axis1=-2, axis2=-1))


def pose(rotations: NDArray, translations: NDArray) -> NDArray:
    """Poses of rotations (…, 3, 3) followed by translations (…, 3)."""
    result = np.zeros((*rotations.shape[:-2], 4, 4))
    result[..., :3, :3] = rotations
    result[..., :3, 3] = translations
    result[..., 3, 3] = 1
    return result


def apply(poses: NDArray, points: NDArray) -> NDArray:
    """Images of points (…, k, 3) under poses (…, 4, 4)."""
    return points @ np.swapaxes(poses[..., :3, :3], -1, -2) + poses[..., None, :3, 3]


def inverse(poses: NDArray) -> NDArray:
    """Inverse rigid motions."""
    back = np.swapaxes(poses[..., :3, :3], -1, -2)
    return pose(back, -(back @ poses[..., :3, 3:])[..., 0])


def fit(before: NDArray, after: NDArray) -> NDArray:
    """Poses that carry points (…, k, 3) best onto others, least squares (Kabsch)."""
    middle, target = before.mean(-2, keepdims=True), after.mean(-2, keepdims=True)
    u, _, vt = np.linalg.svd(np.swapaxes(before - middle, -1, -2) @ (after - target))
    flip = np.ones(u.shape[:-1])
    flip[..., 2] = np.sign(np.linalg.det(u @ vt))
    turn = np.swapaxes((u * flip[..., None, :]) @ vt, -1, -2)
    return pose(turn, (target - middle @ np.swapaxes(turn, -1, -2))[..., 0, :])


def between(first: NDArray, second: NDArray, fraction: NDArray | float) -> NDArray:
    """Poses part of the way: rotations by the shorter arc, translations straight."""
    fraction = np.asarray(fraction, float)[..., None]
    turn = rotation_vector(np.swapaxes(first[..., :3, :3], -1, -2) @ second[..., :3, :3])
    step = fraction * (second[..., :3, 3] - first[..., :3, 3])
    return pose(first[..., :3, :3] @ rotation(fraction * turn), first[..., :3, 3] + step)
