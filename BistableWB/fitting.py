# SPDX-License-Identifier: LGPL-2.1-or-later
"""Auto-fit in a document: proposals for a TrianglePlacement object, and applying one.

    from BistableWB import fitting
    fit = fitting.auto_fit(triangles, bed=(250, 210, 210), margin=1.5)
    fitting.apply(fit.recommended, triangles, unit, fit.wanted)

How the search goes: `origami.auto_fit`.
"""

import math

from .objects.triangle_placement import TrianglePlacement, geometry_below
from .origami import auto_fit as search
from .origami.auto_fit import Wanted


def auto_fit(triangles, bed=(250.0, 210.0, 210.0), margin=1.5, progress=None, **wishes):
    """Designs along the curve of ``triangles`` that fit a print bed and snap.

    ``bed``: x, y, z in mm; ``margin``: smallest snap margin; ``wishes``: further fields of
    `origami.auto_fit.Wanted`: face_thickness, gap_between_planes and play (mm), strain_limit,
    height_ratio. ``progress(fraction, text)`` may raise to cancel. Changes nothing in the
    document. Returns an `origami.auto_fit.Fit`; ValueError where nothing fits.
    """
    found = getattr(getattr(triangles, "Proxy", None), "Type", "")
    if found != TrianglePlacement.Type:
        raise ValueError("Auto-fit: choose the TrianglePlacement whose curve is to be followed.")
    geometry = geometry_below(triangles)
    course = search.Course(
        geometry.curve,
        geometry.family,
        geometry.legs,
        geometry.sphere_radius,
        triangles.FlipSide,
        triangles.Level,
    )
    wanted = Wanted(bed=tuple(float(x) for x in bed), margin=float(margin), **wishes)
    return search.auto_fit(course, wanted, progress)


def apply(candidate, triangles, unit=None, wanted=None, hinges=None):
    """Set the inputs of a TrianglePlacement, a BistableUnit and a HingeSet to a candidate's.

    ``wanted``: the `Wanted` of the search, for thickness, play and margin. The document is not
    recomputed.
    """
    wanted = wanted or Wanted()
    triangles.EdgeLength = candidate.edge_length
    triangles.Gamma = math.degrees(candidate.gamma)
    triangles.Thickness = wanted.pitch
    if hinges is not None:
        hinges.FaceThickness = wanted.face_thickness
        hinges.GapBetweenPlanes = wanted.gap_between_planes
    if unit is None:
        return
    unit.HeightRatio = wanted.height_ratio
    unit.RatioRule = candidate.rule
    if candidate.share is not None:
        unit.RatioShare = candidate.share
    if candidate.rule == "TargetSnap":
        unit.TargetBarrier = 0.0
        unit.TargetMargin = wanted.margin
        unit.HingePlay = wanted.play
        unit.StrainLimit = wanted.strain_limit
