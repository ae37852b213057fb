# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isosceles triangles along a curve: section 3.1 of the paper, for plane, sphere and any legs.

Contact blocks sit on the curve: block k has its midpoint M_k on the curve, the unit vector e_k
along its mid-line towards the joint with the next unit, and the normal n_k towards that unit. With
r = ‖AB‖/2 and the pitch p of thick panels, the next midpoint X is the first crossing outward of

    |X − M_k| / 2 = p + r e_k·y + p n_k·y,      y = (X − M_k) / |X − M_k|,

and block k + 1 is the mirror image of block k in the plane with normal y half way to X. For p = 0
this is the circle (sphere) of radius r about B_k of the paper.
"""

from dataclasses import dataclass, replace

import numpy as np

from . import bezier
from .crossing import CurveTable
from .errors import require
from .overlap import first_overlap

_MAX_UNITS = 20_000


@dataclass(frozen=True)
class Placement:
    """Result of `place`: n units between n + 1 contact segments.

    ``points`` (n + 2, 3): the zigzag A_0, B_0, B_1 … (for pitch 0 consecutive segments share a
    point); ``midpoints`` (n + 1, 3) on the curve at ``parameters`` and ``lengths`` from its start
    (n + 1,); ``thetas`` (n,) radians; ``reaches`` (n + 1, 3): r e_k, from the midpoint to the
    joint; ``legs`` (n + 1, 3) unit vectors along the strip's legs ("upper") at the midpoints;
    ``sides`` (n,): +1 where the joint B of the unit lies left of the path seen from upper, −1 on
    the right; ``length`` of the whole curve; ``centre``: V of concurrent legs, else None.
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

    def __len__(self):
        return len(self.thetas)

    @property
    def segments(self):
        """Ends of the contact segments' mid-lines, start and joint: (n + 1, 2, 3)."""
        return np.stack([self.midpoints - self.reaches, self.midpoints + self.reaches], 1)

    def between(self, first, last):
        """The placement of units ``first`` … ``last``, counted from 0, at most those there are."""
        last = min(last, len(self) - 1)
        ends = {"points": last + 3, "thetas": last + 1, "sides": last + 1}
        of_blocks = ("midpoints", "parameters", "lengths", "reaches", "legs")
        ends |= dict.fromkeys(of_blocks, last + 2)
        return replace(self, **{name: getattr(self, name)[first:end] for name, end in ends.items()})

    @property
    def followed(self):
        """Length of the curve up to the last midpoint."""
        return float(self.lengths[-1])

    @property
    def distances_from_centre(self):
        """Distances (n + 1,) of the midpoints from V of concurrent legs."""
        return np.linalg.norm(self.midpoints - self.centre, axis=1)


class Legs:
    """Direction of the strip's legs at points in space: parallel, or all through one point V."""

    def __init__(self, legs=None):
        kind, vector = ("parallel", (0, 0, 1)) if legs is None else legs
        self.vector = np.asarray(vector, float)
        if kind not in ("parallel", "point") or self.vector.shape != (3,):
            raise ValueError("Ruling: give ('parallel', direction) or ('point', V) with 3 numbers.")
        if not np.isfinite(self.vector).all() or (kind == "parallel" and not self.vector.any()):
            raise ValueError("Ruling: the direction or viewpoint must be finite and not zero.")
        self.central = kind == "point"

    def at(self, points):
        """Unit vectors along the legs, pointing to "upper" (away from V): shape of ``points``."""
        if self.central:
            return bezier.normalised(points - self.vector)
        return np.broadcast_to(bezier.normalised(self.vector), np.shape(points))


def place(curve, edge_length, gamma, pitch=0.0, legs=None, flip=False, extra=(), level=False):
    """Place isosceles triangles along ``curve`` (section 3.1; with thickness: ``hinges.md`` 5).

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
        ‖AB‖, and their midpoints a little above or below the curve.

    Returns a `Placement`. ValueError, with the place on the curve and the parameter to change, for
    a closed curve, an edge too long, a radius of curvature too small and a path that meets itself.
    """
    _check_parameters(edge_length, gamma, pitch)
    _check_count(curve, edge_length, gamma)
    table = CurveTable(curve, edge_length)
    _check_open(table, edge_length)
    legs = Legs(legs)
    if level:
        seen = CurveTable(SeenAlong(curve, legs), edge_length)
        blocks = _march(seen, legs, edge_length, gamma, pitch, flip, extra)
        lifted = seen.curve.lifted(blocks)
    else:
        blocks = lifted = _march(table, legs, edge_length, gamma, pitch, flip, extra)
    if not blocks.sines:
        raise ValueError(
            f"EdgeLength ‖AB‖ = {edge_length:.6g} mm is too long for this curve of length "
            f"{table.lengths[-1]:.6g} mm: not even one unit fits; make EdgeLength shorter, the "
            "curve longer, or Gamma smaller."
        )
    placed = _result(table, legs, edge_length, pitch, lifted)
    _check_overlap(placed, table, legs)
    return placed


@dataclass
class _Blocks:
    """Blocks found so far: parameters, midpoints, half mid-lines r e, and sin t of the units."""

    parameters: list
    midpoints: list
    reaches: list
    sines: list


def _march(table, legs, edge_length, gamma, pitch, flip, extra):
    """All blocks along a tabulated curve, from its start to the last crossing."""
    midpoint, direction, normal = _start(table.curve, legs, gamma, flip)
    r = edge_length / 2
    blocks = _Blocks([0.0], [midpoint], [r * direction], [])
    while True:
        count = len(blocks.sines)
        more = extra[min(count, len(extra) - 1)] if len(extra) else 0.0
        joint = r * direction + pitch * normal
        step = _next_block(table, blocks.parameters[-1], midpoint, joint, pitch + more)
        if step is None:
            return blocks
        parameter, point = step
        y = bezier.normalised(point - midpoint)
        sine, cosine = float(direction @ y), float(normal @ y)
        if cosine <= 0 or sine <= 0 or sine >= 1:
            _too_tight(table, blocks.parameters[-1], parameter, edge_length)
        direction = bezier.normalised(2 * sine * y - direction)
        normal = _forward_normal(direction, legs.at(point), 2 * cosine * y - normal)
        midpoint = point
        blocks.sines.append(sine)
        blocks.parameters.append(parameter)
        blocks.midpoints.append(point)
        blocks.reaches.append(r * direction)


class SeenAlong:
    """A curve as it is seen along parallel legs: projected onto the plane across them."""

    def __init__(self, curve, legs):
        if legs.central:
            raise ValueError("Level: legs through a viewpoint have no level; switch Level off.")
        self.curve, self.axis = curve, legs.at(np.zeros(3))
        for name in ("bend", "breaks"):
            if hasattr(curve, name):
                setattr(self, name, getattr(curve, name))

    def point(self, s):
        points = self.curve.point(s)
        return points - (points @ self.axis)[..., None] * self.axis

    def lifted(self, blocks):
        """Blocks moved along the legs up to the curve.

        Every joint gets the mean height of the curve at its two midpoints. (Midpoints exactly on
        the curve would make each joint's height depend on all before it, and tilt more and more.)
        """
        points = np.asarray(self.curve.point(np.array(blocks.parameters)), float)
        heights = points @ self.axis
        joints = (heights[:-1] + heights[1:]) / 2
        ends = np.concatenate(
            [2 * heights[:1] - joints[:1], joints, 2 * heights[-1:] - joints[-1:]]
        )
        off = (ends[:-1] + ends[1:]) / 2 - heights
        reaches = np.array(blocks.reaches) + (np.diff(ends) / 2)[:, None] * self.axis
        midpoints = points + off[:, None] * self.axis
        return _Blocks(blocks.parameters, list(midpoints), list(reaches), blocks.sines)


def _start(curve, legs, gamma, flip):
    """Midpoint, direction and forward normal of the first block (steps 1-3 of section 3.1)."""
    start = np.asarray(curve.point(np.array([0.0, 1e-4, 2e-4])), float)
    tangent = _start_tangent(curve)
    leg = legs.at(start[0])
    left = np.cross(leg, tangent)
    if np.linalg.norm(left) < 1e-3:
        raise ValueError(
            "Ruling: the legs run along the curve at its start; choose another direction or "
            "viewpoint for Ruling."
        )
    left = bezier.normalised(left)
    bend = (start[2] - start[1]) - (start[1] - start[0])
    straight = np.linalg.norm(bend) < 1e-9 * np.linalg.norm(start[2] - start[0])
    side = left if straight or bend @ left >= 0 else -left
    if flip:
        side = -side
    ahead = bezier.normalised(tangent - (tangent @ leg) * leg)
    direction = np.cos(gamma) * side + np.sin(gamma) * ahead
    return start[0], direction, _forward_normal(direction, leg, tangent)


def _start_tangent(curve):
    """Direction in which the curve starts: the chord over its first millionth.

    A chord needs no derivative from the curve, and it is the convention of the reference numbers
    (the exact tangent differs by less than 1e-4 degrees). A curve that starts with speed zero
    gets a longer chord.
    """
    for step in (1e-6, 1e-4, 1e-2):
        first, then = np.asarray(curve.point(np.array([0.0, step])), float)
        if np.linalg.norm(then - first) > 1e-3 * step * np.abs(curve.point(np.array([1.0]))).max():
            break
    return bezier.normalised(then - first)


def _forward_normal(direction, leg, forward):
    """Normal of a contact panel (spanned by ``direction`` and ``leg``) on the ``forward`` side."""
    normal = bezier.normalised(np.cross(direction, leg))
    return normal if normal @ forward >= 0 else -normal


def _next_block(table, start, midpoint, joint, link):
    """Parameter and point of the next block's midpoint, or None at the end of the curve.

    ``joint`` = r e + p n leads from the midpoint to the axis at B, ``link`` is half the length of
    the double hinge's link (the pitch).
    """

    def growth(points):
        d = points - midpoint
        square = (d * d).sum(-1)
        return square / 2 - link * np.sqrt(square) - d @ joint

    # |gradient| of growth within reach, plus what the link's term can bulge on a chord
    slope = 4 * (np.linalg.norm(joint) + link)
    found = table.first_crossing(start, growth, slope)
    if found is None:
        return None
    return found, np.asarray(table.curve.point(np.array([found])), float)[0]


def _result(table, legs, edge_length, pitch, blocks):
    midpoints, reach = np.array(blocks.midpoints), np.array(blocks.reaches)
    points = np.concatenate([midpoints[:1] - reach[:1], midpoints + reach])
    travel = np.diff(midpoints, axis=0)
    rulings = legs.at(midpoints)
    left = (np.cross(rulings[:-1], travel) * reach[:-1]).sum(1)
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
    )


def _check_parameters(edge_length, gamma, pitch):
    require(
        np.isfinite(edge_length) & (np.asarray(edge_length) > 0),
        "EdgeLength ‖AB‖ is {value:.6g} mm: set it to a length above 0.",
        edge_length,
    )
    require(
        np.isfinite(gamma) & (np.asarray(gamma) > 0) & (np.asarray(gamma) < np.pi / 2),
        "Gamma is {value:.6g}°: the first segment must lean forward; set Gamma above 0° and below "
        "90° (10° to 30° is usual).",
        np.degrees(gamma),
    )
    require(
        np.isfinite(pitch) & (np.asarray(pitch) >= 0) & (np.asarray(pitch) < edge_length / 4),
        "Thickness: the pitch of the panels is {value:.6g} mm; it must be at least 0 and below a "
        "quarter of EdgeLength ({0:.6g} mm).",
        pitch, edge_length / 4,
    )  # fmt: skip


def _check_count(curve, edge_length, gamma):
    """A unit advances by ‖AB‖ sin(θ/2), about ‖AB‖ sin γ: refuse more units than anyone prints."""
    rough = np.asarray(curve.point(np.linspace(0, 1, 1025)), float)
    length = np.linalg.norm(np.diff(rough, axis=0), axis=1).sum()
    if length > _MAX_UNITS * edge_length * np.sin(gamma):
        raise ValueError(
            f"EdgeLength {edge_length:.6g} mm with Gamma {np.degrees(gamma):.4g}° would need more "
            f"than {_MAX_UNITS} units along {length:.6g} mm of curve; make EdgeLength longer."
        )


def _check_open(table, edge_length):
    ends = np.linalg.norm(table.points[-1] - table.points[0])
    if not np.isfinite(table.points).all():
        raise ValueError("Curve: it has points that are not finite; check its control points.")
    if ends <= 1e-6 * table.lengths[-1]:
        raise ValueError(
            f"Curve is closed at {_where(table.points[0])}: a closed tube cannot be both bistable "
            "and flat-foldable; open the curve by a gap of a few EdgeLength."
        )


def _too_tight(table, low, high, edge_length):
    """Refuse a bend that the units cannot follow, naming its sharpest place."""
    radius, point = _sharpest(table, low, high)
    if radius > edge_length:  # the bend is wide enough
        raise ValueError(
            f"Curve: units run into each other near {_where(point)}, where they tilt too much; "
            "make EdgeLength shorter or Gamma smaller, or along a General curve move Ruling nearer "
            "to square with the curve or switch Level on."
        )
    raise ValueError(
        f"Curve: the radius of curvature is too small near {_where(point)} (about {radius:.4g} mm, "
        f"EdgeLength {edge_length:.6g} mm needs more than {edge_length / 2:.4g} mm); make "
        "EdgeLength shorter or the bend wider."
    )


def _sharpest(table, low, high):
    """Smallest radius of curvature between two parameters, and where."""
    s = np.linspace(low, high, 201)
    points = np.asarray(table.curve.point(s), float)
    first, second = np.gradient(points, s, axis=0), None
    second = np.gradient(first, s, axis=0)
    bend = bezier.curvature(first, second)[2:-2]
    k = int(np.argmax(bend))
    return 1 / max(bend[k], 1e-12), points[k + 2]


def _check_overlap(placed, table, legs):
    pair = first_overlap(placed.segments, legs)
    if pair is None:
        return
    i, j = pair
    low, high = placed.parameters[i], placed.parameters[j + 1]
    if j - i <= 4:
        _too_tight(table, low, high, placed.edge_length)
    raise ValueError(
        f"Curve: the tube meets itself: unit {i + 1} near {_where(placed.midpoints[i])} overlaps "
        f"unit {j + 1} near {_where(placed.midpoints[j])}; move these parts of the curve further "
        "apart or make EdgeLength shorter."
    )


def _where(point):
    return "(" + ", ".join(f"{x:.4g}" for x in point) + ") mm"
