# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a design for papers and reports: top view, both states, angles along the curve.

Needs matplotlib, which is optional: `require` says so in one sentence. All functions take results
of `origami` or meshes of `solids`, write one file (.png; .svg or .pdf too where nothing is shaded)
and return its path.
"""

from .charts import angle_chart
from .film import deployment
from .force_charts import safety_chart, torque_chart
from .ghosts import slop_picture
from .hinge import hinge_detail
from .page import NoMatplotlib, require
from .plan import top_view
from .prints import openings, print_on_bed, print_with_ties, stack_and_tube
from .snap_charts import energy_chart, fit_chart, margin_chart
from .states import both_states, standing_view

__all__ = [
    "NoMatplotlib",
    "angle_chart",
    "both_states",
    "deployment",
    "energy_chart",
    "fit_chart",
    "hinge_detail",
    "margin_chart",
    "openings",
    "print_on_bed",
    "print_with_ties",
    "require",
    "safety_chart",
    "slop_picture",
    "stack_and_tube",
    "standing_view",
    "top_view",
    "torque_chart",
]
