# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bodies of a print as solids of the kernel."""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..origami.hinges.bodies import (
    BLOCK_INSET,
    Drawn,
    in_print_plan,
    layout_drawn,
    printed_layouts,
    tube_drawn,
)
from ..origami.hinges.boundary import Boundary
from ..origami.hinges.meshing import CHORD_ERROR
from ..origami.meshes import material_of
from ..origami.progress import NOBODY
from .matrices import placement_of
from .shapes import shape_of

if TYPE_CHECKING:
    import Part

    from ..origami.hinges.parameters import HingeParameters
    from ..origami.hinges.unit_layout import Layout
    from ..origami.progress import Progress
    from ..origami.thick.linkage import ThickUnit

__all__ = [
    "BLOCK_INSET", "Body", "bodies_of", "in_print_plan", "layout_solids", "moved",
    "printed_layouts", "tube_bodies",
]  # fmt: skip


class Body(NamedTuple):
    """One body of the print: ``members`` are its (unit index, body name) pairs.

    ``unit`` is the index of the first of them; a block has two members, the flexure of a hinge none
    (it bends: no single pose holds for it), all others one. ``kind``: a key of `colours.KINDS`.
    ``boundary``: what ``shape`` was made from, and ``place`` (4, 4) where it stands; ``seat`` as of
    `bodies.Drawn`.
    """

    name: str
    shape: Any
    unit: int
    members: tuple
    kind: str
    boundary: Boundary | None = None
    place: Any = None
    seat: tuple | None = None

    @property
    def material(self) -> str:
        """What it is printed in: "rigid", "flexible" or "support"."""
        return material_of(self.kind)

    @property
    def slack(self) -> float:
        """Volume (mm³) by which a mesh with chords within `CHORD_ERROR` may differ."""
        return 0.0 if self.boundary is None else CHORD_ERROR * self.boundary.round_area

    @property
    def volume(self) -> float:
        """Volume, mm³, exact."""
        return self.shape.Volume if self.boundary is None else self.boundary.volume


def tube_bodies(
    thick: "ThickUnit",
    parameters: "HingeParameters",
    incoming_left: Any = None,
    progress: "Progress" = NOBODY,
    notes: list[Any] | None = None,
) -> list[Body]:
    """All bodies of a tube in the print frame: `bodies.tube_drawn` as solids."""
    return bodies_of(tube_drawn(thick, parameters, incoming_left, progress, notes))


def bodies_of(drawn: list[Drawn]) -> list[Body]:
    """Solids of drawn bodies."""
    return [
        Body(
            body.name, shape_of(body.boundary, body.place), body.unit, body.members, body.kind,
            body.boundary, body.place, body.seat,
        )
        for body in drawn
    ]  # fmt: skip


def layout_solids(
    layout: "Layout", parameters: "HingeParameters"
) -> "list[tuple[str, Part.Shape, str]]":
    """(name, solid, kind) of all bodies of a `unit_layout.Layout`, in its frame."""
    return [
        (name, shape_of(boundary, matrix), kind)
        for name, boundary, matrix, kind in layout_drawn(layout, parameters)
    ]


def moved(shape: "Part.Shape", frame: NDArray) -> "Part.Shape":
    """Shape carried by a rigid motion (4, 4)."""
    carried = type(shape)(shape)
    carried.Placement = placement_of(np.asarray(frame)) * carried.Placement
    return carried
