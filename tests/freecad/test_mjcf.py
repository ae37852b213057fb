# SPDX-License-Identifier: LGPL-2.1-or-later
"""MJCF as MuJoCo reads it: masses, both stable states, and a unit that opens and stays open."""

import xml.etree.ElementTree as ET

import numpy as np
import pytest

from BistableWB import make
from BistableWB.exporters import export
from BistableWB.exporters.mjcf import PLA, mechanism_of
from tests.judges import judge


@pytest.fixture
def mujoco(monkeypatch):
    monkeypatch.setenv("MUJOCO_GL", "disable")  # it needs no window
    return judge("mujoco")


@pytest.fixture
def arch(doc, valid):
    curve = make.make_curve(doc)
    triangles = make.make_triangle_placement(doc, curve, edge_length=90)
    obj = make.make_hinge_set(doc, make.make_bistable_unit(doc, triangles))
    valid(doc)
    return obj


def model_of(mujoco, obj, path, **options):
    model = mujoco.MjModel.from_xml_path(str(export(obj, path, **options)))
    model.opt.gravity[:] = 0
    return model, mujoco.MjData(model)


def off(model, data, obj, state):
    """Largest distance (mm) of a corner of any body from where the tool has it."""
    mechanism = mechanism_of(obj)
    worst = 0.0
    for body, motion in zip(mechanism.bodies, mechanism.states[state], strict=True):
        corners = body.placed.bounds
        there = corners @ motion[:3, :3].T + motion[:3, 3]
        k = model.body(body.name).id
        here = corners @ data.xmat[k].reshape(3, 3).T + data.xpos[k] * 1000
        worst = max(worst, np.abs(here - there).max())
    return worst


def test_every_hinge_is_in_the_tree_or_closes_a_loop(hinges, tmp_path):
    root = ET.parse(export(hinges, tmp_path / "a.xml")).getroot()
    bodies = list(root.find("worldbody").iter("body"))
    joints = list(root.iter("joint"))
    assert len(bodies) == hinges.BodyCount == 15
    assert len([j for j in joints if j.get("name")]) == 14
    closing = {c.get("name")[:-2] for c in root.find("equality")}
    assert len(closing) == 23 - 14
    with pytest.raises(ValueError, match="closure is 'glue': choose one of equality, clearance"):
        export(hinges, tmp_path / "a.xml", closure="glue")


def test_flexible_hinges_are_refused(hinges, doc, valid, tmp_path):
    hinges.HingeType = "Flexible"
    valid(doc)
    with pytest.raises(ValueError, match=r"flexible hinges.*set HingeType to Rotational"):
        export(hinges, tmp_path / "a.xml")


@pytest.mark.slow
def test_both_stable_states_close_and_masses_are_right(mujoco, arch, tmp_path):
    model, data = model_of(mujoco, arch, tmp_path / "a.xml")
    volume = sum(shape.Volume for _, shape, _ in arch.Proxy.export_bodies(arch)) * 1e-9
    assert model.body_mass.sum() == pytest.approx(volume * PLA, rel=0.02)  # round faces are coarse
    for state in ("flat", "deployed"):
        mujoco.mj_resetDataKeyframe(model, data, model.key(state).id)
        mujoco.mj_forward(model, data)
        assert off(model, data, arch, state) < 1e-3
        assert np.abs(data.efc_pos[: 3 * model.neq]).max() * 1000 < 1e-3


@pytest.mark.slow
def test_a_unit_is_pushed_open_and_then_stays_by_itself(mujoco, hinges, tmp_path):
    model, data = model_of(mujoco, hinges, tmp_path / "a.xml")
    angles = model.jnt_qposadr[model.actuator_trnid[:, 0]]
    half, deployed = (model.key(name).qpos[angles] for name in ("half", "deployed"))
    mujoco.mj_resetDataKeyframe(model, data, model.key("half").id)
    for step in range(12000):
        part = min(1.0, step / 8000)
        data.ctrl[:] = (1 - part) * half + part * deployed
        mujoco.mj_step(model, data)
    model.actuator_gainprm[:] = model.actuator_biasprm[:] = 0  # let go
    for _ in range(36000):
        mujoco.mj_step(model, data)
    assert off(model, data, hinges, "deployed") < 0.02


@pytest.mark.slow
def test_with_clearance_it_is_loose_by_that_much(mujoco, hinges, tmp_path):
    model, data = model_of(mujoco, hinges, tmp_path / "a.xml", closure="clearance")
    play = mechanism_of(hinges).play / 1000
    assert model.tendon_range[:, 1] == pytest.approx(play)
    mujoco.mj_resetDataKeyframe(model, data, model.key("deployed").id)
    mujoco.mj_forward(model, data)
    assert data.ten_length.max() < 1e-6
