# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volumes (mm³) of hinged panels and links in closed form, from their layout alone."""

from math import acos, asin, cos, pi, sin, sqrt
from typing import TYPE_CHECKING

from . import polygons
from .link_section import link_section
from .parameters import PIN

if TYPE_CHECKING:
    from .parameters import HingeParameters
    from .unit_layout import Hinge, Link, Plate


def plate_volume(plate: "Plate", parameters: "HingeParameters") -> float:
    """Volume of a panel: plate and tabs, barrels outside the tabs, cones, recesses, pins, bores."""
    area = polygons.area(plate.outline(lambda tab: 0.0))
    head = barrel_area_outside_tab(parameters)
    volume = parameters.face_thickness * area
    for tab in plate.tabs:
        start, end = tab.hinge.segments[tab.index]
        volume += (head + crest_area(tab.crest, parameters)) * (end - start)
        volume += feature_volume(tab.hinge, tab.index, parameters)
    return volume + sum(polygons.area(stud.corners) * stud.height for stud in plate.studs)


def barrel_area_outside_tab(parameters: "HingeParameters") -> float:
    """Area (mm²) of a barrel's section that is not in its tab (depth ≥ 0 within the plate)."""
    r, lower = parameters.radius, parameters.gap_between_planes / 2
    quarter = (r * r * acos(lower / r) - lower * sqrt(r * r - lower * lower)) / 2
    return pi * r * r - quarter


def crest_area(crest: tuple, parameters: "HingeParameters") -> float:
    """Area (mm²) of the section of a stand-off on a barrel's top: `Tab.crest`, `Link.crest`."""
    if not crest:
        return 0.0
    width, height = crest[:2]
    r = parameters.radius
    half = asin(width / 2 / r)
    segment = r * r * (half - sin(half) * cos(half))
    return width * (r + height - r * cos(half)) - segment


def feature_volume(hinge: "Hinge", index: int, parameters: "HingeParameters") -> float:
    """What the cones, recesses, pins and bores of one knuckle add (mm³, negative if they take)."""
    last = len(hinge.segments) - 1
    if parameters.pivot == PIN:
        r = parameters.pin_radius
        start, end = hinge.segments[index]
        if index % 2:
            return -pi * (r + parameters.gap_length) ** 2 * (end - start)
        return 0.0 if index == last else pi * r * r * (hinge.segments[index + 2][0] - end)
    return cone_volume(hinge, parameters) * ((index < last) - (index > 0))


def cone_volume(hinge: "Hinge", parameters: "HingeParameters") -> float:
    """Volume of one blunt cone of a hinge."""
    base, tip = parameters.cone_base, parameters.tip_radius(hinge.cone_height)
    return pi * hinge.cone_height * (base * base + base * tip + tip * tip) / 3


def link_volume(link: "Link", parameters: "HingeParameters") -> float:
    """Volume of a link: dogbones, the spine between them, cones or bores.

    The lengths are those of the mean line; exact where both axes are parallel.
    """
    lower, upper = link.hinges
    dogbone, spine = link_section_areas(parameters)
    dogbone += crest_area(link.crest, parameters)
    volume, last = 0.0, None
    for index in range(1, len(lower.segments), 2):
        ends = [(lower.segments[index][k] + upper.segments[index][k]) / 2 for k in (0, 1)]
        volume += dogbone * (ends[1] - ends[0])
        if last is not None:
            volume += spine * (ends[0] - last)
        volume += sum(feature_volume(hinge, index, parameters) for hinge in link.hinges)
        last = ends[1]
    return volume


def link_section_areas(parameters: "HingeParameters") -> tuple:
    """Areas (mm²) of a link's section at a dogbone and between dogbones."""
    section, r, p = link_section(parameters), parameters.radius, parameters.pitch

    def below(radius: float, low: float, high: float) -> float:
        def primitive(x: float) -> float:
            return (x * sqrt(radius**2 - x * x) + radius**2 * asin(x / radius)) / 2

        return primitive(high) - primitive(low)

    block = 2 * p * (section.web + section.outer)
    dogbone = 2 * pi * r * r + block - 2 * below(r, -section.web, r)
    hollow = 2 * below(section.clear, section.inner, section.clear)
    return dogbone, 2 * p * (section.outer - section.inner) - hollow
