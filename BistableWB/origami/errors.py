# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refusals as data: a template and what fills it, the parameter to change, the unit, the cure.

A template is a sentence for a designer with fields in braces, as of ``str.format``. Fields in small
letters are filled with `pieces`; a field that starts with a capital names a parameter by its
property (``{EdgeLength}``), and whoever shows the sentence says what it is called there: a label
in a panel, a key in a design file. Templates are translated, never finished sentences; what fills
them (a label, a file's name) is never read as a template.
"""

import numbers
import string
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

NOTE, WARNING, ERROR = "note", "warning", "error"


def _same(text: str) -> str:
    return text


class _Fields(string.Formatter):
    """``str.format`` with names of parameters looked up, and values that are never templates."""

    def __init__(self, pieces: Mapping[str, Any], name: Callable[[str], str]) -> None:
        super().__init__()
        self.pieces, self.name = pieces, name

    def get_field(
        self, field_name: str, args: Sequence[Any], kwargs: Mapping[Any, Any]
    ) -> tuple[Any, str]:
        """The value of one field: no attribute or index of it can be asked for."""
        if field_name[:1].isupper():
            return self.name(field_name), field_name
        return self.pieces[field_name], field_name


class Choice(str):
    """A value of an enumeration as a piece: whoever shows it says what it is called there.

    English says the value itself. Not for a value that is unknown, which no panel offers.
    """


@dataclass(frozen=True)
class Phrase:
    """A template and what fills it: pieces may be phrases, refusals, findings, choices.

    ``sets``: of a cure, the (property, value) pairs that are all of it, for a button that does it.
    """

    template: str
    pieces: Mapping[str, Any] = field(default_factory=dict, hash=False)
    sets: tuple = field(default=(), compare=False)

    def setting(self, **values: Any) -> "Phrase":
        """The same cure, which is to give properties these values."""
        return replace(self, sets=tuple(values.items()))

    def in_words(
        self, translate: Callable[[str], str] = _same, name: Callable[[str], str] = _same
    ) -> str:
        """The sentence. ``translate(template)`` → template, ``name(property)`` → its name here.

        ``translate`` is given a `Choice` too, and tells by its type that it is one.
        """

        def said(piece: Any) -> Any:
            if isinstance(piece, Choice):
                return translate(piece)
            is_said = isinstance(piece, Phrase | Refusal | Finding)
            return piece.in_words(translate, name) if is_said else piece

        pieces = {key: said(piece) for key, piece in self.pieces.items()}
        template = translate(self.template) if self.template else ""
        return _Fields(pieces, name).vformat(template, (), {})

    def __str__(self) -> str:
        return self.in_words()

    @property
    def parameter(self) -> str:
        """The parameter that it names first, or ""."""
        fields = (field for _, field, _, _ in string.Formatter().parse(self.template) if field)
        return next((field for field in fields if field[:1].isupper()), "")


NOTHING = Phrase("")


def phrase(template: str, **pieces: Any) -> Phrase:
    """A `Phrase`."""
    return Phrase(template, pieces)


def name_of(parameter: str) -> Phrase:
    """The name of a parameter, to fill a template that many parameters share."""
    return Phrase(f"{{{parameter}}}")


def verbatim(text: object) -> Phrase:
    """What another program or an exception of another library says, as it is."""
    return Phrase("{text}", {"text": str(text)})


def joined(phrases: Iterable, separator: str = "; ") -> Phrase:
    """Phrases one after another, as one."""
    pieces = {f"p{k}": one for k, one in enumerate(phrases)}
    return Phrase(separator.join(f"{{{key}}}" for key in pieces), pieces)


def as_data(piece: Any) -> Any:
    """A phrase, or what fills one, as lists, dictionaries, texts and numbers for JSON."""
    if isinstance(piece, Refusal):
        return as_data(piece.message if piece.cure is NOTHING else verbatim(piece))
    if isinstance(piece, Phrase):
        return [piece.template, {key: as_data(one) for key, one in piece.pieces.items()}]
    if isinstance(piece, Choice):
        return {"choice": str(piece)}
    if isinstance(piece, numbers.Real):
        return int(piece) if isinstance(piece, numbers.Integral) else float(piece)
    return piece if piece is None else str(piece)


def from_data(data: Any) -> Any:
    """What `as_data` was made of."""
    if isinstance(data, list):
        template, pieces = data
        return Phrase(template, {key: from_data(one) for key, one in pieces.items()})
    return Choice(data["choice"]) if isinstance(data, dict) else data


class Refusal(ValueError):
    """What cannot be, as data; ``str()`` gives English.

    ``message``, ``cure``: `Phrase`, filled from the same pieces; ``parameter``: property to change
    ("" where there is none); ``unit``: counted from 1, or None; ``body``: its name, or "".
    """

    def __init__(
        self,
        template: str,
        *,
        cure: str = "",
        parameter: str = "",
        unit: int | None = None,
        body: str = "",
        **pieces: Any,
    ) -> None:
        filled = {**pieces, "unit": unit, "body": body}
        self.message = Phrase(template, filled)
        self.cure = Phrase(cure, filled) if cure else NOTHING
        self.parameter, self.unit, self.body = parameter, unit, body
        super().__init__(template)

    def in_words(
        self, translate: Callable[[str], str] = _same, name: Callable[[str], str] = _same
    ) -> str:
        """The sentence with its cure; arguments as of `Phrase.in_words`."""
        return sentence(self.message, self.cure, translate, name)

    def __str__(self) -> str:
        return self.in_words()


def message_of(error: Exception) -> Phrase:
    """What an exception says: a refusal's own words, or another library's, word by word."""
    if isinstance(error, Refusal):
        return Phrase("{refusal}", {"refusal": error})
    return verbatim(error)


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What a check found: plain data for a panel, a report and a test.

    ``severity``: `NOTE` (as it should be, worth knowing), `WARNING` or `ERROR`; ``code``: short
    fixed name of the check; ``bodies``: names of the bodies that it is about; ``unit``: counted
    from 1, or None; ``number`` was measured and ``limit`` asked for (mm unless the code says
    otherwise; None where there is none); ``message``: one sentence; ``cure``: what to change, a
    phrase without a full stop; ``points``: where in space, mm, in the state ``opening`` (0 flat …
    1 deployed), or on the bed as it is printed (None).
    """

    severity: str
    code: str
    message: Phrase
    cure: Phrase = NOTHING
    bodies: tuple = ()
    unit: int | None = None
    number: float | None = None
    limit: float | None = None
    points: tuple = ()
    opening: float | None = None

    @property
    def parameter(self) -> str:
        """The property that the cure changes, or ""."""
        return self.cure.parameter

    def in_words(
        self, translate: Callable[[str], str] = _same, name: Callable[[str], str] = _same
    ) -> str:
        """The sentence with its cure; arguments as of `Phrase.in_words`."""
        return sentence(self.message, self.cure, translate, name)

    def __str__(self) -> str:
        return self.in_words()


def sentence(
    message: Phrase,
    cure: Phrase = NOTHING,
    translate: Callable[[str], str] = _same,
    name: Callable[[str], str] = _same,
) -> str:
    """A message and its cure as one sentence: "What is wrong: what to change."."""
    said = message.in_words(translate, name)
    return f"{said.removesuffix('.')}: {cure.in_words(translate, name)}." if cure.template else said


def gathered(phrases: Iterable[Phrase]) -> list[Phrase]:
    """Phrases with a piece ``unit`` that say the same kind of thing, one for all units.

    The first of each kind stays whole; which other units it holds for is added.
    """
    kinds: dict = {}
    for one in phrases:
        kinds.setdefault(_kind(one), []).append(one)
    return [_with_units(same) for same in kinds.values()]


def _kind(piece: Phrase | float | str) -> Any:
    """What two phrases share that differ in numbers only."""
    if isinstance(piece, Phrase):
        return piece.template, tuple((k, _kind(p)) for k, p in sorted(piece.pieces.items()))
    return piece if isinstance(piece, str) else None


def _with_units(same: Sequence[Phrase]) -> Phrase:
    units: set[Any] = {one.pieces.get("unit") for one in same[1:]} - {None}
    if not units:
        return same[0]
    numbers = ", ".join(map(str, sorted(units)))
    return phrase(
        "{said} (Also units {units}.)" if len(units) > 1 else "{said} (Also unit {units}.)",
        said=same[0],
        units=numbers,
    )


def require(
    valid: NDArray | bool,
    message: str,
    value: Any = None,
    *more: NDArray | float,
    parameter: str = "",
    cure: str = "",
    **pieces: Any,
) -> None:
    """Raise a `Refusal` with ``message`` unless every entry of ``valid`` holds.

    ``message`` may use ``{value}`` (the offending entry of ``value``), the names of ``pieces`` (the
    same entry of each array; phrases as they are), ``{0}``, ``{1}`` … (the same entry of ``more``)
    and ``{at}``, which becomes " of unit k" (counted from 1) for arrays and nothing for scalars.
    """
    valid = np.asarray(valid)
    if valid.all():
        return
    index = np.unravel_index(int(np.argmin(valid)), valid.shape)

    def pick(array: Phrase | NDArray | float | None) -> Phrase | float | None:
        if array is None or isinstance(array, str | Phrase):
            return array
        return float(np.broadcast_to(array, valid.shape)[index])

    unit = int(index[0]) + 1 if valid.ndim else None
    at = phrase(" of unit {unit}", unit=unit) if unit else ""
    filled: dict[str, Any] = {str(k): pick(array) for k, array in enumerate(more)}
    filled |= {name: pick(piece) for name, piece in pieces.items()}
    raise Refusal(
        message, cure=cure, parameter=parameter, unit=unit, value=pick(value), at=at, **filled
    )
