# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves from SVG, DXF and CSV: edges that a Curve object follows.

SVG and DXF are read by FreeCAD's own importers, into a document that is closed again.
"""

import math
import re
import tempfile
import warnings
import xml.etree.ElementTree as ElementTree
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import FreeCAD as App
import numpy as np
import Part

from .. import make
from .text import file_at, table_points, text_of

_SMALLEST = 1e-6  # mm: shorter edges are left out
_GENTLE = 30.0  # degrees: a polygon that turns less at each corner is a curve told by its points
_INKSCAPE = {  # name spaces of what Inkscape says of itself in an SVG
    "inkscape": "http://www.inkscape.org/namespaces/inkscape",
    "sodipodi": "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd",
}
_FLAT = 1e-7  # of its length that a curve in a plane may be off it
_DEFLECTION = 0.01  # mm that the points of a curve may miss it between them


def import_curve(doc, path, kind="Plane", number=None, name=None):
    """A Curve object that follows the curve of a file; returns it, the document not recomputed.

    ``path``: .svg, .dxf, .csv or .txt; ``kind`` as in `make.make_curve`; ``number``: which of
    several separate curves (from 1, longest first); ``name``: of the new objects (default: the
    file's). The edges come into ``doc`` as an object of their own, which the Curve is linked to.
    """
    path = file_at(path)
    wire = curve_wire(path, number)
    label = name or path.stem
    feature = doc.addObject("Part::Feature", "ImportedCurve")
    feature.Label = label
    feature.Shape = wire
    curve = make.make_curve(doc, source=feature, kind=kind)
    curve.Label = f"{label} (curve)"
    return curve


def curve_points(path, number=None):
    """Points [(x, y, z)] in mm along the curve of a file.

    The rows of a table; of an SVG or DXF enough points to draw the curve within 0.01 mm.
    ``number`` as in `import_curve`.
    """
    path = file_at(path)
    if path.suffix.lower() in _TABLES:
        return table_points(path)
    wire = curve_wire(path, number)
    points = []
    for edge in wire.OrderedEdges:
        ends = edge.discretize(Deflection=_DEFLECTION)
        points += [tuple(p) for p in ends[1 if points else 0 :]]
    return points


def curve_wire(path, number=None):
    """The curve of a file as a wire; arguments as of `import_curve`."""
    path = file_at(path)
    return _smooth(Part.Wire(_chosen(_chains(path), number, path)))


class Found(NamedTuple):
    """A curve of a file: its ``length`` in mm, and the ``kind`` that a Curve along it is of."""

    length: float
    kind: str


def curves_in(path):
    """`Found` for every separate curve of a file, the longest first."""
    return [Found(wire.Length, _kind(wire)) for wire in map(Part.Wire, _chains(file_at(path)))]


def _kind(wire):
    """Plane where the wire lies in one, else General."""
    points = np.array([tuple(p) for p in wire.discretize(64)])
    spread = np.linalg.svd(points - points.mean(0), compute_uv=False)
    return "Plane" if spread[2] <= _FLAT * spread[0] else "General"


def _chains(path):
    """Lists of connected edges, the longest first; ValueError for a file without any."""
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        what = f"the suffix {path.suffix}" if path.suffix else "no suffix"
        raise ValueError(f"{path.name} has {what}: choose one of {', '.join(SUFFIXES)}.")
    if suffix in _TABLES:
        return [[_through(table_points(path))]]
    edges = [e for e in SUFFIXES[suffix](path) if e.Length > _SMALLEST]
    if not edges:
        raise ValueError(f"{path.name} holds no line or curve: draw one path, and export it again.")
    return sorted(Part.sortEdges(edges), key=lambda chain: -sum(e.Length for e in chain))


def _chosen(chains, number, path):
    if number is None and len(chains) == 1:
        return chains[0]
    lengths = ", ".join(f"{sum(e.Length for e in chain):.4g}" for chain in chains[:6])
    if number is None:
        raise ValueError(
            f"{path.name} holds {len(chains)} separate curves ({lengths} mm long): join them, or "
            "choose one by its number."
        )
    if not 1 <= int(number) <= len(chains):
        raise ValueError(
            f"{path.name} has no curve {number}: it holds {len(chains)} ({lengths} mm long)."
        )
    return chains[int(number) - 1]


def _smooth(wire):
    """A wire of many short straight edges as the smooth curve through their ends."""
    edges = wire.OrderedEdges
    points = [v.Point for v in wire.OrderedVertexes]
    if len(edges) < 4 or wire.isClosed():
        return wire
    sides = [b - a for a, b in pairwise(points)]
    if not all(e.Length - s.Length < _SMALLEST for e, s in zip(edges, sides, strict=True)):
        return wire
    turns = [math.degrees(a.getAngle(b)) for a, b in pairwise(sides)]
    return Part.Wire([_through(points)]) if max(turns) <= _GENTLE else wire


def _through(points):
    """Smooth edge through points."""
    vectors = [App.Vector(*p) for p in points]
    if len(vectors) == 2:
        return Part.makeLine(*vectors)
    spline = Part.BSplineCurve()
    try:
        spline.interpolate(vectors)
    except Part.OCCError as error:
        raise ValueError(
            "No smooth curve runs through these points: remove points that lie on each other."
        ) from error
    return spline.toShape()


def _svg_edges(path):
    text = text_of(path, "SVG")
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        raise ValueError(
            f"{path.name} is not a whole SVG file ({error}): save it again."
        ) from error
    if root.tag.split("}")[-1] != "svg":
        raise ValueError(f"{path.name} is not an SVG file: choose one, or another suffix.")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of FreeCAD's own code
        import importSVG
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / path.name
        copy.write_text(_with_resolution(text), encoding="utf-8")
        return _edges_by(importSVG.insert, copy)


def _with_resolution(text):
    """An SVG text that says 96 dots an inch as Inkscape does: else FreeCAD asks, in a dialog."""
    if "inkscape:version" in text:
        return text
    bare = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    missing = "".join(
        f' xmlns:{name}="{address}"'
        for name, address in _INKSCAPE.items()
        if f"xmlns:{name}=" not in bare
    )
    said = rf'\g<0>{missing} inkscape:version="1.0" sodipodi:docname="drawing"'
    return re.sub(r"<svg(?=[\s>])", said, bare, count=1)


def _dxf_edges(path):
    text = text_of(path, "DXF (as text, not binary)").upper()
    lines = [line.strip() for line in text.splitlines()]
    if "SECTION" not in lines or "ENTITIES" not in lines or "EOF" not in lines[-3:]:
        raise ValueError(
            f"{path.name} is not a whole DXF file: export it again, as DXF R12 to 2018."
        )
    import Import

    return _edges_by(Import.readDXF, path)


def _edges_by(read, path):
    """Edges that one of FreeCAD's importers makes of a file."""
    before = App.ActiveDocument
    doc = App.newDocument("CurveImport", hidden=True, temp=True)
    App.setActiveDocument(doc.Name)  # FreeCAD 1.0 sorts what it reads into layers of the active one
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of FreeCAD's own code
            read(str(path), doc.Name)
        doc.recompute()
        shapes = [obj.Shape.copy() for obj in doc.Objects if _is_leaf(obj)]
    except Exception as error:  # the importers raise whatever their parsing meets
        raise ValueError(f"{path.name} cannot be read ({error}): export it again.") from error
    finally:
        App.closeDocument(doc.Name)
        if before is not None and before.Name in App.listDocuments():
            App.setActiveDocument(before.Name)
    return [edge for shape in shapes if not shape.isNull() for edge in shape.Edges]


def _is_leaf(obj):
    return hasattr(obj, "Shape") and not getattr(obj, "Group", None)


_TABLES = (".csv", ".txt")
SUFFIXES = {".svg": _svg_edges, ".dxf": _dxf_edges, ".csv": table_points, ".txt": table_points}
