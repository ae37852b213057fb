# SPDX-License-Identifier: LGPL-2.1-or-later
"""A row that aims at what a tube carries, or at what a hand feels, beside the window."""

from PySide import QtGui

from .. import fitting
from ..language.labels import translate
from .measure import MeasureButton


class AimChoice(QtGui.QWidget):
    """A number, and what it is of; ``margin_too``: it may be that nothing but a margin counts."""

    def __init__(self, margin_too=False):
        super().__init__()
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self.kind = QtGui.QComboBox()
        self.kind.setObjectName("AimKind")
        if margin_too:
            self.kind.addItem(translate("BistablePlots", "snap margin only"), "")
        self.kind.addItem(translate("BistablePlots", "carries itself, times"), "carry")
        self.kind.addItem(translate("BistablePlots", "force of a hand, N"), "force")
        self.kind.setToolTip(translate(
            "BistablePlots", "Every unit carries what hangs on it so many times, whatever way the "
            "tube is turned; or hands that pull ‖AB‖ from the leg at B open it with this force"
        ))  # fmt: skip
        self.number = QtGui.QDoubleSpinBox()
        self.number.setObjectName("AimNumber")
        self.number.setRange(0.1, 1000)
        self.number.setSingleStep(0.1)
        self.number.setValue(1.5)
        for widget in (self.kind, self.number):
            row.addWidget(widget)
        self.kind.currentIndexChanged.connect(self._chosen)
        self._chosen()

    def asked(self):
        """Arguments of `fitting.aim_task`; none where only the margin counts."""
        name = self.kind.currentData()
        return {name: self.number.value()} if name else {}

    def take(self, asked):
        """Show what another one ``asked``."""
        for name, number in asked.items():
            self.kind.setCurrentIndex(self.kind.findData(name))
            self.number.setValue(number)

    def _chosen(self, *_):
        self.number.setVisible(bool(self.kind.currentData()))


class AimRow(QtGui.QWidget):
    """What to aim at, and the button that gives each unit the margin for it.

    ``done(error)`` as of `MeasureButton`.
    """

    def __init__(self, done):
        super().__init__()
        row = QtGui.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self.choice = AimChoice()
        self.kind, self.number = self.choice.kind, self.choice.number
        self.button = AimButton(done, self.choice.asked)
        for widget in (self.button, self.choice):
            row.addWidget(widget)

    def aim(self, asked):
        """Aim at it, as if it had been chosen and clicked."""
        self.choice.take(asked)
        if not self.button.is_busy:
            self.button.click()

    def ask_about(self, obj):
        """The HingeSet that a click aims."""
        self.button.ask_about(obj)


class AimButton(MeasureButton):
    """Searches each unit's margin, and sets them."""

    def __init__(self, done, asked):
        self._asked = asked
        super().__init__(done)
        self.setObjectName("Aim")

    def task(self):
        return fitting.aim_task(self.obj, **self._asked())

    def texts(self):
        return translate("BistablePlots", "Aim"), translate("BistablePlots", "Stop ({:.0%})")
