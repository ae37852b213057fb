# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an object: its table of properties as grouped fields, live, in one undo step."""

import contextlib
import time

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import ICONS, make
from ..language.labels import label_of, translate, translated, value_text
from ..language.words import in_words
from ..objects import is_heavy, later, type_of
from ..objects.base import Hidden, Result
from ..objects.refused import refusal_of, warnings_of
from ..origami.progress import Cancelled
from .fields import KINDS, error_colour, wrapped
from .folding import BASICS, Fold, form_in
from .macro import inputs_of, record_changes

_WAIT = 80  # ms after the last change before the preview follows
_SLOW = 0.3  # s: a preview that takes longer waits for a pause of the user
_LONGEST = 3000  # ms that it waits


class ObjectPanel:
    """Edits one object. ``form`` is what FreeCAD shows; accept and reject are its buttons."""

    def __init__(self, obj):
        self.obj, self.doc, self.name = obj, obj.Document, obj.Name
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistablePanel")
        self.form.setWindowTitle(obj.Label)
        self.form.setWindowIcon(QtGui.QIcon(obj.ViewObject.Proxy.getIcon()))
        self.touched_before = {o.Name for o in self.doc.Objects if "Touched" in o.State}
        self.inputs_before = inputs_of(obj)
        title = translate("BistablePanel", "Edit {}").format(obj.Label)
        if not self.doc.HasPendingTransaction:  # a command that has just made the object
            self.doc.openTransaction(title)
        self._timer = QtCore.QTimer(self.form)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._preview)
        self._wait = _WAIT
        self._build()
        self.show_state()

    # what FreeCAD calls

    def getStandardButtons(self):
        """OK and Cancel."""
        box = QtGui.QDialogButtonBox
        return sum(int(getattr(button, "value", button)) for button in (box.Ok, box.Cancel))

    def accept(self):
        """OK: compute everything, keep it as one undo step. Stay open where it cannot be."""
        for field in self.fields.values():
            field.settle()
        record_changes(self.obj, self.inputs_before)
        if not self.recompute_all():
            return False
        self.close()
        self.doc.commitTransaction()
        Gui.getDocument(self.doc.Name).resetEdit()
        return True

    def reject(self):
        """Cancel: the document is as it was."""
        self.close()
        self.doc.abortTransaction()
        if self.doc.getObject(self.name):  # else it was made by the command that is cancelled
            self._compute_cheap()
        for other in self.doc.Objects:
            if is_heavy(other) and not other.isValid():
                self.doc.recompute([other])  # a refused input left its mark
            elif "Touched" in other.State and other.Name not in self.touched_before:
                other.purgeTouched()
        Gui.getDocument(self.doc.Name).resetEdit()
        return True

    def close(self):
        """Stop what goes on beside the panel."""
        self._timer.stop()

    # building

    @property
    def is_heavy(self):
        """Whether the object is made on Apply and OK only."""
        return is_heavy(self.obj)

    def _build(self):
        column = QtGui.QVBoxLayout(self.form)
        column.setSpacing(0)
        self.message = QtGui.QLabel()
        self.message.setObjectName("Message")
        self.message.setWordWrap(True)
        self.message.hide()
        self.fields, self.results, self.folds, self._fold_of = {}, {}, {}, {}
        self._type = self.obj.Proxy.Type
        basics = QtGui.QWidget()
        self._basic = form_in(basics)
        column.addWidget(basics)
        for prop in self.obj.Proxy.PROPERTIES:
            if isinstance(prop, Hidden):
                continue
            if isinstance(prop, Result):
                self._add_result(column, prop)
            elif prop.kind in KINDS:
                field = KINDS[prop.kind](self.obj, prop, self.changed)
                self.add_row(column, prop.group, field)
        self.build_more(column)
        column.addWidget(self.message)
        column.addStretch(1)
        self._follow_hidden()

    def build_more(self, column):
        """Add widgets of a special panel; nothing here."""

    def add_row(self, column, group, field):
        """Put a field into the box of its group."""
        form = self.form_of(column, group, field.name)
        self.fields[field.name] = field
        form.addRow(field.label, field.widget)
        form.addRow(field.error)

    def form_of(self, column, group, name):
        """The form that a property stands in: the basic one, or that of its group."""
        if name in BASICS.get(self._type, ()):
            return self._basic
        if group not in self.folds:
            self.folds[group] = Fold(self._type, group, translated(group))
            column.addWidget(self.folds[group])
        self._fold_of[name] = self.folds[group]
        return self.folds[group].form

    def _add_result(self, column, prop):
        text = QtGui.QLabel()
        text.setObjectName(f"{prop.name}_result")
        text.setWordWrap(True)
        text.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        label = QtGui.QLabel(translated(label_of(prop.name)))
        for part in (label, text):
            part.setToolTip(wrapped(translated(prop.tip)))
        if prop.name.startswith("Body") and prop.kind != "Integer":
            return  # lists of all bodies
        if prop.name == "SnapMargins" and not self.obj.SnapMargins:
            return
        if prop.name == "Warnings":  # never folded away
            column.addWidget(text)
            self.results[prop.name] = text
            return
        form = self.form_of(column, prop.group, prop.name)
        if prop.kind == "StringList":
            form.addRow(label)
            form.addRow(text)
        else:
            form.addRow(label, text)
        self.results[prop.name] = text

    def _follow_hidden(self):
        for field in self.fields.values():
            for part in (field.label, field.widget):
                if part.parent():  # else it would become a window
                    part.setVisible(not field.is_hidden())
        for fold in self.folds.values():
            inside = [name for name, its in self._fold_of.items() if its is fold]
            fold.setVisible(
                any(n in self.results or not self.fields[n].is_hidden() for n in inside)
            )

    # following changes

    def changed(self, field):
        """A property was changed by ``field``: what depends on it follows soon."""
        for other in self.fields.values():
            if other is not field:
                other.refresh()  # setting one property may set another
        self._follow_hidden()
        if self.is_heavy:
            self.say(translate("BistablePanel", "Press Apply or OK to make the solids anew."))
        elif self._wait > _WAIT:  # slow: not before the user pauses
            self._timer.start(self._wait)
        elif not self._timer.isActive():  # not anew: a long drag must not starve the preview
            self._timer.start(_WAIT)

    def _preview(self):
        start = time.perf_counter()
        self._compute_cheap()
        self.show_state()
        took = time.perf_counter() - start
        self._wait = _WAIT if took < _SLOW else min(round(1000 * took), _LONGEST)
        if took >= _SLOW and not self.message.text():
            self.say(translate("BistablePanel", "The preview is slow: it follows when you pause."))

    def _compute_cheap(self):
        chain = [self.obj, *self.obj.InListRecursive]
        cheap = [o for o in chain if type_of(o) and not is_heavy(o)]
        if cheap:
            self.doc.recompute(cheap)

    def recompute_all(self):
        """Compute the document; False, with the reason beside the field, where it is refused."""
        self._timer.stop()
        if not self._make_heavy():
            self.say(translate("BistablePanel", "Cancelled: the solids are as they were."))
            return False
        with later.leaving():  # solids of objects above follow beside the window
            self.doc.recompute()
        self.show_state()
        return self.obj.isValid()

    def _make_heavy(self):
        """Make the object's own solids, where Esc can stop it; False if it did."""
        if is_heavy(self.obj):
            try:
                make.make_solids(self.obj)
            except Cancelled:
                return False
        return True

    def show_state(self):
        """Results, and what is wrong with which input."""
        for name, label in self.results.items():
            value = getattr(self.obj, name)
            if name == "Warnings":
                value = [in_words(one) for one in warnings_of(self.obj)]
            elif isinstance(value, str):  # one of our words, such as the kind that was found
                value = translated(value)
            label.setText(value_text(value))
            if name == "Warnings":
                label.setVisible(bool(value))
        self.say("")
        for field in self.fields.values():
            field.explain("", "")
        for other in [self.obj, *self.obj.InListRecursive]:
            if type_of(other) and not other.isValid():
                self._explain(other)
                return

    def _explain(self, other):
        refusal, colour = refusal_of(other), error_colour(self.form)
        reason, field = in_words(refusal), self.fields.get(refusal.parameter)
        if other is self.obj and field and not field.is_hidden():
            field.explain(reason, colour)
            if refusal.parameter in self._fold_of:
                self._fold_of[refusal.parameter].unfold()
        else:
            self.say(reason if other is self.obj else f"{other.Label}: {reason}", colour)

    def say(self, text, colour=""):
        """A message below all fields, or none."""
        self.message.setText(text)
        self.message.setStyleSheet(f"color: {colour}" if colour else "")
        self.message.setVisible(bool(text))


class HeavyPanel(ObjectPanel):
    """For objects that take long: made on Apply and OK."""

    def build_more(self, column):
        """The button that makes the object with the inputs as they are."""
        self.apply = QtGui.QPushButton(translate("BistablePanel", "Apply"))
        self.apply.setObjectName("Apply")
        self.apply.clicked.connect(self.recompute_all)
        column.addWidget(self.apply)


def open_panel(obj):
    """Edit ``obj`` in a panel, unless another one is open; True if it was opened."""
    from . import panel_for

    if Gui.Control.activeDialog():
        App.Console.PrintWarning(translate("BistablePanel", "Close the open task first.") + "\n")
        return False
    Gui.Control.showDialog(panel_for(obj))
    return True


def icon(name):
    """An icon of the workbench."""
    return QtGui.QIcon(str(ICONS / f"{name}.svg"))


def is_there(obj):
    """Whether a document object still exists."""
    with contextlib.suppress(ReferenceError, AttributeError):
        return obj is not None and bool(obj.Name)
    return False
