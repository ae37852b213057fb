# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets for single properties, by their kind. A field reads, writes and explains itself."""

import contextlib

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..language.labels import label_of, translate, translated
from ..objects import type_of
from .counting import counts

# Property of kind Link -> type of object that it may link to.
LINKED = {
    "Curve": "Bistable::Curve",
    "Triangles": "Bistable::TrianglePlacement",
    "Unit": "Bistable::BistableUnit",
}
_SLIDER_STEPS = 1000
_NARROWEST = 100  # pixels: a number with its unit, the mark for formulas and the arrows
_PAUSE = 500  # ms without a key after which a number that is being typed is whole


class Field:
    """One property of ``obj`` as a row: ``label``, ``widget``, and ``error`` below it.

    ``changed(field)`` is called after the user has changed the property. Subclasses give
    ``build()`` (make ``self.widget``), ``show(value)`` and ``value()``.
    """

    def __init__(self, obj, prop, changed):
        self.obj, self.prop, self.name, self._changed = obj, prop, prop.name, changed
        self._quiet = False
        self.build()
        self.widget.setObjectName(self.name)
        self.label = QtGui.QLabel(translated(label_of(self.name)))
        self.error = QtGui.QLabel()
        self.error.setObjectName(f"{self.name}_error")
        self.error.setWordWrap(True)
        self.error.hide()
        for part in (self.label, self.widget):
            part.setToolTip(wrapped(translated(prop.tip)))
        self.refresh()

    def refresh(self):
        """Show what the property is now."""
        self._quiet = True
        self.show(getattr(self.obj, self.name))
        self._quiet = False

    def edited(self, *_):
        """The user has changed the widget: write the property."""
        if self._quiet or self.has_expression():
            return
        value = self.value()
        if value is not None:
            setattr(self.obj, self.name, value)
        self._changed(self)

    def settle(self):
        """What is being typed counts now."""

    def has_expression(self):
        """Whether a formula gives the property its value."""
        return any(path.lstrip(".") == self.name for path, _ in self.obj.ExpressionEngine)

    def is_hidden(self):
        """Whether the property does not count at the moment."""
        if "Hidden" in self.obj.getEditorMode(self.name):
            return True
        return not counts(self.obj, self.name)

    def explain(self, text, colour):
        """Show what is wrong with the input, or nothing."""
        self.error.setText(text)
        self.error.setStyleSheet(f"color: {colour}")
        self.error.setVisible(bool(text))


class Typed(Field):
    """A spin box: a number counts when it is whole, after a pause, on Enter or on leaving it.

    "4" is not what somebody who types "45" wants. Steps of the arrows and the wheel count at once.
    """

    def watch_typing(self, spin):
        """Let numbers that are typed into ``spin`` wait."""
        self._spin = spin
        self._pause = QtCore.QTimer(spin)
        self._pause.setSingleShot(True)
        self._pause.timeout.connect(self._whole)
        spin.findChild(QtGui.QLineEdit).textEdited.connect(lambda _: self._pause.start(_PAUSE))
        spin.editingFinished.connect(self.settle)

    def is_typing(self):
        """Whether a number is being typed."""
        return self._pause.isActive()

    def settle(self):
        """See `Field.settle`."""
        if self._pause.isActive():
            self._pause.stop()
            self._whole()

    def _whole(self):
        self._spin.interpretText()
        self.edited()


class Quantity(Typed):
    """Length, Angle or Float: a spin box with units and formulas."""

    UNITS = {"Length": "mm", "Angle": "deg", "Float": ""}

    def build(self):
        self.widget = Gui.UiLoader().createWidget("Gui::QuantitySpinBox")
        self.widget.setProperty("unit", self.UNITS[self.prop.kind])
        self.widget.setMinimumWidth(_NARROWEST)  # beside its name, in a dock as wide as usual
        bind(self.widget, self.obj, self.name)
        # not valueChanged: PySide knows this class as a QAbstractSpinBox only
        self.watch_typing(self.widget)  # first: it tells whether a change of text was typed
        self.widget.findChild(QtGui.QLineEdit).textChanged.connect(self._text_changed)

    def _text_changed(self, *_):
        if not self.is_typing():
            self.edited()

    def show(self, value):
        self.widget.setProperty("rawValue", getattr(value, "Value", value))

    def value(self):
        raw, now = self.widget.property("rawValue"), getattr(self.obj, self.name)
        return None if raw == getattr(now, "Value", now) else raw


class Number(Typed):
    """Integer: a spin box; the whole numbers that we have are odd."""

    def build(self):
        self.widget = Gui.UiLoader().createWidget("Gui::IntSpinBox")
        self.widget.setRange(-1000, 1000)
        self.widget.setSingleStep(2)
        self.widget.setKeyboardTracking(False)
        bind(self.widget, self.obj, self.name)
        self.watch_typing(self.widget)
        self.widget.valueChanged.connect(self.edited)

    def show(self, value):
        self.widget.setValue(value)

    def value(self):
        return self.widget.value()


class Fraction(Typed):
    """A number from 0 to 1: slider and spin box."""

    def build(self):
        self.widget = QtGui.QWidget()
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setRange(0, _SLIDER_STEPS)
        self.spin = Gui.UiLoader().createWidget("Gui::DoubleSpinBox")
        self.spin.setRange(0, 1)
        self.spin.setDecimals(3)
        self.spin.setSingleStep(0.05)
        self.spin.setKeyboardTracking(False)
        bind(self.spin, self.obj, self.name)
        self.watch_typing(self.spin)
        row = QtGui.QHBoxLayout(self.widget)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.slider, 1)
        row.addWidget(self.spin)
        self.slider.valueChanged.connect(lambda step: self.spin.setValue(step / _SLIDER_STEPS))
        self.spin.valueChanged.connect(self._spun)

    def _spun(self, value):
        self.slider.blockSignals(True)
        self.slider.setValue(round(value * _SLIDER_STEPS))
        self.slider.blockSignals(False)
        self.edited()

    def show(self, value):
        self.spin.setValue(value)
        self._spun(value)

    def value(self):
        return self.spin.value()


class Choice(Field):
    """Enumeration: a list of its values."""

    def build(self):
        self.widget = _list()
        for text in self.obj.getEnumerationsOfProperty(self.name):
            self.widget.addItem(translated(text), text)
        self.widget.currentIndexChanged.connect(self.edited)

    def show(self, value):
        self.widget.setCurrentIndex(self.widget.findData(value))

    def value(self):
        return self.widget.currentData()


class Switch(Field):
    """Bool: a box to tick."""

    def build(self):
        self.widget = QtGui.QCheckBox()
        self.widget.toggled.connect(self.edited)

    def show(self, value):
        self.widget.setChecked(value)

    def value(self):
        return self.widget.isChecked()


class Vector(Field):
    """Three coordinates."""

    def build(self):
        self.widget = QtGui.QWidget()
        row = QtGui.QHBoxLayout(self.widget)
        row.setContentsMargins(0, 0, 0, 0)
        self.boxes = []
        for _ in range(3):
            box = QtGui.QDoubleSpinBox()
            box.setRange(-1e6, 1e6)
            box.setDecimals(2)
            box.setMinimumWidth(40)
            box.setButtonSymbols(QtGui.QAbstractSpinBox.NoButtons)
            box.valueChanged.connect(self.edited)
            row.addWidget(box)
            self.boxes.append(box)

    def show(self, value):
        for box, coordinate in zip(self.boxes, value, strict=True):
            box.setValue(coordinate)

    def value(self):
        return App.Vector(*(box.value() for box in self.boxes))


class Link(Field):
    """Another object of the document, of the type that fits."""

    def build(self):
        self.widget = _list()
        self.widget.addItem(translate("BistablePanel", "(none)"), "")
        for other in self.obj.Document.Objects:
            if type_of(other) == LINKED.get(self.name) and other not in self.obj.InListRecursive:
                self.widget.addItem(other.Label, other.Name)
        self.widget.currentIndexChanged.connect(self.edited)

    def show(self, value):
        self.widget.setCurrentIndex(max(0, self.widget.findData(value.Name if value else "")))

    def edited(self, *_):
        if not self._quiet:
            name = self.widget.currentData()
            setattr(self.obj, self.name, self.obj.Document.getObject(name) if name else None)
            self._changed(self)


class Source(Field):
    """Geometry of other objects: taken from the selection."""

    def build(self):
        self.widget = QtGui.QWidget()
        self.text = QtGui.QLabel()
        self.text.setWordWrap(True)
        take = QtGui.QPushButton(translate("BistablePanel", "Use selection"))
        take.setObjectName("UseSelection")
        clear = QtGui.QToolButton()
        clear.setText("×")
        clear.setToolTip(translate("BistablePanel", "Follow the control points instead"))
        take.clicked.connect(self._take)
        clear.clicked.connect(lambda: self._set(None))
        row = QtGui.QHBoxLayout(self.widget)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.text, 1)
        row.addWidget(take)
        row.addWidget(clear)

    def _take(self):
        from ..scene.chosen import edges

        found = edges()
        if found:
            self._set(found)
        else:
            nothing = translate("BistablePanel", "Select a sketch, a wire or edges first.")
            self.explain(nothing, error_colour(self.widget))

    def _set(self, value):
        setattr(self.obj, self.name, value)
        self.refresh()
        self._changed(self)

    def show(self, value):
        if value is None:
            self.text.setText(translate("BistablePanel", "none: the points count"))
        else:
            parts = ", ".join(name for name in value[1] if name)
            self.text.setText(f"{value[0].Label} {parts}".strip())


KINDS = {
    "Length": Quantity,
    "Angle": Quantity,
    "Float": Quantity,
    "Integer": Number,
    "FloatConstraint": Fraction,
    "Enumeration": Choice,
    "Bool": Switch,
    "Vector": Vector,
    "Link": Link,
    "LinkSub": Source,
}


def _list():
    """A list that is no wider than its row: its texts may be cut, and are whole when it opens."""
    box = QtGui.QComboBox()
    box.setSizeAdjustPolicy(QtGui.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(4)
    box.setMinimumWidth(_NARROWEST)
    return box


def bind(widget, obj, name):
    """Let the spin box take formulas for a property."""
    with contextlib.suppress(TypeError):  # FreeCAD 0.20 binds boxes of quantities only
        Gui.ExpressionBinding(widget).bind(obj, name)


def wrapped(text):
    """A tooltip that Qt breaks into lines."""
    return f"<p>{text}</p>" if text else ""


def error_colour(widget):
    """A red that can be read on the widget's theme."""
    dark = widget.palette().color(QtGui.QPalette.Window).lightness() < 128
    return "#ff8a80" if dark else "#b3261e"
