# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ruling of a space curve: the direction, or viewpoint, of the strip's legs (section 2, general).

A curve can be followed with any ruling from which it is seen as a regular curve that does not
overlap itself. *Openness* is how well a ruling does: the smallest angle between the curve's tangent
and the legs. At 90° the strip stands square on the curve everywhere, as on plane curves (legs along
the normal) and on spheres (legs through the centre); at 0° the curve, seen along the legs, has a
cusp. Turns that the curve makes in space are then seen as turns, none hidden and none added.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import Refusal
from .bezier import normalised
from .crossing import CurveTable
from .kinds import fitted_sphere
from .legs import Legs
from .overlap import CLEARANCE
from .tightness import where

if TYPE_CHECKING:
    from .curve import Curve

LEAST_OPENNESS = np.radians(10)
_ENOUGH_BETTER = np.radians(5)  # a viewpoint must beat every direction by this
_PROPOSED_OPENNESS = np.radians(30)  # nothing less open is proposed
_ALIKE = np.cos(np.radians(12))  # directions closer than this fail alike
_AS_GOOD = np.radians(0.1)  # a coordinate axis this close to the best direction is taken instead
_SAMPLES = 800
_RESTING = 1e-12  # of the curve's length: what a node may be from the next by rounding
_DIRECTIONS = 400
_ROUND = 1e-6  # of the distance from a viewpoint


def default_ruling(
    curve: "Curve", edge_length: float | None = None
) -> tuple[str, tuple[float, ...]]:
    """The ruling from which ``curve`` is seen most openly, as ``legs`` of `placement.place`.

    Candidates are directions all around (the normal of plane curves and the coordinate axes among
    them) and the centre of the sphere that fits the curve best. Of those in whose view the curve
    does not overlap itself the one of largest `openness` is taken; a viewpoint only if it beats
    every direction by 5°, and for closed curves only where they lie on the sphere: elsewhere they
    cannot be closed. Directions point up (+z, or +y, or +x).

    ``curve``: object with ``point(s)``; ``edge_length`` ‖AB‖ in the curve's unit of length lets
    parts of the curve pass over each other `CLEARANCE` ‖AB‖ apart along the legs; without it only
    parts that meet in space count as overlapping. ValueError, with the place, where no candidate
    will do.
    """
    view = _View(curve, edge_length)
    best = _most_open(view.tangents)
    sphere = fitted_sphere(view.points)
    centre = None if sphere is None else sphere[0]
    if centre is not None and not (view.closed and not view.is_round(centre)):
        legs = Legs(("point", centre))
        enough = view.openness(Legs(("parallel", best))) + _ENOUGH_BETTER
        if view.openness(legs) > enough and view.fault(legs) is None:
            return "point", tuple(centre.tolist())
    first_fault: Any = None
    refused: list[NDArray] = []
    for direction in (best, *_others(view.tangents)):
        if any(abs(direction @ other) > _ALIKE for other in refused):
            continue
        fault = view.fault(Legs(("parallel", direction)))
        if fault is None:
            return "parallel", tuple(direction.tolist())
        first_fault = first_fault or fault
        refused.append(direction)
    raise first_fault


def openness(curve: "Curve", legs: tuple[str, ArrayLike] | None) -> float:
    """Smallest angle between the curve's tangent and the legs, radians in [0, π/2].

    ``legs`` as for `placement.place`: None (along z), ("parallel", direction) or ("point", V).
    """
    return _View(curve, None).openness(Legs(legs))


def check_ruling(
    curve: "Curve", legs: tuple[str, ArrayLike] | None, edge_length: float | None = None
) -> None:
    """ValueError, naming the place on the curve and the cure, for a ruling that will not do.

    That is: a viewpoint on the curve, legs along the tangent (openness below 10°), and a curve that
    seen along the legs overlaps itself. Parameters as for `default_ruling` and `openness`.
    """
    fault = _View(curve, edge_length).fault(Legs(legs))
    if fault is not None:
        raise fault


class _View:
    """Evenly spaced points of a curve, with unit tangents, to look at along any legs."""

    def __init__(self, curve: "Curve", edge_length: float | None) -> None:
        rough = np.asarray(curve.point(np.linspace(0, 1, 65)), float)
        length = np.linalg.norm(np.diff(rough, axis=0), axis=1).sum()
        if not np.isfinite(length) or length == 0:
            raise Refusal(
                "Curve: it has no length or points that are not finite; check it.",
                parameter="Curve",
            )
        table = CurveTable(curve, edge_length or length / 50)
        length = table.lengths[-1]
        count = _SAMPLES if edge_length is None else 16 * length / edge_length
        count = int(np.clip(count, 200, 2 * _SAMPLES))
        s = np.interp(np.linspace(0, length, count + 1), table.lengths, table.parameters)
        self.points = np.asarray(curve.point(s), float)
        steps = np.diff(table.points, axis=0)
        moving = np.linalg.norm(steps, axis=1) > _RESTING * length  # a step of none has no tangent
        self.tangents = normalised(steps[moving])
        self.places = ((table.points[1:] + table.points[:-1]) / 2)[moving]
        self.length = length
        self.closed = bool(np.linalg.norm(self.points[0] - self.points[-1]) <= 1e-6 * length)
        self.width = 2 * length / count
        self.clearance = CLEARANCE * edge_length if edge_length else 1e-3 * length
        self.least_distance = edge_length or 1e-3 * length

    def is_round(self, centre: NDArray) -> bool:
        """Whether the curve lies on a sphere about ``centre``."""
        reach = np.linalg.norm(self.points - centre, axis=1)
        return bool(np.ptp(reach) <= _ROUND * reach.mean())

    def angles(self, legs: Legs) -> NDArray:
        """Angle between tangent and legs at ``places``, radians."""
        rulings = legs.at(self.places)
        sine = np.linalg.norm(np.cross(self.tangents, rulings), axis=1)
        return np.arctan2(sine, np.abs((self.tangents * rulings).sum(1)))

    def openness(self, legs: Legs) -> float:
        """Smallest of `angles`."""
        return float(self.angles(legs).min())

    def fault(self, legs: Legs) -> "Refusal | None":
        """What is wrong with these legs, as a `Refusal`, or None."""
        if legs.central:
            distance = np.linalg.norm(self.points - legs.vector, axis=1)
            k = int(np.argmin(distance))
            if distance[k] < self.least_distance:
                return Refusal(
                    "{Ruling}: the viewpoint {viewpoint} lies on the curve, {distance:.3g} mm from "
                    "{place}; move it away from the curve by more than {least:.4g} mm.",
                    parameter="Ruling",
                    viewpoint=where(legs.vector),
                    distance=distance[k],
                    place=where(self.points[k]),
                    least=self.least_distance,
                )
        angles = self.angles(legs)
        k = int(np.argmin(angles))
        if angles[k] < LEAST_OPENNESS:
            return Refusal(
                "{Ruling}: the legs run along the curve near {place} (at {angle:.3g}°, "
                "{least:.3g}° is the least); choose another direction or viewpoint for {Ruling}.",
                parameter="Ruling",
                place=where(self.places[k]),
                angle=np.degrees(angles[k]),
                least=np.degrees(LEAST_OPENNESS),
            )
        pair = self._overlap(legs)
        if pair is None:
            return None
        first, second = (where(self.points[i]) for i in pair)
        return Refusal(
            "{Ruling}: seen along the legs the curve overlaps itself: {first} lies in front of "
            "{second}; choose another direction or viewpoint for {Ruling}, or move these parts of "
            "the curve apart.",
            parameter="Ruling",
            first=first,
            second=second,
        )

    def _overlap(self, legs: Legs) -> tuple[int, int] | None:
        """Indices of two points that coincide seen along the legs, the curve going away between.

        Points coincide closer than ``width`` (two steps), it goes away beyond three of these;
        parts ``clearance`` apart along the legs pass over each other.
        """
        offset = self.points - legs.vector
        rulings = legs.at(self.points)
        depth = (offset * rulings).sum(1)
        seen = rulings * np.median(depth) if legs.central else offset - depth[:, None] * rulings
        square = (seen * seen).sum(1)
        apart = square[:, None] + square - 2 * (seen @ seen.T)
        away = apart > (3 * self.width) ** 2
        after = np.triu(away, 1)
        gone = np.where(after.any(1), after.argmax(1), len(seen))
        beyond = np.arange(len(seen)) > gone[:, None]
        if self.closed:  # across the seam it may not have gone away at all
            last = np.where(away.any(1), len(seen) - 1 - away[:, ::-1].argmax(1), -1)
            before = np.tril(away, -1).any(1)
            beyond &= (last[:, None] >= np.arange(len(seen))) | before[:, None]
        near = np.abs(depth[:, None] - depth) < self.clearance
        hits = np.argwhere((apart < self.width**2) & beyond & near)
        return tuple(hits[0]) if len(hits) else None


def _others(tangents: NDArray) -> NDArray:
    """Directions (unit vectors) that may be proposed, most open first."""
    around = _directions(_DIRECTIONS)
    values = _openness_of(around, tangents)
    order = np.argsort(-values, kind="stable")
    return around[order[values[order] >= _PROPOSED_OPENNESS]]


def _most_open(tangents: NDArray) -> NDArray:
    """The direction of largest openness; a coordinate axis or mean normal if as good."""
    normal = _upward(np.linalg.svd(tangents, full_matrices=False)[2][-1])
    plain = np.stack([*np.eye(3)[::-1], normal])
    found = _openness_of(plain, tangents)
    square = np.nonzero(found > np.pi / 2 - 1e-6)[0]
    if len(square):
        return plain[square[0]]
    around = _directions(_DIRECTIONS)
    best = _refined(around[np.argmax(_openness_of(around, tangents))], tangents)
    good = np.nonzero(found >= _openness_of(best[None], tangents)[0] - _AS_GOOD)[0]
    return plain[good[0]] if len(good) else _upward(best)


def _refined(direction: NDArray, tangents: NDArray) -> NDArray:
    """Pattern search for the largest openness near a direction."""
    best, step = _openness_of(direction[None], tangents)[0], 0.1
    turns = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    while step > 1e-5:
        u = normalised(np.cross(direction, np.eye(3)[np.argmin(np.abs(direction))]))
        v = np.cross(direction, u)
        ring = np.cos(turns)[:, None] * u + np.sin(turns)[:, None] * v
        trial = normalised(direction + step * ring)
        values = _openness_of(trial, tangents)
        k = int(np.argmax(values))
        if values[k] > best + 1e-9:
            direction, best = trial[k], values[k]
        else:
            step /= 2
    return direction


def _openness_of(directions: NDArray, tangents: NDArray) -> NDArray:
    """Openness (m,) of unit directions (m, 3); accurate near 90°."""
    return np.arccos(np.minimum(np.abs(directions @ tangents.T).max(1), 1))


def _directions(count: int) -> NDArray:
    """Unit vectors spread evenly over the upper half sphere (a Fibonacci spiral): (count, 3)."""
    k = np.arange(count)
    z = 1 - (k + 0.5) / count
    turn = k * np.pi * (3 - np.sqrt(5))
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(turn), r * np.sin(turn), z], -1)


def _upward(direction: NDArray) -> NDArray:
    """The direction or its opposite: the one whose last coordinate that is not zero is positive."""
    leading = direction[np.nonzero(np.abs(direction) > 1e-9)[0][-1]]
    return direction if leading > 0 else -direction
