# SPDX-License-Identifier: LGPL-2.1-or-later
"""One finding of a check."""

from dataclasses import dataclass

NOTE, WARNING, ERROR = "note", "warning", "error"


@dataclass(frozen=True)
class Finding:
    """What a check found: plain data for a panel, a report and a test.

    ``severity``: `NOTE` (as it should be, worth knowing), `WARNING` or `ERROR`; ``code``: short
    fixed name of the check; ``place``: names of the bodies, hinge or unit; ``number`` was measured
    and ``limit`` asked for (mm unless the code says otherwise; None where there is none);
    ``message``: one sentence; ``cure``: what to change; ``points``: where in space, mm, in the
    state ``opening`` (0 flat … 1 deployed), or on the bed as it is printed (None).
    """

    severity: str
    code: str
    place: tuple
    number: float | None
    limit: float | None
    message: str
    cure: str = ""
    points: tuple = ()
    opening: float | None = None

    def __str__(self):
        return f"{self.message[:-1]}: {self.cure}." if self.cure else self.message
