# SPDX-License-Identifier: LGPL-2.1-or-later
"""How strongly a unit snaps between its two stable states (docs/theory/hinges.md 4).

Without thickness: the energy of its edges as bars on the way (`energy_path`, `barrier`). With
thickness: the misfit of its hinges on the way, and the clearance with which it would open without
strain, against that which its hinges have (`assess`).
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import phrase
from ..thick.linkage import STEPS
from ..thick.preload import without
from ..units import energy
from ..units.creases import CREASES
from .clearance import least_clearance
from .contact import outermost

if TYPE_CHECKING:
    from ..errors import Phrase
    from ..thick.linkage import ThickUnit
    from .contact import Contacts

__all__ = ["Snap", "assess", "barrier", "energy_path", "needed_clearance", "peak_misfit"]

_NODES = np.arange(STEPS + 1) / STEPS
_AGAIN = 4  # rounds of looking again at the largest levels
_LESS = 1e-3  # of a level: less is no gain
_AROUND = np.array([-0.67, -0.33, 0, 0.33, 0.67])


def energy_path(
    alpha: NDArray | float, beta: NDArray | float, n: int = 100, end: float = 1.0
) -> tuple:
    """Energy of a zero-thickness unit on its way from flat to ``end`` (1: deployed).

    ``alpha``, ``beta``: radians, scalars or arrays of one shape. Returns the opening as a fraction
    of θ (n,) and the energy in EA·‖AB‖ (…, n): bars with Green strain, both pyramids on one planar
    base, each edge counted once, minimised at each opening. ValueError outside the range of (3).
    """
    fractions = np.linspace(0, end, n)
    return fractions, energy.path(alpha, beta, fractions)[0]


def barrier(alpha: NDArray | float, beta: NDArray | float, n: int = 100) -> tuple:
    """Energy barrier in EA·‖AB‖, the opening fraction where it stands, and the largest strain.

    Arguments as in `energy_path`; three arrays of their shape.
    """
    fractions = np.linspace(0, 1, n)
    values, strains = energy.path(alpha, beta, fractions)
    peak, place = _vertex(values)
    return peak[()], (place / (n - 1))[()], np.abs(strains).max((-1, -2))[()]


def peak_misfit(thick: "ThickUnit") -> tuple:
    """Largest hinge misfit between the two stable states, in least squares.

    ``thick``: `linkage.ThickUnit`. Returns mm, the opening fraction and the hinge (index into
    `creases.CREASES`): scalars, or (n,) for a batch.
    """
    gaps = _gaps(thick, _NODES[None]).max((2, 3))
    # Around the largest node: the top may be a corner, where the unit jumps.
    near = np.concatenate([gaps.argmax(-1)[:, None] + _AROUND, _vertex(gaps)[1][:, None]], -1)
    near = np.clip(near / STEPS, 0, 1)
    gaps = _gaps(thick, near).max(-1)
    best = gaps.max(-1).argmax(-1)
    which = np.arange(len(gaps))
    hinge = gaps[which, best].argmax(-1)
    found = gaps[which, best, hinge] * thick.scale, near[which, best], hinge
    return tuple(_out(thick, array) for array in found)


def needed_clearance(
    thick: "ThickUnit", held: "Contacts", accuracy: float = 1e-3
) -> tuple[Any, Any]:
    """Factor S on the hinges' clearance with which a unit opens freely: its snap margin.

    The largest, over the opening, of the least clearance with which the rigid bodies stand there
    (`clearance.least_clearance`). ``held``: `contact.Contacts` of these units, mm; ``accuracy`` is
    relative. Returns S and the opening fraction: scalars, or (n,) for a batch.
    """
    held = outermost(held).scaled(1 / thick.scale)
    search = _Uphill(thick, replace(held, barrels=None), accuracy)
    # The least squares tell where to look.
    place = np.clip(_squares(thick).argmax(-1), 1, STEPS - 1)
    search.look(np.arange(len(thick)), place)
    climbing = np.arange(len(thick))
    for _ in range(STEPS):
        up = np.where(search.slopes[climbing, place] > 0, 1, -1)
        place = np.clip(place + up, 0, STEPS)
        fresh = np.isnan(search.levels[climbing, place])
        climbing, place = climbing[fresh], place[fresh]
        if not len(climbing):
            break
        search.look(climbing, place)
    if held.barrels is not None:
        search.keep_apart(held)
    search.settle_tops()
    found, at = search.top()
    return _out(thick, found), _out(thick, at)


class _Uphill:
    """Least clearance and its slope at the nodes of the path that were looked at; NaN elsewhere."""

    def __init__(self, thick: "ThickUnit", held: "Contacts", accuracy: float) -> None:
        self.thick, self.held, self.accuracy = thick, held, accuracy
        self.levels, self.slopes = np.full((2, len(thick), STEPS + 1), np.nan)
        self.poses: dict[Any, Any] = {}

    def look(self, units: NDArray, nodes: NDArray) -> None:
        """Find levels and slopes of some ``units`` (k,) at one node (k,) each."""
        self._keep(units, nodes, self.at(units, nodes / STEPS))

    def _keep(self, units: NDArray, nodes: NDArray, found: Sequence[NDArray]) -> None:
        self.levels[units, nodes], self.slopes[units, nodes] = found[:2]
        self.poses |= zip(zip(units.tolist(), nodes.tolist(), strict=True), found[2], strict=True)

    def at(
        self, units: NDArray, fractions: NDArray, starts: NDArray | None = None
    ) -> tuple[NDArray, ...]:
        """Levels, slopes (k,) and poses of some units at one opening each; ``starts``: poses."""
        closures, poses = self.thick.near(units, fractions)
        if starts is not None:
            poses = closures.held(starts)
        found, slopes, poses = least_clearance(
            self.held.take(units), closures, poses, self.accuracy
        )
        return found, slopes * self.thick.turns[units], poses

    def keep_apart(self, held: "Contacts") -> None:
        """Find the largest levels, and those beside them, again: barrels of ``held`` count too.

        Barrels need as much or more everywhere, but little: the top stays where it is, or beside.
        """
        self.held = held
        done: set[tuple[int, int]] = set()
        for _ in range(STEPS):
            tops = np.nan_to_num(self.levels).argmax(-1)
            near = {(u, k + side) for u, k in enumerate(tops.tolist()) for side in (-1, 0, 1)}
            todo = sorted((near & self.poses.keys()) - done)
            if not todo:
                return
            done.update(todo)
            units, nodes = np.array(todo).T
            starts = np.stack([self.poses[each] for each in todo])
            self._keep(units, nodes, self.at(units, nodes / STEPS, starts))

    def settle_tops(self) -> None:
        """Look at the largest levels again, from the poses next to them.

        Where a unit gives way sideways, those of least squared misfit may lead to a worse optimum.
        """
        tried: Any = set()
        for _ in range(_AGAIN):
            tops = np.nan_to_num(self.levels).argmax(-1)
            todo = [
                (u, k, k + side)
                for u, k in enumerate(tops.tolist())
                for side in (-1, 1)
                if (u, k + side) in self.poses
                and (u, k, side) not in tried
                and not tried.add((u, k, side))
            ]
            if not todo:
                return
            units, nodes, beside = np.array(todo).T
            starts = np.stack([self.poses[u, k] for u, _, k in todo])
            found, slopes, poses = self.at(units, nodes / STEPS, starts)
            for side in (0, 1):  # one unit's two tries one after the other
                some = np.flatnonzero((beside > nodes) == side)
                less = some[found[some] < self.levels[units[some], nodes[some]] * (1 - _LESS)]
                if len(less):
                    self._keep(units[less], nodes[less], (found[less], slopes[less], poses[less]))

    def top(self) -> tuple[NDArray, NDArray]:
        """Largest level (n,) and where, between nodes by the cubic through levels and slopes."""
        known = np.nan_to_num(self.levels)
        units, best = np.arange(len(known)), known.argmax(-1)
        up = np.nan_to_num(self.slopes)[units, best] > 0
        low = np.clip(np.where(up, best, best - 1), 0, STEPS - 1)
        ends = [(self.levels[units, k], self.slopes[units, k] / STEPS) for k in (low, low + 1)]
        place = (low + _cubic_top(*ends[0], *ends[1])) / STEPS
        between = np.flatnonzero(np.isfinite(place))
        peak, where = known.max(-1), best / STEPS
        if len(between):
            starts = np.stack(
                [self.poses[u, k] for u, k in zip(between, best[between], strict=True)]
            )
            there = self.at(between, place[between], starts)[0]
            higher = there > peak[between]
            peak[between] = np.maximum(there, peak[between])
            where[between[higher]] = place[between][higher]
        return peak, where


def _cubic_top(start: NDArray, rise: NDArray, end: NDArray, fall: NDArray) -> NDArray:
    """Where the cubic with these values and slopes at 0 and 1 is largest; NaN if at an end."""
    third, second = 2 * (start - end) + rise + fall, 3 * (end - start) - 2 * rise - fall
    with np.errstate(invalid="ignore", divide="ignore"):
        root = np.sqrt(second**2 - 3 * third * rise)
        place = np.where(rise > 0, rise / (root - second), np.nan)
        return np.where((rise > 0) & (fall < 0) & (place > 0) & (place < 1), place, np.nan)


@dataclass(frozen=True)
class Snap:
    """What `assess` found, scalars or (n,): lengths in mm, openings as fractions of θ.

    ``margin``: snap margin, factor on the hinges' clearance ``gap`` (mm) with which a unit would
    open freely, infinite for hinges without clearance, and where on the way (``margin_at``) it
    needs that much; ``bistable``: after its peak the squared misfit falls again, so there is a
    second stable state.
    """

    margin: np.ndarray
    margin_at: np.ndarray
    gap: float
    peak_misfit: np.ndarray
    peak_at: np.ndarray
    peak_hinge: np.ndarray
    deployed_misfit: np.ndarray
    bistable: np.ndarray
    strain: np.ndarray
    strain_limit: float

    @property
    def needed_gap(self) -> NDArray | float:
        """Clearance (GapLength, mm) with which units would open without strain."""
        return self.margin * self.gap if self.gap else self.margin

    @property
    def floppy(self) -> NDArray | bool:
        """Whether the hinges' clearance swallows the bistability: margin below 1."""
        return self.margin < 1

    @property
    def overstrained(self) -> NDArray | bool:
        """Whether the peak strain passes its limit, if there is one."""
        return (self.strain > self.strain_limit) & (self.strain_limit > 0)

    def warnings(self) -> list:
        """A `Phrase` for each unit and trouble, units counted from 1."""
        return [said for k in range(np.size(self.margin)) for said in self._unit(k)]

    def _unit(self, k: int) -> "Iterator[Phrase]":
        unit = None if np.ndim(self.margin) == 0 else k + 1
        at = phrase("Unit {unit}", unit=unit) if unit else phrase("The unit")
        margin, strain = (np.ravel(a)[k] for a in (self.margin, self.strain))
        if not np.ravel(self.bistable)[k]:
            yield phrase(
                "{at} has no second stable state: its hinges' misfit rises all the way, to "
                "{misfit:.2f} mm; switch {Compensate} on.",
                at=at,
                unit=unit,
                misfit=np.ravel(self.deployed_misfit)[k],
            )
        if margin < 1:
            yield phrase(
                "{at} is floppy: a clearance of {needed:.2f} mm in its hinges is enough to open it "
                "without strain, and they have {gap:.2f} mm (snap margin {margin:.2f}); make "
                "{EdgeLength} larger, {Ratio} nearer to sin(theta/2), the cones steeper, "
                "{GapLength} smaller, or use flexible hinges, which have no play.",
                at=at,
                unit=unit,
                gap=self.gap,
                needed=margin * self.gap,
                margin=margin,
            )
        if 0 < self.strain_limit < strain:
            hinge = CREASES[np.ravel(self.peak_hinge)[k]].name
            yield phrase(
                "{at} strains by {strain:.1%} of ‖AB‖ where it snaps, at hinge {hinge}, and "
                "{StrainLimit} is {limit:.1%}: make {Ratio} larger or the panels thinner.",
                at=at,
                unit=unit,
                strain=strain,
                hinge=hinge,
                limit=self.strain_limit,
            )


def assess(
    thick: "ThickUnit",
    held: "Contacts | None" = None,
    panel_size: float | None = None,
    strain_limit: float = 0.0,
) -> "Snap":
    """The snap of a thick unit, or of each unit of a batch.

    ``thick``: `linkage.ThickUnit`, compensated or not; ``held``: `contact.Contacts` of their
    hinges, None for flexible ones, which have no play; ``panel_size``: length over which a panel
    takes up the misfit, mm, ‖AB‖ if None. Returns a `Snap`.
    """
    peak, peak_at, hinge = peak_misfit(thick)
    if held:
        margin, at = needed_clearance(thick, held)
    else:
        margin, at = (_out(thick, np.full(len(thick), value)) for value in (np.inf, 0.0))
    strain = peak / (thick.scale if panel_size is None else panel_size)
    deployed = thick.misfit(1.0).max(-1)
    bistable = _out(thick, _falls_again(thick))
    gap: Any = held.gap if held else 0.0
    return Snap(
        margin, at, gap, peak, peak_at, hinge, deployed, bistable, strain, strain_limit
    )  # fmt: skip


def _gaps(thick: "ThickUnit", fractions: NDArray) -> NDArray:
    """Gaps (n, m, 23, 2) in edge lengths at openings (n or 1, m)."""
    poses = thick.states(fractions)
    gaps = thick.closures(fractions).gaps(poses.reshape(-1, *poses.shape[2:]))
    return gaps.reshape(*poses.shape[:2], *gaps.shape[1:])


def _falls_again(thick: "ThickUnit") -> NDArray:
    """Whether the squared misfit falls after its peak (n,): there is a second stable state.

    Preloaded, a unit that hardly snaps may not show it: then the one that it was made of tells.
    """
    found = (np.diff(_squares(thick)) < 0).any(-1)
    if not found.all() and thick.rest is not None:
        found = (np.diff(_squares(without(thick))) < 0).any(-1)
    return found


def _squares(thick: "ThickUnit") -> NDArray:
    """Squared misfit (n, nodes) of all hinges at the nodes of the path."""
    return (_gaps(thick, _NODES[None]) ** 2).sum((2, 3))


def _vertex(values: NDArray) -> tuple[Any, Any]:
    """Largest of (…, m) values and its place, between samples, by the parabola through three."""
    k = np.clip(values.argmax(-1), 1, values.shape[-1] - 2)[..., None]
    left, middle, right = (np.take_along_axis(values, k + i, -1)[..., 0] for i in (-1, 0, 1))
    bend = left - 2 * middle + right
    offset = np.where(bend < 0, (left - right) / np.where(bend < 0, 2 * bend, 1.0), 0.0)
    offset = np.clip(offset, -1, 1)
    peak = middle - (left - right) * offset / 4
    return np.maximum(peak, values.max(-1)), k[..., 0] + offset


def _out(thick: "ThickUnit", array: NDArray) -> Any:
    return array[0] if thick.unit.flat.ndim == 2 else array
