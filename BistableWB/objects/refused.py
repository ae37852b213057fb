# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a document object is refused: FreeCAD marks it, and says one line, no traceback.

FreeCAD marks an object as invalid only where its ``execute`` raises, and writes whatever traceback
that has into the report view before the sentence (0.20.2, 1.0.0 and 1.1.3 alike). A refusal is no
mistake of the program, so its traceback is held back: Python prints none while
``sys.tracebacklimit`` is 0, and the limit is lifted as soon as FreeCAD lets the exception go.
"""

import contextlib
import sys

from ..origami.errors import Refusal, verbatim


class _Named(type):
    """FreeCAD writes the name of an exception's class before its text."""

    def __str__(cls):
        return "Refused"


class Refused(ValueError, metaclass=_Named):
    """What ``execute`` raises for a `origami.errors.Refusal`: its sentence, without traceback."""

    def __init__(self, sentence):
        super().__init__(sentence)
        sys.tracebacklimit = 0

    def __del__(self):
        tracebacks_again()


def tracebacks_again():
    """Let Python print tracebacks."""
    with contextlib.suppress(AttributeError):
        del sys.tracebacklimit


def warnings_of(obj):
    """Phrases of the result Warnings; word by word where the proxy has not kept them."""
    kept = obj.Proxy.warnings
    said = obj.Warnings
    return kept if [str(one) for one in kept] == said else [verbatim(text) for text in said]


def refusal_of(obj):
    """Why ``obj`` is invalid, a `Refusal`; None where it is valid.

    What is no refusal of ours, a mistake of the program or of FreeCAD, is told word by word.
    """
    if obj.isValid():
        return None
    kept = getattr(getattr(obj, "Proxy", None), "refusal", None)
    return kept or Refusal("{text}", text=obj.getStatusString())
