# SPDX-License-Identifier: LGPL-2.1-or-later
"""HingeSet: a tube of thick panels with print-in-place hinges, as it is printed and as it opens."""

from dataclasses import replace

import FreeCAD as App
import numpy as np

from ..origami.design import Placing, Thickness
from ..origami.errors import Refusal, phrase
from ..origami.hinges.bed import Bed, split
from ..origami.hinges.ends import stands_out
from ..origami.hinges.parameters import ROTATIONAL
from ..origami.progress import NOBODY, Cancelled
from ..origami.snap.study import refuse_flexible
from . import later
from .base import (
    Hidden,
    OfShape,
    Prop,
    Result,
    frame_placement,
    require_link,
    set_result,
    set_warnings,
)
from .bistable_unit import BistableUnit, design_of
from .curve import placed as placed_by
from .end_inputs import END_PROPERTIES, ends_of
from .hinge_inputs import (
    HINGE_PROPERTIES,
    STANDOFF_PROPERTIES,
    apply_process,
    count_segments,
    hinge_parameters,
)
from .later import LIVE, ON_DEMAND
from .print_limits import check_bed_of, check_feet
from .self_drawn import BODY_RESULTS, SelfDrawn, body_results
from .snap_results import (
    STRENGTH_PROPERTIES,
    STRENGTH_RESULTS,
    conditions_of,
    measured,
    refresh,
    task,
    write,
)
from .thick_model import Order

AUTOMATIC, GIVEN = "Automatic", "Given"
_KEPT = 2  # models: this one, and the one before for undo


class HingeSet(SelfDrawn):
    """Every panel, link and contact block of a tube as a solid, in one stack for the print bed."""

    Type = "Bistable::HingeSet"
    asked = False  # whether solids are wanted now, whatever Update says
    _made: dict = {}
    _shown = None  # what the Shape was made from, last
    PROPERTIES = (
        Prop("Link", "Unit", "Hinge", "BistableUnit whose panels become thick"),
        *HINGE_PROPERTIES,
        *STANDOFF_PROPERTIES,
        Prop("Bool", "Compensate", "Hinge", "Shift the hinge axes so that the thick panels close "
             "exactly when deployed; without it they do not snap", True),
        Prop("Enumeration", "PreloadRule", "Hinge", "Automatic: hinges of every deployed unit take "
             "up as much play as it needs for its cones to bear and hold it; none where hinges "
             "have three knuckles: their cones are far from the ends of hinges, and panels would "
             "press into each other. Given: Preload says how much",
             [AUTOMATIC, GIVEN], GIVEN),
        Prop("FloatConstraint", "Preload", "Hinge", "How much of their play hinges of a deployed "
             "unit take up: 0 none, it wobbles; 1 about all (setting it sets PreloadRule to Given)",
             (0.0, 0.0, 1.5, 0.1)),
        *STRENGTH_PROPERTIES,
        *END_PROPERTIES,
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
        Prop("Enumeration", "Update", "State", "When solids follow in the window. Live: beside "
             "it, as soon as anything changes. OnDemand: the old ones stay, grey, until they are "
             "asked for; without a window they always follow", [LIVE, ON_DEMAND]),
        Prop("FloatConstraint", "Deployment", "State", "0 is the flat-folded print on the bed, 1 "
             "is deployed along the curve", (0.0, 0.0, 1.0, 0.05)),
        *BODY_RESULTS,
        OfShape("Bool", "UpToDate", "Results", "Whether the solids are those of the inputs", True),
        Hidden("String", "MadeFrom", "Results", "Which inputs the solids were made from"),
        Result("Vector", "PrintSize", "Results", "Length, width and height of the print, mm"),
        Result("Vector", "DeployedSize", "Results", "Length, width and height when deployed, mm"),
        Result("Length", "CurveDeviation", "Results", "Largest distance of a deployed contact "
               "block from its place on the curve"),
        Result("Length", "DeployedMisfit", "Results", "Largest misfit of a hinge when "
               "deployed, apart from its preload"),
        Result("FloatList", "SnapMargins", "Results", "Clearance with which a unit would open "
               "freely / clearance of its hinges, for every unit, measured where its cones or pins "
               "are; below 1 a unit is floppy. Infinite for strips, which have no play: Barriers "
               "tell"),
        Result("FloatList", "Preloads", "Results", "Play that hinges of every deployed unit take "
               "up, in gap lengths: what Preload says, or what was found"),
        *STRENGTH_RESULTS,
        Result("StringList", "Warnings", "Results", "What to look at before printing"),
    )  # fmt: skip

    def onChanged(self, obj, name):
        """Whoever sets the number of knuckles means it."""
        super().onChanged(obj, name)
        if self.ready(obj):
            count_segments(obj, name)
            if name == "Preload" and obj.PreloadRule == AUTOMATIC:
                obj.PreloadRule = GIVEN
            apply_process(obj, name)

    def conditions(self, obj):
        """`snap.study.Conditions` that `measure` studies the tube under."""
        return conditions_of(obj)

    def aiming(self, obj):
        """Thick design, hinges and conditions of the tube, for `aiming.aimed`.

        Refuses hinges that have no cones.
        """
        order = self.order(obj)
        refuse_flexible(order.parameters)
        return order.design, order.parameters, conditions_of(obj)

    def measure(self, obj, progress=NOBODY):
        """`snap.study.Study` of the tube, written to the results; about a second a unit."""
        found = measured(obj, self.model(obj), progress)
        write(obj, found)
        return found

    def study(self, obj):
        """The `snap.study.Study` that still holds, or None."""
        model = self._known(self.order(obj))
        if model is None or model.studied is None or model.studied[0] != conditions_of(obj):
            return None
        return model.studied[1]

    def study_task(self, obj):
        """What `measure` does, for a thread beside the window: work(progress), and keep(study)."""
        model = self.model(obj)
        conditions, work = task(obj, model)

        def keep(found):
            model.studied = conditions, found
            if self._known(self.order(obj)) is model:
                refresh(obj, model)

        return work, keep

    def generate(self, obj):
        """Solids at `Deployment`; they are made anew only if more than that has changed.

        In the window they are made aside where nobody waits for them (`later`), or not at all
        until they are asked for; meanwhile the old ones stay.
        """
        order = self.order(obj)
        if not 0 <= obj.Deployment <= 1:
            raise Refusal(
                "{Deployment} is {opening:.6g}: it must lie between 0 and 1.",
                parameter="Deployment",
                opening=obj.Deployment,
            )
        if self._known(order) is None and later.nobody_waits():
            is_wanted = self.asked or obj.Update == LIVE
            if not (is_wanted and later.runner.begin(obj, order, self._work(obj, order))):
                set_result(obj, UpToDate=False)
                return
        try:
            model = self.model(obj)
        except Cancelled:
            set_result(obj, UpToDate=False)
            return
        if not (model.is_measured or self._measures_later(obj, order, model)):
            model.measured()
        self._publish(obj, order, model)

    @staticmethod
    def _measures_later(obj, order, model):
        """Whether margins follow their solids, aside."""
        if not later.nobody_waits():
            return False
        later.runner.begin(obj, ("margins", order), model.measured, follows=True)
        return True

    def _publish(self, obj, order, model):
        margins = np.atleast_1d(model.snap.margin).tolist() if model.is_measured else []
        set_result(
            obj,
            **body_results(model.bodies),
            PrintSize=App.Vector(*model.print_size(obj.Orientation)),
            DeployedSize=App.Vector(*model.deployed_size),
            CurveDeviation=_length(model.deviation),
            DeployedMisfit=_length(model.deployed_misfit),
            SnapMargins=margins,
            Preloads=model.preloads,
        )
        refresh(obj, model)
        set_warnings(obj, model.warnings)
        shown = order.digest, obj.Deployment, obj.Orientation
        if self._shown != shown or obj.MadeFrom != shown[0]:
            obj.Shape = model.compound(obj.Deployment, obj.Orientation)
            self._shown = shown
        set_result(obj, MadeFrom=order.digest, UpToDate=True)

    def export_bodies(self, obj):
        """[(name, shape, kind), …] of the flat print as it stands, whatever `Deployment`."""
        model, named = self.model(obj), self.bodies_at(obj, 0)
        if obj.Support:
            body = model.support()
            body.Placement = model.standing(obj.Orientation) * body.Placement
            named.append(("support", body, "support"))
        if model.has_ties(obj.Orientation) and model.tied().ties:
            named.append(("ties", model.tie_shape(), "foot"))
        if model.has_pillars(obj.Orientation) and self._propped(obj, model).pillars:
            named.append(("pillars", model.pillar_shape(), "foot"))
        return named

    def _propped(self, obj, model):
        """`Model.propped`, in the window with progress and Esc: `Cancelled`."""
        if later.runner is not None and not model.is_propped:
            order = self.order(obj)
            if not model.is_measured:  # aside they may be on the way: one job at a time
                later.runner.wait(obj, ("margins", order), model.measured)
                self._publish(obj, order, model)
            later.runner.wait(obj, ("pillars", order), model.with_pillars)
        return model.propped()

    def bodies_at(self, obj, opening):
        """[(name, shape, kind), …] at an opening; flexures, which bend, are there at 0 only."""
        model = self.model(obj)
        shapes = model.shapes(opening, obj.Orientation)
        shown = [body for body in model.bodies if opening == 0 or body.members or body.seat]
        return [(body.name, shape, body.kind) for body, shape in zip(shown, shapes, strict=True)]

    def model(self, obj):
        """The `Model` of a HingeSet object, from memory if nothing that shapes it has changed.

        In the window Esc stops it: `Cancelled`.
        """
        order = self.order(obj)
        model = self._known(order)
        if model is None:
            work = self._work(obj, order)
            made = work(NOBODY) if later.runner is None else later.runner.wait(obj, order, work)
            self.take(order, made)
            model = self._known(order)
        check_bed_of(model.tube, order)
        check_feet(model.bodies, order)
        return model

    @staticmethod
    def _work(obj, order):
        """What makes the model of an order: from the solids of the Shape, if they are its own."""
        saved = obj.Shape.Solids if obj.MadeFrom == order.digest else ()
        state = obj.Deployment, obj.Orientation

        def made(progress):
            model = order.made(progress, saved)
            model.compound(*state)  # while nobody waits
            return model

        return made

    def order(self, obj):
        """What a HingeSet object asks for, the `Order` that its model is made by."""
        unit = require_link(obj, "Unit", BistableUnit.Type, phrase("choose a BistableUnit"))
        parameters = hinge_parameters(obj)
        if parameters.rotation_angle:
            raise Refusal(
                "{RotationAngle} is {angle:.6g}°: a tube is printed flat-folded, set it "
                "to 0°; coupons can be printed partly open.",
                parameter="RotationAngle",
                angle=obj.RotationAngle.Value,
            )
        return Order(
            self.held(thick_design(obj, unit, parameters)),
            parameters,
            (obj.FirstUnit, obj.LastUnit),
            (tuple(obj.Bed), obj.Orientation),
            getattr(unit.Triangles, "Label", ""),
            ends_of(obj),
        )

    def take(self, order, model, error=None):
        """Keep what was made by an order: its `Model`, or the error that ended it.

        Margins stay with the model that they were measured of.
        """
        if not isinstance(order, Order):
            if error is None:
                return
            order = order[1]
        self._made = {order: error or model} | self._made
        for old in list(self._made)[_KEPT:]:
            del self._made[old]

    def _known(self, order):
        """The `Model` of an order that was made lately, or None; its error is raised again."""
        found = self._made.get(order)
        if isinstance(found, Exception):
            raise found
        return found


def parts_for(obj, bed):
    """Runs of units [(first, last)], from 0, that a ``bed`` (x, y, z mm) holds; [] if not one."""
    parameters = hinge_parameters(obj)
    tube = thick_design(obj, obj.Unit, parameters).thick()
    on_edge = obj.Orientation == "OnEdge"
    more = stands_out(ends_of(obj), parameters, tube.is_closed)
    return split(tube.thick, parameters, Bed(*bed), tube.tube.incoming_left, on_edge, more)


def thick_design(obj, unit, parameters):
    """The `TubeDesign` of a HingeSet object on a BistableUnit: the unit's, with thickness.

    Along a curve it stands in the frame of the Parts that the HingeSet is in: a Part's placement
    moves the Shape once, not twice.
    """
    design, back = design_of(unit), frame_placement(obj).inverse()
    where = design.where
    if isinstance(where, Placing) and not back.isIdentity():
        where = replace(where, geometry=placed_by(where.geometry, back))
    preload = _preload(obj, parameters)
    panels = Thickness(
        parameters.face_thickness,
        parameters.gap_between_planes,
        obj.Compensate,
        preload,
        None if preload == 0 else parameters,
    )
    return replace(design, where=where, thickness=panels)


def _preload(obj, parameters):
    """Gap (mm) that hinges with play take up when deployed; None: what each unit needs."""
    if not 0 <= obj.Preload <= 1.5:
        raise Refusal(
            "{Preload} is {value:.6g}: it must lie between 0 (none) and 1.5.",
            parameter="Preload",
            value=obj.Preload,
        )
    if not (obj.Compensate and parameters.hinge_type == ROTATIONAL):
        return 0.0
    return None if obj.PreloadRule == AUTOMATIC else obj.Preload * parameters.gap_length


def _length(value):
    return App.Units.Quantity(float(value), App.Units.Length)
