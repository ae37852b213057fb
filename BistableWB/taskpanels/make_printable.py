# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of *Make it printable*: a search beside the window, what it changes and why, OK."""

from html import escape

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from PySide import QtCore, QtGui

from .. import colours, fitting, settings
from ..language.labels import label_of, translate, translated, value_text
from ..language.words import in_words
from ..objects import TYPES, proxy_class
from ..origami.errors import Phrase, Refusal
from ..recording.script import Script
from ..scene.motion import FacesMotion
from ..scene.overlay import DASHES, SOLID, polyline
from ..scene.stand_in import StandIn
from .aside import Aside
from .base import icon
from .fields import error_colour
from .requirements import Requirements

_POLL = 80  # ms between looks at the search
_DRAWN = (colours.rgb("#FFFFFF"), 5.0, SOLID), (colours.rgb("#5B6770"), 3.0, DASHES)
_FOLLOWED = (colours.rgb("#FFFFFF"), 5.0, SOLID), (colours.rgb(colours.CURVE), 3.0, SOLID)
_UNITS = {"Length": " mm", "Angle": "°"}
_SAMPLES = np.linspace(0, 1, 241)


class MakePrintablePanel:
    """Makes the tube along a curve printable; the document is changed by OK only, in one undo step.

    ``source``: a Curve, something along it, or edges, (object, names), for a new Curve.
    """

    def __init__(self, source):
        self.source = source
        self.chain = fitting.chain_of(source)
        self.doc = self.chain.document
        self.request = self.proposal = None
        self._search = self._shown = None
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistableMakePrintable")
        self.form.setWindowTitle(translate("BistablePrintable", "Make it printable"))
        self.form.setWindowIcon(icon("MakePrintable"))
        self._build()
        self._timer = QtCore.QTimer(self.form)
        self._timer.timeout.connect(self._follow)

    # what FreeCAD calls

    def getStandardButtons(self):
        """OK and Cancel."""
        box = QtGui.QDialogButtonBox
        return sum(int(getattr(b, "value", b)) for b in (box.Ok, box.Cancel))

    def accept(self):
        """OK: what was found becomes the document's. Stay open where there is nothing."""
        if self.proposal is None or self.proposal.found is None:
            self.say(translate("BistablePrintable", "Nothing has been found yet."))
            return False
        self.reject()
        App.setActiveDocument(self.doc.Name)
        with Script(translate("BistablePrintable", "Make it printable")) as script:
            for line in self._lines():
                script.add(line)
            for line in self._views():
                script.view(line)
        return True

    def reject(self):
        """Cancel, or Esc: a search that still runs is forgotten, the view is as it was."""
        self._timer.stop()
        if self._search:
            self._search.stop()
        self._hide_preview()
        return True

    # the panel

    def _build(self):
        column = QtGui.QVBoxLayout(self.form)
        self.headline = _text("Headline")
        self.table = _text("Changes")
        row = QtGui.QHBoxLayout()
        self.button = QtGui.QPushButton()
        self.button.setObjectName("Search")
        self.button.clicked.connect(self._press)
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 100)
        row.addWidget(self.button)
        row.addWidget(self.bar, 1)
        self.message = _text("Message")
        hinges, unit = self.chain.hinge_sets[:1], self.chain.unit
        self.requirements = Requirements(*(hinges or [None]), unit, ("margin",), margin=1.2)
        self.others = QtGui.QPushButton(
            translate("BistablePrintable", "Compare other designs (Auto-fit)…")
        )
        self.others.setObjectName("Others")
        self.others.clicked.connect(self._compare)
        self.others.setVisible(self.chain.curve is not None)
        for part in (self.headline, self.table):
            column.addWidget(part)
        column.addLayout(row)
        for part in (self.message, self.requirements.box, self.others):
            column.addWidget(part)
        column.addStretch(1)
        self._rest()

    def say(self, text, colour=""):
        """A message below everything, or none."""
        self.message.setText(text)
        self.message.setStyleSheet(f"color: {colour}" if colour else "")
        self.message.setVisible(bool(text))

    def _rest(self):
        self.button.setText(translate("BistablePrintable", "Search again"))
        self.bar.hide()

    def _compare(self):
        """Leave, and open the table of proposals along the same curve."""
        self.reject()
        source = self.chain.triangles or self.chain.curve
        QtCore.QTimer.singleShot(0, lambda: _compare_along(source))  # the button goes with the form

    # searching

    def _press(self):
        if self._search:
            self._search.stop()
        else:
            self.start()

    def start(self):
        """Search with what is wanted now."""
        self.say("")
        self.requirements.explain("", "")
        try:
            wanted = self.requirements.wanted()
            self.request = fitting.request_of(
                self.chain,
                wanted.bed,
                wanted.margin,
                settings.hinge(),
                settings.calibrated_clearance(),
            )
        except Refusal as error:
            self._explain(error)
            return
        self._search = Aside(self.request.search)
        self.button.setText(translate("BistablePrintable", "Stop"))
        self.bar.setValue(0)
        self.bar.show()
        self._timer.start(_POLL)

    def _follow(self):
        """Show how far the search is, and what came out of it."""
        found = self._search
        self.bar.setValue(round(100 * found.fraction))
        if found.is_running():
            return
        self._timer.stop()
        self._search = None
        self._rest()
        self.say("")
        if found.error:
            self._explain(found.error)
        elif found.result is None:
            self.say(translate("BistablePrintable", "Stopped: nothing is changed."))
        else:
            self.show_answer(found.result)

    def _explain(self, refusal):
        colour, text = error_colour(self.form), in_words(refusal)
        parameter = {"TargetMargin": "Margin"}.get(refusal.parameter, refusal.parameter)
        if not self.requirements.explain(text, colour, parameter):
            self.say(text, colour)

    # what was found

    def show_answer(self, answer):
        """Show what a search found: in the panel, and its tube in the view."""
        self.proposal = fitting.proposed(self.chain, self.request, answer)
        self.headline.setText(_headline(self.proposal))
        self.headline.show()
        self.table.setText(_rows(self.proposal.changes))
        self.table.setVisible(bool(self.proposal.changes))
        self._preview()

    def _preview(self):
        """The deployed tube instead of the one that there is, with drawn and followed curve."""
        self._hide_preview()
        found = self.proposal.found
        if found is None:
            return
        motion = FacesMotion(found.design.tube())
        motion.show(1.0)
        drawn = self.request.geometry.curve.point(_SAMPLES)
        if found.option.change:
            motion.root.addChild(polyline(drawn, *_DRAWN))
        followed = found.option.geometry.curve.point(_SAMPLES)
        motion.root.addChild(polyline(followed, *_FOLLOWED))
        hidden = list(self.chain.objects().values())
        view = Gui.getDocument(self.doc.Name).ActiveView
        self._shown = StandIn(view, motion.root, hidden)

    def _hide_preview(self):
        if self._shown:
            self._shown.end()
            self._shown = None

    # applying

    def _lines(self):
        """What OK does, as lines of a macro."""
        yield "from BistableWB import fitting"
        yield from self.proposal.lines()
        for variable in self.proposal.hinge_sets:
            yield f"make.make_solids({variable})"

    def _views(self):
        """The first print by itself: all prints lie on the same bed."""
        yield "Gui.Selection.clearSelection()"
        first, *more = self.proposal.hinge_sets
        yield (
            f"if {first}.isValid(): [part.ViewObject.hide() for part in {first}.OutListRecursive]"
        )
        if self.proposal.found.option.change:
            yield "curve.ViewObject.show()"  # beside the drawn one
        for variable in more:
            yield f"{variable}.ViewObject.hide()"
        yield "Gui.SendMsgToActiveView('ViewFit')"


def _compare_along(source):
    from .auto_fit import AutoFitPanel

    Gui.Control.closeDialog()
    panel = AutoFitPanel(source)
    Gui.Control.showDialog(panel)
    panel.start()


def _text(name):
    label = QtGui.QLabel()
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setTextFormat(QtCore.Qt.RichText)
    label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    label.hide()
    return label


def _headline(proposal):
    """What comes out, in a sentence or two."""
    found, blocked = proposal.found, proposal.blocked
    texts = []
    if found is not None:
        text = translate(
            "BistablePrintable",
            "{units} units in {prints} print(s), ‖AB‖ {edge} mm: the weakest has a snap margin of "
            "{margin}, and the tube ends {gap} mm from the curve's end.",
        )
        texts.append(
            "<b>"
            + escape(
                text.format(
                    units=len(found.margins),
                    prints=max(len(found.parts), 1),
                    edge=f"{found.option.edge_length:.4g}",
                    margin=f"{found.margin:.2f}",
                    gap=f"{found.end_gap:.2f}",
                )
            )
            + "</b>"
        )
    if blocked is not None:
        head = (
            translate("BistablePrintable", "Nearest design that can be made. In the way: {why}.")
            if found is not None
            else translate("BistablePrintable", "No tube can be made: {why}.")
        )
        texts.append(escape(head.format(why=in_words(blocked).rstrip("."))))
    elif not proposal.changes:
        texts.append(escape(translate("BistablePrintable", "It is printable as it is.")))
    return "<br>".join(texts)


def _rows(changes):
    """The table of changes as HTML: of every object its properties, old → new, and why."""
    rows, label = [], None
    for change in changes:
        if change.label != label:
            label = change.label
            new = "" if change.before is not None or not change.property else _new()
            rows.append(f"<tr><td colspan=3><b>{escape(label)}</b>{new}</td></tr>")
        name = escape(translated(label_of(change.property))) if change.property else ""
        before = "" if change.before is None else _value(change, change.before)
        arrow = "→" if before else ""
        rows.append(
            f"<tr><td>{name}&nbsp;</td><td align=right>{before} {arrow}&nbsp;</td>"
            f"<td><b>{_value(change, change.after)}</b></td></tr>"
        )
        why = escape(in_words(change.why))
        if why:
            rows.append(f"<tr><td colspan=3><small><i>{why}</i></small></td></tr>")
    return f"<table cellspacing=1 width='100%'>{''.join(rows)}</table>"


def _new():
    return " (" + escape(translate("BistablePrintable", "new")) + ")"


def _value(change, value):
    """A value as a panel shows it."""
    if isinstance(value, Phrase):
        return escape(in_words(value))
    if isinstance(value, str):
        return escape(translated(value))
    if isinstance(value, tuple):
        return escape(", ".join(f"{x:.4g}" for x in value))
    return escape(value_text(value)) + _UNITS.get(_kind(change.property), "")


def _kind(name):
    """FreeCAD's kind of a property of ours."""
    for type_name in TYPES:
        for prop in proxy_class(type_name).PROPERTIES:
            if prop.name == name:
                return prop.kind
    return ""
