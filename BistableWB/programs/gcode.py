# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a slicer's G-code says: the lines of plastic that it lays, its time and its filament."""

import re
from array import array
from typing import NamedTuple

import numpy as np

from ..origami.errors import Refusal

# Kinds of lines (PrusaSlicer's ;TYPE: comments) that are no part of the model.
SUPPORT = ("Support material", "Support material interface")
AROUND = ("Skirt/Brim", "Skirt", "Brim", "Wipe tower", "Custom")
_HEAD = re.compile(r";(TYPE|WIDTH|HEIGHT|Z):(.*)")
_WORD = re.compile(r"([XYE])(-?[\d.]+)")
_TIME = re.compile(r"; estimated printing time \(normal mode\) = (.*)")
_USED = re.compile(r"; filament used \[cm3\] = (.*)")
_SECONDS = {"d": 86400, "h": 3600, "m": 60, "s": 1}


class Lines(NamedTuple):
    """Straight lines of extruded plastic, n of them, in the order in which they are laid.

    ``ends`` (n, 2, 2): start and end in the plan, mm; ``top`` (n,): height of the nozzle, at which
    the line's upper side lies, mm; ``width``, ``height`` (n,) mm; ``kind`` (n,): index into
    ``kinds``, the names that the slicer gives.
    """

    ends: np.ndarray
    top: np.ndarray
    width: np.ndarray
    height: np.ndarray
    kind: np.ndarray
    kinds: tuple

    @property
    def lengths(self):
        """Length of every line (n,), mm."""
        return np.linalg.norm(self.ends[:, 1] - self.ends[:, 0], axis=1)

    def of_model(self):
        """The lines that stay: without support, skirt and brim."""
        others = [k for k, name in enumerate(self.kinds) if name in SUPPORT + AROUND]
        return self.chosen(~np.isin(self.kind, others))

    def chosen(self, which):
        """The lines that ``which`` (mask or rows) names."""
        return Lines(*(column[which] for column in self[:-1]), self.kinds)


class Estimate(NamedTuple):
    """What the slicer reckons: ``seconds``; ``volumes`` of each extruder's filament, mm³."""

    seconds: float
    volumes: tuple
    layers: int
    tool_changes: int


def read(path):
    """(`Lines`, `Estimate`) of a G-code file of PrusaSlicer; ValueError if it is something else.

    A move with an X or Y and an E lays a line; lengths in mm (G21), coordinates absolute (G90).
    """
    with open(path, encoding="utf-8", errors="replace") as file:
        rows, kinds, layers, tools, tail = _walk(file)
    time, used = _TIME.search(tail), _USED.search(tail)
    if not rows or not time or not used:
        raise Refusal(
            "{path} has no lines or no printing time as PrusaSlicer writes them: slice with it.",
            path=path,
        )
    table = np.frombuffer(rows).reshape(-1, 8)
    lines = Lines(
        table[:, :4].reshape(-1, 2, 2), *table[:, 4:7].T, table[:, 7].astype(int), tuple(kinds)
    )
    volumes = tuple(1000 * float(number) for number in used[1].split(","))
    return lines, Estimate(_seconds(time[1]), volumes, layers, max(tools - 1, 0))


def _walk(file):
    """Rows (x, y, x, y, top, width, height, kind), kinds, counts of layers and tools, comments."""
    rows, kinds, tail = array("d"), {}, []  # a long print has millions of lines
    x = y = top = width = height = 0.0
    kind = layers = tools = 0
    for text in file:
        if text.startswith("G1 "):
            if "X" not in text and "Y" not in text:
                continue
            words = dict(_WORD.findall(text.split(";", 1)[0]))
            from_x, from_y = x, y
            x, y = float(words.get("X", x)), float(words.get("Y", y))
            if "E" in words and (x != from_x or y != from_y):
                rows.extend((from_x, from_y, x, y, top, width, height, kind))
        elif text.startswith(";"):
            head = _HEAD.match(text)
            if head is None:
                layers += text.startswith(";LAYER_CHANGE")
                if text.startswith(("; estimated", "; filament used")):
                    tail.append(text)
            elif head[1] == "TYPE":
                kind = kinds.setdefault(head[2].strip(), len(kinds))
            elif head[1] == "WIDTH":
                width = float(head[2])
            elif head[1] == "HEIGHT":
                height = float(head[2])
            else:
                top = float(head[2])
        elif re.match(r"T\d", text):
            tools += 1
    return rows, list(kinds), layers, tools, "".join(tail)


def _seconds(text):
    """Seconds of a time like "1d 2h 3m 4s"."""
    return float(sum(int(n) * _SECONDS[unit] for n, unit in re.findall(r"(\d+)([dhms])", text)))
