# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an export: what else a format can do, as fields; OK writes the file."""

from pathlib import Path

from PySide import QtGui

from .base import icon
from .texts import translate

_SHEETS = ("A4", "A3", "A2", "A1", "A0")

# Suffix -> the exporter's options that the panel offers.
OPTIONS = {
    ".svg": ("sheet", "tabs", "tab_depth", "colours"),
    ".dxf": ("sheet", "tabs", "tab_depth"),
    ".fold": ("deployment_frames", "title", "author"),
}


class ExportPanel:
    """Options for writing ``obj`` to ``path``; OK calls ``write(obj, path, **options)``."""

    def __init__(self, obj, path, write):
        self.obj, self.path, self._write = obj, Path(path), write
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistableExport")
        title = translate("BistableExport", "Export {}").format(self.path.name)
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(icon("ExportPrint"))
        form = QtGui.QFormLayout(self.form)
        form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        self.fields = {name: _FIELDS[name]() for name in OPTIONS[self.path.suffix.lower()]}
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
        if self._write(self.obj, str(self.path), **self.options()):
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


_FIELDS = {
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
