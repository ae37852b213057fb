# SPDX-License-Identifier: LGPL-2.1-or-later
"""HingeSet and HingeCoupon in the view: solids, coloured by what each body is."""

from .. import colours
from . import settings
from .coloured import ColouredView

LINK = colours.MUTED
STRIP = colours.CURVE
_PLATES = ("border", "primary", "contact", "secondary")  # for a coupon's plates, one by one


def body_colour(name, number=0):
    """RGB of a body by its name: its panel's kind, blocks as the contact panels that they are.

    ``number`` tells bodies apart that have no kind.
    """
    if "strip" in name:
        return colours.rgb(STRIP)
    if "block" in name:
        return settings.panel_colour("contact")
    if "link" in name:
        return colours.rgb(LINK)
    kinds = [kind for kind in colours.PANELS if kind in name]
    # longest first: "secondary" must not be taken for anything shorter
    return settings.panel_colour(max(kinds, key=len) if kinds else _PLATES[number % 4])


def bodies_shown(obj):
    """(name, shape) of the bodies in an object's shape; flexible strips are there only when flat.

    Empty where names and shape do not belong together (while a file is being opened).
    """
    shapes = obj.Shape.SubShapes
    names = list(obj.BodyNames)
    if len(names) != len(shapes):
        names = [name for name in names if "strip" not in name]
    return list(zip(names, shapes, strict=True)) if len(names) == len(shapes) else []


class BodiesView(ColouredView):
    """Printed parts. A tube has thousands of small faces: coarse barrels, thin lines."""

    LOOK = {
        "LineColor": colours.rgb(colours.INK),
        "LineWidth": 1.0,
        "PointSize": 1.0,
        "Deviation": 1.0,
        "AngularDeflection": 45.0,
    }

    def wanted_colours(self, obj):
        """Every face in the colour of its body."""
        found = []
        for number, (name, shape) in enumerate(bodies_shown(obj)):
            found += [body_colour(name, number)] * shape.countElement("Face")
        return found


class HingeSetView(BodiesView):
    """A whole print: without edges, whose drawing would cost more than all the rest."""

    LOOK = BodiesView.LOOK | {"DisplayMode": "Shaded"}
