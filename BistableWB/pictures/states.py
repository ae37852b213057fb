# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tube flat-folded and deployed, side by side at one scale."""

import math

import numpy as np

from .. import colours
from ..origami import rigid
from ..origami.curves.bezier import normalised
from ..origami.units.creases import INDEX, LAYER_HEIGHT_IN_PITCHES, PANELS, kind_of, layer_of
from ..origami.units.deployment import contact_frame
from . import rendering, stage
from .page import DPI, blank_axes, figure, halo, round_length, scale_bar
from .shading import render_solids

SHEET_PITCH = 1.8  # mm between the sheets of the flat state as drawn; the default hinges' pitch
KINDS = {
    "contact": "contact panel, shared with the next unit",
    "border": "border panel",
    "primary": "primary triangle ABC",
    "secondary": "secondary triangle A′B′C′",
}
_WIDTH = 9.0  # inches
_TALLEST = 6.5
_LEGEND = 0.9  # inches at the foot of the page
_ELEVATION = math.radians(40)
_TURN = math.radians(24)  # out of the front view
_COINCIDE = 1e-6  # of ‖AB‖


def both_states(path, tube, sheet_pitch=SHEET_PITCH):
    """Flat and deployed ``tube`` (`tube.Tube`), shaded, panels coloured by kind, sizes in mm.

    The model has no thickness, and flat all of it lies in one plane: the sheets are drawn
    ``sheet_pitch`` mm apart, in the order in which they are stacked in the print.
    """
    flat, deployed = _stack(tube, sheet_pitch), _in_own_frame(tube)
    views = (stage.view_along(_turned_to_front(flat), _TURN, _ELEVATION), _deployed_view(deployed))
    scenes = [_polygons(flat, tube), _polygons(deployed, tube)]
    boxes = [rendering.bounds(v, p) for v, (p, _) in zip(views, scenes, strict=True)]
    sizes = np.array([[b[1] - b[0], b[3] - b[2]] for b in boxes])
    gap = 0.10 * sizes[:, 0].sum()
    extent = np.array([sizes[:, 0].sum() + 3 * gap, sizes[:, 1].max() * 1.22])
    per_mm = min(_WIDTH / extent[0], (_TALLEST - _LEGEND) / extent[1])  # inches
    foot = _LEGEND / per_mm
    low = np.array([-gap, -foot - 0.14 * sizes[:, 1].max()])
    page = np.array([_WIDTH / per_mm, extent[1] + foot])
    low[0] -= (page[0] - extent[0]) / 2
    with figure(path, _WIDTH, page[1] * per_mm) as sheet:
        axes = blank_axes(sheet, low, low + page)
        x = 0.0
        names = ("flat-folded", "deployed")
        for name, view, (polygons, kinds), size in zip(names, views, scenes, sizes, strict=True):
            sheets = stage.sheets(polygons, [colours.of(kind) for kind in kinds])
            image, box = render_solids(view, sheets, per_mm * DPI)
            place = (x, x + box[1] - box[0], 0, box[3] - box[2])
            axes.imshow(image, extent=place, interpolation="antialiased", zorder=2)
            _caption(axes, x + size[0] / 2, name, polygons, tube, sheet_pitch)
            if name == "deployed" and len(tube) == 1:
                _name_vertices(axes, view, deployed[0], (x - box[0], -box[2]))
            x += size[0] + gap
        axes.set(xlim=(low[0], low[0] + page[0]), ylim=(low[1], low[1] + page[1]))
        _legend(axes, {kind for _, kinds in scenes for kind in kinds})
        corner = low + np.array([0.03 * page[0], 0.32 * foot])
        scale_bar(axes, corner, round_length(0.12 * page[0]))
    return path


def _deployed_view(points):
    if len(points) == 1:  # into the dart, past C'
        return stage.view_along((1, 0, 0), -1.4 * _TURN, _ELEVATION)
    return stage.view_along(_turned_to_front(points), _TURN, _ELEVATION)


def _turned_to_front(points):
    """Horizontal direction to look along: across the longer side, from the open side of an arch."""
    flat = points.reshape(-1, 3)[:, :2]
    centred = flat - flat.mean(0)
    longest = np.linalg.svd(centred, full_matrices=False)[2][0]
    across = np.array([-longest[1], longest[0], 0.0])
    middle = points.reshape(len(points), -1, 3).mean(1)
    ends = (middle[0] + middle[-1]) / 2 - middle.mean(0)
    side = ends @ across
    if abs(side) < 1e-3 * np.ptp(flat, axis=0).max():
        side = -across[1] if abs(across[1]) > 0.2 else -across[0]
    return -across if side > 0 else across


def standing_view(tube):
    """Direction (3,) of the deployed tube's legs, and the horizontal one from which to see it then.

    The second counts in the frame in which `stage.upright` makes the legs stand.
    """
    points = tube.deployed()
    legs = _legs(points)
    return legs, _turned_to_front(points @ stage.upright(legs).T)


def _legs(points):
    return (points[:, INDEX["B_upper"]] - points[:, INDEX["B_lower"]]).mean(0)


def _in_own_frame(tube):
    """Deployed vertices (n, 10, 3) with the strip's legs, on average, along z."""
    points = tube.deployed()
    return points @ stage.upright(_legs(points)).T


def _stack(tube, pitch):
    """Flat vertices (n, 12 panels as 10 vertices each, 3): every panel at its height in the print.

    Returned as (n, panels, 10, 3): the z of a unit's vertices differs from panel to panel.
    """
    flat = tube.state(0)
    left, right = contact_frame(flat[0], "left"), contact_frame(flat[0], "right")
    frame = left if tube.incoming_left[0] else right
    flat = rigid.apply(rigid.inverse(frame)[None], flat)
    stacked = np.repeat(flat[:, None], len(PANELS), 1)
    for k in range(len(tube)):
        side = 1 if tube.incoming_left[k] else -1
        for i, panel in enumerate(PANELS):
            height = 4 * k + side * LAYER_HEIGHT_IN_PITCHES[layer_of(panel)]
            stacked[k, i, :, 2] = pitch * height
    return stacked


def _polygons(points, tube):
    """Corners and kind of every panel; a contact panel shared by two units comes once."""
    polygons, kinds, shared = [], [], None
    for k in range(len(points)):
        incoming = "contact_left" if tube.incoming_left[k] else "contact_right"
        outgoing = "contact_right" if tube.incoming_left[k] else "contact_left"
        for i, (panel, corners) in enumerate(PANELS.items()):
            vertices = points[k, i] if points.ndim == 4 else points[k]
            polygon = vertices[[INDEX[c] for c in corners]]
            if panel == incoming and shared is not None:
                gap = np.linalg.norm(polygon.mean(0) - shared.mean(0))
                if gap < _COINCIDE * tube.unit.edge_length:
                    continue
            if panel == outgoing:
                after = polygon
            polygons.append(polygon)
            kinds.append(kind_of(panel))
        shared = after
    return polygons, kinds


def _caption(axes, x, name, polygons, tube, pitch):
    """State, size and what the size means, below a drawing."""
    corners = np.concatenate(polygons)
    size = np.ptp(corners, axis=0)
    flat = name == "flat-folded"
    if flat:
        size[2] = 4 * pitch * len(tube)
    count = "1 unit" if len(tube) == 1 else f"{len(tube)} units"
    note = f"{count}, sheets drawn {pitch:g} mm apart" if flat else count
    axes.annotate(
        name, (x, 0), xytext=(0, -12), textcoords="offset points", ha="center", va="top",
        fontsize=10.5, fontweight="bold",
    )  # fmt: skip
    axes.annotate(
        f"{size[0]:.0f} × {size[1]:.0f} × {size[2]:.0f} mm\n{note}", (x, 0), xytext=(0, -28),
        textcoords="offset points", ha="center", va="top", fontsize=8.5, color=colours.MUTED,
    )  # fmt: skip


def _name_vertices(axes, view, points, shift):
    """Letters of the paper at the upper vertices of a single unit."""
    seen = view.seen(points)[:, :2] + shift
    centre = seen.mean(0)
    names = {"B_upper": "B", "A_left_upper": "A", "A_right_upper": "A", "C_upper": "C′",
             "P_upper": "C = B′"}  # fmt: skip
    for vertex, name in names.items():
        at = seen[INDEX[vertex]]
        away = normalised(at - centre)
        axes.annotate(
            name, at, xytext=10 * away, textcoords="offset points", ha="center", va="center",
            fontsize=9.5, fontstyle="italic", zorder=5, path_effects=halo(),
        )  # fmt: skip


def _legend(axes, kinds):
    from matplotlib.patches import Patch

    handles = [
        Patch(facecolor=colours.PANELS[kind], edgecolor=colours.INK, linewidth=0.6, label=text)
        for kind, text in KINDS.items()
        if kind in kinds
    ]
    axes.legend(
        handles=handles, loc="lower right", ncols=2, frameon=False, fontsize=8.5,
        handlelength=1.4, handleheight=1.0, columnspacing=1.8, borderaxespad=1.6,
    )  # fmt: skip
