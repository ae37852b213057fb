# SPDX-License-Identifier: LGPL-2.1-or-later
"""Top view of a placement, as in Fig. 2c-d of the paper."""

import math

import numpy as np

from .. import colours
from ..origami.curves.bezier import normalised
from .page import blank_axes, figure, page, round_length, scale_bar


def top_view(path, placed, curve, gamma=None, sphere_radius=None):
    """Curve, triangles and midpoints as in Fig. 2c-d of the paper; a sphere is seen from outside.

    ``placed``: a `placement.Placement`; ``curve``: what it was placed along; ``gamma``: radians.
    """
    flat = _plan(placed)
    segments, line = flat(placed.segments), flat(curve.point(np.linspace(0, 1, 600)))
    everything = np.concatenate([segments.reshape(-1, 2), line])
    low, high, (width, height) = _framed(everything)
    with figure(path, width, height) as sheet:
        axes = blank_axes(sheet, low, high)
        points_per_mm = width * 72 / (high - low)[0]
        if sphere_radius:
            _draw_sphere(axes, flat, placed.centre, sphere_radius)
        _draw_triangles(axes, segments)
        axes.plot(*line.T, color=colours.CURVE, lw=1.8, zorder=4, solid_capstyle="round")
        axes.plot(
            *flat(placed.midpoints).T, ls="", marker="o", mfc="white", mec=colours.CURVE, mew=1.1,
            ms=min(4.2, 0.09 * placed.edge_length * points_per_mm), zorder=5,
        )  # fmt: skip
        _label_thetas(axes, segments, np.degrees(placed.thetas), points_per_mm)
        _draw_edge_length(axes, placed, flat, points_per_mm)
        if gamma is not None:
            _draw_gamma(axes, placed, flat, gamma)
        _scale_bar_where_empty(axes, everything, low, high, points_per_mm)
    return path


def _plan(placed):
    """Function from points in space to the plan (…, 2) that one sees along the legs."""
    up = normalised(placed.legs.mean(0))
    if abs(up[2]) > 1 - 1e-9 and placed.centre is None:
        right = np.array([1.0, 0, 0])
    else:
        right = placed.midpoints[-1] - placed.midpoints[0]
        right = normalised(right - (right @ up) * up)
    ahead = np.cross(up, right)
    centre = np.zeros(3) if placed.centre is None else placed.centre
    return lambda points: (np.asarray(points) - centre) @ np.stack([right, ahead], 1)


def _framed(points):
    """Corners in mm and size in inches of a page around ``points`` with room for labels."""
    low, high = points.min(0), points.max(0)
    for _ in range(3):  # the margin is in points of the page, whose scale depends on the margin
        extent = high - low
        size = page(extent)
        margin = 40 / (72 * min(size / extent))
        low, high = points.min(0) - margin, points.max(0) + margin
    extent = high - low
    size = page(extent)
    spare = size / min(size / extent) - extent  # a page has a least width and height
    return low - spare / 2, high + spare / 2, size


def _scale_bar_where_empty(axes, points, low, high, points_per_mm):
    """The scale bar in the corner of the page that is farthest from everything drawn."""
    length = round_length((high - low)[0] * 0.2)
    inset = 14 / points_per_mm
    corners = [
        (low[0] + inset, low[1] + inset),
        (high[0] - inset - length, low[1] + inset),
        (low[0] + inset, high[1] - 2 * inset),
        (high[0] - inset - length, high[1] - 2 * inset),
    ]
    distance = [
        np.linalg.norm(points - np.add(corner, [length / 2, 0]), axis=1).min() for corner in corners
    ]
    scale_bar(axes, corners[int(np.argmax(distance))], length)


def _draw_triangles(axes, segments):
    from matplotlib.collections import LineCollection, PolyCollection

    triangles = np.stack([segments[:-1, 0], segments[:-1, 1], segments[1:, 1]], 1)
    if not np.allclose(segments[:-1, 1], segments[1:, 0]):  # thick panels: a double hinge at B
        triangles = np.concatenate([segments[:-1], segments[1:]], 1)
    fills = PolyCollection(
        triangles, facecolor=colours.PANELS["border"], alpha=0.32, edgecolor="none", zorder=1
    )
    axes.add_collection(fills)
    bases = np.stack([segments[:-1, 0], segments[1:, 1]], 1)
    axes.add_collection(LineCollection(bases, colors=colours.MUTED, lw=0.6, zorder=2))
    axes.add_collection(
        LineCollection(segments, colors=colours.INK, lw=1.4, zorder=3, capstyle="round")
    )


def _label_thetas(axes, segments, degrees, points_per_mm):
    """θ_k beside the joint of unit k, outside its triangle; fewer where they would be crowded."""
    start, joint, end = segments[:-1, 0], segments[:-1, 1], segments[1:, 1]
    outward = normalised(joint - (start + end) / 2)
    room = np.linalg.norm(np.diff(joint[::2], axis=0), axis=1).min() if len(joint) > 2 else 1e9
    size = float(np.clip(room * points_per_mm / 4.2, 5.0, 8.5))
    every = max(1, math.ceil(20 / (room * points_per_mm)))
    for k in range(0, len(degrees), every):
        axes.annotate(
            rf"$\theta_{{{k + 1}}}$" + f"\n{degrees[k]:.1f}°" * (every == 1),
            joint[k], xytext=outward[k] * 1.75 * size, textcoords="offset points",
            ha="center", va="center", fontsize=size, linespacing=1.0,
        )  # fmt: skip


def _draw_gamma(axes, placed, flat, gamma):
    """The angle γ by which the first segment leans forward out of the curve's normal."""
    direction, leg = placed.reaches[0] / np.linalg.norm(placed.reaches[0]), placed.legs[0]
    ahead = np.cross(leg, direction)
    ahead *= np.sign(ahead @ (placed.midpoints[1] - placed.midpoints[0]))

    def at(angle, reach):
        """Points at an angle back from the segment, reach in half segments."""
        angle = np.atleast_1d(angle)[:, None]
        ray = np.cos(angle) * direction - np.sin(angle) * ahead
        return flat(placed.midpoints[0] + reach * placed.edge_length / 2 * ray)

    style = {"color": colours.MUTED, "lw": 0.8, "zorder": 3.5}
    end = at(gamma, 1.12)[0]
    axes.plot(*np.stack([at(gamma, 0)[0], end]).T, ls=(0, (4, 3)), **style)
    axes.plot(*at(np.linspace(0, gamma, 40), 0.8).T, **style)
    away = normalised(at(gamma + math.radians(50), 1)[0] - at(0, 0)[0])
    axes.annotate(
        rf"$\gamma$ = {math.degrees(gamma):g}°", end, xytext=9 * away, textcoords="offset points",
        fontsize=8, color=colours.MUTED, **_aligned(away),
    )  # fmt: skip


def _draw_edge_length(axes, placed, flat, points_per_mm):
    """‖AB‖ along the first segment, on its outer side, where the segment is long enough."""
    text = f"‖AB‖ = {placed.edge_length:g} mm"
    if 5.2 * len(text) > placed.edge_length * points_per_mm:
        return
    middle, direction, ahead = _start(placed, flat)
    slope = math.degrees(math.atan2(direction[1], direction[0]))
    slope = (slope + 90) % 180 - 90
    outward = np.array([-direction[1], direction[0]])
    outward *= -1 if outward @ ahead > 0 else 1
    axes.annotate(
        text, middle - 0.28 * placed.edge_length * direction, xytext=8 * outward,
        textcoords="offset points", rotation=slope, rotation_mode="anchor", fontsize=8,
        ha="center", va="center",
    )  # fmt: skip


def _start(placed, flat):
    """First midpoint, first segment's direction towards its joint, direction of travel."""
    middle = flat(placed.midpoints[0])
    direction = normalised(flat(placed.segments[0, 1]) - middle)
    return middle, direction, normalised(flat(placed.midpoints[1]) - middle)


def _towards(angle):
    return np.array([math.cos(angle), math.sin(angle)])


def _aligned(direction):
    """Alignment of a text that stands in ``direction`` from its anchor."""
    x, y = direction
    return {
        "ha": "left" if x > 0.3 else "right" if x < -0.3 else "center",
        "va": "bottom" if y > 0.3 else "top" if y < -0.3 else "center",
    }


def _draw_sphere(axes, flat, centre, radius):
    """Meridians and parallels of the curve's sphere about the direction that one looks along."""
    from matplotlib.patches import Circle

    t = np.linspace(0, 2 * np.pi, 361)
    style = {"color": colours.FAINT, "lw": 0.8, "zorder": 0}
    x, y = flat(centre)
    for polar in np.radians(range(15, 90, 15)):
        reach = radius * np.sin(polar)
        axes.plot(x + reach * np.cos(t), y + reach * np.sin(t), **style)
    for azimuth in np.radians(range(0, 180, 15)):
        ahead = radius * _towards(azimuth)
        axes.plot([x - ahead[0], x + ahead[0]], [y - ahead[1], y + ahead[1]], **style)
    axes.add_patch(Circle((x, y), radius, fill=False, ec=colours.MUTED, lw=0.9, zorder=0))
