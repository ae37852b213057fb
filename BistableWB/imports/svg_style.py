# SPDX-License-Identifier: LGPL-2.1-or-later
"""As much of CSS as says where a shape of an SVG lies and whether it is seen."""

import re
from typing import NamedTuple

from ..origami.errors import Refusal

_MOST_WORK = 300_000  # comparisons of an element with a rule
_BRACE = re.compile(r"[{}]")
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_PART = re.compile(r"([.#]?)([\w\-\u0080-\uffff]+)|(\*)")
_COMPOUND = re.compile(r"(?:[.#]?[\w\-\u0080-\uffff]+|\*)+")


class _Rule(NamedTuple):
    weight: tuple  # specificity and place in the file
    path: tuple  # compounds, the last one for the element itself; ">" between parent and child
    declarations: dict


class StyleSheet:
    """The rules of all ``<style>`` elements.

    Selectors are names, classes, ids and ``*``, with descendants and children; rules with others
    (states, attributes) and those for other media are left out.
    """

    def __init__(self, texts: list[str]):
        self.rules: list[_Rule] = []
        for text in texts:
            self._read(_COMMENT.sub(" ", text))
        self.rules.sort(key=lambda rule: rule.weight)
        self._likely: dict = {}
        self._work = 0

    def _read(self, text: str):
        for selectors, block in _blocks(text):
            found = declarations(block)
            for selector in selectors.split(","):
                path = _path(selector)
                if path and found:
                    weight = (*_specificity(path), len(self.rules))
                    self.rules.append(_Rule(weight, path, found))

    def of(self, element: "Styled") -> dict[str, str]:
        """Declarations for an element, the strongest last."""
        if not self.rules:
            return {}
        key = element.name, element.id, element.classes
        if key not in self._likely:
            self._spend(len(self.rules))
            self._likely[key] = [rule for rule in self.rules if _fits(rule.path[-1], element)]
        found: dict[str, str] = {}
        self._spend(len(self._likely[key]))
        for rule in self._likely[key]:
            if _matches(rule.path, element, set()):
                found |= rule.declarations
        return found

    def _spend(self, count):
        self._work += count
        if self._work > _MOST_WORK:
            raise Refusal("The style sheet of the drawing has far too many rules",
                          cure="export it again with plain attributes instead of CSS")  # fmt: skip


class Styled(NamedTuple):
    """What selectors see of an element: its name, id, classes, and its parent (or None)."""

    name: str
    id: str
    classes: frozenset
    parent: "Styled | None"


def declarations(text: str) -> dict[str, str]:
    """``{property: value}`` of a ``style`` attribute or a block, in small letters and trimmed."""
    found = {}
    for part in text.split(";"):
        name, colon, value = part.partition(":")
        if colon:
            found[name.strip().lower()] = value.replace("!important", "").strip()
    return found


def _blocks(text):
    """(selectors, block) of a style sheet; of at-rules only ``@media`` for all or screens."""
    position = 0
    while True:
        start = text.find("{", position)
        if start < 0:
            return
        head = text[position:start].rpartition(";")[2].strip()
        end = _end_of_block(text, start)
        if head.startswith("@"):
            if re.fullmatch(r"@media\s+(all|screen|only screen)", head):
                yield from _blocks(text[start + 1 : end])
        else:
            yield head.replace("<!--", "").replace("-->", ""), text[start + 1 : end]
        position = end + 1


def _end_of_block(text, start):
    depth = 0
    for match in _BRACE.finditer(text, start):
        depth += 1 if match[0] == "{" else -1
        if depth == 0:
            return match.start()
    return len(text)


def _path(selector):
    """Compounds and ">" of a selector; empty where it is of a kind that is not known."""
    words = selector.replace(">", " > ").split()
    known = all(word == ">" or _COMPOUND.fullmatch(word) for word in words)
    return tuple(words) if known and words and ">" not in (words[0], words[-1]) else ()


def _specificity(path):
    parts = [part for word in path if word != ">" for part in _PART.findall(word)]
    signs = [sign for sign, _, star in parts if not star]
    return signs.count("#"), signs.count("."), signs.count("")


def _matches(path, element, failed):
    """Whether a path of compounds ends at ``element``; ``failed`` spares trying a place twice."""
    key = len(path), id(element)
    if element is None or key in failed:
        return False
    failed.add(key)
    if not _fits(path[-1], element):
        return False
    rest = path[:-1]
    if not rest:
        return True
    if rest[-1] == ">":
        return _matches(rest[:-1], element.parent, failed)
    ancestor = element.parent
    while ancestor is not None:
        if _matches(rest, ancestor, failed):
            return True
        ancestor = ancestor.parent
    return False


def _fits(compound, element):
    for sign, name, star in _PART.findall(compound):
        if star:
            continue
        wanted = {"": element.name == name, "#": element.id == name, ".": name in element.classes}
        if not wanted[sign]:
            return False
    return True
