# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an import: every curve of a file with a picture, its layer and its length."""

from pathlib import Path

import numpy as np
from PySide import QtCore, QtGui

from ..language.labels import translate, translated
from ..language.words import in_words
from ..objects.curve import Curve
from ..origami.errors import Refusal
from .base import icon

_PICTURE = QtCore.QSize(52, 36)
_LISTED = 200  # curves that are shown
_WAIT = 300  # ms after the last change of a number before the file is read again


class ImportPanel:
    """Choose among the curves of ``path``.

    ``read(scale, join)`` → curves with a receipt, or a `Refusal`; scale is None until somebody
    gives one. ``make(numbers, scale, join, radius, curves)`` makes those that are chosen, and says
    whether it did; ``cancelled()`` is called on Cancel.
    """

    def __init__(self, path, read, make, cancelled):
        self.path, self._read, self._make, self._cancelled = Path(path), read, make, cancelled
        self.curves, self.given = None, False
        self.form = QtGui.QWidget()
        self.form.setObjectName("BistableImport")
        title = translate("BistableImport", "Import {}").format(self.path.name)
        self.form.setWindowTitle(title)
        self.form.setWindowIcon(icon("Import"))
        column = QtGui.QVBoxLayout(self.form)
        self.table = self._table()
        column.addWidget(self.table, 1)
        column.addLayout(self._numbers())
        self.receipt = QtGui.QLabel()
        self.receipt.setObjectName("Receipt")
        self.receipt.setWordWrap(True)
        self.receipt.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
        column.addWidget(self.receipt)
        self.timer = QtCore.QTimer(self.form)
        self.timer.setSingleShot(True)
        self.timer.timeout.connect(self.refresh)
        self.refresh()

    def _table(self):
        heads = (
            translate("BistableImport", "Curve"),
            translate("BistableImport", "Layer"),
            translate("BistableImport", "Length"),
            translate("BistableImport", "Size"),
        )
        table = QtGui.QTableWidget(0, len(heads))
        table.setObjectName("Curves")
        table.setHorizontalHeaderLabels(heads)
        table.setIconSize(_PICTURE)
        table.setSelectionBehavior(QtGui.QAbstractItemView.SelectRows)
        table.setEditTriggers(QtGui.QAbstractItemView.NoEditTriggers)
        table.verticalHeader().hide()
        table.setMinimumHeight(160)
        return table

    def _numbers(self):
        form = QtGui.QFormLayout()
        form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
        self.scale = _spin("Scale", 1.0, 1e-6, 1e6, 6, "")
        self.scale.setToolTip(translate("BistableImport", "All lengths are multiplied by this"))
        form.addRow(translate("BistableImport", "Scale"), self.scale)
        self.join = _spin("Join", 0.01, 0, 1000, 4, " mm")
        self.join.setToolTip(
            translate("BistableImport", "Ends of pieces that are so near each other are joined")
        )
        form.addRow(translate("BistableImport", "Join gaps up to"), self.join)
        self.radius = _spin("CornerRadius", 0, 0, 1e5, 3, " mm")
        (prop,) = (one for one in Curve.PROPERTIES if one.name == "CornerRadius")
        self.radius.setToolTip(translated(prop.tip))
        form.addRow(translate("BistableImport", "Corner radius"), self.radius)
        self.scale.valueChanged.connect(self._give)
        for field in (self.scale, self.join):
            field.valueChanged.connect(lambda _: self.timer.start(_WAIT))
        return form

    def refresh(self):
        """Read the file with the numbers of the panel, and show what is in it."""
        self.timer.stop()
        self.curves = None
        self.table.setRowCount(0)
        try:
            self.curves = self._read(self.factor(), self.join.value())
        except Refusal as error:
            self.receipt.setText(in_words(error))
            return
        shown = self.curves[:_LISTED]
        self.table.setRowCount(len(shown))
        for row, curve in enumerate(shown):
            size = " × ".join(f"{x:.4g}" for x in curve.size if x > 1e-6)
            texts = (str(row + 1), curve.layer, f"{curve.length:.5g} mm", f"{size} mm")
            for place, text in enumerate(texts):
                self.table.setItem(row, place, QtGui.QTableWidgetItem(text))
            picture = thumbnail(curve.points(), self.form.palette())
            self.table.item(row, 0).setIcon(QtGui.QIcon(picture))
        self.table.setColumnHidden(1, not any(curve.layer for curve in shown))
        self.table.resizeColumnsToContents()
        self.table.resizeRowsToContents()
        self.table.selectRow(0)
        self.receipt.setText("\n".join(map(in_words, self.curves.receipt.phrases())))

    def factor(self):
        """The scale, None where nobody has given one."""
        return self.scale.value() if self.given else None

    def _give(self, _):
        self.given = True

    def getStandardButtons(self):
        """OK and Cancel."""
        box = QtGui.QDialogButtonBox
        return sum(int(getattr(b, "value", b)) for b in (box.Ok, box.Cancel))

    def accept(self):
        """OK: make the chosen curves. Stay open where that cannot be."""
        if self.timer.isActive():
            self.refresh()
        if self.curves is None:
            return False
        rows = sorted({index.row() for index in self.table.selectedIndexes()})
        if not rows:
            self.receipt.setText(translate("BistableImport", "Choose a curve."))
            return False
        numbers = [row + 1 for row in rows]
        asked = self.factor(), self.join.value(), self.radius.value()
        return self._make(numbers, *asked, self.curves)

    def reject(self):
        """Cancel: nothing is imported."""
        self.timer.stop()
        self._cancelled()
        return True


def _spin(name, value, low, high, decimals, suffix):
    field = QtGui.QDoubleSpinBox()
    field.setObjectName(name)
    field.setDecimals(decimals)
    field.setRange(low, high)
    field.setValue(value)
    field.setSuffix(suffix)
    field.setSingleStep(0.01 if low == 0 else 0.1)
    return field


def thumbnail(points, palette):
    """A small picture of a curve, seen from the side on which it is widest."""
    flat = points - points.mean(0)
    if np.ptp(flat[:, 2]) > 1e-6:
        flat = flat @ np.linalg.svd(flat, full_matrices=False)[2].T
    flat = flat[:, :2] * (1, -1)
    width, height = _PICTURE.width() - 8, _PICTURE.height() - 8
    low, extent = flat.min(0), np.maximum(np.ptp(flat, axis=0), 1e-9)
    scale = min(width / extent[0], height / extent[1])
    shown = (flat - low) * scale + (np.array([width, height]) - extent * scale) / 2 + 4
    picture = QtGui.QPixmap(_PICTURE)
    picture.fill(palette.color(QtGui.QPalette.Base))
    painter = QtGui.QPainter(picture)
    painter.setRenderHint(QtGui.QPainter.Antialiasing)
    painter.setPen(QtGui.QPen(palette.color(QtGui.QPalette.Text), 1.5))
    steps = max(1, len(shown) // 400)
    line = [QtCore.QPointF(x, y) for x, y in [*shown[::steps].tolist(), shown[-1].tolist()]]
    painter.drawPolyline(QtGui.QPolygonF(line))
    painter.end()
    return picture
