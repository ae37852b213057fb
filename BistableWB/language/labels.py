# SPDX-License-Identifier: LGPL-2.1-or-later
"""What panels say about properties: labels, values and results in the user's language."""

import re

import FreeCAD as App

translate = App.Qt.translate
CONTEXT = "BistableProperty"  # of labels, tooltips, groups and choices from the property tables


def label_of(name):
    """English label of a property: "EdgeLength" → "Edge length"."""
    words = re.findall(r"[A-Z]+(?![a-z])|[A-Z][a-z']*|\d+", name)
    return " ".join(
        [words[0], *(w if w.isupper() and len(w) > 1 else w.lower() for w in words[1:])]
    )


def translated(text):
    """A label, tooltip, group or choice of the tables in the user's language."""
    return translate(CONTEXT, text) if text else ""


def value_text(value):
    """A result as short text: numbers with their unit, long lists by their range."""
    if isinstance(value, bool):
        return translate("BistablePanel", "yes") if value else translate("BistablePanel", "no")
    if isinstance(value, float):
        return f"{value:.4g}"
    if hasattr(value, "UserString"):
        return value.UserString
    if hasattr(value, "Length"):  # a vector
        return " × ".join(f"{x:.4g}" for x in value)
    if isinstance(value, list | tuple):
        return _list_text(list(value))
    return str(value)


def _list_text(values):
    if not values:
        return "–"
    if isinstance(values[0], str):
        shown = [f"• {text}" for text in values[:6]]
        if len(values) > 6:
            shown.append(translate("BistablePanel", "… and {} more").format(len(values) - 6))
        return "\n".join(shown)
    low, high = min(values), max(values)
    return f"{low:.4g} … {high:.4g}" if high - low > 1e-9 * abs(high) else f"{low:.4g}"
