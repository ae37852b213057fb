# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the ties of a print that stands on edge: what each start in mid-air is held by.

A start is tied to the nearest material within 45° below it by a neck that keeps clear of every
third body; where there is none, by a pillar straight up from what lies below, the bed at last.
Ties lie where a blade comes to them along a layer; what cannot be tied so is told.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..layers import PIXEL, Layers, layers
from ..meshes import PlacedMesh
from ..progress import NOBODY, Progress
from .starts import REACH, SMALL, Start, starts_of
from .ties import BED, NECK_LAYERS, PILLAR_IN_NECKS, Tie

_DEEPEST = 40  # layers below a start in which a neck may begin
_CLEAR = 0.3  # mm between a tie and a third body
_TRIES = 36  # places of a start that are tried
_FEET = 12  # places to stand on that are tried, for each of them
_DIRECTIONS = 16  # from which a blade may come
_MOST = 8  # ties of one start


@dataclass
class Tied:
    """``ties`` of a print, the `Start`s that there were, and what is ``left`` of them.

    ``left``: [(`Start`, mm² that hang in the air)].
    """

    ties: list[Tie] = field(default_factory=list)
    starts: list[Start] = field(default_factory=list)
    left: list[tuple[Start, float]] = field(default_factory=list)

    @property
    def left_area(self) -> float:
        """mm² that begin in mid-air in spite of all ties."""
        return float(sum(area for _, area in self.left))


def tied(
    bodies: Sequence[PlacedMesh], layer_height: float, neck: float, progress: Progress = NOBODY
) -> Tied:
    """`Tied` of ``bodies`` (`PlacedMesh`, as they stand on the bed).

    ``layer_height`` and ``neck``, the width of necks, mm. Bodies of a unit are held by those of
    this unit and of the ones next to it.
    """
    found = Tied()
    alive: dict[int, Layers] = {}
    units = sorted({body.unit for body in bodies})
    of_unit = {unit: [k for k, body in enumerate(bodies) if body.unit == unit] for unit in units}
    for place, unit in enumerate(units):
        near = units[max(place - 1, 0) : place + 2]
        wanted = [k for other in near for k in of_unit[other]]
        alive = {k: alive.get(k) or layers(bodies[k].placed, layer_height) for k in wanted}
        search = _Search(alive, layer_height, neck)
        for k in of_unit[unit]:
            for start in starts_of(k, alive[k]):
                found.starts.append(start)
                ties, left = search.hold(start)
                found.ties += ties
                if left > SMALL:
                    found.left.append((start, left))
        progress.step("Ties…", (place + 1) / len(units))
    return found


def _covering(pixels: NDArray, reach: float) -> NDArray:
    """Some of the pixels (n, 2) of a start, first those that have most of it within ``reach``."""
    heads = pixels[:: max(len(pixels) // _TRIES, 1)]
    far = ((heads[:, None] - pixels[None]) ** 2).sum(-1)
    held = (far <= reach**2).sum(1)
    return heads[np.lexsort((far.sum(1), -held))]


class _Search:
    """Looks for ties among the `Layers` of bodies {number: Layers}."""

    def __init__(self, made: Mapping[int, Layers], layer_height: float, neck: float) -> None:
        self.made = {k: one for k, one in made.items() if one.inside.size}
        self.height, self.neck = layer_height, neck
        self.half = max(round(neck / PIXEL / 2), 1)
        self.clear = self.half + round(_CLEAR / PIXEL)
        self.steep = layer_height / PIXEL  # pixels that a tie at 45° moves in a layer
        self._whole: dict[int, tuple[NDArray, NDArray]] = {}
        self._taken: dict[int, list[tuple[NDArray, tuple[int, int]]]] = {}  # layer -> its ties
        self._rays: NDArray | None = None

    def hold(self, start: Start) -> tuple[list[Tie], float]:
        """(ties of a start, mm² of it that are left in the air)."""
        open_pixels = start.pixels
        ties: list[Tie] = []
        window = self._window(start)
        while len(open_pixels) * PIXEL**2 > SMALL or (start.is_island and not ties):
            tie = self._tie(start, open_pixels, window) if len(ties) < _MOST else None
            if tie is None:
                break
            ties.append(tie)
            x, y = tie.head[0] / PIXEL, tie.head[1] / PIXEL
            reach = REACH / PIXEL - 0.5  # the raster
            far = ((open_pixels + 0.5 - [y, x]) ** 2).sum(1)
            open_pixels = open_pixels[far > reach**2]
        is_tied = ties or not start.is_island
        return ties, len(open_pixels) * PIXEL**2 if is_tied else start.area

    def _window(self, start: Start) -> tuple[NDArray, NDArray]:
        """(numbers + 1 of bodies about a start, corner): layers from the deepest to its own."""
        margin = int(_DEEPEST * self.steep) + self.clear + 1
        low = np.append(start.layer - _DEEPEST, start.pixels.min(0) - margin)
        high = np.append(start.layer + 1, start.pixels.max(0) + margin + 1)
        low[0] = max(low[0], 0)
        return self._painted(low, high), low

    def _painted(self, low: ArrayLike, high: ArrayLike) -> NDArray:
        image = np.zeros(np.subtract(high, low), np.int16)
        for k, one in self.made.items():
            start, end = np.maximum(low, one.first), np.minimum(high, one.end)
            if (start < end).all():
                here = tuple(map(slice, start - low, end - low))
                image[here][one.inside[tuple(map(slice, start - one.first, end - one.first))]] = (
                    k + 1
                )
        return image

    def _tie(self, start: Start, pixels: NDArray, window: tuple[NDArray, NDArray]) -> Tie | None:
        """A neck to the nearest that holds, else a pillar; None where there is no way."""
        image, low = window
        heads = _covering(pixels, REACH / PIXEL) - low[1:]
        top = start.layer - low[0]
        solid = image > 0
        for depth in range(2, top + 1):
            reach = (depth - 1) * self.steep
            for head in heads[: max(_TRIES * 4 // (depth * depth), 3)]:
                for foot in self._feet(solid[top - depth], head, reach):
                    path = self._path(head, foot, top, depth)
                    if (
                        self._is_free(image, path, start.body + 1)
                        and self._is_apart(image, path, low, start.body)
                        and self._may_be_cut(image, path, low)
                    ):
                        return self._made(start, low, path, image)
        return self._pillar(start, heads, low)

    def _feet(self, solid: NDArray, head: NDArray, reach: float) -> Sequence[NDArray]:
        """Places (row, column) of a layer to stand on within ``reach`` pixels, nearest first."""
        span = int(reach)
        corner = np.maximum(head - span, 0)
        part = solid[tuple(slice(c, h + span + 1) for c, h in zip(corner, head, strict=True))]
        places = np.argwhere(part)
        if not len(places):
            return []
        places += corner
        far = ((places - head) ** 2).sum(1)
        places = places[far <= reach**2]
        if not len(places):
            return []
        half = self.half
        padded = np.pad(part, half)
        whole = np.zeros(part.shape, np.int8)
        for dy in (-half, 0, half):
            for dx in (-half, 0, half):
                rows, columns = (
                    slice(half + shift, half + shift + length)
                    for shift, length in zip((dy, dx), part.shape, strict=True)
                )
                whole += padded[rows, columns]
        held = whole[tuple((places - corner).T)]
        far = ((places - head) ** 2).sum(1)
        places = places[np.lexsort((far, -np.minimum(held, 8)))]
        return places[:_FEET]

    def _path(self, head: NDArray, foot: NDArray, top: int, depth: int) -> tuple[NDArray, NDArray]:
        """(layers, middles (n, 2)) from the foot's layer to the head's."""
        steps = np.arange(depth + 1)
        middles = foot + (head - foot) * np.minimum(steps / (depth - 1), 1)[:, None]
        return top - depth + steps, np.round(middles).astype(int)

    def _is_free(self, image: NDArray, path: tuple[NDArray, NDArray], own: int) -> bool:
        """Whether a path meets its own two bodies only, each at its end, and can be cut between.

        Right below its head it is in air all round: there it is cut. Below that it keeps off the
        body that it holds, and everywhere clear of all others.
        """
        numbers, middles = path
        holder = int(image[numbers[0], middles[0, 0], middles[0, 1]])
        if self._about(image, numbers[-2], middles[-2], self.half + 1).any():
            return False
        for layer, place in zip(numbers, middles, strict=True):
            about = self._about(image, layer, place, self.clear)
            if ((about != 0) & (about != own) & (about != holder)).any():
                return False
            if layer < numbers[-1] and own != holder and (about == own).any():
                near = self._about(image, layer, place, self.half + 2)
                if (near == own).any():
                    return False
        return True

    def _is_apart(
        self, image: NDArray, path: tuple[NDArray, NDArray], low: NDArray, own: int
    ) -> bool:
        """Whether a path keeps off ties that join other bodies."""
        numbers, middles = path
        pair = own, int(image[numbers[0], middles[0, 0], middles[0, 1]]) - 1
        return not any(
            other != pair and np.abs(place + low[1:] - there).max() <= 2 * self.half + 1
            for layer, place in zip(numbers, middles, strict=True)
            for there, other in self._taken.get(int(layer + low[0]), ())
        )

    @staticmethod
    def _about(image: NDArray, layer: int, place: NDArray, reach: int) -> NDArray:
        """The square within ``reach`` pixels of a place in a layer."""
        (top, left), (bottom, right) = np.maximum(place - reach, 0), place + reach + 1
        return image[layer, top:bottom, left:right]

    def _may_be_cut(self, image: NDArray, path: tuple[NDArray, NDArray], low: NDArray) -> bool:
        """Whether somewhere along it a blade comes straight from outside, in a layer."""
        numbers, middles = path
        in_air = np.flatnonzero(image[numbers, middles[:, 0], middles[:, 1]] == 0)
        if not len(in_air):
            return False
        k = in_air[len(in_air) // 2]
        return self._is_open(int(numbers[k] + low[0]), middles[k] + low[1:])

    def _is_open(self, layer: int, place: NDArray) -> bool:
        """Whether a straight way from ``place`` leads out of all bodies in a layer."""
        image, corner = self._of_layer(layer)
        start = place - corner
        if self._rays is None:
            turn = 2 * np.pi * np.arange(_DIRECTIONS) / _DIRECTIONS
            steps = np.arange(self.half + 1, sum(image.shape))
            ways = np.stack([np.sin(turn), np.cos(turn)])[:, :, None] * steps
            self._rays = np.round(ways).astype(int)
        row, column = self._rays + start[:, None, None]
        inside = (row >= 0) & (row < image.shape[0]) & (column >= 0) & (column < image.shape[1])
        met = image[np.where(inside, row, 0), np.where(inside, column, 0)] & inside
        return not met.any(1).all()

    def _of_layer(self, layer: int) -> tuple[NDArray, NDArray]:
        """(bool raster of all bodies in a layer, its corner)."""
        if layer not in self._whole:
            if len(self._whole) > 64:
                self._whole.clear()
            low = np.min([one.first[1:] for one in self.made.values()], axis=0)
            high = np.max([one.end[1:] for one in self.made.values()], axis=0)
            box = np.append(layer, low), np.append(layer + 1, high)
            self._whole[layer] = self._painted(*box)[0] > 0, low
        return self._whole[layer]

    def _made(
        self, start: Start, low: NDArray, path: tuple[NDArray, NDArray], image: NDArray
    ) -> Tie:
        """The `Tie` along a path: sunk one layer into both its bodies."""
        numbers, middles = path
        holder = int(image[numbers[0], middles[0, 0], middles[0, 1]]) - 1
        ends: list[tuple[float, float, float]] = []
        for place, layer in ((middles[0], numbers[0]), (middles[-1], numbers[-1] + 1)):
            row, column = place + low[1:] + 0.5
            height = float((layer + low[0]) * self.height)
            ends.append((float(column * PIXEL), float(row * PIXEL), height))
        for layer, place in zip(numbers, middles, strict=True):
            self._take(int(layer + low[0]), place + low[1:], start.body, holder)
        return Tie(ends[0], ends[1], self.neck, 0.0, start.body, holder, self.height)

    def _take(self, layer: int, place: NDArray, holds: int, on: int) -> None:
        self._taken.setdefault(layer, []).append((place, (holds, on)))

    def _pillar(self, start: Start, heads: NDArray, low: NDArray) -> Tie | None:
        """A pillar straight up under one of the ``heads``, from the bed or what lies below."""
        half = round(self.neck * PILLAR_IN_NECKS / PIXEL / 2) + round(_CLEAR / PIXEL)
        for head in heads[:: max(len(heads) // 6, 1)]:
            row, column = head + low[1:]
            box = np.array(
                [[0, row - half, column - half], [start.layer, row + half + 1, column + half + 1]]
            )
            shaft = self._painted(*box).any((1, 2))
            below = int(np.flatnonzero(shaft)[-1]) if shaft.any() else BED
            if below != BED and start.layer - below <= 5 * NECK_LAYERS:
                continue
            under = (
                self._painted([below, row, column], [below + 1, row + 1, column + 1])
                if (below != BED)
                else None
            )
            if under is not None and not under.any():
                continue
            foot = 0 if below == BED else below
            x, y = (column + 0.5) * PIXEL, (row + 0.5) * PIXEL
            ends = [(float(x), float(y), layer * self.height) for layer in (foot, start.layer + 1)]
            on = BED if under is None else int(under.ravel()[0]) - 1
            wide = self.neck * PILLAR_IN_NECKS
            for layer in range(foot, start.layer + 1):
                self._take(layer, np.array([row, column]), start.body, on)
            return Tie(ends[0], ends[1], self.neck, wide, start.body, on, self.height)
        return None
