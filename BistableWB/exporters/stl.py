# SPDX-License-Identifier: LGPL-2.1-or-later
"""Binary STL: all bodies in one file, millimetres, z up. The same bodies give the same bytes."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import __version__
from .meshes import ANGULAR_DEFLECTION, LINEAR_DEFLECTION, Mesher

if TYPE_CHECKING:
    from ..origami.meshes import Mesh

_RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def write(
    bodies: Sequence[Any],
    path: Path,
    linear_deflection: float = LINEAR_DEFLECTION,
    angular_deflection: float = ANGULAR_DEFLECTION,
) -> None:
    """Write ``bodies``. Curved faces become triangles within the deflections (mm, radians)."""
    tessellator = Mesher(linear_deflection, angular_deflection)
    write_meshes([tessellator.mesh(body.shape) for body in bodies], path)


def write_meshes(meshes: "Sequence[Mesh]", path: Path) -> None:
    """Write `Mesh` objects (mm) one after the other."""
    with open(path, "wb") as file:
        file.write(f"Bistable Workbench {__version__}; millimetres".encode().ljust(80))
        file.write(np.uint32(sum(len(mesh.triangles) for mesh in meshes)).tobytes())
        for mesh in meshes:
            file.write(_records(mesh).tobytes())


def _records(mesh: "Mesh") -> NDArray:
    corners = mesh.corners.astype(np.float32)
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normals = np.cross(first.astype(float), second.astype(float))
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(corners), _RECORD)
    records["normal"] = normals / np.where(lengths > 0, lengths, 1)
    records["corners"] = corners
    return records
