# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of the checks: findings as they come, computed beside the window."""

import threading

from PySide import QtCore, QtGui

from ..checks.bed import Bed, check_bed
from ..checks.findings import ERROR, NOTE, WARNING, Finding
from ..checks.printing import Print
from ..objects import type_of
from ..objects.hinge_inputs import hinge_parameters
from ..origami import print_stack
from ..solids.mesh import PlacedMesh
from ..solids.tessellation import Tessellator
from ..viewproviders import settings
from .base import icon
from .fields import error_colour
from .texts import translate, value_text

_SIGNS = {NOTE: "✓", WARNING: "!", ERROR: "✗"}
_HALF = 0.5


class CheckPanel:
    """Runs the checks of one print; closing the panel stops them."""

    def __init__(self, obj):
        self.obj = obj
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistableCheck")
        self.form.setWindowTitle(translate("BistableCheck", "Check {}").format(obj.Label))
        self.form.setWindowIcon(icon("Check"))
        self._build()
        self.findings, self._shown, self._stopped, self.done = [], 0, False, False
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
        return True

    def _build(self):
        column = QtGui.QVBoxLayout(self.form)
        self.state = QtGui.QLabel()
        self.state.setObjectName("State")
        self.state.setWordWrap(True)
        self.bar = QtGui.QProgressBar()
        self.bar.setRange(0, 0)
        self.list = QtGui.QVBoxLayout()
        column.addWidget(self.state)
        column.addWidget(self.bar)
        column.addLayout(self.list)
        column.addStretch(1)

    def _start(self):
        self._say(translate("BistableCheck", "Making the meshes…"))
        try:
            self.subject = _Subject(self.obj)
        except ValueError as error:
            refused = Finding(ERROR, "object", (), None, None, str(error))
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
            self._run(list(self.subject.steps()))

    def _run(self, steps):
        self._steps = steps
        self.bar.setRange(0, len(steps))
        self._thread = threading.Thread(target=self._work, daemon=True)
        self._thread.start()
        self._timer.start(100)

    def _work(self):
        """Run all steps; in a thread, so nothing of Qt or FreeCAD is touched."""
        for _, step in self._steps:
            if self._stopped:
                return
            try:
                found = step()
            except Exception as error:  # a check that breaks must not hide the others
                found = [
                    Finding(ERROR, "check", (), None, None, f"{type(error).__name__}: {error}")
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
            return
        self._timer.stop()
        self.bar.hide()
        self.done = True
        every = [finding for found in self.findings for finding in found]
        wrong = sum(finding.severity == ERROR for finding in every)
        if wrong:
            self._say(translate("BistableCheck", "{} errors: correct them first.").format(wrong))
        else:
            self._say(translate("BistableCheck", "Nothing speaks against printing."))

    def _say(self, text):
        self.state.setText(text)

    def _add(self, finding):
        if self.list.count() > 40:
            return
        label = QtGui.QLabel(f"{_SIGNS[finding.severity]}  {finding}")
        label.setWordWrap(True)
        label.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        if finding.severity == ERROR:
            label.setStyleSheet(f"color: {error_colour(self.form)}")
        label.setToolTip(value_text(list(finding.place)))
        self.list.addWidget(label)


class _Subject:
    """A print object, its meshes, and the checks that it gets."""

    def __init__(self, obj):
        self.parameters = hinge_parameters(obj)
        self.model = obj.Proxy.model(obj) if type_of(obj) == "Bistable::HingeSet" else None
        self.bodies = self.model.bodies if self.model else obj.Proxy.bodies(obj)
        self.volumes = [body.shape.Volume for body in self.bodies]
        self.meshes, self._tessellator, self._print = [], Tessellator(), None

    def mesh_next(self):
        """Mesh one more body; False when all are done."""
        if len(self.meshes) == len(self.bodies):
            return False
        body = self.bodies[len(self.meshes)]
        mesh, place = self._tessellator.original(body.shape)
        made = PlacedMesh(body.name, mesh, place, body.unit, body.members, body.material)
        self.meshes.append(made)
        return True

    def whole(self):
        """The `Print`, made in the thread that asks first."""
        self._print = self._print or Print(self.meshes, self.parameters)
        return self._print

    def steps(self):
        """(what it does, function that returns findings) of all checks."""
        if self.model:
            yield translate("BistableCheck", "Size of the print…"), self._check_bed
        yield (
            translate("BistableCheck", "Closed solids…"),
            lambda: self.whole().check_soundness(self.volumes),
        )
        yield (
            translate("BistableCheck", "Clearances in the flat print…"),
            lambda: self.whole().check_flat(),
        )
        for opening in (_HALF, 1.0) if self.model else ():
            text = translate("BistableCheck", "Overlaps when opened to {:.0%}…").format(opening)
            yield text, lambda o=opening: self._check_pose(o)

    def _check_bed(self):
        bed = Bed(*(settings.number(f"Bed{side}") for side in ("Width", "Depth", "Height")))
        tube = self.model.tube
        return check_bed(tube.thick, self.parameters, bed, tube.tube.incoming_left)

    def _check_pose(self, opening):
        tube = self.model.tube
        motions = print_stack.motions(tube.thick, opening, tube.tube.incoming_left)
        misfits = tube.thick.misfit(opening).reshape(len(motions), -1)
        return self.whole().check_poses(motions, opening, misfits)
