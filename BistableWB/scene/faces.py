# SPDX-License-Identifier: LGPL-2.1-or-later
"""How faces get their colours, on FreeCAD 0.20 and on 1.x."""

import FreeCAD as App

from .. import settings
from ..origami.units.creases import PANELS, kind_of

NEEDS_REMINDER = App.Version()[0] == "0"


def unit_colours():
    """RGB of the twelve faces of a unit, in the order of the crease table."""
    return [settings.colour(kind_of(panel)) for panel in PANELS]


def face_colours(view_object):
    """RGB of every face that has a colour of its own; one only where all share it."""
    if hasattr(view_object, "ShapeAppearance"):
        return [material.DiffuseColor[:3] for material in view_object.ShapeAppearance]
    return [colour[:3] for colour in view_object.DiffuseColor]


def set_face_colours(view_object, wanted):
    """Colour the faces one by one, by a list of RGB in 0…1."""
    if hasattr(view_object, "ShapeAppearance"):
        materials = {colour: _material(colour) for colour in set(wanted)}
        view_object.ShapeAppearance = [materials[colour] for colour in wanted]
    else:
        view_object.DiffuseColor = [(*colour, 0.0) for colour in wanted]


def remind(view_object):
    """Make FreeCAD 0.20 draw the colours that the faces have (1.x does so by itself)."""
    view_object.DiffuseColor = view_object.DiffuseColor


def _material(colour):
    material = App.Material()
    material.DiffuseColor = (*colour, 1.0)
    # paper and print, not metal; FreeCAD takes all but the diffuse colour from the first face
    material.AmbientColor = (0.33, 0.33, 0.33, 1.0)
    material.SpecularColor = (0.1, 0.1, 0.1, 1.0)
    material.EmissiveColor = (0.0, 0.0, 0.0, 1.0)
    material.Shininess = 0.2
    return material
