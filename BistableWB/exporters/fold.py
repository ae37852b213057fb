# SPDX-License-Identifier: LGPL-2.1-or-later
"""FOLD 1.2: the zero-thickness tube, deployed (key frame), flat-folded, and the way between.

A tube cannot be unfolded into one sheet, so no frame is a crease pattern: all are folded forms.
Signs are as seen from outside: mountains are ridges. In the flat frame an edge that is not folded
there (a panel beside its neighbour in one layer) is "F"; everything else keeps its sign.
Millimetres, degrees. Own keys carry the prefix ``bistable:``; `imports.fold` reads them back.
"""

import json

import numpy as np

from .. import __version__
from ..origami import rigid
from ..origami.creases import layer_of
from ..origami.nets import overlap
from ..origami.skin import skin_of
from .thin import thin_models

_UNFOLDED = 1e-6  # degrees
_PLANAR = 1e-6  # mm


def write(bodies, path, deployment_frames=None, author="", title=""):
    """Write the tubes of ``bodies``.

    ``deployment_frames``: number of states between flat and deployed for a series of frames that
    also holds both ends (default: no series); ``author`` and ``title`` go into the file.
    """
    if deployment_frames is not None and not 0 <= int(deployment_frames) <= 10_000:
        raise ValueError(
            f"deployment_frames is {deployment_frames}: give a number of states from 0 to 10000."
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
    """One tube of the file, its skin, and where its numbers start."""

    def __init__(self, name, tube, frame):
        self.name, self.tube, self.frame = name, tube, frame
        self.skin = skin_of(tube)
        self.deployed = self.points(1.0)

    def points(self, opening):
        return rigid.apply(self.frame, self.skin.points(self.tube.state(opening)))

    def flat(self):
        """Flat vertices in the plane of the print: x along A-B, z up the stack."""
        points = self.points(0.0)
        side = "left" if self.tube.incoming_left[0] else "right"
        first = self.skin.panels.index((0, f"contact_{side}"))
        down = self.skin.normals(points)[first]
        a, b = (self.skin.corners[0, v] for v in (2 if side == "left" else 4, 0))
        along = points[b] - points[a]
        along /= np.linalg.norm(along)
        axes = np.stack([along, np.cross(-down, along), -down])
        return (points - points[a]) @ axes.T

    def assigned(self, points):
        """Fold angles in degrees and the assignments that go with them."""
        angles = np.degrees(self.skin.fold_angles(points, self.deployed))
        angles[np.abs(angles) < _UNFOLDED] = 0.0
        return angles.tolist(), ["FVM"[int(np.sign(a))] for a in angles]

    def ranks(self):
        """Place of every face in the stack of the flat state, from below."""
        found = []
        for (k, panel), shared in zip(self.skin.panels, self.skin.shared, strict=True):
            layer = layer_of(panel)
            up = layer if self.tube.incoming_left[k] else 5 - layer
            found.append(4 * k + up + (0.5 if shared else 0.0))
        return found


def _joined(parts, rows_of, offset_of=None):
    """Rows of all parts; their numbers moved on by the ``offset_of`` earlier parts."""
    rows, start = [], 0
    for part in parts:
        for row in rows_of(part):
            rows.append([start + int(i) for i in row] if offset_of else row)
        start += offset_of(part) if offset_of else 0
    return rows


def _vertex_count(part):
    return len(part.deployed)


def _face_count(part):
    return len(part.skin.faces)


def _edge_count(part):
    return len(part.skin.edges)


def _key_frame(parts):
    manifold = all(part.skin.is_manifold for part in parts)
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
        "edges_vertices": _joined(parts, lambda p: p.skin.edges, _vertex_count),
        "edges_faces": _joined(parts, _faces_around, _face_count),
        **_folds(parts, [part.deployed for part in parts]),
        "edges_length": [x for part in parts for x in _lengths(part)],
        "faces_vertices": _joined(parts, lambda p: p.skin.faces, _vertex_count),
        "faces_edges": _joined(parts, _edges_round, _edge_count),
        "faces_bistable:panel": [
            " = ".join(f"unit {k + 1} {name}" for k, name in filter(None, both))
            for part in parts
            for both in zip(part.skin.panels, part.skin.shared, strict=True)
        ],
        "bistable:units": _units(parts),
    }  # fmt: skip


def _folds(parts, points):
    found = [part.assigned(p) for part, p in zip(parts, points, strict=True)]
    return {
        "edges_assignment": [a for _, assigned in found for a in assigned],
        "edges_foldAngle": [a for angles, _ in found for a in angles],
    }


def _flat_frame(parts):
    points = [part.flat() for part in parts]
    planar = max(np.abs(p[:, 2]).max() for p in points) < _PLANAR
    if planar:
        for p in points:
            p[:, 2] = 0.0
    manifold = all(part.skin.is_manifold for part in parts)
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


def _series_frame(parts, opening):
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


def _coordinates(points):
    return [(p + 0.0).tolist() for part in points for p in part]


def _lengths(part):
    a, b = part.deployed[part.skin.edges.T]
    return np.linalg.norm(b - a, axis=1).tolist()


def _faces_around(part):
    """Faces at every edge: left and right, or all of them anticlockwise about the edge."""
    skin, points = part.skin, part.deployed
    middles = np.array([points[list(face)].mean(0) for face in skin.faces])
    for (a, b), sides, walls in zip(skin.edges, skin.sides, skin.walls, strict=True):
        if not walls:
            yield sides
            continue
        around = [*sides, *walls]
        axis = (points[b] - points[a]) / np.linalg.norm(points[b] - points[a])
        arms = middles[around] - points[a]
        arms -= np.outer(arms @ axis, axis)
        turns = np.arctan2(np.cross(arms[0], arms) @ axis, arms @ arms[0])
        yield [around[i] for i in np.argsort(turns % (2 * np.pi))]


def _edges_round(part):
    """Edges of every face, the first from its first to its second corner."""
    number = {frozenset(edge): i for i, edge in enumerate(part.skin.edges.tolist())}
    for face in part.skin.faces:
        following = (*face[1:], face[0])
        yield [number[frozenset(pair)] for pair in zip(face, following, strict=True)]


def _face_orders(parts, points):
    """[f, g, s] of all pairs of faces of a unit or of neighbouring units that overlap when flat."""
    orders, start = [], 0
    for part, flat in zip(parts, points, strict=True):
        polygons = [flat[list(face)] @ [1, 1j, 0] for face in part.skin.faces]
        upwards = part.skin.normals(flat)[:, 2] > 0
        ranks, units = part.ranks(), [k for k, _ in part.skin.panels]
        for f, polygon in enumerate(polygons):
            for g in range(f):
                if units[f] - units[g] <= 1 and overlap(polygon, polygons[g]):
                    above = ranks[f] > ranks[g]
                    orders.append([start + f, start + g, 1 if above == upwards[g] else -1])
        start += len(polygons)
    return orders


def _units(parts):
    """What `imports.fold` reads: one entry a unit."""
    entries, start = [], 0
    for part in parts:
        unit = part.tube.unit
        omega = np.pi / 2 if unit.omega is None else unit.omega
        omegas = np.broadcast_to(np.degrees(omega), len(unit))
        for k, corners in enumerate(part.skin.corners):
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


def _text(value, indent=""):
    """JSON with one key, and one row of a table, a line."""
    inner = indent + " "
    if isinstance(value, dict) and any(map(_is_table, value.values())):
        rows = [f"{json.dumps(k)}: {_text(v, inner)}" for k, v in value.items()]
        return "{\n" + ",\n".join(inner + row for row in rows) + f"\n{indent}}}"
    if _is_table(value):
        return "[\n" + ",\n".join(inner + _text(v, inner) for v in value) + f"\n{indent}]"
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def _is_table(value):
    return isinstance(value, list) and value and isinstance(value[0], list | dict)
