# SPDX-License-Identifier: LGPL-2.1-or-later
"""Several prints on one plate: beside each other where they would lie in each other."""

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import FreeCAD as App
import Part

if TYPE_CHECKING:
    from .bodies import Body

GAP = 10.0  # mm between two prints
_BED = 250.0  # mm: width of a row where no print says how wide its printer's bed is


def laid_out(prints: "Sequence[Sequence[Body]]") -> "list[Body]":
    """Bodies of several prints, moved onto one plate: ``prints`` [[`Body`, …], …], flat.

    Prints that lie apart stay where somebody has put them. Else they stand in rows along x, in
    their order, each on the height z = 0; a row is as wide as the narrowest bed of the prints.
    """
    boxes = [_box(bodies) for bodies in prints]
    if len(prints) < 2 or not _overlap(boxes):
        return [body for bodies in prints for body in bodies]
    moves = _rows(boxes, _width(prints))
    return [
        body._replace(shape=_moved(body.shape, move))
        for bodies, move in zip(prints, moves, strict=True)
        for body in bodies
    ]


def _rows(boxes: Sequence[Any], width: float) -> list[App.Vector]:
    """A shift for every box."""
    moves, x, y, depth = [], 0.0, 0.0, 0.0
    for box in boxes:
        if x and x + box.XLength > width:
            x, y, depth = 0.0, y + depth + GAP, 0.0
        moves.append(App.Vector(x - box.XMin, y - box.YMin, -box.ZMin))
        x, depth = x + box.XLength + GAP, max(depth, box.YLength)
    return moves


def _width(prints: "Sequence[Sequence[Body]]") -> float:
    beds = [getattr(bodies[0].source, "Bed", App.Vector()).x for bodies in prints if bodies]
    return min([bed for bed in beds if bed > 0], default=_BED)


def _overlap(boxes: Sequence[Any]) -> bool:
    """Whether any two boxes share a place on the plate."""
    return any(
        a.XMin < b.XMax and b.XMin < a.XMax and a.YMin < b.YMax and b.YMin < a.YMax
        for a, b in itertools.combinations(boxes, 2)
    )


def _box(bodies: "Sequence[Body]") -> Any:
    box = App.BoundBox()
    for body in bodies:
        box.add(body.shape.BoundBox)
    return box


def _moved(shape: Part.Shape, move: App.Vector) -> Part.Shape:
    moved = another(shape)
    moved.Placement = App.Placement(move, App.Rotation()) * moved.Placement
    return moved


def another(shape: Part.Shape) -> Part.Shape:
    """A shape with the same geometry, which is meshed once wherever it stands.

    A solid stays a solid; Part.Compound of a compound ends FreeCAD.
    """
    return Part.Solid(shape) if isinstance(shape, Part.Solid) else Part.Shape(shape)
