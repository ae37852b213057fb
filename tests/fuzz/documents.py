# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random documents: made, edited in any order, undone, saved, copied, and made anew to compare."""

import contextlib
import math
import random
import time
from pathlib import Path

import FreeCAD as App
import numpy as np

from BistableWB import make
from BistableWB.objects.base import Result
from tests.fuzz.drawn import number_near, points_of

TOO_LONG = 10.0  # s of the processor: an operation that takes longer hangs
_SAME = 1e-7  # of the size of a shape
OURS = "Bistable"


class Broken(AssertionError):
    """What no document may be."""


class Session:
    """One document and what is done to it; ``told`` counts what happened."""

    def __init__(self, seed: int, folder: Path):
        self.rng, self.folder, self.told = random.Random(seed), folder, {}
        self.did = ""  # last, for a report
        self.doc = App.newDocument(f"Fuzz{seed}")
        self.doc.UndoMode = 1
        self.file = ""

    def run(self) -> None:
        """Make, edit some times, compare; `Broken` where something is wrong."""
        try:
            self._timed("make", self._make)
            for _ in range(self.rng.randint(2, 7)):
                name = self.rng.choice(self.STEPS)
                self._timed(name, getattr(self, f"_{name}"))
                self._look(name)
            self._timed("made anew", self._anew)
        finally:
            App.closeDocument(self.doc.Name)

    STEPS = ("edit", "edit", "edit", "edit", "choose", "undo", "redo", "reopen", "copy", "delete",
             "move", "relink")  # fmt: skip

    def _timed(self, name, function):
        start = time.process_time()
        function()
        took = time.process_time() - start
        if took > TOO_LONG:
            raise Broken(f"{name} took {took:.0f} s: {self.did}")
        self.told[name] = self.told.get(name, 0) + 1

    def _make(self):
        rng, doc = self.rng, self.doc
        curve = make.make_curve(doc, points=points_of(rng))
        triangles = make.make_triangle_placement(
            doc, curve, edge_length=10 ** rng.uniform(1.2, 2), gamma=rng.uniform(2, 60)
        )
        unit = make.make_bistable_unit(doc, rng.choice((triangles, triangles, None)))
        if rng.random() < 0.12:
            hinges = make.make_hinge_set(doc, unit)
            hinges.LastUnit = rng.randint(1, 2)
        elif rng.random() < 0.05:
            make.make_hinge_coupon(doc)
        doc.recompute()

    def _ours(self):
        return [o for o in self.doc.Objects if type_of(o)]

    def _some(self):
        return self.rng.choice(self._ours() or [make.make_curve(self.doc)])

    def _edit(self):
        obj = self._some()
        names = [p.name for p in obj.Proxy.PROPERTIES if is_number(obj, p)]
        self.doc.openTransaction("Edit")
        if names and self.rng.random() < 0.85:
            name = self.rng.choice(names)
            value = getattr(obj, name)
            self._set(obj, name, number_near(self.rng, getattr(value, "Value", value)))
        elif hasattr(obj, "Points"):
            obj.Points = [App.Vector(*p) for p in points_of(self.rng)]
        self.doc.commitTransaction()
        self.doc.recompute()

    def _choose(self):
        obj = self._some()
        names = [p.name for p in obj.Proxy.PROPERTIES
                 if p.kind in ("Enumeration", "Bool") and not isinstance(p, Result)]  # fmt: skip
        self.doc.openTransaction("Choose")
        if names:
            name = self.rng.choice(names)
            options = obj.getEnumerationsOfProperty(name) or [True, False]
            self._set(obj, name, self.rng.choice(options))
        self.doc.commitTransaction()
        self.doc.recompute()

    def _set(self, obj, name, value):
        self.did = f"{name} of {type_of(obj)} = {value!r}, it was {getattr(obj, name)!r}"
        with contextlib.suppress(ValueError, TypeError, OverflowError):  # FreeCAD's own refusal
            setattr(obj, name, value)

    def _undo(self):
        self.doc.undo()
        self.doc.recompute()

    def _redo(self):
        self.doc.redo()
        self.doc.recompute()

    def _reopen(self):
        before = states(self.doc)
        self.file = self.file or str(self.folder / f"{self.doc.Name}.FCStd")
        self.doc.saveAs(self.file)
        App.closeDocument(self.doc.Name)
        self.doc = App.openDocument(self.file)
        self.doc.UndoMode = 1
        compare(before, states(self.doc), "after it was opened again")

    def _copy(self):
        obj = self._some()
        self.doc.copyObject(obj, self.rng.random() < 0.5)
        self.doc.recompute()

    def _delete(self):
        obj = self._some()
        self.doc.openTransaction("Delete")
        self.doc.removeObject(obj.Name)
        self.doc.commitTransaction()
        self.doc.recompute()

    def _move(self):
        rng = self.rng
        part = next((o for o in self.doc.Objects if o.TypeId == "App::Part"), None)
        part = part or self.doc.addObject("App::Part", "Part")
        obj = self._some()
        if obj.getParentGeoFeatureGroup() is None:
            part.addObject(obj)
        axis = App.Vector(rng.random(), rng.random(), 1)
        part.Placement = App.Placement(
            App.Vector(*(rng.uniform(-500, 500) for _ in range(3))),
            App.Rotation(axis, rng.uniform(0, 360)),
        )
        self.doc.recompute()

    def _relink(self):
        """A link to something, which may be of another type, itself, or what follows it."""
        obj = self._some()
        names = [p.name for p in obj.Proxy.PROPERTIES if p.kind.startswith("Link")]
        if not names:
            return
        name, target = self.rng.choice(names), self._some()
        value = (target, ["Edge1"]) if obj.getTypeIdOfProperty(name).endswith("LinkSub") else target
        before = getattr(obj, name)
        self._set(obj, name, value)
        self.doc.recompute()
        self._look("relink")
        self._set(obj, name, before)
        self.doc.recompute()

    def _look(self, after):
        """Every valid object has finite results, and a shape that is somewhere."""
        for obj in self._ours():
            if obj.isValid() and "Touched" not in obj.State:
                for name, value in results(obj).items():
                    if not np.isfinite(value).all():
                        raise Broken(f"{name} of {type_of(obj)} is {value} after {after}")
                if getattr(obj, "IsometryError", 0.0) > 1e-9 and obj.RatioRule != "Paper":
                    raise Broken(f"isometry {obj.IsometryError:.1e} after {after}")
            elif not obj.isValid():
                kept = obj.Proxy.refusal
                told = kept.message.template if kept else obj.getStatusString()
                self.told[f"refused: {told}"] = self.told.get(f"refused: {told}", 0) + 1

    def _anew(self):
        """All recomputed from nothing is what it was after all those edits."""
        before = states(self.doc)
        path = str(self.folder / f"{self.doc.Name}-anew.FCStd")
        self.doc.saveCopy(path)
        again = App.openDocument(path)
        try:
            for obj in again.Objects:
                obj.touch()
            again.recompute(None, True)
            compare(before, states(again), "made anew")
        finally:
            App.closeDocument(again.Name)
            Path(path).unlink()


def type_of(obj) -> str:
    """Our type of a document object, or ""."""
    return getattr(getattr(obj, "Proxy", None), "Type", "")


def is_number(obj, prop) -> bool:
    """Whether a property is an input of one number."""
    value = getattr(obj, prop.name)
    return not isinstance(prop, Result) and isinstance(getattr(value, "Value", value), float | int)


def results(obj) -> dict:
    """{name: numbers} of all results that hold numbers."""
    found = {}
    for prop in obj.Proxy.PROPERTIES:
        if isinstance(prop, Result) and prop.kind not in ("String", "StringList", "Bool"):
            value = getattr(obj, prop.name)
            found[prop.name] = np.atleast_1d(np.array(getattr(value, "Value", value), float))
    return found


def states(doc) -> dict:
    """{name: (is valid, corners of the shape)} of our objects that are up to date."""
    found = {}
    for obj in doc.Objects:
        if type_of(obj) and not (obj.isValid() and "Touched" in obj.State):
            box = obj.Shape.BoundBox if obj.isValid() and not obj.Shape.isNull() else None
            corners = [box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax] if box else []
            found[obj.Name] = obj.isValid(), corners
    return found


def compare(before, after, when):
    """`Broken` where an object is another one."""
    for name, (valid, corners) in before.items():
        if name not in after:
            continue  # an input of it is refused: it waits
        now_valid, now = after[name]
        if valid != now_valid:
            raise Broken(f"{name} is {'in' * (not now_valid)}valid {when}")
        if valid and len(corners) == len(now):
            size = max(map(abs, (*corners, 1.0)))
            if not math.isclose(np.abs(np.subtract(corners, now)).max(initial=0), 0,
                                abs_tol=_SAME * size):  # fmt: skip
                raise Broken(f"{name} is another one {when}: {corners} {now}")
