# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a body starts in mid-air: every region of a layer that nothing below holds."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..origami.hinges.starts import labelled
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
        labels, count = labelled(layer, corners=False)
        begins = np.ones(count + 1, bool)
        begins[0] = begins[labels[below]] = False
        if not begins.any():
            continue
        begins[labels[held_by(others, body, number, depth) & layer]] = False
        areas = np.bincount(labels.ravel(), minlength=count + 1) * PIXEL**2
        for region in np.flatnonzero(begins & (areas > LEAST)):
            pixel = np.argwhere(labels == region)[0]
            found.append(Start(float(areas[region]), (k, *map(int, pixel))))
    return found
