# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a body starts in mid-air: every region of a layer that nothing below holds."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .layers import PIXEL

if TYPE_CHECKING:
    from .layers import Layers, Tops

LEAST = 0.1  # mm²: what is smaller is not laid by itself


class Start(NamedTuple):
    """A region of a layer that starts in mid-air: ``area`` mm², the ``pixel`` of one place."""

    area: float
    pixel: tuple


def held_by(others: "Sequence[Layers | Tops]", body: "Layers", number: int, depth: int) -> NDArray:
    """Where, over a body's pixels, ``others`` lie at most ``depth`` layers below ``number``."""
    low, high = body.first.copy(), body.end
    low[0], high[0] = number - depth, number
    found = np.zeros(body.inside.shape[1:], bool)
    for other in others:
        if (other.first < high).all() and (other.end > low).all():
            found |= other.window(low, high).any(0)
    return found


def starts(body: "Layers", others: "Sequence[Layers | Tops]", depth: int) -> list[Start]:
    """`Start`s of a body, ``others`` being whatever else is printed.

    A region of a layer starts in mid-air where none of it lies on the body's own layer below, and
    nothing else lies, nor the bed, at most ``depth`` layers below.
    """
    found = []
    for k, layer in enumerate(body.inside):
        number = int(body.first[0]) + k
        if number <= depth or not layer.any():
            continue
        below = layer & body.inside[k - 1] if k else np.zeros_like(layer)
        if below.sum() == layer.sum():
            continue
        rest = layer & ~reached(layer, below)
        if not rest.any():
            continue
        rest &= ~reached(layer, rest & held_by(others, body, number, depth))
        while rest.any():
            pixel = np.argwhere(rest)[0]
            seed = np.zeros_like(rest)
            seed[tuple(pixel)] = True
            region = reached(rest, seed)
            rest &= ~region
            area = float(region.sum()) * PIXEL**2
            if area > LEAST:
                found.append(Start(area, (k, *map(int, pixel))))
    return found


def reached(area: NDArray, seed: NDArray) -> NDArray:
    """The part of an area (rows, columns) bool that hangs together with ``seed``, along its sides.

    From what is reached it spreads along whole rows, then columns, until nothing is added.
    """
    seed = seed & area
    while seed.any():
        before = int(seed.sum())
        seed = _spread(area, seed)
        seed = _spread(area.T, seed.T).T
        if int(seed.sum()) == before:
            break
    return seed


def _spread(area: NDArray, seed: NDArray) -> NDArray:
    """Whatever lies in a row of ``area`` without a gap beside ``seed``."""
    found = seed
    for way in (slice(None), slice(None, None, -1)):
        inside, from_here = area[:, way], found[:, way]
        index = np.arange(inside.shape[1])
        last = np.maximum.accumulate(np.where(from_here, index, -1), 1)
        stop = np.maximum.accumulate(np.where(inside, -1, index), 1)
        found = (inside & (last > stop))[:, way]
    return found
