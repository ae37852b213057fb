# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results that frozen values remember, so that what has not changed is not solved again."""

from collections import OrderedDict
from collections.abc import Callable
from functools import wraps
from threading import Lock
from typing import Any, NamedTuple

from .errors import Refusal

_ALL: list[OrderedDict] = []


def remembered(most: int) -> Callable:
    """Decorate a method of a hashable frozen value: the result is computed once.

    It stays with the value as long as that lives, and is found again by the ``most`` latest equal
    values: an undo, a second look at the same number or another object with the same inputs costs
    nothing. What is refused is refused again at no cost either: a search that finds nothing is the
    longest. Arguments (a `progress.Progress`) are no part of what is remembered; nor is what was
    cancelled. Results are shared: nobody may write into their arrays.
    """

    def decorate(method: Callable) -> Callable:
        latest: OrderedDict[Any, Any] = OrderedDict()
        lock = Lock()  # work aside and the window may ask at the same time
        slot = f"_{method.__name__}"
        _ALL.append(latest)

        @wraps(method)
        def call(self: Any, *args: Any) -> Any:
            own = self.__dict__
            if slot not in own:
                with lock:
                    known = latest.get(self)
                if known is None:
                    try:
                        known = method(self, *args)
                    except Refusal as refused:
                        known = _Refused(refused)
                own[slot] = known
                with lock:
                    latest[self] = known
                    latest.move_to_end(self)
                    while len(latest) > most:
                        latest.popitem(last=False)
            found = own[slot]
            if isinstance(found, _Refused):
                raise found.refusal.with_traceback(None)
            return found

        setattr(call, "known", lambda self: slot in self.__dict__ or self in latest)  # noqa: B010
        return call

    return decorate


class _Refused(NamedTuple):
    refusal: Refusal


def forget() -> None:
    """Forget what equal values would find (not what a living value holds): for tests."""
    for latest in _ALL:
        latest.clear()
