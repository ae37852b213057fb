# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an export: what else a format can do, as fields; OK writes the file."""

from pathlib import Path

from PySide import QtCore, QtGui

from ..exporters import FORMATS, suffix_of
from ..language.labels import translate, translated
from ..origami.patterns.panel_hinges import PANEL_HINGES
from .base import icon

_SHEETS = ("A4", "A3", "A2", "A1", "A0")


class ExportPanel:
    """Options of the file ``path``; OK calls ``write(objects, path, **options)``."""

    def __init__(self, objects, path, write):
        self.objects, self.path, self._write = objects, Path(path), write
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistableExport")
        title = translate("BistableExport", "Export {}").format(self.path.name)
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(icon("ExportPrint"))
        form = QtGui.QFormLayout(self.form)
        form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        self.fields = {name: _FIELDS[name]() for name in FORMATS[suffix_of(self.path)].panel}
        for name, field in self.fields.items():
            field.widget.setObjectName(name)
            form.addRow(field.label, field.widget)
        if "tabs" in self.fields:
            depth = self.fields["tab_depth"].widget
            depth.setEnabled(False)
            self.fields["tabs"].widget.toggled.connect(depth.setEnabled)
        self.message = QtGui.QLabel()
        self.message.setWordWrap(True)
        self.message.hide()
        form.addRow(self.message)

    def getStandardButtons(self):
        """OK and Cancel."""
        box = QtGui.QDialogButtonBox
        return sum(int(getattr(b, "value", b)) for b in (box.Ok, box.Cancel))

    def options(self):
        """What is chosen, without what is left as it would be anyway."""
        chosen = {name: field.value() for name, field in self.fields.items()}
        return {name: value for name, value in chosen.items() if value not in (None, "", False)}

    def accept(self):
        """OK: write the file. Stay open where that cannot be."""
        if self._write(self.objects, str(self.path), **self.options()):
            return True
        text = translate("BistableExport", "{} was not written: the report view says why.")
        self.message.setText(text.format(self.path.name))
        self.message.show()
        return False

    def reject(self):
        """Cancel: nothing is written."""
        return True


class _Sheet:
    def __init__(self):
        self.label = translate("BistableExport", "Sheet")
        self.widget = QtGui.QComboBox()
        self.widget.addItem(translate("BistableExport", "the smallest that will do"), None)
        for name in _SHEETS:
            self.widget.addItem(name, name)

    def value(self):
        return self.widget.currentData()


class _Switch:
    def __init__(self, label, tip):
        self.label, self.widget = label, QtGui.QCheckBox()
        self.widget.setToolTip(tip)

    def value(self):
        return self.widget.isChecked()


class _Depth:
    def __init__(self):
        self.label = translate("BistableExport", "Depth of tabs")
        self.widget = QtGui.QDoubleSpinBox()
        self.widget.setRange(0.5, 100)
        self.widget.setSuffix(" mm")
        self.widget.setValue(6)

    def value(self):
        return self.widget.value() if self.widget.isEnabled() else None


class _Frames:
    def __init__(self):
        self.label = translate("BistableExport", "States on the way")
        self.widget = QtGui.QSpinBox()
        self.widget.setRange(0, 1000)
        self.widget.setSpecialValueText(translate("BistableExport", "none"))
        self.widget.setToolTip(
            translate("BistableExport", "States between flat and deployed, as a series of frames")
        )

    def value(self):
        return self.widget.value() or None


class _Text:
    def __init__(self, label):
        self.label, self.widget = label, QtGui.QLineEdit()

    def value(self):
        return self.widget.text().strip()


class _Length:
    def __init__(self, label, tip, usual, largest=1000):
        self.label, self.usual = label, usual
        self.widget = QtGui.QDoubleSpinBox()
        self.widget.setRange(0, largest)
        self.widget.setSuffix(" mm")
        self.widget.setValue(usual)
        self.widget.setToolTip(tip)

    def value(self):
        return self.widget.value() if self.widget.value() != self.usual else None


class _Hinge:
    def __init__(self):
        self.label = translate("BistableExport", "Hinges")
        self.widget = QtGui.QComboBox()
        for name, hinge in PANEL_HINGES.items():
            self.widget.addItem(translated(name), name)
            self.widget.setItemData(self.widget.count() - 1, hinge.what, QtCore.Qt.ToolTipRole)

    def value(self):
        return self.widget.currentData() if self.widget.currentIndex() else None


class _Stock:
    def __init__(self):
        self.label = translate("BistableExport", "Sheets to cut from, mm")
        self.widget = QtGui.QLineEdit("2500x1250")
        self.widget.setToolTip(translate("BistableExport", "Width x height of a sheet"))

    def value(self):
        text = self.widget.text().strip()
        return text if text != "2500x1250" else None


_FIELDS = {
    "panel_thickness": lambda: _Length(
        translate("BistableExport", "Thickness of panels"),
        translate("BistableExport", "Thickness of the sheets that panels are cut from"),
        18.0,
    ),
    "panel_hinge": _Hinge,
    "stock": _Stock,
    "kerf": lambda: _Length(
        translate("BistableExport", "Kerf"),
        translate("BistableExport", "Width of the cut: paths run half of it outside the panels"),
        0.0,
    ),
    "edge_gap": lambda: _Length(
        translate("BistableExport", "Gap at the edges"),
        translate("BistableExport", "How far panels end before the axes of their hinges"),
        0.5,
    ),
    "sheet": _Sheet,
    "tabs": lambda: _Switch(
        translate("BistableExport", "Glue tabs"),
        translate("BistableExport", "A tab along every seam"),
    ),
    "tab_depth": _Depth,
    "colours": lambda: _Switch(
        translate("BistableExport", "Colours"),
        translate("BistableExport", "Fill the panels in the colours of their kinds"),
    ),
    "deployment_frames": _Frames,
    "title": lambda: _Text(translate("BistableExport", "Title")),
    "author": lambda: _Text(translate("BistableExport", "Author")),
}
