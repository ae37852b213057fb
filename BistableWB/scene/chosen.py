# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a command works on: the selection, else the obvious object of the document.

The questions that `IsActive` asks are asked many times a second: they never list faces or edges.
"""

import FreeCAD as App
import FreeCADGui as Gui

from ..objects import type_of


def of_type(type_name):
    """Object of ``type_name``: selected, or an input of what is selected, else the newest.

    None where there is none, or where the selection is the start of another one.
    """
    selection = Gui.Selection.getSelection()
    ours = [obj for obj in selection if type_of(obj).startswith("Bistable::")]
    for obj in ours:
        for candidate in (obj, *obj.OutListRecursive):
            if type_of(candidate) == type_name:
                return candidate
    return None if ours or edges() else newest(type_name)


def made_from_selection(type_name):
    """An object of ``type_name`` that is made from what is selected, else None."""
    for obj in Gui.Selection.getSelection():
        for candidate in obj.InListRecursive if type_of(obj).startswith("Bistable::") else ():
            if type_of(candidate) == type_name:
                return candidate
    return None


def newest(type_name):
    """The newest object of ``type_name`` in the active document, else None."""
    doc = App.ActiveDocument
    for obj in reversed(doc.findObjects("Part::FeaturePython") if doc else ()):
        if type_of(obj) == type_name:
            return obj
    return None


def edges():
    """First selected thing that a Curve can follow, as (object, names of edges), else None.

    Selected edges count; else a selected object of edges only, such as a sketch, a wire or a
    Draft curve. What this workbench made does not count.
    """
    for picked in Gui.Selection.getSelectionEx():
        shape = getattr(picked.Object, "Shape", None)
        if shape is None or type_of(picked.Object).startswith("Bistable::"):
            continue
        names = [name for name in picked.SubElementNames if name.startswith("Edge")]
        if names:
            return picked.Object, names
        if shape.countElement("Edge") and not shape.countElement("Face"):
            return picked.Object, [""]
    return None


def sphere():
    """Radius and centre of the first spherical face of a selected object, else None."""
    for picked in Gui.Selection.getSelectionEx():
        for face in getattr(getattr(picked.Object, "Shape", None), "Faces", ()):
            if face.Surface.TypeId == "Part::GeomSphere":
                return face.Surface.Radius, face.Surface.Center
    return None
