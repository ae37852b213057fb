# SPDX-License-Identifier: LGPL-2.1-or-later
"""Binary STL: all bodies in one file, millimetres, z up. The same bodies give the same bytes."""

import numpy as np

from .. import __version__
from ..solids.tessellation import ANGULAR_DEFLECTION, LINEAR_DEFLECTION, shared

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def write(bodies, path, linear_deflection=LINEAR_DEFLECTION, angular_deflection=ANGULAR_DEFLECTION):
    """Write ``bodies``. Curved faces become triangles within the deflections (mm, radians)."""
    tessellator = shared(linear_deflection, angular_deflection)
    write_meshes([tessellator.mesh(body.shape) for body in bodies], path)


def write_meshes(meshes, path):
    """Write `Mesh` objects (mm) one after the other."""
    with open(path, "wb") as file:
        file.write(f"Bistable Workbench {__version__}; millimetres".encode().ljust(80))
        file.write(np.uint32(sum(len(mesh.triangles) for mesh in meshes)).tobytes())
        for mesh in meshes:
            file.write(_records(mesh).tobytes())


def _records(mesh):
    corners = mesh.corners.astype(np.float32)
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normals = np.cross(first.astype(float), second.astype(float))
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(corners), _RECORD)
    records["normal"] = normals / np.where(lengths > 0, lengths, 1)
    records["corners"] = corners
    return records
