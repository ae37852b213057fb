# SPDX-License-Identifier: LGPL-2.1-or-later
"""Orthographic cameras: where points are seen, and how near they are."""

from dataclasses import dataclass

import numpy as np


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
