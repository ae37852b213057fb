# SPDX-License-Identifier: LGPL-2.1-or-later
"""A comparison in words and as a table, for people: also where flat-folding loses."""

from typing import NamedTuple

from ..origami.errors import Phrase, joined, phrase

_SAME = 0.02  # share below which two numbers count as equal
_COLUMNS = (
    phrase("printed"),
    phrase("time"),
    phrase("model"),
    phrase("support"),
    phrase("on the bed"),
    phrase("height"),
    phrase("layers"),
    phrase("material changes"),
)

_RECKONED = phrase(
    "As PrusaSlicer reckons; soluble support, changes of the material take no time here."
)


class Section(NamedTuple):
    """A table with a title and a text above it: ``columns`` and ``rows`` of texts and phrases."""

    title: Phrase
    text: Phrase
    columns: tuple
    rows: list


def section(comparison):
    """`Section` of a `comparison.Comparison`."""
    rows = [_row(sliced) for sliced in comparison.prints]
    return Section(phrase("Flat-folded or deployed"), verdict(comparison), _COLUMNS, rows)


def verdict(comparison):
    """Sentences: in what the flat-folded print beats the quickest deployed one, and in what not."""
    flat, best = comparison.flat, comparison.deployed[0]
    told = [_against(comparison)]
    if not best.fits:
        told.append(phrase("Deployed it does not fit the printer."))
    if not flat.fits:
        told.append(phrase("The {name} print does not fit the printer.", name=flat.name))
    told.append(_RECKONED)
    return joined(told, " ")


def _against(comparison):
    flat, best = comparison.flat, comparison.deployed[0]
    wins, losses = [], []
    for compared, value, shown in _COMPARED:
        ours, theirs = value(flat), value(best)
        if abs(ours - theirs) > _SAME * max(ours, theirs):
            side = wins if ours < theirs else losses
            side.append(
                phrase("{compared} ({ours} against {theirs})", compared=compared,
                       ours=shown(ours), theirs=shown(theirs))
            )  # fmt: skip
    ways = len(comparison.deployed)
    other = (
        phrase("the deployed one")
        if ways == 1
        else phrase("the quickest of {ways} deployed ones", ways=ways)
    )
    return phrase(
        "Against {other}, the {name} print needs {needs}.",
        other=other,
        name=flat.name,
        needs=_needs(_listed(wins), _listed(losses)),
    )


def _needs(less, more):
    if not less and not more:
        return phrase("the same")
    if not more:
        return phrase("less {less}", less=less)
    if not less:
        return phrase("more {more}", more=more)
    return phrase("less {less}, and more {more}", less=less, more=more)


def duration(seconds):
    """Hours and minutes."""
    hours, minutes = divmod(round(seconds / 60), 60)
    return f"{hours} h {minutes:02d} min" if hours else f"{minutes} min"


def volume(cubic_millimetres):
    """Volume in cm³."""
    return f"{cubic_millimetres / 1000:.1f} cm³"


# What is compared in words: name, function of a `comparison.Sliced`, function that shows its value.
_COMPARED = (
    (phrase("time"), lambda p: p.seconds, duration),
    (phrase("model"), lambda p: p.model, volume),
    (phrase("support"), lambda p: p.support, volume),
    (phrase("area on the bed"), lambda p: p.footprint, lambda a: f"{a / 100:.0f} cm²"),
    (phrase("height"), lambda p: p.size[2], lambda h: f"{h:.0f} mm"),
)


def _row(sliced):
    width, depth, height = sliced.size
    return [
        sliced.name if sliced.fits else phrase("{name} (too large)", name=sliced.name),
        duration(sliced.seconds),
        volume(sliced.model),
        volume(sliced.support),
        f"{width:.0f} × {depth:.0f} mm",
        f"{height:.1f} mm",
        str(sliced.layers),
        str(sliced.changes),
    ]


def _listed(items):
    if len(items) < 2:
        return items[0] if items else None
    return phrase("{several} and {last}", several=joined(items[:-1], ", "), last=items[-1])
