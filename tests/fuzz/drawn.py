# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random curves, numbers and texts, by a seeded generator."""

import math
import random

KINDS = ("bezier", "arc", "helix", "sphere", "loop", "wobble", "line", "knot", "doubled")
ODD_NUMBERS = (0.0, -1.0, 1e-9, 1e-3, 1e3, 1e7, 1e300, math.nan, math.inf, -math.inf)


def points_of(rng: random.Random) -> list[tuple[float, float, float]]:
    """Control points of a curve of some kind, now and then far away or degenerate."""
    kind, size, count = rng.choice(KINDS), 10 ** rng.uniform(1.3, 2.8), rng.randint(2, 14)
    made = {
        "bezier": lambda: [tuple(rng.uniform(-size, size) for _ in range(3)) for _ in range(count)],
        "arc": lambda: _along(count, lambda t: (size * math.cos(3 * t), size * math.sin(3 * t), 0)),
        "helix": lambda: _along(
            count, lambda t: (size * math.cos(6 * t), size * math.sin(6 * t), size * t)
        ),
        "sphere": lambda: (
            [(rng.uniform(-size, size), rng.uniform(-size, size), 0)] * 1
            + _along(count, lambda t: (size * t, size * math.sin(2 * t) / 3, 0))
        ),
        "loop": lambda: _closed(
            _along(count + 2, lambda t: (size * math.cos(6.2 * t), size * math.sin(6.2 * t), 0))
        ),
        "wobble": lambda: _along(
            count,
            lambda t: (2 * size * t, size * rng.uniform(-0.2, 0.2), 0.1 * size * rng.random()),
        ),
        "line": lambda: [(0, 0, 0), (size, size * rng.choice((0, 1)), 0)],
        "knot": lambda: [(0, 0, 0)] * rng.randint(1, 3) + [(size, 0, 0)],
        "doubled": lambda: [(0, 0, 0), (size, 0, 0), (size / 3, 0, 0), (size * 2, 0, 0)],
    }[kind]()
    away = rng.choice((0.0, 0.0, 0.0, 0.0, 5e5, 1e6))
    return [(x + away, y - away, z) for x, y, z in made]


def _along(count, function):
    return [function(k / (count - 1)) for k in range(max(count, 2))] if count > 1 else [(0, 0, 0)]


def _closed(points):
    return [*points[:-1], points[0]]


def number_near(rng: random.Random, value: float) -> float:
    """A number near the one that is there, or an odd one."""
    if rng.random() < 0.12:
        return rng.choice(ODD_NUMBERS)
    scale = abs(value) or rng.choice((1.0, 10.0))
    return value * 2 ** rng.uniform(-1.5, 1.5) + rng.choice((0, 0, 0.1, -0.1)) * scale


def mutated(rng: random.Random, content: bytes) -> bytes:
    """Bytes with some cut, doubled, swapped, or put in from elsewhere."""
    content = bytearray(content)
    for _ in range(rng.randint(1, 6)):
        if not content:
            break
        at, many = rng.randrange(len(content)), rng.randint(1, 40)
        how = rng.randrange(5)
        if how == 0:
            del content[at : at + many]
        elif how == 1:
            content[at:at] = content[at : at + many] * rng.randint(1, 30)
        elif how == 2:
            content[at] = rng.randrange(256)
        elif how == 3:
            content[at:at] = rng.choice((b"1e999", b"-", b"\r", b"\0", b"NaN", b"9" * 400, b"<a>"))
        else:
            other = rng.randrange(len(content))
            content[at : at + many] = content[other : other + many]
    return bytes(content)
