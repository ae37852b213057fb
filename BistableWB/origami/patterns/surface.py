# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels of a tube as one surface: outward faces, edges and fold angles.

A unit is a closed surface (10 vertices, 12 faces, 20 edges). Where zero-thickness units share a
contact panel, the panel is one face, a *wall* inside the tube: all other faces are again one closed
surface, and every edge is a fold of it. Files and crease patterns read it.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..units.closed_forms import plane_unit
from ..units.creases import INDEX, PANELS, VERTICES, layer_of

if TYPE_CHECKING:
    from ..units.tube import Tube

# Corners of neighbouring units nearer to each other than this share of ‖AB‖ are one vertex.
_SAME = 1e-6
# A fold angle (radians) this near to 180° takes its sign from the deployed state.
_FOLDED = 1e-6


def _outward_loops() -> dict[str, tuple[str, ...]]:
    """Corner names of every panel, anticlockwise seen from outside the tube.

    hinges.md 1: the inside is between layers 1 and 2 and between 3 and 4, +y of the flat frame
    is up; the corners turn the same way in all units (`shape.check_shape`).
    """
    plan = plane_unit(0.7, 0.6, 1.0, 0.4).flat[:, [0, 2]]
    loops = {}
    for name, corners in PANELS.items():
        x, z = plan[[INDEX[v] for v in corners]].T
        seen_from_above = (x * np.roll(z, -1) - z * np.roll(x, -1)).sum() < 0
        keep = seen_from_above == (layer_of(name) in (2, 4))
        loops[name] = corners if keep else corners[::-1]
    return loops


OUTWARD = _outward_loops()


def _unit_edges() -> dict[tuple[str, str], tuple[str, str]]:
    """The 20 edges as (start, end): (panel on the left of it, panel on the right)."""
    left = {}
    for name, loop in OUTWARD.items():
        for a, b in zip(loop, (*loop[1:], loop[0]), strict=True):
            left[a, b] = name
    return {(a, b): (p, left[b, a]) for (a, b), p in left.items() if INDEX[a] < INDEX[b]}


EDGES = _unit_edges()


@dataclass(frozen=True)
class Surface:
    """Surface of a tube of n units; panels that two units share are there once.

    ``corners`` (n, 10): vertex numbers, columns in the order of `VERTICES`; ``faces``: vertex
    numbers of every face, anticlockwise from outside (walls: seen from the next unit);
    ``panels``: (unit, panel name) of every face, ``shared``: the same of the face that coincides
    with it, or None; ``edges`` (e, 2): vertex numbers; ``sides`` (e, 2): the surface's face on the
    left and on the right of every edge, seen from outside; ``walls``: for every edge, the walls
    that end on it.
    """

    corners: np.ndarray
    faces: tuple
    panels: tuple
    shared: tuple
    edges: np.ndarray
    sides: np.ndarray
    walls: tuple

    @property
    def is_manifold(self) -> bool:
        """Whether no unit shares a panel with another."""
        return not any(self.walls)

    def points(self, states: NDArray) -> NDArray:
        """Vertices (v, 3) from those of all units (n, 10, 3)."""
        found = np.empty((self.corners.max() + 1, 3))
        for numbers, points in zip(self.corners[::-1], np.asarray(states)[::-1], strict=True):
            found[numbers] = points  # where units meet, the first one counts
        return found

    def normals(self, points: NDArray) -> NDArray:
        """Unit normals (f, 3) of all faces, outwards."""
        normals = []
        for face in self.faces:
            ring = points[list(face)]
            across = np.cross(ring[1] - ring[0], ring[-1] - ring[0])
            if len(face) == 4:  # along both diagonals, should it be bent
                across = np.cross(ring[2] - ring[0], ring[3] - ring[1])
            normals.append(across / np.linalg.norm(across))
        return np.array(normals)

    def fold_angles(self, points: NDArray, deployed: NDArray) -> NDArray:
        """Fold angles (e,) in radians of the surface at ``points`` (v, 3): 0 is unfolded.

        Positive where the surface is hollow (a valley seen from outside), negative at ridges.
        At ±π, where both are the same place, the ``deployed`` vertices (v, 3) give the sign.
        """
        angles = self._angles(points)
        turned = np.abs(angles) > np.pi - _FOLDED
        return np.where(turned, np.copysign(np.abs(angles), self._angles(deployed)), angles)

    def _angles(self, points: NDArray) -> NDArray:
        normals = self.normals(points)
        along = points[self.edges[:, 1]] - points[self.edges[:, 0]]
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        left, right = normals[self.sides[:, 0]], normals[self.sides[:, 1]]
        ridge = (np.cross(left, right) * along).sum(1)
        return -np.arctan2(ridge, (left * right).sum(1))


def surface_of(tube: "Tube") -> Surface:
    """`Surface` of a `tube.Tube`.

    Units of a placement with a pitch stand apart by their blocks and share nothing.
    """
    incoming = ["left" if left else "right" for left in tube.incoming_left]
    corners, joined = _corners(tube, incoming)
    faces: Any
    faces, panels, shared, walls = [], [], [], set()
    for k, side in enumerate(incoming):
        for name, loop in OUTWARD.items():
            if name == f"contact_{side}" and joined[k]:
                continue
            is_wall = name.startswith("contact") and name != f"contact_{side}" and joined[k + 1]
            if is_wall:
                walls.add(len(faces))
            faces.append(tuple(corners[k, [INDEX[v] for v in loop]].tolist()))
            panels.append((k, name))
            shared.append((k + 1, f"contact_{incoming[k + 1]}") if is_wall else None)
    edges, sides, ends = _edges(faces, walls)
    return Surface(corners, tuple(faces), tuple(panels), tuple(shared), edges, sides, ends)


def _corners(tube: "Tube", incoming: Sequence[str]) -> tuple[NDArray, list[bool]]:
    """Vertex numbers (n, 10), and whether the contact before unit k (0…n) is shared."""
    count, deployed = len(tube), tube.deployed()
    near = _SAME * tube.unit.edge_length
    corners, joined = np.full((count, len(VERTICES)), -1), [False] * (count + 1)
    following = 0
    for k in range(count):
        if k:
            here, there = _meeting(incoming[k - 1], incoming[k])
            apart = np.linalg.norm(deployed[k, there] - deployed[k - 1, here], axis=1).max()
            joined[k] = bool(apart < near)
            if joined[k]:
                corners[k, there] = corners[k - 1, here]
        new = np.flatnonzero(corners[k] < 0)
        corners[k, new] = following + np.arange(len(new))
        following += len(new)
    return corners, joined


def _meeting(side_before: str, side: str) -> tuple[list[int], list[int]]:
    """Rows of the outgoing contact's corners of a unit, and of the same points of the next."""
    leaving = "right" if side_before == "left" else "left"
    here = [f"A_{leaving}_upper", f"A_{leaving}_lower", "B_upper", "B_lower"]
    there = ["B_upper", "B_lower", f"A_{side}_upper", f"A_{side}_lower"]
    return [INDEX[v] for v in here], [INDEX[v] for v in there]


def _edges(
    faces: Sequence[Sequence[int]], walls: set[int]
) -> tuple[NDArray, NDArray, tuple[tuple[int], ...]]:
    """Edges (e, 2), surface faces on both sides (e, 2), walls that end on each edge."""
    around: dict[Any, Any] = {}
    for f, face in enumerate(faces):
        for a, b in zip(face, (*face[1:], face[0]), strict=True):
            around.setdefault((min(a, b), max(a, b)), []).append((f, a < b))
    sides, ends = [], []
    for found in around.values():
        left = [f for f, forward in found if forward and f not in walls]
        right = [f for f, forward in found if not forward and f not in walls]
        sides.append((*left, *right))
        ends.append(tuple(sorted({f for f, _ in found if f in walls})))
    return np.array(list(around)), np.array(sides), tuple(ends)
