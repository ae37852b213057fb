# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of a Rhino file (.3dm): read by rhino3dm, an add-on's Python package."""

import importlib
import itertools
from pathlib import Path

import numpy as np

from ..origami.errors import Refusal, phrase
from .drawing import Read, Stroke
from .pieces import MAX_PIECES, Array, Line, Piece
from .splines import clamped
from .text import content_of

_UNITS = {
    "Microns": 1e-3, "Millimeters": 1.0, "Centimeters": 10.0, "Meters": 1e3, "Kilometers": 1e6,
    "Microinches": 25.4e-6, "Mils": 0.0254, "Inches": 25.4, "Feet": 304.8, "Miles": 1609344.0,
    "Angstroms": 1e-7, "Nanometers": 1e-6, "Decimeters": 100.0, "Dekameters": 1e4,
    "Hectometers": 1e5, "Yards": 914.4, "PrinterPoints": 25.4 / 72, "PrinterPicas": 25.4 / 6,
}  # fmt: skip
_DEEPEST = 30
_MOST = 10_000


def read_rhino(path: Path) -> Read:
    """Strokes of all visible curves of a .3dm, in mm. `Refusal` where rhino3dm is not there."""
    rhino = _rhino3dm(path)
    if not content_of(path).startswith(b"3D Geometry File Format"):
        raise _broken(path)
    model = rhino.File3dm.Read(str(path))
    if model is None:
        raise _broken(path)
    unit = str(model.Settings.ModelUnitSystem).rpartition(".")[2]
    source = phrase("the unit of the Rhino model")
    if unit not in _UNITS:
        source = phrase("the Rhino model has no unit: taken as mm")
    read = Read([], unit if unit in _UNITS else "mm", source)
    factor = _UNITS.get(unit, 1.0)
    _Reader(path, rhino, model, read).draw_all(np.diag([factor, factor, factor, 1.0]))
    return read


class _Reader:
    def __init__(self, path, rhino, model, read):
        self.path, self.rhino, self.model, self.read = path, rhino, model, read
        self.layers = {layer.Index: layer for layer in model.Layers}
        self.objects = {str(obj.Attributes.Id): obj for obj in model.Objects}
        self.drawn = 0

    def draw_all(self, matrix):
        """Every object of the model that stands there by itself."""
        definition = self.rhino.ObjectMode.InstanceDefinitionObject
        for obj in self.model.Objects:
            if not obj.Attributes.IsInstanceDefinitionObject and obj.Attributes.Mode != definition:
                self._draw(obj, matrix, ())

    def _draw(self, obj, matrix, within):
        self.drawn += 1
        if self.drawn > _MOST or len(within) > _DEEPEST:
            raise Refusal("{name} draws more than {most} objects", name=self.path.name, most=_MOST,
                          cure="export the selected curve by itself")  # fmt: skip
        geometry, layer = obj.Geometry, self.layers.get(obj.Attributes.LayerIndex)
        kind = str(geometry.ObjectType).rpartition(".")[2]
        if not obj.Attributes.Visible or self._is_hidden(layer):
            self.read.left_out[kind, phrase("hidden")] += 1
        elif kind == "InstanceReference":
            self._instance(geometry, matrix, within)
        elif kind == "Curve":
            pieces = [piece.mapped(matrix) for piece in _pieces(self.rhino, geometry)]
            if len(pieces) > MAX_PIECES:
                raise Refusal("{name} has more than {most} pieces of curves", name=self.path.name,
                              most=MAX_PIECES, cure="simplify the curve")  # fmt: skip
            if pieces:
                name = getattr(layer, "FullPath", "") or getattr(layer, "Name", "")
                self.read.strokes.append(Stroke(pieces, name))
        else:
            self.read.left_out[kind, phrase("no curve")] += 1

    def _is_hidden(self, layer):
        for _ in range(_DEEPEST):
            if layer is None:
                return False
            if not layer.Visible:
                return True
            parent = str(layer.ParentLayerId)
            layer = next((x for x in self.layers.values() if str(x.Id) == parent), None)
        return False

    def _instance(self, reference, matrix, within):
        name = str(reference.ParentIdefId)
        if name in within:
            raise Refusal("{name} has a block that holds itself", name=self.path.name,
                          cure="explode the block")  # fmt: skip
        definition = self.model.InstanceDefinitions.FindId(reference.ParentIdefId)
        if definition is None:
            self.read.left_out[phrase("block"), phrase("it is not in the file")] += 1
            return
        own = np.array([[getattr(reference.Xform, f"M{i}{j}") for j in range(4)] for i in range(4)])
        for key in definition.GetObjectIds():
            if str(key) in self.objects:
                self._draw(self.objects[str(key)], matrix @ own, (*within, name))


def _pieces(rhino, curve) -> list[Piece]:
    """Pieces of a Rhino curve: those of a polycurve one by one, a polyline's sides."""
    if isinstance(curve, rhino.PolyCurve):
        return [p for k in range(curve.SegmentCount) for p in _pieces(rhino, curve.SegmentCurve(k))]
    if isinstance(curve, rhino.PolylineCurve):
        points = [_point(curve.Point(k)) for k in range(curve.PointCount)]
        return [Line(a, b) for a, b in itertools.pairwise(points)]
    if isinstance(curve, rhino.LineCurve):
        return [Line(_point(curve.PointAtStart), _point(curve.PointAtEnd))]
    nurbs = curve.ToNurbsCurve()
    if nurbs is None:
        return []
    homogeneous = [nurbs.Points[k] for k in range(len(nurbs.Points))]
    weights = np.array([p.W for p in homogeneous])
    poles = np.array([(p.X, p.Y, p.Z) for p in homogeneous]) / weights[:, None]
    inner = [nurbs.Knots[k] for k in range(len(nurbs.Knots))]
    knots = np.array([inner[0], *inner, inner[-1]])  # Rhino leaves out the outermost two
    degree = nurbs.Degree
    if degree == 1:
        return [Line(a, b) for a, b in itertools.pairwise(poles)]
    return [clamped(degree, knots, poles, weights if np.ptp(weights) else None)]


def _point(point) -> Array:
    return np.array([point.X, point.Y, point.Z])


def _rhino3dm(path):
    try:
        return importlib.import_module("rhino3dm")
    except ImportError as error:
        raise Refusal(
            "{name} needs the Python package rhino3dm, which is not installed", name=path.name,
            cure="install rhino3dm (FreeCAD's Addon Manager offers it with this workbench), or "
                 "export the curve from Rhino as STEP",
        ) from error  # fmt: skip


def _broken(path):
    return Refusal("{name} is not a whole Rhino file", name=path.name,
                   cure="save it again from Rhino, as version 5 or later")  # fmt: skip
