# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is said where a panel or a hinge has no room, and how much larger would do."""

from typing import TYPE_CHECKING

from ..errors import Refusal, phrase

if TYPE_CHECKING:
    from ..errors import Phrase
    from .unit_layout import Hinge


class TooSmall(Refusal):
    """A panel or hinge has no room.

    ``what`` is wrong (a `Phrase`), at which ``hinge``, and the ``factor`` by which its length must
    grow.
    """

    def __init__(
        self, what: "Phrase", hinge: "Hinge", factor: float, edge_length: float | None = None
    ) -> None:
        self.what, self.hinge = what, hinge
        super().__init__(
            "{what}; set {size}, or make {FaceThickness} or {GapLength} smaller.",
            parameter="FaceThickness",
            what=what,
            size=size_property(hinge, factor, edge_length),
        )


def size_property(hinge: "Hinge", factor: float, edge_length: float | None = None) -> "Phrase":
    """A phrase: property and value that make a hinge of a unit ``factor`` times longer."""
    if hinge.name.startswith("leg"):
        return phrase(
            "the strip height h ({HeightRatio}) so that h is {height:.3g} mm",
            height=hinge.stretch[1] * factor,
        )
    if hinge.name.startswith("crease"):
        return phrase("{LengthX} and {LengthY} {factor:.2f} times larger", factor=factor)
    if edge_length:
        return phrase("{EdgeLength} ‖AB‖ to {length:.3g} mm", length=factor * edge_length)
    return phrase("{EdgeLength} ‖AB‖ {factor:.2f} times larger", factor=factor)
