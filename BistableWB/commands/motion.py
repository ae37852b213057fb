# SPDX-License-Identifier: LGPL-2.1-or-later
"""Open and fold a tube in the 3D view."""

import FreeCADGui as Gui

from ..objects import type_of
from ..objects.refused import refusal_of
from ..origami.errors import Refusal
from ..scene import chosen
from .base import QT_TRANSLATE_NOOP, Command, print_error

_MOVING = ("Bistable::HingeSet", "Bistable::BistableUnit")


class Deploy(Command):
    """Slider, play and record."""

    name = "Bistable_Deploy"
    icon = "Deploy"
    text = QT_TRANSLATE_NOOP("Bistable_Deploy", "Deploy")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Deploy",
        "Open and fold the selected tube in the 3D view: slide, play, record; panels or thick "
        "bodies",
    )
    shortcut = "O, P"

    def IsActive(self):
        """With a tube, and no panel open."""
        return not Gui.Control.activeDialog() and moving_object() is not None

    def run(self):
        """Open the panel."""
        from ..taskpanels.deploy import DeployPanel

        obj = moving_object()
        if not obj.isValid():
            print_error(refusal_of(obj), obj.Label)
            return
        Gui.Selection.clearSelection()
        try:
            panel = DeployPanel(obj)
        except Refusal as error:
            print_error(error, obj.Label)
            return
        Gui.Control.showDialog(panel)


def moving_object():
    """The selected tube, else the visible one, solids before faces, else the newest."""
    for obj in Gui.Selection.getSelection():
        if type_of(obj) in _MOVING:
            return obj
    found = [obj for obj in map(chosen.newest, _MOVING) if obj is not None]
    shown = [obj for obj in found if obj.ViewObject.Visibility]
    return next(iter(shown or found), None)
