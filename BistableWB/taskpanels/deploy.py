# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that opens and folds a tube: slider, play, colours, recording."""

import time

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..language.labels import CONTEXT, translate
from ..objects import type_of
from ..recording.frames import Recorder
from ..scene.motion import COLOURS, motion_of
from ..scene.stand_in import StandIn
from .base import icon
from .snapping import Snapping

_STEPS = 1000
_SECONDS = 3.0  # from flat to deployed
_TICK = 15  # ms
_REST = 250  # ms without a move after which all detail is shown


class DeployPanel:
    """Moves Coin nodes in place of the object's shape. OK writes `Deployment`."""

    def __init__(self, obj):
        self.obj, self.doc = obj, obj.Document
        self.view = Gui.getDocument(self.doc.Name).ActiveView
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistableDeploy")
        self.form.setWindowTitle(translate("BistableDeploy", "Deploy {}").format(obj.Label))
        self.form.setWindowIcon(icon("Deploy"))
        self._build()
        QtGui.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            self.motion = motion_of(obj)
        finally:
            QtGui.QApplication.restoreOverrideCursor()
        self._take_over()
        self.snapping.show_known(self.motion)
        self._timer = QtCore.QTimer(self.form)
        self._timer.timeout.connect(self._tick)
        self._rest = QtCore.QTimer(self.form)
        self._rest.setSingleShot(True)
        self._rest.timeout.connect(lambda: self.motion.show(self._opening))
        self._forward, self._last, self._frames = True, 0.0, []
        self.set_opening(obj.Deployment)

    # what FreeCAD calls

    def getStandardButtons(self):
        """OK and Cancel."""
        box = QtGui.QDialogButtonBox
        return sum(int(getattr(b, "value", b)) for b in (box.Ok, box.Cancel))

    def accept(self):
        """OK: the object takes the opening shown."""
        self._give_back()
        if abs(self.opening - self.obj.Deployment) > 1e-9:
            self.doc.openTransaction(translate("BistableDeploy", "Deploy"))
            Gui.doCommand(f'doc = App.getDocument("{self.doc.Name}")')
            Gui.doCommand(f"doc.{self.obj.Name}.Deployment = {round(self.opening, 4)!r}")
            Gui.doCommand("doc.recompute()")
            self.doc.commitTransaction()
        return True

    def reject(self):
        """Cancel: everything is as it was."""
        self._give_back()
        return True

    # the view

    def _take_over(self):
        """Show the motion instead of the object and of other states of the same tube."""
        family = [self.obj]
        if type_of(self.obj) == "Bistable::HingeSet":
            family.append(self.obj.Unit)
        self._shown = StandIn(self.view, self.motion.root, family)

    def _give_back(self):
        self.stop()
        self.snapping.stop()
        self.recorder.cancel()
        self._rest.stop()
        self._shown.end()

    # the panel

    def _build(self):
        column = QtGui.QVBoxLayout(self.form)
        row = QtGui.QHBoxLayout()
        self.slider = QtGui.QSlider(QtCore.Qt.Horizontal)
        self.slider.setObjectName("Opening")
        self.slider.setRange(0, _STEPS)
        self.slider.setSingleStep(_STEPS // 100)  # arrow keys: one per cent
        self.slider.setPageStep(_STEPS // 10)
        self.slider.valueChanged.connect(self._slid)
        row.addWidget(QtGui.QLabel(translate("BistableDeploy", "flat")))
        row.addWidget(self.slider, 1)
        row.addWidget(QtGui.QLabel(translate("BistableDeploy", "deployed")))
        column.addLayout(row)
        self.snapping = Snapping(self.obj, self.slider, self._snapping_known)
        column.addWidget(self.snapping)
        column.addLayout(self._play_row())
        column.addWidget(self.colours)
        self.text = QtGui.QLabel()
        self.text.setObjectName("State")
        self.text.setWordWrap(True)
        column.addWidget(self.text)
        self.recorder = Recorder(self)
        column.addWidget(self.recorder.box)
        column.addStretch(1)

    def _play_row(self):
        row = QtGui.QHBoxLayout()
        self.play_button = QtGui.QPushButton(translate("BistableDeploy", "Play"))
        self.play_button.setObjectName("Play")
        self.play_button.setCheckable(True)
        self.play_button.toggled.connect(lambda on: self.play() if on else self.stop())
        self.loop = QtGui.QCheckBox(translate("BistableDeploy", "Loop"))
        self.loop.setObjectName("Loop")
        self.colours = QtGui.QComboBox()
        self.colours.setObjectName("Colours")
        self.colours.addItem(translate("BistableDeploy", "Colour: panels"), COLOURS[0])
        self.colours.addItem(translate("BistableDeploy", "Colour: misfit"), COLOURS[1])
        self.colours.addItem(translate("BistableDeploy", "Colour: strain"), COLOURS[2])
        self.colours.currentIndexChanged.connect(self._recolour)
        row.addWidget(self.play_button)
        row.addWidget(self.loop)
        row.addStretch(1)
        return row

    @property
    def opening(self):
        """The opening shown, 0 flat … 1 deployed."""
        return self._opening

    def set_opening(self, opening, moving=False):
        """Show an opening, in the view and on the slider; all its detail soon after ``moving``."""
        self._opening = min(1.0, max(0.0, opening))
        self.slider.blockSignals(True)
        self.slider.setValue(round(self._opening * _STEPS))
        self.slider.blockSignals(False)
        self.motion.show(self._opening, moving)
        if moving:
            self._rest.start(_REST)
        self.snapping.follow(self._opening)
        self._tell()

    def _slid(self, step):
        self.set_opening(step / _STEPS, moving=True)

    def _recolour(self, *_):
        self.motion.colour_by(self.colours.currentData())
        self._tell()

    def _snapping_known(self):
        self.snapping.show_known(self.motion)
        self.set_opening(self._opening)

    def _tell(self):
        parts = [translate("BistableDeploy", "{:.0%} open").format(self._opening)]
        if self.colours.currentData() == COLOURS[1]:
            worst = float(self.motion.misfit(self._opening).max())
            misfit = translate("BistableDeploy", "misfit up to {} mm (full colour: {} mm)")
            parts.append(misfit.format(*map(_hundredths, (worst, self.motion.misfit_limit))))
        elif self.colours.currentData() == COLOURS[2]:
            worst = float(self.motion.strain(self._opening).max())
            strain = translate(
                "BistableDeploy", "strain up to {:.1%} (full colour: {:.1%}, what {} bears)"
            )
            of = self.motion.made_of
            parts.append(strain.format(worst, of.breaking_strain, translate(CONTEXT, of.name)))
        parts += self.snapping.told(self._opening)
        self.text.setText(", ".join(parts))

    # playing

    def play(self):
        """Open from here (from flat, if it is open), then fold again if looped."""
        if self._opening >= 1 and not self.loop.isChecked():
            self.set_opening(0.0)
        self._forward = self._opening < 1
        self._last = time.perf_counter()
        self._frames = []
        self.play_button.setText(translate("BistableDeploy", "Stop"))
        self._timer.start(_TICK)

    def stop(self):
        """Stop playing."""
        self._timer.stop()
        self.play_button.blockSignals(True)
        self.play_button.setChecked(False)
        self.play_button.blockSignals(False)
        self.play_button.setText(translate("BistableDeploy", "Play"))

    def _tick(self):
        now = time.perf_counter()
        step = min(now - self._last, 0.2) / _SECONDS
        self._frames.append(now - self._last)
        self._last = now
        opening = self._opening + (step if self._forward else -step)
        self.set_opening(opening, moving=True)
        if not 0 < opening < 1:
            if not self.loop.isChecked():
                self.stop()
            self._forward = opening <= 0

    @property
    def frame_rate(self):
        """Frames a second of the last play."""
        return len(self._frames) / sum(self._frames) if self._frames else 0.0


def _hundredths(length):
    """A length in mm as no printer prints finer; "< 0.01" for what is only rounding too."""
    return f"{length:.2f}" if length >= 0.01 else "< 0.01"
