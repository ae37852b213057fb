# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values of a design file: a kind is a function that checks what stands there and returns it."""

import itertools
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from ..origami.errors import Phrase

MAX_POINTS = 200
MAX_LENGTH = 100_000.0  # mm
MIN_LENGTH = 0.1


class BadValue(Exception):
    """Why a value cannot be: a `Phrase`, ``said``, that follows the name of its key."""

    def __init__(self, template: Any, **pieces: Any) -> None:
        super().__init__(template)
        self.said = Phrase(template, pieces)


class Key(NamedTuple):
    """One key of a table; ``example`` is how it may be written."""

    kind: Any
    property: str
    example: str
    low: float = -math.inf
    high: float = math.inf
    choices: tuple = ()


_LARGEST = 10**300


def number(value: float, key: Key, what: str = "a number") -> float:
    """A finite number within the key's limits."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise BadValue(
            " is {value}; give it {what}, for example {example}",
            value=_shown(value),
            what=what,
            example=key.example,
        )
    if isinstance(value, int):
        value = max(min(value, _LARGEST), -_LARGEST)  # TOML has integers of any length
    if not math.isfinite(value):
        raise BadValue(
            " is {value}; give it a finite number, for example {example}",
            value=value,
            example=key.example,
        )
    if not key.low <= value <= key.high:
        raise BadValue(
            " is {value}; it must lie between {low:g} and {high:g}, for example {example}",
            value=_shown(value),
            low=key.low,
            high=key.high,
            example=key.example,
        )
    return float(value)


def length(value: float, key: Key) -> float:
    """A length in mm."""
    return number(value, key, "a length in mm as a number")


def angle(value: int, key: Key) -> float:
    """An angle in degrees."""
    return number(value, key, "an angle in degrees as a number")


def numbers(value: Any, key: Key) -> list[float]:
    """A list of numbers, maybe empty."""
    if not isinstance(value, list):
        raise BadValue(
            " is {value}; give it a list, for example {example}",
            value=_shown(value),
            example=key.example,
        )
    return [number(one, key) for one in value]


def whole(value: int, key: Key) -> int:
    """A whole number."""
    if isinstance(value, bool) or not isinstance(value, int):
        raise BadValue(
            " is {value}; give it a whole number, for example {example}",
            value=_shown(value),
            example=key.example,
        )
    return int(number(value, key))


def flag(value: bool, key: Key) -> bool:
    """True or false."""
    if not isinstance(value, bool):
        raise BadValue(
            " is {value}; set it to true or false",
            value=_shown(value),
        )
    return value


def text(value: str, key: Key) -> str:
    """A short text on one line."""
    if not isinstance(value, str) or not value.strip():
        raise BadValue(
            " is {value}; give it a text in quotes, for example {example}",
            value=_shown(value),
            example=key.example,
        )
    if len(value) > 400 or not value.isprintable():
        raise BadValue(
            " is too long or has characters that do not print; give it one short line",
        )
    return value.strip()


def choice(value: str, key: Key) -> str:
    """One of the key's choices, whatever the case of its letters."""
    for known in key.choices:
        if isinstance(value, str) and value.lower() == known.lower():
            return known
    raise BadValue(
        " is {value}; choose one of {names}",
        value=_shown(value),
        names=", ".join(key.choices),
    )


def choices(value: Sequence[str], key: Key) -> list[str]:
    """A list of the key's choices, each once, in the order of the table."""
    if not isinstance(value, list):
        raise BadValue(
            " is {value}; give it a list, for example {example}",
            value=_shown(value),
            example=key.example,
        )
    wanted = {choice(item, key) for item in value}
    return [known for known in key.choices if known in wanted]


def vector(value: Sequence[int], key: Key) -> list[float]:
    """Three coordinates in mm."""
    if not isinstance(value, list) or len(value) != 3:
        raise BadValue(
            " is {value}; give it three numbers in mm: {example}",
            value=_shown(value),
            example=key.example,
        )
    return [length(x, key) for x in value]


def points(value: Sequence[Sequence[float]], key: Key) -> list[list[float]]:
    """Control points: lists of two or three coordinates in mm."""
    if not isinstance(value, list) or len(value) < 2:
        raise BadValue(
            " is {value}; give it two or more points: {example}",
            value=_shown(value),
            example=key.example,
        )
    if len(value) > MAX_POINTS:
        raise BadValue(
            " has {count} control points; a Bézier curve is steered by a few, give it "
            "{most} at most",
            count=len(value),
            most=MAX_POINTS,
        )
    found = []
    for index, point in enumerate(value, 1):
        if not isinstance(point, list) or len(point) not in (2, 3):
            raise BadValue(
                ", point {index}, is {point}; give it two or three numbers in mm, as in {example}",
                index=index,
                point=_shown(point),
                example=key.example,
            )
        try:
            coordinates = [length(x, key) for x in point]
        except BadValue as problem:
            raise BadValue(
                ", point {index}, has a coordinate that{problem}",
                index=index,
                problem=problem.said,
            ) from None
        found.append([*coordinates, 0.0][:3])
    for index, (one, two) in enumerate(itertools.pairwise(found), 1):
        if one == two:
            raise BadValue(
                ", points {index} and {following}, coincide; move or remove one",
                index=index,
                following=index + 1,
            )
    return found


def _shown(value: Any) -> Any:
    """A value as it may stand in a sentence: short, and with its type where that is the trouble."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return f"{value:g}"
    if isinstance(value, int):
        return f"{value}" if abs(value) < 10**12 else "a number of very many digits"
    if isinstance(value, str):
        return f'the text "{value[:30]}{"…" if len(value) > 30 else ""}"'
    if isinstance(value, list):
        return f"a list of {len(value)}" if value else "an empty list"
    return "a table" if isinstance(value, dict) else "a date or time"
