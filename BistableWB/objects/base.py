# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all document objects of the workbench share: properties by table, saving, migration."""

from typing import Any, NamedTuple

import FreeCAD as App

from .. import hooks
from ..origami.errors import Refusal, as_data, from_data, name_of, phrase
from . import containers, links
from .refused import Refused, tracebacks_again

OUTPUT = 8  # property attribute: setting it does not touch the object
READ_ONLY = 1
HIDDEN = 4
MOST = 1e8  # mm, ° …: no number that a tube is made by is larger
VERSION = 1  # of the set of properties; raise it with a step in `BistableObject.migrate`


class Prop(NamedTuple):
    """One property: FreeCAD type (without App::Property), name, group, tooltip, default.

    ``default`` of an Enumeration is the list of its values; the first is chosen. ``older``: the
    value in files from before there was the property, where the default would change what they
    hold.
    """

    kind: str
    name: str
    group: str
    tip: str
    default: Any = None
    older: Any = None


class Result(Prop):
    """A read-only output property: expressions and macros may read it, nothing writes it."""


class OfShape(Result):
    """A result that tells of the Shape, which a refused object keeps: it keeps it too."""


class Hidden(OfShape):
    """A result that is only for us: it is saved, and nobody is shown it."""


def default_of(proxy_class, name):
    """What a new object has for the property ``name``."""
    (value,) = (prop.default for prop in proxy_class.PROPERTIES if prop.name == name)
    return value[0] if isinstance(value, list | tuple) else value


class BistableObject:
    """Base of the proxies. Subclasses give ``Type``, ``PROPERTIES`` and ``generate(obj)``."""

    Type = ""
    PROPERTIES: tuple = ()
    _design = None
    _is_made = False  # since it was opened or copied
    _completed = True  # but while missing properties are added
    _freed = ()  # links that are just being set to something else, not because of a deletion
    refusal: Refusal | None = None  # of the last recompute
    warnings: tuple = ()  # phrases of the last recompute

    def __init__(self, obj):
        obj.Proxy = self
        self.ensure_properties(obj)

    def ensure_properties(self, obj):
        """Add what is missing of the table of properties; never change what is there."""
        present = obj.PropertiesList
        is_older = "BistableVersion" in present
        self._completed = False
        for prop in self.PROPERTIES:
            if prop.name not in present:
                attributes = OUTPUT | READ_ONLY if isinstance(prop, Result) else 0
                attributes |= HIDDEN if isinstance(prop, Hidden) else 0
                obj.addProperty(
                    f"App::Property{prop.kind}", prop.name, prop.group, prop.tip, attributes
                )
                if prop.default is not None:
                    setattr(obj, prop.name, prop.default)
                if is_older and prop.older is not None:
                    setattr(obj, prop.name, prop.older)
        if links.REMEMBERED not in present:
            tip = "Links that were set: one that is gone is said, not taken for a choice"
            obj.addProperty("App::PropertyStringList", links.REMEMBERED, "Base", tip,
                            OUTPUT | HIDDEN | READ_ONLY)  # fmt: skip
            for name in links.link_names(self):
                links.remember(obj, name)
        for name, kind, value in (
            ("BistableType", "String", self.Type),
            ("BistableVersion", "Integer", VERSION),
        ):
            if name not in present:
                tip = "Lets Repair restore the object when the workbench was missing"
                obj.addProperty(f"App::Property{kind}", name, "Base", tip, HIDDEN | READ_ONLY)
                setattr(obj, name, value)
        self._completed = True

    def onDocumentRestored(self, obj):
        """Migrate step by step, then add what newer versions added."""
        found = getattr(obj, "BistableVersion", 0)
        self.migrate(obj, found)
        self.ensure_properties(obj)
        if found > VERSION:
            _say_newer(obj)
        else:
            obj.BistableVersion = VERSION
        containers.watch()
        if App.GuiUp and hooks.views:  # the file may have been made without a window
            hooks.views().attach_missing(obj)

    def migrate(self, obj, version):
        """Bring an object of an older ``version`` up to date. Nothing to do since version 1."""

    def ready(self, obj):
        """Whether ``obj`` has all its properties and is not being restored from a file."""
        has_all = self._completed and "BistableVersion" in obj.PropertiesList
        return has_all and "Restore" not in obj.State

    def onBeforeChange(self, obj, name):
        """Note when a link is set to something else, other than because its target is deleted."""
        if name in links.link_names(self) and self.ready(obj):
            self._freed = (name,) if links.may_be_freed(obj, name) else ()

    def onChanged(self, obj, name):
        """Remember which links were set."""
        if name in links.link_names(self) and self.ready(obj):
            links.remember(obj, name, name in self._freed)
            self._freed = ()

    def following(self, obj):
        """Names of the inputs that other inputs of ``obj`` carry along, as nobody has set them."""
        return set()

    def mustExecute(self, obj):
        """FreeCAD asks: a copy may stand in another Part than what it was copied of."""
        return not self._is_made and self.ready(obj) and containers.stands_apart(obj)

    def execute(self, obj):
        """Recompute: make Shape and results, or keep the `Refusal` that `generate` raises.

        FreeCAD keeps the sentence only, in the user's language: see `refusal_of`.
        """
        tracebacks_again()
        self.refusal, self._is_made = None, True
        try:
            refuse_enormous(obj)
            self.generate(obj)
        except Refusal as refusal:
            self.refusal = refusal
            clear_results(obj)
            for above in links.made_of(obj):  # FreeCAD leaves them, and calls what they were valid
                above.touch()
            raise Refused(_in_words(refusal)) from None

    def held(self, design):
        """The equal design that this proxy holds, with what it remembers; else this one, held.

        Designs (`origami.design`) are made anew from properties whenever somebody asks.
        """
        if self._design != design:
            self._design = design
        return self._design

    def generate(self, obj):
        """Make Shape and results of ``obj``; `Refusal` where that cannot be."""
        raise NotImplementedError

    def dumps(self):
        """What a file keeps besides the properties: the warnings as data, for another language."""
        return {"warnings": [as_data(one) for one in self.warnings]} if self.warnings else None

    def loads(self, state):
        """See `dumps`; files of 0.1.0 have nothing."""
        if isinstance(state, dict):
            self.warnings = tuple(map(from_data, state.get("warnings", ())))

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


def refuse_enormous(obj):
    """`Refusal` where a number that ``obj`` is made by is none, or beyond any place on a map."""
    for prop in obj.Proxy.PROPERTIES:
        value = None if isinstance(prop, Result) else getattr(obj, prop.name)
        value = getattr(value, "Value", value)
        if isinstance(value, float | App.Vector):
            numbers = [value] if isinstance(value, float) else list(value)
            worst = next((x for x in numbers if not abs(x) <= MOST), None)
            if worst is not None:
                raise Refusal(
                    "{name} is {value:.3g}",
                    cure="give {name} a number up to {most:.0e}",
                    parameter=prop.name,
                    name=name_of(prop.name),
                    value=worst,
                    most=MOST,
                )


def clear_results(obj):
    """Empty the results of an object that has none now: nobody takes old ones for true."""
    for prop in obj.Proxy.PROPERTIES:
        if isinstance(prop, Result) and not isinstance(prop, OfShape):
            value = getattr(obj, prop.name)
            empty = App.Vector() if isinstance(value, App.Vector) else prop.default
            if empty is None:
                empty = type(value)() if isinstance(value, list | str | bool | int) else 0.0
            set_result(obj, **{prop.name: empty})
    obj.Proxy.warnings = ()


def _say_newer(obj):
    """A file of a newer version: what it knows and we do not stays, and comes back there."""
    said = phrase(
        "{label} was saved by a newer version of the workbench: what is new there is kept, but "
        "not heeded here.",
        label=obj.Label,
    )
    App.Console.PrintWarning(f"{said}\n")


def set_warnings(obj, phrases):
    """Write the result Warnings; those that are new are said in the report view as well."""
    phrases = tuple(phrases)
    sentences = [str(one) for one in phrases]
    for sentence in sentences:
        if sentence not in obj.Warnings:
            App.Console.PrintWarning(f"{obj.Label}: {sentence}\n")
    set_result(obj, Warnings=sentences)
    obj.Proxy.warnings = phrases


def global_placement(obj):
    """Placement of a document object in the global frame, also inside Parts and groups."""
    if hasattr(obj, "getGlobalPlacement"):
        return obj.getGlobalPlacement()
    home = obj.getParentGeoFeatureGroup()  # an App::Link
    return global_placement(home) * obj.Placement if home is not None else obj.Placement


def frame_placement(obj):
    """Placement of the Parts that an object is in: its Placement, and its Shape, are seen there."""
    return global_placement(obj) * obj.Placement.inverse()


def require_link(obj, name, type_name, hint):
    """The object linked in property ``name``; `Refusal` where it is missing or of other type.

    Of an App::Link the object that it stands for.
    ``hint``: `Phrase`, what to link.
    """
    target = links.linked(obj, name)
    if target is None:
        raise Refusal(
            "{name} is empty: {hint}.",
            parameter=name,
            name=name_of(name),
            hint=hint,
        )
    real = links.followed(target)
    found = getattr(getattr(real, "Proxy", None), "Type", real.TypeId)
    if found != type_name:
        raise Refusal(
            "{name} links to {label} ({found}): {hint}.",
            parameter=name,
            name=name_of(name),
            label=target.Label,
            found=found,
            hint=hint,
        )
    return real


def make_object(doc, type_name, name, proxy_class):
    """A new Part::FeaturePython of our type, with its view provider where there is a GUI."""
    obj = doc.addObject("Part::FeaturePython", name)
    proxy_class(obj)
    containers.watch()
    if App.GuiUp and hooks.views:
        hooks.views().attach(obj.ViewObject, type_name)
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
    if App.GuiUp and hooks.views:
        return hooks.views().attach_missing(obj) or lost
    return lost


def _in_words(refusal):
    """A refusal as the tree, its tooltip and the report view say it: in the user's language."""
    words = hooks.words() if hooks.words else None
    return words.in_words(refusal) if words else str(refusal)
