# SPDX-License-Identifier: LGPL-2.1-or-later
"""The checks of a print: one table, pure data.

To add one, give `suite.Suite` a method that returns findings, and add a line: the panel, reports,
the command line and docs/checks.md read it.
"""

from typing import NamedTuple

from ..marks import QT_TRANSLATE_NOOP


class Finds(NamedTuple):
    """A row of docs/checks.md: the ``code`` of findings, what is measured against which limit."""

    code: str
    measured: str
    limit: str
    finding: str


class Check(NamedTuple):
    """One step of the checks: ``title`` (shown while it runs), ``method`` of `suite.Suite`.

    ``of``: ALL prints, TUBES only, MOVING ones (tubes of rigid bodies), or TIED ones, on edge with
    ties; ``openings``: those at which it is made, each a step of its own that the method gets.
    """

    title: str
    method: str
    of: str
    finds: tuple
    openings: tuple = ()


ALL, TUBES, MOVING, TIED = "all", "tubes", "moving", "tied"
OPENINGS = (0.25, 0.5, 0.75, 1.0)  # at which bodies may overlap no more than the snap

CHECKS = {
    "size": Check(
        QT_TRANSLATE_NOOP("BistableCheck", "Size of the print…"), "check_size", TUBES,
        (Finds("bed", "size of the print as it stands, flat or on edge, turned on the bed so that "
               "it fits best", "the object's *Bed*, else the preferences",
               "error, with the parts that would fit"),),
    ),
    "snap": Check(
        QT_TRANSLATE_NOOP("BistableCheck", "Snap of the units…"), "check_snap", TUBES,
        (Finds("snap", "needed clearance / clearance of the hinges, for every unit",
               "1, and a second stable state", "warning that names the floppy units"),),
    ),
    "solids": Check(
        QT_TRANSLATE_NOOP("BistableCheck", "Closed solids…"), "check_solids", ALL,
        (Finds("open", "every body is one closed "
               "surface, the right way round, that does not cross itself", "0", "error"),
         Finds("volume", "mesh against solid", "0.5 %", "error")),
    ),
    "clearances": Check(
        QT_TRANSLATE_NOOP("BistableCheck", "Clearances in the flat print…"), "check_clearances",
        ALL,
        (Finds("clearance", "smallest distance between two moving bodies, flat", "what the hinges "
               "ask for, less 0.02 mm; 0.1 mm, which slicers close", "error"),),
    ),
    "layers": Check(
        QT_TRANSLATE_NOOP("BistableCheck", "Layers and overhangs…"), "check_layers", ALL,
        (Finds("layers", "volume of a body's layers against its own", "5 %",
               "warning: thicknesses off the layers"),
         Finds("fused", "area in which a layer of one moving body lies directly on a layer of "
               "another", "0.15 mm² a pair; from 1 mm² it is welded", "warning; error"),
         Finds("overhang", "area that is carried neither by the layer below (up to 60° from the "
               "vertical) nor by the support, nor spanned from hold to hold over 5 mm",
               "a square of 5 mm fits into it", "warning: print with support"),
         Finds("island", "every region of a layer that begins in mid-air, over 0.1 mm²: height "
               "above anything else", "5 mm; 0.4 mm where no slicer adds support",
               "warning: how many places, how large"),
         Finds("pillar", "loose pillars that hold what stand-offs cannot: plastic, cm³", "none",
               "note: how many fall out at the first opening")),
    ),
    "ties": Check(
        QT_TRANSLATE_NOOP("BistableCheck", "Ties…"), "check_ties", TIED,
        (Finds("start", "on edge with ties: area of every island of a layer, and of what lies "
               "further than 1.5 mm from what is below", "1 mm² a unit", "warning"),
         Finds("tie", "bodies that a tie joins, and its thinnest section between them",
               "two; 1.75 nozzle²", "error")),
    ),
    "walls": Check(
        QT_TRANSLATE_NOOP("BistableCheck", "Walls and cones…"), "check_walls", ALL,
        (Finds("wall", "distance of faces that look away from each other, lie opposite each other "
               "and do not meet", "nozzle; for floors a layer", "error"),
         Finds("cone", "steepest overhang of any cone or its recess", "60° from the vertical",
               "warning")),
    ),
    "overlaps": Check(
        QT_TRANSLATE_NOOP("BistableCheck", "Overlaps when opened to {}…"), "check_pose", MOVING,
        (Finds("overlap", "depth by which bodies run into each other, 25, 50, 75 and 100 % open",
               "play and snap on the way, 0.01 mm (preloaded: twice what "
               "cones press) at rest", "warning; error when deployed"),),
        OPENINGS,
    ),
}  # fmt: skip
