# SPDX-License-Identifier: LGPL-2.1-or-later
"""Linked geometry as one smooth curve: edges, wires, sketches and Draft curves."""

import math

import numpy as np
import Part

KINK_DEGREES = 0.5
_JOIN = 1e-5


class EdgeChain:
    """Connected edges as one curve: ``point(s)`` for s in [0, 1], as `origami.placement` wants.

    s runs in proportion to the edges' lengths. ``label`` names the source in errors.
    ValueError where the edges do not form one open chain, or where they meet in a kink.
    """

    def __init__(self, edges, label):
        self.label = label
        self.pieces = _chained(edges, label)
        lengths = np.array([edge.Length for edge, _, _ in self.pieces])
        self.length = float(lengths.sum())
        self.bounds = np.concatenate([[0], np.cumsum(lengths)]) / self.length
        self.bounds[-1] = 1
        self.breaks = self._breaks()
        self._refuse_kinks()

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

    def _refuse_kinks(self):
        for (edge, _, last), (after, first, _) in zip(self.pieces, self.pieces[1:], strict=False):
            self._compare(_direction(edge, last, False), _direction(after, first, True),
                          edge.valueAt(last))  # fmt: skip
        for edge, first, last in self.pieces:
            for knot in _sharp_knots(edge, first, last):
                step = 1e-6 * abs(last - first)
                before, after = edge.tangentAt(knot - step), edge.tangentAt(knot + step)
                self._compare(before, after, edge.valueAt(knot))

    def _compare(self, before, after, point):
        angle = math.degrees(before.getAngle(after))
        if angle > KINK_DEGREES:
            at = ", ".join(f"{x:.4g}" for x in point)
            raise ValueError(
                f"Source {self.label} has a kink of {angle:.3g}° at ({at}) mm: round it with a "
                "fillet (or a tangent constraint), the units cannot follow a corner."
            )


def edges_of(link):
    """Edges of a link with sub-elements (object, names), in global coordinates, and a label.

    ValueError where nothing is linked, or the linked object has no edge.
    """
    source, names = link
    names = [name for name in names if name]
    label = source.Label
    shape = Part.getShape(source, "", needSubElement=False)
    if shape.isNull() or not shape.Edges:
        raise ValueError(
            f"Source {label} has no edge: link an edge, a wire, a sketch or a Draft curve."
        )
    if not names:
        return shape.Edges, label
    edges = []
    for name in names:
        try:
            element = shape.getElement(name)
        except (ValueError, Part.OCCError, AttributeError, IndexError) as error:
            raise ValueError(
                f"Source {label} has no element {name} any more: choose its edge again."
            ) from error
        if not element.Edges:
            raise ValueError(f"Source {label}: {name} is not an edge; choose an edge or a wire.")
        edges += element.Edges
    return edges, f"{label}.{','.join(names)}"


def _chained(edges, label):
    """Edges in path order as (edge, first parameter, last parameter) along the path."""
    groups = Part.sortEdges(edges)
    if len(groups) != 1:
        raise ValueError(
            f"Source {label} falls into {len(groups)} separate pieces: link one connected curve, "
            "or choose one of its edges."
        )
    pieces = []
    for edge in groups[0]:
        first, last = edge.FirstParameter, edge.LastParameter
        pieces.append((edge, first, last))
    return _oriented(pieces)


def _oriented(pieces):
    """Swap parameters so that every piece starts where the one before ended."""
    ends = [(e.valueAt(a), e.valueAt(b)) for e, a, b in pieces]
    if len(pieces) == 1:
        here = ends[0][pieces[0][0].Orientation == "Reversed"]
    else:  # the path starts at the end of the first piece that is further from the second
        here = max(ends[0], key=lambda p: min(p.distanceToPoint(q) for q in ends[1]))
    turned = []
    for (edge, first, last), (start, end) in zip(pieces, ends, strict=True):
        reverse = here.distanceToPoint(end) < here.distanceToPoint(start)
        turned.append((edge, last, first) if reverse else (edge, first, last))
        here = start if reverse else end
    return turned


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
