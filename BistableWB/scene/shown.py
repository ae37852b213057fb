# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which bodies of a print are in the view."""

from typing import NamedTuple


class Shown(NamedTuple):
    """One body in an object's shape: ``element`` is what can be selected; ``units`` from 1."""

    name: str
    element: str
    kind: str
    units: tuple


def bodies_shown(obj):
    """`Shown` of the bodies in an object's shape; flexures are there only when flat.

    Empty where names and shape do not belong together (while a file is being opened).
    """
    count = obj.Shape.countElement("Solid")
    known = list(zip(obj.BodyNames, obj.BodyKinds, obj.BodyUnits, strict=False))
    if len(known) != count:
        known = [entry for entry in known if entry[1] != "flexure"]
    if len(known) != count:
        return []
    return [
        Shown(name, f"Solid{k + 1}", kind, (unit, unit + 1) if kind == "block" else (unit,))
        for k, (name, kind, unit) in enumerate(known)
    ]
