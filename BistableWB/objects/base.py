# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all document objects of the workbench share: properties by table, saving, migration."""

from typing import Any, NamedTuple

import FreeCAD as App

OUTPUT = 8  # property attribute: setting it does not touch the object
READ_ONLY = 1
HIDDEN = 4
VERSION = 1  # of the set of properties; raise it with a step in `BistableObject.migrate`


class Prop(NamedTuple):
    """One property: FreeCAD type (without App::Property), name, group, tooltip, default.

    ``default`` of an Enumeration is the list of its values; the first is chosen.
    """

    kind: str
    name: str
    group: str
    tip: str
    default: Any = None


class Result(Prop):
    """A read-only output property: expressions and macros may read it, nothing writes it."""


class BistableObject:
    """Base of the proxies. Subclasses give ``Type``, ``PROPERTIES`` and ``generate(obj)``."""

    Type = ""
    PROPERTIES: tuple = ()

    def __init__(self, obj):
        obj.Proxy = self
        self.ensure_properties(obj)

    def ensure_properties(self, obj):
        """Add what is missing of the table of properties; never change what is there."""
        present = obj.PropertiesList
        for prop in self.PROPERTIES:
            if prop.name not in present:
                attributes = OUTPUT | READ_ONLY if isinstance(prop, Result) else 0
                obj.addProperty(
                    f"App::Property{prop.kind}", prop.name, prop.group, prop.tip, attributes
                )
                if prop.default is not None:
                    setattr(obj, prop.name, prop.default)
        for name, kind, value in (
            ("BistableType", "String", self.Type),
            ("BistableVersion", "Integer", VERSION),
        ):
            if name not in present:
                tip = "Lets Repair restore the object when the workbench was missing"
                obj.addProperty(f"App::Property{kind}", name, "Base", tip, HIDDEN | READ_ONLY)
                setattr(obj, name, value)

    def onDocumentRestored(self, obj):
        """Migrate step by step, then add what newer versions added."""
        self.migrate(obj, getattr(obj, "BistableVersion", 0))
        self.ensure_properties(obj)
        obj.BistableVersion = VERSION
        if App.GuiUp:  # the file may have been made without a window
            from ..viewproviders import attach_missing

            attach_missing(obj)

    def migrate(self, obj, version):
        """Bring an object of an older ``version`` up to date. Nothing to do since version 1."""

    @staticmethod
    def ready(obj):
        """Whether ``obj`` has all its properties and is not being restored from a file."""
        return "BistableVersion" in obj.PropertiesList and "Restore" not in obj.State

    def execute(self, obj):
        """Recompute: refuse what cannot be with a ValueError, else make Shape and results."""
        self.generate(obj)

    def generate(self, obj):
        """Make Shape and results of ``obj``; ValueError with one sentence for a designer."""
        raise NotImplementedError

    def dumps(self):
        """Nothing of the proxy is saved: everything lies in the properties."""
        return None

    def loads(self, state):
        """See `dumps`."""

    # FreeCAD 0.20 asks for these names.
    __getstate__ = dumps
    __setstate__ = loads


def set_result(obj, **values):
    """Write results, only those that changed (the same value would touch the object too)."""
    for name, value in values.items():
        if isinstance(value, float):
            value = float(value)
        if getattr(obj, name) != value:
            setattr(obj, name, value)


def set_warnings(obj, sentences):
    """Write the result Warnings; those that are new are said in the report view as well."""
    for sentence in sentences:
        if sentence not in obj.Warnings:
            App.Console.PrintWarning(f"{obj.Label}: {sentence}\n")
    set_result(obj, Warnings=list(sentences))


def global_placement(obj):
    """Placement of a document object in the global frame, also inside Parts and groups."""
    return obj.getGlobalPlacement() if hasattr(obj, "getGlobalPlacement") else obj.Placement


def frame_placement(obj):
    """Placement of the Parts that an object is in: its Placement, and its Shape, are seen there."""
    return global_placement(obj) * obj.Placement.inverse()


def require_link(obj, name, type_name, hint):
    """The object linked in property ``name``; ValueError where it is missing or of other type."""
    target = getattr(obj, name)
    if target is None:
        raise ValueError(f"{name} is empty: {hint}.")
    found = getattr(getattr(target, "Proxy", None), "Type", target.TypeId)
    if found != type_name:
        raise ValueError(f"{name} links to {target.Label} ({found}): {hint}.")
    return target


def make_object(doc, type_name, name, proxy_class):
    """A new Part::FeaturePython of our type, with its view provider where there is a GUI."""
    obj = doc.addObject("Part::FeaturePython", name)
    proxy_class(obj)
    if App.GuiUp:
        from ..viewproviders import attach

        attach(obj.ViewObject, type_name)
    return obj


def repair_object(obj, classes):
    """Give ``obj`` its proxy and view provider back; True if it needed that.

    ``classes(type name)`` → class of the proxy, None for objects that are not ours. FreeCAD loses
    the proxies of a file that is saved where the workbench is missing.
    """
    type_name = getattr(obj, "BistableType", "")
    kind = classes(type_name)
    if kind is None:
        return False
    lost = getattr(obj.Proxy, "Type", "") != type_name
    if lost:
        obj.Proxy = kind.__new__(kind)
        obj.Proxy.onDocumentRestored(obj)
        obj.touch()
    if App.GuiUp:
        from ..viewproviders import attach_missing

        return attach_missing(obj) or lost
    return lost
