# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of a panel that fold away, and which fields stand above them, always in sight."""

from PySide import QtCore, QtGui

# Type of object -> its basic properties: what most designs are made with, on one screen of
# 1280 × 720. The others, and types that are not here, are in groups.
BASICS = {
    "Bistable::TrianglePlacement": ("Curve", "EdgeLength", "Gamma", "PlacementRule", "Count"),
    "Bistable::BistableUnit": (
        "Triangles", "Theta", "EdgeLength", "RatioRule", "Ratio", "RatioShare", "TargetMargin",
        "HeightRatio",
    ),
    "Bistable::HingeSet": (
        "Unit", "Process", "HingeType", "FaceThickness", "GapLength", "GapBetweenPlanes",
    ),
    "Bistable::HingeCoupon": ("Kind", "Preset", "HingeType", "FaceThickness", "GapLength"),
}  # fmt: skip
_AROUND = 4  # pixels above and below the text of a title, together
_opened: dict = {}  # (type, group) -> whether the user left it open, until FreeCAD ends


def form_in(widget):
    """A `QFormLayout` in ``widget``, as all panels have it."""
    form = QtGui.QFormLayout(widget)
    form.setContentsMargins(0, 0, 0, 0)
    form.setFieldGrowthPolicy(QtGui.QFormLayout.AllNonFixedFieldsGrow)
    form.setRowWrapPolicy(QtGui.QFormLayout.WrapLongRows)
    form.setVerticalSpacing(3)  # hidden rows and empty explanations keep their spacing
    return form


class Fold(QtGui.QWidget):
    """A group of rows below a title that shows and hides them; ``form`` takes the rows.

    Types of objects with `BASICS` have their groups folded until the user opens them.
    """

    def __init__(self, type_name, group, title):
        super().__init__()
        self.setObjectName(f"{group}_group")
        self._key = type_name, group
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        self.title = QtGui.QToolButton()
        self.title.setText(title)
        self.title.setCheckable(True)
        self.title.setAutoRaise(True)
        self.title.setToolButtonStyle(QtCore.Qt.ToolButtonTextBesideIcon)
        self.title.setMaximumHeight(self.title.fontMetrics().height() + _AROUND)
        self.title.setSizePolicy(QtGui.QSizePolicy.Ignored, QtGui.QSizePolicy.Fixed)
        self.title.toggled.connect(self._fold)
        self.title.clicked.connect(lambda on: _opened.update({self._key: on}))
        self._body = QtGui.QWidget()
        self.form = form_in(self._body)
        self.form.setContentsMargins(9, 0, 0, 3)
        column.addWidget(self.title)
        column.addWidget(self._body)
        self._fold(False)
        self.title.setChecked(_opened.get(self._key, type_name not in BASICS))

    def unfold(self):
        """Show the rows."""
        self.title.setChecked(True)

    def _fold(self, is_open):
        self.title.setArrowType(QtCore.Qt.DownArrow if is_open else QtCore.Qt.RightArrow)
        self._body.setVisible(is_open)
