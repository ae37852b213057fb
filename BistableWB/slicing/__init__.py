# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a slicer makes of a print: time, plastic and support, and whether hinges stay free.

Needs PrusaSlicer, which is optional: `NoSlicer` says so in one sentence. Plain data comes out.
"""

from ..programs.prusaslicer import NoSlicer, find

__all__ = ["NoSlicer", "compare", "find", "modes"]


def compare(hinge_set, progress=None, **options):
    """`comparison.Comparison` of a HingeSet, flat-folded and deployed: `comparison.compare`."""
    from . import comparison  # needs FreeCAD; what reads G-code does not

    return comparison.compare(hinge_set, progress, **options)


def modes(hinge_set, progress=None, **options):
    """`ways.Mode` of every process that lays filament, for a HingeSet: `ways.modes`."""
    from . import ways  # needs FreeCAD

    return ways.modes(hinge_set, progress, **options)
