# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels: one for every type of object, made from its table of properties."""

import importlib

from ..objects import TYPES


def panel_for(obj):
    """A new panel that edits ``obj``; it opens an undo step."""
    module, name = TYPES[obj.BistableType].panel
    return getattr(importlib.import_module(f"{__name__}.{module}"), name)(obj)
