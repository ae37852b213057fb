# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX judges the stiffness of panels, the energy of a unit and the stress in a knuckle.

Solid elements against our plates and cantilevers: nothing of the model is shared but the loads.
"""

from dataclasses import replace

import numpy as np
import pytest

from BistableWB.origami import rigid
from BistableWB.origami.snap import elastic, forces, knuckles, panels
from BistableWB.origami.snap.contact import contacts
from BistableWB.origami.thick.closure import FIRST, SECOND
from BistableWB.origami.units.creases import BODIES
from tests.origami.calculix import Block, Plate, needed
from tests.origami.test_elastic import HINGES, PLA, unit

pytestmark = [needed, pytest.mark.slow]
FIRM = 0.4865  # ratio of a unit that snaps
MODES = 6


def shape_of(layout, name):
    plate = layout.plates[name]
    core = np.array([[p.real, p.imag] for p in plate.core])
    roots = np.array([[[t.corner(k).real, t.corner(k).imag] for k in (0, 1)] for t in plate.tabs])
    return plate, core, roots


def in_balance(roots):
    """Columns: loads on the roots whose forces and moments add up to nothing."""
    sums = np.zeros((6, 6 * len(roots)))
    for k, root in enumerate(roots):
        x, z = root.mean(0)
        sums[:3, 6 * k : 6 * k + 3] = sums[3:, 6 * k + 3 : 6 * k + 6] = np.eye(3)
        sums[3:, 6 * k : 6 * k + 3] = rigid.skew(np.array([x, 0.0, z]))
    return np.linalg.svd(sums)[2][6:].T


@pytest.mark.parametrize("name", ["secondary_left_upper", "primary_left_upper"])
def test_a_panel_is_as_stiff_as_solid_elements_say(name, tmp_path):
    _, core, roots = shape_of(unit(FIRM)[1], name)
    found = panels.compliance(panels.Plate(core, 1.2, roots), 0.35)
    free = in_balance(roots)
    values, vectors = np.linalg.eigh(free.T @ found @ free)
    assert values.min() > 0
    loads = (free @ vectors[:, ::-1][:, :MODES]).T
    solid = Plate(core, roots, 1.2).work(tmp_path, loads.reshape(MODES, -1, 6))
    ours = np.einsum("ci,ij,cj->c", loads, found, loads)
    assert ours == pytest.approx(solid, rel=0.03)


def test_energy_of_a_unit_at_three_openings(tmp_path):
    """Its panels' energies under the forces of three states on the way, knuckles rigid."""
    thick, layout = unit(FIRM)
    found = contacts([layout], HINGES)
    options = elastic.Options(count=30, rigid_knuckles=True)
    made = elastic.elastic_unit(thick, layout, found, HINGES, PLA, options=options)
    openings = np.array([1.0, 0.92, 0.88, 0.82])
    poses = thick.states(openings[None])[0]
    poses[..., :3, 3] *= thick.scale
    rests = forces.follow(made, openings, poses)[1:]
    tabs = elastic.tabs_of(layout, found, HINGES)
    ours, solid = np.zeros(3), np.zeros(3)
    for name in ("border_left", "primary_left_upper", "secondary_left_upper", "border_right",
                 "primary_right_upper", "secondary_right_upper"):  # fmt: skip
        plate, core, roots = shape_of(layout, name)
        loads = np.array([loads_on(name, plate, rest, found, tabs) for rest in rests])
        at = panels.compliance(panels.Plate(core, 1.2, roots), 0.35)
        twin = 1 if name.startswith("border") else 2  # the lower one is its mirror image
        flat = loads.reshape(3, -1)
        ours += twin * np.einsum("ci,ij,cj->c", flat, at, flat) / (2 * PLA.young)
        folder = tmp_path / name
        folder.mkdir()
        work = Plate(core, roots, 1.2, 2.0).work(folder, loads)
        solid += twin * work / (2 * PLA.young)
    assert ours == pytest.approx(solid, rel=0.1)
    # and these panels are most of what gives way
    assert (ours > 0.5 * np.array([rest.energy for rest in rests])).all()


def loads_on(name, plate, rest, found, tabs):
    """Wrenches (tabs, 6) at the roots of a plate's tabs, in its flat frame."""
    body = BODIES.index(name)
    loads = np.zeros((len(plate.tabs), 6))
    axes = found.axes[0]
    up = np.broadcast_to([0.0, 1.0, 0.0], axes.shape)
    frame = np.stack([up, np.cross(axes, up), axes], -1)
    pushed = (frame[:, None] @ rest.forces[..., None])[..., 0]
    for (side, hinge, k), (tab, _, places) in tabs.items():
        bodies = (FIRST, SECOND)[side]
        if bodies[hinge] != body:
            continue
        push = -pushed[hinge, places]
        if side:
            back = (
                rest.state.poses[SECOND[hinge], :3, :3].T @ rest.state.poses[FIRST[hinge], :3, :3]
            )
            push = -push @ back.T
        arms = found.points[0, hinge, places] - tab.root
        loads[k, :3] += push.sum(0)
        loads[k, 3:] += np.cross(arms, push).sum(0)
    return loads


@pytest.mark.parametrize("force", [(0, 10.0, 0), (10.0, 0, 0), (0, 0, 10.0)])
@pytest.mark.parametrize(("length", "width"), [(4.5, 4.0), (2.5, 5.0)])
def test_stress_in_a_knuckles_root(force, length, width, tmp_path):
    """A tab of solid elements, its end pushed."""
    tab = knuckles.Tab(np.eye(3), np.zeros(3), length, width, 1.2)
    at = np.array([[length, 0.0, 0.0]])
    # at half its length: at a held root solid elements find more with every refinement
    half = replace(tab, root=np.array([length / 2, 0, 0]), length=length / 2)
    ours = knuckles.stress(half, at, np.array([force]))
    solid, gave = Block(length, width, 1.2).pushed(tmp_path, force, PLA.young, PLA.poisson)
    assert ours == pytest.approx(solid, rel=0.15)
    give = knuckles.compliance(tab, at[0], PLA.poisson) / PLA.young
    along = np.flatnonzero(force)[0]
    assert give[along, along] * 10 == pytest.approx(gave, rel=0.15)
