# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window's status bar says of solids that are being made, or are not up to date."""

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

translate = App.Qt.translate
_STEP = 5  # % by which the bar moves
_INPUT = (
    QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease, QtCore.QEvent.Shortcut,
    QtCore.QEvent.ShortcutOverride, QtCore.QEvent.MouseButtonPress,
    QtCore.QEvent.MouseButtonRelease, QtCore.QEvent.MouseButtonDblClick, QtCore.QEvent.Wheel,
    QtCore.QEvent.ContextMenu, QtCore.QEvent.Close,
)  # fmt: skip


class Status(QtCore.QObject):
    """Progress with a button to stop, or a button that makes what is stale; nothing else.

    ``stop()`` is called on the button and on Esc, ``make()`` on the other button and on Enter in
    the 3D view. Keys count only while there is something to stop or to make.
    """

    def __init__(self, stop, make):
        super().__init__()
        self._stop, self._make = stop, make
        self._is_busy = self._is_stale = self._is_waiting = False
        self.box = None

    def show(self, jobs, stale):
        """Show how far ``jobs`` are, or that objects are ``stale``."""
        self._is_busy, self._is_stale = bool(jobs), bool(stale) and not jobs
        if not (jobs or stale or self.box):
            return
        if self.box is None:
            self._build()
            QtCore.QCoreApplication.instance().installEventFilter(self)
        self.box.setVisible(bool(jobs or stale))
        self.stop.setVisible(self._is_busy)
        self.make.setVisible(self._is_stale)
        fraction = jobs[0].fraction if jobs else None
        self.bar.setVisible(fraction is not None)
        if jobs:
            text = translate("BistableLive", "Making solids")
            # A bar that swings or creeps has the whole window drawn anew, many times a second.
            self.bar.setValue(_STEP * round(100 / _STEP * (fraction or 0)))
        else:
            labels = ", ".join(obj.Label for obj in stale[:3])
            text = translate("BistableLive", "{}: solids not up to date").format(labels)
        self.text.setText(text)

    def wait_for(self, job):
        """Show a job until it ends, with all other input kept away."""
        self._is_waiting = True
        application = QtCore.QCoreApplication.instance()
        try:
            while not job.wait(0.02):
                self.show([job], [])
                application.processEvents()
        finally:
            self._is_waiting = False
            self.show([], [])

    def eventFilter(self, watched, event):
        """Esc stops; Enter in the 3D view makes; who waits gets nothing else."""
        kind = event.type()
        if kind not in _INPUT:
            return False
        if kind == QtCore.QEvent.KeyPress:
            key = event.key()
            if key == QtCore.Qt.Key_Escape and (self._is_busy or self._is_waiting):
                self._stop()
                return True
            if (
                key in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter)
                and self._is_stale
                and not self._is_busy
                and _is_in_view(watched)
            ):
                QtCore.QTimer.singleShot(0, self._make)
                return True
        return self._is_waiting and not _is(watched, "BistableStop")

    def _build(self):
        bar = Gui.getMainWindow().statusBar()
        self.box = QtGui.QWidget(bar)
        self.box.setObjectName("BistableStatus")
        row = QtGui.QHBoxLayout(self.box)
        row.setContentsMargins(0, 0, 0, 0)
        self.text, self.bar = QtGui.QLabel(), QtGui.QProgressBar()
        self.bar.setMaximumWidth(140)
        self.stop = QtGui.QPushButton(translate("BistableLive", "Stop (Esc)"))
        self.make = QtGui.QPushButton(translate("BistableLive", "Make solids (Enter)"))
        self.stop.setObjectName("BistableStop")
        self.make.setObjectName("BistableMake")
        self.stop.clicked.connect(lambda: self._stop())
        self.make.clicked.connect(lambda: self._make())
        for part in (self.text, self.bar, self.stop, self.make):
            row.addWidget(part)
        self.bar.setRange(0, 100)
        bar.addPermanentWidget(self.box)


def _is(watched, name):
    return isinstance(watched, QtCore.QObject) and watched.objectName() == name


def _is_in_view(watched):
    """Whether an event goes to a 3D view."""
    view = Gui.ActiveDocument.ActiveView if Gui.ActiveDocument else None
    if not hasattr(view, "graphicsView") or not isinstance(watched, QtGui.QWidget):
        return False
    graphics = view.graphicsView()
    return watched is graphics or graphics.isAncestorOf(watched)
