# SPDX-License-Identifier: LGPL-2.1-or-later
"""Auto-fit in a document: proposals for the tube along a curve, and applying one.

    from BistableWB import fitting
    fit = fitting.auto_fit(triangles, bed=(250, 210, 210), margin=1.5)
    fitting.apply(fit.recommended, triangles, unit, fit.wanted)

How the search goes: `fit.search`.
"""

import math

from .objects import type_of
from .objects.base import require_link
from .objects.bistable_unit import BistableUnit
from .objects.curve import Curve, geometry_of
from .objects.triangle_placement import TrianglePlacement, geometry_below
from .origami.curves.rules import PAPER
from .origami.errors import Refusal, phrase
from .origami.fit import aiming, search
from .origami.fit.search import Wanted
from .origami.fit.terms import design_of
from .origami.progress import NOBODY, Progress
from .origami.snap.table import CONTACT
from .printable import Made, chain_of, follow_gentler, make_printable, proposed, request_of

__all__ = [
    "Made", "aim", "aim_task", "apply", "auto_fit", "chain_of", "course_of", "follow_gentler",
    "inputs_of", "make_printable", "proposed", "request_of", "tube_of",
]  # fmt: skip


def auto_fit(source, bed=(250.0, 210.0, 210.0), margin=1.5, progress=None, **requirements):
    """Designs along the curve of ``source`` that fit a print bed and snap.

    ``source``: a TrianglePlacement or a Curve; ``bed``: x, y, z in mm; ``margin``: smallest snap
    margin; ``requirements``: further fields of `search.Wanted`: face_thickness,
    gap_between_planes and play (mm), strain_limit, height_ratio. ``progress``: a `Progress`, or
    a function ``progress(fraction, text)``. Changes nothing in the document. Returns a
    `search.Fit`; ValueError where nothing fits.
    """
    wanted = Wanted(bed=tuple(float(x) for x in bed), margin=float(margin), **requirements)
    if progress is not None and not isinstance(progress, Progress):  # as macros of 0.1.0 may
        told = progress
        progress = Progress(lambda text, fraction: told(fraction, text))
    return search.auto_fit(course_of(source), wanted, progress or NOBODY)


def aim(hinges, carry=0.0, force=0.0, progress=None):
    """Give the units of a HingeSet the ratios with which they carry the tube, or snap as hard.

    ``carry``: factor by which every unit carries what hangs on it, whatever way the tube is turned;
    or ``force``: N of a hand that opens a unit, ‖AB‖ from the leg at B. Sets UnitMargins of the
    BistableUnit, one step of undo, and recomputes. Some seconds a unit; ``progress``: a `Progress`.
    Returns `aiming.Aimed`; `Refusal`, and nothing is changed, where it cannot be reached.
    """
    work, keep = aim_task(hinges, carry, force)
    found = work(progress or NOBODY)
    keep(found)
    return found


def aim_task(hinges, carry=0.0, force=0.0):
    """`aim` in two parts: ``work(progress)``, which touches no document, and ``keep(its result)``.

    What cannot be aimed at is refused at once.
    """
    hint = phrase("choose a BistableUnit")
    unit = require_link(hinges, "Unit", BistableUnit.Type, hint)
    wanted = aiming.Aim(float(carry), float(force))
    wanted.check()
    given = hinges.Proxy.aiming(hinges)

    def keep(found):
        doc = hinges.Document
        doc.openTransaction("Aim the snap")
        unit.RatioRule, unit.TargetBarrier, unit.MarginMeasure = "TargetSnap", 0.0, CONTACT
        unit.UnitMargins = list(found.margins)
        doc.recompute()
        doc.commitTransaction()

    return lambda progress: aiming.aimed(*given, wanted, progress), keep


def course_of(source):
    """The `search.Course` of a TrianglePlacement or Curve object; ValueError for others.

    Nothing of it is the document's: a search may go on while the document changes.
    """
    if type_of(source) == Curve.Type:
        geometry, start = geometry_of(source), ()
    elif type_of(source) == TrianglePlacement.Type:
        geometry, start = geometry_below(source), (source.FlipSide, source.Level)
    else:
        raise Refusal(
            "Auto-fit: choose the TrianglePlacement, or the Curve, that is to be followed."
        )
    return search.Course(
        geometry.curve, geometry.family, geometry.legs, geometry.sphere_radius, *start
    )


def tube_of(candidate, course, wanted):
    """The `Tube` that a candidate proposes along a `Course`, to look at it before it is applied."""
    return design_of(course, candidate, wanted).tube()


def inputs_of(candidate, wanted):
    """What a candidate sets: {"triangles" | "unit" | "hinges": {property: value}}, mm and degrees.

    In this order: a ratio's rule comes before what it goes by. Candidates are placed by the paper's
    rule: another one would take other angles, and perhaps another number of units.
    """
    triangles = {
        "PlacementRule": PAPER.name,
        "EdgeLength": candidate.edge_length,
        "Gamma": math.degrees(candidate.gamma),
        "Thickness": wanted.pitch,
    }
    unit = {"HeightRatio": wanted.height_ratio, "RatioRule": candidate.rule}
    if candidate.share is not None:
        unit["RatioShare"] = candidate.share
    if candidate.rule == "TargetSnap":
        unit |= {
            "TargetBarrier": 0.0,
            "TargetMargin": wanted.margin,
            "HingePlay": wanted.play,
            "MarginMeasure": CONTACT,
            "StrainLimit": wanted.strain_limit,
        }
    parameters = wanted.parameters
    hinges = {
        "FaceThickness": wanted.face_thickness,
        "GapBetweenPlanes": wanted.gap_between_planes,
        "GapLength": parameters.gap_length,
        "Pivot": parameters.pivot,
        "ConeAngle": math.degrees(parameters.cone_angle),
    }
    if parameters.segment_width:
        hinges["SegmentWidth"] = parameters.segment_width
    else:
        hinges["Segmentations"] = parameters.segmentations
    return {"triangles": triangles, "unit": unit, "hinges": hinges}


def apply(candidate, triangles, unit=None, wanted=None, hinges=None):
    """Set the inputs of a TrianglePlacement, a BistableUnit and a HingeSet to a candidate's.

    ``wanted``: the `Wanted` of the search, for thickness, play and margin. The document is not
    recomputed.
    """
    objects = {"triangles": triangles, "unit": unit, "hinges": hinges}
    for which, inputs in inputs_of(candidate, wanted or Wanted()).items():
        if objects[which] is not None:
            for name, value in inputs.items():
                setattr(objects[which], name, value)
