# SPDX-License-Identifier: LGPL-2.1-or-later
"""FOLD 1.2: the zero-thickness tube, deployed (key frame), flat-folded, and the way between.

A tube cannot be unfolded into one sheet, so no frame is a crease pattern: all are folded forms.
Signs are as seen from outside: mountains are ridges. In the flat frame an edge that is not folded
there (a panel beside its neighbour in one layer) is "F"; everything else keeps its sign.
Millimetres, degrees. Own keys carry the prefix ``bistable:``; `imports.fold` reads them back.
"""

import json
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import __version__
from ..origami import rigid
from ..origami.errors import Refusal
from ..origami.patterns.nets import overlap
from ..origami.patterns.surface import surface_of
from ..origami.units.creases import layer_of
from .thin import thin_models

if TYPE_CHECKING:
    from ..origami.units.tube import Tube

_UNFOLDED = 1e-6  # degrees
_PLANAR = 1e-6  # mm


def write(
    bodies: Sequence[Any],
    path: Path,
    deployment_frames: int | None = None,
    author: str = "",
    title: str = "",
) -> None:
    """Write the tubes of ``bodies``.

    ``deployment_frames``: number of states between flat and deployed for a series of frames that
    also holds both ends (default: no series); ``author`` and ``title`` go into the file.
    """
    if deployment_frames is not None and not 0 <= int(deployment_frames) <= 10_000:
        raise Refusal(
            "deployment_frames is {deployment_frames}: give a number of states from 0 to 10000.",
            deployment_frames=deployment_frames,
        )
    parts = [_Part(*model) for model in thin_models(bodies)]
    names = ", ".join(part.name for part in parts)
    content = {
        "file_spec": 1.2,
        "file_creator": f"Bistable Workbench {__version__}",
        "file_author": author,
        "file_title": title or names,
        "file_description": "Bistable, flat-foldable tube of rigid panels without thickness: the "
        "deployed and the flat-folded state.",
        "file_classes": ["singleModel" if len(parts) == 1 else "multiModel"],
        **_key_frame(parts),
        "file_frames": [_flat_frame(parts)],
    }
    if deployment_frames is not None:
        content["file_classes"].append("animation")
        series = np.linspace(0, 1, int(deployment_frames) + 2)
        content["file_frames"] += [_series_frame(parts, float(s)) for s in series]
    path.write_text(_text(content) + "\n", encoding="utf-8")


class _Part:
    """One tube of the file, its surface, and where its numbers start."""

    def __init__(self, name: str, tube: "Tube", frame: NDArray) -> None:
        self.name, self.tube, self.frame = name, tube, frame
        self.surface = surface_of(tube)
        self.deployed = self.points(1.0)

    def points(self, opening: float) -> NDArray:
        return rigid.apply(self.frame, self.surface.points(self.tube.state(opening)))

    def flat(self) -> NDArray:
        """Flat vertices in the plane of the print: x along A-B, z up the stack."""
        points = self.points(0.0)
        side = "left" if self.tube.incoming_left[0] else "right"
        first = self.surface.panels.index((0, f"contact_{side}"))
        down = self.surface.normals(points)[first]
        a, b = (self.surface.corners[0, v] for v in (2 if side == "left" else 4, 0))
        along = points[b] - points[a]
        along /= np.linalg.norm(along)
        axes = np.stack([along, np.cross(-down, along), -down])
        return (points - points[a]) @ axes.T

    def assigned(self, points: NDArray) -> tuple[list[float], list[str]]:
        """Fold angles in degrees and the assignments that go with them."""
        angles = np.degrees(self.surface.fold_angles(points, self.deployed))
        angles[np.abs(angles) < _UNFOLDED] = 0.0
        return angles.tolist(), ["FVM"[int(np.sign(a))] for a in angles]

    def ranks(self) -> list[float]:
        """Place of every face in the stack of the flat state, from below."""
        found = []
        for (k, panel), shared in zip(self.surface.panels, self.surface.shared, strict=True):
            layer = layer_of(panel)
            up = layer if self.tube.incoming_left[k] else 5 - layer
            found.append(4 * k + up + (0.5 if shared else 0.0))
        return found


def _joined(
    parts: Sequence[_Part], rows_of: Callable[..., Any], offset_of: Callable[..., Any] | None = None
) -> list[list[int]]:
    """Rows of all parts; their numbers moved on by the ``offset_of`` earlier parts."""
    rows, start = [], 0
    for part in parts:
        for row in rows_of(part):
            rows.append([start + int(i) for i in row] if offset_of else row)
        start += offset_of(part) if offset_of else 0
    return rows


def _vertex_count(part: _Part) -> int:
    return len(part.deployed)


def _face_count(part: _Part) -> int:
    return len(part.surface.faces)


def _edge_count(part: _Part) -> int:
    return len(part.surface.edges)


def _key_frame(parts: Sequence[_Part]) -> dict[str, Any]:
    manifold = all(part.surface.is_manifold for part in parts)
    return {
        "frame_title": "deployed",
        "frame_classes": ["foldedForm"],
        "frame_attributes": [
            "3D", *(["manifold", "orientable"] if manifold else ["nonManifold"]), "convexFaces",
            "nonSelfTouching", "nonSelfIntersecting",
        ],
        "frame_unit": "mm",
        "frame_bistable:opening": 1.0,
        "vertices_coords": _coordinates(part.deployed for part in parts),
        "edges_vertices": _joined(parts, lambda p: p.surface.edges, _vertex_count),
        "edges_faces": _joined(parts, _faces_around, _face_count),
        **_folds(parts, [part.deployed for part in parts]),
        "edges_length": [x for part in parts for x in _lengths(part)],
        "faces_vertices": _joined(parts, lambda p: p.surface.faces, _vertex_count),
        "faces_edges": _joined(parts, _edges_round, _edge_count),
        "faces_bistable:panel": [
            " = ".join(f"unit {k + 1} {name}" for k, name in filter(None, both))
            for part in parts
            for both in zip(part.surface.panels, part.surface.shared, strict=True)
        ],
        "bistable:units": _units(parts),
    }  # fmt: skip


def _folds(parts: Sequence[_Part], points: Sequence[NDArray]) -> dict[str, list[Any]]:
    found = [part.assigned(p) for part, p in zip(parts, points, strict=True)]
    return {
        "edges_assignment": [a for _, assigned in found for a in assigned],
        "edges_foldAngle": [a for angles, _ in found for a in angles],
    }


def _flat_frame(parts: Sequence[_Part]) -> dict[str, Any]:
    points = [part.flat() for part in parts]
    planar = max(np.abs(p[:, 2]).max() for p in points) < _PLANAR
    if planar:
        for p in points:
            p[:, 2] = 0.0
    manifold = all(part.surface.is_manifold for part in parts)
    return {
        "frame_parent": 0,
        "frame_inherit": True,
        "frame_title": "flat-folded",
        "frame_classes": ["foldedForm"],
        "frame_attributes": [
            "2D" if planar else "3D",
            *(["manifold", "orientable"] if manifold else ["nonManifold"]), "convexFaces",
            "selfTouching", "nonSelfIntersecting",
        ],
        "frame_bistable:opening": 0.0,
        "vertices_coords": _coordinates(points),
        **_folds(parts, points),
        "faceOrders": _face_orders(parts, points),
    }  # fmt: skip


def _series_frame(parts: Sequence[_Part], opening: float) -> dict[str, Any]:
    points = [part.points(opening) for part in parts]
    return {
        "frame_parent": 0,
        "frame_inherit": True,
        "frame_title": f"deployment {opening:.4g}",
        "frame_classes": ["foldedForm"],
        "frame_attributes": ["3D", "convexFaces"],
        "frame_bistable:opening": opening,
        "vertices_coords": _coordinates(points),
        **_folds(parts, points),
    }


def _coordinates(points: Iterator[Any] | Sequence[NDArray]) -> list[list[float]]:
    return [(p + 0.0).tolist() for part in points for p in part]


def _lengths(part: _Part) -> list[float]:
    a, b = part.deployed[part.surface.edges.T]
    return np.linalg.norm(b - a, axis=1).tolist()


def _faces_around(part: _Part) -> Iterator[NDArray | list[int]]:
    """Faces at every edge: left and right, or all of them anticlockwise about the edge."""
    surface, points = part.surface, part.deployed
    middles = np.array([points[list(face)].mean(0) for face in surface.faces])
    for (a, b), sides, walls in zip(surface.edges, surface.sides, surface.walls, strict=True):
        if not walls:
            yield sides
            continue
        around = [*sides, *walls]
        axis = (points[b] - points[a]) / np.linalg.norm(points[b] - points[a])
        arms = middles[around] - points[a]
        arms -= np.outer(arms @ axis, axis)
        turns = np.arctan2(np.cross(arms[0], arms) @ axis, arms @ arms[0])
        yield [around[i] for i in np.argsort(turns % (2 * np.pi))]


def _edges_round(part: _Part) -> Iterator[list[int]]:
    """Edges of every face, the first from its first to its second corner."""
    number = {frozenset(edge): i for i, edge in enumerate(part.surface.edges.tolist())}
    for face in part.surface.faces:
        following = (*face[1:], face[0])
        yield [number[frozenset(pair)] for pair in zip(face, following, strict=True)]


def _face_orders(parts: Sequence[_Part], points: Sequence[NDArray]) -> list[list[int]]:
    """[f, g, s] of all pairs of faces of a unit or of neighbouring units that overlap when flat."""
    orders, start = [], 0
    for part, flat in zip(parts, points, strict=True):
        polygons = [flat[list(face)] @ [1, 1j, 0] for face in part.surface.faces]
        upwards = part.surface.normals(flat)[:, 2] > 0
        ranks, units = part.ranks(), [k for k, _ in part.surface.panels]
        for f, polygon in enumerate(polygons):
            for g in range(f):
                if units[f] - units[g] <= 1 and overlap(polygon, polygons[g]):
                    above = ranks[f] > ranks[g]
                    orders.append([start + f, start + g, 1 if above == upwards[g] else -1])
        start += len(polygons)
    return orders


def _units(parts: Sequence[_Part]) -> list[dict[str, Any]]:
    """What `imports.fold` reads: one entry a unit."""
    entries, start = [], 0
    for part in parts:
        unit = part.tube.unit
        omega = np.pi / 2 if unit.omega is None else unit.omega
        omegas = np.broadcast_to(np.degrees(omega), len(unit))
        for k, corners in enumerate(part.surface.corners):
            entries.append(
                {
                    "object": part.name,
                    "unit": k + 1,
                    "vertices": (start + corners).tolist(),
                    "theta": float(np.degrees(np.atleast_1d(unit.theta)[k])),
                    "ratio": float(np.broadcast_to(unit.ratio, len(unit))[k]),
                    "omega": float(omegas[k]),
                    "edge_length": unit.edge_length,
                    "strip_height": unit.strip_height,
                }
            )
        start += len(part.deployed)
    return entries


def _text(value: Any, indent: str = "") -> str:
    """JSON with one key, and one row of a table, a line."""
    inner = indent + " "
    if isinstance(value, dict) and any(map(_is_table, value.values())):
        rows = [f"{json.dumps(k)}: {_text(v, inner)}" for k, v in value.items()]
        return "{\n" + ",\n".join(inner + row for row in rows) + f"\n{indent}}}"
    if _is_table(value):
        return "[\n" + ",\n".join(inner + _text(v, inner) for v in value) + f"\n{indent}]"
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def _is_table(value: Any) -> Any:
    return isinstance(value, list) and value and isinstance(value[0], list | dict)
