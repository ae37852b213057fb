# SPDX-License-Identifier: LGPL-2.1-or-later
"""How strongly a unit snaps between its two stable states (``hinges.md`` 4).

Without thickness: the energy of its edges as bars on the way (`energy_path`, `barrier`). With
thickness: the misfit of its hinges on the way, the play with which it would open without strain,
and what a hinge's clearance leaves of that (`assess`).
"""

from dataclasses import dataclass

import numpy as np

from . import energy
from .creases import CREASES
from .errors import require
from .linkage import STEPS
from .play import smallest_largest

__all__ = ["PLA_STRAIN", "Snap", "assess", "barrier", "energy_path", "needed_play", "peak_misfit"]

PLA_STRAIN = 0.02  # what PLA bears
_NODES = np.arange(STEPS + 1) / STEPS
_AROUND = np.array([-0.67, -0.33, 0, 0.33, 0.67])


def energy_path(alpha, beta, n=100, end=1.0):
    """Energy of a zero-thickness unit on its way from flat to ``end`` (1: deployed).

    ``alpha``, ``beta``: radians, scalars or arrays of one shape. Returns the opening as a fraction
    of θ (n,) and the energy in EA·‖AB‖ (…, n): bars with Green strain, both pyramids on one planar
    base, each edge counted once, minimised at each opening. ValueError outside the range of (3).
    """
    fractions = np.linspace(0, end, n)
    return fractions, energy.path(alpha, beta, fractions)[0]


def barrier(alpha, beta, n=100):
    """Energy barrier in EA·‖AB‖, the opening fraction where it stands, and the largest strain.

    Arguments as in `energy_path`; three arrays of their shape.
    """
    fractions = np.linspace(0, 1, n)
    values, strains = energy.path(alpha, beta, fractions)
    peak, place = _vertex(values)
    return peak[()], (place / (n - 1))[()], np.abs(strains).max((-1, -2))[()]


def peak_misfit(thick):
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


def needed_play(thick, accuracy=2e-3):
    """Needed play δ*: with that much in every hinge the unit would open without any strain.

    The largest, over the opening, of the smallest achievable largest misfit. Returns mm and the
    opening fraction: scalars, or (n,) for a batch. ``accuracy`` is relative.
    """
    n, which = len(thick), np.arange(len(thick))
    # The least squares tell where to look; from there uphill, node by node.
    top = np.clip(_squares(thick).argmax(-1), 1, STEPS - 1)
    found = np.full((n, STEPS + 1), np.nan)
    for _ in range(STEPS):
        nodes = np.clip(top[:, None] + [-1, 0, 1], 0, STEPS)
        unknown = np.isnan(found[which[:, None], nodes])
        unit, column = np.nonzero(unknown)
        found[unit, nodes[unit, column]] = _levels(thick, nodes / STEPS, unknown, accuracy)
        best = nodes[which, found[which[:, None], nodes].argmax(-1)]
        if (best == top).all():
            break
        top = best
    values = np.nan_to_num(found)
    place = _vertex(values)[1]
    place = np.clip(place / STEPS, 0, 1)
    refined = _levels(thick, place[:, None], np.ones((n, 1), bool), accuracy)
    higher = refined > values.max(-1)
    delta = np.where(higher, refined, values.max(-1)) * thick.scale
    return _out(thick, delta), _out(thick, np.where(higher, place, top / STEPS))


@dataclass(frozen=True)
class Snap:
    """What `assess` found, scalars or (n,): lengths in mm, openings as fractions of θ.

    ``bistable``: after its peak the squared misfit falls again, so there is a second stable state.
    """

    peak_misfit: np.ndarray
    peak_at: np.ndarray
    peak_hinge: np.ndarray
    deployed_misfit: np.ndarray
    bistable: np.ndarray
    needed_play: np.ndarray
    needed_at: np.ndarray
    play: float
    strain: np.ndarray
    strain_limit: float

    @property
    def margin(self):
        """Snap margin δ*/play; infinite for hinges without play."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(self.needed_play > 0, self.needed_play / self.play, 0.0)[()]

    @property
    def floppy(self):
        """Whether the hinges' clearance swallows the bistability: margin below 1."""
        return self.margin < 1

    @property
    def overstrained(self):
        """Whether the peak strain is more than the material bears."""
        return self.strain > self.strain_limit

    def warnings(self):
        """One sentence for each unit and trouble, units counted from 1."""
        return [sentence for k in range(np.size(self.margin)) for sentence in self._unit(k)]

    def _unit(self, k):
        at = "The unit" if np.ndim(self.margin) == 0 else f"Unit {k + 1}"
        margin, needed, strain = (
            np.ravel(a)[k] for a in (self.margin, self.needed_play, self.strain)
        )
        if not np.ravel(self.bistable)[k]:
            yield (
                f"{at} has no second stable state: its hinges' misfit rises all the way, to "
                f"{np.ravel(self.deployed_misfit)[k]:.2f} mm; switch Compensate on."
            )
        if margin < 1:
            yield (
                f"{at} is floppy: its hinges play by {self.play:.2f} mm and {needed:.2f} mm is "
                f"enough to open it without strain (snap margin {margin:.2f}); make EdgeLength "
                "larger, Ratio nearer to sin(theta/2), the cones steeper, GapLength smaller, or "
                "use flexible hinges, which have no play."
            )
        if strain > self.strain_limit:
            hinge = CREASES[np.ravel(self.peak_hinge)[k]].name
            yield (
                f"{at} strains by {strain:.1%} where it snaps, at hinge {hinge}, and its material "
                f"bears about {self.strain_limit:.0%}: make Ratio larger or the panels thinner."
            )


def assess(thick, play, panel_size=None, strain_limit=PLA_STRAIN):
    """The snap of a thick unit, or of each unit of a batch.

    ``thick``: `linkage.ThickUnit`, compensated or not; ``play``: what one hinge's clearance
    allows, mm (`hinge_parameters.HingeParameters.play`); ``panel_size``: length over which a panel
    takes up the misfit, mm, ‖AB‖ if None. ValueError for a negative play. Returns a `Snap`.
    """
    require(
        np.isfinite(play) & (np.asarray(play) >= 0),
        "Play of a hinge is {value:.6g} mm: it cannot be negative.",
        play,
    )
    peak, peak_at, hinge = peak_misfit(thick)
    delta, delta_at = needed_play(thick)
    strain = peak / (thick.scale if panel_size is None else panel_size)
    deployed = thick.misfit(1.0).max(-1)
    bistable = _out(thick, (np.diff(_squares(thick)) < 0).any(-1))
    return Snap(
        peak, peak_at, hinge, deployed, bistable, delta, delta_at, float(play), strain, strain_limit
    )


def _gaps(thick, fractions):
    """Gaps (n, m, 23, 2) in edge lengths at openings (n or 1, m)."""
    poses = thick.states(fractions)
    gaps = thick.closures(fractions).gaps(poses.reshape(-1, *poses.shape[2:]))
    return gaps.reshape(*poses.shape[:2], *gaps.shape[1:])


def _squares(thick):
    """Squared misfit (n, nodes) of all hinges at the nodes of the path."""
    return (_gaps(thick, _NODES[None]) ** 2).sum((2, 3))


def _levels(thick, openings, wanted, accuracy):
    """Smallest largest misfit, in edge lengths, at the ``wanted`` ones of openings (n, m)."""
    poses = thick.states(openings)[wanted]
    closures = thick.closures(openings).take(wanted.ravel())
    return smallest_largest(closures, poses, accuracy)[0]


def _vertex(values):
    """Largest of (…, m) values and its place, between samples, by the parabola through three."""
    k = np.clip(values.argmax(-1), 1, values.shape[-1] - 2)[..., None]
    left, middle, right = (np.take_along_axis(values, k + i, -1)[..., 0] for i in (-1, 0, 1))
    bend = left - 2 * middle + right
    offset = np.where(bend < 0, (left - right) / np.where(bend < 0, 2 * bend, 1.0), 0.0)
    offset = np.clip(offset, -1, 1)
    peak = middle - (left - right) * offset / 4
    return np.maximum(peak, values.max(-1)), k[..., 0] + offset


def _out(thick, array):
    return array[0] if thick.unit.flat.ndim == 2 else array
