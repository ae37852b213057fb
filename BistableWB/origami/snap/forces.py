# SPDX-License-Identifier: LGPL-2.1-or-later
"""How hard a unit snaps, both ways: barrier, torque, a hand's force, and where it would break.

docs/theory/hinges.md 4. The energy of an elastic unit is followed from flat to deployed and
back (`elastic`, `minimum`); what every tab bears is told by the forces on its cones (`knuckles`).
Lengths mm, forces N, energies and torques N·mm, openings as fractions of the deployed angle.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..progress import NOBODY
from ..thick.closure import FIRST, SECOND
from ..units.creases import BODIES, CREASES
from . import knuckles
from .beyond import bears_beyond
from .contact import contacts
from .elastic import elastic_unit, tabs_of
from .minimum import State, least, start

if TYPE_CHECKING:
    from ..hinges.parameters import HingeParameters
    from ..hinges.unit_layout import Layout
    from ..progress import Progress
    from ..thick.linkage import ThickUnit
    from .contact import Contacts
    from .materials import Material
    from .minimum import ElasticUnit, Rest

# The barrier stands near the deployed state, where also torques are largest.
OPENINGS = np.array([0, 0.2, 0.36, 0.5, 0.62, 0.72, 0.8, 0.86, 0.91, 0.95, 0.98, 1.0])
FLAT, ON_EDGE = "Flat", "OnEdge"
# The way up of a print in the unit's flat frame: along the stack, or along A–B.
_UP = {FLAT: np.array([0.0, 1.0, 0.0]), ON_EDGE: np.array([1.0, 0.0, 0.0])}
_FINE = 40


@dataclass(frozen=True)
class Weakest:
    """The tab that bears the most of what it can.

    ``share``: stress / strength, above 1 it breaks; ``stress`` MPa; ``force`` N on its cone;
    ``hinge``, ``body``: names; ``knuckle``: number along the hinge, from 1; ``opening``: where.
    """

    share: float
    stress: float
    force: float
    hinge: str
    body: str
    knuckle: int
    opening: float


@dataclass(frozen=True)
class SnapForces:
    """How one unit snaps.

    ``openings`` (m,); ``opening`` and ``closing``: energies (m,) of both ways, N·mm;
    ``opening_torques``, ``closing_torques`` (m,): their derivatives by the angle about the leg at
    B, N·mm: what a hand must give; ``angle``: of the deployed unit, radians;
    ``lever``: ‖AB‖, mm; ``weakest``: on both ways; ``found``: whether all was computed;
    ``beyond``: torque that the deployed unit bears in the way of opening further, until a knuckle
    breaks or panels buckle, N·mm.
    """

    openings: NDArray
    opening: NDArray
    closing: NDArray
    opening_torques: NDArray
    closing_torques: NDArray
    angle: float
    lever: float
    weakest: Weakest
    found: bool
    beyond: float = 0.0

    @property
    def barrier(self) -> float:
        """Energy that opening takes, N·mm."""
        return float(max(self._peak(self.opening, self.opening_torques) - self.opening[0], 0.0))

    @property
    def closing_barrier(self) -> float:
        """Energy that folding back takes, N·mm."""
        return float(max(self._peak(self.closing, self.closing_torques) - self.closing[-1], 0.0))

    @property
    def torque(self) -> float:
        """Largest torque about the leg at B that opening takes, N·mm."""
        return float(max(_vertex(self.opening_torques), 0.0))

    @property
    def closing_torque(self) -> float:
        """Largest torque about the leg at B that folding back takes, N·mm."""
        return float(max(_vertex(-self.closing_torques), 0.0))

    @property
    def hand(self) -> float:
        """Force of a hand that opens it, N: at the A ends of the contact panels, ‖AB‖ from B."""
        return self.torque / self.lever

    @property
    def unstable(self) -> tuple[float, float] | None:
        """Openings between which it moves on by itself: from the barrier to where it is at rest.

        A hand that opens it feels the snap there, and cannot hold it; None if it does not snap.
        """
        if self.barrier <= _NOTHING:
            return None
        fine, energies = self._fine(), self._curve(self.opening, self.opening_torques)
        peak = int(energies.argmax())
        rest = energies[peak:].min() + _AT_REST * self.barrier
        return float(fine[peak]), float(fine[peak + int(np.argmax(energies[peak:] <= rest))])

    def _peak(self, energies: NDArray, torques: NDArray) -> float:
        return self._curve(energies, torques).max()

    def _fine(self) -> Any:
        shares = np.arange(_FINE) / _FINE
        start, end = self.openings[:-1], self.openings[1:]
        return np.append((start[:, None] + shares * (end - start)[:, None]).ravel(), end[-1])

    def _curve(self, energies: NDArray, torques: NDArray) -> NDArray:
        """Energies at `_fine`: cubic between nodes, with their torques as slopes."""
        s = (np.arange(_FINE) / _FINE)[None]
        width = np.diff(self.openings)[:, None] * self.angle
        a, b = energies[:-1, None], energies[1:, None]
        da, db = torques[:-1, None] * width, torques[1:, None] * width
        c = (2 * s**3 - 3 * s**2 + 1) * a + (s**3 - 2 * s**2 + s) * da
        c = c + (3 * s**2 - 2 * s**3) * b + (s**3 - s**2) * db
        return np.append(c.ravel(), energies[-1])


_AT_REST = 0.02  # of the barrier: what the energy at rest may still be above the least
_NOTHING = 0.02  # N·mm: less than the barrier of the computation itself


def snap_forces(
    thick: "ThickUnit",
    layouts: "Sequence[Layout]",
    parameters: "HingeParameters",
    material: "Material",
    orientation: str = FLAT,
    progress: "Progress" = NOBODY,
    in_tube: bool = True,
    openings: NDArray = OPENINGS,
) -> list[SnapForces]:
    """`SnapForces` of every unit of a compensated `ThickUnit` with its layouts.

    ``in_tube``: contact panels between two units are halves of a block. Units alike are computed
    once.
    """
    known, found = {}, []
    count = len(layouts)
    for k, layout in enumerate(layouts):
        unit = thick[k : k + 1]
        # Left and right are mirror images: which of them is joined counts, not its name.
        joined = (in_tube and k > 0, in_tube and k < count - 1)
        key = (np.round(unit._shifts, 5).tobytes(), np.round(unit._flat, 4).tobytes(), joined)
        if key not in known:
            own = progress.part(k / count, (k + 1) / count).named("Energy of the units")
            known[key] = unit_forces(unit, layout, parameters, material, orientation, joined,
                                     openings, progress=own)  # fmt: skip
        found.append(known[key])
    return found


def unit_forces(
    thick: "ThickUnit",
    layout: "Layout",
    parameters: "HingeParameters",
    material: "Material",
    orientation: str = FLAT,
    joined: Sequence[bool] = (False, False),
    openings: NDArray = OPENINGS,
    clearance: float = 1.0,
    progress: "Progress" = NOBODY,
) -> SnapForces:
    """`SnapForces` of one unit; ``clearance``: share of the hinges' clearance that is there."""
    found = contacts([layout], parameters)
    unit = elastic_unit(thick, layout, found, parameters, material, joined)
    poses = thick.states(np.asarray(openings, float)[None])[0]
    poses[..., :3, 3] *= thick.scale
    parts = [progress.part(*span) for span in ((0.0, 0.5), (0.5, 0.85), (0.85, 1.0))]
    back = follow(unit, openings[::-1], poses[::-1], clearance, progress=parts[0])[::-1]
    forth = follow(unit, openings, poses, clearance, back, progress=parts[1])
    tabs = tabs_of(layout, found, parameters)

    def worked(rest: "Rest", opening: float) -> Weakest:
        return weakest_tab(rest, opening, found, tabs, material, _UP[orientation])

    worst = [max(zip(openings, way, strict=True), key=_hardest) for way in (forth, back)]
    weakest = max((worked(rest, x) for x, rest in worst), key=lambda tab: tab.share)
    beyond = bears_beyond(unit, thick, back[-1], lambda *at: worked(*at).share, clearance, parts[2])
    energies = [np.array([rest.energy for rest in way]) for way in (forth, back)]
    torques = [np.array([rest.torque for rest in way]) for way in (forth, back)]
    return SnapForces(
        np.asarray(openings, float), energies[0], energies[1], torques[0], torques[1],
        abs(unit.turn), thick.scale, weakest, all(rest.found for rest in (*forth, *back)),
        beyond,
    )  # fmt: skip


def _hardest(at: "tuple[float, Rest]") -> float:
    return float(np.linalg.norm(at[1].forces.sum(1), axis=-1).max())


def follow(
    unit: "ElasticUnit",
    openings: NDArray,
    poses: NDArray,
    clearance: float = 1.0,
    known: Any = None,
    progress: "Progress" = NOBODY,
) -> list:
    """Rests at openings in their order; ``poses``: rigid ones of least misfit, to start from.

    ``known``: rests of another way through these openings, which may be the same.
    """
    state, found = start(unit, poses[0]), []
    for k, opening in enumerate(openings):
        progress.step(fraction=k / len(openings))
        if k:
            moved = poses[k] @ rigid.inverse(poses[k - 1]) @ state.poses
            state = State(moved, state.modes)
        rest = least(unit, opening, state, clearance, known=known[k] if known else None)
        state = rest.state
        found.append(rest)
    return found


def weakest_tab(
    rest: "Rest",
    opening: float,
    found: "Contacts",
    tabs: Mapping[tuple[int, ...], tuple[knuckles.Tab, int, Sequence[int]]],
    material: "Material",
    up: NDArray,
) -> Weakest:
    """`Weakest` of all tabs at one rest; ``tabs``: of `elastic.tabs_of`; ``up``: of the print."""
    axes = found.axes[0]
    high = np.stack([np.broadcast_to([0.0, 1.0, 0.0], axes.shape),
                     np.cross(axes, [0.0, 1.0, 0.0]), axes], -1)  # fmt: skip
    pushed = (high[:, None] @ rest.forces[..., None])[..., 0]  # on the second body, first's frame
    poses = rest.state.poses
    back = np.swapaxes(poses[SECOND, :3, :3], -1, -2) @ poses[FIRST, :3, :3]
    on = -pushed, (back[:, None] @ pushed[..., None])[..., 0]
    worst = Weakest(0.0, 0.0, 0.0, "", "", 0, float(opening))
    for (side, hinge, _), (tab, knuckle, places) in tabs.items():
        forces = on[side][hinge, places]
        points = found.points[0, hinge, places]
        # all places of a tab push at once: the moments add
        stress = knuckles.stress(tab, points, forces)
        lying = 1 - (tab.frame[:, 0] @ up) ** 2
        bears = material.strength * (material.layer_share + (1 - material.layer_share) * lying)
        share = stress / bears
        if share > worst.share:
            body = BODIES[(FIRST, SECOND)[side][hinge]]
            force = float(np.linalg.norm(forces.sum(0)))
            worst = Weakest(float(share), float(stress), force, CREASES[hinge].name, body,
                            knuckle + 1, float(opening))  # fmt: skip
    return worst


def _vertex(values: NDArray) -> float:
    """Largest of values, between samples, by the parabola through three (as if evenly spaced)."""
    k = int(np.clip(values.argmax(), 1, len(values) - 2))
    left, middle, right = values[k - 1 : k + 2]
    bend = left - 2 * middle + right
    if bend >= 0:
        return values.max()
    offset = np.clip((left - right) / (2 * bend), -1, 1)
    return max(middle - (left - right) * offset / 4, values.max())
