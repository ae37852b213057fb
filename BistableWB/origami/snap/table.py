# SPDX-License-Identifier: LGPL-2.1-or-later
"""Needed play and peak strain of compensated plane units, looked up instead of computed.

Needed play is the radial play of cones (ga / tan of the cone's angle) with which a unit would open
freely: in edge lengths it depends on the opening angle θ, the share of the ratio (0 at sin(θ/2), 1
at 1) and pitch / ‖AB‖, and a little on how long the strip and the knuckles are. It is tabulated in
`table_data` for new hinge sets (by ``benchmarks/snap.py --write-table`` from `measure`, in
minutes); between its nodes logarithms are interpolated, monotonically along the share and linearly
in log θ and log pitch. An estimate, before a `HingeSet` measures.

`LEGACY` is the measure of version 0.1, play at the ends of creases, where no hinge is held: only
for tubes of older files, so that they stay as they were.
"""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..hinges.parameters import SEGMENT_WIDTH, HingeParameters
from ..thick.linkage import ThickUnit
from ..unit import plane_unit
from . import table_crease, table_data
from .contact import holding
from .margin import assess

CONTACT, LEGACY = "Contact", "Crease"
MEASURES = {CONTACT: table_data, LEGACY: table_crease}
USUAL = HingeParameters(segment_width=SEGMENT_WIDTH)
_HEIGHT_RATIO = 2.5  # ‖AB‖ / h of the tabulated units

SHARES = (0.01, 0.02, 0.04, 0.08, 0.16, 0.32)
THETAS = tuple(math.radians(10) * 1.2**k for k in range(13))  # to 89°
PITCH_RATIOS = tuple(0.006 * 1.4**k for k in range(8))  # to 0.063
_NARROW = math.radians(35)
GRID = np.linspace(math.log(SHARES[0]), math.log(SHARES[-1]), 481)


def profile(theta: NDArray, pitch_ratio: float, measure: str = CONTACT) -> tuple:
    """Needed play and peak strain of units over all shares.

    ``theta`` (n,) radians; ``pitch_ratio``: pitch / ‖AB‖, scalar or (n,); ``measure``: a key of
    `MEASURES`. Returns the shares (m,),
    needed play (n, m) in ‖AB‖ and strain (n, m), both falling, and the smallest share (n,) with
    which such units can be made: NaN if none can. Beyond the table its border counts.
    """
    rows, lowest = _expanded(measure)
    (i, u), (j, v) = (
        _place(nodes, values)
        for nodes, values in ((PITCH_RATIOS, pitch_ratio), (THETAS, np.asarray(theta, float)))
    )
    corners = ((i, j, (1 - u) * (1 - v)), (i + 1, j, u * (1 - v)), (i, j + 1, (1 - u) * v),
               (i + 1, j + 1, u * v))  # fmt: skip
    counts = np.array([np.where(np.isnan(lowest[a, b]), 0.0, w) for a, b, w in corners])
    made = counts.sum(0) > 0.3
    counts = counts / np.where(made, counts.sum(0), np.nan)
    values = sum(
        np.nan_to_num(rows[a, b]) * w[:, None, None]
        for (a, b, _), w in zip(corners, counts, strict=True)
    )
    least = np.max([np.where(w > 0, lowest[a, b], 0.0)
                    for (a, b, _), w in zip(corners, counts, strict=True)], axis=0)  # fmt: skip
    return np.exp(GRID), np.exp(values[:, 0]), np.exp(values[:, 1]), np.where(made, least, np.nan)


def at(theta: ArrayLike, share: ArrayLike, pitch_ratio: float) -> tuple[NDArray, NDArray]:
    """Needed play in ‖AB‖ and peak strain, (n,) each, of units of θ and share (scalar or (n,))."""
    theta, share = np.broadcast_arrays(np.atleast_1d(theta), np.asarray(share, float))
    _, plays, strains, _ = profile(theta, pitch_ratio)
    places = np.interp(np.log(share), GRID, np.arange(len(GRID)))
    return read(plays, places), read(strains, places)


def first_below(rows: NDArray, goal: NDArray | float) -> NDArray:
    """Place (n,) along falling rows (n, m) where they cross ``goal`` (one, or one each).

    0 if below all along.
    """
    falling = np.minimum.accumulate(rows, -1)
    goals = np.broadcast_to(goal, len(falling))
    places = np.arange(rows.shape[-1])
    return np.array([np.interp(-g, -row, places) for g, row in zip(goals, falling, strict=True)])


def read(rows: NDArray, places: NDArray) -> NDArray:
    """Values (n,) of rows (n or 1, m) at places (n,) along them, by interpolation."""
    rows = np.broadcast_to(rows, (len(places), rows.shape[-1]))
    below = np.clip(places.astype(int), 0, rows.shape[-1] - 2)
    which, share = np.arange(len(places)), places - below
    return rows[which, below] * (1 - share) + rows[which, below + 1] * share


def measure(theta: NDArray, share: NDArray, pitch_ratio: float) -> Any:
    """Needed play in ‖AB‖ and peak strain of units, (2, n); NaN where no such unit can be made.

    ``theta``, ``share`` (n,); hinges are `USUAL`. What the table holds; about 0.1 s a unit.
    """
    edge = USUAL.pitch / pitch_ratio
    try:
        low = np.sin(theta / 2)
        unit = plane_unit(theta, low + share * (1 - low), edge, edge / _HEIGHT_RATIO)
        thick = ThickUnit(unit, USUAL.face_thickness, USUAL.gap_between_planes).compensated()
        snap = assess(thick, holding(thick, USUAL))
    except ValueError:
        if len(theta) == 1:
            return np.full((2, 1), np.nan)
        half = len(theta) // 2
        parts = slice(None, half), slice(half, None)
        return np.concatenate([measure(theta[p], share[p], pitch_ratio) for p in parts], 1)
    return np.stack([snap.margin * USUAL.play / edge, snap.strain])


def monotone(x: NDArray, y: NDArray, at: NDArray) -> NDArray:
    """Cubic through (x, y) that has no extremum between nodes; constant beyond them.

    ``x`` (m,) ascending, ``y`` (k, m), ``at`` (…,): (k, …). Slopes by Fritsch and Butland.
    """
    if len(x) == 1:
        return np.broadcast_to(y.reshape(-1, *([1] * np.ndim(at))), (len(y), *np.shape(at)))
    width = np.diff(x)
    chord = np.diff(y) / width
    slopes = np.concatenate([chord[:, :1], np.zeros((len(y), len(x) - 2)), chord[:, -1:]], 1)
    left, right = chord[:, :-1], chord[:, 1:]
    weight = (width[:-1] + 2 * width[1:]) / (3 * (width[:-1] + width[1:]))
    same = left * right > 0
    mean = left * right / np.where(same, weight * right + (1 - weight) * left, 1.0)
    slopes[:, 1:-1] = np.where(same, mean, 0.0)
    at = np.clip(at, x[0], x[-1])
    k = np.clip(np.searchsorted(x, at, "right") - 1, 0, len(width) - 1)
    h = width[k]
    t = (at - x[k]) / h
    start, end = y[:, k], y[:, k + 1]
    bend = 3 * (end - start) - h * (2 * slopes[:, k] + slopes[:, k + 1])
    turn = 2 * (start - end) + h * (slopes[:, k] + slopes[:, k + 1])
    return start + t * (h * slopes[:, k] + t * (bend + t * turn))


def table(name: str = CONTACT) -> NDArray:
    """The tabulated values: (pitch ratios, θ, needed play in ‖AB‖ and strain, shares)."""
    shape = len(PITCH_RATIOS), len(THETAS), 2, len(SHARES)
    return np.array(MEASURES[name].TABLE.split(), float).reshape(shape) / 1000


@lru_cache(maxsize=len(MEASURES))
def _expanded(name: str) -> tuple[NDArray, NDArray]:
    """Logarithms over `GRID`: (pitch ratios, θ, 2, m), and the smallest shares that can be made."""
    nodes, known = np.log(SHARES), np.log(table(name))
    # Narrow units of thick panels may lock for once: do not count on more than a wider one has.
    for j in reversed([j for j, theta in enumerate(THETAS) if theta < _NARROW]):
        known[:, j] = np.fmin(known[:, j], known[:, j + 1])
    rows = np.full((*known.shape[:3], len(GRID)), np.nan)
    lowest = np.full(known.shape[:2], np.nan)
    for index in np.ndindex(*lowest.shape):
        bad = np.flatnonzero(np.isnan(known[index]).any(0))
        first = bad[-1] + 1 if len(bad) else 0
        if first < len(nodes):
            rows[index] = monotone(nodes[first:], known[index][:, first:], GRID)
            lowest[index] = SHARES[first]
    return rows, lowest


def _place(nodes: Sequence[float], values: NDArray | float) -> tuple[NDArray, NDArray]:
    """Index (n,) of the node below values, and their share of the way to the next, by log."""
    places = np.interp(np.log(np.atleast_1d(values)), np.log(nodes), np.arange(len(nodes)))
    below = np.clip(places.astype(int), 0, len(nodes) - 2)
    return below, places - below
