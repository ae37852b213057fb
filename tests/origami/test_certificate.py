# SPDX-License-Identifier: LGPL-2.1-or-later
"""No tube leaves the mathematics broken: it is measured, whoever made it."""

from dataclasses import replace

import numpy as np
import pytest

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.design import CurveGeometry, Placing, TubeDesign
from BistableWB.origami.errors import Refusal
from BistableWB.origami.units.certificate import certified, shared_panel_gaps
from BistableWB.origami.units.ratios import RatioRule

PLANE = ("parallel", (0.0, 0.0, 1.0))
ARCH = CurveGeometry(Bezier([[0, 0, 0], [60, 120, 0], [180, 120, 0], [240, 0, 0]]), "Plane", PLANE)
BACK = CurveGeometry(Bezier([[0, 0, 0], [500, 0, 0], [100, 0, 0]]), "Plane", PLANE)
LINE = CurveGeometry(Bezier([[0, 0, 0], [500, 0, 0]]), "Plane", PLANE)


def design(geometry, gamma=20.0, pitch=0.0):
    return TubeDesign(Placing(geometry, 40.0, np.radians(gamma), pitch=pitch), RatioRule())


@pytest.mark.parametrize("pitch", [0.0, 1.8])
def test_a_good_tube_passes_and_one_unit_moved_aside_does_not(pitch):
    tube = design(ARCH, pitch=pitch).tube()
    assert certified(tube, 40.0, pitch) is tube
    frames = tube.frames.copy()
    frames[5, 0, 3] += 0.34 * 40
    with pytest.raises(Refusal, match="Units 5 and 6 do not join") as refused:
        certified(replace(tube, frames=frames), 40.0, pitch)
    assert refused.value.parameter == "EdgeLength"


def test_neighbours_share_their_panels_to_rounding():
    tube = design(ARCH).tube()
    assert shared_panel_gaps(tube, tube.deployed()).max() < 1e-12 * 40


def test_what_is_no_number_is_refused():
    tube = design(ARCH).tube()
    frames = tube.frames.copy()
    frames[2, 1, 3] = np.nan
    with pytest.raises(Refusal, match="Unit 3 cannot be computed"):
        certified(replace(tube, frames=frames), 40.0, 0.0)


def test_nearly_flat_units_are_refused_before_they_are_wrong():
    """At γ 89.99° panels changed by 1e-8 of their size, and a unit lay beside its neighbour.

    How much just there is a matter of rounding (6e-10 with other libraries): a tenth nearer to 90°
    it is never right.
    """
    with pytest.raises(Refusal, match=r"exactly enough: .* keep Gamma further") as refused:
        design(LINE, 89.999).tube()
    assert refused.value.parameter == "Gamma"
    with pytest.raises(Refusal):
        design(BACK, 89.999).tube()
