# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of what is exported: of drawn bodies without a CAD kernel, of other shapes by it."""

from typing import TYPE_CHECKING

from numpy.typing import NDArray

from ..origami.hinges.bodies import Drawn
from ..origami.hinges.meshing import CHORD_ERROR, mesh_of

if TYPE_CHECKING:
    import Part

    from ..origami.meshes import Mesh

LINEAR_DEFLECTION = CHORD_ERROR  # mm by which chords of round edges may lie inside
ANGULAR_DEFLECTION = 1.6  # radians: a circle has at least eight chords, and that is enough


class Mesher:
    """Meshes bodies within ``linear`` (mm) and ``angular`` (radians) deflection."""

    def __init__(
        self, linear: float = LINEAR_DEFLECTION, angular: float = ANGULAR_DEFLECTION
    ) -> None:
        self.linear, self.angular = linear, angular

    def original(self, shape: "Drawn | Part.Shape") -> "tuple[Mesh, NDArray]":
        """The `Mesh` (shared by copies) whose image this body's is, and the matrix (4, 4).

        ``shape``: a shape of the kernel, or a `bodies.Drawn`.
        """
        if isinstance(shape, Drawn):
            return mesh_of(shape.boundary, self.linear).mesh, shape.place
        from ..solids.tessellation import shared

        return shared(self.linear, self.angular).original(shape)

    def mesh(self, shape: "Drawn | Part.Shape") -> "Mesh":
        """The `Mesh` in the frame in which the body stands."""
        original, matrix = self.original(shape)
        return original.moved(matrix)
