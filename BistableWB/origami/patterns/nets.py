# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets: the panels of one unit unfolded into the plane, to be cut, scored and glued.

Seen from outside; plane points are complex numbers (mm). Every panel is the one of the flat state,
moved without stretching. Panels are joined along creases, one after the other, wherever nothing
comes to lie on anything else; a unit falls into more than one net only where that cannot be had, or
where the net would not fit a sheet. A crease that is not inside a net is a *seam*: its two edges
bear the same number and are glued together.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from ..units.creases import INDEX, VERTICES, layer_of
from ..units.tube import single
from .surface import EDGES, OUTWARD, surface_of

if TYPE_CHECKING:
    from ..units.closed_forms import Unit

# Two polygons that reach less than this (mm) into each other do not overlap.
SLACK = 1e-6
MOUNTAIN, VALLEY = "mountain", "valley"

# Creases by the letters of their ends, in the order in which panels are joined. The first gives a
# strip with two fans at either end: symmetric, and the borders stay free. The others are for
# oblique units on which that overlaps.
_ORDERS = (
    ("AA", "CC", "AB", "AP", "AC", "PC", "PB", "BB"),
    ("AA", "AB", "AP", "AC", "CC", "PC", "PB", "BB"),
    ("AA", "CC", "AC", "AP", "AB", "PC", "PB", "BB"),
)


@dataclass(frozen=True)
class Seam:
    """One edge of a net that is glued to another of the same ``number`` (of the same unit).

    ``start`` and ``end``: along the outline, the net on the left; ``panel`` it belongs to,
    ``fold``: "mountain" or "valley", also of the ``tab`` (4 corners, or None).
    """

    number: int
    start: complex
    end: complex
    panel: str
    fold: str
    tab: tuple | None = None


@dataclass(frozen=True)
class Net:
    """Panels of one unit in one piece.

    ``polygons``: {panel: corners (m,), anticlockwise}; ``folds``: [(start, end, "mountain" or
    "valley")]; ``outline``: corners of the cut, anticlockwise, tabs included; ``seams``.
    """

    polygons: dict
    folds: tuple
    outline: np.ndarray
    seams: tuple

    def moved(self, turn: complex, shift: complex) -> "Net":
        """The net turned by a complex number of length 1, then shifted."""

        def move(z: Any) -> Any:
            return z * turn + shift

        seams = tuple(
            Seam(s.number, move(s.start), move(s.end), s.panel, s.fold,
                 s.tab and tuple(map(move, s.tab)))
            for s in self.seams
        )  # fmt: skip
        polygons = {name: move(p) for name, p in self.polygons.items()}
        folds = tuple((move(a), move(b), fold) for a, b, fold in self.folds)
        return Net(polygons, folds, move(self.outline), seams)

    @property
    def shapes(self) -> list:
        """All polygons that need paper: panels and tabs."""
        return [*self.polygons.values(), *(np.array(s.tab) for s in self.seams if s.tab)]


def unit_nets(
    unit: "Unit", fits: Callable[..., Any] = lambda points: True, tab_depth: float = 0.0
) -> list:
    """Nets of one `unit.Unit` (a list, mostly of one).

    ``fits(points)`` says whether a net with these corners may be made; ``tab_depth`` (mm) of the
    glue tabs, 0: none. ValueError where a single panel does not fit.
    """
    shapes = unfolded(unit)
    for name, polygon in shapes.items():
        if not fits(polygon):
            raise Refusal(
                "Panel {body} is too large for the sheet: choose a larger sheet.",
                body=name,
            )
    best: Any = None
    for order in _ORDERS:
        found = _joined(shapes, order, fits)
        if best is None or len(found) < len(best):
            best = found
        if len(best) == 1:
            break
    folds = _fold_kinds(unit)
    return _with_seams(best, folds, tab_depth, fits)


def unfolded(unit: "Unit") -> dict:
    """{panel: corners (m,)}, anticlockwise as seen from outside, each where it lies when flat."""
    flat = unit.flat.reshape(-1, 3)
    shapes = {}
    for name, loop in OUTWARD.items():
        x, _, z = flat[[INDEX[v] for v in loop]].T
        shapes[name] = (-x if layer_of(name) in (2, 4) else x) + 1j * z
    return shapes


def overlap(first: NDArray, second: NDArray, slack: float = SLACK) -> bool:
    """Whether two convex polygons, complex corners in order, have a common inside."""
    for polygon in (first, second):
        normals = 1j * (np.roll(polygon, -1) - polygon)
        normals /= np.abs(normals)
        a = (first[None] * normals.conj()[:, None]).real
        b = (second[None] * normals.conj()[:, None]).real
        apart = np.maximum(a.min(1) - b.max(1), b.min(1) - a.max(1))
        if apart.max() >= -slack:
            return False
    return True


def _kind(edge: Sequence[str]) -> str:
    """Letters of an edge's ends, such as "AP"."""
    letters = "".join(sorted(v[0] for v in edge))
    return {"BP": "PB", "CP": "PC"}.get(letters, letters)


def _fold_kinds(unit: "Unit") -> dict[tuple[str, str], str]:
    """{edge: "mountain" or "valley"} of a unit, from its deployed state."""
    tube = single(unit)
    surface = surface_of(tube)
    deployed = surface.points(tube.deployed())
    kinds = {}
    for (i, j), angle in zip(surface.edges, surface.fold_angles(deployed, deployed), strict=True):
        ends = VERTICES[i], VERTICES[j]
        kinds[ends if ends in EDGES else ends[::-1]] = VALLEY if angle > 0 else MOUNTAIN
    return kinds


def _corner(shapes: Mapping[str, NDArray], panel: str, vertex: str) -> complex:
    return shapes[panel][OUTWARD[panel].index(vertex)]


def _joined(
    shapes: Mapping[str, NDArray], order: Sequence[str], fits: Callable[..., Any]
) -> list[tuple[dict[str, NDArray], set[tuple[Any, ...]]]]:
    """Pieces [({panel: polygon}, {crease})]: panels joined along creases without overlap."""
    pieces: list[Any] = [({name: polygon}, set()) for name, polygon in shapes.items()]
    for edge in sorted(EDGES, key=lambda e: order.index(_kind(e))):
        (a, b), (left, right) = edge, EDGES[edge]
        one = next(p for p in pieces if left in p[0])
        other = next(p for p in pieces if right in p[0])
        if one is other:
            continue
        here, there = _corner(one[0], left, a), _corner(other[0], right, a)
        turn = (_corner(one[0], left, b) - here) / (_corner(other[0], right, b) - there)
        turn /= abs(turn)
        moved = {name: here + (p - there) * turn for name, p in other[0].items()}
        if any(overlap(p, q) for p in one[0].values() for q in moved.values()):
            continue
        if not fits(np.concatenate([*one[0].values(), *moved.values()])):
            continue
        pieces.remove(other)
        one[0].update(moved)
        one[1].update(other[1], {edge})
    return pieces


def _with_seams(
    pieces: Sequence[tuple[dict[str, NDArray], set[Any]]],
    kinds: Mapping[tuple[str, str], str],
    tab_depth: float,
    fits: Callable[..., Any],
) -> list[Net]:
    """`Net` list of pieces: folds, numbered seams, tabs and outlines."""
    inside = set().union(*(creases for _, creases in pieces))
    numbers = {edge: i + 1 for i, edge in enumerate(e for e in EDGES if e not in inside)}
    tabs = _tabs(pieces, numbers, tab_depth, fits) if tab_depth > 0 else {}
    nets = []
    for polygons, creases in pieces:
        outline: Any
        seams, outline = [], []
        for panel, a, b in _boundary(polygons, creases):
            edge = (a, b) if (a, b) in EDGES else (b, a)
            start, end = _corner(polygons, panel, a), _corner(polygons, panel, b)
            tab = tabs.get((panel, edge))
            seams.append(Seam(numbers[edge], start, end, panel, kinds[edge], tab))
            outline += tab[:3] if tab else [start]
        folds = tuple(
            (_corner(polygons, EDGES[e][0], e[0]), _corner(polygons, EDGES[e][0], e[1]), kinds[e])
            for e in EDGES
            if e in creases
        )
        nets.append(Net(polygons, folds, np.array(outline), tuple(seams)))
    return nets


def _boundary(
    polygons: Mapping[str, NDArray], creases: set[Sequence[str]]
) -> Iterator[tuple[str, ...]]:
    """Edges (panel, start, end) round a piece, anticlockwise.

    A piece is a tree of panels: the way round it turns into the neighbour at every crease.
    """
    root = next(iter(polygons))

    def around(panel: str, entry: Any) -> Iterator[tuple[str, ...]]:
        loop = OUTWARD[panel]
        first = loop.index(entry) if entry else 0
        for i in range(len(loop) - bool(entry)):
            a, b = loop[(first + i) % len(loop)], loop[(first + i + 1) % len(loop)]
            edge = (a, b) if (a, b) in EDGES else (b, a)
            if edge in creases:
                left, right = EDGES[edge]
                yield from around(right if panel == left else left, a)
            else:
                yield panel, a, b

    yield from around(root, None)


def _tabs(
    pieces: Sequence[tuple[Mapping[str, NDArray], set[Sequence[Any]]]],
    numbers: Mapping[tuple[str, str], int],
    depth: float,
    fits: Callable[..., Any],
) -> dict[tuple[str, tuple[str, str]], tuple[complex, ...]]:
    """{(panel, edge): 4 corners along the outline}: one tab a seam where there is room for it."""
    tabs: Any
    tabs, angles = {}, _inner_angles(pieces)
    for edge in numbers:
        found = None
        for share in (1.0, 0.7, 0.5, 0.3):
            for panel, mate in (EDGES[edge], EDGES[edge][::-1]):
                piece = next(p for p, _ in pieces if panel in p)
                tab = _tab(piece, panel, edge, share * depth, [angles[mate, v] for v in edge])
                others = [t for (name, _), t in tabs.items() if name in piece]
                taken = [*piece.values(), *(np.array(t) for t in others)]
                if tab is None or any(overlap(np.array(tab), q) for q in taken):
                    continue
                if fits(np.concatenate([*taken, tab])):
                    found = panel, tab
                    break
            if found:
                tabs[found[0], edge] = found[1]
                break
    return tabs


def _tab(
    piece: Mapping[str, NDArray],
    panel: str,
    edge: Sequence[str],
    depth: float,
    mate_angles: Sequence[float],
) -> tuple[complex, ...] | None:
    """Trapezoid on the outside of an edge, within the mirror image of the panel it is glued to."""
    loop = OUTWARD[panel]
    forward = loop[(loop.index(edge[0]) + 1) % len(loop)] == edge[1]
    (a, b), limits = (edge, mate_angles) if forward else (edge[::-1], mate_angles[::-1])
    start, end = _corner(piece, panel, a), _corner(piece, panel, b)
    length = abs(end - start)
    along = (end - start) / length
    slopes = [1 / np.tan(np.radians(min(60.0, 0.8 * limit))) for limit in limits]
    depth = min(depth, 0.7 * length / sum(slopes))
    if depth < 1.0:  # mm: nothing that glue could hold
        return None
    out = -1j * along * depth
    return (
        start,
        start + along * depth * slopes[0] + out,
        end - along * depth * slopes[1] + out,
        end,
    )


def _inner_angles(
    pieces: Sequence[tuple[Mapping[str, NDArray], set[Sequence[Any]]]],
) -> dict[tuple[str, str], float]:
    """{(panel, vertex): inner angle in degrees}."""
    found: dict[Any, Any] = {}
    for polygons, _ in pieces:
        for name, p in polygons.items():
            turns = np.angle((np.roll(p, 1) - p) / (np.roll(p, -1) - p)) % (2 * np.pi)
            found |= {(name, v): t for v, t in zip(OUTWARD[name], np.degrees(turns), strict=True)}
    return found
