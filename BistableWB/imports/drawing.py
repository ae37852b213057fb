# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a reader of files hands over, and what becomes of it: curves and a receipt."""

import math
from collections import Counter
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

import numpy as np

from ..origami.curves.joining import JOIN, chains, nearest_gap
from ..origami.errors import Phrase, Refusal, joined, phrase
from .lengths import measure
from .pieces import Arc, Array, Line, Piece, Spline
from .splines import through

SPECK = 1e-6  # mm: what is shorter is a slip of the mouse
MAX_POINTS = 5_000  # of a polygon that is read as a smooth curve
_GENTLE = 30.0  # degrees: a polygon that turns less at each corner is a curve told by its points
_FLAT = 1e-7  # of its size that a curve in a plane may be off it
_NEAR = 0.02  # of the longest curve: ends nearer than this may be meant to meet
_LARGEST = 1e15  # mm
_FAR = 1e6  # mm: a curve so far from the origin is brought there


@dataclass
class Stroke:
    """Pieces of a drawing that hang together in this order, in mm, and the layer they lie on."""

    pieces: list[Piece]
    layer: str = ""
    smooth: bool = False  # through points of a table: no polygon


@dataclass
class Read:
    """What a reader found in a file.

    ``unit``: of the file, as a word; ``source``: where it says so; ``left_out``: how many of what,
    and why; ``notes``: what a person should know of it.
    """

    strokes: list[Stroke]
    unit: str
    source: Phrase
    left_out: Counter = field(default_factory=Counter)
    notes: list[Phrase] = field(default_factory=list)


@dataclass
class FileCurve:
    """A curve of a file: ``pieces`` in path order, in mm, its ``layer``, and whether it closes."""

    pieces: list[Piece]
    layer: str = ""
    closed: bool = False
    gap: float = 0.0

    @cached_property
    def length(self) -> float:
        """Arc length in mm."""
        return math.fsum(piece.length for piece in self.pieces)

    @cached_property
    def kind(self) -> str:
        """What a Curve along it is: Plane where it lies in a plane, else General."""
        points = self.points()
        spread = np.linalg.svd(points - points.mean(0), compute_uv=False)
        return "Plane" if len(spread) < 3 or spread[2] <= _FLAT * spread[0] else "General"

    def points(self, per_piece: int = 16) -> Array:
        """Points (n, 3) along the curve: the ends of lines, ``per_piece`` of every other span."""
        if len(self.pieces) > 500:
            per_piece = 4
        found = [self.pieces[0].start[None]]
        for piece in self.pieces:
            if isinstance(piece, Line):
                found.append(piece.end[None])
                continue
            cuts = piece.bounds if len(piece.bounds) < 300 else np.array([0.0, 1.0])
            steps = np.arange(1, per_piece + 1) / per_piece
            t = (cuts[:-1, None] + np.diff(cuts)[:, None] * steps).ravel()
            found.append(piece.at(t))
        return np.concatenate(found)

    @cached_property
    def size(self) -> tuple[float, float, float]:
        """Extent along x, y and z in mm."""
        return tuple(np.ptp(self.points(64), axis=0).tolist())


def curves_of(read: Read, join: float = JOIN) -> tuple[list[FileCurve], list[Phrase]]:
    """The curves of what was read, the longest first, and what was done to them."""
    notes: list[Phrase] = []
    measure([piece for stroke in read.strokes for piece in stroke.pieces])
    strokes = [Stroke(_solid(s.pieces), s.layer, s.smooth) for s in read.strokes]
    specks = sum(not s.pieces for s in strokes)
    if specks:
        notes.append(phrase("{count} pieces without length are left out", count=specks))
    strokes = _once([s for s in strokes if s.pieces], notes)
    found = []
    for layer in dict.fromkeys(s.layer for s in strokes):
        found += _joined([s for s in strokes if s.layer == layer], layer, join, notes)
    found.sort(key=lambda curve: -curve.length)
    return [_smooth(curve) for curve in _brought_home(found, notes)], notes


def _solid(pieces):
    """Pieces that have a length, and not there and back again."""
    extents = [_extent(piece) for piece in pieces]
    if not all(math.isfinite(extent) and extent < _LARGEST for extent in extents):
        raise Refusal("The drawing has numbers that are not finite, or far too large",
                      cure="remove the shape that is not on the sheet")  # fmt: skip
    pieces = [piece for piece, extent in zip(pieces, extents, strict=True) if extent > SPECK]
    half = len(pieces) // 2
    if len(pieces) % 2 == 0 and half and math.dist(pieces[0].start, pieces[-1].end) <= SPECK:
        keys = [_key(piece) for piece in pieces]
        if keys[:half] == keys[half:][::-1]:
            return pieces[:half]
    return pieces


def _extent(piece):
    if isinstance(piece, Line):
        return piece.length
    if isinstance(piece, Arc):
        return float(np.abs(piece.u).max() + np.abs(piece.v).max()) * abs(piece.last - piece.first)
    if isinstance(piece, Spline):
        return float(np.ptp(piece.poles, axis=0).max())
    return piece.length


def _key(piece):
    """The same for pieces that lie on each other, whichever way they run."""
    ends = sorted([_rounded(piece.start), _rounded(piece.end)])
    return (*ends, *_middle(piece), round(piece.length, 6))


def _middle(piece):
    """A place that tells a piece from others between the same ends."""
    if isinstance(piece, Line):
        return ()
    if isinstance(piece, Spline):
        return _rounded(piece.poles.mean(0))
    return _rounded(piece.at(np.array([0.5]))[0])


def _rounded(point):
    return tuple(round(x, 6) + 0.0 for x in point.tolist())


def _once(strokes, notes):
    """Strokes without those whose every piece lies exactly on a piece of another."""
    seen, kept, dropped = set(), [], 0
    for stroke in sorted(strokes, key=lambda s: -len(s.pieces)):
        keys = {(stroke.layer, _key(piece)) for piece in stroke.pieces}
        if keys <= seen:
            dropped += 1
        else:
            kept.append(stroke)
        seen |= keys
    if dropped:
        notes.append(phrase("{count} exact duplicates are left out", count=dropped))
    return kept


def _joined(strokes, layer, join, notes):
    starts = np.array([s.pieces[0].start for s in strokes])
    ends = np.array([s.pieces[-1].end for s in strokes])
    out = np.array([s.pieces[0].direction(at_end=False) for s in strokes])
    into = np.array([s.pieces[-1].direction(at_end=True) for s in strokes])
    lengths = np.array([math.fsum(p.length for p in s.pieces) for s in strokes])
    found = []
    for chain in chains(starts, ends, out, into, lengths, join):
        pieces = []
        for (k, turned), shift in zip(chain.links, chain.shifts, strict=True):
            part = strokes[k].pieces
            part = [piece.turned() for piece in part[::-1]] if turned else part
            pieces += [_moved(piece, shift) for piece in part] if shift.any() else part
        found.append(FileCurve(pieces, layer, chain.closed, chain.gap))
    widest = max((curve.gap for curve in found), default=0.0)
    if widest > SPECK:
        notes.append(phrase("gaps of up to {gap:.4g} mm are closed", gap=widest))
    return found


def _moved(piece, shift):
    matrix = np.eye(4)
    matrix[:3, 3] = shift
    moved = piece.mapped(matrix)
    moved.__dict__["length"] = piece.length
    return moved


def _brought_home(curves, notes):
    """Curves far from the origin, as those of a map, moved to it together."""
    if not curves:
        return []
    corners = np.concatenate([[p.start, p.end] for curve in curves for p in curve.pieces])
    far, extent = np.abs(corners).max(), np.ptp(corners, axis=0).max()
    if far <= max(_FAR, 10 * extent):
        return curves
    home = np.floor(corners.min(0))
    notes.append(
        phrase("it lies far from the origin and is moved by ({x:.0f}, {y:.0f}, {z:.0f}) mm",
               x=-home[0], y=-home[1], z=-home[2])
    )  # fmt: skip
    return [
        FileCurve([_moved(p, -home) for p in c.pieces], c.layer, c.closed, c.gap) for c in curves
    ]


def _smooth(curve):
    """A curve of many short straight pieces as the smooth one through their ends."""
    pieces = curve.pieces
    if not 4 <= len(pieces) < MAX_POINTS or curve.closed:
        return curve
    if not all(isinstance(piece, Line) for piece in pieces):
        return curve
    directions = [piece.direction(at_end=False) for piece in pieces]
    turns = [math.degrees(math.acos(min(1.0, max(-1.0, a @ b)))) for a, b in pairwise(directions)]
    if max(turns) > _GENTLE or max(turns) < 1e-6:
        return curve
    points = np.array([pieces[0].start, *(piece.end for piece in pieces)])
    return FileCurve([through(points)], curve.layer, curve.closed, curve.gap)


def open_gap(curves: list[FileCurve]) -> tuple[int, int, float, Array] | None:
    """The two curves (from 1) whose ends come nearest each other: also the distance and the place.

    None where no ends are so near that they may be meant to meet.
    """
    ends = [
        (k, np.array([curve.pieces[0].start, curve.pieces[-1].end]))
        for k, curve in enumerate(curves[:50], 1)
        if not curve.closed
    ]
    found = [
        (*nearest_gap(one, other), a, b)
        for i, (a, one) in enumerate(ends)
        for b, other in ends[i + 1 :]
    ]
    if not found:
        return None
    gap, place, a, b = min(found, key=lambda entry: entry[0])
    return (a, b, gap, place) if gap <= _NEAR * curves[0].length else None


def nothing_in(name: str, read: Read) -> Refusal:
    """The refusal of a file without any curve, with what it holds instead."""
    held = joined(
        phrase("{count} × {what} ({why})", count=count, what=what, why=why)
        for (what, why), count in read.left_out.items()
    )
    rest = phrase(", only {held}", held=held) if read.left_out else ""
    return Refusal(
        "{name} holds no line or curve{rest}", name=name, rest=rest,
        cure="draw one path, or turn text and surfaces to paths, and export it again",
    )  # fmt: skip
