# SPDX-License-Identifier: LGPL-2.1-or-later
"""A search in a thread of its own beside a panel; nothing of Qt or of the document is touched."""

from ..origami.errors import Refusal
from ..origami.progress import Cancelled, Progress
from ..scene import threads


class Aside:
    """``work(progress)`` on its way: ``text`` and ``fraction``, then ``result`` or ``error``.

    Neither where it was stopped.
    """

    def __init__(self, work):
        self.text, self.fraction = "", 0.0
        self.result, self.error, self._stopped = None, None, False
        self._thread = threads.start(self._run, work)

    def is_running(self):
        """Whether it has not ended yet."""
        return self._thread.is_alive()

    def stop(self):
        """End it at its next step."""
        self._stopped = True

    def _run(self, work):
        try:
            self.result = work(Progress(self._say, lambda: self._stopped))
        except Cancelled:
            pass
        except Refusal as error:
            self.error = error
        except Exception as error:  # a thread that breaks must not leave the panel waiting
            self.error = Refusal("{kind}: {error}", kind=type(error).__name__, error=str(error))

    def _say(self, text, fraction):
        self.text, self.fraction = text, fraction or self.fraction
