# SPDX-License-Identifier: LGPL-2.1-or-later
"""A button that measures how a print snaps, wobbles and stands, beside the window."""

from PySide import QtCore, QtGui

from ..language.labels import translate
from ..origami.progress import Cancelled
from ..scene.aside import Job
from .base import is_there

_POLL = 60  # ms


class MeasureButton(QtGui.QPushButton):
    """Starts the study of a HingeSet, shows how far it is, and stops it when clicked again.

    ``done(error)`` is called at the end: None where the object has its results, a `ValueError`
    where they cannot be; not if the user stopped it.
    """

    def __init__(self, done):
        super().__init__()
        self.setObjectName("Measure")
        self.obj, self._done = None, done
        self._job = self._keep = None
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._follow)
        self.clicked.connect(self._clicked)
        self._label()

    @property
    def is_busy(self):
        """Whether a study goes on."""
        return self._job is not None

    def ask_about(self, obj):
        """The HingeSet that a click measures; a study of another one ends."""
        if obj is not self.obj:
            self.stop()
        self.obj = obj

    def stop(self):
        """End the study, if one goes on."""
        if self._job is not None:
            self._job.stop()
        self._end()

    def task(self):
        """What to work on, ``work(progress)``, and what to do with its result, ``keep(result)``."""
        return self.obj.Proxy.study_task(self.obj)

    def texts(self):
        """What the button says, and what while it works, with a place for how far it is."""
        return (
            translate("BistablePlots", "How hard does it snap, does it stand?"),
            translate("BistablePlots", "Stop measuring ({:.0%})"),
        )

    def _clicked(self):
        if self._job is not None:
            self.stop()
        elif is_there(self.obj):
            self._begin()

    def _begin(self):
        try:
            work, self._keep = self.task()
        except Cancelled:
            return
        except ValueError as error:
            self._done(error)
            return
        self._job = Job(None, work, alone=False).start()
        self._timer.start(_POLL)
        self._label()

    def _follow(self):
        job, keep = self._job, self._keep
        if job is None or not job.wait(0):
            self._label()
            return
        self._end()
        if not is_there(self.obj) or isinstance(job.error, Cancelled):
            return
        if job.error is not None and not isinstance(job.error, ValueError):
            raise job.error
        if job.error is None:
            keep(job.result)
        self._done(job.error)

    def _end(self):
        self._timer.stop()
        self._job = self._keep = None
        self._label()

    def _label(self):
        begin, stop = self.texts()
        self.setText(begin if self._job is None else stop.format(self._job.fraction or 0.0))
