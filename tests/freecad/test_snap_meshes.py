# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the snap margin tells the truth: rigid bodies of exported prints, moved through space.

Where the margin is below 1 there is a way of rigid poses from flat to deployed on which nothing
overlaps; where it is above, the bodies overlap at the worst opening however they are turned.
"""

import math

import numpy as np
import pytest
from scipy.optimize import minimize

from BistableWB import make
from BistableWB.exporters import export
from BistableWB.origami.snap.clearance import least_clearance
from BistableWB.origami.snap.contact import holding, outermost
from tests.judges import judge

judge("manifold3d")

from tests.freecad.overlaps import Overlaps, pulled  # noqa: E402 (it needs the judge)

pytestmark = pytest.mark.slow

FREE = 0.002  # mm³ in all: what the facets of the meshes make of cones that just do not touch
OPENINGS = np.r_[0.0, 0.1, 0.25, np.linspace(0.4, 1.0, 13)]
HELIX = [(200 * math.cos(t), 200 * math.sin(t), 16 * t) for t in np.linspace(0, 2.2, 12)]
STEPS = 30, 15  # of the search for poses that overlap least: near margin 1, and far from it
FAR = 1.3


def plane(doc, theta, edge, share, **hinges):
    low = math.sin(math.radians(theta) / 2)
    ratio = low + share * (1 - low)
    return hinged(doc, make.make_bistable_unit(doc, None, theta, ratio, edge), hinges)


def sphere(doc, theta, edge, omega, **hinges):
    unit = make.make_bistable_unit(doc, theta=theta, edge_length=edge)
    unit.Omega, unit.RatioRule = omega, "Exact"
    return hinged(doc, unit, hinges)


def general(doc, edge, share, number, **hinges):
    curve = make.make_curve(doc, points=HELIX, kind="General")
    unit = make.make_bistable_unit(doc, make.make_triangle_placement(doc, curve, edge))
    unit.RatioShare = share
    return hinged(doc, unit, {"FirstUnit": number, "LastUnit": number, **hinges})


def hinged(doc, unit, values):
    made = make.make_hinge_set(doc, unit, process="FDM, soluble")  # bare panels
    made.Preload = 0  # margins are of the way, without preload
    if unit.Triangles:
        unit.RatioRule = "Adaptive"
    for name, value in values.items():
        setattr(made, name, value)
    return made


PINS = {"Pivot": "Pin", "FaceThickness": 2.4}
DESIGNS = {
    "called 1.50 by version 0.1": (plane, (55, 80, 0.0953), {"Segmentations": 7}, 0.98),
    "softer": (plane, (55, 80, 0.13), {"Segmentations": 7}, 0.76),
    "along a helix": (general, (60, 0.04, 2), {}, 0.69),
    "pins, loose": (plane, (55, 80, 0.10), PINS, 0.72),
    "cones of 45°, loose": (plane, (55, 80, 0.0953), {"ConeAngle": 45}, 0.78),
    "just firm": (plane, (55, 80, 0.10), {}, 1.08),
    "cones of 45°": (plane, (55, 80, 0.06), {"ConeAngle": 45}, 1.08),
    "along a helix, firm": (general, (90, 0.025, 2), {}, 1.155),
    "a little firmer": (plane, (55, 80, 0.09), {}, 1.17),
    "firm": (plane, (55, 80, 0.07), {}, 1.39),
    "pins": (plane, (55, 100, 0.05), PINS, 1.5),
    "cones of 60°": (plane, (60, 80, 0.08), {"ConeAngle": 60}, 1.72),
    "on a sphere": (sphere, (50, 90, 75), {}, 2.1),
}


class Case:
    """One design: its exported bodies, and the clearance that poses of them need."""

    def __init__(self, obj, folder):
        self.model = obj.Proxy.model(obj)
        self.thick = self.model.tube.thick
        path = export([obj], folder / "unit.3mf", assembly=True)
        lift = self.thick.gap_between_planes / 2 if obj.FirstUnit > 1 else 0.0
        self.overlaps = Overlaps(path, self.thick, self.model.tube.tube.incoming_left, lift)
        held = holding(self.thick, self.model.parameters)
        self.held = outermost(held).scaled(1 / self.thick.scale)
        self.margin = float(np.ravel(self.model.snap.margin)[0])
        self.worst = float(np.ravel(self.model.snap.margin_at)[0])

    def least(self, opening):
        """Closure and poses (1, 15, 4, 4), in edge lengths, that need least clearance."""
        closure, start = self.thick.near(np.array([0]), np.array([opening]))
        return closure, least_clearance(self.held, closure, start)[2]

    def millimetres(self, poses):
        found = poses[0].copy()
        found[:, :3, 3] *= self.thick.scale
        return found

    def least_overlap(self):
        """Smallest overlap (mm³) at the worst opening, by descent from the poses that need least.

        The slopes are those of the meshes themselves: areas that lie inside another body.
        """
        closure, base = self.least(self.worst)
        scale = self.thick.scale

        def overlap(step):
            poses = closure.moved(base, step[None] / scale)
            total, slopes = self.overlaps.with_slopes(self.millimetres(poses))
            slopes[:, 3:] *= scale
            return total, pulled(closure, poses, slopes) / scale

        start = overlap(np.zeros(83))[0]
        steps = STEPS[self.margin > FAR]
        found = minimize(
            overlap, np.zeros(83), jac=True, method="L-BFGS-B",
            options={"maxiter": steps, "maxfun": steps + 10},
        )  # fmt: skip
        return start, found.fun


@pytest.mark.parametrize("name", DESIGNS)
def test_meshes_agree_with_the_margin(doc, valid, tmp_path, name):
    make_one, values, hinges, expected = DESIGNS[name]
    obj = make_one(doc, *values, **hinges)
    valid(doc)
    case = Case(obj, tmp_path)
    assert case.margin == pytest.approx(expected, abs=0.03)
    if case.margin < 1:
        ways = [case.millimetres(case.least(opening)[1]) for opening in OPENINGS]
        ways.append(case.millimetres(case.least(case.worst)[1]))
        found = [case.overlaps.volume(poses) for poses in ways]
        print(f"{name}: margin {case.margin:.3f}, largest overlap on the way {max(found):.5f} mm³")
        assert max(found) <= FREE
        # one way: from opening to opening no body jumps
        steps = np.abs(np.diff(np.array(ways[:-1])[:, :, :3, :3], axis=0)).max((1, 2, 3))
        assert steps.max() < 0.45
    else:
        start, least = case.least_overlap()
        print(f"{name}: margin {case.margin:.3f}, overlap {start:.3f}, at the least {least:.3f}")
        assert least >= 10 * FREE
