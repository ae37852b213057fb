# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start without a window: nothing to do, FreeCAD has put the package on the path already."""
