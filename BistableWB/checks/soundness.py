# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each body's mesh must be one closed, oriented surface that nowhere crosses itself."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..origami.errors import ERROR, Finding, phrase
from ..origami.meshes import component_labels, half_edges, unpaired_edges
from . import triangles

if TYPE_CHECKING:
    from ..origami.errors import Phrase
    from ..origami.meshes import Mesh
    from .bvh import Tree

VOLUME_TOLERANCE = 0.005  # share by which a mesh's volume may differ from its solid's
# Triangles lower than this (mm) are slivers: single precision, in which STL is written, loses them.
LEAST_HEIGHT = 1e-5
_REBUILD = phrase("rebuild the solids, and report it if it stays so")
_TOUCHING = 1e-6  # mm
_FOLDED = 1 - 1e-9  # cosine of the angle below which neighbours lie on each other


def check_mesh(name: str, mesh: "Mesh", tree: "Tree") -> list[Finding]:
    """List of `Finding` about one body's `Mesh` (mm); ``tree``: its `Tree`."""
    found = []

    def error(code: str, number: float, what: "Phrase", points: ArrayLike = ()) -> None:
        where = tuple(map(tuple, np.asarray(points)[:20].tolist()))
        message = phrase("The mesh of {body} {fault}.", body=name, fault=what)
        found.append(
            Finding(
                severity=ERROR,
                code=code,
                bodies=(name,),
                number=float(number),
                limit=0.0,
                message=message,
                cure=_REBUILD,
                points=where,
            )
        )

    corners = mesh.corners
    slivers = corners[heights(corners) < LEAST_HEIGHT]
    if len(slivers):
        error("degenerate", len(slivers), phrase(
            "has {count} triangles without area", count=len(slivers)), slivers.mean(1))  # fmt: skip
    loose = unpaired_edges(mesh.triangles)
    if len(loose):
        where = mesh.vertices[loose].mean(1)
        if _is_closed_unoriented(mesh.triangles):
            what = phrase("has triangles that face the wrong way")
            error("orientation", len(loose), what, where)
        else:
            error(
                "open",
                len(loose),
                phrase("is not closed at {count} edges", count=len(loose)),
                where,
            )
    elif mesh.volume <= 0:
        error("inside_out", mesh.volume, phrase("is inside out"))
    parts = component_labels(mesh.triangles, len(mesh.vertices)).max(initial=-1) + 1
    if parts != 1:
        error("parts", parts, phrase("has {count} separate parts instead of one", count=parts))
    crossing = self_intersections(tree)
    if len(crossing):
        error("self_intersection", len(crossing), phrase(
            "crosses itself at {count} places", count=len(crossing)), crossing)  # fmt: skip
    return found


def check_volume(name: str, mesh: "Mesh", solid_volume: float, slack: float = 0.0) -> list[Finding]:
    """List of `Finding`: the mesh's volume against the solid's (mm³), to `VOLUME_TOLERANCE`.

    ``slack``: mm³ that chords of round faces may take or add, where that is more: in thin panels
    barrels are most of a body.
    """
    off = abs(mesh.volume - solid_volume) / solid_volume
    if off <= max(VOLUME_TOLERANCE, slack / solid_volume):
        return []
    message = phrase(
        "The mesh of {body} has {volume:.5g} mm³, {off:.1%} off its solid's {solid:.5g} mm³.",
        body=name,
        volume=mesh.volume,
        off=off,
        solid=solid_volume,
    )
    return [
        Finding(
            severity=ERROR,
            code="volume",
            bodies=(name,),
            number=off,
            limit=VOLUME_TOLERANCE,
            message=message,
            cure=phrase("make the linear and angular deflection smaller"),
        )
    ]


def check_count(parts: int, expected: int) -> list[Finding]:
    """List of `Finding`: connected parts of a whole print against its number of bodies."""
    if parts == expected:
        return []
    message = phrase(
        "The print has {parts} separate parts instead of {expected} bodies.",
        parts=parts,
        expected=expected,
    )
    return [
        Finding(
            severity=ERROR,
            code="body_count",
            number=float(parts),
            limit=float(expected),
            message=message,
            cure=_REBUILD,
        )
    ]


def heights(corners: NDArray) -> NDArray:
    """Smallest height of every triangle (t, 3, 3) → (t,), mm."""
    edges = corners[:, [1, 2, 0]] - corners
    longest = np.sqrt((edges**2).sum(-1).max(1))
    area = np.linalg.norm(triangles.cross(edges[:, 0], edges[:, 1]), axis=1)
    return area / np.where(longest > 0, longest, 1)


def self_intersections(tree: "Tree") -> NDArray:
    """Middles (n, 3) of triangles of a mesh that cross others, or lie folded onto a neighbour."""
    mesh = tree.mesh
    scene, first, second = tree.own_pairs(_TOUCHING)
    near = scene.touching(first, second, _TOUCHING)
    first, second = first[near], second[near]
    for _ in range(2):  # first those that touch each other's planes, seen from either side
        meet, _ = scene.reaches(first, second)
        second, first = first[meet], second[meet]
    a, b = mesh.triangles[first], mesh.triangles[second]
    common = (a[:, :, None] == b[:, None, :]).sum((1, 2))
    # With a corner in common, one crosses the other only with what is really on both its sides.
    deep = scene.reaches(first, second)[1] & scene.reaches(second, first)[1]
    neighbours = np.flatnonzero(common == 2)
    apart = np.flatnonzero((common == 0) | ((common == 1) & deep))
    crossing = np.zeros(len(first), bool)
    crossing[neighbours] = _folded(mesh.vertices, a[neighbours], b[neighbours])
    for p, q in ((first[apart], second[apart]), (second[apart], first[apart])):
        hit, _, _ = triangles.edges_through(scene.corners[p], scene.corners[q])
        one, other = mesh.triangles[p], mesh.triangles[q]
        shared = (one[:, :, None] == other[:, None, :]).any(2)
        free = ~shared & ~shared[:, [1, 2, 0]]  # an edge that starts at the other triangle meets it
        crossing[apart] |= (hit & free).any(1)
    return scene.corners[first[crossing]].mean(1)


def _folded(vertices: NDArray, first: NDArray, second: NDArray) -> NDArray:
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


def _is_closed_unoriented(indices: NDArray) -> bool:
    """Every edge has two triangles, whichever way round they are."""
    edges = np.sort(half_edges(indices), axis=1)
    _, count = np.unique(edges, axis=0, return_counts=True)
    return bool((count == 2).all())
