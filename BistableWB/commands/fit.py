# SPDX-License-Identifier: LGPL-2.1-or-later
"""Proposals for a tube that fits the printer and snaps."""

import FreeCADGui as Gui

from . import chosen
from .base import QT_TRANSLATE_NOOP, Command
from .create import CURVE, TRIANGLES


class AutoFit(Command):
    """Wishes, a search, proposals; one of them is applied."""

    name = "Bistable_AutoFit"
    icon = "AutoFit"
    text = QT_TRANSLATE_NOOP("Bistable_AutoFit", "Auto-fit")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_AutoFit",
        "Propose edge length, gamma and ratio rule for a curve, so that its tube fits the printer "
        "and snaps",
    )
    shortcut = "O, A"

    def IsActive(self):
        """With a curve to follow, and no panel open."""
        return not Gui.Control.activeDialog() and followed_object() is not None

    def run(self):
        """Open the panel; it searches at once."""
        from ..taskpanels.auto_fit import AutoFitPanel

        panel = AutoFitPanel(followed_object())
        Gui.Selection.clearSelection()
        Gui.Control.showDialog(panel)
        panel.start()


def followed_object():
    """The triangles whose tube is to be fitted, else the curve; None where there is neither."""
    return chosen.of_type(TRIANGLES) or chosen.of_type(CURVE)
