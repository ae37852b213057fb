# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of other programs: curves of drawings, tables and models, and units of our own FOLD.

Lengths are millimetres. Every function raises `Refusal` (a ValueError), one sentence with the
cure, for a file that is missing, broken or of another kind; nothing is left in the document then.
`curves_in` reads drawings and tables without FreeCAD; what makes document objects needs it.
"""

import importlib

from ..origami.curves.joining import JOIN
from .reading import SUFFIXES, Curves, FileCurve, Receipt, curves_in

_IN_FREECAD = {
    **dict.fromkeys(("curve_points", "curve_wire", "import_curve"), "curves"),
    **dict.fromkeys(("import_fold", "read_unit", "unit_count"), "fold"),
}
__all__ = [
    "JOIN",
    "SUFFIXES",
    "Curves",
    "FileCurve",
    "Receipt",
    "curve_points",
    "curve_wire",
    "curves_in",
    "import_curve",
    "import_fold",
    "read_unit",
    "unit_count",
]


def __getattr__(name):
    if name not in _IN_FREECAD:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f".{_IN_FREECAD[name]}", __name__), name)
