# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isosceles triangles along a curve: section 3.1 of the paper, for plane, sphere and any legs.

Contact blocks sit on the curve: block k has its midpoint M_k on the curve, the unit vector e_k
along its mid-line towards the joint with the next unit, and the normal n_k towards that unit. With
r = ‖AB‖/2 and the pitch p of thick panels, the next midpoint X is the first crossing outward of

    |X − M_k| / 2 = p + r e_k·y + p n_k·y,      y = (X − M_k) / |X − M_k|,

and block k + 1 is the mirror image of block k in the plane with normal y half way to X. For p = 0
this is the circle (sphere) of radius r about B_k of the paper.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import Refusal, require
from .crossing import CurveTable
from .end_fit import EndFit
from .legs import Legs, SeenAlong
from .marching import march
from .overlap import first_overlap
from .rules import PAPER
from .steered import Steered
from .tightness import too_long, too_tight, where

if TYPE_CHECKING:
    from .curve import Curve
    from .rules import PlacementRule

_MAX_UNITS = 20_000


@dataclass(frozen=True)
class Placement:
    """Result of `place`: n units between n + 1 contact segments.

    ``points`` (n + 2, 3): the zigzag A_0, B_0, B_1 … (for pitch 0 consecutive segments share a
    point); ``midpoints`` (n + 1, 3) on the curve at ``parameters`` and ``lengths`` from its start
    (n + 1,); ``thetas`` (n,) radians; ``reaches`` (n + 1, 3): r e_k, from the midpoint to the
    joint; ``legs`` (n + 1, 3) unit vectors along the strip's legs ("upper") at the midpoints;
    ``sides`` (n,): +1 where the joint B of the unit lies left of the path seen from upper, −1 on
    the right; ``length`` of the whole curve; ``centre``: V of concurrent legs, else None;
    ``gamma`` of the first segment; ``end`` (3,): where the last midpoint should be; ``off``
    (n + 1,): distances of the midpoints from the curve; ``closed``: the last segment is the first;
    ``unlike`` (mm): by how much a curve whose tube was to be symmetric is not; 0 where it is.
    """

    points: np.ndarray
    midpoints: np.ndarray
    parameters: np.ndarray
    lengths: np.ndarray
    thetas: np.ndarray
    reaches: np.ndarray
    legs: np.ndarray
    sides: np.ndarray
    edge_length: float
    pitch: float
    length: float
    centre: np.ndarray | None = None
    gamma: float = 0.0
    end: np.ndarray | None = None
    off: np.ndarray | None = None
    closed: bool = False
    unlike: float = 0.0

    def __len__(self) -> int:
        return len(self.thetas)

    @property
    def segments(self) -> NDArray:
        """Ends of the contact segments' mid-lines, start and joint: (n + 1, 2, 3)."""
        return np.stack([self.midpoints - self.reaches, self.midpoints + self.reaches], 1)

    def between(self, first: int, last: int) -> "Placement":
        """The placement of units ``first`` … ``last``, counted from 0, at most those there are."""
        last = min(last, len(self) - 1)
        ends = {"points": last + 3, "thetas": last + 1, "sides": last + 1}
        if (first, last) == (0, len(self) - 1):
            return self
        of_blocks = ("midpoints", "parameters", "lengths", "reaches", "legs", "off")
        ends |= dict.fromkeys(of_blocks, last + 2)
        parts = {name: getattr(self, name)[first:end] for name, end in ends.items()}
        return replace(self, **parts, end=parts["midpoints"][-1], closed=False)

    @property
    def end_gap(self) -> float:
        """Distance of the last midpoint from the curve's end; of a closed tube from its first."""
        return float(np.linalg.norm(self.midpoints[-1] - self.end))

    @property
    def followed(self) -> float:
        """Length of the curve up to the last midpoint."""
        return float(self.lengths[-1])

    @property
    def distances_from_centre(self) -> NDArray:
        """Distances (n + 1,) of the midpoints from V of concurrent legs."""
        return np.linalg.norm(self.midpoints - self.centre, axis=1)


def place(
    curve: "Curve",
    edge_length: float,
    gamma: float,
    pitch: float = 0.0,
    legs: tuple[str, ArrayLike] | None = None,
    flip: bool = False,
    extra: NDArray | Sequence[Any] = (),
    level: bool = False,
    rule: "PlacementRule" = PAPER,
) -> Placement:
    """Place isosceles triangles along ``curve`` (section 3.1; with thickness: theory/hinges.md 5).

    Parameters
    ----------
    curve : object with ``point(s)`` for s in [0, 1] (array in, (…, 3) out).
    edge_length : ‖AB‖, in the curve's unit of length.
    gamma : angle of the first segment against the curve's normal, radians, in (0, π/2).
    pitch : p = face thickness + gap between planes; 0 is the paper's rule.
    legs : None (along z), ("parallel", direction) or ("point", V).
    flip : start on the convex side of the curve instead of the concave one.
    extra : what half the distance between the midpoints of unit k's two blocks exceeds the rule
        by, per unit (its last value counts for all further units): see `thick_tube`.
    level : for space curves with parallel legs: follow the rule in the view along the legs and lift
        the result onto the curve. Segments then stay as level as the curve is steep, where the
        rule in space lets them tilt more and more (a helix). Segments are then a little longer than
        ‖AB‖, and their midpoints a little above or below the curve. Steered and closed tubes with
        parallel legs are always made so.
    rule : a `rules.PlacementRule`: the paper's march by default.

    Returns a `Placement`. ValueError, with the place on the curve and the parameter to change, for
    an edge too long, a radius of curvature too small and a path that meets itself; by the rule
    Paper for a closed curve.
    """
    rule.check()
    _check_parameters(edge_length, gamma, pitch)
    _check_count(curve, edge_length, gamma)
    table = CurveTable(curve, edge_length)
    closed = _is_closed(table, rule)
    along = Legs(legs)
    steered = closed or rule.name == "Steered"
    given = along, edge_length, gamma, pitch, flip, extra
    seen = table
    if level or (steered and not along.central):
        seen = CurveTable(SeenAlong(curve, along), edge_length)
    found = _follow(seen, given, rule, closed)
    if not found.blocks.sines:
        too_long(edge_length, table.lengths[-1])
    placed = _result(table, along, edge_length, pitch, seen, found, closed)
    _check_overlap(placed, table, along)
    return placed


@dataclass(frozen=True)
class _Found:
    """Blocks by a rule, the first block's gamma, and how far midpoints are off the curve."""

    blocks: Any
    gamma: float
    off: Any = 0.0
    unlike: float = 0.0


def _follow(table: CurveTable, given: Sequence[Any], rule: "PlacementRule", closed: bool) -> _Found:
    legs, edge_length, gamma, pitch, flip, extra = given
    if closed or rule.name == "Steered":
        steered = Steered(table, legs, edge_length, gamma, pitch, flip, extra, rule, closed)
        blocks, first, off = steered.solved()
        return _Found(blocks, first, off, steered.unlike)
    if rule.name == "EndFit":
        fitted = EndFit(table.curve, legs, edge_length, pitch, flip, extra)
        blocks, first = fitted.fitted(gamma, rule.near)
        return _Found(blocks, first)
    return _Found(march(table, legs, edge_length, gamma, pitch, flip, extra), gamma)


def _result(
    table: CurveTable,
    legs: Legs,
    edge_length: float,
    pitch: float,
    seen: CurveTable,
    found: _Found,
    closed: bool,
) -> Placement:
    viewed: Any = seen.curve
    blocks = found.blocks if seen is table else viewed.lifted(found.blocks, closed)
    off = np.broadcast_to(found.off, len(blocks.midpoints))
    midpoints, reach = np.array(blocks.midpoints), np.array(blocks.reaches)
    points = np.concatenate([midpoints[:1] - reach[:1], midpoints + reach])
    travel = np.diff(midpoints, axis=0)
    rulings = legs.at(midpoints)
    left = (np.cross(rulings[:-1], travel) * reach[:-1]).sum(1)
    on_curve = np.asarray(table.curve.point(np.array(blocks.parameters)), float)
    above = ((midpoints - on_curve) * rulings).sum(1)
    return Placement(
        points=points,
        midpoints=midpoints,
        parameters=np.array(blocks.parameters),
        lengths=table.length_at(blocks.parameters),
        thetas=2 * np.arcsin(np.array(blocks.sines)),
        reaches=reach,
        legs=rulings,
        sides=np.where(left >= 0, 1, -1),
        edge_length=float(edge_length),
        pitch=float(pitch),
        length=float(table.lengths[-1]),
        centre=legs.vector if legs.central else None,
        gamma=float(found.gamma),
        end=midpoints[0] if closed else table.points[-1],
        off=np.hypot(off, above if seen is not table else 0.0),
        closed=closed,
        unlike=found.unlike,
    )


def _check_parameters(edge_length: float, gamma: float, pitch: float) -> None:
    require(
        np.isfinite(edge_length) & (np.asarray(edge_length) > 0),
        "{EdgeLength} ‖AB‖ is {value:.6g} mm: set it to a length above 0.",
        edge_length,
        parameter="EdgeLength",
    )
    require(
        np.isfinite(gamma) & (np.asarray(gamma) > 0) & (np.asarray(gamma) < np.pi / 2),
        "{Gamma} is {value:.6g}°: the first segment must lean forward; set {Gamma} above 0° and "
        "below 90° (10° to 30° is usual).",
        np.degrees(gamma),
        parameter="Gamma",
    )
    require(
        np.isfinite(pitch) & (np.asarray(pitch) >= 0) & (np.asarray(pitch) < edge_length / 4),
        "{Thickness}: the pitch of the panels is {value:.6g} mm; it must be at least 0 and below "
        "a quarter of {EdgeLength} ({0:.6g} mm).",
        pitch, edge_length / 4,
        parameter="Thickness",

    )  # fmt: skip


def _check_count(curve: "Curve", edge_length: float, gamma: float) -> None:
    """A unit advances by ‖AB‖ sin(θ/2), about ‖AB‖ sin γ: refuse more units than anyone prints."""
    rough = np.asarray(curve.point(np.linspace(0, 1, 1025)), float)
    length = np.linalg.norm(np.diff(rough, axis=0), axis=1).sum()
    if length > _MAX_UNITS * edge_length * np.sin(gamma):
        raise Refusal(
            "{EdgeLength} {edge_length:.6g} mm with {Gamma} {gamma:.4g}° would need more than "
            "{most} units along {length:.6g} mm of curve; make {EdgeLength} longer.",
            parameter="EdgeLength",
            edge_length=edge_length,
            gamma=np.degrees(gamma),
            most=_MAX_UNITS,
            length=length,
        )


def _is_closed(table: CurveTable, rule: "PlacementRule") -> bool:
    ends = np.linalg.norm(table.points[-1] - table.points[0])
    if not np.isfinite(table.points).all():
        raise Refusal(
            "Curve: it has points that are not finite; check its control points.",
            parameter="Curve",
        )
    closed = bool(ends <= 1e-6 * table.lengths[-1])
    if closed and rule.name == "Paper":
        raise Refusal(
            "Curve is closed at {place}: the paper's rule cannot follow it",
            cure="choose EndFit or Steered as {PlacementRule}, which close the tube, or open the "
            "curve by a gap of a few {EdgeLength}",
            parameter="PlacementRule",
            place=where(table.points[0]),
        )
    return closed


def _check_overlap(placed: Placement, table: CurveTable, legs: Legs) -> None:
    pair = first_overlap(placed.segments, legs, placed.closed)
    if pair is None:
        return
    i, j = pair
    low, high = placed.parameters[i], placed.parameters[j + 1]
    if j - i <= 4:
        too_tight(table, low, high, placed.edge_length)
    raise Refusal(
        "Curve: the tube meets itself: unit {first} near {place} overlaps unit {second} near "
        "{other_place}; move these parts of the curve further apart or make {EdgeLength} shorter.",
        parameter="EdgeLength",
        unit=i + 1,
        first=i + 1,
        place=where(placed.midpoints[i]),
        second=j + 1,
        other_place=where(placed.midpoints[j]),
    )
