# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plates and links, each built once for all its mirror images."""

from FreeCAD import Vector

from ..origami.hinge_volume import link_volume, plate_volume
from .links import link_solid
from .plates import plate_solid

# Coordinates that differ by less than this (mm) make the same body.
SAME = 6


class BodyCache:
    """Bodies already built, found again for any copy that is mirrored up-down or left-right.

    Plane units have their lower half as the mirror image of the upper one, and panels that meet
    their own hinges only are alike on the left and on the right; units of an arc are all alike.
    """

    def __init__(self, parameters):
        self.parameters = parameters
        self._known = {}

    def plate(self, plate):
        """Solid of a plate in its unit's flat frame."""
        return self._find(plate, _plate_key, plate_solid, plate_volume)

    def link(self, link):
        """Solid of a link in its unit's flat frame."""
        return self._find(link, _link_key, link_solid, link_volume)

    def _find(self, item, key_of, build, volume_of):
        height = _height(item)
        for conjugate in (False, True):
            for upside in (1, -1):
                found = self._known.get(key_of(item, conjugate, upside))
                if found is not None:
                    return _mirrored(found[0], conjugate, upside, found[1], height)
        shape = build(item, self.parameters, volume_of(item, self.parameters))
        self._known[key_of(item, False, 1)] = shape, height
        return shape


def _height(item):
    if hasattr(item, "hinges"):
        return sum(hinge.height for hinge in item.hinges) / 2
    return item.height


def _mirrored(shape, conjugate, upside, from_height, to_height):
    if conjugate:
        shape = shape.mirror(Vector(0, 0, 0), Vector(0, 0, 1))
    if upside < 0:
        middle = (from_height + to_height) / 2
        return shape.mirror(Vector(0, middle, 0), Vector(0, 1, 0))
    if abs(to_height - from_height) > 10.0**-SAME:
        shape = shape.translated(Vector(0, to_height - from_height, 0))
    return shape


def _place(point, conjugate):
    return round(point.real, SAME), round(-point.imag if conjugate else point.imag, SAME)


def _segment_key(hinge, index, height, conjugate, upside):
    return (
        *(_place(hinge.point(s), conjugate) for s in hinge.segments[index]),
        round(upside * (hinge.height - height), SAME),
        index > 0,
        index < len(hinge.segments) - 1,
        index % 2,
    )


def _plate_key(plate, conjugate, upside):
    core = sorted(_place(p, conjugate) for p in plate.core)
    tabs = sorted(
        _segment_key(tab.hinge, tab.index, plate.height, conjugate, upside) for tab in plate.tabs
    )
    return tuple(core), tuple(tabs)


def _link_key(link, conjugate, upside):
    height = _height(link)
    segments = sorted(
        _segment_key(hinge, index, height, conjugate, upside)
        for hinge in link.hinges
        for index in range(len(hinge.segments))
    )
    return tuple(segments), _place(link.outward, conjugate)
