# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shapes to triangle meshes. Bodies that are moved or mirrored copies are meshed once."""

from math import isclose, pi

import MeshPart
import numpy as np
import Part

from .mesh import Mesh, PlacedMesh, joined, unpaired_edges

LINEAR_DEFLECTION = 0.05  # mm
ANGULAR_DEFLECTION = 0.3  # radians
_SAME = 1e5  # corners are the same within a part of a mm
# Copies in a tube are mirrored up-down or left-right in the frame they were built in.
_MIRRORS = [np.diag([1.0, up, along]) for up in (1.0, -1.0) for along in (1.0, -1.0)]


class Tessellator:
    """Meshes shapes; those that it has met, also moved or mirrored, come from its memory.

    ``linear`` (mm) and ``angular`` (radians) deflection bound how far flats lie from round faces.
    """

    def __init__(self, linear=LINEAR_DEFLECTION, angular=ANGULAR_DEFLECTION):
        self.linear, self.angular = linear, angular
        self._known = {}

    def mesh(self, shape):
        """Closed `Mesh` of a solid in the frame in which the shape stands."""
        original, matrix = self.original(shape)
        return original.moved(matrix)

    def original(self, shape):
        """The `Mesh` (shared by copies) whose image this shape's is, and the matrix (4, 4)."""
        place = np.array(shape.Placement.toMatrix().A).reshape(4, 4)
        own = Part.Shape(shape)
        own.Placement = type(shape.Placement)()
        key, middle, mirror = _fingerprint(own)
        alike = self._known.setdefault(key, [])
        volume = own.Volume
        known = next((k for k in alike if isclose(k[0], volume, rel_tol=1e-6)), None)
        if known is None:
            known = volume, mesh_of(own, self.linear, self.angular), middle, mirror
            alike.append(known)
        _, mesh, its_middle, its_mirror = known
        between = np.eye(4)
        between[:3, :3] = mirror @ its_mirror  # mirrors are their own inverse
        between[:3, 3] = middle - between[:3, :3] @ its_middle
        return mesh, place @ between


def placed_meshes(bodies, linear=LINEAR_DEFLECTION, angular=ANGULAR_DEFLECTION):
    """`PlacedMesh` of every body, of which only name and shape are needed."""
    tessellator = Tessellator(linear, angular)
    return [
        PlacedMesh(
            body.name,
            *tessellator.original(body.shape),
            getattr(body, "unit", 0),
            getattr(body, "members", ()),
            getattr(body, "material", "rigid"),
        )
        for body in bodies
    ]


def mesh_of(shape, linear=LINEAR_DEFLECTION, angular=ANGULAR_DEFLECTION):
    """Closed `Mesh` of one shape, deflections in mm and radians.

    Solids of a compound stay apart also where they touch. The kernel covers a cone with hundreds of
    points where a strip of triangles is as good: cones are left out and filled between their rims.
    """
    solids = shape.Solids
    if len(solids) > 1:
        return joined([mesh_of(solid, linear, angular) for solid in solids])
    faces = shape.Faces
    cones = [face for face in faces if isinstance(face.Surface, Part.Cone)]
    if cones:
        others = Part.makeCompound([f for f in faces if not isinstance(f.Surface, Part.Cone)])
        mesh = _with_strips(_from_kernel(others, linear, angular), cones)
        if mesh is not None:
            return mesh
    return _from_kernel(shape, linear, angular)


def _from_kernel(shape, linear, angular):
    mesh = MeshPart.meshFromShape(Shape=shape, LinearDeflection=linear, AngularDeflection=angular)
    mesh.removeDuplicatedPoints()
    points, triangles = mesh.Topology
    return Mesh(np.array(points, float).reshape(-1, 3), np.array(triangles, int).reshape(-1, 3))


def _fingerprint(shape):
    """(key, middle, mirror) of a shape in its own frame; copies have the same key.

    The copy is the image of the points that the key stands for under mirror and shift to middle.
    """
    points = np.array([tuple(v.Point) for v in shape.Vertexes])
    middle = (points.min(0) + points.max(0)) / 2
    candidates = []
    for mirror in _MIRRORS:
        whole = np.rint((points - middle) @ mirror * _SAME).astype(np.int64)
        candidates.append((whole[np.lexsort(whole.T)].tobytes(), mirror))
    code, mirror = min(candidates, key=lambda entry: entry[0])
    return (len(shape.Faces), len(shape.Edges), code), middle, mirror


def _with_strips(mesh, cones):
    """The mesh with a strip of triangles for each cone between its rims; None where they differ."""
    rims = _rims(mesh)
    strips = [mesh.triangles]
    for face in cones:
        found = [_rim_at(rims, centre, radius) for centre, radius in _circles(face)]
        if len(found) != 2 or any(rim is None for rim in found):
            return None
        strips += _strip(mesh.vertices, found[0], found[1][::-1])
    whole = Mesh(mesh.vertices, np.concatenate(strips))
    return None if len(unpaired_edges(whole.triangles)) else whole


def _strip(vertices, first, second):
    """Triangles between two coaxial rims that run the same way round, by the angle of their points.

    At every point of a rim, its edge up to there is joined to where the other rim has got to.
    """
    points = vertices[first]
    arms = points - points.mean(0)
    axis = np.cross(arms, np.roll(arms, -1, 0)).sum(0)
    axis /= np.linalg.norm(axis)
    start, across = arms[0], np.cross(axis, arms[0])
    turns = []
    for rim in (first, second):
        arms = vertices[rim] - vertices[rim].mean(0)
        angles = np.arctan2(arms @ across, arms @ start) % (2 * pi)
        angles[angles > 2 * pi - 1e-4] = 0.0
        turns.append(angles)
    second = np.roll(second, -turns[1].argmin())
    turns[1] = np.roll(turns[1], -turns[1].argmin())
    ends = [np.append(angles[1:], 2 * pi + angles[0]) for angles in turns]
    beside = np.searchsorted(ends[1], ends[0] - 1e-4) % len(second)
    onto = np.searchsorted(ends[0], ends[1] + 1e-4, side="right") % len(first)
    return [
        np.stack([np.roll(first, -1), first, second[beside]], 1),
        np.stack([first[onto], second, np.roll(second, -1)], 1),
    ]


def _circles(face):
    """Centre and radius of the rims of a cone, each rim once (it may be made of arcs)."""
    found = {}
    for edge in face.Edges:
        curve = edge.Curve
        if isinstance(curve, Part.Circle):
            found.setdefault(tuple(round(x, 4) for x in curve.Center), curve.Radius)
    return list(found.items())


def _rims(mesh):
    """Open borders of a mesh: (centres (n, 3), radii (n,), loops), each loop along its edges."""
    following = dict(unpaired_edges(mesh.triangles).tolist())
    loops = []
    while following:
        start, at = following.popitem()
        loop = [start]
        while at != start and at in following:
            loop.append(at)
            at = following.pop(at)
        loops.append(np.array(loop))
    middles = [mesh.vertices[loop].mean(0) for loop in loops]
    radii = [
        np.linalg.norm(mesh.vertices[loop] - m, axis=1).max()
        for loop, m in zip(loops, middles, strict=True)
    ]
    return np.array(middles).reshape(-1, 3), np.array(radii), loops


def _rim_at(rims, centre, radius):
    middles, radii, loops = rims
    if not loops:
        return None
    off = np.linalg.norm(middles - centre, axis=1) + np.abs(radii - radius)
    best = off.argmin()
    return loops[best] if off[best] < 0.05 * radius else None
