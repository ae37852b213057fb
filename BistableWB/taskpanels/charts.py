# SPDX-License-Identifier: LGPL-2.1-or-later
"""Charts of a tube's numbers, drawn by Qt in the colours of the window's theme."""

import math

from PySide import QtCore, QtGui

from .. import colours

_LEFT, _RIGHT, _TOP, _BOTTOM = 46, 10, 32, 22
_ACROSS = 18  # more below, for the name of a horizontal scale
_GAP = 0.18  # of a bar's place
_CHOSEN = "#D81B72"
_REACH = 14  # pixels within which a click takes a point
_POINT = 9  # radius of a point


class Chart(QtGui.QWidget):
    """A title, a vertical scale, and what a subclass draws over it.

    Subclasses call ``rescale(numbers)`` with what the scale must hold (none: nothing is drawn), and
    give ``draw(painter, area)`` and ``index_at(place)``. ``picked(index)`` is called when the mouse
    picks one of what is drawn.
    """

    bottom = _BOTTOM

    def __init__(self, title, picked=None):
        super().__init__()
        self.title, self.unit, self.chosen, self.picked = title, "", set(), picked
        self._scale = None
        self.setMinimumSize(240, 110)  # the titles are to be read
        self.setMouseTracking(True)

    def rescale(self, numbers):
        """Let the vertical scale hold these numbers, and draw anew."""
        self._scale = scale_for(numbers)
        self.update()

    def draw(self, painter, area):
        """Draw the numbers into ``area``."""
        raise NotImplementedError

    def index_at(self, place):
        """Number of what is drawn at a `QPoint`, None beside all."""

    def told(self, index):
        """What the tooltip says of it."""
        return ""

    def choose(self, indices):
        """Highlight some of what is drawn."""
        self.chosen = set(indices)
        self.update()

    # mouse

    def mousePressEvent(self, event):
        """Pick what is there."""
        index = self.index_at(event.pos())
        if index is not None and self.picked:
            self.picked(index)

    def mouseMoveEvent(self, event):
        """Tell of what is under the mouse."""
        index = self.index_at(event.pos())
        self.setToolTip("" if index is None else self.told(index))

    # drawing

    def ink(self):
        """Colour of text and lines on this theme."""
        return self.palette().color(QtGui.QPalette.WindowText)

    def faint(self):
        """Colour of the lines behind the numbers."""
        faint = QtGui.QColor(self.ink())
        faint.setAlpha(45)
        return faint

    def area(self):
        """Where the numbers are drawn."""
        return QtCore.QRectF(
            _LEFT, _TOP, self.width() - _LEFT - _RIGHT, self.height() - _TOP - self.bottom
        )

    def height_of(self, value, area):
        """Vertical position of a value; infinite ones are at the top."""
        low, high, _ = self._scale
        return area.bottom() - (min(value, high) - low) / (high - low) * area.height()

    def paintEvent(self, event):
        """Title, scale, numbers."""
        painter = QtGui.QPainter(self)
        painter.setRenderHint(QtGui.QPainter.Antialiasing)
        painter.setPen(self.ink())
        title = QtCore.QRectF(8, 4, self.width() - 16, _TOP - 12)
        painter.drawText(title, QtCore.Qt.AlignLeft | QtCore.Qt.AlignVCenter, self.title)
        area = self.area()
        if self._scale and area.width() > 40 and area.height() > 20:
            self._draw_scale(painter, area)
            self.draw(painter, area)
        painter.end()

    def _draw_scale(self, painter, area):
        low, high, step = self._scale
        every = max(1, round(16 * (high - low) / step / area.height()) or 1)
        right = QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter
        for k in range(0, round((high - low) / step) + 1, every):
            y = self.height_of(low + k * step, area)
            painter.setPen(self.faint())
            painter.drawLine(QtCore.QPointF(area.left(), y), QtCore.QPointF(area.right(), y))
            painter.setPen(self.ink())
            box = QtCore.QRectF(0, y - 8, _LEFT - 5, 16)
            painter.drawText(box, right, f"{round(low + k * step, 10):g}{self.unit}")


class BarChart(Chart):
    """One value a unit; ``limits`` draws a line across each bar."""

    def __init__(self, title, colour, picked):
        super().__init__(title, picked)
        self.colour = QtGui.QColor(colour)
        self.values, self.limits = [], []

    def set_values(self, values, limits=(), unit=""):
        """Draw other values."""
        self.values, self.limits, self.unit = list(values), list(limits), unit
        self.chosen = {k for k in self.chosen if k < len(self.values)}
        self.rescale([*self.values, *self.limits])

    def index_at(self, place):
        width = self.area().width()
        if not self.values or width <= 0 or not _LEFT <= place.x() < _LEFT + width:
            return None
        return int((place.x() - _LEFT) / width * len(self.values))

    def told(self, index):
        return f"{index + 1}: {self.values[index]:.4g}{self.unit}"

    def centre_of(self, index):
        """Position in the middle of a bar."""
        area = self.area()
        x = area.left() + (index + 0.5) * area.width() / len(self.values)
        return QtCore.QPoint(int(x), int(area.center().y()))

    def draw(self, painter, area):
        place = area.width() / len(self.values)
        for k, value in enumerate(self.values):
            x, y = area.left() + (k + _GAP / 2) * place, self.height_of(value, area)
            bar = QtCore.QRectF(x, y, (1 - _GAP) * place, area.bottom() - y)
            painter.fillRect(bar, QtGui.QColor(_CHOSEN) if k in self.chosen else self.colour)
            if k < len(self.limits):
                limit = self.height_of(self.limits[k], area)
                painter.setPen(QtGui.QPen(self.ink(), 2))
                start = QtCore.QPointF(area.left() + k * place, limit)
                painter.drawLine(start, start + QtCore.QPointF(place, 0))
        painter.setPen(self.ink())
        step = next(s for s in (1, 2, 5, 10, 20, 50, 100, 1e9) if s * place > 20)
        for k in range(len(self.values)):
            if (k + 1) % step == 0 or k == 0:
                box = QtCore.QRectF(area.left() + (k + 0.5) * place - 15, area.bottom() + 2, 30, 18)
                painter.drawText(box, QtCore.Qt.AlignCenter, str(k + 1))


class Plane(Chart):
    """A chart with a horizontal scale too, from 0; ``across`` names it."""

    bottom = _BOTTOM + _ACROSS

    def __init__(self, title, across, picked=None):
        super().__init__(title, picked)
        self.across, self.unit_across, self._width = across, "", None

    def widen(self, numbers):
        """Let the horizontal scale hold these numbers."""
        self._width = scale_for(numbers)

    def place_of(self, x, y):
        """Where a pair of numbers is drawn, as a `QPointF`."""
        area = self.area()
        return QtCore.QPointF(self._across(x, area), self.height_of(y, area))

    def _across(self, value, area):
        low, high, _ = self._width
        return area.left() + (value - low) / (high - low) * area.width()

    def draw(self, painter, area):
        low, high, step = self._width
        centre = QtCore.Qt.AlignHCenter | QtCore.Qt.AlignTop
        painter.setPen(self.ink())
        every = math.ceil(42 * (high - low) / step / area.width())
        for k in range(0, round((high - low) / step) + 1, every):
            x = self._across(low + k * step, area)
            box = QtCore.QRectF(min(x - 25, self.width() - 50), area.bottom() + 3, 50, 16)
            text = f"{round(low + k * step, 10):g}{self.unit_across}"
            painter.drawText(box, centre, text)
        box = QtCore.QRectF(area.left(), area.bottom() + 20, area.width(), 16)
        painter.drawText(box, centre, self.across)


class LineChart(Plane):
    """Lines over one another; each may be named at its top. A band tells of all the rest."""

    def set_lines(self, xs, lines, band=None):
        """Draw ``lines``, [(name, ys, colour)], over ``xs``; ``band``: (lowest ys, highest ys)."""
        self.xs, self.lines, self.band = list(xs), list(lines), band
        if self.lines:
            self.widen(self.xs)
        every = [ys for _, ys, _ in self.lines] + ([band[1]] if band else [])
        self.rescale([y for ys in every for y in ys] and [1.15 * max(map(max, every))])

    def draw(self, painter, area):
        super().draw(painter, area)
        if self.band:
            low, high = (
                [self.place_of(*p) for p in zip(self.xs, ys, strict=True)] for ys in self.band
            )
            painter.setPen(QtCore.Qt.NoPen)
            painter.setBrush(self.faint())
            painter.drawPolygon(QtGui.QPolygonF([*low, *reversed(high)]))
        taken = []
        for name, ys, colour in self.lines:
            places = [self.place_of(*p) for p in zip(self.xs, ys, strict=True)]
            painter.setBrush(QtCore.Qt.NoBrush)
            painter.setPen(QtGui.QPen(QtGui.QColor(colour), 2))
            painter.drawPolyline(QtGui.QPolygonF(places))
            self._write(painter, name, min(places, key=lambda p: p.y()), taken)

    def _write(self, painter, name, top, taken):
        """Write a name above the top of its line, or where there is room below other names."""
        metrics = painter.fontMetrics()
        box = QtCore.QRectF(metrics.boundingRect(name)).adjusted(-4, -1, 4, 1)
        box.moveCenter(QtCore.QPointF(top.x(), top.y() - box.height() / 2 - 2))
        area = self.area()
        box.moveLeft(max(area.left(), min(box.left(), area.right() - box.width())))
        while any(box.intersects(other) for other in taken):
            box.translate(0, box.height())
        taken.append(box)
        # not the palette's: of a style sheet it knows the ink, but not the ground
        ground = QtGui.QColor("#202020" if self.ink().lightness() > 110 else "#FFFFFF")
        ground.setAlpha(170)
        painter.fillRect(box, ground)
        painter.setPen(self.ink())
        painter.drawText(box, QtCore.Qt.AlignCenter, name)


class PointChart(Plane):
    """Numbered points; the first one, drawn as a diamond, is the recommended one."""

    def set_points(self, points, texts):
        """Draw ``points`` [(x, y)]; ``texts`` are their tooltips."""
        self.points, self.texts, self.chosen = list(points), list(texts), set()
        if self.points:
            self.widen([1.08 * max(x for x, _ in self.points)])
        self.rescale([1.08 * max(y for _, y in self.points)] if self.points else [])

    def index_at(self, place):
        if not self._scale:
            return None
        far = [
            (self.place_of(*point) - QtCore.QPointF(place)).manhattanLength()
            for point in self.points
        ]
        nearest = min(range(len(far)), key=far.__getitem__)
        return nearest if far[nearest] <= _REACH else None

    def told(self, index):
        return self.texts[index]

    def draw(self, painter, area):
        super().draw(painter, area)
        order = sorted(range(len(self.points)), key=lambda k: (k in self.chosen, -k))
        for k in order:  # the chosen one on top of all
            self._draw_point(painter, k)

    def _draw_point(self, painter, k):
        place, r = self.place_of(*self.points[k]), _POINT
        chosen = k in self.chosen
        fill = colours.PANELS["primary" if k == 0 else "border"]
        painter.setBrush(QtGui.QColor(_CHOSEN if chosen else fill))
        painter.setPen(QtGui.QPen(QtGui.QColor(colours.INK), 1.5))
        if k == 0:
            corners = ((0, -1.3), (1.3, 0), (0, 1.3), (-1.3, 0))
            painter.drawPolygon(
                QtGui.QPolygonF([place + QtCore.QPointF(r * x, r * y) for x, y in corners])
            )
        else:
            painter.drawEllipse(place, r, r)
        painter.setPen(QtGui.QColor("white" if chosen else colours.INK))
        box = QtCore.QRectF(place.x() - r, place.y() - r, 2 * r, 2 * r)
        painter.drawText(box, QtCore.Qt.AlignCenter, str(k + 1))


def scale_for(numbers):
    """Round ends and step of a scale that holds 0 and all finite numbers; None without numbers."""
    numbers = list(numbers)
    if not numbers:
        return None
    finite = [0.0, *(x for x in numbers if math.isfinite(x))]
    low, high = min(finite), max(finite)
    step = nice_step(high - low or 1.0)
    return math.floor(low / step) * step, math.ceil(high / step) * step or step, step


def nice_step(span):
    """A round step that divides ``span`` into two to five."""
    rough = span / 4
    power = 10 ** math.floor(math.log10(rough))
    return next(f * power for f in (1, 2, 2.5, 5, 10) if f * power >= rough * 0.999)


THETA, RATIO, MARGIN = (colours.PANELS[k] for k in ("primary", "border", "secondary"))
WEAKEST, CHOSEN = colours.PANELS["primary"], _CHOSEN
