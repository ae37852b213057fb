# SPDX-License-Identifier: LGPL-2.1-or-later
"""BistableUnit in the view: twelve faces a unit, coloured by kind of panel."""

from .. import colours
from ..scene import faces
from .coloured import ColouredView


class BistableUnitView(ColouredView):
    """Paper: flat faces with thin dark edges."""

    LOOK = {"LineColor": colours.rgb(colours.INK), "LineWidth": 1.0, "PointSize": 1.0}

    def wanted_colours(self, obj):
        """The colours of one unit's faces, once for every unit."""
        pattern = faces.unit_colours()
        return pattern * (obj.Shape.countElement("Face") // len(pattern))
