# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of a Curve: its control points as a table and in the 3D view."""

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from ..language.labels import translate, translated
from ..origami.curves.families import FAMILIES, counts
from ..scene.handles import Handles
from .base import ObjectPanel, icon
from .fields import Field, wrapped

_ENOUGH = 2  # points that a curve needs


class CurvePanel(ObjectPanel):
    """Points are dragged in the view, clicked into it, or typed."""

    def build_more(self, column):
        """The table, and the points in the view."""
        prop = next(p for p in self.obj.Proxy.PROPERTIES if p.name == "Points")
        field = Points(self.obj, prop, self.changed)
        form = self.form_of(column, prop.group, prop.name)
        self.fields[field.name] = field
        form.insertRow(0, field.widget)
        form.insertRow(1, field.error)
        self.handles = None
        view = Gui.getDocument(self.doc.Name).ActiveView
        if hasattr(view, "getSceneGraph"):
            self.handles = Handles(view, self.obj, field.set_points)
            field.add.toggled.connect(self._set_adding)
        if len(self.obj.Points) < _ENOUGH:
            field.add.setChecked(True)
        self._follow_hidden()

    def changed(self, field):
        """Keep table and view together."""
        if self.handles and self.handles.points != self.obj.Points:
            self.handles.set_points(self.obj.Points)
        elif self.handles:
            self.handles.show()
        super().changed(field)

    def close(self):
        """Take the points out of the view."""
        super().close()
        if self.handles:
            self.handles.remove()
            self.handles = None

    def _compute_cheap(self):
        if self.obj.Source is not None or len(self.obj.Points) >= _ENOUGH:
            super()._compute_cheap()

    def show_state(self):
        """Say what to do as long as there is no curve."""
        super().show_state()
        if self.obj.Source is None and len(self.obj.Points) < _ENOUGH:
            self.say(translate("BistablePanel", "Click points into the 3D view: the tube follows."))

    def _follow_hidden(self):
        """Show only what counts for this kind of curve."""
        super()._follow_hidden()
        if "Points" not in self.fields:  # still being built
            return
        if self.obj.Source is not None:
            self.fields["Points"].add.setChecked(False)
        for kind in set(FAMILIES) & set(self.folds):
            self.folds[kind].setVisible(counts(kind, self.obj.Kind, self.obj.FoundKind))

    def _set_adding(self, adding):
        self.handles.adding = adding


class Points(Field):
    """Control points: a table of coordinates, buttons to add and to remove."""

    def build(self):
        self.widget = QtGui.QWidget()
        column = QtGui.QVBoxLayout(self.widget)
        column.setContentsMargins(0, 0, 0, 0)
        self.table = QtGui.QTableWidget(0, 3)
        self.table.setObjectName("PointsTable")
        self.table.setHorizontalHeaderLabels(["x mm", "y mm", "z mm"])  # in any unit scheme
        self.table.horizontalHeader().setSectionResizeMode(QtGui.QHeaderView.Stretch)
        self.table.verticalHeader().setDefaultSectionSize(24)
        self.table.setMinimumHeight(150)
        self.table.setToolTip(wrapped(translated(self.prop.tip)))
        self.table.itemChanged.connect(self.edited)
        column.addWidget(self.table)
        row = QtGui.QHBoxLayout()
        self.add = QtGui.QToolButton()
        self.add.setObjectName("AddPoints")
        self.add.setText(translate("BistablePanel", "Add in view"))
        self.add.setIcon(icon("DrawCurve"))
        self.add.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self.add.setCheckable(True)
        self.add.setToolTip(
            translate("BistablePanel", "Every click into the 3D view adds a point at the end")
        )
        remove = QtGui.QToolButton()
        remove.setObjectName("RemovePoint")
        remove.setText(translate("BistablePanel", "Remove"))
        remove.setToolTip(translate("BistablePanel", "Remove the chosen point (or right-click it)"))
        remove.clicked.connect(self._remove)
        row.addWidget(self.add)
        row.addWidget(remove)
        row.addStretch(1)
        column.addLayout(row)

    def show(self, value):
        self.table.setRowCount(len(value))
        for row, point in enumerate(value):
            for column, coordinate in enumerate(point):
                item = QtGui.QTableWidgetItem(f"{coordinate:.2f}")
                item.setData(QtCore.Qt.UserRole, coordinate)
                item.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
                self.table.setItem(row, column, item)

    def is_hidden(self):
        """See `Field.is_hidden`; what the curve follows counts instead of its points."""
        return self.obj.Source is not None or super().is_hidden()

    def set_points(self, points):
        """Take points from the view."""
        self.obj.Points = points
        self.refresh()
        self._changed(self)

    def value(self):
        return [
            App.Vector(*(self._number(row, column) for column in range(3)))
            for row in range(self.table.rowCount())
        ]

    def _number(self, row, column):
        item = self.table.item(row, column)
        exact = item.data(QtCore.Qt.UserRole)
        if item.text() == f"{exact:.2f}":
            return exact
        try:
            return float(item.text().replace(",", "."))
        except ValueError:
            return exact

    def _remove(self):
        points = list(self.obj.Points)
        if points:
            row = self.table.currentRow()
            del points[row if row >= 0 else -1]
            self.set_points(points)
