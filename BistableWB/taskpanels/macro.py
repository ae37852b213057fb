# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a panel changed, as lines that a macro keeps and that replay without a window."""

import FreeCADGui as Gui

from ..objects.base import Result


def inputs_of(obj):
    """{name: (literal, follows)} of an object's inputs; formulas are left out.

    ``literal``: the value as a Python expression; ``follows``: whether another input carries it
    along, as nobody has set it.
    """
    formulas = {path.lstrip(".") for path, _ in obj.ExpressionEngine}
    following = obj.Proxy.following(obj)
    return {
        prop.name: (literal(getattr(obj, prop.name)), prop.name in following)
        for prop in obj.Proxy.PROPERTIES
        if not isinstance(prop, Result) and prop.name not in formulas
    }


def record_changes(obj, before):
    """Run, and record, the lines that take the inputs from ``before`` to what they are now."""
    changed = {}
    for name, (text, follows) in inputs_of(obj).items():
        old, followed = before.get(name, (None, False))
        if old != text and not (followed and follows):  # else the replay carries it along too
            changed[name] = text
    if changed:
        Gui.doCommand(f'doc = App.getDocument("{obj.Document.Name}")')
    for name, text in changed.items():
        Gui.doCommand(f"doc.{obj.Name}.{name} = {text}")


def literal(value):
    """A Python expression for the value of a property; ``doc`` is its document."""
    if hasattr(value, "Unit"):
        return repr(value.Value)
    if hasattr(value, "PropertiesList"):
        return f'doc.getObject("{value.Name}")'
    if hasattr(value, "Length"):
        return f"App.Vector({value.x!r}, {value.y!r}, {value.z!r})"
    if isinstance(value, list | tuple):
        inner = ", ".join(map(literal, value))
        return f"({inner})" if isinstance(value, tuple) else f"[{inner}]"
    return repr(value)
