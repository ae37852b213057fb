# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tube of thick panels cut from sheets: outlines between hinge axes, hinges, screw holes.

Panels are those of theory/hinges.md 1, thickness compensation included: every edge is a hinge axis,
or lies ``edge_gap`` inside it. A piece is seen from the face that carries most of its hinges, so
that it can be drilled as it lies on the sheet.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import ceil, tan
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from ..hinges import polygons
from ..hinges.layout import axes_of
from ..units.creases import CREASES, LAYER_HEIGHT_IN_PITCHES, LINKS, PANELS, kind_of, layer_of

if TYPE_CHECKING:
    from ..hinges.unit_layout import Hinge
    from ..thick.linkage import ThickUnit
    from .panel_hinges import PanelHinge

END_SCREW = 20.0  # mm from a hinge's end to its first screw
_BETWEEN = 2.0  # mm between two hinges in line
_CODES = {"contact": "C", "border": "B", "primary": "P", "secondary": "S", "link": "L"}


@dataclass(frozen=True)
class Piece:
    """One piece to cut: ``unit`` (from 0), ``name`` as of `creases.BODIES`, what it is called.

    ``outline``: corners x + i y (mm), anticlockwise, seen from its face; ``edges``: the crease of
    the edge that starts at each corner; ``holes``: (place, whether on the face that is seen).
    ``is_mirrored``: seen from above in the flat unit, whose plan x + i z is seen from below.
    """

    unit: int
    name: str
    label: str
    outline: tuple
    edges: tuple
    holes: tuple = ()
    is_mirrored: bool = False

    @property
    def kind(self) -> str:
        """Kind of panel, or "link" for the slat of a double hinge."""
        return kind_of(self.name)

    @property
    def area(self) -> float:
        """mm²."""
        return polygons.area(self.outline)

    def edge_length(self, crease: str) -> float:
        """Length (mm) of the edge along a crease."""
        k = self.edges.index(crease)
        return abs(self.outline[(k + 1) % len(self.outline)] - self.outline[k])


@dataclass(frozen=True)
class CutHinge:
    """One hinge to cut to ``length`` (mm), with its ``screws`` on each of its two leaves.

    ``strip`` (mm): width of the strip that stands for a double hinge's link; 0: there is none.
    """

    unit: int
    crease: str
    length: float
    screws: int = 0
    strip: float = 0.0


def pieces_of(
    thick: "ThickUnit", hinge: "PanelHinge", edge_gap: float = 0.0
) -> tuple[list[Piece], list[CutHinge]]:
    """`Piece` and `CutHinge` lists of a tube of ``thick`` units, whose gap is the hinge's.

    `Refusal` where a panel is too small for its hinges.
    """
    pieces: list[Piece] = []
    hinges: list[CutHinge] = []
    axes = np.asarray(thick.axes).reshape(-1, *np.shape(thick.axes)[-3:])
    for k, one in enumerate(axes):
        lines = axes_of(one, thick.pitch)
        spans = {name: _span(line, lines, hinge, k) for name, line in lines.items()}
        screws = {name: _screws(span, hinge) for name, span in spans.items()}
        for name in PANELS:
            pieces.append(_panel(k, name, lines, screws, hinge, edge_gap, thick.pitch))
        made, cut = _links(k, one, lines, spans, screws, hinge, edge_gap)
        pieces += made
        hinges += cut
    return pieces, hinges


def _label(unit: int, name: str) -> str:
    words = name.split("_")
    return f"{unit + 1}-{_CODES[kind_of(name)]}{''.join(word[0].upper() for word in words[1:])}"


def _span(
    line: "Hinge", lines: "Mapping[str, Hinge]", hinge: "PanelHinge", unit: int
) -> tuple[float, float]:
    """Part of an axis (mm from its origin) that a hinge takes, clear of the leaves it meets."""
    ends = list(line.stretch)
    for end, sense in ((0, 1), (1, -1)):
        room = _BETWEEN / 2
        for other in lines.values():
            if other is line or other.height != line.height:
                continue
            if line.corners[end] not in other.corners or not set(line.bodies) & set(other.bodies):
                continue
            away = 1 if other.corners[0] == line.corners[end] else -1
            turn = (away * other.direction) / (sense * line.direction)
            angle = abs(np.angle(turn))
            room = max(room, hinge.leaf / tan(angle / 2))
        ends[end] += sense * room
    if ends[1] - ends[0] < max(2 * END_SCREW, hinge.leaf):
        whole, need = line.stretch[1] - line.stretch[0], max(2 * END_SCREW, hinge.leaf)
        factor = (whole + need - (ends[1] - ends[0])) / whole
        raise Refusal(
            "Unit {unit}: hinge {hinge} is {whole:.0f} mm long, too short for leaves that reach "
            "{leaf:g} mm onto the panels: make {EdgeLength} {factor:.1f} times longer, or take "
            "another hinge.",
            parameter="EdgeLength", unit=unit + 1, hinge=line.name, whole=whole, leaf=hinge.leaf,
            factor=factor,
        )  # fmt: skip
    return ends[0], ends[1]


def _screws(span: tuple[float, float], hinge: "PanelHinge") -> NDArray:
    """Places (mm along the axis) of the screws of one leaf."""
    if not hinge.screw_pitch:
        return np.empty(0)
    low, high = span[0] + END_SCREW, span[1] - END_SCREW
    return np.linspace(low, high, max(2, ceil((high - low) / hinge.screw_pitch) + 1))


def _panel(
    unit: int,
    name: str,
    lines: "Mapping[str, Hinge]",
    screws: Mapping[str, NDArray],
    hinge: "PanelHinge",
    edge_gap: float,
    pitch: float,
) -> Piece:
    own = [line for line in lines.values() if name in line.bodies]
    ends = [line.point(s) for line in own for s in (0.0, line.stretch[1])]
    middle = sum(ends) / len(ends)
    inward = {line.name: _towards(middle, line) for line in own}
    bounds = [
        (line.origin + edge_gap * inward[line.name], inward[line.name], line.name) for line in own
    ]
    span = max(abs(p - middle) for p in ends)
    corners, tags = polygons.half_planes(bounds, ends, span)
    if not corners or set(tags) != {line.name for line in own}:
        raise Refusal(
            "Unit {unit}: nothing is left of panel {panel} {gap:.3g} mm inside its hinge axes: "
            "make {EdgeLength} longer, or the gap at the edges smaller.",
            parameter="EdgeLength", unit=unit + 1, panel=name, gap=edge_gap,
        )  # fmt: skip
    height = LAYER_HEIGHT_IN_PITCHES[layer_of(name)] * pitch
    layer = layer_of(name)
    from_above = layer in (1, 3)  # most hinges of these are on the upper face
    holes = []
    for line in own:
        above = line.height > height
        for s in screws[line.name]:
            place = line.point(float(s)) + hinge.screw_inset * inward[line.name]
            holes.append((place, above == from_above))
    piece = Piece(unit, name, _label(unit, name), tuple(corners), tuple(tags), tuple(holes))
    return _mirrored(piece) if from_above else piece


def _towards(middle: complex, line: "Hinge") -> complex:
    normal = 1j * line.direction
    return normal if polygons.dot(middle - line.origin, normal) > 0 else -normal


def _mirrored(piece: Piece) -> Piece:
    """The piece as it is seen from its other side."""
    n = len(piece.outline)
    outline = tuple(p.conjugate() for p in piece.outline[::-1])
    edges = tuple(piece.edges[(n - 2 - k) % n] for k in range(n))
    holes = tuple((p.conjugate(), side) for p, side in piece.holes)
    return replace(piece, outline=outline, edges=edges, holes=holes, is_mirrored=True)


def _links(
    unit: int,
    axes: NDArray,
    lines: "Mapping[str, Hinge]",
    spans: Mapping[str, tuple[float, float]],
    screws: Mapping[str, NDArray],
    hinge: "PanelHinge",
    edge_gap: float,
) -> tuple[list[Piece], list[CutHinge]]:
    """Slats of the double hinges, or none; and all hinges of a unit."""
    slats, cut = [], []
    double = {crease.name: crease for crease in CREASES if crease.double}
    for name in LINKS:
        pair = [crease for crease in double if name in double[crease].bodies]
        ends = [_axis_ends(axes, crease, spans[crease]) for crease in pair]
        width = _widths(*ends)
        length = float(np.mean([np.linalg.norm(b - a) for a, b in ends]))
        if hinge.has_slats:
            slats.append(_slat(unit, name, pair, length, width, edge_gap, hinge))
        else:
            cut.append(CutHinge(unit, name, length, 0, max(width) + 2 * hinge.leaf))
    for name in lines:
        if name in double and not hinge.has_slats:
            continue
        cut.append(CutHinge(unit, name, spans[name][1] - spans[name][0], len(screws[name])))
    return slats, cut


def _axis_ends(axes: NDArray, crease: str, span: Sequence[float]) -> tuple[NDArray, NDArray]:
    """Points (3,) of an axis where its hinge begins and ends."""
    index = next(k for k, entry in enumerate(CREASES) if entry.name == crease)
    start, end = axes[index]
    along = (end - start) / np.linalg.norm(end - start)
    return start + span[0] * along, start + span[1] * along


def _widths(one: tuple[NDArray, NDArray], other: tuple[NDArray, NDArray]) -> tuple[float, float]:
    """Distances (mm) of one axis' two ends from the other axis."""
    along = (other[1] - other[0]) / np.linalg.norm(other[1] - other[0])
    first, last = (np.linalg.norm(np.cross(p - other[0], along)) for p in one)
    return float(first), float(last)


def _slat(
    unit: int,
    name: str,
    pair: Sequence[str],
    length: float,
    width: tuple[float, float],
    edge_gap: float,
    hinge: "PanelHinge",
) -> Piece:
    low, (first, last) = edge_gap, width
    outline = (
        complex(0, low), complex(length, low),
        complex(length, last - edge_gap), complex(0, first - edge_gap),
    )  # fmt: skip
    holes = []
    for s in _screws((0.0, length), hinge):
        inset = min(hinge.screw_inset, 0.25 * min(width))
        holes += [(complex(s, inset), True), (complex(s, float(np.interp(
            s, (0, length), width)) - inset), True)]  # fmt: skip
    edges = (pair[0], "", pair[1], "")
    return Piece(unit, name, _label(unit, name), outline, edges, tuple(holes))
