# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of Auto-fit: requirements, a search beside the window, proposals, one applied."""

from math import degrees

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from .. import fitting
from ..language.labels import translate, translated
from ..language.words import in_words
from ..objects import type_of
from ..origami.errors import Refusal
from ..origami.fit import search
from ..recording.script import Script, by_name
from ..scene.motion import FacesMotion
from ..scene.stand_in import StandIn
from .aiming import AimChoice
from .aside import Aside
from .base import icon
from .charts import PointChart
from .fields import error_colour
from .plots import dock
from .requirements import Requirements

TRIANGLES, UNIT, HINGES = (
    f"Bistable::{name}" for name in ("TrianglePlacement", "BistableUnit", "HingeSet")
)
_POLL = 80  # ms between looks at the search


class AutoFitPanel:
    """Proposals for the tube along ``source``, a TrianglePlacement or a Curve.

    The document is changed by OK only, in one undo step that a macro keeps. Where a load or a force
    is to be aimed at, that goes on beside the window then, in the dock of charts.
    """

    def __init__(self, source):
        self.source, self.doc = source, source.Document
        followers = [obj for obj in source.InListRecursive if type_of(obj) in (UNIT, HINGES)]
        self.units = [obj for obj in followers if type_of(obj) == UNIT]
        self.hinges = [obj for obj in followers if type_of(obj) == HINGES]
        self.fit, self.course, self.chosen = None, None, None
        self._search, self._shown = None, None
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistableAutoFit")
        self.form.setWindowTitle(translate("BistableAutoFit", "Auto-fit"))
        self.form.setWindowIcon(icon("AutoFit"))
        self._build()
        self._timer = QtCore.QTimer(self.form)
        self._timer.timeout.connect(self._follow)

    # what FreeCAD calls

    def getStandardButtons(self):
        """OK and Cancel."""
        box = QtGui.QDialogButtonBox
        return sum(int(getattr(b, "value", b)) for b in (box.Ok, box.Cancel))

    def accept(self):
        """OK: the chosen proposal becomes the document's. Stay open where there is none."""
        if self.chosen is None:
            self.say(translate("BistableAutoFit", "Search, then choose one of the proposals."))
            return False
        self.reject()
        App.setActiveDocument(self.doc.Name)
        with Script(translate("BistableAutoFit", "Auto-fit")) as script:
            for line in self._lines():
                script.add(line)
        if self.aim.asked() and self.hinges:
            charts = dock()
            charts.show()
            charts.show_tube(self.hinges[-1])
            charts.aim.aim(self.aim.asked())
        return True

    def reject(self):
        """Cancel: a search that still runs is forgotten, the view is as it was."""
        self._timer.stop()
        if self._search:
            self._search.stop()
        self._hide_preview()
        return True

    # the panel

    def _build(self):
        column = QtGui.QVBoxLayout(self.form)
        self.chart = PointChart(
            translate("BistableAutoFit", "Height of the print (mm)"),
            translate("BistableAutoFit", "off the curve (mm)"),
            self.choose,
        )
        self.chart.setMinimumSize(140, 170)  # no wider than the narrowest task view
        self.table = _table()
        self.table.itemSelectionChanged.connect(self._row_chosen)
        self.details = QtGui.QLabel()
        self.details.setObjectName("Details")
        self.details.setWordWrap(True)
        self.details.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        for part in (self.chart, self.table, self.details):
            column.addWidget(part)
        self.requirements = Requirements((self.hinges or [None])[-1], (self.units or [None])[-1])
        column.addWidget(self.requirements.box)
        self.aim = AimChoice(margin_too=True)
        self.aim.setEnabled(bool(self.hinges))  # without a print there is no weight and no force
        column.addWidget(self.aim)
        row = QtGui.QHBoxLayout()
        self.button = QtGui.QPushButton()
        self.button.setObjectName("Search")
        self.button.clicked.connect(self._press)
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 100)
        row.addWidget(self.button)
        row.addWidget(self.bar, 1)
        column.addLayout(row)
        self.message = QtGui.QLabel()
        self.message.setObjectName("Message")
        self.message.setWordWrap(True)
        column.addWidget(self.message)
        column.addStretch(1)
        self._rest()
        self._show_results(False)

    def say(self, text, colour=""):
        """A message below everything, or none."""
        self.message.setText(text)
        self.message.setStyleSheet(f"color: {colour}" if colour else "")
        self.message.setVisible(bool(text))

    def _rest(self):
        """Nothing is searched."""
        self.button.setText(translate("BistableAutoFit", "Search"))
        self.bar.hide()

    def _show_results(self, shown):
        for part in (self.chart, self.table, self.details):
            part.setVisible(shown)

    # searching

    def _press(self):
        if self._search:
            self._search.stop()
        else:
            self.start()

    def start(self):
        """Search with the requirements as they are."""
        self.say("")
        self.requirements.explain("", "")
        try:
            wanted = self.requirements.wanted()
            wanted.check()
            self.course = fitting.course_of(self.source)
        except Refusal as error:
            self._explain(error)
            return
        course = self.course
        self._search = Aside(lambda progress: search.auto_fit(course, wanted, progress))
        self.button.setText(translate("BistableAutoFit", "Stop"))
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
        if found.error:
            self._explain(found.error)
        elif found.result is None:
            self.say(translate("BistableAutoFit", "Stopped."))
        else:
            self.show_fit(found.result)

    def _explain(self, refusal):
        """Say what is wrong beside the field of its parameter, else below."""
        colour = error_colour(self.form)
        text = in_words(refusal)
        if not self.requirements.explain(text, colour, refusal.parameter):
            self.say(text, colour)

    # proposals

    def show_fit(self, fit):
        """Show the proposals of a search, the recommended one chosen."""
        self.fit, rows = fit, fit.candidates
        self.table.blockSignals(True)
        self.table.setRowCount(len(rows))
        for number, candidate in enumerate(rows):
            for column, text in enumerate(_cells(candidate)):
                item = QtGui.QTableWidgetItem(text)
                item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
                self.table.setItem(number, column, item)
        self.table.resizeColumnsToContents()
        self.table.setFixedHeight(_height_of(self.table))
        self.table.blockSignals(False)
        points = [(c.deviation, c.print_size[2]) for c in rows]
        self.chart.set_points(points, [_sentence(c) for c in rows])
        self._show_results(True)
        self.choose(0)

    def _row_chosen(self):
        self.choose(self.table.currentRow())

    def choose(self, number):
        """Choose a proposal, counted from 0: it is told in full, and shown in the view."""
        self.chosen = self.fit.candidates[number]
        self.table.blockSignals(True)
        self.table.selectRow(number)
        self.table.blockSignals(False)
        self.chart.choose({number})
        self.details.setText(_sentence(self.chosen))
        self._preview()

    def _preview(self):
        """Show the deployed faces of the chosen proposal instead of the tube that there is."""
        self._hide_preview()
        motion = FacesMotion(fitting.tube_of(self.chosen, self.course, self.fit.wanted))
        motion.show(1.0)
        hidden = [*self.units, *self.hinges]
        if type_of(self.source) == TRIANGLES:
            hidden.append(self.source)
        view = Gui.getDocument(self.doc.Name).ActiveView
        self._shown = StandIn(view, motion.root, hidden)

    def _hide_preview(self):
        if self._shown:
            self._shown.end()
            self._shown = None

    # applying

    def _lines(self):
        """What OK does, as lines of a macro: the missing objects are made, the others set."""
        inputs = fitting.inputs_of(self.chosen, self.fit.wanted)
        if type_of(self.source) == TRIANGLES:
            yield f"triangles = {by_name(self.source)}"
        else:
            yield f"triangles = make.make_triangle_placement(doc, {by_name(self.source)})"
        yield from _settings("triangles", inputs)
        for unit in self.units or [None]:
            made = by_name(unit) if unit else "make.make_bistable_unit(doc, triangles)"
            yield f"unit = {made}"
            yield from _settings("unit", inputs)
        for hinges in self.hinges:
            yield f"hinges = {by_name(hinges)}"
            yield from _settings("hinges", inputs)
            yield "make.make_solids(hinges)"


def _settings(which, inputs):
    return [f"{which}.{name} = {value!r}" for name, value in inputs[which].items()]


def _table():
    heads = {
        "‖AB‖": translate("BistableAutoFit", "Edge length, mm: the width of the tube"),
        "γ": translate("BistableAutoFit", "Angle by which the first segment leans forward"),
        "n": translate("BistableAutoFit", "Number of units"),
        translate("BistableAutoFit", "snap"): translate(
            "BistableAutoFit", "Smallest snap margin; below 1 is floppy"
        ),
        translate("BistableAutoFit", "print, mm"): translate(
            "BistableAutoFit", "Length, width and height of the flat-folded print"
        ),
        translate("BistableAutoFit", "off"): translate(
            "BistableAutoFit", "Largest distance of the curve from the tube's blocks, mm"
        ),
        translate("BistableAutoFit", "ratio rule"): translate(
            "BistableAutoFit", "How the ratio of every unit is chosen"
        ),
    }
    table = QtGui.QTableWidget(0, len(heads))
    table.setObjectName("Proposals")
    for column, (head, tip) in enumerate(heads.items()):
        item = QtGui.QTableWidgetItem(head)
        item.setToolTip(tip)
        table.setHorizontalHeaderItem(column, item)
    table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
    table.setSelectionMode(QtGui.QAbstractItemView.SingleSelection)
    table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
    table.verticalHeader().setDefaultSectionSize(22)
    table.setMinimumWidth(60)
    table.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Fixed)
    return table


def _height_of(table):
    """Height that shows every row, and a scroll bar below them."""
    rows = sum(table.rowHeight(k) for k in range(table.rowCount()))
    bar = table.horizontalScrollBar().sizeHint().height()
    return table.horizontalHeader().sizeHint().height() + rows + bar + 4


def _cells(candidate):
    """A row of the table."""
    return (
        f"{candidate.edge_length:.0f}",
        f"{degrees(candidate.gamma):.0f}°",
        str(candidate.count),
        f"{candidate.margin_min:.2f}",
        _size(candidate),
        f"{candidate.deviation:.1f}",
        _rule(candidate),
    )


def _size(candidate):
    return " × ".join(f"{x:.0f}" for x in candidate.print_size)


def _rule(candidate):
    name = translated(candidate.rule)
    return name if candidate.share is None else f"{name} {candidate.share:.3g}"


def _sentence(candidate):
    """All of a candidate's numbers."""
    text = translate(
        "BistableAutoFit",
        "{n} units, θ {low:.0f}° … {high:.0f}°, ratio rule {rule}: snap margin {margin:.2f} or "
        "more (weakest: unit {weakest}); print {size} mm; at most "
        "{off:.1f} mm off the curve, {covered:.0%} of it followed.",
    )
    return text.format(
        n=candidate.count,
        low=degrees(candidate.thetas[0]),
        high=degrees(candidate.thetas[1]),
        rule=_rule(candidate),
        margin=candidate.margin_min,
        weakest=candidate.weakest,
        size=_size(candidate),
        off=candidate.deviation,
        covered=candidate.coverage,
    )
