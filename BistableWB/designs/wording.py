# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refusals and findings in the words of a design file: keys for properties of the objects."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from ..origami.errors import Phrase
from .keys import SINGLE_UNIT, TABLES, TEST_PRINTS, key_of_property

if TYPE_CHECKING:
    from .reading import Design


@dataclass(frozen=True)
class _Keyed(Phrase):
    """A phrase whose parameters are always called by the keys of a design file."""

    key: Callable[[str], str] = str

    def in_words(self, translate: Callable[[str], str] = str, name: Any = None) -> str:
        """The sentence, by ``translate`` in the user's language."""
        return super().in_words(translate, self.key)


def keyed(design: "Design", table: str | None, said: Any) -> Phrase:
    """A `Phrase`, `Refusal` or `Finding` as a phrase, with keys of the file whoever says it.

    ``table``: what it is about, whose keys need no more than their name; None: no table.
    """
    return _Keyed("{said}", {"said": said}, key=_key_of(design, table))


def with_keys(design: "Design", table: str | None, said: Any) -> str:
    """What `keyed` says in English."""
    return str(keyed(design, table, said))


def _key_of(design: "Design", table: str | None) -> Callable[[str], str]:
    homes = [name for name in TABLES if name in _relevant(design)]
    homes = [table, *homes] if table else homes

    def key(parameter: str) -> str:
        for home in homes:
            found = key_of_property(home, parameter) or _namesake(home, parameter)
            single_only = home == "unit" and found in SINGLE_UNIT and "curve" in design.tables
            if found and not single_only:
                return found if home == table else f"[{home}] {found}"
        return parameter

    return key


def _namesake(table: str, parameter: Any) -> Any:
    """The key of a property that is not set as it is written, such as Source, or None."""
    return parameter.lower() if parameter.lower() in TABLES[table] else None


def _relevant(design: "Design") -> Any:
    """Tables whose keys may cure what an object of the design refuses."""
    if "curve" in design.tables:
        return {"curve", "triangles", "unit", "hinges"}
    return {"unit", "hinges"} if design.makes_unit else set(TEST_PRINTS)
