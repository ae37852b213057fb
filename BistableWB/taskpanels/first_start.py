# SPDX-License-Identifier: LGPL-2.1-or-later
"""Asks once which printer there is, beside the window; who does not answer goes on as before."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import settings
from ..language.labels import translate
from ..origami.hinges.printers import CUSTOM
from .preferences import printers_box

_SOON = 1500  # ms after the workbench was activated
_open = []  # Qt forgets a dialog that nobody holds


def ask_later():
    """Ask when the window has settled, unless that was asked before."""
    if not settings.printer_was_asked():
        QtCore.QTimer.singleShot(_SOON, ask)


def ask():
    """Show the question; it blocks nothing. None where it was asked, or no window is seen."""
    window = Gui.getMainWindow()
    if settings.printer_was_asked() or not window.isVisible():
        return None
    dialog = PrinterQuestion(window)
    _open[:] = [dialog]
    dialog.show()
    return dialog


class PrinterQuestion(QtGui.QDialog):
    """Which printer new tubes are for."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("BistablePrinterQuestion")
        self.setWindowTitle(translate("BistableFirstStart", "Your printer"))
        self.setModal(False)
        column = QtGui.QVBoxLayout(self)
        text = QtGui.QLabel(
            translate(
                "BistableFirstStart",
                "New tubes are made for this printer: its bed, nozzle and layers. You can change "
                "it under Edit → Preferences → Bistable.",
            )
        )
        text.setWordWrap(True)
        column.addWidget(text)
        self.printer = printers_box()
        self.printer.setItemText(0, translate("BistableFirstStart", "Another one"))
        column.addWidget(self.printer)
        buttons = QtGui.QDialogButtonBox()
        take = translate("BistableFirstStart", "Use it")
        self.take = buttons.addButton(take, QtGui.QDialogButtonBox.AcceptRole)
        later = translate("BistableFirstStart", "Not now")
        self.later = buttons.addButton(later, QtGui.QDialogButtonBox.RejectRole)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        column.addWidget(buttons)

    def done(self, result):
        """However it is closed, it is not asked again."""
        if result == QtGui.QDialog.Accepted and self.printer.currentData() != CUSTOM:
            settings.use_printer(self.printer.currentData())
        settings.keep_printer_asked()
        super().done(result)
