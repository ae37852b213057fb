# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bistable unit of thick panels: twelve panels and three links on twenty-three hinge axes.

Folded flat, the panels lie in four layers and every axis between two of them (hinges.md 1, 2;
the table is `creases.CREASES`), so that away from the flat state thick panels close only where the
axes are shifted for it. `ThickUnit` finds the poses of least misfit at a prescribed opening, and
the smallest shifts with which the deployed state closes exactly (docs/theory/hinges.md 3).

Frame: the unit's flat frame, plan (x, z), stack along +y, left contact panel in layer 1; poses
carry points of the flat state and keep the left contact panel where it is.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import rigid
from ..errors import name_of, require
from ..units.creases import BODIES, CREASES, INDEX
from .closure import RIGHT, Closure, settle
from .compensation import compensate, normals, shifted
from .guesses import jumps_between, without_thickness

if TYPE_CHECKING:
    from ..units.closed_forms import Unit

__all__ = ["BODIES", "CREASES", "FURTHEST", "ThickUnit"]

FURTHEST = 1.125  # the largest opening, in multiples of theta, that can be asked for
STEPS = 24  # of the path between flat and deployed
_DEPLOYED, _LAST = STEPS, round(FURTHEST * STEPS)
# At the first node no body has turned by more than some degrees, in radians.
_NEARLY_FLAT = 0.5
_CURE = (
    "make {FaceThickness} and {GapBetweenPlanes} smaller (their sum is {pitch:.4g} mm), "
    "{EdgeLength} longer than {edge:.4g} mm, or {Ratio} larger"
)
_ENDS = np.array([[INDEX[v] for v in c.vertices] for c in CREASES])
_HEIGHTS = np.array([c.height for c in CREASES], float)


class ThickUnit:
    """One unit, or a batch of n, of thick panels; arrays of a batch have a leading n.

    ``unit``: `unit.Unit` in mm; ``face_thickness`` t and ``gap_between_planes`` g in mm, both
    above 0; ``shifts`` (23, 2) mm moves the start and the end of every axis across it in the flat
    plane, along ``normals``; ``lines``: see `lines`; ``rest``: `preload.Rest` of units that are
    preloaded. ValueError names the parameter, or the unit that has no solution.
    """

    def __init__(
        self,
        unit: "Unit",
        face_thickness: float,
        gap_between_planes: float,
        shifts: NDArray | None = None,
        lines: NDArray | None = None,
        rest: Any = None,
    ) -> None:
        for name, value in (
            ("FaceThickness", face_thickness),
            ("GapBetweenPlanes", gap_between_planes),
        ):
            require(
                np.isfinite(value) & (np.asarray(value) > 0),
                "{name} is {value:.6g} mm: set it to a length above 0.",
                value,
                parameter=name,
                name=name_of(name),
            )
        self.unit = unit
        self.face_thickness = float(face_thickness)
        self.gap_between_planes = float(gap_between_planes)
        self.pitch = self.face_thickness + self.gap_between_planes
        self._single = unit.flat.ndim == 2
        n = len(unit)
        given = np.zeros((n, len(CREASES), 2)) if shifts is None else np.asarray(shifts, float)
        self._shifts = given.reshape(n, len(CREASES), 2)
        self._lines = self._middles() if lines is None else np.reshape(lines, (n, 2, 2, 3))
        self.rest = rest
        self._known: dict[Any, Any] = {}

    def __len__(self) -> int:
        return len(self.unit)

    def __getitem__(self, units: NDArray | slice) -> "ThickUnit":
        """A smaller batch (a slice of units), shifts and lines kept."""
        thicknesses = self.face_thickness, self.gap_between_planes
        given = self._shifts[units], self._lines[units], self.rest and self.rest.take(units)
        return ThickUnit(self.unit[units], *thicknesses, *given)

    def laid(self, lines: NDArray) -> "ThickUnit":
        """The same unit with other `lines`."""
        return self._with(lines, self.rest)

    def resting(self, rest: Any) -> "ThickUnit":
        """The same unit, preloaded, with its `preload.Rest`: deployed it stands there."""
        return self._with(self._lines, rest)

    def _with(self, lines: NDArray, rest: Any) -> "ThickUnit":
        both = self.face_thickness, self.gap_between_planes
        result = ThickUnit(self.unit, *both, self._shifts, lines, rest)
        result._known = self._known
        return result

    def shifted(self, more: NDArray | float) -> "ThickUnit":
        """The same unit with ``more`` (23, 2) mm added to its `shifts`; at rest nowhere."""
        thicknesses = self.face_thickness, self.gap_between_planes
        return ThickUnit(self.unit, *thicknesses, self._shifts + more, self._lines)

    @property
    def shifts(self) -> NDArray:
        """Shifts across the axes of their start and end, mm: (23, 2)."""
        return self._out(self._shifts)

    @property
    def axes(self) -> NDArray:
        """Axis ends in the flat state, shifts included, mm: (23, 2, 3)."""
        return self._out(shifted(self._nominal, self._shifts))

    @property
    def normals(self) -> NDArray:
        """Directions in the flat plane along which shifts count, +y × (end − start): (23, 3)."""
        return self._out(normals(self._nominal))

    @property
    def opening(self) -> NDArray | float:
        """Angle between the contact panels about the leg at B when deployed, radians."""
        return self._out(np.abs(self._closure.turn))

    def poses(self, x: Any) -> NDArray:
        """Rigid transforms from the flat state to opening ``x``, of least squared misfit.

        ``x``: fraction of the opening angle, 0 flat, 1 deployed, up to `FURTHEST`; a number, or
        (m,). Returns (15, 4, 4) or (m, 15, 4, 4) in the order of `BODIES`, lengths in mm; that of
        contact_left is the identity, so a tube's next unit hangs on that of contact_right.
        """
        poses = self.states(np.ravel(x)[None])
        poses[..., :3, 3] *= self.scale
        return self._out(poses.reshape(len(self), *np.shape(x), *poses.shape[2:]))

    def gaps(self, x: NDArray | Sequence[Any]) -> NDArray:
        """Misfit at the start and end of every hinge, mm: (23, 2) or (m, 23, 2)."""
        fractions = np.ravel(x)[None]
        poses = self.states(fractions)
        gaps = self.closures(fractions).gaps(poses.reshape(-1, *poses.shape[2:])) * self.scale
        return self._out(gaps.reshape(len(self), *np.shape(x), *gaps.shape[1:]))

    def misfit(self, x: Any) -> NDArray:
        """Distance of the two bodies' images of the worse axis end, mm: (23,) or (m, 23)."""
        return self.gaps(x).max(-1)

    def compensated(self) -> "ThickUnit":
        """The same unit with the smallest shifts that close it when deployed (theory/hinges.md 3).

        ValueError names the first unit for which there are none.
        """
        shifts, poses, converged = self._compensation
        require(
            converged,
            "Hinges{at} cannot be shifted so that the unit closes when deployed (at {value:.0f}°): "
            + _CURE
            + "; beyond 110° only less {Gamma} or a {Ratio} nearer to sin(theta/2) helps.",
            np.degrees(np.abs(self._closure.turn)),
            parameter="FaceThickness",
            pitch=self.pitch,
            edge=self.scale,
        )
        result: ThickUnit = self.shifted(shifts * self.scale - self._shifts)
        result._known[_DEPLOYED] = poses
        return result

    def contact_transform(self, x: float = 1.0) -> NDArray:
        """Pose of the right contact panel seen from the left one, mm: (4, 4)."""
        return self.poses(x)[..., RIGHT, :, :]

    @property
    def lines(self) -> NDArray:
        """Mid-lines A-B of the two blocks that hold the contact panels, flat state, mm: (2, 2, 3).

        A block joins layer 4 of one unit to layer 1 of the next, so its mid-plane lies two pitches
        from the unit's middle. Blocks follow the curve, and lie on each other, by these lines: the
        middle of the strip, its upper end where the legs meet in a point; `laid` moves them.
        """
        return self._out(self._lines)

    def block_lines(self, x: float = 1.0) -> NDArray:
        """`lines` at opening ``x`` in the left contact panel's frame, mm: (2, 2, 3)."""
        poses = self.poses(x)
        poses = poses[None] if self._single else poses
        return self._out(rigid.apply(poses[:, [0, RIGHT]], self._lines))

    # -- for `snap`: always batched, lengths in edge lengths --------------------------------------

    @property
    def scale(self) -> float:
        """Edge length ‖AB‖, mm."""
        return self.unit.edge_length

    @property
    def turns(self) -> NDArray:
        """Angle of the right contact panel about the leg at B when deployed, with sign, (n,)."""
        return self._closure.turn

    def closures(self, fractions: ArrayLike) -> "Closure":
        """Closures of all units at openings (n or 1, m): a batch of n·m, openings fastest."""
        fractions = np.broadcast_to(fractions, (len(self), np.shape(fractions)[1]))
        m, whole = fractions.shape[1], self._closure
        axes, leg, turn = (np.repeat(a, m, 0) for a in (whole.axes, whole.leg, whole.turn))
        return Closure(axes, leg, turn * fractions.ravel())

    def states(self, fractions: NDArray) -> NDArray:
        """Poses (n, m, 15, 4, 4) of least misfit at openings (n or 1, m)."""
        fractions = np.asarray(fractions, float)
        require(
            ((fractions >= -1e-9) & (fractions <= FURTHEST + 1e-9)).ravel(),
            "{Deployment} is {value:.6g}: it must lie between 0 (flat) and 1 (deployed), at most "
            "{0:.4g}.",
            fractions.ravel(),
            FURTHEST,
            parameter="Deployment",
        )
        fractions = np.clip(fractions, 0, FURTHEST)
        poses = np.empty((len(self), fractions.shape[1], len(BODIES), 4, 4))
        flat, deployed = (fractions == 0).all(0), (fractions == 1).all(0)
        poses[:, flat] = np.eye(4)
        if deployed.any():
            poses[:, deployed] = self._node(_DEPLOYED)[:, None]
        rest = ~flat & ~deployed
        if rest.any():
            poses[:, rest] = self._near(np.broadcast_to(fractions, poses.shape[:2])[:, rest])
        between = rest & (fractions * STEPS % 1 != 0).any(0)
        if between.any():
            poses[:, between] = self._settled(fractions[:, between], poses[:, between])
        return poses if self.rest is None else self.rest.on(poses, fractions)

    def near(self, units: NDArray, fractions: NDArray) -> tuple[Closure, NDArray]:
        """Closures, and poses (k, 15, 4, 4) not quite of least misfit, of some units.

        Unit ``units[i]`` at the opening ``fractions[i]``: interpolated from the nodes of the path.
        """
        place = fractions * STEPS
        below = np.minimum(place.astype(int), _LAST - 1)
        share = place - below
        start, end = (
            np.stack([self._node(b)[u] for b, u in zip(nodes.tolist(), units, strict=True)])
            for nodes in (below, below + (share > 0))  # no node is found that none is near to
        )
        share = np.where(jumps_between(start, end) & (share > 0), below < _DEPLOYED, share)
        whole = self._closure.take(units)
        closure = Closure(whole.axes, whole.leg, whole.turn * fractions)
        return closure, rigid.between(start, end, share[:, None])

    # -- inside ------------------------------------------------------------------------------------

    def _out(self, array: NDArray) -> NDArray:
        return array[0] if self._single else array

    @property
    def _flat(self) -> NDArray:
        return self.unit.flat.reshape(-1, *self.unit.flat.shape[-2:])

    def _middles(self) -> NDArray:
        ends = ("upper", "lower") if self.unit.omega is None else ("upper",)
        corners = [
            [[INDEX[f"{corner}_{end}"] for end in ends] for corner in (f"A_{side}", "B")]
            for side in ("left", "right")
        ]
        lines = self._flat[:, corners].mean(-2)
        lines[..., 1] += np.array([[-2], [2]]) * self.pitch
        return lines

    @cached_property
    def _nominal(self) -> NDArray:
        axes = self._flat[:, _ENDS].copy()
        axes[..., 1] += _HEIGHTS[:, None] * self.pitch
        return axes

    @cached_property
    def _guess(self) -> NDArray:
        deployed = self.unit.deployed.reshape(self._flat.shape)
        return without_thickness(self._flat / self.scale, deployed / self.scale)

    @cached_property
    def _closure(self) -> Closure:
        leg = self._flat[:, INDEX["B_upper"]] - self._flat[:, INDEX["B_lower"]]
        leg = leg / np.linalg.norm(leg, axis=-1, keepdims=True)
        turn = rigid.twist_angle(self._guess[:, RIGHT, :3, :3], leg)
        require(
            turn < 0,
            "Panels{at} would open inside out, through one another: swap its left and right "
            "contact panels.",
        )
        return Closure(shifted(self._nominal, self._shifts) / self.scale, leg, turn)

    @cached_property
    def _compensation(self) -> tuple[NDArray, ...]:
        nominal = Closure(self._nominal / self.scale, self._closure.leg, self._closure.turn)
        return compensate(nominal, self._guess)

    def _near(self, fractions: NDArray) -> NDArray:
        """Poses at openings (n, m), interpolated from the nodes of the path.

        Where the unit jumps between two nodes, those of the one nearer to the deployed state.
        """
        place = fractions * STEPS
        below = np.minimum(place.astype(int), _LAST - 1)
        first = below.min()
        nodes = np.stack([self._node(k) for k in range(first, below.max() + 2)])
        which = np.arange(len(self))[:, None]
        start, end = nodes[below - first, which], nodes[below - first + 1, which]
        share = place - below
        share = np.where(jumps_between(start, end) & (share > 0), below < _DEPLOYED, share)
        return rigid.between(start, end, share[..., None])

    def _node(self, k: int) -> NDArray:
        """Poses (n, 15, 4, 4) at opening k / STEPS, followed from the deployed state."""
        if k not in self._known:
            if k == 0:
                found = np.broadcast_to(np.eye(4), self._guess.shape)
            elif k == _DEPLOYED:
                found = self._settled([[1.0]], self._guess[:, None])[:, 0]
            else:
                found = self._followed(k)
            if k == 1:
                self._check_flat(found)
            self._known[k] = found
        return self._known[k]

    def _followed(self, k: int) -> NDArray:
        """Poses at node k from those at the nodes next to it, towards the deployed state."""
        back = 1 if k < _DEPLOYED else -1
        guess = near = self._node(k + back)
        if k + back != _DEPLOYED:
            far = self._node(k + 2 * back)
            steady = ~jumps_between(far, near)
            guess = rigid.between(far, near, np.where(steady, 2.0, 1.0)[:, None])
        found = self._settled([[k / STEPS]], guess[:, None])[:, 0]
        jumps = jumps_between(found, near)
        if jumps.any():
            # Where to depends on where from: the same as in `_near`.
            again = self._settled([[k / STEPS]], near[:, None])[:, 0]
            found = np.where(jumps[:, None, None, None], again, found)
        return found

    def _check_flat(self, poses: NDArray) -> None:
        turns = np.linalg.norm(rigid.rotation_vector(poses[..., :3, :3]), axis=-1).max(-1)
        require(
            turns < _NEARLY_FLAT,
            "The deployed state{at} does not fold flat: its panels are too thick and lock on the "
            "way; " + _CURE + ".",
            parameter="FaceThickness",
            pitch=self.pitch,
            edge=self.scale,
        )

    def _settled(self, fractions: ArrayLike, guesses: NDArray) -> NDArray:
        """Poses (n, m, 15, 4, 4) of least misfit at openings (n or 1, m), from guesses.

        Beyond the deployed state a unit may give way sideways, in so flat a valley that the steps
        run out: then the best poses found will do.
        """
        flat = guesses.reshape(-1, *guesses.shape[2:])
        poses, converged = settle(self.closures(fractions), flat)
        converged = converged.reshape(guesses.shape[:2])
        require(
            converged | (np.asarray(fractions) > 1),
            "Poses{at} cannot be found at {value:.0%} of its opening: " + _CURE + ".",
            fractions,
            parameter="FaceThickness",
            pitch=self.pitch,
            edge=self.scale,
        )
        return poses.reshape(guesses.shape)
