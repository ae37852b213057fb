# SPDX-License-Identifier: LGPL-2.1-or-later
"""Does it stand: a deployed tube under its own weight, in any direction (docs/theory/hinges.md 4).

Every unit can give way by folding about its leg at B; all else holds. The moment about that leg of
all that hangs on the unit stands against the torque that folding takes (`forces.SnapForces`). At
one held end that is statics alone; held at both, the far end's reaction is the one with which the
units' moments are least. Lengths mm, forces N, moments N·mm, masses g.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import Refusal
from ..hinges import volumes
from ..thick import print_stack
from ..units.creases import BODIES
from .slop import standing

if TYPE_CHECKING:
    from ..hinges.parameters import HingeParameters
    from ..hinges.unit_layout import Layout
    from ..thick.linkage import ThickUnit
    from .forces import SnapForces

GRAVITY = 9.81e-3  # N/g
START, BOTH = "Start", "Both"
MOST = 1000.0  # a safety factor, or a load in N, beyond which more says nothing
_OTHER = 0.05  # give of a unit across its leg, of that about its leg: both ends held


@dataclass(frozen=True)
class Load:
    """What the weight of a deployed tube asks of its n units.

    ``weight``: g; ``centre`` (3,): of mass in the print's frame, first block at rest, mm;
    ``moments`` (n,): about each unit's leg at B, positive where they fold it, N·mm; ``bears`` (n,):
    what folding (or, where the moment opens it, opening further) takes; ``factors`` (n,): safety,
    at most `MOST`; ``turned`` (n,): the least safety of each, whatever way gravity has; ``free``:
    extra load at the free end in gravity's direction, N; ``sag``: how far
    the free end gives way by elastic strain, mm: linear, from each unit's stiffness
    near its deployed state, so an estimate for a sag below a tenth of the length.
    """

    weight: float
    centre: NDArray
    moments: NDArray
    bears: NDArray
    factors: NDArray
    turned: NDArray
    free: float
    sag: float

    @property
    def weakest(self) -> int:
        """The unit, counted from 0, that gives way first."""
        return int(self.factors.argmin())

    @property
    def first_turned(self) -> int:
        """The unit, counted from 0, that gives way first when the tube is turned any way."""
        return int(self.turned.argmin())

    @property
    def stands(self) -> bool:
        """Whether no unit gives way."""
        return bool(self.factors.min() >= 1)


def masses(layouts: "Sequence[Layout]", parameters: "HingeParameters", density: float) -> NDArray:
    """Masses (n, 15), g, of all bodies of every unit, in the order of `creases.BODIES`.

    ``density``: g/cm³. The filler of a block counts half with either contact panel (what it takes
    up of the gap is the smaller of both cores, as good as).
    """
    found = np.zeros((len(layouts), len(BODIES)))
    for k, layout in enumerate(layouts):
        for b, name in enumerate(BODIES):
            if name in layout.plates:
                plate = layout.plates[name]
                volume = volumes.plate_volume(plate, parameters)
                inner = k > 0 if name == "contact_left" else k < len(layouts) - 1
                if name.startswith("contact") and inner:
                    area = abs(volumes.polygons.area(plate.core))
                    volume += area * parameters.gap_between_planes / 2
            elif not parameters.has_knuckles:
                continue
            else:
                volume = volumes.link_volume(layout.links[name], parameters)
            found[k, b] = volume * density / 1000
    return found


def carried(
    thick: "ThickUnit",
    layouts: "Sequence[Layout]",
    parameters: "HingeParameters",
    density: float,
    forces: "Sequence[SnapForces]",
    gravity: NDArray | Sequence[Any] = (0, 0, -1),
    fixed: str = START,
    incoming_left: NDArray | None = None,
) -> Load:
    """`Load` of a deployed tube.

    ``thick``, ``layouts``: its compensated units; ``density``: g/cm³; ``forces``: one
    `forces.SnapForces` a unit; ``gravity``: direction in the frame of the print (the first block at
    rest), any length; ``fixed``: "Start" (the first block is held) or "Both".
    """
    way = _direction(gravity, fixed)
    left = (
        print_stack.alternating(len(layouts))
        if incoming_left is None
        else np.asarray(incoming_left)
    )
    mass = masses(layouts, parameters, density)
    bodies = _Standing(thick, layouts, left, mass)
    levers = bodies.about_legs(bodies.at_end(way))
    stiff = np.array([_stiffness(each) for each in forces])
    each_way = [bodies.wrenches(pull) for pull in GRAVITY * np.eye(3)]
    if fixed == BOTH:
        by_axis = np.array([bodies.shared(wrenches, stiff) for wrenches in each_way])
        levers = np.zeros(len(layouts))
    else:
        by_axis = np.array([bodies.about_legs(wrenches) for wrenches in each_way])
    moments = way @ by_axis
    bears = np.array([_bears(each, m) for each, m in zip(forces, moments, strict=True)])
    least = np.array([min(each.closing_torque, each.beyond) for each in forces])
    return Load(
        float(mass.sum()), bodies.centre(), moments, bears, _factors(bears, moments),
        # moments are linear in gravity: the largest of all directions, of both senses
        _factors(least, np.linalg.norm(by_axis, axis=0)),
        _free(forces, moments, levers), float(np.abs(moments * levers / stiff).sum()),
    )  # fmt: skip


def _factors(bears: NDArray, moments: NDArray) -> Any:
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(moments == 0, MOST, np.minimum(bears / np.abs(moments), MOST))


def _direction(gravity: ArrayLike, fixed: str) -> NDArray:
    if fixed not in (START, BOTH):
        raise Refusal(
            "{FixedAt} is {value}: the tube has no support", cure="set it to Start or Both",
            parameter="FixedAt", value=repr(fixed),
        )  # fmt: skip
    way = np.asarray(gravity, float)
    length = np.linalg.norm(way)
    if not (np.isfinite(length) and length > 0):
        raise Refusal(
            "{Gravity} has no direction", cure="set it to 0, 0, -1 for example",
            parameter="Gravity",
        )  # fmt: skip
    return way / length


def _bears(forces: "SnapForces", moment: float) -> float:
    """Torque that a moment must overcome: folding, or opening beyond the deployed state."""
    return forces.closing_torque if moment > 0 else forces.beyond


def _stiffness(forces: "SnapForces") -> float:
    """Torque by angle near the deployed state, N·mm: secant up to the largest closing torque."""
    torques = -forces.closing_torques
    top = int(torques.argmax())
    angle = max((1 - forces.openings[top]) * forces.angle, 1e-3)
    return max(torques[top] / angle, 1e-3)


def _free(forces: "Sequence[SnapForces]", moments: NDArray, levers: NDArray) -> float:
    """Largest force at the free end with which no unit gives way, N."""
    room = []
    for each, moment, lever in zip(forces, moments, levers, strict=True):
        if abs(lever) < 1e-9:
            continue
        limit = each.closing_torque if lever > 0 else -each.beyond
        room.append((limit - moment) / lever)
    return float(np.clip(min(room, default=0.0), 0.0, MOST))


class _Standing:
    """Where every body of a deployed tube is, and what hangs on which unit."""

    def __init__(
        self, thick: "ThickUnit", layouts: "Sequence[Layout]", left: NDArray, mass: NDArray
    ) -> None:
        self.mass, self.left = mass, left
        motions = print_stack.motions(thick, 1.0, left)
        places = print_stack.frames(thick, left)
        self.centres = np.zeros((*mass.shape, 3))
        for k, layout in enumerate(layouts):
            for b, name in enumerate(BODIES):
                flat = _middle(layout, name)
                self.centres[k, b] = (motions[k, b] @ places[k] @ [*flat, 1])[:3]
        frames, self.end, _ = standing(thick, left)
        flats = thick.unit.flat.reshape(-1, 10, 3)
        ends = np.array([f @ np.append(p, 1) for f, p in zip(frames, flats[:, 0], strict=True)])
        starts = np.array([f @ np.append(p, 1) for f, p in zip(frames, flats[:, 1], strict=True)])
        self.on_leg = starts[:, :3]
        legs = ends[:, :3] - starts[:, :3]
        self.legs = legs / np.linalg.norm(legs, axis=1, keepdims=True)
        # sense in which the outgoing block turns about the leg when the unit opens
        turn = np.sign(thick._closure.turn)
        self.opens = np.where(left, turn, -turn)

    def centre(self) -> NDArray:
        """Centre of mass (3,), mm."""
        return (self.mass[..., None] * self.centres).sum((0, 1)) / self.mass.sum()

    def wrenches(self, pull: NDArray) -> NDArray:
        """Weight that hangs on every unit: forces and moments about the origin (n, 6).

        All of a unit but its incoming contact panel hangs on its leg: the safe side.
        """
        weight = self.mass.copy()
        own = weight.copy()
        entry = [BODIES.index(print_stack.contact_names(one)[0]) for one in self.left]
        own[np.arange(len(own)), entry] = 0
        forces = own[..., None] * pull
        moments = np.cross(self.centres, forces)
        each = np.concatenate([forces.sum(1), moments.sum(1)], -1)
        beyond = weight[..., None] * pull
        whole = np.concatenate([beyond.sum(1), np.cross(self.centres, beyond).sum(1)], -1)
        after = np.concatenate([np.cumsum(whole[::-1], 0)[::-1][1:], np.zeros((1, 6))])
        return each + after

    def at_end(self, force: NDArray) -> NDArray:
        """A force (3,) at the free end as wrenches (n, 6)."""
        return np.tile(np.concatenate([force, np.cross(self.end, force)]), (len(self.legs), 1))

    def at_legs(self, wrenches: NDArray) -> NDArray:
        """Moments (n, 3) about points on the legs."""
        return wrenches[:, 3:] - np.cross(self.on_leg, wrenches[:, :3])

    def about_legs(self, wrenches: NDArray) -> NDArray:
        """Moments (n,) about the legs, positive where they fold."""
        return -self.opens * (self.at_legs(wrenches) * self.legs).sum(1)

    def shared(self, wrenches: NDArray, stiff: NDArray) -> NDArray:
        """Moments (n,) about the legs with the far end held too."""
        rows, known = [], []
        weights = 1 / np.sqrt(stiff)
        for k, leg in enumerate(self.legs):
            reach = np.hstack([-_skew(self.end - self.on_leg[k]).T @ np.eye(3), np.eye(3)])
            # split: about the leg with its stiffness, across it nearly rigid
            split = weights[k] * (np.outer(leg, leg) * (1 - _OTHER) + _OTHER * np.eye(3))
            rows.append(split @ reach)
            known.append(split @ self.at_legs(wrenches)[k])
        reaction = np.linalg.lstsq(np.vstack(rows), -np.concatenate(known), rcond=None)[0]
        force, moment = reaction[:3], reaction[3:]
        at_end = np.concatenate([force, moment + np.cross(self.end, force)])
        return self.about_legs(wrenches + at_end)


def _skew(v: NDArray) -> NDArray:
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def _middle(layout: "Layout", name: str) -> tuple[float, ...]:
    """Centre of a body in the unit's flat frame, by its core (panels) or its axes (links)."""
    if name in layout.plates:
        plate = layout.plates[name]
        corners = np.array([[p.real, p.imag] for p in plate.core])
        following = np.roll(corners, -1, 0)
        cross = corners[:, 0] * following[:, 1] - following[:, 0] * corners[:, 1]
        x, z = ((corners + following) * cross[:, None]).sum(0) / (3 * cross.sum())
        return x, plate.height, z
    link: Any = layout.links[name] if layout.links else None
    points = [h.point((h.stretch[0] + h.stretch[1]) / 2) for h in link.hinges]
    middle = sum(points) / len(points)
    return middle.real, 0.0, middle.imag
