# SPDX-License-Identifier: LGPL-2.1-or-later
"""What Auto-fit is asked: fields for an `search.Wanted`, filled from what is known."""

from dataclasses import replace

from PySide import QtGui

from .. import settings
from ..language.labels import label_of, translate, translated
from ..objects.hinge_inputs import hinge_parameters
from ..origami.fit.search import Wanted

# Field of `Wanted` -> name by which its errors call it, suffix, decimals, step.
_FIELDS = {
    "margin": ("Margin", "", 2, 0.1),
    "face_thickness": ("FaceThickness", " mm", 2, 0.2),
    "gap_between_planes": ("GapBetweenPlanes", " mm", 2, 0.2),
    "play": ("HingePlay", " mm", 2, 0.01),
    "height_ratio": ("HeightRatio", "", 2, 0.1),
}


class Requirements:
    """A box of fields. Panels and hinges are as in a HingeSet, or as the preferences have them.

    ``only``: which fields of `Wanted`, beside the bed; ``usual``: what they start with.
    """

    def __init__(self, hinges=None, unit=None, only=tuple(_FIELDS), **usual):
        self.box = QtGui.QGroupBox(translate("BistableAutoFit", "Wanted"))
        form = QtGui.QFormLayout(self.box)
        form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
        form.setVerticalSpacing(3)
        self.errors = {}
        known = self._known = replace(_known(hinges, unit), **usual)
        self.bed = [_spin("Bed", " mm", 0, 10, size) for size in known.bed]
        row = QtGui.QHBoxLayout()
        row.setSpacing(2)
        for spin, side in zip(self.bed, "xyz", strict=True):
            spin.setObjectName(f"Bed_{side}")
            spin.setSuffix("")
            row.addWidget(spin)
        self._add(form, "Bed", row)
        self.fields = {}
        for field in only:
            name, suffix, decimals, step = _FIELDS[field]
            value = getattr(known, field)
            self.fields[field] = spin = _spin(name, suffix, decimals, step, value)
            self._add(form, name, spin)

    def wanted(self):
        """The `Wanted` of the fields."""
        bed = tuple(spin.value() for spin in self.bed)
        fields = {field: spin.value() for field, spin in self.fields.items()}
        return replace(self._known, bed=bed, **fields)

    def explain(self, reason, colour, name=None):
        """Show what is wrong beside the field ``name`` only; True if there is such a field.

        Without a name nothing is wrong anywhere.
        """
        for known, label in self.errors.items():
            label.setText(reason if known == name else "")
            label.setStyleSheet(f"color: {colour}")
            label.setVisible(known == name)
        return name in self.errors

    def _add(self, form, name, widget):
        label = label_of({"Margin": "TargetMargin"}.get(name, name))
        text = translate("BistableAutoFit", "Bed, mm") if name == "Bed" else translated(label)
        form.addRow(text, widget)
        self.errors[name] = error = QtGui.QLabel()
        error.setObjectName(f"{name}_error")
        error.setWordWrap(True)
        error.hide()
        form.addRow(error)


def _known(hinges, unit):
    """A `Wanted` by the objects that there are, else by the preferences."""
    parameters = hinge_parameters(hinges) if hinges else settings.hinge()
    own = tuple(hinges.Bed) if hinges else ()
    return Wanted(
        bed=own if any(own) else settings.bed(),
        face_thickness=parameters.face_thickness,
        gap_between_planes=parameters.gap_between_planes,
        play=parameters.play,
        hinges=parameters,
        **({"height_ratio": unit.HeightRatio} if unit else {}),
    )


def _spin(name, suffix, decimals, step, value):
    spin = QtGui.QDoubleSpinBox()
    spin.setObjectName(name)
    spin.setRange(0, 5000)
    spin.setDecimals(decimals)
    spin.setSingleStep(step)
    spin.setSuffix(suffix)
    spin.setMinimumWidth(40)
    spin.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
    spin.setValue(value)
    return spin
