# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every test sees. Tests that need FreeCAD exist only inside FreeCAD: see .ci/in-freecad."""

import sys

from hypothesis import settings

FREECAD = sys.modules.get("FreeCAD")

collect_ignore = []
if FREECAD is None:
    collect_ignore.append("freecad")
if FREECAD is None or not FREECAD.GuiUp:
    collect_ignore.append("gui")

# The same examples on each run, and no database: a red run can be repeated anywhere.
# No deadline: machines differ.
settings.register_profile("house", database=None, deadline=None, max_examples=40, derandomize=True)
settings.load_profile("house")
