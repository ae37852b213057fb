# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a HingeSet is made of, how it is held, and how it then snaps, wobbles and stands.

The results take about a second a unit; a recompute does not wait for them: it empties what no
longer holds, and `measure` (a macro, the report, the charts) fills them.
"""

import FreeCAD as App
import numpy as np

from ..origami.progress import NOBODY
from ..origami.snap.materials import MATERIALS, material
from ..origami.snap.study import Conditions, study
from .base import Prop, Result, set_result

STRENGTH_PROPERTIES = (
    Prop("Enumeration", "Material", "Strength", "What the panels are made of: stiffness, weight "
         "and strength", list(MATERIALS)),
    Prop("Float", "YoungsModulus", "Strength", "Young's modulus of your own material, MPa; 0: that "
         "of Material", 0.0),
    Prop("Float", "Density", "Strength", "Density of your own material, g/cm³; 0: that of Material",
         0.0),
    Prop("Float", "Strength", "Strength", "Tensile strength of your own material along its layers, "
         "MPa; 0: that of Material", 0.0),
    Prop("Vector", "Gravity", "Strength", "Direction of gravity for the deployed tube, in the "
         "frame of the flat print with its first block at rest", App.Vector(0, 0, -1)),
    Prop("Enumeration", "FixedAt", "Strength", "Where the deployed tube is held: at its first "
         "block, or at both ends", ["Start", "Both"]),
)  # fmt: skip
STRENGTH_RESULTS = (
    Result("FloatList", "Barriers", "Strength results", "Energy that opening takes, N·mm, of "
           "every unit"),
    Result("FloatList", "ClosingBarriers", "Strength results", "Energy that folding back takes, "
           "N·mm, of every unit"),
    Result("FloatList", "HandForces", "Strength results", "Force of a hand that opens a unit, N, "
           "‖AB‖ from the leg at B"),
    Result("FloatList", "Stresses", "Strength results", "Largest stress in a knuckle's root on the "
           "way, as a share of what the material bears, of every unit; above 1 it breaks"),
    Result("FloatList", "FreeBends", "Strength results", "Free turn of every deployed unit about "
           "its leg at B to either side, degrees"),
    Result("FloatList", "FreeTwists", "Strength results", "Free twist of every deployed unit to "
           "either side, degrees"),
    Result("Length", "EndSlop", "Strength results", "How far the deployed tube's free end moves "
           "before anything bears"),
    Result("Float", "Weight", "Strength results", "Weight of the tube, g"),
    Result("FloatList", "SafetyFactors", "Strength results", "Safety of every deployed unit "
           "against folding under the tube's weight; below 1 it folds"),
    Result("Float", "LeastSafety", "Strength results", "Least safety of all units, whatever way "
           "the deployed tube is turned"),
    Result("Float", "FreeLoad", "Strength results", "Extra load at the free end that the deployed "
           "tube bears, in the direction of gravity, N"),
)  # fmt: skip
_LISTS = tuple(prop.name for prop in STRENGTH_RESULTS if prop.kind == "FloatList")


def conditions_of(obj) -> Conditions:
    """`Conditions` of a HingeSet object; refuses numbers that cannot be."""
    own = material(obj.Material).edited(
        young=obj.YoungsModulus, density=obj.Density, strength=obj.Strength
    )
    return Conditions(own, obj.Orientation, tuple(obj.Gravity), obj.FixedAt)


def measured(obj, model, progress=NOBODY):
    """The `Study` of a HingeSet's model, from memory if nothing has changed since."""
    conditions = conditions_of(obj)
    if model.studied is None or model.studied[0] != conditions:
        model.studied = conditions, study(model.tube, model.parameters, conditions, progress)
    return model.studied[1]


def task(obj, model):
    """What `measured` does, to be done beside the window: conditions, and work(progress)."""
    conditions = conditions_of(obj)

    def work(progress):
        return study(model.tube, model.parameters, conditions, progress)

    return conditions, work


def refresh(obj, model):
    """Write the results if they are known and still hold, else empty them."""
    known = model.studied is not None and model.studied[0] == conditions_of(obj)
    write(obj, model.studied[1] if known else None)


def write(obj, found):
    """Write the results of a `Study`, or empty them (None)."""
    if found is None:
        set_result(
            obj, **{name: [] for name in _LISTS}, Weight=0.0, FreeLoad=0.0, LeastSafety=0.0,
            EndSlop=_length(0),
        )  # fmt: skip
        return
    units = found.units
    set_result(
        obj,
        Barriers=[unit.barrier for unit in units],
        ClosingBarriers=[unit.closing_barrier for unit in units],
        HandForces=[unit.hand for unit in units],
        Stresses=[unit.weakest.share for unit in units],
        FreeBends=np.degrees(found.slop.bend).tolist(),
        FreeTwists=np.degrees(found.slop.twist).tolist(),
        EndSlop=_length(found.slop.end),
        Weight=found.load.weight,
        SafetyFactors=found.load.factors.tolist(),
        LeastSafety=found.load.turned.min(),
        FreeLoad=found.load.free,
    )


def _length(value):
    return App.Units.Quantity(float(value), App.Units.Length)
