# SPDX-License-Identifier: LGPL-2.1-or-later
"""Linked geometry as one smooth curve: edges, wires, sketches and Draft curves."""

import itertools
import math

import FreeCAD as App
import numpy as np
import Part

from ..origami.curves.joining import chains, nearest_gap
from ..origami.errors import Refusal, phrase
from .base import frame_placement

KINK_DEGREES = 0.5


class EdgeChain:
    """Connected edges as one curve: ``point(s)`` for s in [0, 1], as `origami.placement` wants.

    s runs in proportion to the edges' lengths. ``label`` names the source in errors.
    ``kinks``: parameters where they meet in a kink. ValueError where they do not form one chain.
    """

    def __init__(self, edges, label):
        self.label = label
        self.pieces = _chained(edges, label)
        lengths = np.array([edge.Length for edge, _, _ in self.pieces])
        self.length = float(lengths.sum())
        self.bounds = np.concatenate([[0], np.cumsum(lengths)]) / self.length
        self.bounds[-1] = 1
        self.breaks = self._breaks()
        self.kinks = self._kinks()

    def _breaks(self):
        """Parameters where pieces, or spans of a B-spline, meet."""
        found = set(self.bounds.tolist())
        for k, (edge, first, last) in enumerate(self.pieces):
            if isinstance(edge.Curve, Part.BSplineCurve):
                local = [(knot - first) / (last - first) for knot in edge.Curve.getKnots()]
                start, end = self.bounds[k], self.bounds[k + 1]
                found |= {start + t * (end - start) for t in local if 0 < t < 1}
        return sorted(found)

    def point(self, s):
        """Points (…, 3) at ``s`` in [0, 1]."""
        s = np.asarray(s, float)
        flat = s.ravel()
        index = np.clip(
            np.searchsorted(self.bounds, flat, side="right") - 1, 0, len(self.pieces) - 1
        )
        start, end = self.bounds[index], self.bounds[index + 1]
        local = (flat - start) / (end - start)
        points = np.empty((len(flat), 3))
        for i, (k, t) in enumerate(zip(index.tolist(), local.tolist(), strict=True)):
            edge, first, last = self.pieces[k]
            points[i] = edge.valueAt(first + t * (last - first))
        return points.reshape(*s.shape, 3)

    def _kinks(self):
        """Parameters of the kinks, 0 among them where a closed chain has one at its seam."""
        pairs = list(zip(self.pieces, self.pieces[1:], strict=False))
        at = self.bounds[1:-1].tolist()
        (edge, first, _), (end, _, last) = self.pieces[0], self.pieces[-1]
        if edge.valueAt(first).distanceToPoint(end.valueAt(last)) < 1e-6 * self.length:
            pairs.append((self.pieces[-1], self.pieces[0]))
            at.append(0.0)
        found = [
            place
            for place, ((edge, _, last), (after, first, _)) in zip(at, pairs, strict=True)
            if _turned(_direction(edge, last, False), _direction(after, first, True))
        ]
        for k, (edge, first, last) in enumerate(self.pieces):
            for knot in _sharp_knots(edge, first, last):
                step = 1e-6 * abs(last - first)
                if _turned(edge.tangentAt(knot - step), edge.tangentAt(knot + step)):
                    share = (knot - first) / (last - first)
                    start, end = self.bounds[k : k + 2]
                    found.append(float(start + share * (end - start)))
        return sorted(found)


def _turned(before, after):
    return math.degrees(before.getAngle(after)) > KINK_DEGREES


def edges_of(link):
    """Edges of a link with sub-elements (object, names), in global coordinates, and a label.

    ValueError where nothing is linked, or the linked object has no edge.
    """
    source, names = link
    names = [name for name in names if name]
    label = source.Label
    shape = Part.getShape(source, "", needSubElement=False)
    home = frame_placement(source)  # the Parts that it is in
    if not (shape.isNull() or home.isIdentity()):
        shape.Placement = home * shape.Placement
    if shape.isNull() or not shape.Edges:
        raise Refusal(
            "{Source} {label} has no edge: link an edge, a wire, a sketch or a Draft curve.",
            parameter="Source",
            label=label,
        )
    if not names:
        return shape.Edges, label
    edges = []
    for name in names:
        try:
            element = shape.getElement(name)
        except (ValueError, Part.OCCError, AttributeError, IndexError) as error:
            raise Refusal(
                "{Source} {label} has no element {name} any more: choose its edge again.",
                parameter="Source",
                label=label,
                name=name,
            ) from error
        if not element.Edges:
            raise Refusal(
                "{Source} {label}: {name} is not an edge; choose an edge or a wire.",
                parameter="Source",
                label=label,
                name=name,
            )
        edges += element.Edges
    return edges, f"{label}.{','.join(names)}"


def _chained(edges, label):
    """Edges in path order as (edge, first parameter, last parameter) along the path.

    They are joined as those of files are (`origami.curves.joining`): a gap that is closed moves
    edges, exact duplicates are left out. The path runs as its first edge does.
    """
    edges = _once(edges)
    params = [(edge.FirstParameter, edge.LastParameter) for edge in edges]
    starts, ends = (
        np.array([tuple(e.valueAt(p[k])) for e, p in zip(edges, params, strict=True)])
        for k in (0, 1)
    )
    out, into = (
        np.array([tuple(e.tangentAt(p[k])) for e, p in zip(edges, params, strict=True)])
        for k in (0, 1)
    )
    found = chains(starts, ends, out, into, np.array([edge.Length for edge in edges]))
    if len(found) != 1:
        raise _falls_apart(found, starts, ends, label)
    links, shifts = found[0].links, found[0].shifts
    if dict(links)[0] != (edges[0].Orientation == "Reversed"):
        links, shifts = [(k, not turned) for k, turned in links[::-1]], shifts[::-1]
    pieces = []
    for (k, turned), shift in zip(links, shifts, strict=True):
        edge, (first, last) = edges[k], params[k]
        if shift.any():
            edge = edge.translated(App.Vector(*shift.tolist()))
        pieces.append((edge, last, first) if turned else (edge, first, last))
    return pieces


def _falls_apart(found, starts, ends, label):
    loose = [
        np.array([point for k, _ in chain.links for point in (starts[k], ends[k])])
        for chain in found[:20]
        if not chain.closed
    ]
    gaps = [nearest_gap(a, b) for a, b in itertools.combinations(loose, 2)]
    where = ""
    if gaps:
        gap, place = min(gaps, key=lambda pair: pair[0])
        at = ", ".join(f"{x:.4g}" for x in place)
        where = phrase(" (the smallest gap is {gap:.3g} mm at ({at}) mm)", gap=gap, at=at)
    return Refusal(
        "{Source} {label} falls into {count} separate pieces{where}: link one connected curve, or "
        "choose one of its edges.",
        parameter="Source",
        label=label,
        count=len(found),
        where=where,
    )


def _once(edges):
    """Edges without those that lie exactly on one before."""
    seen, kept = set(), []
    for edge in edges:
        ends = sorted(_rounded(edge.valueAt(p)) for p in edge.ParameterRange)
        middle = edge.valueAt(sum(edge.ParameterRange) / 2)
        key = (*ends, _rounded(middle), round(edge.Length, 6))
        if key not in seen:
            kept.append(edge)
        seen.add(key)
    return kept


def _rounded(point):
    return tuple(round(x, 6) + 0.0 for x in point)


def _direction(edge, parameter, leaving):
    """Unit direction of travel at the end (or, ``leaving``, at the start) of a piece."""
    forward = (parameter == edge.FirstParameter) == leaving
    tangent = edge.tangentAt(parameter)
    return tangent if forward else -tangent


def _sharp_knots(edge, first, last):
    """Inner knots of a B-spline edge at which it may have a corner."""
    curve = edge.Curve
    if not isinstance(curve, Part.BSplineCurve):
        return []
    low, high = min(first, last), max(first, last)
    return [
        knot
        for knot, multiplicity in zip(curve.getKnots(), curve.getMultiplicities(), strict=True)
        if low < knot < high and multiplicity >= curve.Degree
    ]
