# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies as Coin nodes made from meshes: faces, edges and points, one place and one colour a body.

FreeCAD's own drawing of a shape takes its time for every face, and a tube has tens of thousands.
Here copies share their triangles, and a body that only moves gets another matrix.
"""

from functools import lru_cache

import numpy as np
import PartGui  # noqa: F401  makes its nodes known to Coin
from pivy import coin

from ..solids.mesh import half_edges
from ..solids.tessellation import VIEW, shared

_FLIP = np.diag([1.0, 1.0, -1.0, 1.0])
_REMEMBERED = 1000  # meshes as nodes


def meshed(shape):
    """What `BodyNodes.show` draws of a solid: its `Meshed` and the matrix (4, 4) that places it."""
    return shared(*VIEW).meshed(shape)


class BodyNodes:
    """Three nodes to show, each of all bodies: ``faces``, ``lines`` and ``points``.

    Body k is named ``Solid{k + 1}``, part k of what can be selected, coloured by ``materials[k]``
    and moved by ``transforms[k]`` from where it was shown. ``fast``: without what is hidden in the
    hinges, and without the insides that one sees where a body is cut open.
    """

    def __init__(self, fast=False):
        self.fast = fast
        self.faces, self.lines, self.points = (coin.SoSeparator() for _ in range(3))
        self.line_style, self.line_colour = coin.SoDrawStyle(), coin.SoBaseColor()
        self.point_style, self.point_colour = coin.SoDrawStyle(), coin.SoBaseColor()
        self._bodies = [coin.SoGroup() for _ in range(3)]
        self._set_up()
        self.transforms, self.materials, self._places, self._shown = [], [], [], []

    def show(self, bodies):
        """Draw bodies, (`Meshed`, matrix (4, 4)) of each; if they are the same, only move them."""
        drawn, places = [], []
        for mesh, matrix in bodies:
            is_mirrored = np.linalg.det(matrix[:3, :3]) < 0  # a matrix that mirrors turns faces out
            drawn.append(_drawing(mesh, is_mirrored))
            places.append(matrix @ _FLIP if is_mirrored else matrix)
        if [id(d) for d in drawn] != [id(d) for d in self._shown]:
            self._make(drawn)
        for node, place in zip(self._places, places, strict=True):
            node.matrix = sb_matrix(place)

    def colour(self, colours, transparency=0.0):
        """RGB of every body, or one for all; ``transparency`` 0…1."""
        for k, material in enumerate(self.materials):
            material.diffuseColor.setValue(*colours[k if len(colours) > 1 else 0])
            material.transparency = transparency

    def _set_up(self):
        """What holds for all bodies."""
        hints, binding, light = coin.SoShapeHints(), coin.SoNormalBinding(), coin.SoLightModel()
        binding.value = coin.SoNormalBinding.PER_VERTEX_INDEXED
        light.model = coin.SoLightModel.BASE_COLOR
        hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
        shape_type = "SOLID" if self.fast else "UNKNOWN_SHAPE_TYPE"
        hints.shapeType = getattr(coin.SoShapeHints, shape_type)
        offset = coin.SoPolygonOffset()  # edges are drawn in front of the faces that they bound
        offset.factor, offset.units = 1.0, 1.0
        before = (
            (hints, binding, offset),
            (light, self.line_style, self.line_colour),
            (light, self.point_style, self.point_colour),
        )
        for root, nodes, bodies in zip(
            (self.faces, self.lines, self.points), before, self._bodies, strict=True
        ):
            for node in (*nodes, bodies):
                root.addChild(node)

    def _make(self, drawn):
        self._shown = drawn
        for group in self._bodies:
            group.removeAllChildren()
        nodes = coin.SoMatrixTransform, coin.SoMatrixTransform, coin.SoMaterial
        made = [[node() for _ in drawn] for node in nodes]
        self.transforms, self._places, self.materials = made
        for k, drawing in enumerate(drawn):
            material = self.materials[k]
            material.specularColor.setValue(0.1, 0.1, 0.1)
            parts = (
                (material, *drawing.corners, drawing.face_set(k, len(drawn), self.fast)),
                (drawing.corners[0], drawing.line_set),
                (drawing.corners[0], drawing.point_set),
            )
            for group, own in zip(self._bodies, parts, strict=True):
                body = coin.SoSeparator()
                body.setName(f"Solid{k + 1}")
                for node in (self.transforms[k], self._places[k], *own):
                    body.addChild(node)
                group.addChild(body)


@lru_cache(maxsize=_REMEMBERED)
def _drawing(mesh, is_mirrored):
    return _Drawing(mesh, is_mirrored)


class _Drawing:
    """Nodes of one mesh, which its copies share; each face has vertices of its own."""

    def __init__(self, meshed, is_mirrored):
        mesh = meshed.mesh.moved(_FLIP) if is_mirrored else meshed.mesh
        count = len(mesh.vertices)
        codes, corners = np.unique(
            meshed.faces[:, None] * count + mesh.triangles, return_inverse=True
        )
        vertices, self._triangles = mesh.vertices[codes % count], corners.reshape(-1, 3)
        place, normal = coin.SoCoordinate3(), coin.SoNormal()
        fill(place.point, vertices)
        fill(normal.vector, _normals(vertices, self._triangles))
        self.corners = place, normal
        edges, beside = _edges(mesh.triangles, meshed.faces)
        self._is_hidden = np.isin(meshed.faces, _hidden(beside, meshed.cones))
        at = np.zeros(count, int)
        at[codes % count] = np.arange(len(codes))
        self.line_set, self.point_set = coin.SoIndexedLineSet(), coin.SoPointSet()
        fill(self.line_set.coordIndex, _closed(at[edges]))

    def face_set(self, number, count, fast):
        """Faces of body ``number``: a part to be selected among empty ones for the others."""
        triangles = self._triangles[~self._is_hidden] if fast else self._triangles
        node = coin.SoType.fromName("SoBrepFaceSet").createInstance()
        fill(node.coordIndex, _closed(triangles))
        parts = np.zeros(count, np.int32)
        parts[number] = len(triangles)
        fill(node.partIndex, parts)
        return node


def fill(field, values):
    """Give a field of many values these ones."""
    values = np.ascontiguousarray(values, np.float32 if values.dtype.kind == "f" else np.int32)
    field.setNum(len(values))
    field.setValues(0, len(values), values)


def sb_matrix(matrix):
    """Coin's matrix, which multiplies from the other side."""
    return coin.SbMatrix(*np.asarray(matrix).T.ravel().tolist())


def _closed(rows):
    """Indices, each row ended by −1."""
    return np.pad(rows, ((0, 0), (0, 1)), constant_values=-1).ravel()


def _normals(vertices, triangles):
    """Unit normals (v, 3): means over the triangles at a vertex, which all lie on one face."""
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    across = np.repeat(np.cross(b - a, c - a), 3, axis=0)
    total = np.stack(
        [np.bincount(triangles.ravel(), across[:, k], len(vertices)) for k in range(3)], 1
    )
    return total / np.maximum(np.linalg.norm(total, axis=1, keepdims=True), 1e-12)


def _edges(triangles, faces):
    """Pairs (e, 2) of vertices where two faces meet, and pairs (e, 2) of these faces."""
    pairs = np.sort(half_edges(triangles), 1)
    codes = pairs[:, 0].astype(np.int64) * (triangles.max() + 1) + pairs[:, 1]
    order = np.argsort(codes, kind="stable")
    codes, owner = codes[order], np.repeat(faces, 3)[order]
    border = np.flatnonzero((codes[1:] == codes[:-1]) & (owner[1:] != owner[:-1]))
    return pairs[order[border]], np.stack([owner[border], owner[border + 1]], 1)


def _hidden(beside, cones):
    """Faces in the hinges: cones and what borders on nothing but cones, their tips."""
    both = np.concatenate([beside, beside[:, ::-1]])
    others = both[~np.isin(both[:, 1], cones), 0]
    return np.setdiff1d(both[:, 0], np.setdiff1d(others, cones))
