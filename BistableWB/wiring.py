# SPDX-License-Identifier: LGPL-2.1-or-later
"""Joins parts that must not know each other, once, when FreeCAD starts with a window (InitGui.py).

Objects get their view providers, and view providers their panels, by `hooks`. Nothing is imported
before it is asked for: FreeCAD starts as fast as without the workbench.
"""

from . import hooks


def join():
    """Give the hooks their other ends."""
    hooks.views, hooks.panels, hooks.words = _views, _panels, _words


def _views():
    from . import viewproviders

    return viewproviders


def _panels():
    from .taskpanels import base

    return base


def _words():
    from .language import words

    return words
