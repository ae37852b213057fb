# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the deployment slider shows of a print's snap: unstable stretches and the ghost of its slop.

A unit is unstable between its barrier and where it is at rest: let go there, it moves on by itself.
"""

from PySide import QtCore, QtGui

from ..language.labels import translate
from ..language.words import in_words
from ..objects import type_of
from .measure import MeasureButton

_ROW, _MOST = 6, 72  # pixels: of a unit, and of all
_HANDLE = 8  # pixels at either end of a slider that its handle cannot reach
_DEPLOYED = 0.995
_TRACK, _UNSTABLE, _MARK = "#DCE6EE", "#E07B39", "#C2185B"


class Strip(QtGui.QWidget):
    """A row for every unit, from flat to deployed, with its unstable stretch; a mark follows."""

    def __init__(self, slider):
        super().__init__()
        self.setObjectName("Unstable")
        self._slider, self.stretches, self._opening = slider, [], 0.0

    def show_stretches(self, stretches):
        """(start, end) as shares of the opening of every unit, None where it does not snap."""
        self.stretches = list(stretches)
        self.setFixedHeight(min(_ROW * len(self.stretches), _MOST))
        self.setVisible(bool(self.stretches))
        self.update()

    def follow(self, opening):
        """Bring the mark there."""
        self._opening = opening
        self.update()

    def units_at(self, opening):
        """Numbers, from 1, of the units that are unstable at an opening."""
        return [
            k + 1
            for k, stretch in enumerate(self.stretches)
            if stretch is not None and stretch[0] < opening < stretch[1]
        ]

    def paintEvent(self, event):
        """Draw all rows and the mark, below the slider's own ends."""
        painter = QtGui.QPainter(self)
        left = self.mapFromGlobal(self._slider.mapToGlobal(QtCore.QPoint(_HANDLE, 0))).x()
        width = self._slider.width() - 2 * _HANDLE
        height = self.height() / max(len(self.stretches), 1)
        for k, stretch in enumerate(self.stretches):
            row = QtCore.QRectF(left, k * height, width, max(height - 1, 1))
            painter.fillRect(row, QtGui.QColor(_TRACK))
            if stretch is not None:
                row.setLeft(left + stretch[0] * width)
                row.setRight(left + stretch[1] * width)
                painter.fillRect(row, QtGui.QColor(_UNSTABLE))
        mark = QtCore.QRectF(left + self._opening * width - 1, 0, 2, self.height())
        painter.fillRect(mark, QtGui.QColor(_MARK))
        painter.end()


class Snapping(QtGui.QWidget):
    """The strip, what asks for it, and whether the ghost is shown; for a HingeSet only.

    ``known()`` is called when a study that was asked for is there.
    """

    def __init__(self, obj, slider, known):
        super().__init__()
        self.setObjectName("Snapping")
        self.obj, self._known, self._motion, self._slop = obj, known, None, None
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.strip = Strip(slider)
        self.measure = MeasureButton(self._measured)
        self.ghost = QtGui.QCheckBox(translate("BistableDeploy", "Ghost of its play"))
        self.ghost.setObjectName("Ghost")
        self.ghost.setToolTip(
            translate("BistableDeploy", "How far the deployed tube moves before anything bears")
        )
        self.ghost.toggled.connect(self._toggled)
        self.refused = QtGui.QLabel()
        self.refused.setWordWrap(True)
        for widget in (self.strip, self.measure, self.ghost, self.refused):
            column.addWidget(widget)
            widget.hide()
        self._opening = 0.0
        self.is_print = type_of(obj) == "Bistable::HingeSet"
        self.setVisible(self.is_print)

    def show_known(self, motion):
        """Show what is known of the print; ``motion`` draws it."""
        if not self.is_print:
            return
        self._motion = motion
        self.measure.ask_about(self.obj)
        found = self.obj.Proxy.study(self.obj)
        self.measure.setVisible(found is None)
        self.ghost.setVisible(found is not None and not found.flexible)
        self._slop = found.slop if found else None
        self.strip.show_stretches([unit.unstable for unit in found.units] if found else [])

    def follow(self, opening):
        """The slider stands at ``opening``."""
        self._opening = opening
        self.strip.follow(opening)
        if self._motion is not None and self.is_print:
            self._motion.show_ghosts(self.ghost.isChecked() and opening > _DEPLOYED)

    def told(self, opening):
        """What there is to say at an opening: a list of texts."""
        parts = []
        units = self.strip.units_at(opening)
        if len(units) == 1:
            text = translate("BistableDeploy", "unit {} moves on by itself here")
            parts.append(text.format(units[0]))
        elif len(units) > 1 and len(units) == len(self.strip.stretches):
            parts.append(translate("BistableDeploy", "all units move on by themselves here"))
        elif units:
            text = translate("BistableDeploy", "units {} move on by themselves here")
            parts.append(text.format(", ".join(map(str, units))))
        if self.ghost.isChecked() and self._slop is not None:
            text = translate("BistableDeploy", "free end ± {:.1f} mm before anything bears")
            parts.append(text.format(self._slop.end))
        return parts

    def stop(self):
        """The panel closes."""
        self.measure.stop()

    def _measured(self, error):
        self.refused.setText("" if error is None else in_words(error))
        self.refused.setVisible(error is not None)
        self._known()

    def _toggled(self, is_on):
        if is_on and self._motion.ghosts is None:
            self._motion.add_ghosts(self._slop)
        self._known()
