# SPDX-License-Identifier: LGPL-2.1-or-later
"""Another minimisation of a unit's energy: CalculiX's panels, cones as facets, least distance.

Of our model only the places of the contacts are shared. Panels are solid elements, condensed by
CalculiX; a cone is `SIDES` planes; bodies start where rigid ones miss each other least, and move by
small rotations. What is then sought is the point of least norm of a polyhedron, by Lawson and
Hanson's non-negative least squares. Contact panels and knuckles are rigid here, and in ours too.
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import nnls

from BistableWB.origami import rigid
from BistableWB.origami.snap import elastic, forces
from BistableWB.origami.snap.contact import contacts
from BistableWB.origami.thick.closure import FIRST, RIGHT, SECOND
from BistableWB.origami.units.creases import BODIES
from tests.origami.calculix import Plate, needed
from tests.origami.test_calculix import FIRM, in_balance, shape_of
from tests.origami.test_elastic import HINGES, PLA, unit

pytestmark = [needed, pytest.mark.slow]

OPENINGS = np.array([1.0, 0.92, 0.88, 0.82])
SIDES, SIZE = 24, 5.0  # mm, of the elements
SOFT = 1e-3  # N/mm: what holds a body that nothing touches
REACH = 40.0  # mm: a rotation moves a body's end by so much
NEAR = 0.6  # mm: facets further away are left out
LEFT = BODIES.index("contact_left")
RIGID = [k for k, name in enumerate(BODIES) if name.startswith("contact")]


def softness(layout, body, folder):
    """Motions (6 tabs, modes) of a panel's roots by modes of energy |z|² / 2."""
    _, core, roots = shape_of(layout, BODIES[body])
    folder.mkdir()
    found = Plate(core, roots, HINGES.face_thickness, SIZE).compliance(
        folder, PLA.young, PLA.poisson
    )
    free = in_balance(roots)
    values, vectors = np.linalg.eigh(free.T @ found @ free)
    assert values.min() > 0
    return free @ (vectors * np.sqrt(values))


class Facets:
    """The polyhedron of a unit's modes and motions in which no cone enters its recess."""

    def __init__(self, layout, found, soft, leg):
        self.found, self.soft, self.leg = found, soft, leg
        self.tabs = {
            (side, hinge, place): (k, tab)
            for (side, hinge, k), (tab, _, places) in elastic.tabs_of(layout, found, HINGES).items()
            for place in places
        }
        counts = [soft[b].shape[1] if b in soft else 0 for b in range(len(BODIES))]
        self.starts = np.concatenate([[0], np.cumsum(counts)])

    def least(self, poses):
        """Energy of least norm, and the poses to which it leads from ``poses`` (15, 4, 4), mm."""
        motions, count = self._motions(poses)
        rows, rooms = self._planes(poses, motions, count)
        modes = self.starts[-1]
        rows[:, modes:] /= np.sqrt(SOFT)
        problem = np.vstack([rows.T, -rooms[None]])
        goal = np.zeros(len(problem))
        goal[-1] = 1
        share, _ = nnls(problem, goal, maxiter=20 * len(rooms))
        left = problem @ share - goal
        point = -left[:-1] / left[-1]
        assert (rows @ point + rooms).min() > -1e-6
        moved = poses.copy()
        for body, (at, turns) in motions.items():
            step = point[at : at + len(turns) + 3] / np.sqrt(SOFT)
            turn = rigid.rotation(turns.T @ step[: len(turns)] / REACH)
            place = turn @ poses[body, :3, 3] + step[len(turns) :]
            moved[body] = rigid.pose(turn @ poses[body, :3, :3], place)
        return (point[:modes] ** 2).sum() / 2, moved

    def _motions(self, poses):
        """{body: (first unknown, directions about which it turns)}, and the number of unknowns."""
        found, count = {}, self.starts[-1]
        for body in range(len(BODIES)):
            if body == LEFT:
                continue
            turns = np.eye(3)
            if body == RIGHT:  # not about its leg: that is the opening
                turns = np.linalg.svd((poses[RIGHT, :3, :3] @ self.leg)[None])[2][1:]
            found[body] = count, turns
            count += len(turns) + 3
        return found, count

    def _planes(self, poses, motions, count):
        """Rows and rooms: rows · unknowns + rooms ≥ 0."""
        found, rows, rooms = self.found, [], []
        shrink = (1 + np.cos(np.pi / SIDES)) / 2  # between the polygon within and the one without
        up = np.array([0.0, 1.0, 0.0])
        for hinge, place in zip(*np.nonzero(found.valid[0]), strict=True):
            point, axis = found.points[0, hinge, place], found.axes[0, hinge]
            slope, lean = found.slope[0, hinge, place], found.lean[0, hinge, place]
            bodies = FIRST[hinge], SECOND[hinge]
            ends = [rigid.apply(poses[b], point[None])[0] for b in bodies]
            back = poses[bodies[0], :3, :3].T
            moves = np.zeros((3, count))
            for side, (body, sign) in enumerate(zip(bodies, (-1, 1), strict=True)):
                if body in motions:
                    at, turns = motions[body]
                    lever = -rigid.skew(ends[1]) @ turns.T / REACH
                    moves[:, at : at + len(turns) + 3] += sign * np.hstack([lever, np.eye(3)])
                if body in self.soft:
                    k, tab = self.tabs[side, hinge, place]
                    arm = np.hstack([np.eye(3), -rigid.skew(point - tab.root)])
                    own = poses[body, :3, :3] @ arm @ self.soft[body][6 * k : 6 * k + 6]
                    moves[:, self.starts[body] : self.starts[body + 1]] += sign * own
            for angle in 2 * np.pi * np.arange(SIDES) / SIDES:
                out = np.cos(angle) * np.cross(axis, up) + np.sin(angle) * up
                way = slope * out - lean * axis
                room = shrink * found.gap - way @ back @ (ends[1] - ends[0])
                if room < NEAR:
                    rows.append(-way @ back @ moves)
                    rooms.append(room)
        return np.array(rows), np.array(rooms)


def ours(thick, layout, found, poses):
    """Energies of our own minimisation, knuckles and contact panels rigid."""
    options = elastic.Options(count=30, rigid_knuckles=True, hertz=1e5)
    made = elastic.elastic_unit(thick, layout, found, HINGES, PLA, options=options)
    modes = [side.copy() for side in made.modes]
    for own, bodies in zip(modes, (FIRST, SECOND), strict=True):
        own[np.isin(bodies, RIGID)] = 0
    made = replace(made, modes=tuple(modes))
    rests = forces.follow(made, OPENINGS, poses)
    assert all(rest.found for rest in rests)
    return made, [rest.energy for rest in rests[1:]]


def test_the_least_energy_of_a_unit_is_found_by_another_minimisation_too(tmp_path):
    """At three openings on the way, within 10 %."""
    thick, layout = unit(FIRM)
    found = contacts([layout], HINGES)
    poses = thick.states(OPENINGS[None])[0]
    poses[..., :3, 3] *= thick.scale
    made, energies = ours(thick, layout, found, poses)
    soft = {
        body: softness(layout, body, tmp_path / name)
        for body, name in enumerate(BODIES)
        if name in layout.plates and body not in RIGID
    }
    facets = Facets(layout, found, soft, made.leg)
    theirs = []
    for start in poses[1:]:
        there = start
        for _ in range(2):  # the second time from where the first one led
            energy, there = facets.least(there)
        theirs.append(energy)
    assert energies == pytest.approx(theirs, rel=0.1)
