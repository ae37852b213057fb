# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a print on edge is turned about its stack so that the least of it begins in mid-air.

Judged on the meshes alone, for many turns at once: every lowest corner of a body is an island of
some layer, and every face that looks straight down a ledge. Only turns that stand on as much of the
bed as the unturned print count: one on a corner would fall over.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..meshes import Mesh, PlacedMesh, half_edges
from .tying import tied

_DOWN = 0.99  # cosine from which a face looks straight down
_LEDGE = 2.5  # mm² of such faces that want one tie
_STANDS = 0.9  # of the unturned print's area on the bed
_TRIED = 3  # turns that are tied to see
LEFT = 1.0  # mm² of a unit that may begin in mid-air
_SURE = 0.8  # of that: layers and meshes differ by a little
_WIDER = 1.2  # how much wider than the unturned print it may be
_EDGE = 3.0  # mm²: from which a face is an edge to stand on
_ON_BED = 0.3  # mm above the lowest corner of all: printed on the bed
_TILT = 1e-4  # lets one corner of a flat edge be its lowest


def standing(turn: float = 0.0) -> NDArray:
    """Rotation (4, 4) from the flat print to the one on edge, turned about its stack (radians).

    Without a turn x of the flat print points up; with one the direction at −turn from x does.
    """
    c, s = float(np.cos(turn)), float(np.sin(turn))
    on_edge = np.array([[0.0, 0, -1, 0], [0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
    return on_edge @ np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


class Wanted(NamedTuple):
    """Of every turn (t,): about how many ties it wants, ``area`` on the bed, ``size`` (t, 2) mm.

    ``size``: height, and width upright to the stack.
    """

    ties: NDArray
    area: NDArray
    size: NDArray


def edges_of(bodies: Sequence[PlacedMesh]) -> NDArray:
    """Turns (t,) radians with which an edge of the print lies flat on the bed, 0 first."""
    found = set()
    for body in bodies:
        areas = _areas(body.placed)
        upright = np.abs(areas[:, 2]) < 1e-6
        kept = areas[upright & (np.linalg.norm(areas, axis=1) > _EDGE)]
        found |= set(np.round(np.degrees(np.arctan2(kept[:, 1], -kept[:, 0])) % 360, 1).tolist())
    return np.radians([0.0, *sorted(found - {0.0, 360.0})])


def _areas(mesh: Mesh) -> NDArray:
    """(t, 3) vector areas of triangles, mm²."""
    a, b, c = np.moveaxis(mesh.corners, 1, 0)
    return np.cross(b - a, c - a) / 2


def wanted(bodies: Sequence[PlacedMesh], turns: NDArray) -> Wanted:
    """`Wanted` of the flat print's ``bodies`` with ``turns`` (t,), radians."""
    up = np.stack([np.cos(turns), -np.sin(turns)])
    aside = np.stack([np.sin(turns), np.cos(turns)])
    placed = [body.placed for body in bodies]
    points = np.concatenate([mesh.vertices[:, :2] for mesh in placed])
    heights = points @ up
    size = np.stack([np.ptp(heights, axis=0), np.ptp(points @ aside, axis=0)], 1)
    bed = heights.min(0) + _ON_BED
    count, area = np.zeros(len(turns)), np.zeros(len(turns))
    for mesh in placed:
        plan = mesh.vertices[:, :2]
        z = plan @ up + _TILT * mesh.vertices[:, 2:] + _TILT**2 * (plan @ aside)
        edges = half_edges(mesh.triangles)
        lowest = np.full(z.shape, np.inf)
        np.minimum.at(lowest, edges[:, 0], z[edges[:, 1]])
        count += ((z < lowest) & (z > bed)).sum(0)
        areas = _areas(mesh)
        down = -areas[:, :2] @ up
        flat = down > _DOWN * np.linalg.norm(areas, axis=1)[:, None]
        is_above = plan[mesh.triangles[:, 0]] @ up > bed
        count += (down * (flat & is_above)).sum(0) / _LEDGE
        area += (down * (flat & ~is_above)).sum(0)
    return Wanted(count, area, size)


def likely_turns(bodies: Sequence[PlacedMesh]) -> NDArray:
    """Turns (t,) radians that want the fewest ties, first the best, and none: `_TRIED` at most.

    Those that make the print no higher, hardly wider, and stand as firmly as none.
    """
    turns = edges_of(bodies)
    found = wanted(bodies, turns)
    fits = (found.size <= found.size[0] * [1, _WIDER] + 1e-6).all(1)
    fits &= found.area >= _STANDS * found.area[0]
    order = [k for k in np.argsort(found.ties, kind="stable") if fits[k] and k]
    return turns[[*order[: _TRIED - 1], 0]]


def best_turn(bodies: Sequence[PlacedMesh], layer_height: float, neck: float) -> float:
    """The most likely turn (radians) with which ties leave next to nothing in the air.

    Tried on the first unit of the flat print's ``bodies``; ``layer_height`` and ``neck`` mm. Where
    none does, the one that leaves least.
    """
    first = [body for body in bodies if body.unit == bodies[0].unit]
    left = []
    turns = likely_turns(bodies).tolist()
    for turn in turns:
        left.append(tied(on_bed(first, turn), layer_height, neck).left_area)
        if left[-1] <= _SURE * LEFT:
            return turn
    return turns[int(np.argmin(left))]


def on_bed(bodies: Sequence[PlacedMesh], turn: float) -> list[PlacedMesh]:
    """Bodies of the flat print as they stand on edge, turned about the stack (radians)."""
    move = standing(turn)
    stood = [body._replace(place=move @ body.place) for body in bodies]
    lift = np.eye(4)
    lift[2, 3] = -min(body.placed.bounds[0][2] for body in stood)
    return [body._replace(place=lift @ body.place) for body in stood]
