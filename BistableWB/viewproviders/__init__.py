# SPDX-License-Identifier: LGPL-2.1-or-later
"""View providers: icon, place in the tree and colours of the document objects.

Importing this package must stay cheap: FreeCAD does so while it opens a file of ours.
"""

import contextlib
import importlib

from ..objects import TYPES, Type

_PLAIN = Type("", "").view


def attach(view_object, type_name):
    """Give the view object of a new document object of ours its view provider; returns it."""
    module, name = TYPES[type_name].view if type_name in TYPES else _PLAIN
    view_class = getattr(importlib.import_module(f"{__name__}.{module}"), name)
    return view_class(view_object)


def attach_missing(obj):
    """`attach` where there is none: an object saved without a window. True if it was needed."""
    from .base import BistableView

    view_object = obj.ViewObject
    if view_object is None or isinstance(view_object.Proxy, BistableView):  # FreeCAD: 1 for none
        return False
    attach(view_object, obj.BistableType)
    view_object.Proxy.refresh(obj)
    _show_soon(obj)
    return True


def _show_soon(obj):
    """FreeCAD 1.x hides what it opens from a file made without a window; show it as if new.

    What has become thick is left hidden: its flat print lies in the same place.
    """
    from PySide import QtCore

    def show():
        with contextlib.suppress(ReferenceError):  # closed in the meantime
            above = (getattr(other, "BistableType", "") for other in obj.InListRecursive)
            obj.ViewObject.Visibility = "Bistable::HingeSet" not in above

    QtCore.QTimer.singleShot(0, show)
