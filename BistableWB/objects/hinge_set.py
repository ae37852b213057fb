# SPDX-License-Identifier: LGPL-2.1-or-later
"""HingeSet: a tube of thick panels with print-in-place hinges, as it is printed and as it opens."""

import re

import FreeCAD as App
import numpy as np
import Part

from ..checks import ERROR
from ..checks.bed import Bed, check_bed, split
from ..origami.creases import BODIES
from ..origami.linkage import ThickUnit
from ..origami.snap import assess
from ..origami.thick_tube import ThickTube, thick_tube
from ..solids.joint import part_bodies
from ..solids.support import support_body
from ..solids.tube import tube_bodies
from .base import Prop, Result, frame_placement, require_link, set_result, set_warnings
from .bistable_unit import SHAPING, BistableUnit, triangles_below, tube_of, tube_on
from .curve import placed as placed_by
from .hinge_inputs import HINGE_PROPERTIES, hinge_parameters
from .self_drawn import SelfDrawn
from .triangle_placement import geometry_below, place_on

_SAMPLES = np.linspace(0, 1, 129)
_OFF_CURVE = 0.01  # of ‖AB‖: further off is worth a warning


class HingeSet(SelfDrawn):
    """Every panel, link and contact block of a tube as a solid, in one stack for the print bed."""

    Type = "Bistable::HingeSet"
    PROPERTIES = (
        Prop("Link", "Unit", "Hinge", "BistableUnit whose panels become thick"),
        *HINGE_PROPERTIES,
        Prop("Bool", "Compensate", "Hinge", "Shift the hinge axes so that the thick panels close "
             "exactly when deployed; without it they do not snap", True),
        Prop("Enumeration", "Orientation", "Printer", "Flat: layers horizontal, gaps filled with "
             "soluble support. OnEdge: layers vertical", ["Flat", "OnEdge"]),
        Prop("Vector", "Bed", "Printer", "Room of the printer (width, depth, height in mm), to "
             "refuse a print that is too large; 0, 0, 0: not checked", App.Vector(0, 0, 0)),
        Prop("Integer", "FirstUnit", "Part of the tube", "First unit of this print, counted from "
             "1: a long tube is printed in parts that are joined at their contact blocks", 1),
        Prop("Integer", "LastUnit", "Part of the tube", "Last unit of this print; 0: the last of "
             "the tube", 0),
        Prop("Bool", "Support", "Printer", "Export a body of soluble support that fills the gaps "
             "between the panels", False),
        Prop("FloatConstraint", "Deployment", "State", "0 is the flat-folded print on the bed, 1 "
             "is deployed along the curve", (0.0, 0.0, 1.0, 0.05)),
        Result("Integer", "BodyCount", "Results", "Number of separate moving bodies"),
        Result("StringList", "BodyNames", "Results", "Names of the bodies, in the order of the "
               "solids"),
        Result("Vector", "PrintSize", "Results", "Length, width and height of the print, mm"),
        Result("Vector", "DeployedSize", "Results", "Length, width and height when deployed, mm"),
        Result("Length", "CurveDeviation", "Results", "Largest distance of a deployed contact "
               "block from its place on the curve"),
        Result("Length", "DeployedMisfit", "Results", "Largest misfit of a hinge when deployed"),
        Result("FloatList", "SnapMargins", "Results", "Needed play / play of the hinge, for every "
               "unit; below 1 a unit is floppy"),
        Result("StringList", "Warnings", "Results", "What to look at before printing"),
    )  # fmt: skip

    def generate(self, obj):
        """Solids at `Deployment`; they are made anew only if more than that has changed."""
        model = self.model(obj)
        if not 0 <= obj.Deployment <= 1:
            raise ValueError(f"Deployment is {obj.Deployment:.6g}: it must lie between 0 and 1.")
        set_result(
            obj,
            BodyCount=len(model.bodies),
            BodyNames=[body.name for body in model.bodies],
            PrintSize=_size(model.shapes(0, obj.Orientation)),
            DeployedSize=_size(model.shapes(1)),
            CurveDeviation=_length(model.tube.deviation()),
            DeployedMisfit=_length(model.tube.thick.misfit(1.0).max()),
            SnapMargins=np.atleast_1d(model.snap.margin).tolist(),
        )
        set_warnings(obj, model.warnings)
        obj.Shape = Part.makeCompound(model.shapes(obj.Deployment, obj.Orientation))

    def export_bodies(self, obj):
        """[(name, shape), …] of the flat-folded print in its orientation, whatever `Deployment`."""
        model, named = self.model(obj), self.bodies_at(obj, 0)
        if obj.Support:
            body = model.support()
            body.Placement = model.standing(obj.Orientation) * body.Placement
            named.append(("support", body))
        return named

    def bodies_at(self, obj, opening):
        """[(name, shape), …] at an opening; flexible strips, which bend, are there at 0 only."""
        model = self.model(obj)
        names = [body.name for body in model.bodies if opening == 0 or body.members]
        return list(zip(names, model.shapes(opening, obj.Orientation), strict=True))

    def model(self, obj):
        """The `Model` of a HingeSet object, from memory if nothing that shapes it has changed."""
        unit = require_link(obj, "Unit", BistableUnit.Type, "choose a BistableUnit")
        parameters = hinge_parameters(obj)
        if parameters.rotation_angle:
            raise ValueError(
                f"RotationAngle is {obj.RotationAngle.Value:.6g}°: a tube is printed flat-folded, "
                "set it to 0°; coupons can be printed partly open."
            )
        units = obj.FirstUnit, obj.LastUnit
        room = tuple(obj.Bed), obj.Orientation
        back = frame_placement(obj).inverse()  # a Part's placement moves the Shape once, not twice
        key = (parameters, obj.Compensate, units, *_inputs(unit, back))
        if getattr(self, "_key", None) != key:
            self._model = _make_model(unit, back, parameters, obj.Compensate, units, room)
            self._key = key
        else:
            _check_bed(self._model.tube, parameters, room, obj.FirstUnit - 1)
        return self._model


class Model:
    """All bodies of a thick tube in the print frame, and where they stand in any state.

    Flexible strips (`Body.members` empty) bend, so they are there in the flat print only.
    """

    def __init__(self, tube, parameters, bodies, warnings):
        self.tube, self.parameters, self.bodies = tube, parameters, bodies
        self.snap = assess(tube.thick, parameters.play)
        self.warnings = [*parameters.warnings(), *_gathered(self.snap.warnings()), *warnings]

    def motions(self, opening):
        """Motions (bodies, 4, 4) from the flat print to an opening; None for flexible strips."""
        found = self.tube.motions(opening)
        members = [body.members[0] if body.members else None for body in self.bodies]
        return [m and found[m[0], BODIES.index(m[1])] for m in members]

    def shapes(self, opening, orientation="Flat"):
        """Shapes of the bodies at an opening; at 0 all of them, in the orientation of the print."""
        if opening == 0:
            turn = self.standing(orientation)
            return [_moved(body.shape, turn) for body in self.bodies]
        return [
            _moved(body.shape, App.Placement(App.Matrix(*motion.ravel().tolist())))
            for body, motion in zip(self.bodies, self.motions(opening), strict=True)
            if motion is not None
        ]

    def standing(self, orientation):
        """Placement of the flat print on the bed: as it is, or on the ends of its layers."""
        if orientation == "Flat":
            return App.Placement()
        turn = App.Placement(App.Vector(), App.Rotation(App.Vector(0, 1, 0), -90))
        low = min(body.shape.BoundBox.XMin for body in self.bodies)
        return App.Placement(App.Vector(0, 0, -low), App.Rotation()) * turn

    def support(self):
        """Shape of the soluble support in the print frame."""
        tube = self.tube
        return support_body(tube.thick, self.parameters, tube.tube.incoming_left).shape


def _moved(shape, placement):
    moved = Part.Shape(shape)
    moved.Placement = placement * moved.Placement
    return moved


def _make_model(unit, back, parameters, compensate, units, room):
    parameters.check()
    whole, warnings = _thick(unit, back, parameters, compensate)
    first, last = _range(units, len(whole.tube))
    part = whole.part(first, last)
    _check_bed(part, parameters, room, first)
    notes = []
    indicator = App.Base.ProgressIndicator()
    indicator.start("Hinged solids…", len(part.tube))

    def progress(*_):
        indicator.next(True)

    left = whole.tube.incoming_left
    try:
        if part is whole:
            bodies = tube_bodies(whole.thick, parameters, left, progress, notes)
        else:
            bodies = part_bodies(whole.thick, parameters, first, last, left, progress)
    finally:
        indicator.stop()
    return Model(part, parameters, bodies, [*warnings, *_gathered(notes)])


def _range(units, count):
    """First and last unit, counted from 0, of the properties FirstUnit and LastUnit."""
    first, last = units[0] - 1, (units[1] or count) - 1
    if not 0 <= first <= last < count:
        raise ValueError(
            f"FirstUnit {units[0]} and LastUnit {units[1]} do not name units of a tube of {count}: "
            f"set FirstUnit to 1 or more and LastUnit to at most {count} (0: the last)."
        )
    return first, last


def _check_bed(tube, parameters, room, first):
    """ValueError where the print does not fit a given bed, with the parts that would.

    ``room``: the properties Bed and Orientation.
    """
    size, orientation = room
    if not any(size):
        return
    given = tube.thick, parameters, Bed(*size), tube.tube.incoming_left, orientation == "OnEdge"
    finding = check_bed(*given)[0]
    if finding.severity == ERROR:
        parts = ", ".join(f"{a + first + 1}–{b + first + 1}" for a, b in split(*given))
        cure = f"set FirstUnit and LastUnit to print the parts {parts}" if parts else finding.cure
        raise ValueError(f"Bed: {finding.message} Cure: {cure}.")


def _gathered(sentences):
    """Sentences "Unit k: …" or "Unit k …" that say the same kind of thing, one for all units.

    The first of each kind stays whole; how many more units it holds for is added.
    """
    kinds = {}
    for sentence in sentences:
        kinds.setdefault(re.sub(r"[\d.]+", "#", sentence), []).append(sentence)
    gathered = []
    for same in kinds.values():
        more = sorted({int(n) for s in same[1:] for n in re.findall(r"^Unit (\d+)", s)})
        told = same[0]
        if more:
            told = f"{told} (Also unit{'s'[: len(more) > 1]} {', '.join(map(str, more))}.)"
        gathered.append(told)
    return gathered


def _thick(unit, back, parameters, compensate):
    """`ThickTube` of a BistableUnit object in the frame that ``back`` leads to, and warnings."""
    t, g = parameters.face_thickness, parameters.gap_between_planes
    triangles = triangles_below(unit)
    if triangles is not None and abs(triangles.Thickness.Value - parameters.pitch) < 1e-9:
        geometry = placed_by(geometry_below(triangles), back)
        tube = thick_tube(
            lambda tuning: place_on(triangles, geometry, tuning.extra),
            lambda placed, tuning: tube_on(unit, placed, geometry, tuning),
            t,
            g,
            compensate,
        )
        return tube, _deviation_warnings(tube, "")
    thin = tube_of(unit)
    thick = ThickUnit(thin.unit, t, g)
    if compensate:
        thick = thick.compensated()
    if triangles is None:
        return ThickTube(thin, thick), []
    placed = place_on(triangles, placed_by(geometry_below(triangles), back))
    tube = ThickTube(thin, thick, placed)
    cure = f"; set Thickness of {triangles.Label} to {parameters.pitch:.4g} mm"
    return tube, _deviation_warnings(tube, cure)


def _deviation_warnings(tube, cure):
    off, edge = tube.deviation(), tube.placement.edge_length
    if off <= _OFF_CURVE * edge:
        return []
    return [f"Deployed, the tube strays up to {off:.3g} mm from its curve{cure or ': compensate'}."]


def _inputs(unit, back):
    """What shapes a BistableUnit's tube, without its `Deployment`: comparable values."""
    own = [getattr(unit, name) for name in SHAPING]
    own = [getattr(value, "Value", value) for value in own]
    triangles = triangles_below(unit)
    if triangles is None:
        alone = (unit.Theta, unit.EdgeLength, unit.Omega, unit.Thickness)
        return (*own, *(quantity.Value for quantity in alone))
    geometry = placed_by(geometry_below(triangles), back)
    return (
        *own,
        triangles.EdgeLength.Value,
        triangles.Gamma.Value,
        triangles.Thickness.Value,
        triangles.FlipSide,
        triangles.Level,
        geometry.family,
        geometry.sphere_radius,
        np.asarray(geometry.legs[1], float).tobytes(),
        np.asarray(geometry.curve.point(_SAMPLES), float).tobytes(),
    )


def _size(shapes):
    box = App.BoundBox()
    for shape in shapes:
        box.add(shape.BoundBox)
    return App.Vector(box.XLength, box.YLength, box.ZLength)


def _length(value):
    return App.Units.Quantity(float(value), App.Units.Length)
