# SPDX-License-Identifier: LGPL-2.1-or-later
"""The objects that stand along one curve: Curve, triangles, units, hinge sets."""

from dataclasses import dataclass, field

from ..objects import TYPES, type_of
from ..objects.curve import Curve, geometry_of
from ..origami.errors import Refusal

TRIANGLES, UNIT, HINGES = (
    f"Bistable::{name}" for name in ("TrianglePlacement", "BistableUnit", "HingeSet")
)


@dataclass
class Chain:
    """Document objects, None where there are none yet; ``hinge_sets`` in the order of their units.

    ``edges``: (object, names) that a Curve is yet to follow; then there is no ``curve``.
    """

    curve: object = None
    triangles: object = None
    unit: object = None
    hinge_sets: list = field(default_factory=list)
    edges: tuple | None = None

    @property
    def document(self):
        """Where all of it is."""
        return self.curve.Document if self.curve is not None else self.edges[0].Document

    def objects(self) -> dict:
        """{variable of a macro: object} of all that there is."""
        found = {"curve": self.curve, "triangles": self.triangles, "unit": self.unit}
        found |= {hinges_name(n): obj for n, obj in enumerate(self.hinge_sets)}
        return {name: obj for name, obj in found.items() if obj is not None}


def hinges_name(number):
    """Variable of a hinge set, counted from 0."""
    return f"hinges{number + 1}" if number else "hinges"


def chain_of(source) -> Chain:
    """The `Chain` of a Curve, TrianglePlacement, BistableUnit or HingeSet; `Refusal` for others.

    Or of edges, (object, names), that no Curve follows yet.
    """
    if isinstance(source, tuple):
        return Chain(edges=source)
    own, obj = {}, source
    while type_of(obj) in TYPES and type_of(obj) not in own:
        own[type_of(obj)] = obj
        link = TYPES[type_of(obj)].input
        obj = getattr(obj, link) if link else None
    if Curve.Type not in own:
        raise Refusal("Make it printable: choose the Curve that the tube is to follow.")
    curve = own[Curve.Type]
    triangles = own.get(TRIANGLES) or _linked(curve, TRIANGLES, "Curve")
    unit = own.get(UNIT) or _linked(triangles, UNIT, "Triangles")
    there = [obj for obj in unit.InList if type_of(obj) == HINGES] if unit is not None else []
    there.sort(key=lambda hinges: hinges.FirstUnit)
    return Chain(curve, triangles, unit, list(dict.fromkeys(there)))


def course_of(chain):
    """`CurveGeometry` of the curve, in the global frame; of edges: as a new Curve takes them."""
    if chain.curve is not None:
        return geometry_of(chain.curve)
    from .. import make

    doc = chain.document
    doc.openTransaction("")
    made = make.make_curve(doc, source=chain.edges)
    name = made.Name
    try:
        return geometry_of(made)
    finally:
        doc.abortTransaction()
        if doc.getObject(name) is not None:  # a document without undo
            doc.removeObject(name)


def _linked(obj, type_name, link):
    """The object of a type that links to ``obj`` by a property, the first if there are several."""
    found = obj.InList if obj is not None else ()
    return next((o for o in found if type_of(o) == type_name and getattr(o, link) == obj), None)
