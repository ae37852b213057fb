# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the hinges and panels of one bistable unit lie in plan (docs/theory/hinges.md 1 and 2)."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..errors import phrase
from ..units.creases import CREASES, LAYER_HEIGHT_IN_PITCHES, LINKS, PANELS, kind_of, layer_of
from . import polygons
from .room import TooSmall
from .unit_layout import Hinge, finish

if TYPE_CHECKING:
    from .parameters import HingeParameters
    from .unit_layout import Layout

# mm. Axes almost parallel to each other (by 1e-7) are neither parallel nor not to a CAD kernel.
_GRID = 1e-4
_MOST = 200  # units whose layouts are kept: a tube's are asked for many times over
_KNOWN: dict = {}


def unit_layout(
    axes: NDArray, parameters: "HingeParameters", edge_length: float | None = None
) -> "Layout":
    """`unit_layout.Layout` of one unit.

    ``axes``: (23, 2, 3), the ends of each hinge axis in the flat state in the order of `CREASES`
    (plan = x, z), compensation included; ``parameters``: `HingeParameters`; ``edge_length``: ‖AB‖
    mm, for messages.
    ValueError where a panel or a hinge has no room. Layouts are shared: nobody may change one.
    """
    parameters.check()
    key = parameters, np.asarray(axes, float).tobytes()
    found = _KNOWN.get(key)
    if found is None:
        found = _made(axes, parameters, edge_length)
        if len(_KNOWN) >= _MOST:
            _KNOWN.clear()
        _KNOWN[key] = found
    return found


def _made(axes: NDArray, parameters: "HingeParameters", edge_length: float | None) -> "Layout":
    hinges = axes_of(axes, parameters.pitch)
    try:
        return _laid_out(hinges, parameters)
    except TooSmall as error:
        if error.hinge.name.startswith("leg"):
            raise
        factor = _growth(hinges, parameters)
        raise TooSmall(error.what, error.hinge, factor, edge_length) from error


def _laid_out(hinges: Mapping[str, Hinge], parameters: "HingeParameters") -> "Layout":
    cores = {name: _core(name, hinges, parameters) for name in PANELS}
    heights = {name: LAYER_HEIGHT_IN_PITCHES[layer_of(name)] * parameters.pitch for name in PANELS}
    kinds = {name: kind_of(name) for name in PANELS}
    return finish(hinges, cores, heights, kinds, LINKS, parameters)


def _growth(hinges: Mapping[str, Hinge], parameters: "HingeParameters") -> float:
    """How much larger a unit of the same proportions must be for these hinges."""
    for step in range(1, 60):
        factor = 1.04**step
        larger = {
            name: replace(
                hinge,
                origin=factor * hinge.origin,
                stretch=tuple(factor * s for s in hinge.stretch),
            )
            for name, hinge in hinges.items()
        }
        try:
            _laid_out(larger, parameters)
        except TooSmall:
            continue
        return 1.03 * factor
    return 10.0


def axes_of(axes: NDArray, pitch: float) -> dict[str, Hinge]:
    """`Hinge` of every crease, in plan, whole: no knuckles yet; ``axes`` as of `unit_layout`."""
    ends = {}
    on_grid = np.round(axes / _GRID) * _GRID
    for crease, ((x0, _, z0), (x1, _, z1)) in zip(CREASES, on_grid.tolist(), strict=True):
        ends[crease.name] = complex(x0, z0), complex(x1, z1)
    hinges = {}
    for crease in CREASES:
        a, b = ends[crease.name]
        u = polygons.unit(b - a)
        low, corners = 0.0, [_plan_vertex(v) for v in crease.vertices]
        if "C_" in crease.stretch[0] and "C_" not in crease.vertices[0]:
            foot = ends[crease.name.replace("AB", "AC")][1]
            low, corners[0] = polygons.dot(foot - a, u), _plan_vertex(crease.stretch[0])
        hinges[crease.name] = Hinge(
            crease.name, a, u, crease.height * pitch, crease.bodies,
            (low, abs(b - a)), tuple(corners),
        )  # fmt: skip
    return hinges


def _plan_vertex(name: str) -> str:
    return name.replace("_left", "").replace("_right", "")


def _alias(panel: str, hinge: str) -> str | None:
    """The hinge in line with A–B or A–C' whose barrels run along the same edge of the panel."""
    pair = ("AB", "AC") if kind_of(panel) in ("contact", "primary") else ("AC", "AB")
    return hinge.replace(*pair) if hinge.startswith(pair[0]) else None


def _core(
    panel: str, hinges: Mapping[str, Hinge], parameters: "HingeParameters"
) -> tuple[list[complex], list[str]]:
    """Convex core of a panel and its edge tags: every edge cut back from the axes along it."""
    own = [h for h in hinges.values() if panel in h.bodies]
    ends = [h.point(s) for h in own for s in (0.0, h.stretch[1])]
    middle = sum(ends) / len(ends)
    lines = []
    for hinge in own:
        alias = _alias(panel, hinge.name)
        for axis in [hinge, hinges[alias]] if alias else [hinge]:
            normal = 1j * axis.direction
            if polygons.dot(middle - axis.origin, normal) < 0:
                normal = -normal
            lines.append((axis.origin + parameters.cut_back * normal, normal, hinge.name))
    corners, tags = polygons.half_planes(lines, ends, 10 * parameters.cut_back)
    if not corners or not all(h.name in tags for h in own):
        shortest = min(own, key=lambda h: h.stretch[1])
        raise TooSmall(
            phrase(
                "Panel {panel}: cut back by {cut_back:.3g} mm at every edge, no edge is left at "
                "hinge {hinge}",
                panel=panel,
                cut_back=parameters.cut_back,
                hinge=shortest.name,
            ),
            shortest,
            2.0,
        )
    return corners, tags
