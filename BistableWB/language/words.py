# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refusals, warnings and findings in the user's language.

Their templates are translated (the context `CONTEXT` of resources/translations); parameters and
choices are called what the panels call them. What else fills a template stays as it is.
"""

import FreeCAD as App

from ..origami.errors import Choice, Finding, Phrase, Refusal
from .labels import label_of, translated

CONTEXT = "BistableSentence"


def in_words(said):
    """A `Phrase`, `Refusal`, `Finding` or `Choice` in the user's language; else as it is."""
    if isinstance(said, Choice):
        return own_template(said)
    if isinstance(said, Phrase | Refusal | Finding):
        return said.in_words(own_template, name_of_parameter)
    return str(said)


def own_template(text):
    """A template, or a `Choice` as the panels have it, in the user's language."""
    if isinstance(text, Choice):
        return translated(str(text))
    return App.Qt.translate(CONTEXT, text)


def name_of_parameter(parameter):
    """What the panels call a property."""
    return translated(label_of(parameter))
