# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hinges, tabs, plates and links in plan: vertex relief, spans, segments, cut-back outlines.

``hinges.md`` 2. Plan points are complex numbers x + i z (mm); heights (mm) are measured along the
stack. A panel is a convex *core*, cut back by barrel radius + clearance from every hinge axis along
its edges, and one *tab* for each of its own knuckles, which runs from the core to the axis. So
panels clear all barrels by construction, and no boolean is ever needed.
"""

from dataclasses import dataclass, replace
from math import sqrt

from . import plan
from .hinge_parameters import FLEXIBLE, MINIMUM_SEGMENTS, cone_height_for, segments_for

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

    def point(self, along):
        """Plan point of the axis at ``along`` mm from its origin."""
        return self.origin + along * self.direction


@dataclass(frozen=True)
class Tab:
    """The part of a panel that carries one knuckle: segment ``index`` of ``hinge``.

    ``inward``: unit vector from the axis into the panel; ``depths``: distance from the axis to the
    core at the segment's start and end (mm); ``between``: core corners inside the tab's base, in
    counter-clockwise order; ``forward``: whether the axis runs counter-clockwise round the core.
    """

    hinge: Hinge
    index: int
    inward: complex
    depths: tuple
    between: tuple
    forward: bool

    def corner(self, end, depth=None):
        """Plan point at the segment's start (0) or end (1), ``depth`` mm from the axis."""
        depth = self.depths[end] if depth is None else depth
        return self.hinge.point(self.hinge.segments[self.index][end]) + depth * self.inward


@dataclass(frozen=True)
class Plate:
    """One panel: ``core`` corners, and ``ring``: core corners and `Tab`s, counter-clockwise.

    ``height``: of the mid-plane (mm from the unit's middle).
    """

    name: str
    height: float
    core: tuple
    ring: tuple

    @property
    def tabs(self):
        """The plate's tabs, one a knuckle."""
        return [item for item in self.ring if isinstance(item, Tab)]

    def outline(self, tip):
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
    """A double hinge's link: its two hinges, lower first, and the way out from the panels."""

    name: str
    hinges: tuple
    outward: complex


class TooSmall(ValueError):
    """A panel or hinge has no room.

    ``what`` is wrong, at which ``hinge``, and the ``factor`` by which its length must grow.
    """

    def __init__(self, what, hinge, factor, edge_length=None):
        self.what, self.hinge = what, hinge
        size = size_property(hinge, factor, edge_length)
        super().__init__(f"{what}; set {size}, or make FaceThickness or GapLength smaller.")


@dataclass(frozen=True)
class Layout:
    """Plates, links and hinges by name, and what was changed to fit (``notes``)."""

    plates: dict
    links: dict
    hinges: dict
    notes: tuple


def finish(hinges, cores, heights, links, parameters):
    """`Layout` of hinges without segments and cut-back cores.

    ``hinges``: {name: Hinge}; ``cores``: {plate: (corners, tags)}; ``heights``: {plate: mm};
    ``links``: names of the double hinges' links. ValueError where a hinge has no room.
    """
    hinges = dict(hinges)
    starts = relief(hinges, parameters)
    notes = []
    for name, hinge in hinges.items():
        span = free_span(hinge, cores, starts[name], parameters)
        hinges[name] = segmented(hinge, span, parameters, notes)
    made = {name: make_link(name, hinges, cores, parameters, notes) for name in links}
    for link in made.values():
        hinges |= {hinge.name: hinge for hinge in link.hinges}
    plates = {}
    for name, (corners, _) in cores.items():
        own = [h for h in hinges.values() if name in h.bodies]
        plates[name] = make_plate(name, heights[name], corners, own, parameters)
    return Layout(plates, made, hinges, tuple(dict.fromkeys(notes)))


def tab_points(tab, depth):
    """The four corners of a tab, counter-clockwise round the plate."""
    ends = (0, 1) if tab.forward else (1, 0)
    a, b = ends
    return [tab.corner(a), tab.corner(a, depth), tab.corner(b, depth), tab.corner(b)]


def relief(hinges, parameters):
    """Start of each hinge at both its ends (mm from the end), clear of the barrels it meets.

    ``hinges.md`` 2: two axes whose heights differ by Δ keep √((D + c)² − Δ²) in plan.
    """
    reach = 2 * parameters.radius + parameters.gap_length
    ends = {}
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
                s = plan.free_start(p, u, q, v, sqrt(reach**2 - apart**2))
                starts[first.name][end_i] = max(starts[first.name][end_i], s)
                starts[second.name][end_j] = max(starts[second.name][end_j], s)
    return starts


def free_span(hinge, cores, starts, parameters):
    """Part of the axis (mm from its origin) with relief at both ends and a core on both sides."""
    low, high = hinge.stretch[0] + starts[0], hinge.stretch[1] - starts[1]
    # Two beams of flexible strips meet at a core's corner: keep them apart there.
    margin = 2.5 * parameters.gap_length if parameters.hinge_type == FLEXIBLE else CORNER
    for body in hinge.bodies:
        if body not in cores:
            continue
        corners, tags = cores[body]
        feet = []
        for i, tag in enumerate(tags):
            if tag == hinge.name:
                feet += [corners[i], corners[(i + 1) % len(corners)]]
        along = [plan.dot(p - hinge.origin, hinge.direction) for p in feet]
        low, high = max(low, min(along) + margin), min(high, max(along) - margin)
    return low, high


def segmented(hinge, span, parameters, notes):
    """The hinge with as many knuckles as fit ``span``, or one strip if it is flexible.

    ``notes`` takes a sentence where that is fewer than Segmentations; ValueError below three.
    """
    length = span[1] - span[0]
    if parameters.hinge_type == FLEXIBLE:
        _check_room(
            hinge, length, 6 * parameters.strip_thickness, "a strip with fingers needs {:.3g} mm"
        )
        return replace(hinge, segments=(span,))
    least, gap = parameters.shortest_segment, parameters.gap_length
    need = MINIMUM_SEGMENTS * (least + gap) - gap
    _check_room(hinge, length, need, "three segments need {:.3g} mm")
    count = segments_for(length, parameters)
    if count < parameters.segmentations:
        kind = hinge.name.replace("_left", "").replace("_right", "")
        notes.append(
            f"Hinge {kind} has room for {count} segments instead of {parameters.segmentations}."
        )
    return make_segments(hinge, span, count, parameters)


def _check_room(hinge, length, need, what):
    if length >= need:
        return
    whole = hinge.stretch[1] - hinge.stretch[0]
    left = f"only {length:.3g} mm are" if length > 0 else "no length is"
    raise TooSmall(
        f"Hinge {hinge.name}: {left} left between its vertices and {what.format(need)}", hinge,
        1.05 * (whole + need - length) / whole,
    )  # fmt: skip


def size_property(hinge, factor, edge_length=None):
    """The property, with a value, that makes a hinge of a unit ``factor`` times longer."""
    if hinge.name.startswith("leg"):
        return f"the strip height h (HeightRatio) so that h is {hinge.stretch[1] * factor:.3g} mm"
    if hinge.name.startswith("crease"):
        return f"LengthX and LengthY {factor:.2f} times larger"
    if edge_length:
        return f"EdgeLength ‖AB‖ to {factor * edge_length:.3g} mm"
    return f"EdgeLength ‖AB‖ {factor:.2f} times larger"


def make_segments(hinge, span, count, parameters):
    """The hinge with ``count`` equal knuckles on ``span`` (mm along the axis), ga apart."""
    gap = parameters.gap_length
    each = (span[1] - span[0] - (count - 1) * gap) / count
    starts = [span[0] + k * (each + gap) for k in range(count)]
    segments = tuple((s, s + each) for s in starts)
    return replace(hinge, segments=segments, cone_height=cone_height_for(each, parameters))


def make_link(name, hinges, cores, parameters, notes):
    """Link of a double hinge: both axes get the same segments, laid out on their mean line."""
    pair = sorted((h for h in hinges.values() if name in h.bodies), key=lambda h: h.height)
    origin = (pair[0].origin + pair[1].origin) / 2
    direction = plan.unit(pair[0].direction + pair[1].direction)
    # Along the mean line: offset + slope * (along the hinge's own axis).
    offsets = [plan.dot(h.origin - origin, direction) for h in pair]
    slopes = [plan.dot(h.direction, direction) for h in pair]
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
    if plan.dot(sum(panel) / len(panel) - origin, outward) > 0:
        outward = -outward
    return Link(name, tuple(matched), outward)


def inward_of(hinge, core):
    """Unit vector across the axis of a hinge towards a core."""
    inward = 1j * hinge.direction
    return -inward if plan.dot(sum(core) / len(core) - hinge.origin, inward) < 0 else inward


def make_plate(name, height, core, hinges, parameters):
    """Plate with one tab for each of its knuckles on ``hinges`` (those that name it)."""
    placed = []
    for hinge in hinges:
        if parameters.hinge_type == FLEXIBLE:
            continue
        inward = inward_of(hinge, core)
        parity = hinge.bodies.index(name)
        for index in range(parity, len(hinge.segments), 2):
            placed.append(_tab(hinge, index, inward, core))
    placed.sort(key=lambda entry: entry[0])
    ring = []
    for i, corner in enumerate(core):
        inside = any(corner in tab.between for _, tab in placed)
        if not inside:
            ring.append(corner)
        ring += [tab for at, tab in placed if i <= at < i + 1]
    return Plate(name, height, tuple(core), tuple(ring))


def _tab(hinge, index, inward, core):
    """(position round the core, `Tab`) of one knuckle."""
    hits = [plan.entry(core, hinge.point(s), inward) for s in hinge.segments[index]]
    forward = plan.dot(hinge.direction, -1j * inward) > 0
    first, last = hits if forward else hits[::-1]
    n = len(core)
    steps = (last[1] - first[1]) % n
    between = tuple(core[(first[1] + k) % n] for k in range(1, steps + 1))
    tab = Tab(hinge, index, inward, (hits[0][0], hits[1][0]), between, forward)
    return first[1] + min(max(first[2], 0.0), 1 - 1e-12), tab


@dataclass(frozen=True)
class LinkSection:
    """Sizes (mm) of a link's section, from each of its two axes, outwards (away from the panels).

    ``web``: half-width of the web on the panels' side; ``clear``: barrel radius + clearance;
    ``inner``, ``outer``: the spine that joins the dogbones runs between them, outside ``clear``.
    """

    web: float
    clear: float
    inner: float
    outer: float


def link_section(parameters):
    """Section of every link.

    Narrow enough on the panels' side to keep the clearance from barrels at height 0, and with a
    spine that no knuckle of the panels can reach.
    """
    r, p, clear = parameters.radius, parameters.pitch, parameters.cut_back
    beside = sqrt(max((2 * r + parameters.gap_length) ** 2 - p * p, 0.0)) - clear
    narrow = max(p - parameters.nozzle_diameter, 0.0)
    inner = max(sqrt(max(clear**2 - narrow**2, 0.0)), r / 2)
    outer = clear + 2 * parameters.nozzle_diameter
    return LinkSection(min(0.6 * r, max(beside, 0.0)), clear, inner, outer)
