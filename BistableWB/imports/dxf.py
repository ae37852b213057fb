# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of a DXF, R12 to R2018, as text or binary: read by ezdxf, an add-on's Python package.

ezdxf reads the file; what its entities mean, and where blocks stand, is worked out here.
"""

import importlib
import tempfile
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..origami.errors import Refusal, phrase
from .drawing import Read, Stroke
from .dxf_entities import PIECES, frame
from .pieces import MAX_PIECES, Array
from .text import content_of

_UNITS = {  # $INSUNITS: name, mm
    1: ("inch", 25.4), 2: ("ft", 304.8), 3: ("mile", 1609344.0), 4: ("mm", 1.0), 5: ("cm", 10.0),
    6: ("m", 1000.0), 7: ("km", 1e6), 8: ("microinch", 25.4e-6), 9: ("mil", 0.0254),
    10: ("yd", 914.4), 11: ("Å", 1e-7), 12: ("nm", 1e-6), 13: ("µm", 1e-3), 14: ("dm", 100.0),
    15: ("dam", 1e4), 16: ("hm", 1e5), 17: ("Gm", 1e12), 18: ("au", 1.495978707e14),
    19: ("light year", 9.4607304725808e18), 20: ("pc", 3.0856775814913673e19),
    21: ("US survey ft", 1200000 / 3937), 22: ("US survey inch", 100000 / 3937),
    23: ("US survey yd", 3600000 / 3937), 24: ("US survey mile", 6336000000 / 3937),
}  # fmt: skip
_BINARY = b"AutoCAD Binary DXF"
_DEEPEST = 30  # blocks in blocks
_MOST = 10_000  # entities that are drawn
_WHY = {
    "HATCH": phrase("a filling"),
    "POINT": phrase("no curve"),
    "XLINE": phrase("without end"),
    "RAY": phrase("without end"),
    "REGION": phrase("a surface"),
    "BODY": phrase("a solid"),
    "3DSOLID": phrase("a solid"),
    "MESH": phrase("a surface"),
    "SURFACE": phrase("a surface"),
    "3DFACE": phrase("a surface"),
    "SOLID": phrase("a filling"),
    "TRACE": phrase("a filling"),
    "IMAGE": phrase("a picture"),
    "VIEWPORT": phrase("a view"),
    "WIPEOUT": phrase("a cover"),
}


class _Place(NamedTuple):
    matrix: Array
    layer: str | None  # of the block reference, for what lies on layer 0
    names: tuple = ()


def read_dxf(path: Path) -> Read:
    """Strokes of the model space of a DXF, in mm. `Refusal` where ezdxf is not there."""
    content = content_of(path)
    document = _document(path, content)
    # ezdxf fills in what the header lacks: only what the file says counts
    code = document.header.get("$INSUNITS", 0) if b"$INSUNITS" in content else 0
    unit, factor = _UNITS.get(code, ("mm", 1.0))
    if code in _UNITS:
        source = phrase("$INSUNITS of the file is {code}", code=code)
    else:
        source = phrase("the file gives no unit ($INSUNITS): taken as mm")
    reader = _Reader(path, document, Read([], unit, source))
    scale = np.diag([factor, factor, factor, 1.0])
    for entity in document.modelspace():
        reader.draw(entity, _Place(scale, None))
    outside = sum(len(layout) for layout in document.layouts if not layout.is_modelspace)
    if outside:
        reader.read.left_out[phrase("entity"), phrase("in paper space")] += outside
    return reader.read


class _Reader:
    def __init__(self, path, document, read):
        self.path, self.document, self.read = path, document, read
        self.layers = {layer.dxf.name.lower(): layer for layer in document.layers}
        self.drawn = self.pieces = 0

    def draw(self, entity, place: _Place):
        """Strokes of an entity, and of the block that a reference shows."""
        self.drawn += 1
        if self.drawn > _MOST:
            raise Refusal("{name} draws more than {most} entities", name=self.path.name, most=_MOST,
                          cure="save the one curve by itself (WBLOCK)")  # fmt: skip
        kind = entity.dxftype()
        layer = entity.dxf.get("layer", "0")
        layer = place.layer if layer == "0" and place.layer is not None else layer
        if entity.dxf.get("invisible", 0):
            self.read.left_out[kind, phrase("invisible")] += 1
        elif (why := self._hidden(layer, kind)) is not None:
            self.read.left_out[kind, why] += 1
        elif kind == "INSERT":
            self._insert(entity, place, layer)
        elif kind in PIECES:
            self._stroke(entity, kind, place, layer)
        elif kind not in ("ATTDEF", "ATTRIB", "SEQEND"):
            self.read.left_out[kind, _WHY.get(kind, phrase("text or drawing aid"))] += 1

    def _hidden(self, layer, kind):
        """Why nothing on ``layer`` is seen; of a reference only a frozen layer hides the block."""
        found = self.layers.get(layer.lower())
        if found is None:
            return None
        if found.is_frozen():
            return phrase("layer {layer} is frozen", layer=layer)
        if found.is_off() and kind != "INSERT":
            return phrase("layer {layer} is off", layer=layer)
        return None

    def _stroke(self, entity, kind, place, layer):
        try:
            pieces = PIECES[kind](entity)
        except (ArithmeticError, ValueError, IndexError) as error:
            raise Refusal(
                "{name} has a broken {kind} (handle {handle})", name=self.path.name, kind=kind,
                handle=entity.dxf.get("handle", "?"),
                cure="run AUDIT in the CAD program, or draw it again, and export once more",
            ) from error  # fmt: skip
        if pieces is None:
            self.read.left_out[kind, phrase("a surface")] += 1
            return
        self.pieces += len(pieces)
        if self.pieces > MAX_PIECES:
            raise Refusal("{name} has more than {most} pieces of curves", name=self.path.name,
                          most=MAX_PIECES, cure="save the one curve by itself")  # fmt: skip
        mapped = [piece.mapped(place.matrix) for piece in pieces]
        if not all(np.isfinite([p.start, p.end]).all() for p in mapped):
            raise Refusal(
                "{name} has a {kind} whose numbers are not finite (handle {handle})",
                name=self.path.name, kind=kind, handle=entity.dxf.get("handle", "?"),
                cure="draw it again",
            )  # fmt: skip
        if mapped:
            self.read.strokes.append(Stroke(mapped, "" if layer == "0" else layer))

    def _insert(self, entity, place, layer):
        name = entity.dxf.get("name", "")
        block = self.document.blocks.get(name)
        if block is None:
            block = phrase("block {name}", name=name)
            self.read.left_out[block, phrase("it is not in the file")] += 1
            return
        if name in place.names or len(place.names) > _DEEPEST:
            raise Refusal("{file}: the block {name} holds itself", file=self.path.name, name=name,
                          cure="explode it, or remove it from itself")  # fmt: skip
        if block.block is not None and block.block.dxf.get("flags", 0) & 12:
            block = phrase("block {name}", name=name)
            self.read.left_out[block, phrase("it lies in another file (xref): bind it")] += 1
            return
        for matrix in _standing(entity, block, _MOST):
            inner = _Place(place.matrix @ matrix, layer, (*place.names, name))
            self.drawn += 1
            for child in block:
                self.draw(child, inner)


def _standing(entity, block, most):
    """Matrices (4, 4) from a block to where a reference, or an array of them, shows it."""
    dxf = entity.dxf
    base = block.block.dxf.get("base_point", (0, 0, 0)) if block.block is not None else (0, 0, 0)
    axes = frame(dxf.get("extrusion", (0, 0, 1)))
    angle = np.radians(dxf.get("rotation", 0.0))
    turn = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0],
                     [0, 0, 1]])  # fmt: skip
    scales = [dxf.get(f"{axis}scale", 1.0) for axis in "xyz"]
    matrix = np.eye(4)
    matrix[:3, :3] = axes @ turn @ np.diag(scales)
    insert = np.array(list(dxf.get("insert", (0, 0, 0))), float)
    rows = dxf.get("row_count", 1) if dxf.get("row_spacing", 0) else 1
    columns = dxf.get("column_count", 1) if dxf.get("column_spacing", 0) else 1
    for k in range(min(max(1, rows) * max(1, columns), most)):
        row, column = divmod(k, max(1, columns))
        step = [column * dxf.get("column_spacing", 0), row * dxf.get("row_spacing", 0), 0]
        placed = matrix.copy()
        placed[:3, 3] = axes @ (insert + turn @ step) - matrix[:3, :3] @ np.array(list(base), float)
        yield placed


def _document(path, content):
    try:
        ezdxf = importlib.import_module("ezdxf")
    except ImportError as error:
        raise Refusal(
            "{name} needs the Python package ezdxf, which is not installed", name=path.name,
            cure="install ezdxf (FreeCAD's Addon Manager offers it with this workbench; on Debian "
                 "python3-ezdxf), or save the curve as SVG",
        ) from error  # fmt: skip
    if not content.startswith(_BINARY):
        content = _whole(path, content)
    recover = importlib.import_module("ezdxf.recover")
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / "drawing.dxf"
        copy.write_bytes(content)
        problems = (ezdxf.DXFError, ValueError, LookupError, TypeError, AttributeError, OSError)
        try:
            return ezdxf.readfile(copy)
        except problems:
            try:
                return recover.readfile(copy)[0]
            except problems as error:
                raise _no_dxf(path) from error


def _whole(path, content):
    """Text of a DXF with plain line ends, up to its end of file; `Refusal` without one."""
    lines = content.replace(b"\r\n", b"\n").replace(b"\r", b"\n").split(b"\n")
    stripped = [line.strip(b" \t\x1a\xef\xbb\xbf") for line in lines]
    if b"\0" in content:
        raise Refusal("{name} is not a text file", name=path.name, cure="choose a DXF file")
    if b"SECTION" not in stripped or b"ENTITIES" not in stripped:
        raise _no_dxf(path)
    start = next(k for k, line in enumerate(stripped) if line)
    for k in range(start, len(lines) - 1, 2):
        if stripped[k] == b"0" and stripped[k + 1].upper() == b"EOF":
            return b"\n".join([*lines[start:k], b"0", b"EOF", b""])
    raise _no_dxf(path)


def _no_dxf(path):
    return Refusal("{name} is not a whole DXF file", name=path.name,
                   cure="export it again, as DXF R12 to 2018")  # fmt: skip
