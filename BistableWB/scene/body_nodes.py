# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies as Coin nodes made from meshes: faces, edges and points, one place and one colour a body.

FreeCAD's own drawing of a shape takes its time for every face, and a tube has tens of thousands.
Here copies share their triangles, and a body that only moves gets another matrix.
"""

from functools import lru_cache

import numpy as np
import PartGui  # noqa: F401  makes its nodes known to Coin
from pivy import coin

from ..origami.meshes import half_edges
from ..solids.tessellation import VIEW, shared

_FLIP = np.diag([1.0, 1.0, -1.0, 1.0])
_REMEMBERED = 1000  # meshes as nodes
FULL, MOVING = 0, 1  # levels of detail


def meshed(shape):
    """What `BodyNodes.show` draws of a solid: its `Meshed` and the matrix (4, 4) that places it."""
    return shared(*VIEW).meshed(shape)


def prepare(shape):
    """Do all of `BodyNodes.show` for a solid that needs no nodes, in a thread beside the window."""
    mesh, matrix = meshed(shape)
    _sketch(mesh, bool(np.linalg.det(matrix[:3, :3]) < 0))


class BodyNodes:
    """Three nodes to show, each of all bodies: ``faces``, ``lines`` and ``points``.

    Body k is named ``Solid{k + 1}``, part k of what can be selected, coloured by ``materials[k]``,
    moved by ``transforms[k]`` from where it was shown. ``fast``: only faces, to look at, without
    what is hidden in the hinges and without the insides that one sees where a body is cut open;
    copies share their node.
    """

    def __init__(self, fast=False):
        self.fast = fast
        self.faces, self.lines, self.points = (coin.SoSeparator() for _ in range(3))
        self.line_style, self.line_colour = coin.SoDrawStyle(), coin.SoBaseColor()
        self.point_style, self.point_colour = coin.SoDrawStyle(), coin.SoBaseColor()
        self._bodies = [coin.SoGroup() for _ in range(2 if fast else 3)]
        self._set_up()
        self.transforms, self.materials, self._places, self._shown = [], [], [], []
        self._fields = []

    def show(self, bodies):
        """Draw bodies, (`Meshed`, matrix (4, 4)) of each; if they are the same, only move them."""
        for _ in self.showing(bodies):
            pass

    def showing(self, bodies):
        """`show` in steps: what was shown stays until the last of them."""
        drawn, places = [], []
        for mesh, matrix in bodies:
            is_mirrored = bool(np.linalg.det(matrix[:3, :3]) < 0)  # it turns faces out
            drawn.append(_drawing(mesh, is_mirrored))
            places.append(matrix @ _FLIP if is_mirrored else matrix)
            yield
        if [id(d) for d in drawn] != [id(d) for d in self._shown]:
            yield from self._make(drawn)
        for node, place in zip(self._places, places, strict=True):
            node.matrix = sb_matrix(place)

    def colour(self, colours, transparency=0.0):
        """RGB of every body, or one for all; ``transparency`` 0…1."""
        for k, material in enumerate(self.materials):
            material.diffuseColor.setValue(*colours[k if len(colours) > 1 else 0])
            material.transparency = transparency

    def move(self, matrices):
        """Put bodies to `SbMatrix` each, from where they were shown; None: it stays."""
        for field, matrix in zip(self._fields, matrices, strict=True):
            if matrix is not None:
                field.setValue(matrix)

    def detail(self, level):
        """Of ``fast`` nodes: `FULL`, or `MOVING` without the faces in the gaps of the hinges."""
        self._levels.whichChild = level

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
        below = self._bodies
        if self.fast:
            self._levels = coin.SoSwitch()
            for bodies in self._bodies:
                self._levels.addChild(bodies)
            self._levels.whichChild = FULL
            below = self._levels, coin.SoGroup(), coin.SoGroup()
        for root, nodes, bodies in zip(
            (self.faces, self.lines, self.points), before, below, strict=True
        ):
            for node in (*nodes, bodies):
                root.addChild(node)

    def _make(self, drawn):
        """Make nodes of all bodies beside those that are shown, in steps; then exchange them."""
        nodes = coin.SoMatrixTransform, coin.SoMatrixTransform, coin.SoMaterial
        transforms, places, materials = made = [[node() for _ in drawn] for node in nodes]
        separators = [[] for _ in self._bodies]
        for k, drawing in enumerate(drawn):
            materials[k].specularColor.setValue(0.1, 0.1, 0.1)
            if self.fast:
                parts = [(materials[k], drawing.shared(level)) for level in (FULL, MOVING)]
            else:
                parts = (
                    (materials[k], *drawing.corners, drawing.face_set(k, len(drawn))),
                    (drawing.corners[0], drawing.line_set),
                    (drawing.corners[0], drawing.point_set),
                )
            for found, own in zip(separators, parts, strict=True):
                body = coin.SoSeparator()
                if self.fast:  # it moves: what could be kept is below it
                    body.renderCaching = coin.SoSeparator.OFF
                body.setName(f"Solid{k + 1}")
                for node in (transforms[k], places[k], *own):
                    body.addChild(node)
                found.append(body)
            yield
        self._shown = drawn
        self.transforms, self._places, self.materials = made
        self._fields = [node.matrix for node in self.transforms]
        for group, found in zip(self._bodies, separators, strict=True):
            group.removeAllChildren()
            for body in found:
                group.addChild(body)


@lru_cache(maxsize=_REMEMBERED)
def _drawing(mesh, is_mirrored):
    return _Drawing(_sketch(mesh, is_mirrored))


@lru_cache(maxsize=_REMEMBERED)
def _sketch(mesh, is_mirrored):
    return _Sketch(mesh, is_mirrored)


class _Sketch:
    """The numbers of a drawing of one mesh; each face has vertices of its own."""

    def __init__(self, meshed, is_mirrored):
        mesh = meshed.mesh.moved(_FLIP) if is_mirrored else meshed.mesh
        count = len(mesh.vertices)
        codes, corners = np.unique(
            meshed.faces[:, None] * count + mesh.triangles, return_inverse=True
        )
        self.vertices, self.triangles = mesh.vertices[codes % count], corners.reshape(-1, 3)
        self.normals = _normals(self.vertices, self.triangles)
        edges, beside = _edges(mesh.triangles, meshed.faces)
        hidden, ends = _in_hinges(beside, meshed.cones)
        self.is_hidden = np.isin(meshed.faces, hidden)
        self.is_end = np.isin(meshed.faces, ends)
        at = np.zeros(count, int)
        at[codes % count] = np.arange(len(codes))
        self.edges = _closed(at[edges])


class _Drawing:
    """Nodes of one mesh, which its copies share."""

    def __init__(self, sketch):
        self._triangles, self._sketch, self._shared = sketch.triangles, sketch, {}
        place, normal = coin.SoCoordinate3(), coin.SoNormal()
        fill(place.point, sketch.vertices)
        fill(normal.vector, sketch.normals)
        self.corners = place, normal
        self.line_set, self.point_set = coin.SoIndexedLineSet(), coin.SoPointSet()
        fill(self.line_set.coordIndex, sketch.edges)

    def face_set(self, number, count):
        """Faces of body ``number``: a part to be selected among empty ones for the others."""
        node = coin.SoType.fromName("SoBrepFaceSet").createInstance()
        fill(node.coordIndex, _closed(self._triangles))
        parts = np.zeros(count, np.int32)
        parts[number] = len(self._triangles)
        fill(node.partIndex, parts)
        return node

    def shared(self, level):
        """Faces without those in the hinges, at a level of detail, for all copies."""
        if level not in self._shared:
            left_out = self._sketch.is_hidden
            if level == MOVING:
                left_out = left_out | self._sketch.is_end
            faces, self._shared[level] = coin.SoIndexedFaceSet(), coin.SoSeparator()
            fill(faces.coordIndex, _closed(self._triangles[~left_out]))
            for node in (*self.corners, faces):
                self._shared[level].addChild(node)
        return self._shared[level]


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


def _in_hinges(beside, cones):
    """Faces in the hinges: cones and what borders on nothing but cones, their tips; and the ends.

    Ends are the other faces that border on a cone: they look into the gap between two knuckles.
    """
    both = np.concatenate([beside, beside[:, ::-1]])
    at_cone = np.isin(both[:, 1], cones)
    hidden = np.setdiff1d(both[:, 0], np.setdiff1d(both[~at_cone, 0], cones))
    return hidden, np.setdiff1d(both[at_cone, 0], hidden)
