# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangle meshes as plain arrays: what is exported, checked and drawn. Knows no FreeCAD."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Mesh(NamedTuple):
    """``vertices`` (v, 3) mm; ``triangles`` (t, 3) of their numbers, anticlockwise from outside."""

    vertices: np.ndarray
    triangles: np.ndarray

    @property
    def corners(self) -> NDArray:
        """Corners of all triangles (t, 3, 3), mm."""
        return self.vertices[self.triangles]

    @property
    def volume(self) -> float:
        """Signed volume, mm³: negative where the mesh is inside out."""
        a, b, c = np.moveaxis(self.corners - self.vertices.mean(0), 1, 0)
        return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)

    @property
    def bounds(self) -> NDArray:
        """Lowest and highest coordinates (2, 3), mm."""
        return np.stack([self.vertices.min(0), self.vertices.max(0)])

    def moved(self, matrix: NDArray) -> "Mesh":
        """The mesh carried by a matrix (4, 4); a mirror image keeps its outside outside."""
        matrix = np.asarray(matrix, float)
        vertices = self.vertices @ matrix[:3, :3].T + matrix[:3, 3]
        mirrored = np.linalg.det(matrix[:3, :3]) < 0
        return Mesh(vertices, self.triangles[:, ::-1] if mirrored else self.triangles)


def material_of(kind: str) -> str:
    """What a kind of bodies is printed in: "rigid", "flexible" or "support"."""
    return {"flexure": "flexible", "support": "support"}.get(kind, "rigid")


class PlacedMesh(NamedTuple):
    """One body of a print as a mesh: ``mesh``, shared by all its copies, and where it stands.

    ``place`` (4, 4) carries the mesh into the print frame (it may be a mirror image); ``unit``,
    ``members`` and ``kind`` as in `solids.tube.Body` ("": a body that is none of ours).
    """

    name: str
    mesh: Mesh
    place: np.ndarray
    unit: int = 0
    members: tuple = ()
    kind: str = ""

    @property
    def material(self) -> str:
        """What it is printed in: "rigid", "flexible" or "support"."""
        return material_of(self.kind)

    @property
    def placed(self) -> Mesh:
        """The `Mesh` in the print frame."""
        return self.mesh.moved(self.place)


def joined(meshes: Sequence[Mesh]) -> Mesh:
    """One `Mesh` of several, which stay apart."""
    first = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])[:-1]
    return Mesh(
        np.concatenate([mesh.vertices for mesh in meshes]),
        np.concatenate([m.triangles + k for m, k in zip(meshes, first, strict=True)]),
    )


def half_edges(triangles: NDArray) -> NDArray:
    """Directed edges (3 t, 2), triangle by triangle."""
    return triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)


def unpaired_edges(triangles: NDArray) -> NDArray:
    """Directed edges that do not run exactly once this way and once the other way.

    Empty for a closed, oriented surface without edges shared by more than two triangles.
    """
    edges = half_edges(triangles).astype(np.int64)
    if not len(edges):
        return edges
    base = edges.max() + 1
    there, back = edges[:, 0] * base + edges[:, 1], edges[:, 1] * base + edges[:, 0]
    codes, which, count = np.unique(there, return_inverse=True, return_counts=True)
    at = np.minimum(np.searchsorted(codes, back), len(codes) - 1)
    return edges[(count[which] > 1) | (codes[at] != back)]


def component_labels(triangles: NDArray, count: int) -> NDArray:
    """Label (t,) of the connected part of every triangle, numbered 0… by shared vertices.

    ``count``: number of vertices.
    """
    if not len(triangles):
        return np.zeros(0, int)
    one, other = np.repeat(triangles[:, 0], triangles.shape[1] - 1), triangles[:, 1:].ravel()
    label = np.arange(count)
    while True:
        a, b = label[one], label[other]
        apart = a != b
        if not apart.any():
            return np.unique(label[triangles[:, 0]], return_inverse=True)[1]
        one, other, a, b = one[apart], other[apart], a[apart], b[apart]
        high, low = np.maximum(a, b), np.minimum(a, b)
        order = np.lexsort((-low, high))  # of several links of one root the lowest is written last
        label[high[order]] = low[order]
        while True:
            above = label[label]
            if np.array_equal(above, label):
                break
            label = above
