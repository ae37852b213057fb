# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps that make a tube printable, as data: each can be done, and is a line of a macro."""

from dataclasses import dataclass

import FreeCAD as App

from .. import make
from ..origami.errors import NOTHING, Phrase
from .gentler import follow_gentler

_LIKE = 1e-9


@dataclass(frozen=True)
class Make:
    """``variable`` is made by a function of `make` from the object of the variable ``of``."""

    variable: str
    function: str
    of: str

    def line(self) -> str:
        """For a macro."""
        return f"{self.variable} = make.{self.function}(doc, {self.of})"

    def do(self, doc, objects):
        """Add the new object to ``objects`` {variable: object}."""
        objects[self.variable] = getattr(make, self.function)(doc, objects[self.of])


@dataclass(frozen=True)
class MakeCurve:
    """``curve`` is made along ``edges`` (name of an object, names of its edges)."""

    edges: tuple

    def line(self) -> str:
        """For a macro."""
        name, names = self.edges
        return f'curve = make.make_curve(doc, source=(doc.getObject("{name}"), {list(names)!r}))'

    def do(self, doc, objects):
        """Add the new object to ``objects``."""
        name, names = self.edges
        objects["curve"] = make.make_curve(doc, source=(doc.getObject(name), list(names)))


@dataclass(frozen=True)
class Take:
    """``variable`` is the object ``name``, which is there."""

    variable: str
    name: str

    def line(self) -> str:
        """For a macro."""
        return f'{self.variable} = doc.getObject("{self.name}")'

    def do(self, doc, objects):
        """Add it to ``objects``."""
        objects[self.variable] = doc.getObject(self.name)


@dataclass(frozen=True)
class Remove:
    """The object ``name`` is not needed any more."""

    name: str

    def line(self) -> str:
        """For a macro."""
        return f'doc.removeObject("{self.name}")'

    def do(self, doc, objects):
        """Remove it."""
        doc.removeObject(self.name)


@dataclass(frozen=True)
class Follow:
    """The curve follows a gentler one, made so over a ``width`` (mm)."""

    width: float

    def line(self) -> str:
        """For a macro."""
        return f"fitting.follow_gentler(curve, {self.width!r})"

    def do(self, doc, objects):
        """Make the gentler curve."""
        follow_gentler(objects["curve"], self.width)


@dataclass(frozen=True)
class Set:
    """A property of ``variable`` is set to ``value``: a number, a text, True, three coordinates."""

    variable: str
    property: str
    value: object

    def line(self) -> str:
        """For a macro."""
        value = self.value
        shown = f"App.Vector{value!r}" if isinstance(value, tuple) else repr(value)
        return f"{self.variable}.{self.property} = {shown}"

    def do(self, doc, objects):
        """Set it."""
        value = App.Vector(*self.value) if isinstance(self.value, tuple) else self.value
        setattr(objects[self.variable], self.property, value)


@dataclass(frozen=True)
class Change:
    """A row of what is changed: ``label`` of the object, its ``property`` (or nothing), and why.

    ``before``: None where the object is new. The object's ``variable`` in a macro.
    """

    variable: str
    label: str
    property: str
    before: object
    after: object
    why: Phrase = NOTHING

    def __str__(self) -> str:
        was = "" if self.before is None else f"{shown(self.before)} → "
        why = f" ({self.why})" if self.why.template else ""
        return f"{self.label}: {self.property} {was}{shown(self.after)}{why}."


def plain(value):
    """A property's value as `Set` has it: a quantity as mm or degrees, a vector as a tuple."""
    if isinstance(value, App.Vector):
        return tuple(value)
    return getattr(value, "Value", value)


def same(one, other) -> bool:
    """Whether two plain values are the same, but for rounding."""
    if isinstance(one, tuple) and isinstance(other, tuple):
        return all(abs(a - b) < 1e-6 for a, b in zip(one, other, strict=True))
    if isinstance(other, float) and not isinstance(one, str | bool | tuple):
        return abs(one - other) <= _LIKE * max(abs(other), 1)
    return one == other


def shown(value) -> str:
    """A value as short text."""
    if isinstance(value, tuple):
        return "(" + ", ".join(f"{x:.4g}" for x in value) + ")"
    if isinstance(value, float):
        return f"{value:.4g}"
    return str(value)
