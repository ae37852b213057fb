# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a design for papers and reports: top view, both states, angles along the curve.

Needs matplotlib, which is optional: `require` says so in one sentence. All functions take results
of `origami`, write one file (.png, .svg or .pdf by its suffix) and return its path.
"""

from .charts import angle_chart
from .page import NoMatplotlib, require
from .plan import top_view
from .states import both_states

__all__ = ["NoMatplotlib", "angle_chart", "both_states", "require", "top_view"]
