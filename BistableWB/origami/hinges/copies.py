# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundaries of plates and links, each drawn once for all its mirror images."""

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .knuckles import plate_boundary
from .links import link_boundary

if TYPE_CHECKING:
    from .boundary import Boundary
    from .parameters import HingeParameters
    from .unit_layout import Hinge, Link, Plate

_MOST = 500  # boundaries kept for one set of parameters: ribbed ones take a megabyte each
# Coordinates that differ by less than this (mm) make the same body.
SAME = 6


@lru_cache(maxsize=3)
def copies_for(parameters: "HingeParameters") -> "Copies":
    """The `Copies` of these parameters, with what other tubes, or the same before a change, drew.

    So only what has changed is drawn, made and meshed anew.
    """
    return Copies(parameters)


class Copies:
    """Bodies already drawn, found again for any copy that is mirrored up-down or left-right.

    Plane units have their lower half as the mirror image of the upper one, and panels that meet
    their own hinges only are alike on the left and on the right; units of an arc are all alike.
    """

    def __init__(self, parameters: "HingeParameters") -> None:
        self.parameters = parameters
        self._known: dict[Any, Any] = {}

    def plate(self, plate: "Plate") -> "tuple[Boundary, NDArray]":
        """(`Boundary`, matrix (4, 4) that carries it) of a plate in its unit's flat frame."""
        return self._find(plate, _plate_key, plate_boundary)

    def link(self, link: "Link") -> "tuple[Boundary, NDArray]":
        """(`Boundary`, matrix (4, 4) that carries it) of a link in its unit's flat frame."""
        return self._find(link, _link_key, link_boundary)

    def _find(
        self, item: "Link | Plate", key_of: Callable[..., Any], draw: Callable[..., Any]
    ) -> "tuple[Boundary, NDArray]":
        height = _height(item)
        for conjugate in (False, True):
            for upside in (1, -1):
                found = self._known.get(key_of(item, conjugate, upside))
                if found is not None:
                    boundary, drawn = found
                    return boundary, _carrier(conjugate, upside, drawn, height)
        if len(self._known) >= _MOST:
            self._known.clear()
        boundary = draw(item, self.parameters)
        self._known[key_of(item, False, 1)] = boundary, height
        return boundary, np.eye(4)


def _height(item: "Link | Plate") -> float:
    if hasattr(item, "hinges"):
        return sum(hinge.height for hinge in item.hinges) / 2
    return item.height


def _carrier(conjugate: bool, upside: int, from_height: float, to_height: float) -> NDArray:
    """Matrix that mirrors z, turns heights over, and lifts from one height to another."""
    matrix = np.diag([1.0, upside, -1.0 if conjugate else 1.0, 1.0])
    matrix[1, 3] = to_height - upside * from_height
    return matrix


def _place(point: complex, conjugate: bool) -> tuple[float, float]:
    return round(point.real, SAME), round(-point.imag if conjugate else point.imag, SAME)


def _segment_key(
    hinge: "Hinge", index: int, height: float, conjugate: bool, upside: int
) -> tuple[Any, ...]:
    return (
        *(_place(hinge.point(s), conjugate) for s in hinge.segments[index]),
        round(upside * (hinge.height - height), SAME),
        index > 0,
        index < len(hinge.segments) - 1,
        index % 2,
    )


def _plate_key(plate: "Plate", conjugate: bool, upside: int) -> tuple[Any, ...]:
    core = sorted(_place(p, conjugate) for p in plate.core)
    tabs = sorted(
        (*_segment_key(tab.hinge, tab.index, plate.height, conjugate, upside), tab.crest)
        for tab in plate.tabs
    )
    return tuple(core), tuple(tabs), _studs_key(plate, conjugate, upside)


def _studs_key(plate: "Plate", conjugate: bool, upside: int) -> bytes:
    """Of hundreds of stand-offs, in any order: their corners, each in any order, and heights."""
    if not plate.studs:
        return b""
    corners = np.array([stud.corners for stud in plate.studs])
    corners = np.sort(np.round(corners if not conjugate else corners.conj(), SAME) + 0.0, axis=1)
    heights = np.round([stud.height for stud in plate.studs], SAME)
    rows = np.column_stack([corners.real, corners.imag, heights]) + 0.0
    return rows[np.lexsort(rows.T)].tobytes() + bytes([upside * plate.up > 0])


def _link_key(link: "Link", conjugate: bool, upside: int) -> tuple[Any, ...]:
    height = _height(link)
    segments = sorted(
        _segment_key(hinge, index, height, conjugate, upside)
        for hinge in link.hinges
        for index in range(len(hinge.segments))
    )
    crest = (*link.crest[:2], upside * link.crest[2]) if link.crest else ()
    return tuple(segments), _place(link.outward, conjugate), crest
