# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences of errors, warnings and findings in the user's language.

The packages that write them know nothing of languages: their finished English sentence is matched
against the templates of resources/translations (see sentences.py there), and the translated
template is filled with the same pieces. What matches nothing stays as it is.
"""

import functools
import re
import xml.etree.ElementTree as ET

import FreeCAD as App

from .. import TRANSLATIONS

CONTEXT = "BistableSentence"
_FIELD = re.compile(r"(\{\d+\})")
_WEAK = 20  # letters; a template with fewer fits what others say too
_PHRASE = re.compile(r"[a-z]{2,} .*[a-z]{2,}")
_LIST = re.compile(r"; (?![^“]*”)")


def in_own_language(sentence):
    """``sentence``, or a phrase, in the user's language; as it is where there is no translation."""
    if not _is_translated():
        return sentence
    return _said(sentence) or sentence


def clean(status):
    """The sentence in an object's status string."""
    return re.sub(r"^<class '\w+'>:?\s*|^\w*Error:\s*", "", status).strip()


def finding_text(finding):
    """A `checks.findings.Finding` in words, in the user's language."""
    message, cure = (in_own_language(text) for text in (finding.message, finding.cure))
    return f"{message[:-1]}: {cure}." if cure else message


def _is_translated():
    """Whether there is a translation for the user's language; all templates have one then."""
    template = _templates()[0][1]
    return App.Qt.translate(CONTEXT, template) != template


def _said(sentence):
    """The translation of ``sentence``, or None."""
    for pattern, template, weak in _templates():
        match = pattern.fullmatch(sentence)
        if match:
            pieces = [_piece(piece, weak) for piece in match.groups()]
            if None not in pieces:
                return _filled(App.Qt.translate(CONTEXT, template), pieces)
    return None


def _piece(piece, weak):
    """What is filled in; None where it would leave an English phrase in a translated sentence."""
    said = _said(piece)
    if said is None and "; " in piece:
        parts = [_said(part) for part in _LIST.split(piece)]
        said = None if None in parts else "; ".join(parts)
    if said is None and not (weak and _PHRASE.search(piece)):
        said = piece
    return said


def _filled(template, pieces):
    return _FIELD.sub(lambda field: pieces[int(field[0][1:-1])], template)


@functools.cache
def _templates():
    """(pattern, template, whether it is weak) of all templates, those that say most first."""
    sources = sorted(_sources(), key=lambda text: (-_letters(text), text))
    tails = "|".join(_pattern(text, ".*?") for text in sources if text[0] in " ,;:")
    found = []
    for text in sources:
        pattern = _pattern(text, "(.*?)", f"({tails}|.*?)", f"({tails}|)")
        found.append((re.compile(pattern, re.DOTALL), text, _letters(text) < _WEAK))
    return found


def _pattern(text, field, after_word="", after_field=""):
    """A regular expression for ``text``, with ``field`` for what is filled in.

    What is filled in right after a word or after another field is often a phrase that continues
    it (" of unit 3") or nothing.
    """
    pieces = _FIELD.split(text)
    for k in range(1, len(pieces), 2):
        before = pieces[k - 1]
        if not before and k > 1:
            pieces[k] = after_field or field
        else:
            pieces[k] = (before[-1:].isalpha() and after_word) or field
    pieces[::2] = map(re.escape, pieces[::2])
    return "".join(pieces)


def _letters(text):
    return len(_FIELD.sub("", text))


def _sources():
    """The templates: every .ts file has them all."""
    path = next(TRANSLATIONS.glob("*.ts"))
    for context in ET.parse(path).getroot().iter("context"):
        if context.findtext("name") == CONTEXT:
            return [message.findtext("source") for message in context.iter("message")]
    raise ValueError(f"{path} has no {CONTEXT}: install the workbench again.")
