# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole tube: units of a placement in space, chained by the contact panels they share.

Units are congruent by proper motions: x towards the joint B, z along the legs to "upper". Their
own left contact panel (y < 0) is therefore the incoming one where the joint lies on the right of
the path, and the outgoing one where it lies on the left; `Placement.sides` tells.
"""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from .. import unit as units
from ..curves.bezier import normalised
from ..errors import Refusal
from .contacts import contact_pairs, sphere_contacts
from .creases import INDEX
from .deployment import contact_frame, opening_state
from .general import general_unit
from .oblique import Leaning, leaning

if TYPE_CHECKING:
    from ..curves.placement import Placement
    from .closed_forms import Unit
    from .ratios import RatioRule


@dataclass(frozen=True)
class Tube:
    """Units (a batch `Unit`) and where they stand when deployed.

    ``frames`` (n, 4, 4): unit's own deployed frame → space; ``incoming_left`` (n,) bool: the
    unit's own left contact panel is the one shared with the previous unit; ``leaning``: of units
    between contacts that may lean, None where all stand upright.
    """

    unit: units.Unit
    frames: np.ndarray
    incoming_left: np.ndarray
    leaning: Leaning | None = None

    def __len__(self) -> int:
        return len(self.frames)

    def __getitem__(self, units: slice) -> "Tube":
        """The tube of a slice of its units."""
        leans = self.leaning and self.leaning[units]
        return Tube(self.unit[units], self.frames[units], self.incoming_left[units], leans)

    def deployed(self) -> NDArray:
        """Vertices (n, 10, 3) of all units in the deployed tube, exact."""
        return rigid.apply(self.frames, self.unit.deployed)

    def state(self, opening: float) -> NDArray:
        """Vertices (n, 10, 3) of the tube opened to the fraction ``opening`` in [0, 1].

        The first contact panel stays where it is in the deployed tube; every unit hangs on the
        outgoing contact panel of the one before.
        """
        if not 0 <= opening <= 1:
            raise Refusal(
                "{Deployment} is {opening:.6g}: it must lie between 0 and 1.",
                parameter="Deployment",
                opening=opening,
            )
        deployed = self.deployed()
        if opening == 1:
            return deployed
        own = opening_state(self.unit, opening)
        before, after = self._shared_frames(deployed)
        joints = rigid.inverse(after[:-1]) @ before[1:]
        own_before, own_after = self._shared_frames(own)
        steps = rigid.inverse(own_before) @ own_after
        place = np.empty_like(self.frames)
        hang = before[0]
        for k in range(len(self)):
            place[k] = hang @ rigid.inverse(own_before[k])
            if k < len(joints):
                hang = hang @ steps[k] @ joints[k]
        return rigid.apply(place, own)

    def _shared_frames(self, points: NDArray) -> tuple[NDArray, NDArray]:
        """Frames (n, 4, 4) of the incoming and of the outgoing contact panel of every unit."""
        left, right = contact_frame(points, "left"), contact_frame(points, "right")
        which = self.incoming_left[:, None, None]
        return np.where(which, left, right), np.where(which, right, left)


def make_unit(
    family: str,
    theta: NDArray,
    edge_length: float,
    height_ratio: float,
    rule: "RatioRule",
    omega: NDArray | float | None = None,
) -> "Unit":
    """A `Unit` (or batch) of family "Plane" or "Sphere" by the surface's parameters.

    ``theta`` and ``omega`` in radians, ``height_ratio`` = ‖AB‖/h, ``rule`` a `ratios.RatioRule`.
    On a sphere the rules Exact and Paper give the paper's unit, all others the general unit between
    the same contacts, whose ratio is as free as on a plane.
    """
    height = _strip_height(edge_length, height_ratio)
    if family == "Sphere" and rule.is_sphere_rule:
        return units.sphere_unit(theta, edge_length, omega, height, rule.for_sphere())
    if family == "Sphere":
        contacts = sphere_contacts(np.atleast_1d(theta), edge_length, omega, height)
        return general_unit(contacts[0], contacts[1], rule.ratios(*leaning(*contacts)))
    return units.plane_unit(theta, rule.ratios(theta), edge_length, height)


@dataclass(frozen=True)
class Tuning:
    """Small changes of the units that thick panels ask for: see `thick_tube`.

    ``extra`` (mm) is for `placement.place`; ``sines`` is added to sin(θ/2) of every unit: (n,), the
    last value counts for all further units. ``near``: the `Placement` before, for
    `rules.PlacementRule`.
    """

    extra: np.ndarray = field(default_factory=lambda: np.zeros(1))
    sines: np.ndarray = field(default_factory=lambda: np.zeros(1))
    near: Any = None

    def fitted(self, values: NDArray, count: int) -> NDArray:
        """The first ``count`` values, the last one repeated."""
        return np.concatenate([values, np.full(max(0, count - len(values)), values[-1])])[:count]


def along(
    placement: "Placement",
    family: str,
    height_ratio: float,
    rule: "RatioRule",
    sphere_radius: float | None = None,
    tuning: Tuning | None = None,
) -> "Tube":
    """The `Tube` of a `Placement`; parameters as in `make_unit`, ``sphere_radius`` of the curve.

    ``tuning``: a `Tuning` for thick panels.
    """
    tuning = tuning or Tuning()
    sines = tuning.fitted(tuning.sines, len(placement))
    if family == "Sphere":
        _check_on_sphere(placement, sphere_radius)
    if family == "General" or (family == "Sphere" and not rule.is_sphere_rule):
        return _along_any_curve(placement, height_ratio, rule, sines)
    thetas, omega = placement.thetas, None
    if sines.any():
        thetas = 2 * np.arcsin(np.sin(thetas / 2) + sines)
    if family == "Sphere":
        omega = np.arctan2(1, _leg_slopes(placement, sphere_radius))
    unit = make_unit(family, thetas, placement.edge_length, height_ratio, rule, omega)
    return Tube(unit, _frames(placement, unit), placement.sides < 0)


def _along_any_curve(
    placement: "Placement", height_ratio: float, rule: "RatioRule", sines: NDArray
) -> Tube:
    """Units between the contact panels of a placement with any legs: section 4."""
    contacts = contact_pairs(placement, _strip_height(placement.edge_length, height_ratio), sines)
    theta, leans = leaning(*contacts)
    unit = general_unit(*contacts, rule.ratios(theta, leans))
    frames = np.broadcast_to(np.eye(4), (len(placement), 4, 4)).copy()
    return Tube(unit, frames, placement.sides < 0, leans)


def _strip_height(edge_length: float, height_ratio: float) -> float:
    if not (np.isfinite(height_ratio) and height_ratio > 0):
        raise Refusal(
            "{HeightRatio} ‖AB‖/h is {height_ratio:.6g}: it must be a number above 0, 2.5 is "
            "usual.",
            parameter="HeightRatio",
            height_ratio=height_ratio,
        )
    return edge_length / height_ratio


def _leg_slopes(placement: "Placement", sphere_radius: Any) -> NDArray:
    """cot ω of every unit's contact trapezoids: (n,).

    The leg at B lies where the unit's mid-plane meets the plane of its block: both pass V. Without
    thickness that is tan ω = 2 r / ‖AB‖ for all; a pitch sets blocks further apart, which makes
    the legs of a unit meet a little nearer.
    """
    apart = np.linalg.norm(np.diff(placement.midpoints, axis=0), axis=1)
    return apart / (2 * sphere_radius * np.sin(placement.thetas / 2))


def _check_on_sphere(placement: "Placement", radius: Any) -> None:
    """The distance of all midpoints from V must be the radius of the curve's sphere."""
    reach = placement.distances_from_centre
    off = np.abs(reach - radius)
    if off.max() > 1e-6 * radius:
        k = int(np.argmax(off))
        raise Refusal(
            "Curve is not on the sphere: near midpoint {number} it is {reach:.6g} mm from the "
            "centre instead of {SphereRadius} {radius:.6g} mm; project the curve onto the sphere "
            "or correct {SphereRadius} and {SphereCenter}.",
            parameter="SphereRadius",
            number=k + 1,
            reach=reach[k],
            radius=radius,
        )


def single(unit: "Unit") -> Tube:
    """A `Tube` of one unit that stands in its own frame."""
    batch = unit if unit.flat.ndim == 3 else unit[None]
    return Tube(batch, np.eye(4)[None], np.ones(1, bool))


def _frames(placement: "Placement", unit: "Unit") -> NDArray:
    """Where the units' own deployed frames stand: (n, 4, 4).

    The base A_left–B–A_right of each unit is laid on the zigzag; with a pitch its B lies in the
    middle of the double hinge that joins the two contact blocks.
    """
    start, joint = placement.segments[:-1, 0], placement.segments[:-1, 1]
    next_joint, end = placement.segments[1:, 0], placement.segments[1:, 1]
    travel = normalised(end - start)
    x = (joint + next_joint) / 2 - (start + end) / 2
    x = normalised(x - (x * travel).sum(1, keepdims=True) * travel)
    z = np.cross(x, travel)
    z *= np.sign((z * placement.legs[:-1]).sum(1, keepdims=True))
    frames = np.zeros((len(placement), 4, 4))
    frames[:, :3, 0], frames[:, :3, 1], frames[:, :3, 2] = x, np.cross(z, x), z
    frames[:, 3, 3] = 1
    # The base that follows the zigzag: half way up the strip (plane) or the outer one (sphere).
    base = unit.deployed[:, INDEX["B_upper"]].copy()
    base[:, 2] = 0 if unit.omega is None else base[:, 2]
    frames[:, :3, 3] = (joint + next_joint) / 2 - np.einsum("nij,nj->ni", frames[:, :3, :3], base)
    return frames
