# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the pillars of a flat print: under whatever begins in mid-air or hangs too far.

On the layers (`origami.layers`) of the bodies as they lie on the bed, from below. What a body has
in a layer is carried by its own layer below, and by whatever else lies at most a stand-off's air
below. A region that is carried nowhere gets a pillar, and so does what lies further than `REACH`
from all that carries it.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from math import ceil, floor
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..layers import PIXEL, Layers, Tops, extent, grown, layers
from ..meshes import PlacedMesh
from ..progress import NOBODY, Progress
from .meshing import mesh_of
from .pillars import BASE as _BASE
from .pillars import BED, Pillar
from .starts import SMALL, labelled

if TYPE_CHECKING:
    from .bodies import Drawn
    from .boundary import Boundary
    from .parameters import HingeParameters

REACH = 4.9  # mm from a hold that a printer spans, whichever way it bridges
_AIR = 0.4  # mm, at least two layers, over which a line is laid on what lies below
_CLEAR = 0.4  # mm between a pillar and all bodies beside it
_WIDTHS = ((12.0, 1.2), (40.0, 2.0), (90.0, 3.0), (np.inf, 4.0))  # (up to a height, width), mm
_NARROW = 0.8  # mm: two lines, where nothing wider finds room
_FLOOR = 4  # layers that a base keeps clear of
_HEADS = 24  # places of a region that are tried, the best of which is taken …
_OTHERS = 200  # … and the first of these that will do, if none of them
_GOOD = 1.5  # mm³: a pillar of less is taken at once
_MOST = 40  # pillars of one region
_STANDS = 0.25  # least share of a foot that has something below it


@dataclass
class Propped:
    """``pillars`` of a print, ``starts``: how many regions wanted one, and what is ``left``.

    ``left``: [(number of the body, layer, mm²)] that no pillar can reach.
    """

    pillars: list[Pillar] = field(default_factory=list)
    starts: int = 0
    left: list[tuple[int, int, float]] = field(default_factory=list)

    @cached_property
    def boundaries(self) -> "list[Boundary]":
        """Of the pillars."""
        return [pillar.boundary() for pillar in self.pillars]

    @property
    def left_area(self) -> float:
        """mm² that begin in mid-air in spite of all pillars."""
        return float(sum(area for *_, area in self.left))


def propped(
    bodies: Sequence[PlacedMesh], layer_height: float, air_layers: int, progress: Progress = NOBODY
) -> Propped:
    """`Propped` of ``bodies`` (as they lie on the bed), in layers of ``layer_height`` mm.

    ``air_layers`` stay free between a pillar and what it holds.
    """
    found = Propped()
    units = sorted({body.unit for body in bodies})
    numbers = {unit: [k for k, body in enumerate(bodies) if body.unit == unit] for unit in units}
    search = _Search(bodies, layer_height, air_layers)
    for place, unit in enumerate(units):
        near = [k for other in units[max(place - 1, 0) : place + 2] for k in numbers[other]]
        search.look_at(near)
        for k in numbers[unit]:
            for layer, region, is_island in search.wanting(k):
                found.starts += 1
                made, left = search.hold(k, layer, region, is_island)
                found.pillars += made
                if left > SMALL:
                    found.left.append((k, layer, left))
        progress.step("Pillars…", (place + 1) / len(units))
    found.pillars = [search.based(pillar) for pillar in found.pillars]
    return found


def propped_print(
    bodies: Sequence["Drawn"], parameters: "HingeParameters", progress: Progress = NOBODY
) -> Propped:
    """`propped` of the drawn bodies of a flat print, for hinges that want pillars; else none."""
    if not parameters.has_pillars or parameters.standoffs is None:
        return Propped()
    placed = [
        PlacedMesh(body.name, mesh_of(body.boundary).mesh, body.place, body.unit, body.members,
                   body.kind)
        for body in bodies
    ]  # fmt: skip
    return propped(placed, parameters.layer_height, parameters.standoffs.air_layers, progress)


class _Search:
    """Places pillars among the `Layers` of bodies: those near by whole, those below as heights."""

    def __init__(self, bodies: Sequence[PlacedMesh], layer_height: float, air: int) -> None:
        self.bodies, self.height, self.air = bodies, layer_height, air
        self.depth = max(round(_AIR / layer_height), 2) + 1
        self.near: dict[int, Layers] = {}
        low, end = extent(np.array([body.placed.bounds for body in bodies]))
        self.tops = Tops(low, end)  # of all units further below
        self.boxes = np.empty((0, 3, 2), int)  # of pillars: layers, rows, columns
        self.floor: list[Layers] = []  # what lies in the first layers
        self.around: dict[int, Layers] = {}  # of those near: about the region that is held

    def look_at(self, wanted: Sequence[int]) -> None:
        """Keep the layers of bodies ``wanted``, and only the heights of those left behind."""
        for k in [k for k in self.near if k not in wanted]:
            self.tops.add(self.near.pop(k))
        for k in wanted:
            if k not in self.near:
                self.near[k] = one = layers(self.bodies[k].placed, self.height)
                if one.inside.size and one.first[0] < _FLOOR:
                    self.floor.append(Layers(one.inside[: _FLOOR - one.first[0]], one.first))

    def wanting(self, k: int) -> Iterator[tuple[int, NDArray, bool]]:
        """(layer, pixels (n, 2) on the grid, whether it is an island) that want pillars."""
        made = self.near[k]
        for n, section in enumerate(made.inside):
            number = int(made.first[0]) + n
            below = made.inside[n - 1] if n else np.zeros_like(section)
            fresh = section & ~below
            if number <= self.depth or not fresh.any():
                continue
            yield from self._of_layer(k, number, section, below, fresh)

    def _of_layer(
        self, k: int, number: int, section: NDArray, below: NDArray, fresh: NDArray
    ) -> Iterator[tuple[int, NDArray, bool]]:
        reach = ceil(REACH / PIXEL)
        rows, columns = np.nonzero(fresh)
        low = np.maximum([rows.min() - reach, columns.min() - reach], 0)
        here = slice(low[0], rows.max() + reach + 1), slice(low[1], columns.max() + reach + 1)
        corner = self.near[k].first[1:] + low
        section, below, fresh = section[here], below[here], fresh[here]
        if not (fresh & ~_beside(below)).any():
            return  # as round barrels grow
        carried = section & (below | self._held(k, number, corner, section.shape))
        if not (fresh & ~carried).any():
            return
        labels, count = labelled(section)
        is_held = np.zeros(count + 1, bool)
        is_held[labels[carried]] = True
        for part in np.flatnonzero(~is_held[1:]) + 1:
            yield number, np.argwhere(labels == part) + corner, True
        if not _is_far_somewhere(fresh, carried):
            return
        far = fresh & is_held[labels] & ~grown(carried, reach)
        if far.sum() * PIXEL**2 <= SMALL:
            return
        parts, many = labelled(far)
        for part in range(1, many + 1):
            pixels = np.argwhere(parts == part)
            if len(pixels) * PIXEL**2 > SMALL:
                yield number, pixels + corner, False

    def _held(self, k: int, number: int, corner: NDArray, shape: tuple) -> NDArray:
        """Where other bodies lie at most a stand-off's air below a layer, in a window."""
        low = np.append(number - self.depth, corner)
        end = np.append(number, corner + shape)
        found = np.zeros(shape, bool)
        for other, one in self.near.items():
            if other != k and one.inside.size and (one.first < end).all() and (one.end > low).all():
                found |= one.window(low, end).any(0)
        return found

    def hold(
        self, k: int, layer: int, region: NDArray, is_island: bool
    ) -> tuple[list[Pillar], float]:
        """(pillars under a region, mm² of it that nothing holds)."""
        made: list[Pillar] = []
        left = region
        margin = round((_WIDTHS[-1][1] / 2 + _BASE + _CLEAR) / PIXEL) + 1
        low, end = region.min(0) - margin, region.max(0) + margin + 1
        self.around = {
            number: one
            for number, one in self.near.items()
            if one.inside.size and (one.first[1:] < end).all() and (one.end[1:] > low).all()
        }
        while len(left) * PIXEL**2 > SMALL or (is_island and not made):
            pillar = self._pillar(k, layer, left) if len(made) < _MOST else None
            if pillar is None:
                break
            made.append(pillar)
            middle = np.array([pillar.y, pillar.x]) / PIXEL - 0.5
            left = left[((left - middle) ** 2).sum(1) > (REACH / PIXEL) ** 2]
        return made, 0.0 if made and is_island else len(left) * PIXEL**2

    def _pillar(self, k: int, layer: int, region: NDArray) -> Pillar | None:
        """The least pillar under a region; None if there is none."""
        top = layer - self.air
        best: tuple[float, tuple] | None = None
        for order, head in enumerate(_heads(region)):
            if best is not None and order >= _HEADS:
                break
            found = self._standing_at(head, top)
            if found is None:
                continue
            width, foot, _ = found
            cost = (top - foot) * self.height * width**2 + 0.2 * order
            cost += 2 * (width == _NARROW)
            if best is None or cost < best[0]:
                best = cost, (head, *found)
            if best[0] < _GOOD:
                break
        if best is None:
            return None
        head, width, foot, on = best[1]
        y, x = (head + 0.5) * PIXEL
        self._take(head, width, foot, top)
        return Pillar(float(x), float(y), foot * self.height, top * self.height, width, k, on, 0.0,
                      self.height)  # fmt: skip

    def _standing_at(self, head: NDArray, top: int) -> tuple[float, int, int] | None:
        """(width, foot's layer, body below) of a pillar: as wide as its height wants, if it can."""
        last = None
        for most, width in _WIDTHS:
            shaft = self._shaft(head, width, top)
            if shaft is None:
                break
            last = width, *shaft
            if (top - shaft[0]) * self.height <= most:
                break
        if last is None:
            shaft = self._shaft(head, _NARROW, top)
            last = shaft and (_NARROW, *shaft)
        return last

    def _shaft(self, head: NDArray, width: float, top: int) -> tuple[int, int] | None:
        """(foot's layer, body below) of a pillar that ends at ``top``; None where there is none."""
        half = round(width / 2 / PIXEL)
        beside = half + round(_CLEAR / PIXEL)
        low, end = head - beside, head + beside + 1
        stop, on = self._below(low, end, top)
        foot = 0 if on == BED else stop + 1 + self.air
        if foot >= top or self._meeting(head - half, head + half + 1, foot, top):
            return None
        if on != BED and self._standing(head - half, head + half + 1, stop) < _STANDS:
            return None
        return foot, on

    def _below(self, low: NDArray, end: NDArray, top: int) -> tuple[int, int]:
        """(highest layer below ``top`` in which something lies in a box, its body)."""
        stop = int(self.tops.part(low, end).max())
        on = BED if stop == BED else -2
        for other, one in self.around.items():
            if one.first[0] >= top or one.end[0] <= stop:
                continue
            if (one.first[1:] >= end).any() or (one.end[1:] <= low).any():
                continue
            start = int(max(stop + 1, one.first[0]))
            lies = one.window([start, *low], [min(top, one.end[0]), *end]).any((1, 2))
            if lies.any():
                stop, on = start + int(np.flatnonzero(lies)[-1]), other
        return stop, on

    def _standing(self, low: NDArray, end: NDArray, stop: int) -> float:
        """Share of a box that has something in the layers from ``stop`` down."""
        deep = stop + 1 + self.air - self.depth
        held = self.tops.part(low, end) >= max(deep, 0)
        for one in self.around.values():
            if one.first[0] <= stop and one.end[0] > deep:
                held |= one.window([deep, *low], [stop + 1, *end]).any(0)
        return float(held.mean())

    def _meeting(self, low: NDArray, end: NDArray, foot: int, top: int) -> int:
        """How many pillars a box meets."""
        box = np.stack([np.append(foot, low), np.append(top, end)], 1)
        meets = (self.boxes[:, :, 0] < box[:, 1]) & (self.boxes[:, :, 1] > box[:, 0])
        return int(meets.all(1).sum())

    def based(self, pillar: Pillar) -> Pillar:
        """A pillar with a wider base, if it stands on the bed and finds room for one."""
        if pillar.on != BED or pillar.high <= _FLOOR * self.height:
            return pillar
        half = round((pillar.width / 2 + _BASE) / PIXEL)
        head = np.round(np.array([pillar.y, pillar.x]) / PIXEL - 0.5).astype(int)
        beside = half + round(_CLEAR / PIXEL)
        low, end = np.append(0, head - beside), np.append(_FLOOR, head + beside + 1)
        if any(one.window(low, end).any() for one in self.floor):
            return pillar
        if self._meeting(head - half, head + half + 1, 0, _FLOOR) > 1:  # itself
            return pillar
        self._take(head, pillar.width + 2 * _BASE, 0, _FLOOR)
        return pillar._replace(base=_BASE)

    def _take(self, head: NDArray, width: float, foot: int, top: int) -> None:
        half = round(width / 2 / PIXEL)
        box = [[foot, top], *np.stack([head - half, head + half + 1], 1).tolist()]
        self.boxes = np.concatenate([self.boxes, [box]])


def _heads(region: NDArray) -> NDArray:
    """Pixels of a region (n, 2): `_HEADS` that have most of it about them, then some others."""
    heads = region[:: max(len(region) // _HEADS, 1)]
    far = ((heads[:, None] - region[None]) ** 2).sum(-1)
    held = (far <= (REACH / PIXEL) ** 2).sum(1)
    others = region[:: max(len(region) // _OTHERS, 1)]
    return np.concatenate([heads[np.lexsort((far.sum(1), -held))][:_HEADS], others])


def _beside(area: NDArray) -> NDArray:
    """An area and the pixels at its sides."""
    found = area.copy()
    found[1:] |= area[:-1]
    found[:-1] |= area[1:]
    found[:, 1:] |= area[:, :-1]
    found[:, :-1] |= area[:, 1:]
    return found


def _is_far_somewhere(fresh: NDArray, carried: NDArray) -> bool:
    """Whether a pixel of ``fresh`` may be further than `REACH` from all ``carried``: in blocks."""
    side = floor(REACH / PIXEL / 2**0.5 / 2)  # two blocks away is nearer than that, corners too
    rows, columns = (-(-n // side) * side for n in fresh.shape)
    blocks = []
    for area in (fresh, carried):
        whole = np.zeros((rows, columns), bool)
        whole[: area.shape[0], : area.shape[1]] = area
        blocks.append(whole.reshape(rows // side, side, columns // side, side).any((1, 3)))
    near = np.pad(blocks[1], 1)
    near = near[:-2] | near[1:-1] | near[2:]
    near = near[:, :-2] | near[:, 1:-1] | near[:, 2:]
    return bool((blocks[0] & ~near).any())
