# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a search found, as steps for a document, and as a table of what they change and why."""

import math
from dataclasses import dataclass, field

import FreeCAD as App

from ..objects import proxy_class, type_of
from ..objects.base import default_of, global_placement
from ..objects.hinge_set import AUTOMATIC, GIVEN
from ..origami.errors import Phrase, phrase
from ..origami.hinges.kinds import ROTATIONAL
from . import reasons
from .chain import HINGES, TRIANGLES, UNIT, Chain, hinges_name
from .steps import Change, Follow, Make, MakeCurve, Remove, Set, Take, plain, same

_MAKERS = {
    TRIANGLES: ("make_triangle_placement", "curve", "TrianglePlacement"),
    UNIT: ("make_bistable_unit", "triangles", "BistableUnit"),
    HINGES: ("make_hinge_set", "unit", "HingeSet"),
}


@dataclass
class Proposal:
    """Steps that make a curve's tube printable; nothing of the document is changed by it.

    ``found``: the `origami.fit.printable.Printable`; ``blocked``: None, or what stands in the way
    of what was asked; ``steps`` and ``changes``: see `steps`; ``hinge_sets``: their variables.
    """

    found: object
    blocked: Phrase | None
    steps: list = field(default_factory=list)
    changes: list = field(default_factory=list)
    hinge_sets: list = field(default_factory=list)

    def lines(self) -> list[str]:
        """Lines of a macro, after ``from BistableWB import fitting, make`` and ``doc = …``."""
        return [step.line() for step in self.steps]

    def do(self, doc) -> dict:
        """Change a document; returns {variable: object}. Not recomputed."""
        objects: dict = {}
        for step in self.steps:
            step.do(doc, objects)
        return objects


class Writer:
    """Writes a `Proposal` for the objects of a `Chain`."""

    def __init__(self, chain: Chain, request, found, blocked):
        self.chain, self.request, self.found = chain, request, found
        self.there = chain.objects()
        self.types: dict = {}
        self.processed: set = set()  # new hinge sets whose process sets all that they are
        self.written = Proposal(found, blocked)

    def write(self) -> Proposal:
        """All of it, in the order in which objects are made from each other."""
        self._curve()
        self._triangles()
        self._unit()
        self._hinges()
        return self.written

    # objects

    def _take(self, variable, type_name):
        """Name the object that is there, or have it made."""
        self.types[variable] = type_name
        obj = self.there.get(variable)
        if obj is not None:
            self.written.steps.append(Take(variable, obj.Name))
        else:
            function, of, _ = _MAKERS[type_name]
            self.written.steps.append(Make(variable, function, of))

    def _set(self, variable, property, value, why):
        """A property that differs is set, and told; of new objects also where it is the default."""
        obj = self.there.get(variable)
        if obj is not None:
            before = plain(getattr(obj, property))
            if same(before, value):
                return
            label = obj.Label
        else:
            before, label = None, _MAKERS[self.types[variable]][2]
            proxy = proxy_class(self.types[variable])
            usual = same(plain(default_of(proxy, property)), value)
            if usual and property != "EdgeLength" and variable not in self.processed:
                return
            if property == "Process":
                self.processed.add(variable)
        self.written.steps.append(Set(variable, property, value))
        self.written.changes.append(Change(variable, label, property, before, value, why))

    # in the order of the document

    def _curve(self):
        option, curve = self.found.option, self.chain.curve
        if curve is None:
            obj, names = self.chain.edges
            self.written.steps.append(MakeCurve((obj.Name, tuple(names))))
        else:
            self.written.steps.append(Take("curve", curve.Name))
        if option.change:
            label = "Curve" if curve is None else curve.Label
            self.written.steps.append(Follow(option.width))
            why = reasons.gentler(option, self.request.wish)
            source = getattr(curve, "Source", None)
            drawn = "Points" if source is None and curve is not None else "Source"
            before = phrase("as drawn") if curve is not None else None
            self.written.changes.append(
                Change("curve", label, drawn, before, phrase("a gentler curve"), why)
            )
        if option.geometry.family == "General":
            self._ruling(option)

    def _ruling(self, option):
        """Legs of a space curve as the search found them best."""
        (kind, vector), curve = option.geometry.legs, self.chain.curve
        own_kind, own = self.request.geometry.legs
        alike = kind == own_kind and max(abs(a - b) for a, b in zip(vector, own, strict=True))
        if kind == own_kind and alike < 1e-6 and not option.change:
            return
        vector = tuple(float(x) for x in vector)
        if curve is not None:
            back = global_placement(curve).inverse()
            turn = back.Rotation.multVec if kind == "parallel" else back.multVec
            vector = tuple(turn(App.Vector(*vector)))
        kind = "Direction" if kind == "parallel" else "Viewpoint"
        label = "Curve" if curve is None else curve.Label
        for name, value in (("Ruling", vector), ("RulingKind", kind)):
            before = None if curve is None else plain(getattr(curve, name))
            if before is None or not same(before, value):
                self.written.steps.append(Set("curve", name, value))
                change = Change("curve", label, name, before, value, reasons.RULING)
                self.written.changes.append(change)

    def _triangles(self):
        option, found = self.found.option, self.found
        self._take("triangles", TRIANGLES)
        values = {
            "EdgeLength": (float(option.edge_length), reasons.edge_length(found)),
            "Gamma": (round(math.degrees(option.gamma), 6), reasons.gamma(found)),
            "Thickness": (float(option.hinges.pitch), reasons.THICKNESS),
            "FlipSide": (bool(option.flip), reasons.FLIP),
            "Level": (bool(option.level), reasons.LEVEL),
            "PlacementRule": (option.rule.name, reasons.rule(option)),
        }
        if option.rule.tolerance:
            values["Tolerance"] = float(option.rule.tolerance), reasons.TOLERANCE
            values |= {
                "Symmetric": (False, reasons.STEERED_FREELY),
                "StartDirection": ("Free", reasons.STEERED_FREELY),
                "EndDirection": ("Free", reasons.STEERED_FREELY),
            }
        for name, (value, why) in values.items():
            self._set("triangles", name, value, why)

    def _unit(self):
        design, rule = self.found.design, self.found.design.rule
        self._take("unit", UNIT)
        self._set("unit", "HeightRatio", float(design.height_ratio), reasons.height(design))
        self._set("unit", "RatioRule", rule.name, reasons.ratios(rule, self.request.wish))
        if rule.name == "TargetSnap":
            aims = {
                "TargetBarrier": 0.0,
                "TargetMargin": rule.target.margin,
                "HingePlay": rule.target.play,
                "StrainLimit": rule.target.strain_limit,
                "MarginMeasure": rule.target.measure,
            }
            for name, value in aims.items():
                self._set("unit", name, value, reasons.target(name, self.request.wish))
        else:
            self._set("unit", "RatioShare", rule.share, reasons.ratios(rule, self.request.wish))

    def _hinges(self):
        """One HingeSet a print: those there are, and new ones."""
        found, wish = self.found, self.request.wish
        parts = found.parts or [(0, len(found.margins) - 1)]
        for n, (first, last) in enumerate(parts):
            variable = hinges_name(n)
            self._take(variable, HINGES)
            self.written.hinge_sets.append(variable)
            for name, value, why in self._panels(wish):
                self._set(variable, name, value, why)
            whole = len(parts) == 1 and "hinges" not in self.there
            if not whole:
                why = reasons.part(n, len(parts), wish)
                self._set(variable, "FirstUnit", first + 1, why)
                last_unit = 0 if last == len(found.margins) - 1 else last + 1
                self._set(variable, "LastUnit", last_unit, why)
            if found.parts:
                self._set(variable, "Bed", tuple(map(float, wish.bed)), reasons.BED)
        for obj in self.chain.hinge_sets[len(parts) :]:
            self.written.steps.append(Remove(obj.Name))
            gone = Change(type_of(obj), obj.Label, "", None, phrase("removed"), reasons.NO_PART)
            self.written.changes.append(gone)

    def _panels(self, wish):
        """Hinge and panel numbers; what margins were measured with, of new hinge sets too."""
        hinges = self.found.option.hinges
        why = reasons.panels(hinges == wish.panels[0])
        yield "Process", hinges.process, reasons.MEASURED
        yield "FaceThickness", float(hinges.face_thickness), why
        yield "GapBetweenPlanes", float(hinges.gap_between_planes), why
        yield "GapLength", float(hinges.gap_length), why
        yield "Compensate", True, reasons.COMPENSATE
        yield "PreloadRule", AUTOMATIC if wish.preload is None else GIVEN, reasons.PRELOAD
        if wish.preload is not None:
            yield "Preload", float(wish.preload), reasons.PRELOAD
        yield "HingeType", ROTATIONAL, reasons.KNUCKLES
        yield "Pivot", hinges.pivot, reasons.MEASURED
        yield "ConeAngle", round(math.degrees(hinges.cone_angle), 6), reasons.MEASURED
        yield "SegmentWidth", float(hinges.segment_width), reasons.MEASURED
        if not hinges.segment_width:
            yield "Segmentations", hinges.segmentations, reasons.MEASURED
        finer = hinges.layer_height < wish.panels[0].layer_height
        layer_why = reasons.LAYER if finer else reasons.MEASURED
        yield "LayerHeight", float(hinges.layer_height), layer_why
        yield "NozzleDiameter", float(hinges.nozzle_diameter), reasons.MEASURED
        yield "Orientation", "OnEdge" if self.request.on_edge else "Flat", reasons.MEASURED
