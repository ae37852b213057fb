# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a curve to prints that snap; proposals for a tube that fits the printer and snaps."""

import FreeCADGui as Gui

from ..objects import TYPES, type_of
from ..origami.errors import Refusal
from ..scene import chosen
from .base import QT_TRANSLATE_NOOP, Command, print_error, translate
from .create import CURVE, TRIANGLES, has_curve


class MakePrintable(Command):
    """A curve becomes a tube that prints, snaps and ends where the curve does."""

    name = "Bistable_MakePrintable"
    icon = "MakePrintable"
    text = QT_TRANSLATE_NOOP("Bistable_MakePrintable", "Make it printable")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_MakePrintable",
        "Search edge length, angles, hinges and parts for the selected curve, sketch or edges, so "
        "that the tube prints on your printer, snaps and ends where the curve does; shows what it "
        "changes and why",
    )
    shortcut = "O, M"

    def IsActive(self):
        """With something to follow, and no panel open."""
        return not Gui.Control.activeDialog() and has_curve()

    def run(self):
        """Open the panel; it searches at once."""
        from ..taskpanels.make_printable import MakePrintablePanel

        try:
            panel = MakePrintablePanel(chosen_source())
        except Refusal as error:
            print_error(error, translate("Bistable_MakePrintable", "Make it printable"))
            return
        Gui.Selection.clearSelection()
        Gui.Control.showDialog(panel)
        panel.start()


class AutoFit(Command):
    """Requirements, a search, proposals; one of them is applied."""

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


def chosen_source():
    """What is to be made printable: what is selected of a tube, else its curve, else edges."""
    ours = [obj for obj in Gui.Selection.getSelection() if type_of(obj) in TYPES]
    return ours[0] if ours else chosen.of_type(CURVE) or chosen.edges()
