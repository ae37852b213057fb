# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each body's mesh must be one closed, oriented surface that nowhere crosses itself."""

import numpy as np

from ..solids.mesh import component_labels, half_edges, unpaired_edges
from . import triangles
from .findings import ERROR, Finding
from .trees import Scene

VOLUME_TOLERANCE = 0.005  # share by which a mesh's volume may differ from its solid's
# Triangles lower than this (mm) are slivers: single precision, in which STL is written, loses them.
LEAST_HEIGHT = 1e-5
_REBUILD = "rebuild the solids, and report it if it stays so"
_TINY = 1e-9  # mm
_FOLDED = 1 - 1e-9  # cosine of the angle below which neighbours lie on each other


def check_mesh(name, mesh, tree):
    """List of `Finding` about one body's `Mesh` (mm); ``tree``: its `Tree`."""
    found = []

    def error(code, number, what, points=()):
        where = tuple(map(tuple, np.asarray(points)[:20].tolist()))
        message = f"The mesh of {name} {what}."
        found.append(Finding(ERROR, code, (name,), float(number), 0.0, message, _REBUILD, where))

    corners = mesh.corners
    slivers = corners[heights(corners) < LEAST_HEIGHT]
    if len(slivers):
        error("degenerate", len(slivers), f"has {len(slivers)} triangles without area",
              slivers.mean(1))  # fmt: skip
    loose = unpaired_edges(mesh.triangles)
    if len(loose):
        where = mesh.vertices[loose].mean(1)
        if _is_closed_unoriented(mesh.triangles):
            what = "has triangles that face the wrong way"
            error("orientation", len(loose), what, where)
        else:
            error("open", len(loose), f"is not closed at {len(loose)} edges", where)
    elif mesh.volume <= 0:
        error("inside_out", mesh.volume, "is inside out")
    parts = component_labels(mesh.triangles, len(mesh.vertices)).max(initial=-1) + 1
    if parts != 1:
        error("parts", parts, f"has {parts} separate parts instead of one")
    crossing = self_intersections(tree)
    if len(crossing):
        error("self_intersection", len(crossing), f"crosses itself at {len(crossing)} places",
              crossing)  # fmt: skip
    return found


def check_volume(name, mesh, solid_volume):
    """List of `Finding`: the mesh's volume against the solid's (mm³), to `VOLUME_TOLERANCE`."""
    off = abs(mesh.volume - solid_volume) / solid_volume
    if off <= VOLUME_TOLERANCE:
        return []
    message = (
        f"The mesh of {name} has {mesh.volume:.5g} mm³, {off:.1%} off its solid's "
        f"{solid_volume:.5g} mm³."
    )
    return [Finding(ERROR, "volume", (name,), off, VOLUME_TOLERANCE, message,
                    "make the linear and angular deflection smaller")]  # fmt: skip


def check_count(parts, expected):
    """List of `Finding`: connected parts of a whole print against its number of bodies."""
    if parts == expected:
        return []
    message = f"The print has {parts} separate parts instead of {expected} bodies."
    return [Finding(ERROR, "body_count", (), float(parts), float(expected), message, _REBUILD)]


def heights(corners):
    """Smallest height of every triangle (t, 3, 3) → (t,), mm."""
    edges = corners[:, [1, 2, 0]] - corners
    longest = np.sqrt((edges**2).sum(-1).max(1))
    area = np.linalg.norm(triangles.cross(edges[:, 0], edges[:, 1]), axis=1)
    return area / np.where(longest > 0, longest, 1)


def self_intersections(tree):
    """Middles (n, 3) of triangles of a mesh that cross others, or lie folded onto a neighbour."""
    mesh = tree.mesh
    scene = Scene([tree], np.eye(4)[None])
    _, first, second = scene.near_triangles([(0, 0)], 1e-6)
    a, b = mesh.triangles[first], mesh.triangles[second]
    common = (a[:, :, None] == b[:, None, :]).sum((1, 2))
    neighbours, apart = np.flatnonzero(common == 2), np.flatnonzero(common < 2)
    crossing = np.zeros(len(first), bool)
    crossing[neighbours] = _folded(mesh.vertices, a[neighbours], b[neighbours])
    for p, q in ((first[apart], second[apart]), (second[apart], first[apart])):
        rows = np.flatnonzero(_straddle(scene, p, q))
        hit, _, _ = triangles.edges_through(scene.corners[p[rows]], scene.corners[q[rows]])
        one, other = mesh.triangles[p[rows]], mesh.triangles[q[rows]]
        shared = (one[:, :, None] == other[:, None, :]).any(2)
        free = ~shared & ~shared[:, [1, 2, 0]]  # an edge that starts at the other triangle meets it
        crossing[apart[rows]] |= (hit & free).any(1)
    return scene.corners[first[crossing]].mean(1)


def _straddle(scene, p, q):
    """Whether triangles p have corners on both sides of the planes of triangles q: (n,) bool."""
    above = np.matmul(scene.corners[p], scene.normals[q][:, :, None])[..., 0]
    low, high = triangles.least_of_three(above), triangles.most_of_three(above)
    return (low <= scene.heights[q] + _TINY) & (high >= scene.heights[q] - _TINY)


def _folded(vertices, first, second):
    """Whether neighbours with a common edge lie on each other, not side by side: (n,) bool."""
    common = (first[:, :, None] == second[:, None, :]).any(2)
    ends = first[common].reshape(-1, 2)
    start = vertices[ends[:, 0]]
    along = vertices[ends[:, 1]] - start
    along /= np.maximum(np.linalg.norm(along, axis=1), 1e-30)[:, None]
    sides = []
    for one, other in ((first, second), (second, first)):
        third = one[~(one[:, :, None] == other[:, None, :]).any(2)]
        side = vertices[third] - start
        side -= triangles.dot(side, along)[:, None] * along
        sides.append(side / np.maximum(np.linalg.norm(side, axis=1), 1e-30)[:, None])
    return triangles.dot(*sides) > _FOLDED


def _is_closed_unoriented(indices):
    """Every edge has two triangles, whichever way round they are."""
    edges = np.sort(half_edges(indices), axis=1)
    _, count = np.unique(edges, axis=0, return_counts=True)
    return bool((count == 2).all())
