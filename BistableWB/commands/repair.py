# SPDX-License-Identifier: LGPL-2.1-or-later
"""Repair: objects of a file that was saved where the workbench was missing."""

import FreeCAD as App

from .base import QT_TRANSLATE_NOOP, Command, translate


class Repair(Command):
    """Make objects work again that have lost their proxies."""

    name = "Bistable_Repair"
    icon = "Repair"
    text = QT_TRANSLATE_NOOP("Bistable_Repair", "Repair objects")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Repair",
        "Make objects of this workbench work again after the file was saved without it",
    )

    def IsActive(self):
        """With a document."""
        return App.ActiveDocument is not None

    def run(self):
        """Repair the active document and say what was done."""
        repaired = repair_document(App.ActiveDocument)
        if repaired:
            names = ", ".join(obj.Label for obj in repaired)
            text = translate("Bistable_Repair", "Repaired: {}").format(names)
        else:
            text = translate("Bistable_Repair", "Nothing to repair: all objects are whole.")
        App.Console.PrintMessage(f"{text}\n")


def repair_document(doc):
    """`make.repair` as one undo step."""
    from .. import make

    doc.openTransaction(translate("Bistable_Repair", "Repair objects"))
    repaired = make.repair(doc)
    doc.commitTransaction()
    return repaired
