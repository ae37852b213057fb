# SPDX-License-Identifier: LGPL-2.1-or-later
"""Macro API: one function an object. mm and degrees; the document is not recomputed."""

import contextlib

import FreeCAD as App

from .objects import TYPES, proxy_class
from .objects.base import make_object, repair_object
from .origami.ratios import DEFAULT_SHARE
from .origami.snap_table import PITCH_RATIOS


def make_curve(doc, points=None, source=None, kind="Plane", sphere_radius=None, name="Curve"):
    """An open curve by control ``points`` (two or more) or by ``source``.

    ``source``: an object with edges, or (object, sub-element names). ``kind``: "Plane",
    "Sphere" or "General"; ``sphere_radius`` in mm. Without points and source: the example arch.
    """
    obj = _make(doc, "Bistable::Curve", name, Kind=kind)
    if points is not None:
        obj.Points = [App.Vector(*p) for p in points]
    if source is not None:
        obj.Source = source if isinstance(source, tuple) else (source, [""])
    if sphere_radius is not None:
        obj.SphereRadius = sphere_radius
    return obj


def make_triangle_placement(doc, curve, edge_length=40.0, gamma=20.0):
    """Triangles along a Curve object: ``edge_length`` ‖AB‖ in mm, ``gamma`` in degrees."""
    obj = _make(doc, "Bistable::TrianglePlacement", "TrianglePlacement")
    obj.Curve = curve
    obj.EdgeLength = edge_length
    obj.Gamma = gamma
    return obj


def make_bistable_unit(
    doc, triangles=None, theta=None, ratio=None, edge_length=None, height_ratio=2.5
):
    """Units of a whole tube (``triangles``), or one unit by ``theta`` (°) and ``edge_length`` (mm).

    ``ratio`` = ‖A'C'‖/‖AB‖ of all units (rule Fixed). Without it the rule is Adaptive on a plane
    and Exact on a sphere.
    """
    obj = _make(doc, "Bistable::BistableUnit", "BistableUnit")
    obj.Triangles = triangles
    obj.HeightRatio = height_ratio
    for name, value in (("Theta", theta), ("Ratio", ratio), ("EdgeLength", edge_length)):
        if value is not None:
            setattr(obj, name, value)
    curve = getattr(triangles, "Curve", None)
    if getattr(curve, "Kind", "") == "Sphere":
        obj.RatioRule = "Exact"
    return obj


def make_hinge_set(doc, unit, hinge_type="Rotational", preset=None):
    """Thick, hinged panels for a BistableUnit object; ``preset``: a column of the paper's tables.

    A tube's TrianglePlacement that does not allow for thickness yet gets the pitch of the panels,
    and its units expect the play of these hinges. A ratio rule that nobody has touched becomes
    TargetSnap, so that the hinges' play does not swallow the snap of units that open little (on a
    sphere, where ratios cannot be chosen, it stays).
    """
    from .objects.hinge_inputs import apply_preset, hinge_parameters

    obj = _make(doc, "Bistable::HingeSet", "HingeSet", HingeType=hinge_type)
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
    on_sphere = getattr(triangles.Curve, "Kind", "") == "Sphere"
    tabulated = parameters.pitch <= PITCH_RATIOS[-1] * triangles.EdgeLength.Value
    return untouched and not on_sphere and tabulated and parameters.play > 0


def make_solids(hinges):
    """Make the solids of a HingeSet now: Esc can stop it here, but not within a recompute.

    What the HingeSet refuses, the next recompute will say.
    """
    with contextlib.suppress(ValueError):
        hinges.Proxy.model(hinges)


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
            raise ValueError(f"{prop} {value!r} is unknown: choose one of {known}.")
    obj = make_object(doc, type_name, name, kind)
    for prop, value in choices.items():
        setattr(obj, prop, value)
    return obj
