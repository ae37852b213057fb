# SPDX-License-Identifier: LGPL-2.1-or-later
"""Models of prints made in a thread beside the window, with progress, Esc and an end.

Only numbers and the kernel's free shapes are touched aside; the document is touched in the
window's thread, when a model is there.
"""

import contextlib
import threading

import FreeCAD as App
from PySide import QtCore

from ..objects import later, type_of
from ..origami.errors import Refusal
from ..origami.progress import Cancelled, Progress
from . import threads
from .body_nodes import prepare
from .status import Status

HINGE_SET = "Bistable::HingeSet"
_POLL = 40  # ms
_AT_ONCE = 0.05  # s that a recompute waits for a model before it goes on without
_MAKING = 0.7  # of the time that making and drawing take
_ONE = threading.Lock()  # one model at a time: the window wants a processor too


class Job:
    """One piece of work in a thread of its own: ``work(progress)``, ``result`` or ``error``.

    ``alone``: no other such work goes on at the same time.
    """

    def __init__(self, order, work, alone=True):
        self.order, self._work, self._alone = order, work, alone
        self.text, self.fraction = "", None
        self.result = self.error = None
        self._stopped = False
        self._thread = None

    @property
    def is_started(self):
        """Whether it goes on, or has ended."""
        return self._thread is not None

    def start(self):
        """Begin, if it has not begun."""
        if self._thread is None:
            self._thread = threads.start(self._run)
        return self

    def stop(self):
        """End it at its next step."""
        self._stopped = True

    def wait(self, seconds):
        """Whether it has ended within that time."""
        self._thread.join(seconds)
        return not self._thread.is_alive()

    def _run(self):
        try:
            with _ONE if self._alone else contextlib.nullcontext():
                self.result = self._work(Progress(self._say, lambda: self._stopped))
        except BaseException as error:
            self.error = error

    def _say(self, text, fraction):
        self.text, self.fraction = text, fraction


class Runner(QtCore.QObject):
    """What `objects.later` asks: models of HingeSet objects, one job for each object."""

    def __init__(self):
        super().__init__()
        self._jobs = {}  # (document's name, object's name) -> Job
        self._waited = None
        self.status = Status(self.stop_all, self.make_stale)
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(self._follow)
        self._observer = _Observer(self)
        App.addDocumentObserver(self._observer)

    def begin(self, obj, order, work, follows=False):
        """Start what makes the model of ``order`` unless it goes on already; wait a moment for it.

        True where it ended at once: the object's proxy has taken what came out of it. What only
        ``follows`` begins when the solids have been drawn, which would else take longer.
        """
        key = obj.Document.Name, obj.Name
        job = self._jobs.get(key)
        if job is None or job.order != order:
            if job is not None:
                job.stop()
            job = self._jobs[key] = Job(order, work if follows else _drawable(work))
        if not follows and job.start().wait(_AT_ONCE):
            del self._jobs[key]
            obj.Proxy.take(job.order, job.result, job.error)
            return True
        self._timer.start(_POLL)
        return False

    def wait(self, obj, order, work):
        """The model of ``order``, for Python that waits: the window shows progress, Esc stops it.

        `Cancelled` where it was stopped.
        """
        job = self._jobs.pop((obj.Document.Name, obj.Name), None)
        if job is None or job.order != order:
            if job is not None:
                job.stop()
            job = Job(order, _drawable(work))
        if not job.start().wait(_AT_ONCE):
            self._waited = job
            self.status.wait_for(job)
            self._waited = None
        if job.error is not None:
            raise job.error
        return job.result

    def is_busy(self):
        """Whether anything is being made."""
        return bool(self._jobs)

    def stop_all(self):
        """The user has had enough: what is being made stays as it was, greyed."""
        for job in (*self._jobs.values(), self._waited):
            if job is not None:
                job.stop()

    def drop(self, obj):
        """What is being made for ``obj`` is not wanted any more."""
        job = self._jobs.pop((obj.Document.Name, obj.Name), None)
        if job is not None:
            job.stop()

    def make(self, obj):
        """Make the solids of a HingeSet now, whatever its Update says."""
        with _asked(obj):
            obj.touch()
            with later.leaving():
                obj.Document.recompute([obj])

    def make_stale(self):
        """Make the solids of all HingeSets of the active document that are not up to date."""
        for obj in stale_in(App.ActiveDocument):
            self.make(obj)

    def _follow(self):
        for key, job in list(self._jobs.items()):
            obj = _object(*key)
            if obj is None:
                job.stop()
                del self._jobs[key]
            elif not job.is_started:
                if not _is_drawing(obj):
                    job.start()
            elif job.wait(0) and not _is_recomputing(obj.Document):
                del self._jobs[key]
                self._finish(obj, job)
        if not self._jobs:
            self._timer.stop()
        self.status.show(list(self._jobs.values()), stale_in(App.ActiveDocument))

    def _finish(self, obj, job):
        """Let the object take what was made for it."""
        if isinstance(job.error, Cancelled):
            return
        obj.Proxy.take(job.order, job.result, job.error)
        obj.touch()
        with later.leaving():  # should it have changed meanwhile
            obj.Document.recompute([obj])

    def reconcile(self, doc):
        """After undo or redo: solids that are no longer those of their inputs are made anew."""
        for obj in doc.Objects:
            if type_of(obj) == HINGE_SET and obj.MadeFrom:
                with contextlib.suppress(Refusal):
                    current = obj.Proxy.order(obj).digest == obj.MadeFrom
                    if current:
                        self.drop(obj)
                    if not (current and obj.UpToDate):
                        obj.touch()
                        with later.leaving():
                            doc.recompute([obj])


class _Observer:
    """Undo and redo bring back inputs; solids made aside are no part of what they undo."""

    def __init__(self, runner):
        self._runner = runner

    def slotUndoDocument(self, doc):
        """FreeCAD has undone something."""
        name = doc.Name  # the document may be closed before then
        QtCore.QTimer.singleShot(0, lambda: self._later(name))

    slotRedoDocument = slotUndoDocument

    def slotActivateDocument(self, doc):
        """Another document: what is stale there is another thing."""
        self._runner._timer.start(_POLL)

    def _later(self, name):
        if name in App.listDocuments():
            self._runner.reconcile(App.getDocument(name))


def install():
    """Let recomputes that nobody waits for go on aside; once."""
    if later.runner is None:
        later.runner = Runner()


def make(obj):
    """Make the solids of a HingeSet now, whatever its Update says."""
    install()
    later.runner.make(obj)


def stale_in(doc):
    """HingeSets of a document whose solids are not those of their inputs."""
    if doc is None:
        return []
    return [obj for obj in doc.Objects if type_of(obj) == HINGE_SET and not obj.UpToDate]


@contextlib.contextmanager
def _asked(obj):
    obj.Proxy.asked = True
    try:
        yield
    finally:
        obj.Proxy.asked = False


def _drawable(work):
    """The work, and then what the view needs to draw its bodies, which takes as long."""

    def made(progress):
        model = work(progress.part(0, _MAKING))
        for done, body in enumerate(model.bodies):
            progress.step("Hinged solids…", _MAKING + (1 - _MAKING) * done / len(model.bodies))
            prepare(body.shape)
        return model

    return made


def _object(document, name):
    if document not in App.listDocuments():
        return None
    return App.getDocument(document).getObject(name)


def _is_drawing(obj):
    view = getattr(obj.ViewObject, "Proxy", None)  # None where it was lost, until Repair
    return hasattr(view, "is_drawing") and view.is_drawing()


def _is_recomputing(doc):
    return bool(getattr(doc, "Recomputing", False))
