# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundaries of panels with their knuckles: plate, a "J" for each, cones or pins (hinges.md 2).

Heights run along y of a unit's flat frame, a plan point x + i z is (x, height, z).
"""

import itertools
from collections.abc import Callable, Mapping, Sequence
from math import asin, copysign, cos, pi, sin, sqrt
from typing import TYPE_CHECKING, Any

from .drafting import Draft
from .parameters import PIN
from .unit_layout import Tab

if TYPE_CHECKING:
    from .boundary import Boundary
    from .parameters import HingeParameters
    from .standoffs import Stud
    from .unit_layout import Hinge, Plate


def at(plan_point: complex, height: float) -> tuple:
    """Point (x, y, z) of a unit's flat frame from a plan point (x + i z) and a height (mm)."""
    return plan_point.real, height, plan_point.imag


def inner_depth(parameters: "HingeParameters") -> float:
    """Distance from the axis (mm) at which a plate's inner face meets the barrel."""
    return sqrt(parameters.radius**2 - (parameters.gap_between_planes / 2) ** 2)


def side_of(tab: Tab, plate: "Plate") -> float:
    """On which face of its plate (−1 lower, +1 upper) a tab's axis lies."""
    return copysign(1, tab.hinge.height - plate.height)


def plate_boundary(plate: "Plate", parameters: "HingeParameters") -> "Boundary":
    """`Boundary` of one `Plate` in the unit's flat frame."""
    draft = Draft()
    draw_plate(draft, plate, parameters)
    return draft.boundary()


def draw_plate(
    draft: Draft,
    plate: "Plate",
    parameters: "HingeParameters",
    holes: Mapping[int, Sequence[Sequence[int]]] | None = None,
) -> None:
    """All faces of a plate with its knuckles.

    ``holes``: {−1 or 1: loops of edges} in the lower or upper face, clockwise from outside, where a
    block goes on or a dowel through.
    """
    half = parameters.face_thickness / 2
    heights = plate.height - half, plate.height + half
    corners = {}  # of the core: number in the ring -> its (lower, upper) vertex
    knuckles = {}
    for place, item in enumerate(plate.ring):
        if isinstance(item, Tab):
            knuckles[place] = _Knuckle(draft, item, side_of(item, plate), parameters)
        else:
            corners[place] = tuple(draft.vertex(at(item, height)) for height in heights)
    outlines: Any
    outlines, stops = ([], []), []
    for place in range(len(plate.ring)):
        if place in corners:
            for outline, corner in zip(outlines, corners[place], strict=True):
                outline.append(corner)
            stops.append((corners[place], corners[place]))
            continue
        knuckle = knuckles[place]
        for outline, upper in zip(outlines, (0, 1), strict=True):
            outline += knuckle.outline(upper)
        stops.append(knuckle.feet())
    lower, upper = outlines[0], outlines[1][::-1]
    face = heights[plate.up > 0]
    feet = [_stud(draft, stud, face, plate.up) for stud in plate.studs]
    for side, outline in ((-1, lower), (1, upper)):
        inner = [*(holes or {}).get(side, []), *(feet if side == plate.up else [])]
        draft.plane(draft.ring(outline), *inner)
    for (_, (low, high)), ((next_low, next_high), _) in zip(
        stops, [*stops[1:], stops[0]], strict=True
    ):
        draft.polygon(low, high, next_high, next_low)
    drawn: dict[Any, Any] = {}
    for knuckle in knuckles.values():
        knuckle.draw(drawn)


def _stud(draft: Draft, stud: "Stud", face: float, up: int) -> list[int]:
    """Sides and top of a stand-off on a face at this height; its foot, a hole in that face."""
    corners = stud.corners[::up]
    low, high = (
        [draft.vertex(at(p, face + up * rise)) for p in corners] for rise in (0.0, stud.height)
    )
    for (a, b), (c, d) in zip(
        zip(low, [*low[1:], low[0]], strict=True),
        zip(high, [*high[1:], high[0]], strict=True),
        strict=True,
    ):
        draft.polygon(a, c, d, b)
    draft.polygon(*high[::-1])
    return draft.ring(low)


class _Knuckle:
    """The eight vertices of a knuckle's "J" profiles, and its faces."""

    def __init__(self, draft: Draft, tab: Tab, side: float, parameters: "HingeParameters") -> None:
        self.draft, self.tab, self.side, self.parameters = draft, tab, side, parameters
        r, half_gap = parameters.radius, parameters.gap_between_planes / 2
        height, inner = tab.hinge.height, inner_depth(parameters)
        low, high = height - side * r, height - side * half_gap
        self._lines: set[int] = set()  # of crests
        self.ends = []  # per end: tangent, inner, far inner, far outer
        for end in (0, 1):
            depth = tab.depths[end]
            places = ((0.0, low), (inner, high), (depth, high), (depth, low))
            self.ends.append([draft.vertex(at(tab.corner(end, d), y)) for d, y in places])

    def outline(self, upper: int) -> list:
        """Vertices of the tab in the lower (0) or upper (1) face, counter-clockwise in plan."""
        a, b = (0, 1) if self.tab.forward else (1, 0)
        near, far = (1, 2) if (self.side > 0) == bool(upper) else (0, 3)
        first, last = self.ends[a], self.ends[b]
        return [first[far], first[near], last[near], last[far]]

    def feet(self) -> tuple:
        """(lower, upper) vertices where the tab leaves the core's edge, and where it comes back."""
        order = (0, 1) if self.tab.forward else (1, 0)
        upright = (3, 2) if self.side > 0 else (2, 3)
        return tuple(tuple(self.ends[end][k] for k in upright) for end in order)

    def draw(self, drawn: Mapping[tuple[str, int], Sequence[int]]) -> None:
        """Barrel, both ends, and cone, recess, pin or bore.

        ``drawn``: circles of the body's pins by (hinge, segment): grows.
        """
        draft, tab = self.draft, self.tab
        holes = pivot_faces(
            draft, tab.hinge, self.parameters, tab.index, tab.hinge.direction, drawn
        )
        barrels = [self._barrel(end) for end in (0, 1)]
        turn = self._turn()
        for first, second in zip(*barrels, strict=True):
            draft.ruled(first, second, turn, flat=first in self._lines)
        for end, (tangent, inner, far_inner, far_outer) in enumerate(self.ends):
            line = draft.line
            loop = [
                *barrels[end], line(inner, far_inner), line(far_inner, far_outer),
                line(far_outer, tangent),
            ]  # fmt: skip
            if (turn > 0) != bool(end):
                loop = [~ref for ref in reversed(loop)]
            draft.plane(loop, *holes[end])

    def _turn(self) -> float:
        """1 where the profile runs anticlockwise about the axis, else −1."""
        inward, direction = self.tab.inward, self.tab.hinge.direction
        # up × inward along the axis: (0, s, 0) × (a, 0, b) = s (b, 0, −a)
        return copysign(
            1, self.side * (inward.imag * direction.real - inward.real * direction.imag)
        )

    def _barrel(self, end: int) -> list[int]:
        """The arcs of a profile, from the tangent round to the plate's inner face; its crest."""
        r = self.parameters.radius
        tangent, inner = self.ends[end][:2]
        sweep = 1.5 * pi + asin(self.parameters.gap_between_planes / 2 / r)
        if not self.tab.crest:
            return [self._arc(end, tangent, inner, 0.0, sweep)]
        width, height = self.tab.crest
        half = asin(width / 2 / r)
        corners = [
            self.draft.vertex(
                at(self.tab.corner(end, depth), self.tab.hinge.height + self.side * rise)
            )
            for depth, rise in (
                (-width / 2, r * cos(half)), (-width / 2, r + height),
                (width / 2, r + height), (width / 2, r * cos(half)),
            )
        ]  # fmt: skip
        lines = [self.draft.line(a, b) for a, b in itertools.pairwise(corners)]
        self._lines.update(lines)
        return [
            self._arc(end, tangent, corners[0], 0.0, pi - half),
            *lines,
            self._arc(end, corners[-1], inner, pi + half, sweep - pi - half),
        ]

    def _arc(self, end: int, first: int, last: int, start: float, sweep: float) -> int:
        """The arc of a profile from ``start`` (radians from the tangent) over ``sweep``."""
        r, side, inward = self.parameters.radius, self.side, self.tab.inward
        centre = at(self.tab.corner(end, 0.0), self.tab.hinge.height)
        along, across = (0.0, -side * r, 0.0), (-r * inward.real, 0.0, -r * inward.imag)
        if start:
            c, s = cos(start), sin(start)
            (a, b, d), (e, f, g) = along, across
            along = a * c + e * s, b * c + f * s, d * c + g * s
            across = e * c - a * s, f * c - b * s, g * c - d * s
        return self.draft.arc(first, last, centre, along, across, sweep)


def pivot_faces(
    draft: Draft,
    hinge: "Hinge",
    parameters: "HingeParameters",
    index: int,
    axis: complex,
    drawn: Mapping[tuple[str, int], Sequence[int]],
) -> tuple:
    """What makes knuckle ``index`` of a hinge turn; the holes in both its end faces.

    ``axis``: plan direction along which its cones and bores point; ``drawn``: the body's pins by
    (hinge, segment) that wait for the end face that they run into. Returns a list of loops for
    each end, clockwise as that end face is seen from outside.
    """
    make = _pin_faces if parameters.pivot == PIN else _cone_faces
    return make(draft, hinge, parameters, index, axis, drawn)


def circle(draft: Draft, centre: Sequence[float], radius: float, axis: complex) -> int:
    """Full circle about ``centre`` (x, y, z), anticlockwise about a plan direction ``axis``."""
    across = -radius * axis.imag, 0.0, radius * axis.real
    return draft.circle(centre, (0.0, radius, 0.0), across)


def _cone_faces(
    draft: Draft,
    hinge: "Hinge",
    parameters: "HingeParameters",
    index: int,
    axis: complex,
    _drawn: Mapping[Any, Any],
) -> Any:
    """Recess at the start of a knuckle and cone at its end, except at the ends of the hinge."""
    base, tip = parameters.cone_base, parameters.tip_radius(hinge.cone_height)
    has = index > 0, index < len(hinge.segments) - 1
    holes: tuple[list[Any], list[Any]] = [], []
    for end, present in enumerate(has):
        if not present:
            continue
        foot = hinge.point(hinge.segments[index][end])
        top = foot + hinge.cone_height * axis
        rims = [
            circle(draft, at(place, hinge.height), radius, axis)
            for place, radius in ((foot, base), (top, tip))
        ]
        solid = 1 if end else -1
        draft.ruled(rims[0], rims[1], solid)
        draft.plane([rims[1] if solid > 0 else ~rims[1]])
        holes[end].append([~rims[0] if end else rims[0]])
    return holes


def _pin_faces(
    draft: Draft,
    hinge: "Hinge",
    parameters: "HingeParameters",
    index: int,
    axis: complex,
    drawn: Mapping[tuple[str, int], Sequence[int]],
) -> Any:
    """Pin from an even knuckle through the next ring, or the bore of an odd knuckle (a ring)."""
    radius = parameters.pin_radius

    def rim(segment: int, end: int, size: float) -> int:
        place = hinge.point(hinge.segments[segment][end])
        return circle(draft, at(place, hinge.height), size, axis)

    if index % 2:
        rims = [rim(index, end, radius + parameters.gap_length) for end in (0, 1)]
        draft.ruled(rims[0], rims[1], -1)
        return [[rims[0]]], [[~rims[1]]]
    holes: tuple[list[Any], list[Any]] = [], []
    if index:
        holes[0].append([_pin(draft, hinge, index - 2, rim, radius, drawn)[1]])
    if index < len(hinge.segments) - 1:
        holes[1].append([~_pin(draft, hinge, index, rim, radius, drawn)[0]])
    return holes


def _pin(
    draft: Draft,
    hinge: "Hinge",
    index: int,
    rim: Callable[..., Any],
    radius: float,
    drawn: Any,
) -> tuple[int, int]:
    """Rims of the pin from knuckle ``index`` to the one after the next, drawn once."""
    key = hinge.name, index
    if key not in drawn:
        drawn[key] = rim(index, 1, radius), rim(index + 2, 0, radius)
        draft.ruled(drawn[key][0], drawn[key][1], 1)
    return drawn[key]
