# SPDX-License-Identifier: LGPL-2.1-or-later
"""Macro API: one function an object. mm and degrees; the document is not recomputed."""

import contextlib
import functools

import FreeCAD as App

from .objects import TYPES, proxy_class
from .objects.base import make_object, repair_object
from .objects.links import refuse_foreign
from .origami.errors import Refusal, name_of
from .origami.snap.table import PITCH_RATIOS
from .origami.units.ratios import DEFAULT_SHARE

# Edge length (mm) and gamma (degrees) with which the units of most curves snap firmly. Functions
# keep the defaults of version 0.1, for macros of that time.
NEW_TUBE = {"edge_length": 70.0, "gamma": 30.0}


def new_tube(curve, bed=(250.0, 210.0, 210.0)):
    """What a new tube along a Curve object begins with, as arguments of `make_triangle_placement`.

    Its edge length (mm) follows from the curve's length and the printer's ``bed`` (x, y, z, mm):
    a tenth of the curve, firm with usual hinges, no wider than the bed takes.
    """
    from .objects.curve import geometry_of
    from .origami.curves.crossing import CurveTable
    from .origami.fit.defaults import first_edge_length

    try:
        length = float(CurveTable(geometry_of(curve).curve, 1e9).lengths[-1])
    except Refusal:  # the curve says it itself when it is recomputed
        return NEW_TUBE
    return {**NEW_TUBE, "edge_length": first_edge_length(length, max(bed[:2]))}


def whole(make):
    """A function that makes objects in a document (its first argument): all of them, or none."""

    @functools.wraps(make)
    def made(doc, *args, **options):
        before = {obj.Name for obj in doc.Objects}
        try:
            return make(doc, *args, **options)
        except Exception:
            for name in [obj.Name for obj in doc.Objects if obj.Name not in before][::-1]:
                doc.removeObject(name)
            raise

    return made


@whole
def make_curve(doc, points=None, source=None, kind="Automatic", sphere_radius=None, name="Curve"):
    """A curve by control ``points`` (two or more) or by ``source``.

    ``source``: an object with edges, or (object, sub-element names). ``kind``:
    "Automatic", "Plane", "Sphere" or "General"; ``sphere_radius`` in mm. Without points and source:
    the example arch.
    """
    obj = _make(doc, "Bistable::Curve", name, Kind=kind)
    if points is not None:
        obj.Points = [App.Vector(*p) for p in points]
    if source is not None:
        source = source if isinstance(source, tuple) else (source, [""])
        refuse_foreign(obj, "Source", source[0])
        obj.Source = source
    if sphere_radius is not None:
        obj.SphereRadius = sphere_radius
    return obj


@whole
def make_triangle_placement(doc, curve, edge_length=40.0, gamma=20.0):
    """Triangles along a Curve object: ``edge_length`` ‖AB‖ in mm, ``gamma`` in degrees."""
    obj = _make(doc, "Bistable::TrianglePlacement", "TrianglePlacement")
    refuse_foreign(obj, "Curve", curve)
    obj.Curve = curve
    obj.EdgeLength = edge_length
    obj.Gamma = gamma
    return obj


@whole
def make_bistable_unit(
    doc, triangles=None, theta=None, ratio=None, edge_length=None, height_ratio=2.5
):
    """Units of a whole tube (``triangles``), or one unit by ``theta`` (°) and ``edge_length`` (mm).

    ``ratio`` = ‖A'C'‖/‖AB‖ of all units (rule Fixed). Without it the rule is Adaptive.
    """
    obj = _make(doc, "Bistable::BistableUnit", "BistableUnit")
    refuse_foreign(obj, "Triangles", triangles)
    obj.Triangles = triangles
    obj.HeightRatio = height_ratio
    for name, value in (("Theta", theta), ("Ratio", ratio), ("EdgeLength", edge_length)):
        if value is not None:
            setattr(obj, name, value)
    return obj


@whole
def make_hinge_set(doc, unit, hinge_type="Rotational", preset=None, process=None):
    """Thick, hinged panels for a BistableUnit object; ``preset``: a column of the paper's tables.

    ``process``: how it is printed, a name of `origami.hinges.processes` ("FDM, stand-offs").

    A tube's TrianglePlacement that does not allow for thickness yet gets the pitch of the panels,
    and its units expect the play of these hinges. A ratio rule that nobody has touched becomes
    TargetSnap, so that the hinges' play does not swallow the snap of units that open little.
    """
    from .objects.hinge_inputs import apply_preset, hinge_parameters

    chosen = {} if process is None else {"Process": process}
    obj = _make(doc, "Bistable::HingeSet", "HingeSet", HingeType=hinge_type, **chosen)
    refuse_foreign(obj, "Unit", unit)
    obj.Unit = unit
    if preset is not None:
        apply_preset(obj, preset)
    triangles = getattr(unit, "Triangles", None)
    if triangles is not None and triangles.Thickness.Value == 0:
        parameters = hinge_parameters(obj)
        triangles.Thickness = parameters.pitch
        if unit.RatioRule != "TargetSnap":
            unit.HingePlay = parameters.play
        if _may_aim(unit, triangles, parameters):
            unit.RatioRule = "TargetSnap"
    return obj


def _may_aim(unit, triangles, parameters):
    """Whether nobody chose ratios, and a margin is known for hinges of these ``parameters``."""
    untouched = unit.RatioRule == "Adaptive" and unit.RatioShare == DEFAULT_SHARE
    tabulated = parameters.pitch <= PITCH_RATIOS[-1] * triangles.EdgeLength.Value
    return untouched and tabulated and parameters.play > 0


def make_solids(hinges):
    """Make the solids of a HingeSet now, whatever its Update; in the window Esc stops it.

    `Cancelled` then. What the HingeSet refuses, the next recompute will say.
    """
    with contextlib.suppress(ValueError):
        hinges.Proxy.model(hinges)


@whole
def make_hinge_coupon(doc, kind="Dihedral", preset="Hinge4"):
    """A test print: ``kind`` "Dihedral", "Vertex" or "NonDevelopableVertex".

    ``preset``: a column of the paper's tables ("Hinge1" … "Hinge9", "Recommended",
    "RecommendedVertex"), or None for the workbench's defaults.
    """
    from .objects.hinge_inputs import check_preset

    if preset is not None:
        check_preset(preset)
    obj = _make(doc, "Bistable::HingeCoupon", "HingeCoupon", Kind=kind)
    if kind != "Dihedral":
        obj.LengthX, obj.LengthY = 50.0, 32.0
    if preset is not None:
        obj.Preset = preset
    return obj


@whole
def make_calibration_plate(doc, least=0.2, step=0.05, count=7):
    """One print that tells what a printer keeps apart: see `origami.hinges.calibration`.

    ``count`` hinges of the clearances ``least``, ``least`` + ``step``, … (mm), and pairs of plates
    over one and two layers of air. `settings.keep_calibration` takes what came out.
    """
    obj = _make(doc, "Bistable::CalibrationPlate", "CalibrationPlate")
    obj.Least, obj.Step, obj.Count = least, step, count
    return obj


def measure_snap(hinges, progress=None):
    """How hard a HingeSet's units snap, how they wobble and whether the tube stands.

    Fills its results Barriers, HandForces, SafetyFactors, … and returns the `Study`; some seconds
    a unit. ``progress``: a `Progress`.
    """
    from .origami.progress import NOBODY

    return hinges.Proxy.measure(hinges, progress or NOBODY)


def repair(doc):
    """Give objects of ours that lost their proxies (a save without the workbench) these back.

    Returns the objects that needed it; the document is recomputed if there are any.
    """
    repaired = [
        obj
        for obj in doc.Objects
        if repair_object(obj, lambda name: proxy_class(name) if name in TYPES else None)
    ]
    if repaired:
        doc.recompute()
    return repaired


def _make(doc, type_name, name, **choices):
    """A new object with its ``choices`` {enumeration: value}; ValueError, and no object, if wrong.

    FreeCAD 0.20 refuses a wrong value with a dictionary of its own insides.
    """
    kind = proxy_class(type_name)
    values = {prop.name: prop.default for prop in kind.PROPERTIES}
    for prop, value in choices.items():
        if value not in values[prop]:
            known = ", ".join(values[prop])
            raise Refusal(
                "{name} {value!r} is unknown: choose one of {known}.",
                parameter=prop,
                name=name_of(prop),
                value=value,
                known=known,
            )
    obj = make_object(doc, type_name, name, kind)
    for prop, value in choices.items():
        setattr(obj, prop, value)
    return obj
