# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shaded pictures of panels by z-buffer, numpy only: what is hidden is hidden, at any angle.

Matplotlib sorts whole polygons by depth and gets tubes wrong. Here every pixel is decided by
itself; edges are drawn where the visible panel changes, so they too are hidden exactly.
"""

from dataclasses import dataclass

import numpy as np

from .. import colours
from .raster import rasterise

_SAMPLES = 3  # a pixel's side in samples: smooth edges
_LIGHT = np.array([-0.30, 0.62, 0.70])  # from the viewer's upper left
_AMBIENT = 0.70
_SHADOW = 0.42  # strength of the depth shading


@dataclass(frozen=True)
class Camera:
    """Orthographic view: rows of ``axes`` (3, 3) are right, up and towards the viewer."""

    axes: np.ndarray

    def seen(self, points):
        """Points (…, 3) in the camera's frame: right, up, nearness (mm)."""
        return np.asarray(points) @ self.axes.T


def camera(forward, up, elevation):
    """A `Camera` that looks along ``forward`` (3,) from ``elevation`` (radians) above it."""
    up = np.asarray(up, float) / np.linalg.norm(up)
    ahead = np.asarray(forward, float) - (np.asarray(forward, float) @ up) * up
    ahead = ahead / np.linalg.norm(ahead)
    near = -np.cos(elevation) * ahead + np.sin(elevation) * up
    right = np.cross(ahead, up)
    return Camera(np.stack([right, np.cross(near, right), near]))


def bounds(view, polygons):
    """(left, right, bottom, top) in mm of polygons as ``view`` sees them."""
    seen = np.concatenate([view.seen(p) for p in polygons])
    return seen[:, 0].min(), seen[:, 0].max(), seen[:, 1].min(), seen[:, 1].max()


def render(view, polygons, fills, resolution, line=1.2):
    """Picture of ``polygons`` ((k, 3) corners each) filled with "#RRGGBB" ``fills``.

    ``resolution``: pixels per mm; ``line``: width of edges in pixels. Returns an RGBA image
    (rows from the top, float 0…1, transparent where nothing is) and its (left, right, bottom, top).
    """
    scale = resolution * _SAMPLES
    left, right, bottom, top = bounds(view, polygons)
    margin = 2 * line / resolution
    left, bottom = left - margin, bottom - margin
    width = _SAMPLES * int(np.ceil((right + margin - left) * resolution))
    height = _SAMPLES * int(np.ceil((top + margin - bottom) * resolution))
    shades = np.empty((len(polygons) + 1, 3), np.float32)
    triangles, polygon_of = [], []
    for k, polygon in enumerate(polygons):
        seen = view.seen(polygon)
        shades[k] = np.array(colours.rgb(fills[k])) * _brightness(seen)
        seen = (seen - [left, bottom, 0]) * [scale, scale, 1]
        triangles += [seen[[0, corner, corner + 1]] for corner in range(1, len(seen) - 1)]
        polygon_of += [k] * (len(seen) - 2)
    depth, triangle = rasterise(np.array(triangles), width, height)
    owner = np.array([*polygon_of, -1])[triangle]
    shading = _depth_shading(depth[::_SAMPLES, ::_SAMPLES], resolution)
    image = shades[owner] * np.kron(shading, np.ones((_SAMPLES, _SAMPLES), np.float32))[..., None]
    edges = _edges(owner, line * _SAMPLES)
    image[edges] = colours.rgb(colours.INK)
    covered = (owner >= 0) | edges
    extent = (left, left + width / scale, bottom, bottom + height / scale)
    return _downsampled(image, covered)[::-1], extent


def _brightness(seen):
    """Light on a panel, either side alike."""
    normal = np.cross(seen[1] - seen[0], seen[2] - seen[0])
    normal /= max(np.linalg.norm(normal), 1e-12)
    normal *= 1 if normal[2] >= 0 else -1
    light = _LIGHT / np.linalg.norm(_LIGHT)
    return _AMBIENT + (1.04 - _AMBIENT) * max(float(normal @ light), 0.0)


def _edges(owner, width):
    """Samples within ``width``/2 of a change of the visible panel."""
    changed = np.zeros(owner.shape, bool)
    for axis in (0, 1):
        here = [slice(None)] * 2
        there = [slice(None)] * 2
        here[axis], there[axis] = slice(1, None), slice(None, -1)
        differs = owner[tuple(here)] != owner[tuple(there)]
        changed[tuple(here)] |= differs
        changed[tuple(there)] |= differs
    reach = round((width - 2) / 2)
    rows, columns = np.nonzero(changed)
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            if dx * dx + dy * dy <= reach * reach + 1:
                y = np.clip(rows + dy, 0, owner.shape[0] - 1)
                x = np.clip(columns + dx, 0, owner.shape[1] - 1)
                changed[y, x] = True
    return changed


def _depth_shading(depth, resolution):
    """Darkening of what lies behind its surroundings: recesses read as recesses."""
    solid = np.isfinite(depth)
    weight = solid.astype(np.float32)
    filled = np.where(solid, depth, 0)
    radius = max(int(0.03 * max(depth.shape)), 2)
    for _ in range(2):
        filled, weight = _box_blur(filled, radius), _box_blur(weight, radius)
    mean = filled / np.maximum(weight, 1e-6)
    behind = np.where(solid, np.clip(mean - depth, 0, None), 0)
    return 1 - _SHADOW * (1 - np.exp(-behind * resolution / (8 * radius))).astype(np.float32)


def _box_blur(image, radius):
    for axis in (0, 1):
        pad = [(0, 0), (0, 0)]
        pad[axis] = (radius + 1, radius)
        total = np.cumsum(np.pad(image, pad, mode="edge"), axis=axis, dtype=np.float64)
        size = 2 * radius + 1
        low, high = [slice(None)] * 2, [slice(None)] * 2
        low[axis], high[axis] = slice(None, -size), slice(size, None)
        image = ((total[tuple(high)] - total[tuple(low)]) / size).astype(np.float32)
    return image


def _downsampled(image, covered):
    """RGBA of _SAMPLES² samples a pixel."""
    height, width = (n // _SAMPLES for n in covered.shape)
    shape = (height, _SAMPLES, width, _SAMPLES)
    alpha = covered.reshape(shape).mean((1, 3))
    colour = (image * covered[..., None]).reshape(*shape, 3).sum((1, 3))
    colour /= np.maximum(covered.reshape(shape).sum((1, 3)), 1)[..., None]
    return np.clip(np.concatenate([colour, alpha[..., None]], -1), 0, 1)
