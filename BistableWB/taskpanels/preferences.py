# SPDX-License-Identifier: LGPL-2.1-or-later
"""The preferences page: printer, default hinge, colours. Files that exist are never changed."""

from PySide import QtCore, QtGui

from .. import colours, settings
from ..language.labels import CONTEXT, label_of, translate, translated
from ..origami.hinges.printers import CUSTOM, PRINTERS
from ..origami.hinges.processes import PROCESSES

_PRINTER = ("BedWidth", "BedDepth", "BedHeight", "NozzleDiameter", "LayerHeight")
_HINGE = ("FaceThickness", "GapLength", "GapBetweenPlanes")
_KINDS = {
    "contact": "Contact panels",
    "border": "Border panels",
    "primary": "Primary triangles",
    "secondary": "Secondary triangles",
}


class PreferencesPage:
    """What FreeCAD shows under Edit → Preferences → Bistable."""

    def __init__(self, parent=None):
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistablePreferences")
        self.form.setWindowTitle(translate("BistablePreferences", "General"))
        column = QtGui.QVBoxLayout(self.form)
        hint = QtGui.QLabel(
            translate(
                "BistablePreferences",
                "These values count for new objects and for checks; existing files stay as they "
                "are.",
            )
        )
        hint.setWordWrap(True)
        column.addWidget(hint)
        self.numbers, self.colours = {}, {}
        own = self._add_numbers(column, translate("BistablePreferences", "Printer"), _PRINTER)
        self.printer = printers_box()
        own.insertRow(0, translate("BistablePreferences", "Printer"), self.printer)
        self.process = QtGui.QComboBox()
        self.process.setObjectName("Process")
        for name, process in PROCESSES.items():
            self.process.addItem(translated(name), name)
            self.process.setItemData(self.process.count() - 1, process.what, QtCore.Qt.ToolTipRole)
        own.addRow(translated("Process"), self.process)
        self.printer.activated.connect(self._take_printer)
        self.process.activated.connect(self._take_process)
        hinge = self._add_numbers(
            column, translate("BistablePreferences", "Hinges of new objects"), _HINGE
        )
        self.pivot = QtGui.QComboBox()
        for name in settings.PIVOTS:
            self.pivot.addItem(translated(name), name)
        hinge.addRow(translated("Pivot"), self.pivot)
        self._add_colours(column)
        column.addStretch(1)
        self.loadSettings()

    def loadSettings(self):
        """Show the preferences."""
        for name, box in self.numbers.items():
            box.setValue(settings.number(name))
        self.pivot.setCurrentIndex(self.pivot.findData(settings.pivot()))
        self.printer.setCurrentIndex(self.printer.findData(settings.printer()))
        self.process.setCurrentIndex(self.process.findData(settings.process()))
        for kind, button in self.colours.items():
            rgb = settings.colour(kind)
            _paint(button, QtGui.QColor.fromRgbF(*rgb).name())

    def saveSettings(self):
        """Keep what is shown."""
        if self.printer.currentData() != settings.printer():
            settings.use_printer(self.printer.currentData())
        for name, box in self.numbers.items():
            settings.group().SetFloat(name, box.value())
        settings.group().SetString("Printer", self._printer_shown())
        settings.group().SetString("Process", self.process.currentData())
        settings.group().SetString("Pivot", self.pivot.currentData())
        for kind, button in self.colours.items():
            settings.set_panel_colour(kind, button.property("code"))

    def _take_printer(self, *_):
        """Show the numbers of the chosen printer."""
        name = self.printer.currentData()
        if name == CUSTOM:
            return
        for key, value in settings.numbers_of(name).items():
            self.numbers[key].setValue(value)
        self.process.setCurrentIndex(self.process.findData(PRINTERS[name].process))

    def _take_process(self, *_):
        """Show the hinge that the chosen process gives."""
        for key, value in settings.given_by(self.process.currentData()).items():
            self.numbers[key].setValue(value)

    def _printer_shown(self):
        """The chosen printer, unless what makes it that printer was changed."""
        name = self.printer.currentData()
        if name == CUSTOM:
            return name
        own = settings.numbers_of(name)
        same = all(abs(self.numbers[key].value() - own[key]) < 5e-3 for key in _PRINTER)
        same = same and self.process.currentData() == PRINTERS[name].process
        return name if same else CUSTOM

    def _add_numbers(self, column, title, names):
        box = QtGui.QGroupBox(title)
        form = QtGui.QFormLayout(box)
        for name in names:
            spin = QtGui.QDoubleSpinBox()
            spin.setObjectName(name)
            spin.setRange(0.01, 5000)
            spin.setDecimals(2)
            spin.setSingleStep(10 if name.startswith("Bed") else 0.1)
            spin.setSuffix(" mm")
            form.addRow(translated(label_of(name)), spin)
            self.numbers[name] = spin
        column.addWidget(box)
        return form

    def _add_colours(self, column):
        box = QtGui.QGroupBox(translate("BistablePreferences", "Colours of new objects"))
        form = QtGui.QFormLayout(box)
        for kind, text in _KINDS.items():
            button = QtGui.QPushButton()
            button.setObjectName(f"Colour_{kind}")
            button.clicked.connect(lambda *_, b=button: _choose(b))
            form.addRow(translate(CONTEXT, text), button)
            self.colours[kind] = button
        reset = QtGui.QPushButton(translate("BistablePreferences", "Default colours"))
        reset.clicked.connect(self._reset_colours)
        form.addRow(reset)
        column.addWidget(box)

    def _reset_colours(self):
        for kind, button in self.colours.items():
            _paint(button, colours.PANELS[kind])


def printers_box():
    """A list of the printers, the first of them the user's own numbers."""
    box = QtGui.QComboBox()
    box.setObjectName("Printer")
    box.addItem(translate("BistablePreferences", "Custom"), CUSTOM)
    for name, profile in PRINTERS.items():
        box.addItem(name, name)
        x, y, z = profile.bed
        tip = f"{x:g} × {y:g} × {z:g} mm, {translated(profile.process)}"
        box.setItemData(box.count() - 1, tip, QtCore.Qt.ToolTipRole)
    return box


def _choose(button):
    colour = QtGui.QColorDialog.getColor(QtGui.QColor(button.property("code")), button)
    if colour.isValid():
        _paint(button, colour.name())


def _paint(button, code):
    code = code.upper()
    button.setProperty("code", code)
    button.setText(code)
    picture = QtGui.QPixmap(32, 16)
    picture.fill(QtGui.QColor(code))
    button.setIcon(QtGui.QIcon(picture))
