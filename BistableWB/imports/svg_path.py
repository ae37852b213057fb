# SPDX-License-Identifier: LGPL-2.1-or-later
"""Path data of SVG: the grammar of SVG 2, chapter 9, and its elliptic arcs (appendix B.2)."""

import math
import re
from collections.abc import Callable

import numpy as np

from ..origami.errors import Refusal
from .pieces import MAX_PIECES, Arc, Array, Line, Piece, bezier

_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
_GAP = re.compile(r"[ \t\r\n\f]*,?[ \t\r\n\f]*")
_BLANK = re.compile(r"[ \t\r\n\f]*")
_COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
_FLAGS = {3, 4}  # of an arc's numbers: one digit each, which need nothing between them


class PathData:
    """The sub-paths of path data: ``subpaths`` [[pieces]], ``closed`` [bool].

    As the specification wants it, everything before an error is drawn; ``error`` says where that
    was (a position in the text), or is None.
    """

    def __init__(self, text: str):
        self.text, self.position = text, 0
        self.subpaths: list[list[Piece]] = []
        self.closed: list[bool] = []
        self.error: int | None = None
        self.here = self.first = self.control = complex(0)
        self.before = ""  # the command that drew last, in capitals
        self.count = 0
        self._read()

    def _read(self):
        text = self.text
        self.position = _BLANK.match(text).end()
        while self.position < len(text):
            command = text[self.position]
            if command.upper() not in _COUNTS or (not self.before and command.upper() != "M"):
                self.error = self.position
                return
            self.position = _BLANK.match(text, self.position + 1).end()
            if not self._draw(command):
                return
            self.position = _BLANK.match(text, self.position).end()

    def _draw(self, command: str) -> bool:
        """One command letter with all its arguments; False where they are in error."""
        count = _COUNTS[command.upper()]
        if count == 0:
            self._close()
            return True
        drawn = 0
        while True:
            start = self.position
            numbers = self._numbers(count)
            if numbers is None:
                rest = self.text[start : start + 1]
                if drawn and (not rest or rest.upper() in _COUNTS):
                    return True
                self.error = start
                return False
            self._segment(command, numbers)
            drawn += 1
            command = {"M": "L", "m": "l"}.get(command, command)

    def _numbers(self, count: int) -> list[float] | None:
        """The next ``count`` numbers; None, and the position as it was, where there are fewer."""
        found, position = [], self.position
        for k in range(count):
            if count == 7 and k in _FLAGS:
                flag = self.text[position : position + 1]
                if flag not in ("0", "1") or not flag:
                    return None
                value, position = float(flag), position + 1
            else:
                match = _NUMBER.match(self.text, position)
                if match is None:
                    return None
                value, position = float(match[0]), match.end()
            if not math.isfinite(value):
                return None
            found.append(value)
            position = _GAP.match(self.text, position).end()
        self.position = position
        return found

    def _segment(self, command: str, numbers: list[float]):
        kind = command.upper()
        origin = self.here if command.islower() else complex(0)
        if kind == "A":
            end = complex(*numbers[5:]) + origin
            self._add(arc(self.here, end, *numbers[:5]))
            self.control = end
        elif kind in "HV":
            value = numbers[0]
            x = value + origin.real if kind == "H" else self.here.real
            y = value + origin.imag if kind == "V" else self.here.imag
            end = self.control = complex(x, y)
            self._add([_line(self.here, end)])
        else:
            points = [complex(*numbers[i : i + 2]) + origin for i in range(0, len(numbers), 2)]
            end = points[-1]
            _DRAW[kind](self, points)
        self.here, self.before = end, kind

    def _move(self, points):
        self.subpaths.append([])
        self.closed.append(False)
        self.first = self.control = points[0]

    def _line(self, points):
        self._add([_line(self.here, points[0])])
        self.control = points[0]

    def _cubic(self, points):
        self._add([_bezier(self.here, *points)])
        self.control = points[1]

    def _smooth_cubic(self, points):
        mirrored = 2 * self.here - self.control if self.before in "CS" else self.here
        self._cubic([mirrored, *points])

    def _quadratic(self, points):
        self._add([_bezier(self.here, *points)])
        self.control = points[0]

    def _smooth_quadratic(self, points):
        mirrored = 2 * self.here - self.control if self.before in "QT" else self.here
        self._quadratic([mirrored, *points])

    def _add(self, pieces):
        if self.before == "Z":  # a path goes on from where it was closed
            self._move([self.first])
        self.subpaths[-1] += pieces
        self.count += 1
        if self.count > MAX_PIECES:
            raise Refusal(
                "A path has more than {most} pieces, far more than a curve for a tube needs",
                cure="simplify it (Path > Simplify in Inkscape)", most=MAX_PIECES,
            )  # fmt: skip

    def _close(self):
        if self.here != self.first:
            self._add([_line(self.here, self.first)])
        self.closed[-1] = True
        self.here = self.control = self.first
        self.before = "Z"


_DRAW: dict[str, Callable] = {
    "M": PathData._move,
    "L": PathData._line,
    "C": PathData._cubic,
    "S": PathData._smooth_cubic,
    "Q": PathData._quadratic,
    "T": PathData._smooth_quadratic,
}


def arc(
    start: complex, end: complex, rx: float, ry: float, turned: float, large: float, sweep: float
) -> list[Piece]:
    """An elliptic arc by its ends: radii of any sign, scaled up where they do not reach.

    ``turned``: degrees of its first axis; ``large`` and ``sweep``: flags. A line where a radius is
    0, nothing where the ends coincide.
    """
    rx, ry = abs(rx), abs(ry)
    if start == end:
        return []
    if rx == 0 or ry == 0:
        return [_line(start, end)]
    axis = complex(math.cos(math.radians(turned)), math.sin(math.radians(turned)))
    half = (start - end) / 2 * axis.conjugate()
    x, y = half.real / rx, half.imag / ry
    reach = math.hypot(x, y)
    if reach >= 1:
        rx, ry, x, y = rx * reach, ry * reach, x / reach, y / reach
        reach = 1.0
    away = math.sqrt(max(0.0, 1 / reach**2 - 1)) * (-1 if bool(large) == bool(sweep) else 1)
    cx, cy = away * y, -away * x  # of the unit circle
    centre = complex(cx * rx, cy * ry) * axis + (start + end) / 2
    first = math.atan2(y - cy, x - cx)
    span = math.atan2(-y - cy, -x - cx) - first
    span = span % (2 * math.pi) if sweep else -(-span % (2 * math.pi))
    u, v = rx * axis, ry * axis * 1j
    return [Arc(_point(centre), _point(u), _point(v), first, first + span)]


def _point(z: complex) -> Array:
    return np.array([z.real, z.imag, 0.0])


def _line(a: complex, b: complex) -> Piece:
    return Line(_point(a), _point(b))


def _bezier(*points: complex) -> Piece:
    return bezier(np.array([(p.real, p.imag) for p in points]))
