# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of the checks: findings as they come, computed beside the window."""

from dataclasses import replace

from PySide import QtCore, QtGui

from .. import checking, settings
from ..checks.table import CHECKS
from ..language.labels import translate, value_text
from ..language.words import in_words
from ..objects import is_heavy
from ..origami.errors import ERROR, NOTE, WARNING, Finding, Refusal, message_of, phrase
from ..origami.hinges.bed import Bed
from ..origami.meshes import PlacedMesh
from ..origami.progress import Cancelled, Progress
from ..programs import openscad
from ..recording.script import Script, by_name
from ..scene import threads
from ..scene.pointer import Pointer
from ..slicing import toolpaths
from ..solids.tessellation import shared
from .base import icon
from .fields import error_colour

_SIGNS = {ERROR: "✗", WARNING: "!", NOTE: "✓"}
_WORST_FIRST = list(_SIGNS)
_MOST = 40  # findings that are shown, the worst ones


class CheckPanel:
    """Runs the checks of one print; closing the panel stops them."""

    def __init__(self, obj):
        self.obj = obj
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistableCheck")
        self.form.setWindowTitle(translate("BistableCheck", "Check {}").format(obj.Label))
        self.form.setWindowIcon(icon("Check"))
        self._build()
        self.pointer = Pointer(obj)
        self.findings, self._shown, self._stopped, self.done = [], 0, False, False
        self._progress = Progress(cancelled=lambda: self._stopped)
        self._rows, self._steps, self._thread, self.again = [], [], None, None
        self._timer = QtCore.QTimer(self.form)
        self._timer.timeout.connect(self._follow)
        QtCore.QTimer.singleShot(0, self._start)

    def getStandardButtons(self):
        """Close."""
        close = QtGui.QDialogButtonBox.Close
        return int(getattr(close, "value", close))

    def reject(self):
        """Close: a check that still runs is forgotten."""
        self._stopped = True
        self._timer.stop()
        self.pointer.clear()
        return True

    def _build(self):
        column = QtGui.QVBoxLayout(self.form)
        self.state = QtGui.QLabel()
        self.state.setObjectName("State")
        self.state.setWordWrap(True)
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 0)
        self.list = QtGui.QVBoxLayout()
        self.more = QtGui.QLabel()
        self.more.hide()
        self.others = QtGui.QVBoxLayout()  # what other programs may be asked
        for widget in (self.state, self.bar):
            column.addWidget(widget)
        column.addLayout(self.list)
        column.addWidget(self.more)
        column.addLayout(self.others)
        column.addStretch(1)

    def _start(self):
        self._say(translate("BistableCheck", "Making the meshes…"))
        try:
            self.subject = _Subject(self.obj)
        except Refusal as error:
            refused = Finding(
                severity=ERROR,
                code="object",
                message=message_of(error),
            )
            self._run([("", lambda: [refused])])
            return
        self.bar.setRange(0, len(self.subject.bodies))
        self._mesher = QtCore.QTimer(self.form)
        self._mesher.timeout.connect(self._mesh_next)
        self._mesher.start(0)

    def _mesh_next(self):
        """One body a turn of the event loop: the window stays alive, and Close stops it."""
        if self._stopped:
            self._mesher.stop()
        elif self.subject.mesh_next():
            self.bar.setValue(len(self.subject.meshes))
        else:
            self._mesher.stop()
            self.subject.finish()
            self._run(list(self.subject.steps()))
            self._offer_printer()
            self._offer_openscad()
            self._offer_slicer()

    def _offer_printer(self):
        """Fields of the printer, and a button that checks the print for it."""
        printer = self.subject.suite.printer
        form = QtGui.QFormLayout()
        fields = {}
        for name, text in (
            ("layer_height", translate("BistableCheck", "Layer height")),
            ("nozzle_diameter", translate("BistableCheck", "Nozzle")),
        ):
            field = fields[name] = QtGui.QDoubleSpinBox()
            field.setObjectName(name)
            field.setRange(0.02, 5.0)
            field.setSingleStep(0.05)
            field.setSuffix(" mm")
            field.setValue(getattr(printer, name))
            form.addRow(text, field)
        self.again = QtGui.QPushButton(translate("BistableCheck", "Check for this printer"))
        self.again.setEnabled(False)
        self.again.clicked.connect(lambda: self._check_for(fields))
        self.others.addLayout(form)
        self.others.addWidget(self.again)

    def _check_for(self, fields):
        """All checks anew, with the printer's values in ``fields``."""
        values = {name: field.value() for name, field in fields.items()}
        self.subject.finish(replace(self.subject.suite.printer, **values))
        self._clear()
        self._run(list(self.subject.steps()))

    def _clear(self):
        """Forget what was found."""
        self.pointer.clear()
        for _, row in self._rows:
            self.list.removeWidget(row)
            row.hide()  # deleted later
            row.deleteLater()
        self.findings, self._shown, self._rows, self._steps = [], 0, [], []

    def _offer_openscad(self):
        """A button that has the mesh judged by OpenSCAD, which takes its time."""
        meshes = [body.placed for body in self.subject.meshes]
        count = sum(len(mesh.triangles) for mesh in meshes)
        minutes = max(1, round(count * openscad.SECONDS_A_TRIANGLE / 60))
        self.offer(
            translate("BistableCheck", "Ask OpenSCAD too (about {} min)").format(minutes),
            translate("BistableCheck", "OpenSCAD renders the mesh with exact numbers."),
            lambda: openscad.check(meshes, self._progress),
        )

    def _offer_slicer(self):
        """A button that has the print sliced, and looks at the toolpaths."""
        count = sum(len(body.mesh.triangles) for body in self.subject.meshes)
        minutes = max(1, round(count * toolpaths.SECONDS_A_TRIANGLE / 60))
        self.offer(
            translate("BistableCheck", "Slice it too (PrusaSlicer, about {} min)").format(minutes),
            translate("BistableCheck", "Looks whether the toolpaths keep bodies that move apart."),
            lambda: self._slice(self.subject.suite),
        )

    def _slice(self, suite):
        bodies, printer = suite.printed_bodies(), suite.printer
        return toolpaths.check_toolpaths(bodies, suite.parameters, printer, self._progress)

    def offer(self, text, tip, step):
        """A button for a check that is made only on demand: ``step()`` → list of `Finding`."""
        button = QtGui.QPushButton(text)
        button.setToolTip(tip)
        button.setMinimumWidth(40)  # a narrow dock must not be made wider

        def ask():
            button.setEnabled(False)
            self._run([(f"{text}…", step)])

        button.clicked.connect(ask)
        self.others.addWidget(button)

    def _run(self, steps):
        """Add steps to those that are worked on beside the window."""
        self._steps += steps
        self.done = False
        if self.again:
            self.again.setEnabled(False)
        self.bar.setRange(0, len(self._steps))
        self.bar.show()
        self._timer.start(100)
        self._work_on()

    def _work_on(self):
        """See to it that the steps are worked on; a thread may just have ended."""
        if self._thread is None or not self._thread.is_alive():
            self._thread = threads.start(self._work)

    def _work(self):
        """Run all steps; in a thread, so nothing of Qt or FreeCAD is touched."""
        while len(self.findings) < len(self._steps) and not self._stopped:
            _, step = self._steps[len(self.findings)]
            try:
                found = step()
            except Cancelled:  # the panel was closed
                return
            except Exception as error:  # a check that breaks must not hide the others
                found = [
                    Finding(
                        severity=ERROR,
                        code="check",
                        message=phrase(
                            "{kind}: {error}",
                            kind=type(error).__name__,
                            error=error,
                        ),
                    )
                ]
            self.findings.append(found)

    def _follow(self):
        while self._shown < len(self.findings):
            for finding in self.findings[self._shown]:
                self._add(finding)
            self._shown += 1
        self.bar.setValue(self._shown)
        if self._shown < len(self._steps):
            self._say(self._steps[self._shown][0])
            self._work_on()
            return
        self._timer.stop()
        self.bar.hide()
        self.done = True
        if self.again:
            self.again.setEnabled(True)
        count = {kind: sum(rank == kind for rank, _ in self._rows) for kind in range(3)}
        errors, warnings = (count[_WORST_FIRST.index(kind)] for kind in (ERROR, WARNING))
        if errors:
            self._say(translate("BistableCheck", "Errors: {}. Correct them first.").format(errors))
        elif warnings:
            text = translate("BistableCheck", "No errors. Warnings to read before you print: {}.")
            self._say(text.format(warnings))
        else:
            self._say(translate("BistableCheck", "Nothing speaks against printing."))

    def _say(self, text):
        self.state.setText(text)

    def _add(self, finding):
        """A row for a finding, below those that are as bad."""
        rank = _WORST_FIRST.index(finding.severity)
        place = sum(other <= rank for other, _ in self._rows)
        row = self._row(finding)
        self._rows.insert(place, (rank, row))
        self.list.insertWidget(place, row)
        for number, (_, other) in enumerate(self._rows):
            other.setVisible(number < _MOST)
        left = len(self._rows) - _MOST
        self.more.setText(translate("BistableCheck", "… and {} more.").format(left))
        self.more.setVisible(left > 0)

    def _row(self, finding):
        row = QtGui.QWidget()
        line = QtGui.QHBoxLayout(row)
        line.setContentsMargins(0, 0, 0, 0)
        label = QtGui.QLabel(f"{_SIGNS[finding.severity]}  {in_words(finding)}")
        label.setWordWrap(True)
        label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        if finding.severity == ERROR:
            label.setStyleSheet(f"color: {error_colour(self.form)}")
        label.setToolTip(value_text(list(finding.bodies)))
        line.addWidget(label, 1)
        buttons = QtGui.QVBoxLayout()  # below each other: bodies have long names
        line.addLayout(buttons)
        if finding.bodies:
            button = QtGui.QToolButton()
            button.setObjectName("Show")
            button.setArrowType(QtCore.Qt.RightArrow)  # no text: bodies have long names
            button.setToolTip(translate("BistableCheck", "Show: select and mark it in the 3D view"))
            button.clicked.connect(lambda: self.pointer.show(finding))
            buttons.addWidget(button, 0, QtCore.Qt.AlignRight)
        if self._can_set(finding):
            buttons.addWidget(self._fix_button(finding), 0, QtCore.Qt.AlignRight)
        buttons.addStretch(1)
        return row

    def _can_set(self, finding):
        """Whether the cure is to give properties of this object values."""
        names = {name for name, _ in finding.cure.sets}
        return bool(names) and names <= set(self.obj.PropertiesList)

    def _fix_button(self, finding):
        button = QtGui.QToolButton()
        button.setObjectName("Fix")
        button.setText(translate("BistableCheck", "Fix"))
        button.setToolTip(
            translate("BistableCheck", "Do it: {}. Then everything is checked anew").format(
                in_words(finding.cure)
            )
        )
        button.clicked.connect(lambda: self._fix(finding))
        return button

    def _fix(self, finding):
        """Do what the cure says as one undo step, and check what comes out of it."""
        if not self.done:  # a check that still runs looks at the old one
            return
        self.pointer.clear()
        with Script(translate("BistableCheck", "Fix")) as script:
            script.add(f"obj = {by_name(self.obj)}")
            for name, value in finding.cure.sets:
                script.add(f"obj.{name} = {value!r}")
            if is_heavy(self.obj):
                script.add("make.make_solids(obj)")
        if script.done:
            self._clear()
            while self.others.count():
                _delete(self.others.takeAt(0))
            self.again, self.done = None, False
            self.bar.setRange(0, 0)
            self.bar.show()
            self._start()


def _delete(item):
    """Take an item of a layout away with all that is in it."""
    inside = item.layout()
    while inside is not None and inside.count():
        _delete(inside.takeAt(0))
    if item.widget():
        item.widget().hide()
        item.widget().deleteLater()


class CheckPanels:
    """Checks of several prints, a box each, beside each other."""

    def __init__(self, panels):
        self.panels = panels
        self.form = [panel.form for panel in panels]

    def getStandardButtons(self):
        """Close."""
        return self.panels[0].getStandardButtons()

    def reject(self):
        """Close all of them."""
        return all(panel.reject() for panel in self.panels)


class _Subject:
    """A print object, its meshes, and the checks that it gets."""

    def __init__(self, obj):
        self.obj, self.bodies = obj, checking.bodies_of(obj)
        self.meshes, self._tessellator = [], shared()

    def mesh_next(self):
        """Mesh one more body; False when all are done."""
        if len(self.meshes) == len(self.bodies):
            return False
        body = self.bodies[len(self.meshes)]
        mesh, place = self._tessellator.original(body.shape)
        made = PlacedMesh(body.name, mesh, place, body.unit, body.members, body.kind)
        self.meshes.append(made)
        return True

    def finish(self, printer=None):
        """All that needs FreeCAD, before the steps run beside it; ``printer``: not the own one."""
        known = Bed(*settings.bed()), settings.calibrated_clearance()
        printer = printer or checking.printer_of(self.obj, *known)
        self.suite = checking.suite_of(self.obj, self.bodies, self.meshes, printer)

    def steps(self):
        """(what it does, function that returns findings) of all checks."""
        for code, step in self.suite.steps():
            name, _, opening = code.partition(" ")
            yield translate("BistableCheck", CHECKS[name].title).format(opening), step
