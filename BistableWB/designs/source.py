# SPDX-License-Identifier: LGPL-2.1-or-later
"""The file that [curve] source of a design names, as a feature of a document."""

import contextlib
from typing import TYPE_CHECKING

import Part

from .. import imports
from ..origami.errors import Refusal
from .keys import OF_SOURCE
from .reading import DesignError

if TYPE_CHECKING:
    import FreeCAD as App

    from .reading import Design

_SHAPES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")


def source_of(doc: "App.Document", design: "Design") -> "App.DocumentObject | None":
    """A feature with the shape of [curve] source, a file beside the design; None if not given."""
    name = design.get("curve", "source")
    if name is None:
        return None
    path = design.path.parent / name
    where = f"{design.path}: [curve] source {name}"
    if path.suffix.lower() not in imports.SUFFIXES:
        raise DesignError(
            "{where} is no shape file; give one of {names}.",
            where=where,
            names=", ".join(imports.SUFFIXES),
        )
    if not path.is_file():
        raise DesignError(
            "{where} is not there; give a path as seen from the design file.",
            where=where,
        )
    chosen = {key: design.get("curve", key) for key in OF_SOURCE}
    shape = Part.Shape()
    if path.suffix.lower() in _SHAPES and not any(chosen.values()):
        with contextlib.suppress(Part.OCCError, OSError, ValueError):
            shape = Part.read(str(path))
    else:
        try:
            shape = imports.curve_wire(path, **chosen)
        except Refusal as error:
            raise DesignError("{where}: {refused}", where=where, refused=error) from error
    if shape.isNull() or not shape.Edges:
        raise DesignError(
            "{where} has no edge that can be read; export the curve again.",
            where=where,
        )
    feature = doc.addObject("Part::Feature", "Source")
    feature.Label = path.stem
    feature.Shape = shape
    return feature
