# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every output of a design opened again: whether it is whole, and what the document says.

The document is computed anew from its inputs first. What a mesh or a model holds is then read by
`outlines`, which knows nothing of how it was written, and compared.
"""

import json
import struct
import zipfile
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import FreeCAD as App
import numpy as np
import Part

from .. import exporters
from ..imports import curves_in
from ..objects import type_of
from ..objects.current import refuse_stale
from ..origami.errors import Phrase, Refusal, phrase, verbatim
from .documents import quiet_console
from .outlines import Outline, Unknown, outline_of

_SIZE = 2e-3  # of a box: triangles stay inside of round surfaces
_VOLUME = 1e-2
_SOLID = 1e-6  # STEP has the surfaces themselves
_KERNEL = (".step", ".stp")
_NETS = (".dxf",)
_BROKEN = (
    ValueError, KeyError, IndexError, TypeError, OSError, struct.error, zipfile.BadZipFile,
    ElementTree.ParseError, json.JSONDecodeError, Part.OCCError, EOFError, RuntimeError,
)  # fmt: skip


def verify(folder: Path) -> Iterator[tuple[Path, Phrase | None]]:
    """(file, what is wrong with it or None) of all files of the designs in ``folder``, and below.

    `Refusal` where there is no document.
    """
    documents = sorted(Path(folder).rglob("*.FCStd"))
    if not documents:
        raise Refusal(
            "There is no document (.FCStd) in {folder}",
            cure="give the folder that --out named",
            folder=str(folder),
        )
    for path in documents:
        with quiet_console():
            yield from _verified(path)


def _verified(path: Path) -> Iterator[tuple[Path, Phrase | None]]:
    try:
        doc = App.openDocument(str(path), hidden=True)
    except (OSError, RuntimeError, App.Base.FreeCADError) as error:
        yield path, phrase("it cannot be opened ({error})", error=verbatim(error))
        return
    try:
        wrong = _anew(doc)
        yield path, wrong
        expected = None if wrong else list(_expected(doc))  # nothing to compare with
        for other in sorted(p for p in path.parent.iterdir() if p.is_file() and p != path):
            yield other, _judged(other, expected)
    finally:
        App.closeDocument(doc.Name)


def _anew(doc: App.Document) -> Phrase | None:
    """What is wrong with a document that is computed from its inputs again."""
    ours = [obj for obj in doc.Objects if type_of(obj)]
    if not ours:
        return phrase("it holds no object of this workbench")
    before = {obj.Name: _own_outline(obj.Shape) for obj in ours}
    for obj in ours:
        obj.touch()
    doc.recompute()
    for obj in ours:
        try:
            refuse_stale(obj)
        except Refusal as refusal:
            return phrase("{refusal}", refusal=refusal)
        if not _alike(before[obj.Name], _own_outline(obj.Shape), _SOLID, _SOLID):
            return phrase("{label} is another one when it is computed again", label=obj.Label)
    return None


def _own_outline(shape: Part.Shape) -> Outline:
    if shape.isNull():
        return Outline()
    low, high = _corners(shape)
    return Outline(np.array([low, high]), shape.Volume if shape.Solids else None)


def _corners(shape: Part.Shape) -> tuple[tuple, tuple]:
    box = shape.BoundBox
    return (box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)


def _expected(doc: App.Document) -> Iterator[Outline]:
    """What files of the objects of a document hold, in each state."""
    for obj in doc.Objects:
        for state in (None, "flat", "deployed") if type_of(obj) else ():
            try:
                bodies = exporters.bodies_of([obj], state)
            except Refusal:
                continue  # it has no such state, or no faces
            shapes = [body.shape for body in bodies]
            lows, highs = zip(*map(_corners, shapes), strict=True)
            solid = all(shape.Solids for shape in shapes)
            volume = sum(shape.Volume for shape in shapes) if solid else None
            yield Outline(np.stack([np.min(lows, 0), np.max(highs, 0)]), volume)


def _judged(path: Path, expected: list[Outline] | None) -> Phrase | None:
    """What is wrong with one file."""
    size, volume = _SIZE, _VOLUME
    try:
        if path.suffix.lower() in _KERNEL:
            found, size, volume = _own_outline(Part.read(str(path))), _SOLID, _SOLID
        elif path.suffix.lower() in _NETS:
            found = _of_curves(path)
        else:
            found = outline_of(path)
    except Unknown:
        return None
    except _BROKEN as error:
        told = error if isinstance(error, Refusal) else verbatim(error)
        return phrase("it is not whole ({error})", error=told)
    if found.open_edges:
        return phrase("{count} edges of its triangles lack a partner", count=found.open_edges)
    if found.box is None or expected is None:
        return None
    if not any(_alike(e, found, size, volume) for e in expected):
        return phrase("it is none of what the document holds")
    return None


def _of_curves(path: Path) -> Outline:
    curves_in(path)
    return Outline()


def _alike(one: Outline, other: Outline, size: float, volume: float) -> bool:
    if one.box is None or other.box is None:
        return one.box is other.box
    reach = np.ptp(one.box, axis=0).max()
    same = np.abs(one.box - other.box).max() <= max(size * reach, 1e-4)
    if one.volume is None or other.volume is None:
        return bool(same)
    return bool(same and abs(one.volume - other.volume) <= volume * abs(one.volume))
