# SPDX-License-Identifier: LGPL-2.1-or-later
"""Watertight meshes of boundaries: every edge is cut into chords once, for both its faces."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import acos, ceil, pi

import numpy as np
from numpy.typing import NDArray

from ..meshes import Mesh
from .boundary import CONE, Boundary, Ruled
from .triangulation import triangulated

CHORD_ERROR = 0.01  # mm by which chords of round edges may lie inside
LEAST_CHORDS = 8  # of a full circle


@dataclass(frozen=True, eq=False)
class Meshed:
    """``mesh``, and the number (t,) of the face that each of its triangles lies on.

    ``cones``: numbers of the faces that are cones.
    """

    mesh: Mesh
    faces: NDArray
    cones: NDArray


def meshed(boundary: Boundary, chord_error: float = CHORD_ERROR) -> Meshed:
    """Closed mesh of a boundary; chords lie at most ``chord_error`` (mm) inside round edges."""
    counts = _chords(boundary, chord_error)
    vertices, first = _points(boundary, counts)
    refs, sizes = _walked(boundary, counts, first)
    numbers, ruled = boundary.ruled
    strips, of_strip = _strips(boundary, ruled, counts, first)
    planes, areas, _ = boundary.planes
    flats, of_flat = triangulated(vertices, refs, sizes, areas)
    triangles = np.concatenate([flats, strips])
    faces = np.concatenate([planes[of_flat], np.array(numbers, int)[of_strip]])
    cones = np.array([k for k in numbers if boundary.kinds[k] == CONE], int)
    return Meshed(Mesh(vertices, triangles), faces, cones)


def mesh_of(boundary: Boundary, chord_error: float = CHORD_ERROR) -> Meshed:
    """`meshed`, made once for every boundary and chord error: its copies share it."""
    known = boundary.__dict__.setdefault("_meshes", {})
    if chord_error not in known:
        known[chord_error] = meshed(boundary, chord_error)
    return known[chord_error]


def chords_for(radius: float, sweep: float, chord_error: float) -> int:
    """Number of chords of an arc (radius mm, sweep radians) for a chord error (mm)."""
    step = 2 * acos(1 - min(chord_error / radius, 0.9)) if radius > 0 else pi
    step = min(step, 2 * pi / LEAST_CHORDS)
    return max(1, ceil(abs(sweep) / step - 1e-9))


def _chords(boundary: Boundary, chord_error: float) -> NDArray:
    """Number of chords (e,) of every edge; alike for both edges of a ruled face."""
    counts = np.ones(len(boundary.ends), int)
    arcs = boundary.arcs
    known: dict[tuple[float, float], int] = {}
    for edge, radius, sweep in zip(
        arcs.edge.tolist(), arcs.radius.round(9).tolist(), arcs.sweep.round(9).tolist(), strict=True
    ):
        if (radius, sweep) not in known:
            known[radius, sweep] = chords_for(radius, sweep, chord_error)
        counts[edge] = known[radius, sweep]
    pairs = np.array([(f.first, f.second) for f in boundary.ruled[1]], int).reshape(-1, 2)
    while True:
        both = counts[pairs]
        if not len(pairs) or (both[:, 0] == both[:, 1]).all():
            return counts
        np.maximum.at(counts, pairs, both.max(1)[:, None])


def _points(boundary: Boundary, counts: NDArray) -> tuple[NDArray, NDArray]:
    """All points (n, 3), vertices first, and where the inner ones of each edge start (e,)."""
    inner = counts - 1
    first = len(boundary.vertices) + np.cumsum(inner) - inner
    points = np.empty((len(boundary.vertices) + inner.sum(), 3))
    points[: len(boundary.vertices)] = boundary.vertices
    arcs = boundary.arcs
    of_arcs = counts[arcs.edge]
    for count in np.unique(of_arcs[of_arcs > 1]).tolist():
        rows = np.flatnonzero(of_arcs == count)
        angles = arcs.sweep[rows, None] * (np.arange(1, count) / count)
        cos, sin = np.cos(angles)[..., None], np.sin(angles)[..., None]
        made = (
            arcs.centre[rows, None] + cos * arcs.along[rows, None] + sin * arcs.across[rows, None]
        )
        at = first[arcs.edge[rows], None] + np.arange(count - 1)
        points[at] = made
    return points, first


def _walk(
    edge: int,
    ends: Sequence[Sequence[int]],
    counts: NDArray | Sequence[int],
    first: NDArray | Sequence[int],
) -> list[int]:
    """Points along an edge without its last one."""
    if edge >= 0:
        start, n = ends[edge][0], counts[edge]
        return [start, *range(first[edge], first[edge] + n - 1)] if n > 1 else [start]
    edge = ~edge
    start, n = ends[edge][1], counts[edge]
    return [start, *range(first[edge] + n - 2, first[edge] - 1, -1)] if n > 1 else [start]


def _walked(
    boundary: Boundary, counts: NDArray, first: NDArray
) -> tuple[list[list[int]], list[tuple[int, ...]]]:
    """Point numbers of the loops of every plane face, and the sizes of its loops."""
    ends, counts, first = boundary.ends.tolist(), counts.tolist(), first.tolist()
    refs, sizes = [], []
    for face in boundary.faces:
        if isinstance(face, Ruled):
            continue
        loops = [
            [point for edge in loop for point in _walk(edge, ends, counts, first)] for loop in face
        ]
        refs.append([point for loop in loops for point in loop])
        sizes.append(tuple(len(loop) for loop in loops))
    return refs, sizes


def _strips(
    boundary: Boundary, ruled: Sequence[Ruled], counts: NDArray, first: NDArray
) -> tuple[NDArray, NDArray]:
    """Triangles (t, 3) of the ruled faces and which of them (t,) each lies on."""
    ends = boundary.ends
    triangles, which = [np.empty((0, 3), int)], [np.empty(0, int)]
    firsts = np.array([face.first for face in ruled], int)
    seconds = np.array([face.second for face in ruled], int)
    signs = np.array([face.sign for face in ruled], int)
    for count in np.unique(counts[firsts]).tolist():
        rows = np.flatnonzero(counts[firsts] == count)
        a, b = (_row_of(edges[rows], ends, count, first) for edges in (firsts, seconds))
        quads = np.stack([a[:, :-1], a[:, 1:], b[:, 1:], b[:, :-1]], -1)
        flip = signs[rows] < 0
        quads[flip] = quads[flip][..., ::-1]
        quads = quads.reshape(-1, 4)
        triangles += [quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]
        of_quads = np.repeat(rows, count)
        which += [of_quads, of_quads]
    return np.concatenate(triangles), np.concatenate(which)


def _row_of(edges: NDArray, ends: NDArray, count: int, first: NDArray) -> NDArray:
    """Points (n, count + 1) of edges cut into ``count`` chords."""
    inner = first[edges, None] + np.arange(count - 1)
    return np.concatenate([ends[edges, :1], inner, ends[edges, 1:]], 1)
