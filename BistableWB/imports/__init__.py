# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files of other programs: a curve from SVG, DXF or CSV, a single unit from our own FOLD.

Lengths are millimetres. Every function raises ValueError, one sentence with the cure, for a file
that is missing, broken or of another kind; nothing is left in the document then.
"""

from .curves import SUFFIXES, curve_points, curve_wire, curves_in, import_curve
from .fold import import_fold, read_unit, unit_count

__all__ = [
    "SUFFIXES",
    "curve_points",
    "curve_wire",
    "curves_in",
    "import_curve",
    "import_fold",
    "read_unit",
    "unit_count",
]
