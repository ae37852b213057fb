# SPDX-License-Identifier: LGPL-2.1-or-later
"""Task panels: one for every type of object, made from its table of properties."""

import importlib

# Type name -> (module, class). Any other type of ours gets the plain panel.
PANELS = {
    "Bistable::Curve": ("curve", "CurvePanel"),
    "Bistable::HingeSet": ("base", "HeavyPanel"),
}
_PLAIN = ("base", "ObjectPanel")


def panel_for(obj):
    """A new panel that edits ``obj``; it opens an undo step."""
    module, name = PANELS.get(obj.BistableType, _PLAIN)
    return getattr(importlib.import_module(f"{__name__}.{module}"), name)(obj)
