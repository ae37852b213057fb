# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies of an exported print, and the volume by which they run into each other: by manifold3d."""

import zipfile
from itertools import combinations
from xml.etree import ElementTree

import manifold3d
import numpy as np

from BistableWB.origami import rigid
from BistableWB.origami.thick import print_stack
from BistableWB.origami.thick.closure import KEPT, RIGHT
from BistableWB.origami.units.creases import BODIES


def read_3mf(path):
    """{name: (vertices, triangles)} of the bodies of a 3MF file, where they stand."""
    root = ElementTree.fromstring(zipfile.ZipFile(path).read("3D/3dmodel.model"))
    space = root.tag.removesuffix("model")
    objects = {item.get("id"): item for item in root.iter(f"{space}object")}

    def mesh_of(item):
        part = item.find(f"{space}components/{space}component")
        if part is not None:  # a copy of another body
            points, faces = mesh_of(objects[part.get("objectid")])
            return rigid.apply(_matrix(part.get("transform")), points), faces
        points = [[float(v.get(c)) for c in "xyz"] for v in item.iter(f"{space}vertex")]
        faces = [[int(t.get(f"v{k}")) for k in (1, 2, 3)] for t in item.iter(f"{space}triangle")]
        return np.array(points), np.array(faces)

    assembly = objects[root.find(f"{space}build/{space}item").get("objectid")]
    parts = [objects[part.get("objectid")] for part in assembly.iter(f"{space}component")]
    return {part.get("name"): mesh_of(part) for part in parts}


def _matrix(text):
    matrix = np.eye(4)
    if text:
        matrix[:3] = np.array(text.split(), float).reshape(4, 3).T
    return matrix


class Overlaps:
    """The fifteen bodies of a unit (its flat frame) from an export of the print of one unit.

    ``lift``: by how much it stands higher than a whole tube would, on the half block below it.
    """

    def __init__(self, path, thick, incoming_left, lift=0.0):
        frame = print_stack.frames(thick, incoming_left)[0]
        frame[2, 3] += lift
        place = np.linalg.inv(frame)
        bodies = read_3mf(path)
        self.meshes, self.points = [], []
        for name in BODIES:
            (found,) = (mesh for key, mesh in bodies.items() if key.endswith(f"_{name}"))
            points = rigid.apply(place, found[0])
            solid = manifold3d.Manifold(
                manifold3d.Mesh(np.float32(points), np.uint32(found[1]))
            ).as_original()
            assert solid.status() == manifold3d.Error.NoError, name
            self.meshes.append(solid)
            self.points.append(points)

    def pairs(self, poses):
        """Solids at poses (15, 4, 4), mm, and the pairs of them whose boxes meet."""
        solids = [s.transform(p[:3]) for s, p in zip(self.meshes, poses, strict=True)]
        boxes = [(q.min(0), q.max(0)) for q in map(rigid.apply, poses, self.points)]
        meet = [
            (a, b)
            for a, b in combinations(range(len(BODIES)), 2)
            if (boxes[a][0] < boxes[b][1]).all() and (boxes[b][0] < boxes[a][1]).all()
        ]
        return solids, meet

    def volume(self, poses):
        """Sum over all pairs of bodies of the volume that both take, mm³."""
        solids, meet = self.pairs(poses)
        return sum((solids[a] ^ solids[b]).volume() for a, b in meet)

    def with_slopes(self, poses):
        """The same, and its derivatives (15, 6) by small rotations about the origin and moves."""
        solids, meet = self.pairs(poses)
        total, slopes = 0.0, np.zeros((len(BODIES), 6))
        for a, b in meet:
            common = solids[a] ^ solids[b]
            if common.is_empty():
                continue
            total += common.volume()
            mesh = common.to_mesh()
            corners = np.float64(mesh.vert_properties)[:, :3][mesh.tri_verts]
            normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
            twist = np.concatenate([np.cross(corners.mean(1), normal), normal], 1)
            starts = np.asarray(mesh.run_index) // 3
            ids = {self.meshes[k].original_id(): k for k in (a, b)}
            for run, first, last in zip(mesh.run_original_id, starts, starts[1:], strict=False):
                slopes[ids[run]] += twist[first:last].sum(0)
        return total, slopes


def pulled(closure, poses, slopes):
    """Derivatives (15, 6) as derivatives (83,) by the unknowns of `Closure.moved`."""
    slopes = slopes.copy()
    slopes[RIGHT, :3] = closure.frame(poses)[0].T @ slopes[RIGHT, :3]
    return slopes.ravel()[KEPT]
