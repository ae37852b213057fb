# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls and cones, measured on a mesh: where it is thinnest, and how far its cones hang over."""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..origami.meshes import component_labels, half_edges
from . import triangles

if TYPE_CHECKING:
    from ..origami.meshes import Mesh
    from .bvh import Scene, Tree

_OPPOSITE = -np.cos(np.pi / 4)  # two sides of a wall face away from each other, up to a taper
_BEHIND = 1e-4  # mm by which each side of a wall must lie behind the other
_FLAT = np.cos(np.radians(0.5))  # triangles of one flat face
_SMOOTH = np.cos(np.radians(40))  # triangles of one curved face; rims of cones are sharper
_ROUND = 0.05  # by which the normals of a cone may differ along its axis
_CONES = 0.15, 0.95  # share of the normals along the axis: barrels have none, flat ends all
_LEAST = 6  # triangles of a cone
_UPRIGHT = np.sqrt(0.5)  # normals that rise more steeply belong to floors and ceilings


class Wall(NamedTuple):
    """``thickness`` mm, its middle ``point``, and whether it is a ``floor``: a wall lying down."""

    thickness: float
    point: np.ndarray
    floor: bool


def thinnest_walls(tree: "Tree", place: NDArray, reach: float) -> list[Wall]:
    """The thinnest upright `Wall` and the thinnest floor, where thinner than ``reach`` mm.

    A wall is the material between two faces that look away from each other within 45°, lie opposite
    each other and do not meet: a sharp corner in plan is none. ``tree``: the body's `Tree`;
    ``place``: how it lies.
    """
    scene, first, second = tree.own_pairs(reach)
    normals = scene.normals
    away = triangles.dot(normals.take(first, 0), normals.take(second, 0)) < _OPPOSITE
    first, second = first[away], second[away]
    through = _is_behind(scene, first, second) & _is_behind(scene, second, first)
    first, second = first[through], second[through]
    thickness = scene.distances(first, second)
    rows = np.flatnonzero(thickness < reach)
    rows = rows[_opposite(scene, first[rows], second[rows])]
    rows = rows[np.argsort(thickness[rows], kind="stable")]
    place = np.asarray(place)
    floor = np.abs(scene.normals[first[rows]] @ place[2, :3]) > _UPRIGHT
    faces = _faces(tree.mesh, scene.normals, _FLAT) if len(rows) else None
    found = []
    for lying in (False, True):
        for row in rows[floor == lying]:
            a, b = first[row], second[row]
            if not _meet(tree.mesh.triangles, faces, a, b):
                middle = (scene.corners[a].mean(0) + scene.corners[b].mean(0)) / 2
                middle = place[:3, :3] @ middle + place[:3, 3]
                found.append(Wall(float(thickness[row]), middle, lying))
                break
    return found


def steepest_cone(mesh: "Mesh") -> tuple[float, NDArray] | None:
    """Largest overhang (degrees from the vertical) of any cone or its recess, and where; or None.

    ``mesh``: the body as it lies. Cones are found by their normals, which all make one angle with
    an axis that is neither none (a barrel) nor a right one (a flat end).
    """
    normals, _ = triangles.planes(mesh.corners)
    label = _faces(mesh, normals, _SMOOTH)
    count = np.bincount(label)
    total = np.stack([np.bincount(label, normals[:, k]) for k in range(3)], 1)
    mean = total / count[:, None]
    off = normals - mean[label]
    spread = np.zeros((len(count), 3, 3))
    np.add.at(spread, label, off[:, :, None] * off[:, None, :])
    values, axes = np.linalg.eigh(spread)
    along = np.abs(triangles.dot(axes[:, :, 0], mean))
    cone = (count >= _LEAST) & (along > _CONES[0]) & (along < _CONES[1])
    cone &= (values[:, 0] / count < _ROUND**2) & (values[:, 1] / count > _ROUND**2)
    rows = np.flatnonzero(cone[label] & (normals[:, 2] < 0))
    if not len(rows):
        return None
    worst = rows[normals[rows, 2].argmin()]
    return float(np.degrees(np.arcsin(-normals[worst, 2]))), mesh.corners[worst].mean(0)


def _is_behind(scene: "Scene", one: NDArray, other: NDArray) -> NDArray:
    """Whether some of each triangle ``other`` lies behind the plane of triangle ``one``."""
    return scene.above(other, one)[0] < -_BEHIND


def _opposite(scene: "Scene", first: NDArray, second: NDArray) -> NDArray:
    """Whether the shadows of two triangles on the plane of the first one overlap: (n,) bool."""
    one, other = scene.corners[first], scene.corners[second]
    normal = scene.normals[first]
    apart = np.zeros(len(first), bool)
    for corners in (one, other):
        for k in range(3):
            across = triangles.cross(normal, corners[:, (k + 1) % 3] - corners[:, k])[:, :, None]
            a, b = (np.matmul(points, across)[..., 0] for points in (one, other))
            apart |= triangles.most_of_three(a) <= triangles.least_of_three(b)
            apart |= triangles.most_of_three(b) <= triangles.least_of_three(a)
    return ~apart


def _faces(mesh: "Mesh", normals: NDArray, alike: float) -> NDArray:
    """Label (t,) of the face of every triangle: neighbours whose normals are alike are one."""
    edges = np.sort(half_edges(mesh.triangles), 1)
    order = np.lexsort(edges.T)
    same = np.flatnonzero((np.diff(edges[order], axis=0) == 0).all(1))
    first, second = order[same] // 3, order[same + 1] // 3
    joined = triangles.dot(normals[first], normals[second]) > alike
    first, second = first[joined], second[joined]
    every = np.arange(len(mesh.triangles))
    rows = np.concatenate([np.stack([every] * 3, 1), np.stack([first, second, second], 1)])
    return component_labels(rows, len(every))[: len(every)]


def _meet(indices: NDArray, faces: Any, first: int, second: int) -> bool:
    """Whether the faces of two triangles have a corner in common: they end in a sharp edge."""
    corners = [np.unique(indices[faces == faces[k]]) for k in (first, second)]
    return bool(np.isin(*corners).any())
