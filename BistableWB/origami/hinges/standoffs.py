# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stand-offs: ribs and rims that hold up, in the print, the panel above by a layer of air.

They grow from the upper face of a panel, stop one layer of air under what lies above, and stay in
the tube as stiffeners (docs/slicing.md). Each is an upright prism over a strip one line wide: ribs
both ways on a grid, rims along the edges and across the tabs. A strip is cut wherever another body
passes on the way from flat to deployed, with the hinges' play, and where nothing lies above it.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from math import floor
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..thick import print_stack
from ..units.creases import BODIES
from . import polygons
from .heights import PIXEL, Heights, heights_of, mark_taken
from .opening_print import poses_on_the_way, turned
from .standoff_inputs import StandOffs
from .strips import SHORTEST, Line, Strip, grid, rims, strips_below, strips_on_tabs
from .unit_layout import Hinge, Layout, Tab

if TYPE_CHECKING:
    from ..thick.linkage import ThickUnit
    from .parameters import HingeParameters

_STEP = 0.3  # mm between places along a strip
_FINE = 5  # steps between two of these, where strips meet
_APART = 0.3  # mm between two pieces of a strip, which slicers do not close
_HELD = 1.1  # layers of air more than wanted that still hold something up
_TURNING = 0.15  # mm that the top of a barrel's stand-off keeps from what it turns beside
_EPS = 1e-6
_MOST = 400  # units whose stand-offs are kept
_KNOWN: dict = {}

Body = tuple[int, str]  # number of a unit, name of a plate or link
Crests = dict[int, tuple[float, float]]  # {place in a plate's ring: `Tab.crest`}
Maps = Sequence[Mapping[str, Heights]]  # by unit and name


class Stud(NamedTuple):
    """A stand-off: ``corners`` of its plan (counter-clockwise), ``height`` above the face, mm."""

    corners: tuple
    height: float


def with_standoffs(
    layouts: list[Layout],
    thick: "ThickUnit",
    parameters: "HingeParameters",
    incoming_left: NDArray | None = None,
) -> list[Layout]:
    """The layouts with stand-offs on their panels and links, for a process that wants some.

    Arguments as of `bodies.tube_drawn`, and its `tube_layouts`. What a unit was given is kept:
    equal units in equal company get the same.
    """
    if parameters.standoffs is None or not parameters.has_knuckles:
        return layouts
    left = print_stack.alternating(len(layouts)) if incoming_left is None else incoming_left
    axes = np.round(np.asarray(thick.axes).reshape(len(layouts), -1), 4) + 0.0
    stack: _Stack | None = None
    made = []
    for k, layout in enumerate(layouts):
        near = slice(max(k - 1, 0), k + 2)
        key = parameters, k > 0, tuple(left[near]), axes[near].tobytes()
        if key not in _KNOWN:
            stack = stack or _Stack(layouts, thick, parameters, parameters.standoffs, left)
            if len(_KNOWN) >= _MOST:
                _KNOWN.clear()
            _KNOWN[key] = stack.standing(k)
        studs, crests, links = _KNOWN[key]
        made.append(_dressed(layout, studs, crests, links, 1 if left[k] else -1))
    return made


def _dressed(
    layout: Layout,
    studs: Mapping[str, tuple[Stud, ...]],
    crests: Mapping[str, Crests],
    links: Mapping[str, tuple],
    up: int,
) -> Layout:
    """A layout with stand-offs: studs and crests by plate, crests by link."""
    plates = {
        name: replace(
            plate,
            ring=tuple(
                replace(item, crest=crests[name][at]) if at in crests[name] else item
                for at, item in enumerate(plate.ring)
            ),
            studs=studs[name],
            up=up,
        )
        for name, plate in layout.plates.items()
    }
    made = {name: replace(link, crest=links[name]) for name, link in layout.links.items()}
    return replace(layout, plates=plates, links=made)


class _Stack:
    """All panels and links of a flat-folded print, as heights, and how they move."""

    def __init__(
        self,
        layouts: Sequence[Layout],
        thick: "ThickUnit",
        parameters: "HingeParameters",
        given: StandOffs,
        left: NDArray,
    ) -> None:
        self.parameters, self.given = parameters, given
        count = len(layouts)
        self.up = [1 if one else -1 for one in left]  # whether +y of a unit is up in the print
        self.layouts = [
            layout if up > 0 else turned(layout)
            for layout, up in zip(layouts, self.up, strict=True)
        ]
        turns = [np.diag([1.0, up, 1.0, 1.0]) for up in self.up]
        self.places = print_stack.frames(thick, left) @ np.array(turns)
        names = [print_stack.contact_names(one) for one in left]
        self.roofed = {(k, names[k][1]) for k in range(count - 1)}  # has its block above it
        self.blocks = {(k, names[k][1]): k for k in range(count - 1)}
        self.blocks |= {(k, names[k][0]): k - 1 for k in range(1, count)}
        beside = given.width / 2 + PIXEL / 2
        self._wants = self._heights(0.0, flat=True)
        self._bars = self._heights(beside + parameters.gap_length - PIXEL / 2)
        self._sweep = self._heights(beside + parameters.play)
        self._close = self._heights(PIXEL / 2)
        ways = poses_on_the_way(thick, left)
        self._poses = [way @ turn for way, turn in zip(ways, turns, strict=True)]
        self._back = [rigid.inverse(poses) for poses in self._poses]

    def _heights(self, grown: float, flat: bool = False) -> Maps:
        return [
            {
                name: heights_of(body, self.parameters, grown, flat)
                for name, body in (*layout.plates.items(), *layout.links.items())
            }
            for layout in self.layouts
        ]

    def standing(self, k: int) -> tuple[dict, dict, dict]:
        """Studs and crests by plate, and crests by link, of unit ``k``."""
        layout = self.layouts[k]
        return (
            {name: self.studs(k, name) for name in layout.plates},
            {name: self.crests(k, name) for name in layout.plates},
            {name: self.link_crest(k, name) for name in layout.links},
        )

    def studs(self, k: int, name: str) -> tuple[Stud, ...]:
        """Tuple of `Stud`s on a plate."""
        if (k, name) in self.roofed:
            return ()
        plate, given = self.layouts[k].plates[name], self.given
        strips = strips_on_tabs(plate, given)
        strips += strips_below(plate, self._barrels_above(k, name), given)
        strips += rims(plate, given) if given.rim else []
        strips += strips_below(plate, self._edges_above(k, name), given)
        single = len(strips)  # those of the grid keep clear of each other by themselves
        strips += grid(plate, given)
        along = [np.linspace(0, s.length, max(int(s.length / _STEP), 1) + 1) for s in strips]
        points = [s.start + a * s.direction for s, a in zip(strips, along, strict=True)]
        high, _ = self._layers(k, name, np.concatenate(points))
        layers = np.split(high, np.cumsum([len(a) for a in along])[:-1])
        found: list[Stud] = []
        taken: list[Line] = []
        for number, (strip, high) in enumerate(zip(strips, layers, strict=True)):
            for low, end, count in self._free(strip, high, taken):
                corners = strip.piece(low, end, given.width)
                found.append(Stud(corners, float(count * self.parameters.layer_height)))
                taken += [strip.middle(low, end)] if number < single else []
        return tuple(found)

    def _free(
        self, strip: Strip, layers: NDArray, taken: Sequence[Line]
    ) -> list[tuple[float, float, int]]:
        """Pieces of a strip with ``layers`` at its places, clear of those that are ``taken``."""
        fine = np.linspace(0, strip.length, _FINE * (len(layers) - 1) + 1)
        high = layers[np.round(np.arange(len(fine)) / _FINE).astype(int)]
        clear = strip.clear_of(taken, fine, self.given.width)
        return _pieces(fine, np.where(clear, high, 0))

    def _edges_above(self, k: int, name: str) -> list[Line]:
        """(start, end) in a plate's plan along the edges, inside them, of the plates above it."""
        here = self.layouts[k].plates[name].height
        found: list[Line] = []
        for plate in self.layouts[k].plates.values():
            if plate.height > here:
                corners = polygons.intersection(plate.core, plate.core, inset=self.given.width)
                found += zip(corners, [*corners[1:], *corners[:1]], strict=True)
        return found

    def _barrels_above(self, k: int, name: str) -> list[Line]:
        """(start, end) in a plate's plan of all knuckles that begin above it in the flat print."""
        top = self.layouts[k].plates[name].height
        return [
            (hinge.point(start), hinge.point(end))
            for hinge in self.layouts[k].hinges.values()
            for start, end in hinge.segments
            if hinge.height - self.parameters.radius > top
        ]

    def crests(self, k: int, name: str) -> Crests:
        """{place in a plate's ring: `Tab.crest`} of the barrels that rise through its upper face.

        They turn with the hinge, beside panels that end at its clearance: they stay below that.
        """
        plate, width = self.layouts[k].plates[name], self.given.width
        by_hinge: dict = {}
        for place, item in enumerate(plate.ring):
            if isinstance(item, Tab) and item.hinge.height > plate.height:
                by_hinge.setdefault(item.hinge.name, []).append((place, item))
        found = {}
        for tabs in by_hinge.values():
            held = self._crests(k, name, tabs[0][1].hinge, [item.index for _, item in tabs])
            for (place, _), (height, wanted) in zip(tabs, held, strict=True):
                if wanted and height:
                    found[place] = width, height
        return found

    def link_crest(self, k: int, name: str) -> tuple:
        """`Link.crest` of a link: on all of its upper barrels, or on none."""
        hinge = self.layouts[k].links[name].hinges[1]
        held = self._crests(k, name, hinge, range(1, len(hinge.segments), 2))
        height = min(height for height, _ in held)
        wanted = any(height and wanted for height, wanted in held)
        return (self.given.width, height, self.up[k]) if wanted and height else ()

    def _crests(
        self, k: int, name: str, hinge: Hinge, indices: Sequence[int]
    ) -> list[tuple[float, bool]]:
        """[(height, wanted)] of stand-offs on barrels of a hinge: mm, 0 for none; holds anything.

        All at once: what passes by on the way is the same for all of them.
        """
        p = self.parameters
        most = floor((p.gap_length - _TURNING) / p.layer_height + _EPS)
        if most < 1:
            return [(0.0, False)] * len(indices)
        along = []
        for index in indices:
            start, end = (hinge.point(s) for s in hinge.segments[index])
            along.append(np.linspace(start, end, max(int(abs(end - start) / _STEP), 2) + 1)[1:-1])
        top = hinge.height + p.radius
        layers, held = self._layers(k, name, np.concatenate(along), top, most, hinge.bodies)
        ends = np.cumsum([len(points) for points in along])[:-1]
        return [
            (float(high.min() * p.layer_height), bool(under.any()))
            for high, under in zip(np.split(layers, ends), np.split(held, ends), strict=True)
        ]

    def _layers(
        self,
        k: int,
        name: str,
        points: NDArray,
        top: float | None = None,
        most: int | None = None,
        but: Sequence[str] = (),
    ) -> tuple[NDArray, NDArray]:
        """Layers (n,) that a stand-off may be high at plan points; whether it has what to hold.

        ``top``: height from which it rises, the plate's upper face if not given. On a barrel at
        ``most`` so many layers, also where it holds nothing; it turns beside bodies ``but`` which
        it keeps clear of by itself.
        """
        p = self.parameters
        if top is None:
            top = self.layouts[k].plates[name].height + p.face_thickness / 2
        own = {(k, body) for body in (name, *but)}
        ceiling = self._ceiling(k, own, points, top, self._wants)
        bar = self._ceiling(k, own, points, top, self._bars)
        air = self.given.air_layers * p.layer_height
        held = np.isfinite(ceiling)
        wanted = np.where(held, ceiling - top - air, (most or 0) * p.layer_height)
        free = np.minimum(wanted, np.where(np.isfinite(bar), bar - top - air, wanted))
        layers = np.floor(free / p.layer_height + _EPS).astype(int)
        layers = layers if most is None else np.minimum(layers, most)
        layers[layers < wanted / p.layer_height - _HELD] = 0
        sweep = self._close if but else self._sweep
        return self._cut((k, name), own, points, top, np.maximum(layers, 0), sweep), held

    def _ceiling(self, k: int, own: set[Body], points: NDArray, top: float, maps: Maps) -> NDArray:
        """Height (n,) of what lies above points of a plate in the flat print, lowest first."""
        found = np.full(len(points), np.inf)
        for j in (k, k + 1):
            if j >= len(self.layouts):
                continue
            move = np.linalg.inv(self.places[j]) @ self.places[k]
            spots = rigid.apply(move, np.stack([points.real, 0 * points.real, points.imag], 1))
            lift = move[1, 3]
            for other, heights in maps[j].items():
                if (j, other) in own or (j != k and self._is_joined(j, other, own)):
                    continue
                if not heights.may_lie_over(spots[:, 0], spots[:, 2], top + lift):
                    continue
                low, high = heights.at(spots[:, 0], spots[:, 2])
                above = high - lift > top + _EPS
                found = np.where(above, np.minimum(found, low - lift), found)
        return found

    def _is_joined(self, j: int, other: str, own: set[Body]) -> bool:
        """Whether a contact panel of another unit is one body with a plate: of the same block."""
        block = self.blocks.get((j, other))
        return block is not None and any(self.blocks.get(body) == block for body in own)

    def _cut(
        self,
        plate: Body,
        own: set[Body],
        points: NDArray,
        top: float,
        layers: NDArray,
        sweep: Maps,
    ) -> NDArray:
        """``layers`` (n,), 0 where another body than ``own`` passes through them on the way."""
        k, name = plate
        rows = np.flatnonzero(layers)
        if not len(rows):
            return layers
        h = self.parameters.layer_height
        levels = [(rows, top + layers[rows] * h)]
        step = max(round(0.5 / h), 1)
        for level in range(step, int(layers.max()), step):
            tall = rows[layers[rows] > level]
            levels.append((tall, np.full(len(tall), top + level * h)))
        which = np.concatenate([a for a, _ in levels])
        spots = np.stack([points.real[which], np.concatenate([b for _, b in levels]),
                          points.imag[which]], 1)  # fmt: skip
        hit = np.zeros(len(which), bool)
        for j in (k - 1, k, k + 1):
            if not 0 <= j < len(self.layouts):
                continue
            others = {
                other: heights
                for other, heights in sweep[j].items()
                if (j, other) not in own and not (j != k and self._is_joined(j, other, own))
            }
            mark_taken(hit, spots, list(others.values()), self._moves(k, name, j, others))
        layers[which[hit]] = 0
        return layers

    def _moves(self, k: int, name: str, j: int, others: Collection[str]) -> NDArray:
        """Motions (bodies, m, 4, 4) of a plate's frame as seen from ``others``, on the way."""
        own = self._poses[k][:, BODIES.index(name)]
        back = self._back[j][:, [BODIES.index(other) for other in others]]
        return np.swapaxes(back @ own[:, None], 0, 1)


def _pieces(along: NDArray, layers: NDArray) -> list[tuple[float, float, int]]:
    """(start, end, layers) of each stretch of a strip in which ``layers`` (n,) are the same."""
    found = []
    starts = np.flatnonzero(np.diff(layers, prepend=-1))
    for first, after in zip(starts, [*starts[1:], len(layers)], strict=True):
        low = along[first] + (_APART / 2 if first and layers[first - 1] else 0.0)
        high = along[after - 1] - (_APART / 2 if after < len(layers) and layers[after] else 0.0)
        if layers[first] and high - low >= SHORTEST:
            found.append((low, high, int(layers[first])))
    return found
