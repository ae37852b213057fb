# SPDX-License-Identifier: LGPL-2.1-or-later
"""Auto-fit in a document: proposals for the tube along a curve, and applying one.

    from BistableWB import fitting
    fit = fitting.auto_fit(triangles, bed=(250, 210, 210), margin=1.5)
    fitting.apply(fit.recommended, triangles, unit, fit.wanted)

How the search goes: `origami.auto_fit`.
"""

import math

from .objects import type_of
from .objects.curve import Curve, geometry_of
from .objects.triangle_placement import TrianglePlacement, geometry_below
from .origami import auto_fit as search
from .origami import tube as tubes
from .origami.auto_fit import Wanted
from .origami.placement import place


def auto_fit(source, bed=(250.0, 210.0, 210.0), margin=1.5, progress=None, **wishes):
    """Designs along the curve of ``source`` that fit a print bed and snap.

    ``source``: a TrianglePlacement or a Curve; ``bed``: x, y, z in mm; ``margin``: smallest snap
    margin; ``wishes``: further fields of `origami.auto_fit.Wanted`: face_thickness,
    gap_between_planes and play (mm), strain_limit, height_ratio. ``progress(fraction, text)`` may
    raise to cancel. Changes nothing in the document. Returns an `origami.auto_fit.Fit`; ValueError
    where nothing fits.
    """
    wanted = Wanted(bed=tuple(float(x) for x in bed), margin=float(margin), **wishes)
    return search.auto_fit(course_of(source), wanted, progress)


def course_of(source):
    """The `origami.auto_fit.Course` of a TrianglePlacement or Curve object; ValueError for others.

    Nothing of it is the document's: a search may go on while the document changes.
    """
    if type_of(source) == Curve.Type:
        geometry, start = geometry_of(source), ()
    elif type_of(source) == TrianglePlacement.Type:
        geometry, start = geometry_below(source), (source.FlipSide, source.Level)
    else:
        raise ValueError(
            "Auto-fit: choose the TrianglePlacement, or the Curve, that is to be followed."
        )
    return search.Course(
        geometry.curve, geometry.family, geometry.legs, geometry.sphere_radius, *start
    )


def tube_of(candidate, course, wanted):
    """The `Tube` that a candidate proposes along a `Course`, to look at it before it is applied."""
    placed = place(
        course.curve,
        candidate.edge_length,
        candidate.gamma,
        wanted.pitch,
        course.legs,
        course.flip,
        level=course.level,
    )
    rule = search.rule_of(candidate.rule, candidate.share, wanted, candidate.edge_length)
    return tubes.along(placed, course.family, wanted.height_ratio, rule, course.sphere_radius)


def inputs_of(candidate, wanted):
    """What a candidate sets: {"triangles" | "unit" | "hinges": {property: value}}, mm and degrees.

    In this order: a ratio's rule comes before what it goes by.
    """
    triangles = {
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
            "StrainLimit": wanted.strain_limit,
        }
    hinges = {
        "FaceThickness": wanted.face_thickness,
        "GapBetweenPlanes": wanted.gap_between_planes,
    }
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
