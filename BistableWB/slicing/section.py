# SPDX-License-Identifier: LGPL-2.1-or-later
"""A comparison in words and as a table, for people: also where flat-folding loses."""

from typing import NamedTuple

_SAME = 0.02  # share below which two numbers count as equal
_COLUMNS = (
    "printed",
    "time",
    "model",
    "support",
    "on the bed",
    "height",
    "layers",
    "material changes",
)


class Section(NamedTuple):
    """A table with a title and a text above it: ``columns`` and ``rows`` of text."""

    title: str
    text: str
    columns: tuple
    rows: list


def section(comparison):
    """`Section` of a `comparison.Comparison`."""
    rows = [_row(sliced) for sliced in comparison.prints]
    return Section("Flat-folded or deployed", verdict(comparison), _COLUMNS, rows)


def verdict(comparison):
    """Sentences: in what the flat-folded print beats the quickest deployed one, and in what not."""
    flat, best = comparison.flat, comparison.deployed[0]
    wins, losses = [], []
    for name, value, shown in _COMPARED:
        ours, theirs = value(flat), value(best)
        if abs(ours - theirs) > _SAME * max(ours, theirs):
            side = wins if ours < theirs else losses
            side.append(f"{name} ({shown(ours)} against {shown(theirs)})")
    ways = len(comparison.deployed)
    against = "the deployed one" if ways == 1 else f"the quickest of {ways} deployed ones"
    text = f"Against {against}, the {flat.name} print needs"
    parts = [f"{word} {_listed(side)}" for word, side in (("less", wins), ("more", losses)) if side]
    text = f"{text} {', and '.join(parts) or 'the same'}."
    if not best.fits:
        text += " Deployed it does not fit the printer."
    if not flat.fits:
        text += f" The {flat.name} print does not fit the printer."
    return (
        f"{text} As PrusaSlicer reckons; soluble support, changes of the material take no time "
        "here."
    )


def duration(seconds):
    """Hours and minutes."""
    hours, minutes = divmod(round(seconds / 60), 60)
    return f"{hours} h {minutes:02d} min" if hours else f"{minutes} min"


def volume(cubic_millimetres):
    """Volume in cm³."""
    return f"{cubic_millimetres / 1000:.1f} cm³"


# What is compared in words: name, function of a `comparison.Sliced`, function that shows its value.
_COMPARED = (
    ("time", lambda p: p.seconds, duration),
    ("model", lambda p: p.model, volume),
    ("support", lambda p: p.support, volume),
    ("area on the bed", lambda p: p.footprint, lambda a: f"{a / 100:.0f} cm²"),
    ("height", lambda p: p.size[2], lambda h: f"{h:.0f} mm"),
)


def _row(sliced):
    width, depth, height = sliced.size
    return [
        sliced.name if sliced.fits else f"{sliced.name} (too large)",
        duration(sliced.seconds),
        volume(sliced.model),
        volume(sliced.support),
        f"{width:.0f} × {depth:.0f} mm",
        f"{height:.1f} mm",
        str(sliced.layers),
        str(sliced.changes),
    ]


def _listed(items):
    return items[0] if len(items) == 1 else f"{', '.join(items[:-1])} and {items[-1]}"
