# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths, transforms and view boxes of SVG, as a browser reads them at 96 dots an inch."""

import math
import re

import numpy as np

from ..origami.errors import Refusal
from .pieces import Array

PIXEL = 25.4 / 96  # mm
_UNITS = {  # in pixels
    "": 1.0, "px": 1.0, "in": 96.0, "cm": 96 / 2.54, "mm": 96 / 25.4, "q": 96 / 101.6,
    "pt": 96 / 72, "pc": 16.0, "em": 16.0, "rem": 16.0, "ex": 8.0, "ch": 8.0,
}  # fmt: skip
_LENGTH = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*([a-z%]*)\s*", re.IGNORECASE)
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
_ANGLES = {"": 1.0, "deg": 1.0, "grad": 0.9, "rad": 180 / math.pi, "turn": 360.0}
_FUNCTION = re.compile(r"\s*,?\s*([a-zA-Z0-9]+)\s*\(([^()]*)\)\s*,?")
_PLACES = {"left": "0%", "top": "0%", "center": "50%", "right": "100%", "bottom": "100%"}


def length(text: str, whole: float, what: str) -> float:
    """A length in pixels; percentages are of ``whole``. ``what`` names it in a `Refusal`."""
    match = _LENGTH.fullmatch(text)
    unit = match[2].lower() if match else None
    if match is None or (unit != "%" and unit not in _UNITS):
        raise Refusal(
            "{what} is “{text}”, which is no length", what=what, text=text[:30],
            cure="give it a number with mm, cm, in, pt or px, with a point for its decimals",
        )  # fmt: skip
    value = float(match[1])
    if not math.isfinite(value):
        raise Refusal("{what} is “{text}”, which is no finite length", what=what, text=text[:30],
                      cure="correct it")  # fmt: skip
    return value * whole / 100 if unit == "%" else value * _UNITS[unit]


def unit_of(text: str) -> str:
    """The unit that a length is given in: "" where there is none."""
    match = _LENGTH.fullmatch(text)
    return match[2] if match else ""


def numbers(text: str) -> list[float]:
    """All numbers of a list as ``points`` and ``viewBox`` have it."""
    return [float(word) for word in _NUMBER.findall(text)]


def move(x: float, y: float) -> Array:
    """The matrix (4, 4) of a translation."""
    matrix = np.eye(4)
    matrix[:2, 3] = x, y
    return matrix


def _affine(a, b, c, d, e=0.0, f=0.0):
    matrix = np.eye(4)
    matrix[:2, :2] = [[a, c], [b, d]]
    matrix[:2, 3] = e, f
    return matrix


def transform(text: str, view: tuple[float, float], origin: str = "") -> Array:
    """The matrix (4, 4) of a ``transform`` attribute or property.

    ``view``: width and height that percentages are of; ``origin``: a ``transform-origin``.
    `Refusal` for what is no transform in the plane.
    """
    matrix, position = np.eye(4), 0
    if text.strip().lower() in ("", "none"):
        return matrix
    while position < len(text.rstrip()):
        match = _FUNCTION.match(text, position)
        if match is None:
            raise _strange(text)
        matrix = matrix @ _function(match[1], match[2], view, text)
        position = match.end()
    if origin:
        place = _place(origin, view)
        matrix = move(*place) @ matrix @ move(-place[0], -place[1])
    return matrix


def _strange(text):
    return Refusal(
        "The transform “{text}” is of no kind that SVG knows in a plane", text=text[:40],
        cure="apply or remove the transforms of the shape in the drawing program",
    )  # fmt: skip


def _function(name, arguments, view, text):
    words = re.findall(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*[a-zA-Z%]*", arguments)
    kind = name.lower()
    try:
        if kind in ("translate", "translatex", "translatey"):
            return _translation(kind, words, view)
        if kind in ("rotate", "skewx", "skewy"):
            return _turn(kind, words)
        values = [float(word) for word in words]
        if kind == "matrix" and len(values) == 6:
            return _affine(*values)
        if kind == "scale" and len(values) in (1, 2):
            return _affine(values[0], 0, 0, values[-1])
        if kind in ("scalex", "scaley") and len(values) == 1:
            return _affine(*((values[0], 0, 0, 1) if kind == "scalex" else (1, 0, 0, values[0])))
    except ValueError as error:
        raise _strange(text) from error
    raise _strange(text)


def _translation(kind, words, view):
    values = [length(word, view[k % 2], "A translation") for k, word in enumerate(words)]
    if kind == "translatey" and len(words) == 1:
        return move(0, length(words[0], view[1], "A translation"))
    if len(values) not in (1, 2) or (kind == "translatex" and len(values) != 1):
        raise ValueError
    return move(values[0], values[1] if len(values) == 2 else 0.0)


def _turn(kind, words):
    angle = math.radians(_angle(words[0])) if words else math.nan
    if kind == "rotate" and len(words) in (1, 3):
        turn = _affine(math.cos(angle), math.sin(angle), -math.sin(angle), math.cos(angle))
        if len(words) == 1:
            return turn
        x, y = float(words[1]), float(words[2])
        return move(x, y) @ turn @ move(-x, -y)
    if len(words) != 1:
        raise ValueError
    return (
        _affine(1, 0, math.tan(angle), 1) if kind == "skewx" else _affine(1, math.tan(angle), 0, 1)
    )


def _angle(word):
    match = _LENGTH.fullmatch(word)
    return float(match[1]) * _ANGLES[match[2].lower()] if match[2].lower() in _ANGLES else _no()


def _no():
    raise ValueError


def _place(text, view):
    words = [_PLACES.get(word, word) for word in text.lower().split()[:2]]
    if text.lower().split()[0] in ("top", "bottom"):
        words = words[::-1] if len(words) == 2 else ["50%", words[0]]
    words += ["50%"] * (2 - len(words))
    return tuple(length(w, v, "A transform-origin") for w, v in zip(words, view, strict=True))


def fitted(box: list[float], width: float, height: float, aspect: str) -> Array:
    """The matrix that puts a view box ``[x, y, width, height]`` into a viewport.

    ``aspect``: a ``preserveAspectRatio``.
    """
    x, y, w, h = box
    words = [word for word in aspect.split() if word != "defer"] or ["xMidYMid"]
    sx, sy = width / w, height / h
    if words[0] == "none":
        return _affine(sx, 0, 0, sy) @ move(-x, -y)
    scale = max(sx, sy) if "slice" in words else min(sx, sy)
    shares = {"Min": 0.0, "Mid": 0.5, "Max": 1.0}
    match = re.fullmatch(r"x(Min|Mid|Max)Y(Min|Mid|Max)", words[0])
    across, down = (shares[match[1]], shares[match[2]]) if match else (0.5, 0.5)
    place = move((width - w * scale) * across, (height - h * scale) * down)
    return place @ _affine(scale, 0, 0, scale) @ move(-x, -y)
