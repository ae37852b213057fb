# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hinges, tabs, plates and links in plan: vertex relief, spans, segments, cut-back outlines.

hinges.md 2. Plan points are complex numbers x + i z (mm); heights (mm) are measured along the
stack. A panel is a convex *core*, cut back by barrel radius + clearance from every hinge axis along
its edges, and one *tab* for each of its own knuckles, which runs from the core to the axis. So
panels clear all barrels by construction, and no boolean is ever needed.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import sqrt
from typing import TYPE_CHECKING, Any

from ..errors import phrase
from . import polygons
from .parameters import MINIMUM_SEGMENTS
from .room import TooSmall
from .segments import cone_height_for, segment_lengths

if TYPE_CHECKING:
    from ..errors import Phrase
    from .parameters import HingeParameters

# Corners x + i z of the panels' cores, and what lies along each edge.
Cores = Mapping[str, tuple[Sequence[complex], Sequence[Any]]]

# Knuckles keep this far from the corners of a core (mm): no slivers, no coincident edges.
CORNER = 0.1


@dataclass(frozen=True)
class Hinge:
    """One hinge axis in plan and its knuckles.

    ``origin``, ``direction`` (unit): the axis; ``height``: its height (mm); ``bodies``: owner of
    the even and of the odd segments; ``stretch``: the part of the axis between its two vertices;
    ``corners``: plan vertex at each end of the stretch; ``segments``: (start, end) of each knuckle
    along the axis (mm from the origin); ``cone_height`` (mm).
    """

    name: str
    origin: complex
    direction: complex
    height: float
    bodies: tuple
    stretch: tuple
    corners: tuple
    segments: tuple = ()
    cone_height: float = 0.0

    def point(self, along: float) -> complex:
        """Plan point of the axis at ``along`` mm from its origin."""
        return self.origin + along * self.direction

    @property
    def cones(self) -> list:
        """Every cone: where its base is along the axis (mm), and which of ``bodies`` carries it.

        A cone stands on the end of every segment but the last and points along the axis into the
        recess of the next one.
        """
        return [(end, k % 2) for k, (_, end) in enumerate(self.segments[:-1])]


@dataclass(frozen=True)
class Tab:
    """The part of a panel that carries one knuckle: segment ``index`` of ``hinge``.

    ``inward``: unit vector from the axis into the panel; ``depths``: distance from the axis to the
    core at the segment's start and end (mm); ``between``: core corners inside the tab's base, in
    counter-clockwise order; ``forward``: whether the axis runs counter-clockwise round the core;
    ``crest``: (width, height above the barrel) of a stand-off along its barrel's top, mm, or empty.
    """

    hinge: Hinge
    index: int
    inward: complex
    depths: tuple
    between: tuple
    forward: bool
    crest: tuple = ()

    def corner(self, end: int, depth: float | None = None) -> complex:
        """Plan point at the segment's start (0) or end (1), ``depth`` mm from the axis."""
        depth = self.depths[end] if depth is None else depth
        return self.hinge.point(self.hinge.segments[self.index][end]) + depth * self.inward


@dataclass(frozen=True)
class Plate:
    """One panel: ``core`` corners, and ``ring``: core corners and `Tab`s, counter-clockwise.

    ``height``: of the mid-plane (mm from the unit's middle); ``kind``: as of `creases.kind_of`;
    ``studs``: the stand-offs (`standoffs.Stud`) on its face that is ``up`` (1 its upper one, −1 its
    lower one) in the print.
    """

    name: str
    height: float
    core: tuple
    ring: tuple
    kind: str
    studs: tuple = ()
    up: int = 1

    @property
    def tabs(self) -> list:
        """The plate's tabs, one a knuckle."""
        return [item for item in self.ring if isinstance(item, Tab)]

    def outline(self, tip: Callable[..., Any]) -> list:
        """Closed polygon of core and tabs; ``tip(tab)`` is the depth (mm) at which a tab ends."""
        points = []
        for item in self.ring:
            if isinstance(item, Tab):
                points += tab_points(item, tip(item))
            else:
                points.append(item)
        return points


@dataclass(frozen=True)
class Link:
    """A double hinge's link: its two hinges, lower first, and the way out from the panels.

    ``crest``: (width, height, up) of a stand-off along its barrels, mm, on top (1) or below (−1).
    """

    name: str
    hinges: tuple
    outward: complex
    crest: tuple = ()


@dataclass(frozen=True)
class Layout:
    """Plates, links and hinges by name, and what was changed to fit (``notes``)."""

    plates: dict
    links: dict
    hinges: dict
    notes: tuple


def finish(
    hinges: Any,
    cores: Cores,
    heights: Mapping[str, float],
    kinds: Mapping[str, str],
    links: Any,
    parameters: "HingeParameters",
) -> Layout:
    """`Layout` of hinges without segments and cut-back cores.

    ``hinges``: {name: Hinge}; ``cores``: {plate: (corners, tags)}; ``heights``: {plate: mm};
    ``kinds``: {plate: kind of panel}; ``links``: names of the double hinges' links. ValueError
    where a hinge has no room.
    """
    hinges = dict(hinges)
    starts = relief(hinges, parameters)
    notes: list[Any] = []
    for name, hinge in hinges.items():
        span = free_span(hinge, cores, starts[name], parameters)
        hinges[name] = segmented(hinge, span, parameters, notes)
    made = {name: make_link(name, hinges, cores, parameters, notes) for name in links}
    for link in made.values():
        hinges |= {hinge.name: hinge for hinge in link.hinges}
    plates = {}
    for name, (corners, _) in cores.items():
        own = [h for h in hinges.values() if name in h.bodies]
        ring = plate_ring(name, corners, own, parameters)
        plates[name] = Plate(name, heights[name], tuple(corners), ring, kinds[name])
    return Layout(plates, made, hinges, tuple(dict.fromkeys(notes)))


def tab_points(tab: Tab, depth: float) -> list:
    """The four corners of a tab, counter-clockwise round the plate."""
    ends = (0, 1) if tab.forward else (1, 0)
    a, b = ends
    return [tab.corner(a), tab.corner(a, depth), tab.corner(b, depth), tab.corner(b)]


def relief(hinges: Mapping[str, Hinge], parameters: "HingeParameters") -> dict[str, list[float]]:
    """Start of each hinge at both its ends (mm from the end), clear of the barrels it meets.

    docs/theory/hinges.md 2: two axes whose heights differ by Δ keep √((D + c)² − Δ²) in plan.
    """
    reach = 2 * parameters.radius + parameters.gap_length
    ends: dict[Any, Any] = {}
    for hinge in hinges.values():
        for end, sign in ((0, 1), (1, -1)):
            arm = (hinge, end, hinge.point(hinge.stretch[end]), sign * hinge.direction)
            ends.setdefault(hinge.corners[end], []).append(arm)
    starts = {name: [0.0, 0.0] for name in hinges}
    for meeting in ends.values():
        for i, (first, end_i, p, u) in enumerate(meeting):
            for second, end_j, q, v in meeting[:i]:
                apart = abs(first.height - second.height)
                if apart > 1.5 * parameters.pitch or apart >= reach:
                    continue
                s = polygons.free_start(p, u, q, v, sqrt(reach**2 - apart**2))
                starts[first.name][end_i] = max(starts[first.name][end_i], s)
                starts[second.name][end_j] = max(starts[second.name][end_j], s)
    return starts


def free_span(
    hinge: Hinge, cores: Cores, starts: Sequence[float], parameters: "HingeParameters"
) -> tuple:
    """Part of the axis (mm from its origin) with relief at both ends and a core on both sides."""
    low, high = hinge.stretch[0] + starts[0], hinge.stretch[1] - starts[1]
    # Two beams of flexible strips meet at a core's corner: keep them apart there.
    margin = 2.5 * parameters.gap_length if not parameters.has_knuckles else CORNER
    for body in hinge.bodies:
        if body not in cores:
            continue
        corners, tags = cores[body]
        feet = []
        for i, tag in enumerate(tags):
            if tag == hinge.name:
                feet += [corners[i], corners[(i + 1) % len(corners)]]
        along = [polygons.dot(p - hinge.origin, hinge.direction) for p in feet]
        low, high = max(low, min(along) + margin), min(high, max(along) - margin)
    return low, high


def segmented(
    hinge: Hinge, span: Sequence[float], parameters: "HingeParameters", notes: list[Any]
) -> "Hinge":
    """The hinge with as many knuckles as fit ``span``, or one strip if it is flexible.

    ``notes`` takes a sentence where that is fewer than Segmentations; ValueError below three.
    """
    length = span[1] - span[0]
    if not parameters.has_knuckles:
        need = 6 * parameters.strip_thickness
        needed = phrase("a strip with fingers needs {need:.3g} mm", need=need)
        _check_room(hinge, length, need, needed)
        return replace(hinge, segments=(span,))
    least, gap = parameters.shortest_segment, parameters.gap_length
    need = MINIMUM_SEGMENTS * (least + gap) - gap
    _check_room(hinge, length, need, phrase("three segments need {need:.3g} mm", need=need))
    lengths = segment_lengths(length, parameters)
    if not parameters.segment_width and len(lengths) < parameters.segmentations:
        kind = hinge.name.replace("_left", "").replace("_right", "")
        notes.append(
            phrase(
                "Hinge {hinge} has room for {count} segments instead of {wanted}.",
                hinge=kind,
                count=len(lengths),
                wanted=parameters.segmentations,
            )
        )
    return with_segments(hinge, span[0], lengths, parameters)


def _check_room(hinge: Hinge, length: float, need: float, needed: "Phrase") -> None:
    if length >= need:
        return
    whole = hinge.stretch[1] - hinge.stretch[0]
    what = phrase(
        "Hinge {hinge}: {left} left between its vertices and {needed}",
        hinge=hinge.name,
        left=phrase("only {length:.3g} mm are" if length > 0 else "no length is", length=length),
        needed=needed,
    )
    raise TooSmall(what, hinge, 1.05 * (whole + need - length) / whole)


def with_segments(
    hinge: Hinge, start: float, lengths: Sequence[float], parameters: "HingeParameters"
) -> Hinge:
    """The hinge with knuckles of these lengths from ``start`` (mm along the axis), ga apart."""
    segments = []
    for length in lengths:
        segments.append((start, start + length))
        start += length + parameters.gap_length
    height = cone_height_for(min(lengths), parameters)
    return replace(hinge, segments=tuple(segments), cone_height=height)


def make_link(
    name: str,
    hinges: Mapping[str, Hinge],
    cores: Cores,
    parameters: "HingeParameters",
    notes: list[Any],
) -> "Link":
    """Link of a double hinge: both axes get the same segments, laid out on their mean line."""
    pair = sorted((h for h in hinges.values() if name in h.bodies), key=lambda h: h.height)
    origin = (pair[0].origin + pair[1].origin) / 2
    direction = polygons.unit(pair[0].direction + pair[1].direction)
    # Along the mean line: offset + slope * (along the hinge's own axis).
    offsets = [polygons.dot(h.origin - origin, direction) for h in pair]
    slopes = [polygons.dot(h.direction, direction) for h in pair]
    spans = [
        [o + k * s for s in (h.segments[0][0], h.segments[-1][1])]
        for h, o, k in zip(pair, offsets, slopes, strict=True)
    ]
    common = max(low for low, _ in spans), min(high for _, high in spans)
    mean = segmented(
        replace(pair[0], origin=origin, direction=direction), common, parameters, notes
    )
    matched = []
    for hinge, offset, slope in zip(pair, offsets, slopes, strict=True):
        segments = tuple(tuple((s - offset) / slope for s in ends) for ends in mean.segments)
        matched.append(replace(hinge, segments=segments, cone_height=mean.cone_height))
    panel = cores[pair[0].bodies[0]][0]
    outward = 1j * direction
    if polygons.dot(sum(panel) / len(panel) - origin, outward) > 0:
        outward = -outward
    return Link(name, tuple(matched), outward)


def inward_of(hinge: Hinge, core: Sequence[complex]) -> complex:
    """Unit vector across the axis of a hinge towards a core."""
    inward = 1j * hinge.direction
    return -inward if polygons.dot(sum(core) / len(core) - hinge.origin, inward) < 0 else inward


def plate_ring(
    name: str, core: Sequence[complex], hinges: Sequence[Hinge], parameters: "HingeParameters"
) -> tuple:
    """Core corners and a tab for each of a plate's knuckles on ``hinges`` (those that name it)."""
    placed = []
    for hinge in hinges:
        if not parameters.has_knuckles:
            continue
        inward = inward_of(hinge, core)
        parity = hinge.bodies.index(name)
        for index in range(parity, len(hinge.segments), 2):
            placed.append(_tab(hinge, index, inward, core))
    placed.sort(key=lambda entry: entry[0])
    ring: list[complex | Tab] = []
    for i, corner in enumerate(core):
        inside = any(corner in tab.between for _, tab in placed)
        if not inside:
            ring.append(corner)
        ring += [tab for at, tab in placed if i <= at < i + 1]
    return tuple(ring)


def _tab(hinge: Hinge, index: int, inward: complex, core: Sequence[complex]) -> tuple[float, Tab]:
    """(position round the core, `Tab`) of one knuckle."""
    hits = [polygons.entry(core, hinge.point(s), inward) for s in hinge.segments[index]]
    forward = polygons.dot(hinge.direction, -1j * inward) > 0
    first, last = hits if forward else hits[::-1]
    n = len(core)
    steps = (last[1] - first[1]) % n
    between = tuple(core[(first[1] + k) % n] for k in range(1, steps + 1))
    tab = Tab(hinge, index, inward, (hits[0][0], hits[1][0]), between, forward)
    return first[1] + min(max(first[2], 0.0), 1 - 1e-12), tab
