# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mathematics of bistable tubes: numpy, radians, plain arrays, batched over units.

Frames are right-handed. A unit's own frame: *flat*, everything lies in the plane y = 0 with A at
x = 0, B at x = ‖AB‖ and the legs along z; *deployed*, the mid-plane is y = 0, x points from C'
to B, z is "upper" and A_left is at y < 0.

Its wings: `curves` (what is followed), `units` (zero thickness), `thick` (panels with thickness),
`snap` (does it hold?), `hinges` (what is printed), `patterns` (nets), `fit` (the search).
"""

import sys

from .curves import bezier, placement
from .thick import linkage
from .units import angles

# Names of 0.1.0 that macros import: they are frozen, wherever the modules have moved.
for _module in (angles, bezier, linkage, placement):
    sys.modules[f"{__name__}.{_module.__name__.rpartition('.')[2]}"] = _module

__all__ = ["angles", "bezier", "linkage", "placement"]
