# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shaded pictures of solids: light, a cast shadow, soft shade in recesses, crisp edges. numpy only.

Every sample knows its triangle and its place in space; everything else follows from these two.
"""

from dataclasses import dataclass

import numpy as np

from .. import colours
from .raster import rasterise

_LIGHT = np.array([-0.42, 0.55, 0.74])  # from the viewer's upper left
_SKY, _FRONT, _SUN, _GROUND_SHADE = 0.67, 0.15, 0.30, 0.22
_CREASE = np.cos(np.radians(24))  # neighbouring faces that meet at more than this show an edge
_RECESS = 3.0  # mm around a point that shade it
_HATCH, _HATCH_SPACING = 0.72, 36  # brightness and, in samples, spacing of a section's hatching
_GRID = 10.0  # mm between the lines of a print bed


@dataclass(frozen=True)
class Solid:
    """A body to draw: triangles ``corners`` (t, 3, 3) mm, anticlockwise from outside, "#RRGGBB"."""

    corners: np.ndarray
    colour: str


@dataclass(frozen=True)
class Ground:
    """Horizontal rectangle from corner ``low`` to ``high`` (2,) at height ``z``, mm.

    A print ``bed`` is drawn with a grid; any other ground shows only the shadows on it.
    """

    low: np.ndarray
    high: np.ndarray
    z: float
    bed: bool = False

    @property
    def corners(self):
        """Two triangles (2, 3, 3)."""
        (x0, y0), (x1, y1) = self.low, self.high
        quad = np.array([[x, y, self.z] for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))])
        return quad[[[0, 1, 2], [0, 2, 3]]]


def shadow_points(view, things, z):
    """Where the shadows of the corners of `Solid` bodies fall on the ground at ``z``: (n, 3)."""
    toward = view.axes.T @ _LIGHT
    points = np.concatenate([thing.corners[::5].reshape(-1, 3) for thing in things])
    return points - toward * ((points[:, 2:] - z) / toward[2])


def render_solids(
    view, solids, resolution, grounds=(), frame=None, cut=None, samples=2, bold=False
):
    """Picture of `Solid` bodies as a `rendering.Camera` sees them.

    ``resolution``: pixels per mm; ``frame``: corners (2, 2) of the picture in mm of the view, all
    that there is if None; ``cut``: a point of a plane and the normal on the side that is taken
    away; ``bold``: thicker edges. Returns an RGBA image (rows from the top, 0…1, transparent where
    nothing is) and its (left, right, bottom, top) in mm.
    """
    scene = _Scene(view, solids, grounds, cut)
    scale = resolution * samples
    if frame is None:
        points = scene.seen.reshape(-1, 3)[:, :2]
        frame = np.stack([points.min(0), points.max(0)]) + np.array([[-3], [3]]) / resolution
    low, high = frame
    width, height = (samples * np.ceil((high - low) * resolution)).astype(int)
    near, owner = rasterise((scene.seen - [*low, 0]) * [scale, scale, 1], width, height)
    near = scene.capped(near, owner, low, scale)
    image = scene.albedo(near, owner, low, scale)
    image *= _brightness(scene, near, owner, low, scale, samples)[..., None]
    weight = _edges(scene, near, owner, scale)
    weight = (_grown(weight) if bold else weight)[..., None]
    image = image * (1 - weight) + weight * np.array(colours.rgb(colours.INK), np.float32)
    extent = (low[0], low[0] + width / scale, low[1], low[1] + height / scale)
    return _downsampled(image, owner >= 0, samples)[::-1], extent


class _Scene:
    """All triangles that face the viewer, in the camera's frame, with what is known of each.

    Of a cut body the inside shows too: where it does, the cut's plane is what one sees.
    """

    def __init__(self, view, solids, grounds, cut=None):
        self.view, self.grounds, self.first_ground = view, grounds, 2 * len(solids)
        parts = [*(s.corners for s in solids), *(g.corners for g in grounds)]
        numbers = [*range(len(solids)), *range(self.first_ground, self.first_ground + len(grounds))]
        body = np.repeat(numbers, [len(part) for part in parts])
        everything = view.seen(np.concatenate(parts)).astype(np.float32)
        if cut is not None:
            normal = np.asarray(cut[1], float) / np.linalg.norm(cut[1])
            cut = view.seen(np.asarray(cut[0], float)), view.seen(normal)
            everything, body = _cut_off(everything, body, *cut)
        self.cut, self.light = cut, _LIGHT / np.linalg.norm(_LIGHT)
        normals = _normals(everything)
        self.casting = everything[(normals @ self.light > 0) & (body < self.first_ground)]
        front, back = normals[:, 2] > 1e-6, normals[:, 2] < -1e-6
        if cut is not None:
            normals[back] = cut[1]
            body = np.where(back, body + len(solids), body)
            front |= back
        self.seen = everything[front]
        self.normals = np.append(normals[front], [[0, 0, 1]], 0).astype(np.float32)
        self.body = np.append(body[front], -1)
        paints = np.array([colours.rgb(s.colour) for s in solids]).reshape(-1, 3)
        white = np.ones((len(grounds) + 1, 3))
        self.colours = np.concatenate([paints, 1 - 0.7 * (1 - paints), white]).astype(np.float32)

    def _hatched(self, body):
        """Samples (h, w) on the lines of a section's hatching, which leans by turns."""
        rows, columns = np.ogrid[: body.shape[0], : body.shape[1]]
        lean = np.where(self.colours[body].sum(-1) > 1.9, 1, -1)
        line = (columns + lean * rows) % _HATCH_SPACING < _HATCH_SPACING // 6
        return line & (body >= self.first_ground // 2) & (body < self.first_ground)

    def capped(self, near, owner, low, scale):
        """Nearness with the cut's plane where one looks into a cut body."""
        if self.cut is None:
            return near
        point, normal = self.cut
        body = self.body[owner]
        inside = (body >= self.first_ground // 2) & (body < self.first_ground)
        rows, columns = np.nonzero(inside)
        places = _places(rows, columns, 0.0 * rows, low, scale) - point
        near = near.copy()
        near[inside] = -(places[:, :2] @ normal[:2]) / normal[2] + point[2]
        return near

    def albedo(self, near, owner, low, scale):
        """Colour (h, w, 3) of what every sample shows, without light."""
        body = self.body[owner]
        image = self.colours[body]
        if self.cut is not None:
            image[self._hatched(body)] *= _HATCH
        for k, ground in enumerate(self.grounds):
            if ground.bed:
                rows, columns = np.nonzero(body == self.first_ground + k)
                places = _places(rows, columns, near[rows, columns], low, scale)
                image[rows, columns] = _bed_colour(ground, places @ self.view.axes, 1 / scale)
        return image


def _normals(corners):
    """Unit normals (t, 3); zeros for triangles without an area."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)


def _cut_off(corners, body, point, normal):
    """Triangles without what lies in front of a plane, and the number of each one's body."""
    height = (corners - point) @ normal
    whole = (height <= 0).all(1)
    parts, bodies = [corners[whole]], [body[whole]]
    for kept in (1, 2):
        for k in range(3):
            order = [k, (k + 1) % 3, (k + 2) % 3]  # the odd one out comes first
            h = height[:, order]
            above = h > 0 if kept == 1 else h <= 0
            chosen = np.flatnonzero(~above[:, 0] & above[:, 1] & above[:, 2])
            a, b, c = np.moveaxis(corners[chosen][:, order], 1, 0)
            h = h[chosen, :, None]
            on_b = a + (b - a) * h[:, 0] / (h[:, 0] - h[:, 1])
            on_c = a + (c - a) * h[:, 0] / (h[:, 0] - h[:, 2])
            found = [(a, on_b, on_c)] if kept == 1 else [(on_b, b, c), (on_b, c, on_c)]
            for triangle in found:
                parts.append(np.stack(triangle, 1))
                bodies.append(body[chosen])
    return np.concatenate(parts), np.concatenate(bodies)


def _places(rows, columns, near, low, scale):
    """Points (n, 3) of samples in the camera's frame."""
    return np.stack([(columns + 0.5) / scale + low[0], (rows + 0.5) / scale + low[1], near], -1)


def _bed_colour(ground, points, sample):
    """Colour (n, 3) of a print bed: a grid of lines, a frame, faintly blue."""
    paper, ink = np.array(colours.rgb("#EDF1F5")), np.array(colours.rgb("#C6D0DA"))
    flat = points[:, :2] - ground.low
    off = np.abs((flat + _GRID / 2) % _GRID - _GRID / 2).min(1)
    edge = np.minimum(flat, ground.high - ground.low - flat).min(1)
    line = np.clip((0.22 - off) / sample + 0.5, 0, 1) * 0.7
    line = np.maximum(line, np.clip((0.9 - edge) / sample + 0.5, 0, 1))
    return (paper + line[:, None] * (ink - paper)).astype(np.float32)


def _brightness(scene, near, owner, low, scale, samples):
    """Brightness (h, w) by light, shadow and recesses; the last two are found once a pixel."""
    sunlit, sky = _shadows(
        scene, near[::samples, ::samples], owner[::samples, ::samples], low, scale / samples
    )
    sunlit, sky = _upscaled(sunlit, samples), _upscaled(sky, samples)
    up = scene.view.axes @ np.array([0, 0, 1.0])
    diffuse = _SKY + 0.06 * (scene.normals @ up) + _FRONT * scene.normals[:, 2]
    diffuse = diffuse.astype(np.float32)
    direct = (_SUN * np.clip(scene.normals @ scene.light, 0, 1)).astype(np.float32)
    solid = diffuse[owner] * sky + direct[owner] * sunlit
    plain = 1 - _GROUND_SHADE * (1 - sunlit) - 0.5 * (1 - sky)
    return np.where(scene.body[owner] >= scene.first_ground, plain, solid)


def _shadows(scene, near, owner, low, scale):
    """Shares (h, w) of the sun and of the sky that reach what is seen; 1 where nothing is."""
    there = owner >= 0
    normals = scene.normals[owner]
    rows, columns = np.nonzero(there)
    places = _places(rows, columns, near[rows, columns], low, scale)
    lit = np.ones(near.shape, np.float32)
    lit[rows, columns] = _lit(scene, places, normals[rows, columns], 1 / scale)
    ground = scene.body[owner] >= scene.first_ground
    softened = _blurred(lit, there & ~ground, 1) + _blurred(lit, ground, 3)
    sky = _open_sky(near, normals, there, scale)
    return np.where(there, softened, 1), np.where(there, sky, 1)


def _lit(scene, places, normals, pixel):
    """Share (n,) of the sun that reaches points (n, 3) of the camera's frame."""
    if not len(scene.casting):
        return np.ones(len(places), np.float32)
    toward = scene.light
    right = np.cross([0, 1.0, 0], toward)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(toward, right), toward])
    cell = 1.2 * pixel
    casting = scene.casting @ axes.T
    low = casting.reshape(-1, 3)[:, :2].min(0) - 2 * cell
    size = np.ceil((casting.reshape(-1, 3)[:, :2].max(0) + 2 * cell - low) / cell).astype(int)
    depth, _ = rasterise((casting - [*low, 0]) * [1 / cell, 1 / cell, 1], *size)
    here = (places + 1.5 * cell * normals) @ axes.T
    total = np.zeros(len(places), np.float32)
    spread = np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]]) * 1.0
    for shift in spread:
        x, y = np.floor((here[:, :2] - low) / cell + shift).astype(int).T
        inside = (x >= 0) & (x < size[0]) & (y >= 0) & (y < size[1])
        blocked = np.zeros(len(places), bool)
        blocked[inside] = depth[y[inside], x[inside]] > here[inside, 2] + 1.5 * cell
        total += ~blocked
    return total / len(spread)


def _open_sky(near, normals, there, scale):
    """Share (h, w) of the sky that is not hidden by what stands around: 1 in the open."""
    hidden = np.zeros(near.shape, np.float32)
    depth = np.where(there, near, -1e6).astype(np.float32)
    directions = np.exp(2j * np.pi * (np.arange(8) + 0.5) / 8)
    radii = (0.25 * _RECESS, 0.6 * _RECESS, _RECESS)
    count = 0
    for ring, radius in enumerate(radii):
        for direction in directions * np.exp(1j * ring):
            dx, dy = round(direction.real * radius * scale), round(direction.imag * radius * scale)
            if dx or dy:
                hidden += _hidden_by(depth, normals, dx, dy, scale)
                count += 1
    return 1 - np.clip(1.5 * hidden / max(count, 1), 0, 0.85)


def _hidden_by(depth, normals, dx, dy, scale):
    """How much of the sky the point (dx, dy) pixels away takes: (h, w)."""
    taken = np.zeros(depth.shape, np.float32)
    here, there = _shifted(depth.shape, dx, dy)
    rise = depth[there] - depth[here]
    x, y = np.float32(dx / scale), np.float32(dy / scale)
    normal = normals[here]
    above = normal[..., 0] * x + normal[..., 1] * y + normal[..., 2] * rise
    reach = np.sqrt(x * x + y * y + rise * rise)
    fading = np.clip(1.5 - reach / (2 * _RECESS), 0, 1)
    taken[here] = np.clip(above / np.maximum(reach, 1e-6) - 0.08, 0, 1) * fading
    return taken


def _shifted(shape, dx, dy):
    """Slices of an array and of the same moved by (dx, dy)."""
    here, there = [], []
    for size, step in zip(shape, (dy, dx), strict=True):
        here.append(slice(max(0, -step), size - max(0, step)))
        there.append(slice(max(0, step), size - max(0, -step)))
    return tuple(here), tuple(there)


def _blurred(image, there, radius):
    """Mean over a square of pixels, of those that are ``there``; 0 elsewhere."""
    weight = there.astype(np.float32)
    image = image * weight
    for axis in (0, 1):
        image, weight = (_summed(a, radius, axis) for a in (image, weight))
    return np.where(there, image / np.maximum(weight, 1e-6), 0)


def _summed(image, radius, axis):
    """Sum of 2 radius + 1 neighbours along an axis."""
    pad = [(0, 0), (0, 0)]
    pad[axis] = (radius + 1, radius)
    total = np.cumsum(np.pad(image, pad), axis, dtype=np.float64)
    ends = total.take(range(2 * radius + 1, total.shape[axis]), axis)
    return (ends - total.take(range(total.shape[axis] - 2 * radius - 1), axis)).astype(np.float32)


def _edges(scene, near, owner, scale):
    """Weight (h, w) of the lines: full where a body ends, fainter at creases within one."""
    body = scene.body[owner]
    ground = body >= scene.first_ground
    weight = np.zeros(near.shape, np.float32)
    normals = scene.normals[owner]
    for axis in (0, 1):
        here, there = _shifted(near.shape, 1 - axis, axis)
        here, there = there, here
        same = body[here] == body[there]
        both_ground = (ground[here] | (body[here] < 0)) & (ground[there] | (body[there] < 0))
        turn = np.einsum("hwk,hwk->hw", normals[here], normals[there]) < _CREASE
        slope = np.minimum(normals[here][..., 2], normals[there][..., 2])
        with np.errstate(invalid="ignore"):
            step = np.abs(near[here] - near[there]) * slope > 0.35 + 3 / scale
        strength = np.where(same, np.where(step, 0.75, np.where(turn, 0.45, 0)), 0.9)
        strength = np.where(both_ground, 0, strength).astype(np.float32)
        weight[here] = np.maximum(weight[here], strength)
        weight[there] = np.maximum(weight[there], strength)
    return weight


def _grown(weight):
    """Lines wider by a sample on either side."""
    for axis in (0, 1):
        wider = weight.copy()
        here, there = _shifted(weight.shape, 1 - axis, axis)
        np.maximum(wider[here], weight[there], out=wider[here])
        np.maximum(wider[there], weight[here], out=wider[there])
        weight = wider
    return weight


def _upscaled(image, samples):
    return image.repeat(samples, 0).repeat(samples, 1)


def _downsampled(image, covered, samples):
    """RGBA of samples² samples a pixel."""
    height, width = (n // samples for n in covered.shape)
    shape = (height, samples, width, samples)
    count = covered.reshape(shape).sum((1, 3))
    colour = (image * covered[..., None]).reshape(*shape, 3).sum((1, 3))
    colour /= np.maximum(count, 1)[..., None]
    alpha = count / samples**2
    return np.clip(np.concatenate([colour, alpha[..., None]], -1), 0, 1)
