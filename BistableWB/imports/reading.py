# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any file with curves in it → `Curves` with a receipt. FreeCAD is needed for solids only."""

from dataclasses import dataclass, field

import numpy as np

from ..origami.curves.joining import JOIN
from ..origami.errors import Phrase, Refusal, phrase
from .drawing import FileCurve, Read, curves_of, nothing_in, open_gap
from .dxf import read_dxf
from .rhino import read_rhino
from .svg import read_svg
from .table import read_table
from .text import file_at

TABLES = (".csv", ".txt", ".tsv", ".xyz")
SHAPES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
DRAWINGS = (".svg", ".svgz", ".dxf", ".3dm")
SUFFIXES = (*DRAWINGS, *TABLES, *SHAPES)


@dataclass
class Receipt:
    """What was read of a file: ``curves``, ``unit`` and its source, what was left out and done.

    ``left_out``: [(count, what, why)]; ``notes``: `Phrase` each; ``scale``: what all lengths were
    multiplied by beyond the unit; ``join``: gaps in mm that were closed.
    """

    name: str
    unit: str
    source: Phrase
    scale: float = 1.0
    join: float = JOIN
    left_out: list = field(default_factory=list)
    notes: list = field(default_factory=list)
    curves: list = field(default_factory=list)

    def read(self) -> list[Phrase]:
        """The curves with length, size and layer, a `Phrase` each; twelve at most."""
        return [
            phrase(
                "Curve {number}: {length:.6g} mm long, {size} mm{layer}",
                number=number,
                length=curve.length,
                size=" × ".join(f"{x:.4g}" for x in curve.size if x > 1e-6),
                layer=phrase(", layer {name}", name=curve.layer) if curve.layer else "",
            )
            for number, curve in enumerate(self.curves[:12], 1)
        ]

    def phrases(self) -> list[Phrase]:
        """Unit, scale, what was left out and why, what was done: a `Phrase` each."""
        told = [phrase("Unit: {unit} ({source})", unit=self.unit, source=self.source)]
        if self.scale != 1:
            told.append(phrase("Scaled by {scale:g}", scale=self.scale))
        told += [
            phrase("Left out: {count} × {what} ({why})", count=count, what=what, why=why)
            for count, what, why in self.left_out
        ]
        return told + [phrase("Note: {note}", note=note) for note in self.notes]

    def __str__(self) -> str:
        return "\n".join([self.name, *map(str, [*self.read(), *self.phrases()])])


class Curves(list):
    """The curves of a file (`FileCurve`), the longest first, with a ``receipt``."""

    def __init__(self, curves, receipt: Receipt):
        super().__init__(curves)
        self.receipt = receipt
        receipt.curves = list(self)

    def summary(self) -> str:
        """Their lengths, of six at most."""
        return ", ".join(f"{curve.length:.4g}" for curve in self[:6])

    def chosen(self, number: int | None = None) -> FileCurve:
        """One curve by its ``number`` (from 1); None: the only one."""
        name = self.receipt.name
        if number is None and len(self) > 1:
            raise Refusal(
                "{name} holds {count} separate curves ({lengths} mm long){gap}", name=name,
                count=len(self), lengths=self.summary(), gap=self._gap(),
                cure="join them, or choose one by its number",
            )  # fmt: skip
        number = 1 if number is None else int(number)
        if not 1 <= number <= len(self):
            raise Refusal(
                "{name} has no curve {number}: it holds {count} ({lengths} mm long)", name=name,
                number=number, count=len(self), lengths=self.summary(),
            )  # fmt: skip
        return self[number - 1]

    def _gap(self):
        found = open_gap(self)
        if found is None:
            return ""
        one, other, gap, (x, y, z) = found
        return phrase(
            "; the ends of curves {one} and {other} are {gap:.3g} mm apart at ({x:.4g}, {y:.4g}, "
            "{z:.4g}) mm, which a larger “join gaps up to” closes",
            one=one, other=other, gap=gap, x=x, y=y, z=z,
        )  # fmt: skip


def curves_in(path, scale=None, join=None, layer=None) -> Curves:
    """All separate curves of a file, the longest first; ``.receipt`` says what became of the rest.

    ``scale``: all lengths are multiplied by it; ``join``: gaps in mm up to which ends are joined
    (None: 0.01); ``layer``: only the curves on this layer. `Refusal`, one sentence with the cure,
    where the file is missing, broken, of another kind, or holds no curve.
    """
    path = file_at(path)
    factor, join = _number(scale, 1.0, "scale"), _number(join, JOIN, "join")
    read = _reader(path)(path, scale)
    if factor != 1:
        matrix = np.diag([factor, factor, factor, 1.0])
        for stroke in read.strokes:
            stroke.pieces = [piece.mapped(matrix) for piece in stroke.pieces]
    curves, notes = curves_of(read, join)
    left_out = [(count, what, why) for (what, why), count in read.left_out.items()]
    receipt = Receipt(
        path.name, read.unit, read.source, factor, join, left_out, read.notes + notes
    )  # fmt: skip
    if not curves:
        raise nothing_in(path.name, read)
    return Curves(_on_layer(curves, layer, path), receipt)


def _number(given, default, name):
    value = default if given is None else given
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    if not is_number or not (0 < value < 1e9 or (name == "join" and value == 0)):
        raise Refusal("{name} is {value}", name=name, value=str(given)[:30],
                      cure="give it a number above 0")  # fmt: skip
    return max(float(value), 1e-9)


def _on_layer(curves, layer, path):
    if layer is None:
        return curves
    found = [curve for curve in curves if curve.layer.lower() == str(layer).lower()]
    if not found:
        layers = ", ".join(dict.fromkeys(curve.layer or "(none)" for curve in curves))
        raise Refusal("{name} has no curve on a layer {layer}", name=path.name, layer=layer,
                      layers=layers[:200], cure="choose one of {layers}")  # fmt: skip
    return found


def _reader(path):
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        what = phrase("the suffix {suffix}", suffix=path.suffix) if suffix else phrase("no suffix")
        raise Refusal("{name} has {what}", name=path.name, what=what, known=", ".join(SUFFIXES),
                      cure="choose one of {known}")  # fmt: skip
    if suffix in TABLES:
        return lambda path, scale: read_table(path)
    if suffix in SHAPES:
        from .shapes import read_shape  # inside FreeCAD only

        return lambda path, scale: read_shape(path)
    readers = {".dxf": read_dxf, ".3dm": read_rhino}
    if suffix in readers:
        return lambda path, scale: readers[suffix](path)
    return read_svg


__all__ = ["SUFFIXES", "Curves", "FileCurve", "Read", "Receipt", "curves_in"]
