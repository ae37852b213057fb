# SPDX-License-Identifier: LGPL-2.1-or-later
"""A curve of a file as an object in a document. Runs inside FreeCAD."""

import Part

from .. import make
from ..origami.errors import Refusal, phrase
from .drawing import MAX_POINTS, FileCurve
from .pieces import Line
from .reading import TABLES, curves_in
from .shapes import edge_of
from .table import table_points
from .text import file_at

_DEFLECTION = 0.01  # mm that the points of a curve may miss it between them
_MOST = 5_000  # pieces of a curve that FreeCAD still makes a wire of in a moment


@make.whole
def import_curve(doc, path, kind=None, number=None, name=None, scale=None, join=None, layer=None):
    """A Curve object that follows the curve of a file; returns it, the document not recomputed.

    ``path``: one of `SUFFIXES`; ``kind`` as in `make.make_curve` (None: what the curve is);
    ``number``: which of several separate curves (from 1, longest first); ``name``: of the new
    objects (default: the file's); ``scale``, ``join``, ``layer`` as in `curves_in`. The edges come
    into ``doc`` as an object of their own, which the Curve is linked to; its description is the
    receipt.
    """
    path = file_at(path)
    found = curves_in(path, scale, join, layer)
    chosen = found.chosen(number)
    wire = wire_of(chosen)
    label = name or path.stem
    feature = doc.addObject("Part::Feature", "ImportedCurve")
    feature.Label = label
    feature.Label2 = str(found.receipt)  # its description, in the document's tree
    feature.Shape = wire
    curve = make.make_curve(doc, source=feature, kind=kind or chosen.kind)
    curve.Label = f"{label} (curve)"
    return curve


def curve_points(path, number=None):
    """Points [(x, y, z)] in mm along the curve of a file.

    The rows of a table; of a drawing enough points to draw the curve within 0.01 mm.
    ``number`` as in `import_curve`.
    """
    path = file_at(path)
    if path.suffix.lower() in TABLES:
        return table_points(path)
    points = []
    for edge in curve_wire(path, number).OrderedEdges:
        ends = edge.discretize(Deflection=_DEFLECTION)
        points += [tuple(p) for p in ends[1 if points else 0 :]]
    return points


def curve_wire(path, number=None, scale=None, join=None, layer=None) -> Part.Wire:
    """The curve of a file as a wire; arguments as of `import_curve`."""
    return wire_of(curves_in(path, scale, join, layer).chosen(number))


def wire_of(curve: FileCurve) -> Part.Wire:
    """A curve of a file as a wire; `Refusal` where it has far too many pieces."""
    if len(curve.pieces) > _MOST:
        kind = phrase("corners") if isinstance(curve.pieces[0], Line) else phrase("pieces")
        raise Refusal(
            "The curve has {count} {kind}, more than {most}", count=len(curve.pieces), kind=kind,
            most=MAX_POINTS, cure="simplify it in the drawing program",
        )  # fmt: skip
    return Part.Wire([edge_of(piece) for piece in curve.pieces])
