# SPDX-License-Identifier: LGPL-2.1-or-later
"""How hard a unit snaps whose hinges are strips of soft material (docs/theory/hinges.md 4).

A strip has no play: it stretches and shears where the panels miss each other, and it bends all the
way from flat. It is a wall between the middles of its two panels, linear elastic, the panels rigid
against it. Bending so thick and short a wall takes more than stretching it a little: mostly it
decides whether the unit stays open at all. Lengths mm, forces N, energies N·mm.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..progress import NOBODY
from ..thick.closure import FIRST, SECOND
from ..units.creases import BODIES, CREASES
from .contact import Contacts, lines
from .elastic import as_unit
from .forces import OPENINGS, SnapForces, Weakest, follow
from .knuckles import SHEAR_SHARE

if TYPE_CHECKING:
    from ..hinges.parameters import HingeParameters
    from ..hinges.unit_layout import Layout
    from ..progress import Progress
    from ..thick.linkage import ThickUnit
    from .materials import Material
    from .minimum import ElasticUnit, Rest

PLACES = np.array([1, 3, 5]) / 6  # of a strip's length: each stands for a third of it
_LAWS = ((1.0, 0.0), (0.0, 1.0), (0.0, -1.0))  # slope, lean: across the axis, and along it


@dataclass(frozen=True)
class Flexing:
    """A unit of rigid panels and strips.

    ``unit``: `minimum.ElasticUnit`; ``bending`` (23,): stiffness against turning, N·mm; ``areas``
    (23,): of a third of a strip, mm².
    """

    unit: "ElasticUnit"
    bending: NDArray
    areas: NDArray

    def turned(self, poses: NDArray) -> NDArray:
        """How far every hinge is bent at poses (15, 4, 4): (23,), radians."""
        first, second = poses[FIRST, :3, :3], poses[SECOND, :3, :3]
        back = np.swapaxes(first, -1, -2) @ second
        found: NDArray = np.linalg.norm(rigid.rotation_vector(back), axis=-1)
        return found

    def bent(self, poses: NDArray) -> float:
        """Energy of bending at poses, N·mm."""
        return float((self.bending * self.turned(poses) ** 2).sum() / 2)


def flexing(
    thick: "ThickUnit", layout: "Layout", parameters: "HingeParameters", soft: "Material"
) -> Flexing:
    """`Flexing` of one compensated unit with its `unit_layout.Layout`; ``soft``: the strips'."""
    origins, axes = (found[0] for found in lines([layout]))
    count = len(PLACES) * len(_LAWS)
    points, give = np.zeros((23, count, 3)), np.zeros((23, count, 3, 3))
    bending, areas = np.zeros(23), np.zeros(23)
    for k, crease in enumerate(CREASES):
        start, end = layout.hinges[crease.name].segments[0]
        span, wall, out = _wall(crease.bodies, layout, axes[k], parameters)
        share = (end - start) / len(PLACES)
        along = start + (end - start) * np.repeat(PLACES, len(_LAWS))
        points[k] = origins[k] + along[:, None] * axes[k]
        shear = span / (SHEAR_SHARE * soft.shear * wall * share)
        stretch = span / (soft.young * wall * share)
        across = span**3 / (soft.young * wall**3 * share) + shear
        frame = np.stack([out, np.cross(axes[k], out), axes[k]], -1)
        give[k] = frame @ np.diag([stretch, across, shear]) @ frame.T
        bending[k] = soft.young * wall**3 * (end - start) / (12 * span)
        areas[k] = wall * share
    slope, lean = (np.tile(law, (1, 23, len(PLACES))) for law in zip(*_LAWS, strict=True))
    valid = np.ones(slope.shape, bool)
    cones = np.broadcast_to(np.repeat(np.arange(len(PLACES)), len(_LAWS)), slope.shape)
    held = Contacts(points[None], axes[None], slope, lean, valid, cones, 0.0)
    modes = np.zeros((23, count, 3, 0))
    unit = as_unit(thick, held, (modes, modes), (give / 2, give / 2))
    return Flexing(unit, bending, areas)


def _wall(
    bodies: tuple, layout: "Layout", axis: NDArray, parameters: "HingeParameters"
) -> tuple[float, float, NDArray]:
    """Span of a strip, its thickness, and the way from panel to panel in the flat frame."""
    up = np.array([0.0, 1.0, 0.0])
    heights = {layout.plates[name].height for name in bodies if name in layout.plates}
    if len(bodies) == 2 and len(heights) == 1 and all(name in layout.plates for name in bodies):
        # level panels: a web as thick as the gap, from the middle of one beam to the other's
        return 2.5 * parameters.strip_thickness, parameters.gap_between_planes, np.cross(axis, up)
    return parameters.pitch, parameters.strip_thickness, up


def flexible_forces(
    thick: "ThickUnit",
    layout: "Layout",
    parameters: "HingeParameters",
    soft: "Material",
    progress: "Progress" = NOBODY,
    openings: NDArray = OPENINGS,
) -> SnapForces:
    """`SnapForces` of one unit with flexible hinges."""
    made = flexing(thick, layout, parameters, soft)
    poses = thick.states(np.asarray(openings, float)[None])[0]
    poses[..., :3, 3] *= thick.scale
    back = follow(made.unit, openings[::-1], poses[::-1], progress=progress.part(0, 0.6))[::-1]
    forth = follow(made.unit, openings, poses, 1.0, back, progress=progress.part(0.6, 1))
    angle = abs(made.unit.turn)
    energies, torques = [], []
    for way in (forth, back):
        bent = np.array([made.bent(rest.state.poses) for rest in way])
        energies.append(np.array([rest.energy for rest in way]) + bent)
        torques.append(
            np.array([rest.torque for rest in way]) + np.gradient(bent, openings * angle)
        )
    worst = max(
        (_weakest(rest, x, made, soft) for x, rest in zip(openings, back, strict=True)),
        key=lambda found: found.share,
    )
    return SnapForces(
        np.asarray(openings, float), energies[0], energies[1], torques[0], torques[1], angle,
        thick.scale, worst, all(rest.found for rest in (*forth, *back)),
        float(max(torques[1][-1], 0.0)),
    )  # fmt: skip


def _weakest(rest: "Rest", opening: float, made: Flexing, soft: "Material") -> Weakest:
    """The strip that is pulled hardest; bending strains it more, and it bears that."""
    pulled = rest.forces.reshape(23, len(PLACES), len(_LAWS), 3).sum(2)
    pulled = np.linalg.norm(pulled, axis=-1)
    stress = pulled.max(1) / made.areas
    k = int(stress.argmax())
    body = BODIES[FIRST[k]]
    return Weakest(
        float(stress[k] / soft.strength), float(stress[k]), float(pulled[k].max()),
        CREASES[k].name, body, 0, float(opening),
    )  # fmt: skip
