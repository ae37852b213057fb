# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a calibration plate: its numbers, and what came out of the printer."""

import FreeCADGui as Gui
from PySide import QtGui

from .. import settings
from ..language.labels import translate
from ..origami.hinges.calibration import AIR_LAYERS
from .base import ObjectPanel


class CalibrationPanel(ObjectPanel):
    """Two questions; OK keeps the answers for this printer."""

    def build_more(self, column):
        """The questions, with what is known already as the answer."""
        box = QtGui.QGroupBox(translate("BistableCalibration", "When it is printed"))
        form = QtGui.QFormLayout(box)
        form.setRowWrapPolicy(QtGui.QFormLayout.WrapAllRows)
        self.tightest, self.apart = QtGui.QComboBox(), QtGui.QComboBox()
        self.tightest.setObjectName("TightestThatTurns")
        self.apart.setObjectName("AirLayers")
        for layers in AIR_LAYERS:
            text = translate("BistableCalibration", "the pair with the number {}").format(layers)
            self.apart.addItem(text, layers)
        self.apart.addItem(translate("BistableCalibration", "none of them"), settings.NO_AIR)
        self.apart.insertItem(0, translate("BistableCalibration", "not tried yet"), 0)
        self.apart.setCurrentIndex(max(self.apart.findData(settings.air_layers()), 0))
        questions = (
            translate("BistableCalibration", "Which is the tightest hinge that turns?"),
            translate("BistableCalibration", "Which pair of plates came apart? (the lower number)"),
        )
        for question, answer in zip(questions, (self.tightest, self.apart), strict=True):
            label = QtGui.QLabel(question)
            label.setWordWrap(True)
            form.addRow(label, answer)
        column.insertWidget(0, box)

    def show_state(self):
        """Offer the hinges that are on the plate."""
        super().show_state()
        chosen = self.tightest.currentData() if self.tightest.count() else None
        chosen = settings.calibrated_clearance() if chosen is None else chosen
        self.tightest.clear()
        self.tightest.addItem(translate("BistableCalibration", "not tried yet"), 0.0)
        for clearance in self.obj.Clearances:
            text = f"{round(100 * clearance)}: {clearance:.2f} mm"
            self.tightest.addItem(text, round(clearance, 6))
            if abs(clearance - chosen) < 1e-6:
                self.tightest.setCurrentIndex(self.tightest.count() - 1)

    def accept(self):
        """Keep the plate, then what came out, where something was said."""
        if not super().accept():
            return False
        answers = self.tightest.currentData() or None, self.apart.currentData() or None
        if answers != (None, None):
            Gui.doCommand("from BistableWB import settings")
            Gui.doCommand(f"settings.keep_calibration{answers!r}")
        return True
