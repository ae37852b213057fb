"""Tubes in any state: chained by shared contact panels, exact at both ends."""

import numpy as np
import pytest

from BistableWB.origami import unit as units
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.units import tube as tubes
from BistableWB.origami.units.creases import INDEX, PANELS
from BistableWB.origami.units.deployment import misfit, opening_state, panel_strains
from BistableWB.origami.units.ratios import RatioRule

ARCH = [(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)]


class OnSphere:
    def point(self, s):
        t = np.asarray(s, float) * 1.8
        p = np.stack([np.cos(t), np.sin(t), 0.4 * np.sin(2 * t)], -1)
        return 120 * p / np.linalg.norm(p, axis=-1, keepdims=True)


def plane_tube(pitch=0.0):
    placed = place(Bezier(ARCH), 40, np.radians(20), pitch)
    return placed, tubes.along(placed, "Plane", 2.5, RatioRule("Fixed", 0.5))


def sphere_tube():
    placed = place(OnSphere(), 40, np.radians(20), legs=("point", (0, 0, 0)))
    return placed, tubes.along(placed, "Sphere", 2.5, RatioRule("Exact"), sphere_radius=120)


def shared(tube, points, k, which):
    """Corners A_u, B_u, B_l, A_l of the incoming or outgoing contact panel of unit k."""
    left = tube.incoming_left[k] == (which == "incoming")
    return points[k][[INDEX[c] for c in PANELS["contact_left" if left else "contact_right"]]]


@pytest.mark.parametrize("make", [plane_tube, sphere_tube])
@pytest.mark.parametrize("opening", [0, 0.01, 0.4, 0.9, 1])
def test_units_share_their_contact_panels(make, opening):
    _, tube = make()
    points = tube.state(opening)
    for k in range(len(tube) - 1):
        out, into = shared(tube, points, k, "outgoing"), shared(tube, points, k + 1, "incoming")
        assert out == pytest.approx(into[[1, 0, 3, 2]], abs=1e-9)  # A and B change sides


@pytest.mark.parametrize("make", [plane_tube, sphere_tube])
def test_both_ends_are_isometric_and_flat_is_flat(make):
    _, tube = make()
    assert tube.unit.isometry_error().max() <= 1e-12
    for opening in (0, 1):
        assert misfit(tube.unit, tube.state(opening)).max() < 1e-11
    flat = tube.state(0).reshape(-1, 3)
    assert np.linalg.svd(flat - flat.mean(0))[1][2] < 1e-9


def test_deployed_tube_follows_the_zigzag():
    placed, tube = plane_tube()
    points = tube.deployed()
    for k in range(len(tube)):
        into = shared(tube, points, k, "incoming")
        assert into[[0, 3]].mean(0) == pytest.approx(placed.points[k], abs=1e-9)
        assert into[[1, 2]].mean(0) == pytest.approx(placed.points[k + 1], abs=1e-9)


def test_sphere_tube_has_its_outer_corners_on_the_zigzag():
    placed, tube = sphere_tube()
    points = tube.deployed()
    for k in range(len(tube)):
        into = shared(tube, points, k, "incoming")
        assert into[:2] == pytest.approx(placed.points[k : k + 2], abs=1e-9)


def test_misfit_between_is_positive_and_smallest():
    """The state between is a minimum: any small change of it only adds squared misfit."""
    unit = units.plane_unit(np.radians(45), 0.42, 40, 16)
    points = opening_state(unit, 0.6)
    best = squared(unit, points)
    assert best > 1e-3
    rng = np.random.default_rng(1)
    free = [INDEX[v] for v in ("C_upper", "C_lower", "P_upper", "P_lower")]
    for _ in range(50):
        other = points.copy()
        other[free] += rng.normal(0, 1e-4, (4, 3))
        assert squared(unit, other) >= best * (1 - 1e-9)


def squared(unit, points):
    return ((units.bar_lengths(points) - units.bar_lengths(unit.flat)) ** 2).sum()


def test_opening_turns_the_contact_panels_by_the_prescribed_angle():
    unit = units.plane_unit(np.radians(45), 0.42, 40, 16)
    for opening in np.linspace(0, 1, 6):
        points = opening_state(unit, opening)
        b, left, right = (points[INDEX[f"{v}_upper"]] for v in ("B", "A_left", "A_right"))
        cosine = (left - b) @ (right - b) / 1600
        assert np.degrees(np.arccos(min(cosine, 1))) == pytest.approx(45 * opening, abs=1e-5)
        assert left[1] <= right[1]


def test_path_is_continuous():
    _, tube = plane_tube()
    before = tube.unit.flat
    for opening in np.linspace(0, 1, 101):
        points = opening_state(tube.unit, opening)
        assert np.abs(points - before).max() < 1.0  # mm per 1 %
        before = points


def test_thick_placement_centres_units_in_their_double_hinges():
    placed, tube = plane_tube(pitch=1.8)
    points = tube.deployed()
    middle = (placed.segments[:-1, 1] + placed.segments[1:, 0]) / 2
    joint = points[:, [INDEX["B_upper"], INDEX["B_lower"]]].mean(1)
    assert joint == pytest.approx(middle, abs=1e-9)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: plane_tube()[1].state(1.2), "Deployment is 1.2"),
        (lambda: plane_tube()[1].state(np.nan), "Deployment is nan"),
        (lambda: tubes.make_unit("Plane", 0.8, 40, 0, RatioRule("Fixed", 0.5)), "HeightRatio"),
        (lambda: tubes.make_unit("Plane", 0.8, 40, 2.5, RatioRule("Best")), "RatioRule 'Best'"),
        (lambda: RatioRule(share=1.0).ratios(0.8), "RatioShare is 1"),
        (lambda: RatioRule(share=np.nan).ratios(0.8), "RatioShare is nan"),
        (
            lambda: tubes.along(
                sphere_tube()[0], "Sphere", 2.5, RatioRule("Exact"), sphere_radius=110
            ),
            "not on the sphere.*SphereRadius",
        ),
    ],
)
def test_refusals(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def test_every_rule_gives_its_ratio():
    theta = np.radians([40.0, 55.0])
    assert tubes.make_unit("Plane", theta, 40, 2.5, RatioRule("Paper")).ratio == pytest.approx(
        [0.5, 0.5]
    )
    exact = tubes.make_unit("Plane", theta, 40, 2.5, RatioRule("Exact"))
    assert exact.ratio == pytest.approx(1 / (3 - 4 * np.sin(theta / 2) ** 2))
    assert exact.isometry_error().max() < 1e-12


def test_adaptive_ratios_are_in_range_for_every_theta():
    theta = np.radians(np.linspace(1, 170, 40))
    ratio = RatioRule(share=0.1).ratios(theta)
    assert (ratio > np.sin(theta / 2)).all()
    assert (ratio < 1).all()
    assert RatioRule(share=0.0).ratios(theta) == pytest.approx(np.sin(theta / 2))


def test_panel_strains_are_those_of_the_panels_corners():
    unit = units.plane_unit(np.radians(50), 0.5, 60, 24)
    points = opening_state(unit, 0.5)
    found = panel_strains(unit, points)
    for k, corners in enumerate(PANELS.values()):
        rows = [INDEX[corner] for corner in corners]
        now, before = (
            np.linalg.norm(p[rows][:, None] - p[rows][None], axis=-1) for p in (points, unit.flat)
        )
        worst = np.abs(now / np.where(before, before, 1) - (before > 0)).max()
        assert found[k] == pytest.approx(worst, abs=1e-12)
    contact = [k for k, name in enumerate(PANELS) if "contact" in name]
    assert found[contact].max() < 1e-12
    assert found.max() > 1e-4
    assert panel_strains(unit, opening_state(unit, 1)).max() < 1e-12
