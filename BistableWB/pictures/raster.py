# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles to samples by z-buffer, numpy only: hundreds of thousands of triangles in seconds.

All triangles are cut into rows, all rows into samples, many at a time; nearer ones come first, so
that most of what is hidden is left out before it costs anything.
"""

import numpy as np

_CHUNK = 1 << 21  # samples at a time
_OVERLAP = 1e-6  # samples by which neighbours overlap, so that no gap opens between them
_LEAST_AREA = 1e-9


def rasterise(corners, width, height):
    """What is seen of triangles ``corners`` (t, 3, 3): x, y in samples, z towards the viewer.

    Returns nearness (height, width), −inf where nothing is, and the number of the triangle, −1
    where none is. Row 0 is at y = 0.
    """
    near = np.full(width * height, -np.inf, np.float32)
    owner = np.full(width * height, -1, np.int32)
    corners = np.asarray(corners, float)
    slopes, facing = _slopes(corners)
    rows = _row_ranges(corners, height)
    chosen = np.flatnonzero(facing & (rows[:, 1] > rows[:, 0]))
    chosen = chosen[np.argsort(-corners[chosen, :, 2].max(1), kind="stable")]
    for part in _chunks(chosen, corners, rows, width):
        spans = _spans(corners, rows, part, width)
        _draw(near, owner, *_samples(corners, slopes, spans, width))
    return near.reshape(height, width), owner.reshape(height, width)


def _slopes(corners):
    """Change (t, 2) of z along x and y, and whether the triangle has an area."""
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    facing = np.abs(area) > _LEAST_AREA
    area = np.where(facing, area, 1)
    along_x = (first[:, 2] * second[:, 1] - second[:, 2] * first[:, 1]) / area
    along_y = (second[:, 2] * first[:, 0] - first[:, 2] * second[:, 0]) / area
    return np.stack([along_x, along_y], 1), facing


def _row_ranges(corners, height):
    """First row and the one after the last (t, 2) whose middles a triangle meets."""
    low = np.ceil(corners[:, :, 1].min(1) - 0.5 - _OVERLAP)
    high = np.floor(corners[:, :, 1].max(1) - 0.5 + _OVERLAP) + 1
    return np.clip(np.stack([low, high], 1), 0, height).astype(int)


def _chunks(chosen, corners, rows, width):
    """Parts of ``chosen`` of about `_CHUNK` samples each, at least one triangle."""
    wide = np.ptp(corners[chosen, :, 0], axis=1).clip(1, width)
    cost = np.cumsum(wide * (rows[chosen, 1] - rows[chosen, 0]) / 2)
    if not len(cost):
        return []
    return np.split(chosen, np.flatnonzero(np.diff(cost // _CHUNK)) + 1)


def _spans(corners, rows, part, width):
    """Triangle, row, first column and number of columns of every row of the triangles ``part``."""
    counts = rows[part, 1] - rows[part, 0]
    triangle = np.repeat(part, counts)
    row = _ramp(counts) + np.repeat(rows[part, 0], counts)
    y = row + 0.5
    left, right = np.full(len(row), np.inf), np.full(len(row), -np.inf)
    for a, b in ((0, 1), (1, 2), (2, 0)):
        start, end = corners[triangle, a], corners[triangle, b]
        rise = end[:, 1] - start[:, 1]
        share = (y - start[:, 1]) / np.where(np.abs(rise) > 1e-12, rise, np.inf)
        meets = (share > -_OVERLAP) & (share < 1 + _OVERLAP) & (np.abs(rise) > 1e-12)
        x = start[:, 0] + share * (end[:, 0] - start[:, 0])
        left = np.where(meets, np.minimum(left, x), left)
        right = np.where(meets, np.maximum(right, x), right)
    empty = left > right
    left, right = np.where(empty, 1.0, left), np.where(empty, 0.0, right)
    first = np.clip(np.ceil(left - 0.5 - _OVERLAP), 0, width).astype(int)
    last = np.clip(np.floor(right - 0.5 + _OVERLAP) + 1, 0, width).astype(int)
    full = last > first
    return triangle[full], row[full], first[full], (last - first)[full]


def _samples(corners, slopes, spans, width):
    """Place in the image, nearness and triangle of every sample of ``spans``."""
    triangle, row, first, count = spans
    corner, slope = corners[triangle, 0], slopes[triangle]
    start = corner[:, 2] + slope[:, 1] * (row + 0.5 - corner[:, 1])
    start += slope[:, 0] * (first + 0.5 - corner[:, 0])
    step = _ramp(count)
    near = np.repeat(start, count) + np.repeat(slope[:, 0], count) * step
    place = np.repeat(row * width + first, count) + step
    return place, near.astype(np.float32), np.repeat(triangle.astype(np.int32), count)


def _ramp(counts):
    """0, 1 … count − 1 for every count, one after the other."""
    ends = np.cumsum(counts)
    return np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - counts, counts)


def _draw(near, owner, place, depth, triangle):
    """Put samples where they are nearer than what is there; of several, the nearest one."""
    ahead = depth > near[place]
    place, depth, triangle = place[ahead], depth[ahead], triangle[ahead]
    left = np.arange(len(place))
    while len(left):
        near[place[left]] = depth[left]  # of several for one place, the last one stays
        left = left[depth[left] > near[place[left]]]
    seen = depth == near[place]
    owner[place[seen]] = triangle[seen]
