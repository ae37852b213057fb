# SPDX-License-Identifier: LGPL-2.1-or-later
"""Progress of long work, and its end before its time: one protocol for all of it."""

from collections.abc import Callable


class Cancelled(Exception):
    """The user has had enough: the work ends and leaves everything as it was."""

    def __str__(self) -> str:
        return "Cancelled."


class Progress:
    """What long work reports to: ``step(text, fraction)``, which raises `Cancelled`.

    ``say(text, fraction)``: shows it; the text is a short English template, the fraction of the
    whole work lies between 0 and 1, or is None where it is unknown. ``cancelled()``: asked at every
    step. The default reports to nobody.
    """

    def __init__(
        self,
        say: Callable[[str, float | None], None] | None = None,
        cancelled: Callable[[], bool] | None = None,
        span: tuple[float, float] = (0.0, 1.0),
    ) -> None:
        self._say, self._cancelled, self._span = say, cancelled, span

    def step(self, text: str = "", fraction: float | None = None) -> None:
        """Report; `Cancelled` where the user wants no more."""
        if self._cancelled is not None and self._cancelled():
            raise Cancelled
        if self._say is not None:
            low, high = self._span
            self._say(text, None if fraction is None else low + fraction * (high - low))

    def part(self, low: float, high: float) -> "Progress":
        """Progress of a part of the work, which is this much of the whole."""
        start, end = self._span
        width = end - start
        return Progress(self._say, self._cancelled, (start + low * width, start + high * width))

    def named(self, text: str) -> "Progress":
        """The same, where steps without a text of their own are told as ``text``."""
        return Progress(lambda own, fraction: self.step(own or text, fraction))


NOBODY = Progress()


def as_progress(given: Progress | None) -> Progress:
    """A `Progress` of what a macro may give: one, None, or a function that takes a text."""
    if isinstance(given, Progress):
        return given
    return NOBODY if given is None else Progress(lambda text, fraction: given(text))
