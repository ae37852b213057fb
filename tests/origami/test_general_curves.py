# SPDX-License-Identifier: LGPL-2.1-or-later
"""Any curve in space gives a proper tube of general units, or an error that says what to do."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.curves.ruling import default_ruling
from BistableWB.origami.unit import BARS, IS_EDGE, PANELS, VERTICES, plane_unit, sphere_unit
from BistableWB.origami.units import angles
from BistableWB.origami.units.contacts import contact_pairs, contact_quads
from BistableWB.origami.units.general import general_unit

INDEX = {name: i for i, name in enumerate(VERTICES)}
NAMES = ("flat", "theta", "ratio", "alpha", "beta", "beta_prime", "edge_length", "strip_height")
RISING = Bezier([[0, 0, 0], [60, 120, 20], [180, 120, 60], [240, 0, 70]])
few = settings(max_examples=10, deadline=None, derandomize=True)

TRIANGLES = [
    [INDEX[v] for v in corners]
    for panel in PANELS.values()
    for corners in ([panel[:3]] if len(panel) == 3 else [panel[:3], (panel[0], *panel[2:])])
]

PIERCING = [
    np.array(column)
    for column in zip(
        *((i, j, t) for i, j in BARS[IS_EDGE].tolist() for t in TRIANGLES if not {i, j} & set(t)),
        strict=True,
    )
]


def pierced(points):
    """Whether a panel edge or diagonal passes through a panel that it does not touch: (n,) bool."""
    i, j, t = PIERCING
    p, q = points[:, i], points[:, j]
    a, b, c = (points[:, t[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    low, high = (((x - a) * normal).sum(-1) for x in (p, q))
    with np.errstate(divide="ignore", invalid="ignore"):
        hit = p + (q - p) * (low / (low - high))[..., None]
        area = (normal * normal).sum(-1)
        weights = [
            (np.cross(v - u, hit - u) * normal).sum(-1) / area for u, v in ((a, b), (b, c), (c, a))
        ]
    return ((low * high < 0) & (np.min(weights, axis=0) > 1e-6)).any(1)


def assert_proper(unit, left, right):
    """Isometric, on its contacts, C' and P where section 1 has them, nothing through anything."""
    assert unit.isometry_error().max() <= 1e-12
    for quads, side in ((left, "left"), (right, "right")):
        corners = [INDEX[v] for v in PANELS[f"contact_{side}"]]
        np.testing.assert_allclose(unit.deployed[:, corners], quads, atol=1e-8)
    at = {name: unit.flat[:, i] for name, i in INDEX.items()}
    assert np.abs(unit.flat[..., 1]).max() == 0
    for end, out in (("upper", 1), ("lower", -1)):
        for side in ("left", "right"):
            a, b, c, p = (at[f"{v}_{end}"] for v in (f"A_{side}", "B", "C", "P"))
            assert ((a[:, 0] < c[:, 0]) & (c[:, 0] < b[:, 0])).all()
            for q in (b, c):  # the apex lies outward of A-B and A-C'
                u, v = q - a, p - a
                assert (out * (u[:, 0] * v[:, 2] - u[:, 2] * v[:, 0]) > 0).all()
    some = np.linspace(0, len(unit) - 1, min(len(unit), 12)).astype(int)
    assert not pierced(unit.deployed[some]).any()


def on_sphere(radius, bend=0.5):
    class Curve:
        def point(self, s):
            longitude, latitude = 1.5 * np.asarray(s), bend * np.sin(3 * np.asarray(s))
            level = np.cos(latitude)
            return radius * np.stack(
                [level * np.cos(longitude), level * np.sin(longitude), np.sin(latitude)], -1
            )

    return Curve()


def assert_same(found, expected):
    for name in NAMES:
        np.testing.assert_allclose(
            getattr(found, name), getattr(expected, name), rtol=0, atol=1e-8, err_msg=name
        )


def test_the_rising_arch_of_the_reference(vectors):
    case = vectors["general"][0]
    curve = Bezier(case["control_points"])
    placed = place(curve, case["edge_length"], np.radians(case["gamma"]))
    left, right = contact_pairs(placed, 16.0)
    unit = general_unit(left, right, 0.5)
    assert_proper(unit, left, right)
    np.testing.assert_allclose(unit.ratio, 0.5, atol=2e-3)


def test_plane_curve_contacts_are_the_rectangles_of_the_plane_unit():
    curve = Bezier([[0, 0, 0], [60, 120, 0], [180, 120, 0], [240, 0, 0]])
    placed = place(curve, 40.0, np.radians(20))
    unit = general_unit(*contact_pairs(placed, 16.0), 0.6)
    expected = plane_unit(placed.thetas, 0.6, 40.0, 16.0)
    assert_same(unit, expected)


def test_sphere_curve_contacts_are_those_of_the_sphere_unit():
    edge, radius = 30.0, 100.0
    placed = place(on_sphere(radius), edge, np.radians(15), legs=("point", (0, 0, 0)))
    left, right = contact_pairs(placed, 12.0)
    ratio = angles.exact_sphere_ratio(placed.thetas)
    unit = general_unit(left, right, ratio)
    expected = sphere_unit(placed.thetas, edge, np.arctan(2 * radius / edge), 12.0)
    assert_same(unit, expected)


def test_neighbours_share_their_contacts_on_any_viewpoint_curve():
    placed = place(RISING, 40.0, np.radians(20), legs=("point", (120.0, 40.0, -300.0)))
    quads = contact_quads(placed, 16.0)
    assert quads.shape == (len(placed) + 1, 4, 3)
    np.testing.assert_allclose(quads[:-1, 1:3], quads[1:, [0, 3]], atol=1e-9)
    left, right = contact_pairs(placed, 16.0)
    unit = general_unit(left, right, 0.6)
    assert_proper(unit, left, right)
    right_handed = np.cross(right[:, 0] - right[:, 1], left[:, 0] - left[:, 1])
    assert ((right_handed * (left[:, 1] - left[:, 2])).sum(1) > 0).all()


def test_thick_contacts_meet_in_the_middle_of_the_double_hinge():
    placed = place(RISING, 40.0, np.radians(20), pitch=1.4)
    left, right = contact_pairs(placed, 16.0)
    unit = general_unit(left, right, 0.6)
    assert_proper(unit, left, right)


def test_thick_contacts_of_a_viewpoint_curve_lie_in_the_planes_of_their_blocks():
    viewpoint = np.array([120.0, 40.0, -300.0])
    placed = place(RISING, 40.0, np.radians(20), pitch=1.4, legs=("point", viewpoint))
    left, right = contact_pairs(placed, 16.0)
    assert_proper(general_unit(left, right, 0.6), left, right)
    np.testing.assert_allclose(left[:, 1:3], right[:, 1:3], atol=1e-9)
    normals = np.cross(placed.reaches, placed.legs)
    for k, (one, other) in enumerate(zip(left, right, strict=True)):
        pair = (one, other) if placed.sides[k] < 0 else (other, one)
        for quad, normal in zip(pair, normals[k : k + 2], strict=True):
            np.testing.assert_allclose((quad[1:] - quad[0]) @ normal, 0, atol=1e-8)
    edges = np.linalg.norm(left[:, 0] - left[:, 1], axis=1)
    np.testing.assert_allclose(edges, 40.0, atol=1e-9)


@pytest.mark.parametrize("legs", [None, ("point", (120.0, 40.0, -300.0))])
def test_contacts_open_wider_by_what_is_asked(legs):
    placed = place(RISING, 40.0, np.radians(20), pitch=1.4, legs=legs)

    def half(sines):
        normals = [
            np.cross(q[:, 0] - q[:, 1], q[:, 2] - q[:, 1])
            for q in contact_pairs(placed, 16.0, sines)
        ]
        u, v = (n / np.linalg.norm(n, axis=1)[:, None] for n in normals)
        return np.arccos((u * v).sum(1)) / 2

    more = np.linspace(-0.02, 0.02, len(placed))
    np.testing.assert_allclose(np.sin(half(more)) - np.sin(half(None)), more, atol=1e-9)


def test_units_that_tilt_too_much_are_not_blamed_on_the_bend():
    steep = Bezier([[0, 0, 0], [60, 120, 20], [180, 120, 60], [240, 0, 80]])
    with pytest.raises(ValueError, match=r"near \(.*tilt too much; make .* move Ruling"):
        place(steep, 40.0, np.radians(20), legs=("point", (120.0, 60.0, 10.0)))


def test_a_strip_that_reaches_the_viewpoint_is_refused():
    placed = place(on_sphere(100.0), 30.0, np.radians(15), legs=("point", (0, 0, 0)))
    with pytest.raises(ValueError, match="HeightRatio"):
        contact_quads(placed, 101.0)
    with pytest.raises(ValueError, match="HeightRatio"):
        contact_quads(placed, 0.0)


def assert_helpful(error):
    """The message tells what to do."""
    assert any(word in str(error) for word in ("make", "choose", "move", "open", "change"))


def tube_or_error(curve, edge, ratio, legs):
    """A curve gives a proper tube, or a ValueError of one sentence that says what to change."""
    try:
        placed = place(curve, edge, np.radians(18), legs=legs)
        left, right = contact_pairs(placed, edge / 2.5)
        unit = general_unit(left, right, ratio)
    except ValueError as error:
        assert_helpful(error)
        return None
    assert_proper(unit, left, right)
    return unit


sway = st.floats(-80, 80)


@settings(max_examples=20, deadline=None, derandomize=True)
@given(
    st.lists(st.tuples(st.floats(-30, 30), sway, sway), min_size=4, max_size=5),
    st.floats(12, 25), st.floats(0.5, 0.85), st.booleans(),
)  # fmt: skip
def test_any_space_bezier_gives_a_tube_or_a_clear_error(offsets, edge, ratio, proposed):
    curve = Bezier([(80 * k + x, y, z) for k, (x, y, z) in enumerate(offsets)])
    try:
        legs = default_ruling(curve, edge) if proposed else None
    except ValueError as error:
        assert_helpful(error)
    else:
        tube_or_error(curve, edge, ratio, legs)


@few
@given(
    st.lists(st.tuples(st.floats(-60, 60), st.floats(-20, 20)), min_size=3, max_size=3),
    st.floats(30, 45), st.floats(0.55, 0.8),
)  # fmt: skip
def test_gently_rising_curves_give_tubes(bends, edge, ratio):
    """Where no contact leans more than 20° out of the plane across the legs, every unit closes."""
    points = [(0, 0, 0), *((80 * k, *bend) for k, bend in enumerate(bends, 1))]
    placed = place(Bezier(points), edge, np.radians(18))
    left, right = contact_pairs(placed, edge / 2.5)
    if np.abs(placed.reaches[:, 2] / np.linalg.norm(placed.reaches, axis=1)).max() < np.sin(
        np.radians(20)
    ):
        assert_proper(general_unit(left, right, ratio), left, right)


class Helix:
    """Radius 100 mm about z, rising ``pitch`` a turn."""

    def __init__(self, pitch, turns):
        self.pitch, self.turns = pitch, turns

    def point(self, s):
        turn = self.turns * np.asarray(s, float)
        angle = 2 * np.pi * turn
        return np.stack([100 * np.cos(angle), 100 * np.sin(angle), self.pitch * turn], -1)


@pytest.mark.parametrize("pitch", [5, 15, 30, 50])
def test_helices_give_tubes(pitch):
    assert tube_or_error(Helix(pitch, 0.7), 30.0, 0.6, None) is not None
    tube_or_error(Helix(pitch, 4.05), 30.0, 0.6, None)


@few
@given(st.floats(120, 400), st.floats(-0.3, 0.3), st.floats(-0.4, 0.4), st.floats(0.55, 0.8))
def test_viewpoint_curves_give_a_tube_or_a_clear_error(distance, slope, bend, ratio):
    class Seen:
        """A curve about the origin whose distance from it changes along the way."""

        def point(self, s):
            s = np.asarray(s, float)
            return on_sphere(1.0, bend).point(s) * (distance * (1 + slope * s))[..., None]

    tube_or_error(Seen(), 30.0, ratio, ("point", (0, 0, 0)))
