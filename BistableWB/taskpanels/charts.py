# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bar charts of numbers along a tube, drawn by Qt in the colours of the window's theme."""

import math

from PySide import QtCore, QtGui

from .. import colours

_LEFT, _RIGHT, _TOP, _BOTTOM = 46, 10, 32, 22
_GAP = 0.18  # of a bar's place
_CHOSEN = "#D81B72"


class BarChart(QtGui.QWidget):
    """One value a unit; ``limits`` draws a line across each bar.

    ``picked(index)`` is called when a bar is clicked.
    """

    def __init__(self, title, colour, picked):
        super().__init__()
        self.title, self.colour, self.picked = title, QtGui.QColor(colour), picked
        self.values, self.limits, self.chosen, self.unit = [], [], set(), ""
        self.setMinimumSize(220, 110)
        self.setMouseTracking(True)

    def set_values(self, values, limits=(), unit=""):
        """Draw other values."""
        self.values, self.limits, self.unit = list(values), list(limits), unit
        self.chosen = {k for k in self.chosen if k < len(self.values)}
        self.update()

    def choose(self, indices):
        """Highlight bars."""
        self.chosen = set(indices)
        self.update()

    # mouse

    def index_at(self, x):
        """Number of the bar at a horizontal position, None beside all."""
        width = self.width() - _LEFT - _RIGHT
        if not self.values or width <= 0 or not _LEFT <= x < _LEFT + width:
            return None
        return int((x - _LEFT) / width * len(self.values))

    def centre_of(self, index):
        """Position in the middle of a bar."""
        area = self._area()
        x = area.left() + (index + 0.5) * area.width() / len(self.values)
        return QtCore.QPoint(int(x), int(area.center().y()))

    def mousePressEvent(self, event):
        """Pick the bar."""
        index = self.index_at(event.pos().x())
        if index is not None:
            self.picked(index)

    def mouseMoveEvent(self, event):
        """Tell the value under the mouse."""
        index = self.index_at(event.pos().x())
        text = "" if index is None else f"{index + 1}: {self.values[index]:.4g}{self.unit}"
        self.setToolTip(text)

    # drawing

    def _area(self):
        return QtCore.QRectF(
            _LEFT, _TOP, self.width() - _LEFT - _RIGHT, self.height() - _TOP - _BOTTOM
        )

    def _range(self):
        every = [*self.values, *self.limits]
        low, high = min(0.0, *every), max(0.0, *every)
        step = nice_step(high - low or 1.0)
        return math.floor(low / step) * step, math.ceil(high / step) * step, step

    def paintEvent(self, event):
        """Title, scale, bars, limits."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        ink = self.palette().color(QtGui.QPalette.WindowText)
        faint = QtGui.QColor(ink)
        faint.setAlpha(45)
        painter.setPen(ink)
        title = QtCore.QRectF(8, 4, self.width() - 16, _TOP - 12)
        painter.drawText(title, QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, self.title)
        if self.values and self._area().width() > 40 and self._area().height() > 20:
            area, (bottom, top, step) = self._area(), self._range()
            self._draw_scale(painter, area, bottom, top, step, ink, faint)
            self._draw_bars(painter, area, bottom, top)
            self._draw_numbers(painter, area, ink)
        painter.end()

    def _height(self, value, area, bottom, top):
        return area.bottom() - (value - bottom) / (top - bottom) * area.height()

    def _draw_scale(self, painter, area, bottom, top, step, ink, faint):
        every = max(1, round(16 * (top - bottom) / step / area.height()) or 1)
        for k in range(0, round((top - bottom) / step) + 1, every):
            value = bottom + k * step
            y = self._height(value, area, bottom, top)
            painter.setPen(faint)
            painter.drawLine(QtCore.QPointF(area.left(), y), QtCore.QPointF(area.right(), y))
            painter.setPen(ink)
            box = QtCore.QRectF(0, y - 8, _LEFT - 5, 16)
            right = QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter
            painter.drawText(box, right, f"{round(value, 10):g}{self.unit}")

    def _draw_bars(self, painter, area, bottom, top):
        place = area.width() / len(self.values)
        for k, value in enumerate(self.values):
            x, y = area.left() + (k + _GAP / 2) * place, self._height(value, area, bottom, top)
            bar = QtCore.QRectF(x, y, (1 - _GAP) * place, area.bottom() - y)
            painter.fillRect(bar, QtGui.QColor(_CHOSEN) if k in self.chosen else self.colour)
            if k < len(self.limits):
                limit = self._height(self.limits[k], area, bottom, top)
                painter.setPen(QtGui.QPen(self.palette().color(QtGui.QPalette.WindowText), 2))
                start = QtCore.QPointF(area.left() + k * place, limit)
                painter.drawLine(start, start + QtCore.QPointF(place, 0))

    def _draw_numbers(self, painter, area, ink):
        painter.setPen(ink)
        place = area.width() / len(self.values)
        step = next(s for s in (1, 2, 5, 10, 20, 50, 100, 1e9) if s * place > 20)
        for k in range(len(self.values)):
            if (k + 1) % step == 0 or k == 0:
                box = QtCore.QRectF(area.left() + (k + 0.5) * place - 15, area.bottom() + 2, 30, 18)
                painter.drawText(box, QtCore.Qt.AlignCenter, str(k + 1))


def nice_step(span):
    """A round step that divides ``span`` into two to five."""
    rough = span / 4
    power = 10 ** math.floor(math.log10(rough))
    return next(f * power for f in (1, 2, 2.5, 5, 10) if f * power >= rough * 0.999)


THETA, RATIO, MARGIN = (colours.PANELS[k] for k in ("primary", "border", "secondary"))
