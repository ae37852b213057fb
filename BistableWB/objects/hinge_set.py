# SPDX-License-Identifier: LGPL-2.1-or-later
"""HingeSet: a tube of thick panels with print-in-place hinges, as it is printed and as it opens."""

import math

import FreeCAD as App
import numpy as np
import Part

from ..origami.creases import BODIES
from ..origami.hinge_parameters import PRESETS, HingeParameters
from ..origami.linkage import ThickUnit
from ..origami.thick_tube import ThickTube, thick_tube
from ..solids.tube import tube_bodies
from .base import BistableObject, Prop, Result, require_link, set_result
from .bistable_unit import BistableUnit, triangles_below, tube_of, tube_on
from .triangle_placement import geometry_below, place_on

_DEFAULTS = HingeParameters()
_SAMPLES = np.linspace(0, 1, 129)
_OFF_CURVE = 0.01  # of ‖AB‖: further off is worth a warning

# The hinge inputs that HingeSet and HingeCoupon share, with the paper's names.
HINGE_PROPERTIES = (
    Prop("Enumeration", "HingeType", "Hinge", "Rotational: print-in-place knuckles. Flexible: a "
         "strip of soft material (TPU) along every crease", ["Rotational", "Flexible"]),
    Prop("Enumeration", "Pivot", "Hinge", "Cone: each knuckle turns on a cone. Pin: a continuous "
         "pin, for thick panels", ["Cone", "Pin"]),
    Prop("Angle", "ConeAngle", "Hinge", "Angle of the cones' surface against their base, 45° to "
         "60°: steeper has less play", math.degrees(_DEFAULTS.cone_angle)),
    Prop("Integer", "Segmentations", "Hinge", "Number of knuckles along a hinge, odd; fewer where "
         "a hinge is short", _DEFAULTS.segmentations),
    Prop("Length", "GapLength", "Hinge", "Axial gap between knuckles and clearance around them",
         _DEFAULTS.gap_length),
    Prop("Length", "GapBetweenPlanes", "Hinge", "Gap between stacked panels",
         _DEFAULTS.gap_between_planes),
    Prop("Length", "FaceThickness", "Hinge", "Thickness of the panels", _DEFAULTS.face_thickness),
    Prop("Length", "LayerHeight", "Printer", "Layer height (the paper's profile)",
         _DEFAULTS.layer_height),
    Prop("Length", "NozzleDiameter", "Printer", "Nozzle diameter: the thinnest wall",
         _DEFAULTS.nozzle_diameter),
)  # fmt: skip


class HingeSet(BistableObject):
    """Every panel, link and contact block of a tube as a solid, in one stack for the print bed."""

    Type = "Bistable::HingeSet"
    PROPERTIES = (
        Prop("Link", "Unit", "Hinge", "BistableUnit whose panels become thick"),
        *HINGE_PROPERTIES,
        Prop("Bool", "Compensate", "Hinge", "Shift the hinge axes so that the thick panels close "
             "exactly when deployed; without it they do not snap", True),
        Prop("Enumeration", "Orientation", "Printer", "Flat: layers horizontal, gaps filled with "
             "soluble support. OnEdge: layers vertical", ["Flat", "OnEdge"]),
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
            PrintSize=_size(model.compound(0, obj.Orientation)),
            DeployedSize=_size(model.compound(1)),
            CurveDeviation=_length(model.tube.deviation()),
            DeployedMisfit=_length(model.tube.thick.misfit(1.0).max()),
            Warnings=model.warnings,
        )
        obj.Shape = model.compound(obj.Deployment, obj.Orientation)

    def model(self, obj):
        """The `Model` of a HingeSet object, from memory if nothing that shapes it has changed."""
        unit = require_link(obj, "Unit", BistableUnit.Type, "choose a BistableUnit")
        parameters = hinge_parameters(obj)
        key = (parameters, obj.Compensate, *_inputs(unit))
        if getattr(self, "_key", None) != key:
            self._model = _make_model(unit, parameters, obj.Compensate)
            self._key = key
        return self._model


class Model:
    """All bodies of a thick tube in the print frame, and where they stand in any state."""

    def __init__(self, tube, bodies, warnings):
        self.tube, self.bodies, self.warnings = tube, bodies, warnings

    def motions(self, opening):
        """Motions (bodies, 4, 4) from the flat print to an opening (0 flat, 1 deployed)."""
        found = self.tube.motions(opening)
        members = [body.members[0] for body in self.bodies]
        return np.array([found[k, BODIES.index(name)] for k, name in members])

    def compound(self, opening, orientation="Flat"):
        """Compound of all bodies, in their order; at opening 0 in the orientation of the print."""
        shapes = []
        turn = on_edge(self) if orientation == "OnEdge" and opening == 0 else App.Placement()
        for body, motion in zip(self.bodies, self.motions(opening), strict=True):
            shape = Part.Shape(body.shape)
            move = turn * App.Placement(App.Matrix(*motion.ravel().tolist()))
            shape.Placement = move * shape.Placement
            shapes.append(shape)
        return Part.makeCompound(shapes)


def on_edge(model):
    """Placement that stands the flat print on the ends of its layers (x of the print upwards)."""
    turn = App.Placement(App.Vector(), App.Rotation(App.Vector(0, 1, 0), -90))
    low = min(body.shape.BoundBox.XMin for body in model.bodies)
    return App.Placement(App.Vector(0, 0, -low), App.Rotation()) * turn


def hinge_parameters(obj):
    """`HingeParameters` from the properties of a HingeSet or HingeCoupon object."""
    return HingeParameters(
        hinge_type=obj.HingeType,
        pivot=obj.Pivot,
        cone_angle=math.radians(obj.ConeAngle.Value),
        segmentations=obj.Segmentations,
        gap_length=obj.GapLength.Value,
        gap_between_planes=obj.GapBetweenPlanes.Value,
        face_thickness=obj.FaceThickness.Value,
        layer_height=obj.LayerHeight.Value,
        nozzle_diameter=obj.NozzleDiameter.Value,
    )


def apply_preset(obj, name):
    """Set the hinge inputs of ``obj`` to the readable cells of a preset of the paper's tables."""
    if name not in PRESETS:
        raise ValueError(f"Preset {name!r} is unknown: choose one of {', '.join(PRESETS)}.")
    given = PRESETS[name].given
    for key, prop in (
        ("segmentations", "Segmentations"),
        ("gap_length", "GapLength"),
        ("gap_between_planes", "GapBetweenPlanes"),
        ("face_thickness", "FaceThickness"),
        ("layer_height", "LayerHeight"),
    ):
        if key in given:
            setattr(obj, prop, given[key])


def _make_model(unit, parameters, compensate):
    parameters.check()
    tube, warnings = _thick(unit, parameters, compensate)
    notes = []
    indicator = App.Base.ProgressIndicator()
    indicator.start("Hinged solids…", len(tube.tube))
    try:
        bodies = tube_bodies(
            tube.thick, parameters, tube.tube.incoming_left, lambda *_: indicator.next(True), notes
        )
    finally:
        indicator.stop()
    return Model(tube, bodies, [*parameters.warnings(), *warnings, *notes])


def _thick(unit, parameters, compensate):
    """`ThickTube` of a BistableUnit object, and warnings about it."""
    t, g = parameters.face_thickness, parameters.gap_between_planes
    triangles = triangles_below(unit)
    if triangles is not None and abs(triangles.Thickness.Value - parameters.pitch) < 1e-9:
        geometry = geometry_below(triangles)
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
    placed = place_on(triangles, geometry_below(triangles))
    tube = ThickTube(thin, thick, placed)
    cure = f"; set Thickness of {triangles.Label} to {parameters.pitch:.4g} mm"
    return tube, _deviation_warnings(tube, cure)


def _deviation_warnings(tube, cure):
    off, edge = tube.deviation(), tube.placement.edge_length
    if off <= _OFF_CURVE * edge:
        return []
    return [f"Deployed, the tube strays up to {off:.3g} mm from its curve{cure or ': compensate'}."]


def _inputs(unit):
    """What shapes a BistableUnit's tube, without its `Deployment`: comparable values."""
    own = [getattr(unit, n) for n in ("RatioRule", "Ratio", "RatioShare", "HeightRatio")]
    triangles = triangles_below(unit)
    if triangles is None:
        return (*own, unit.Theta.Value, unit.EdgeLength.Value, unit.Omega.Value)
    geometry = geometry_below(triangles)
    return (
        *own,
        triangles.EdgeLength.Value,
        triangles.Gamma.Value,
        triangles.Thickness.Value,
        triangles.FlipSide,
        geometry.family,
        geometry.sphere_radius,
        np.asarray(geometry.legs[1], float).tobytes(),
        np.asarray(geometry.curve.point(_SAMPLES), float).tobytes(),
    )


def _size(shape):
    box = shape.BoundBox
    return App.Vector(box.XLength, box.YLength, box.ZLength)


def _length(value):
    return App.Units.Quantity(float(value), App.Units.Length)
