# SPDX-License-Identifier: LGPL-2.1-or-later
"""BistableUnit: the zero-thickness faces of a whole tube, or of one unit by itself."""

import math

import FreeCAD as App
import numpy as np
import Part

from ..origami.design import Single, TubeDesign
from ..origami.errors import Refusal, phrase
from ..origami.snap.table import LEGACY, MEASURES
from ..origami.snap.targets import FIRM, TargetBarrier, TargetMargin
from ..origami.units.creases import INDEX, PANELS
from ..origami.units.ratios import DEFAULT_SHARE, RULES, SPHERE_RULES, RatioRule
from ..solids.matrices import array_of
from .base import (
    BistableObject,
    Prop,
    Result,
    global_placement,
    require_link,
    set_result,
    set_warnings,
)
from .links import linked
from .triangle_placement import TrianglePlacement, placing_of

_ALONE = ("Theta", "EdgeLength", "Omega", "Thickness")
_FLAT_ENOUGH = 1e-7  # mm that a corner may lie off its panel's plane


class BistableUnit(BistableObject):
    """Twelve panels a unit, in two congruent states and the least-misfit way between them."""

    Type = "Bistable::BistableUnit"
    PROPERTIES = (
        Prop("Link", "Triangles", "Unit", "TrianglePlacement whose whole tube is made; empty: one "
             "unit by itself from Theta and EdgeLength"),
        Prop("Angle", "Theta", "Unit", "Opening angle of the single unit", 45.0),
        Prop("Length", "EdgeLength", "Unit", "Length ‖AB‖ of the single unit", 60.0),
        Prop("Angle", "Omega", "Unit", "Base angle ω of the single unit's contact trapezoids; "
             "90° is a plane unit, less is a unit on a sphere", 90.0),
        Prop("Enumeration", "RatioRule", "Unit", "How the ratio ‖A'C'‖/‖AB‖ is chosen. Adaptive: "
             "by RatioShare, for every unit anew. Fixed: by Ratio. Exact: the ratio that closes "
             "on a sphere. Paper: 1/2. TargetSnap: by TargetMargin, for every unit anew",
             list(RULES)),
        Prop("Float", "Ratio", "Unit", "Ratio ‖A'C'‖/‖AB‖ of all units (setting it chooses the "
             "rule Fixed): at least sin(theta/2) and below 1; nearer to sin(theta/2) snaps harder",
             0.5),
        Prop("Float", "RatioShare", "Unit", "For the rule Adaptive: where the ratio lies between "
             "the least one (0; sin(theta/2), more where contact panels lean) and 1; smaller snaps "
             "harder", DEFAULT_SHARE),
        Prop("Float", "HeightRatio", "Unit", "‖AB‖ / h: edge length to height of the strip", 2.5),
        Prop("Length", "Thickness", "Target snap", "Pitch of the single unit's thick panels (face "
             "thickness + gap between planes), 1.8 mm for example; a tube takes it from its "
             "triangles", 0.0),
        Prop("Float", "TargetMargin", "Target snap", "Wanted snap margin: needed play / play of "
             "the hinges. 1.8 carries a usual tube, below 1 is floppy", FIRM),
        Prop("FloatList", "UnitMargins", "Target snap", "Wanted snap margin of each unit, as "
             "aiming at a force or a load finds them; empty: TargetMargin for all", []),
        Prop("Length", "HingePlay", "Target snap", "Play of one hinge; 0.28 mm is that of the "
             "hinges' defaults, 0 that of flexible hinges", 0.28),
        Prop("Enumeration", "MarginMeasure", "Target snap", "What TargetMargin counts. Contact: "
             "play where the hinges' cones are, as the hinge set measures it. Crease: play at the "
             "creases' ends, as up to version 0.1, which takes for firm what is floppy",
             list(MEASURES), LEGACY),
        Prop("Float", "StrainLimit", "Target snap", "Largest misfit of hinges / ‖AB‖ that ratios "
             "may lead to; 0: none. What breaks is told by Stresses of the hinge set", 0.0),
        Prop("Float", "TargetBarrier", "Target snap", "Instead of a margin: wanted energy barrier "
             "of the zero-thickness units, in EA·‖AB‖; 0 aims for TargetMargin", 0.0),
        Prop("FloatConstraint", "Deployment", "State", "0 is flat-folded, 1 is deployed; both "
             "exact, between them the state of least misfit", (1.0, 0.0, 1.0, 0.05)),
        Result("FloatList", "Alphas", "Results", "Angle alpha of every unit, degrees"),
        Result("FloatList", "Betas", "Results", "Angle beta of every unit, degrees"),
        Result("FloatList", "BetaPrimes", "Results", "Angle beta' of every unit, degrees"),
        Result("FloatList", "Ratios", "Results", "Ratio ‖A'C'‖/‖AB‖ of every unit"),
        Result("FloatList", "Omegas", "Results", "Base angle ω of every unit's contact trapezoids, "
               "degrees; 90 where the legs are parallel"),
        Result("Float", "IsometryError", "Results", "Largest relative change of any edge or "
               "diagonal of a panel between flat and deployed"),
        Result("Float", "Residual", "Results", "Largest relative change of a panel edge: what the "
               "ratio rule leaves unclosed"),
        Result("FloatList", "Barriers", "Results", "Energy barrier between the two states of "
               "every unit without thickness, in EA·‖AB‖ (symmetric unit of its theta and ratio)"),
        Result("StringList", "Warnings", "Results", "Which units are floppy (thick ones, with "
               "hinges of HingePlay) or cannot reach the target, and what would help"),
    )  # fmt: skip

    def onChanged(self, obj, name):
        """Show only the inputs that count: a tube takes angle and length from its triangles."""
        super().onChanged(obj, name)
        if name == "Ratio" and self.ready(obj):
            if obj.RatioRule == "Adaptive":
                obj.RatioRule = "Fixed"  # whoever sets a ratio means it
        elif name == "TargetMargin" and self.ready(obj) and obj.UnitMargins:
            obj.UnitMargins = []  # whoever sets one for all means it
        elif name == "Triangles" and "Omega" in obj.PropertiesList:
            for prop in _ALONE:
                if prop in obj.PropertiesList:
                    obj.setEditorMode(prop, 2 if obj.Triangles else 0)

    def onDocumentRestored(self, obj):
        """Migrate, then set what the editor shows."""
        super().onDocumentRestored(obj)
        if obj.getEnumerationsOfProperty("RatioRule") != list(RULES):
            chosen = obj.RatioRule
            obj.RatioRule = list(RULES)
            obj.RatioRule = chosen
        self.onChanged(obj, "Triangles")

    def generate(self, obj):
        """Faces of all panels at `Deployment`, and the angles and ratios of the units."""
        design = design_of(obj)
        tube = design.tube()
        unit = tube.unit
        set_result(
            obj,
            Alphas=_degrees(unit.alpha),
            Betas=_degrees(unit.beta),
            BetaPrimes=_degrees(unit.beta_prime),
            Ratios=np.broadcast_to(unit.ratio, len(unit)).tolist(),
            Omegas=_degrees(
                np.broadcast_to(np.pi / 2 if unit.omega is None else unit.omega, len(unit))
            ),
            IsometryError=float(unit.isometry_error().max()),
            Residual=float(unit.residual().max()),
            Barriers=design.barriers().tolist(),
        )
        set_warnings(obj, _snap_warnings(obj, design))
        obj.Shape = _shape(obj, tube, obj.Deployment)

    def bodies_at(self, obj, opening):
        """[(name, shape, kind)] of all faces at an opening; they are of no one kind."""
        shape = _shape(obj, tube_of(obj), opening)
        shape.Placement = obj.Placement
        return [(obj.Label, shape, "")]


def _shape(obj, tube, opening):
    """Faces of a tube at an opening, in the object's own frame."""
    points = tube.state(opening)
    if obj.Triangles is not None:
        matrix = array_of(global_placement(obj).inverse())
        points = points @ matrix[:3, :3].T + matrix[:3, 3]
    return faces(points)


def tube_of(obj):
    """The `Tube` of a BistableUnit object; a single unit is a tube of one."""
    return design_of(obj).tube()


def design_of(obj):
    """`design.TubeDesign` of a BistableUnit object, in the global frame along a curve."""
    triangles = triangles_below(obj)
    where = _single(obj) if triangles is None else placing_of(triangles)
    return obj.Proxy.held(TubeDesign(where, _rule(obj, where), obj.HeightRatio))


def _snap_warnings(obj, design):
    """Sentences on units that miss the target or are floppy.

    What is said of a snap is looked up, not measured: HingeSet measures it.
    """
    tube, edge_length, pitch = design.tube(), design.edge_length, design.pitch
    theta, leaning = tube.unit.theta, tube.leaning
    warnings = []
    if design.rule.target is not None:
        warnings = design.rule.target.choose(theta, leaning).warnings
        if isinstance(design.rule.target, TargetMargin) and obj.MarginMeasure != LEGACY:
            return warnings
    if pitch > 0 and obj.HingePlay.Value > 0:
        snap = TargetMargin(edge_length, pitch, play=obj.HingePlay.Value)
        free = obj.RatioRule not in SPHERE_RULES
        warnings = [*warnings, *snap.floppy(theta, tube.unit.ratio, leaning, free)]
    return warnings


def triangles_below(obj):
    """The TrianglePlacement of a BistableUnit object, None for a single unit."""
    if linked(obj, "Triangles") is None:
        return None
    hint = phrase("choose a TrianglePlacement of this workbench, or none for a single unit")
    return require_link(obj, "Triangles", TrianglePlacement.Type, hint)


def _rule(obj, where):
    """The `RatioRule`, with the numbers that count for it only."""
    if obj.RatioRule == "TargetSnap":
        return RatioRule(obj.RatioRule, target=_target(obj, where.edge_length, where.pitch))
    number = {"Adaptive": {"share": obj.RatioShare}, "Fixed": {"ratio": obj.Ratio}}
    return RatioRule(obj.RatioRule, **number.get(obj.RatioRule, {}))


def _target(obj, edge_length, pitch):
    """What the rule TargetSnap aims for."""
    if obj.TargetBarrier:
        return TargetBarrier(obj.TargetBarrier)
    if pitch == 0 and obj.Triangles is not None:
        raise Refusal(
            "{Thickness} of {label} is 0 mm, and without thickness there is no snap margin: set "
            "it to face thickness + gap between planes, 1.8 mm for example, or aim for a "
            "{TargetBarrier}.",
            parameter="Thickness",
            label=obj.Triangles.Label,
        )
    return TargetMargin(
        edge_length,
        pitch,
        tuple(obj.UnitMargins) or obj.TargetMargin,
        obj.HingePlay.Value,
        obj.StrainLimit,
        obj.MarginMeasure,
    )


def _single(obj):
    omega = obj.Omega.Value
    if not 0 < omega <= 90:
        raise Refusal(
            "{Omega} is {omega:.6g}°: set it to 90° for a plane unit, or above 0° and below 90° "
            "for a unit on a sphere.",
            parameter="Omega",
            omega=omega,
        )
    return Single(
        math.radians(obj.Theta.Value),
        obj.EdgeLength.Value,
        np.pi / 2 if omega == 90 else math.radians(omega),
        obj.Thickness.Value,
    )


def faces(points):
    """Compound of 12 faces a unit, unit by unit, panels in the order of the crease table.

    ``points``: (n, 10, 3) vertices. A quadrilateral that is bent between the two states becomes
    the bilinear face through its corners.
    """
    panels = [[INDEX[corner] for corner in corners] for corners in PANELS.values()]
    made = []
    for unit in points:
        vectors = [App.Vector(*p) for p in unit.tolist()]
        for corners in panels:
            made.append(_face([vectors[i] for i in corners]))
    return Part.makeCompound(made)


def _face(corners):
    if len(corners) == 4:
        a, b, c, d = corners
        normal = (b - a).cross(d - a).normalize()
        if abs(normal.dot(c - a)) > _FLAT_ENOUGH:
            surface = Part.BSplineSurface()
            surface.buildFromPolesMultsKnots(
                [[a, b], [d, c]], (2, 2), (2, 2), (0, 1), (0, 1), False, False, 1, 1
            )
            return surface.toShape()
    return Part.Face(Part.makePolygon([*corners, corners[0]]))


def _degrees(radians):
    return np.degrees(np.atleast_1d(radians)).tolist()
