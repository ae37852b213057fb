# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elastic units: what panels, knuckles and cones give, and what that makes of the snap."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from BistableWB.origami.errors import Refusal
from BistableWB.origami.hinges.layout import unit_layout
from BistableWB.origami.hinges.parameters import PIN, HingeParameters
from BistableWB.origami.snap import forces, knuckles, materials, panels
from BistableWB.origami.snap.contact import contacts
from BistableWB.origami.snap.elastic import Options, elastic_unit
from BistableWB.origami.snap.minimum import least, start
from BistableWB.origami.snap.springs import cones
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.unit import plane_unit
from BistableWB.origami.units.creases import CREASES

HINGES = HingeParameters()
PLA = materials.material("PLA")
KNOWN = 0.5130090138268358  # ratio of the unit of docs/theory/hinges.md 4


def unit(ratio=KNOWN, hinges=HINGES):
    """The unit theta 55°, ‖AB‖ 80 of the notes, compensated, and its layout."""
    thin = plane_unit(np.radians(55), ratio, 80, 32)
    thick = ThickUnit(thin, hinges.face_thickness, hinges.gap_between_planes).compensated()
    return thick, unit_layout(thick.axes, hinges, 80)


def central(found, layout, hinges):
    """Contacts by the law of the notes: one place a cone, in the middle of what is engaged."""
    each = found.valid.reshape(*found.valid.shape[:2], -1, 2)
    points = found.points.reshape(*each.shape, 3).mean(3)
    for hinge in range(points.shape[1]):
        laid = layout.hinges[CREASES[hinge].name]
        for k, (base, _) in enumerate(laid.cones):
            along = base + (hinges.gap_length + laid.cone_height) / 2
            at = laid.point(along)
            points[0, hinge, k] = at.real, laid.height, at.imag
    halves = {name: getattr(found, name).reshape(each.shape)[..., 0]
              for name in ("slope", "lean", "valid", "cones")}  # fmt: skip
    return replace(found, points=points, **halves)


def energies(openings, clearance, ratio=KNOWN, law=None, **options):
    thick, layout = unit(ratio)
    found = contacts([layout], HINGES)
    found = law(found, layout, HINGES) if law else found
    elastic = elastic_unit(thick, layout, found, HINGES, PLA, options=Options(**options))
    poses = thick.states(np.array([openings]))[0]
    poses[..., :3, 3] *= thick.scale
    rests = forces.follow(elastic, openings, poses, clearance)
    assert all(rest.found for rest in rests)
    return elastic, rests


# -- cones ------------------------------------------------------------------------------------


@given(st.integers(0, 10**6), st.floats(-3, 0.5), st.floats(-4, -1))
def test_cones_push_back_by_the_slope_of_what_they_cost(seed, size, sharp):
    random = np.random.default_rng(seed)
    n = 12
    root = random.normal(size=(n, 3, 3))
    give = 0.01 * root @ np.swapaxes(root, -1, -2) + 1e-3 * np.eye(3)
    lean = random.choice([-1.0, 0.0, 1.0], n)
    slope = np.where(lean == 0, 1.0, random.choice([0.0, 1.43], n))
    held = cones(give, slope, lean, np.full(n, 0.2))
    u, mu = 10**size * random.normal(size=(n, 3)), 10**sharp
    step = 1e-6 * random.normal(size=(n, 3))
    _, strain, force, stiffness = held.push(u, mu)
    up, down = held.push(u + step, mu), held.push(u - step, mu)
    scale = np.abs(force).max() + mu
    assert (up[0] - down[0]) / 2 == pytest.approx((force * step).sum(1), abs=1e-6 * scale * 1e-4)
    moved = (stiffness @ step[..., None])[..., 0]
    assert (up[2] - down[2]) / 2 == pytest.approx(moved, abs=1e-3 * np.abs(stiffness).max() * 1e-6)
    # what is left to move freely keeps the law, and nothing free is cheaper
    free = u - (give @ force[..., None])[..., 0]
    room = 0.2 + lean * free[:, 2] - slope * np.linalg.norm(free[:, :2], axis=1)
    assert (room > 0).all()
    for _ in range(20):
        other = free + 0.1 * random.normal(size=(n, 3)) * np.abs(u - free).max(1, keepdims=True)
        inside = 0.2 + lean * other[:, 2] - slope * np.linalg.norm(other[:, :2], axis=1) > 0
        away = u - other
        dearer = (away * np.linalg.solve(give, away[..., None])[..., 0]).sum(1) / 2
        assert (dearer[inside] > strain[inside] - 60 * mu - 1e-9).all()


# -- panels and tabs --------------------------------------------------------------------------

STRIP = np.array([[0, 0], [80, 0], [80, 8], [0, 8.0]])
ENDS = np.array([[[0, 0], [0, 8]], [[80, 0], [80, 8.0]]])


def test_a_strip_stretches_and_bends_as_a_beam():
    found = panels.compliance(panels.Plate(STRIP, 1.2, ENDS), 0.0)
    pull, bend = np.zeros(12), np.zeros(12)
    pull[[0, 6]] = -1, 1
    assert pull @ found @ pull == pytest.approx(80 / (8 * 1.2), rel=3e-3)
    bend[[5, 11]] = -1, 1  # moments about z, which is the strip's width
    assert bend @ found @ bend == pytest.approx(12 * 80 / (8 * 1.2**3), rel=3e-3)
    upright = np.zeros(12)
    upright[[4, 10]] = -1, 1  # in its plane
    assert upright @ found @ upright == pytest.approx(12 * 80 / (1.2 * 8**3), rel=4e-3)
    twist = np.zeros(12)
    twist[[3, 9]] = -1, 1
    torsion = 2 * 80 / (8 * 1.2**3 / 3 * (1 - 0.63 * 1.2 / 8))  # Saint-Venant's
    assert twist @ found @ twist == pytest.approx(torsion, rel=0.02)


def test_modes_are_the_compliance():
    found = panels.compliance(panels.Plate(STRIP, 1.2, ENDS), 0.35)
    soft = panels.modes(found, 12)
    assert soft @ soft.T == pytest.approx(found, abs=1e-9 * found.max())


def test_a_tab_is_a_cantilever():
    frame = np.eye(3)
    tab = knuckles.Tab(frame, np.zeros(3), 6.0, 4.0, 1.2)
    tip = knuckles.compliance(tab, [6.0, 0, 0], 0.35)
    bent = 6**3 / (3 * 4 * 1.2**3 / 12)
    assert tip[1, 1] == pytest.approx(bent, rel=0.05)  # and shear
    assert tip[1, 1] > bent
    stress = knuckles.stress(tab, np.array([[6.0, 0, 0]]), np.array([[0, 10.0, 0]]))
    assert stress == pytest.approx(10 * 6 * 6 / (4 * 1.2**2))


# -- units ------------------------------------------------------------------------------------


def test_torque_is_the_slope_of_the_energy():
    openings = np.array([1.0, 0.93, 0.88, 0.879, 0.8805])
    elastic, rests = energies(openings, 0.5)
    rise = (rests[4].energy - rests[3].energy) / (0.0015 * abs(elastic.turn))
    assert rests[2].torque == pytest.approx(rise, rel=0.02)
    assert rests[0].energy < 0.02


@pytest.mark.slow
def test_barrier_grows_as_play_falls():
    openings = np.array([1.0, 0.93, 0.88])
    tops = [energies(openings, share)[1][-1].energy for share in (1.0, 0.6, 0.2)]
    assert (np.diff(tops) > 0.5).all()
    assert tops[0] < 0.05


@pytest.mark.slow
def test_energy_is_that_of_the_notes():
    """54.6, 16.2, 5.7 and 0 N·mm with 0, 1/4, 1/2 and all of the play, knuckles rigid."""
    openings = np.array([1.0, 0.96, 0.92, 0.9, 0.88, 0.86, 0.84, 0.8, 0.76, 0.72])
    fine = {"rigid_knuckles": True, "count": 30, "degree": 18, "hertz": 1e5, "law": central}
    found = [
        max(rest.energy for rest in energies(openings, share, **fine)[1])
        for share in (0.0, 0.25, 0.5, 1.0)
    ]
    assert found[:3] == pytest.approx([54.6, 16.2, 5.7], rel=0.1)
    assert found[3] < 0.05


@pytest.mark.slow
def test_few_modes_tell_the_energy_as_well_as_many():
    openings = np.array([1.0, 0.95, 0.9, 0.86, 0.82])
    few = energies(openings, 0.5)[1]
    many = energies(openings, 0.5, count=30, degree=16)[1]
    for a, b in zip(few, many, strict=True):
        assert a.energy == pytest.approx(b.energy, rel=0.05, abs=0.02)


def test_no_symmetry_is_assumed():
    """From a state that is pushed about, the same state of least energy is found."""
    elastic, rests = energies(np.array([1.0, 0.93, 0.88]), 0.5)
    poses = rests[-1].state.poses.copy()
    poses[1:, :3, 3] += np.random.default_rng(1).normal(scale=0.1, size=(14, 3))
    again = least(elastic, 0.88, start(elastic, poses), 0.5)
    assert again.energy == pytest.approx(rests[-1].energy, rel=1e-3, abs=1e-3)


# -- materials --------------------------------------------------------------------------------


@pytest.mark.parametrize("name", materials.MATERIALS)
def test_every_number_has_its_source(name):
    found = materials.material(name)
    assert set(found.sources) == {
        "young", "poisson", "density", "strength", "layer_share", "friction",
    }  # fmt: skip
    assert all(found.sources.values())


@pytest.mark.parametrize(
    ("change", "parameter"),
    [({"young": -1}, "YoungsModulus"), ({"density": -1.2}, "Density"),
     ({"strength": -5}, "Strength"), ({"strength": float("nan")}, "Strength")],
)  # fmt: skip
def test_numbers_that_cannot_be_are_refused_with_the_cure(change, parameter):
    with pytest.raises(Refusal, match="above 0") as refused:
        PLA.edited(**change)
    assert refused.value.parameter == parameter


def test_an_edited_number_says_whose_it_is():
    own = PLA.edited(young=2500.0, density=0.0)
    assert (own.young, own.density) == (2500.0, PLA.density)
    assert "user" in own.sources["young"]
    assert own.sources["density"] == PLA.sources["density"]
    with pytest.raises(Refusal, match="PETG"):
        materials.material("Wood")


@pytest.mark.slow
def test_pins_snap_as_cones_do():
    """Rings on a pin: more play, less barrier, and the torque is the slope of the energy."""
    pins = HingeParameters(pivot=PIN, face_thickness=2.4)
    thick, layout = unit(0.475, pins)
    found = contacts([layout], pins)
    elastic = elastic_unit(thick, layout, found, pins, PLA)
    openings = np.array([1.0, 0.93, 0.88, 0.878, 0.877, 0.874])
    poses = thick.states(openings[None])[0]
    poses[..., :3, 3] *= thick.scale
    tops = []
    for share in (1.0, 0.6, 0.2):
        rests = forces.follow(elastic, openings, poses, share)
        assert all(rest.found for rest in rests)
        tops.append(rests[2].energy)
    assert (np.diff(tops) > 0.5).all()
    rise = (rests[4].energy - rests[5].energy) / (0.003 * abs(elastic.turn))
    assert (rests[4].torque + rests[5].torque) / 2 == pytest.approx(rise, rel=0.05)
