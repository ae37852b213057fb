# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact panels of units along a curve with any legs, and what section 4 asks of them."""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..curves.bezier import normalised
from ..errors import Refusal, require
from .closed_forms import contact_radius

if TYPE_CHECKING:
    from ..curves.placement import Placement

INPUT_SLACK = 1e-9  # in units of ‖AB‖: how far contacts may miss what section 4 asks of them
THINNEST = 1e-5  # smallest sine of a corner, and shortest edge in ‖AB‖, that still counts as one


def contact_quads(placement: "Placement", strip_height: float) -> NDArray:
    """Contact panels of a `placement.Placement`: (n + 1, 4, 3), in the placement's coordinates.

    Corners of quadrilateral k: start_upper, joint_upper, joint_lower, start_lower, where the joint
    is the second end of segment k (B of unit k, A of unit k − 1: see `contact_pairs`).
    Parallel legs: ``strip_height`` h is the length of every leg, half of it on either side of the
    segment; legs across the segment give the rectangle of `plane_unit`. Legs through V: the segment
    is the outer base and each leg is cut at 1 − h/r of its distance from V, with r the distance
    of the segment's midpoint from V (mean of the two segments that share the leg): on a sphere the
    trapezoid of section 3. ValueError where h leaves no inner base.
    """
    require(
        np.isfinite(strip_height) & (np.asarray(strip_height) > 0),
        "Strip height h is {value:.6g}: set {HeightRatio} ‖AB‖/h to a number above 0.",
        strip_height,
        parameter="HeightRatio",
    )
    upper = lower = placement.segments
    if placement.centre is None:
        reach = strip_height / 2 * placement.legs[:, None]
        upper, lower = upper + reach, lower - reach
    else:
        centre, r = placement.centre, placement.distances_from_centre
        require(
            r > strip_height,
            "Strip height h = {0:.6g}{at} does not fit between the curve and the viewpoint, which "
            "is {value:.6g} away: raise {HeightRatio} or move {Ruling}'s viewpoint away.",
            r, strip_height,
            parameter="HeightRatio",

        )  # fmt: skip
        at_joints = (r[:-1] + r[1:]) / 2
        ends = np.stack([np.append(r[:1], at_joints), np.append(at_joints, r[-1:])], 1)
        lower = centre + (1 - strip_height / ends)[..., None] * (upper - centre)
    return np.stack([upper[:, 0], upper[:, 1], lower[:, 1], lower[:, 0]], 1)


def sphere_contacts(theta: NDArray, edge_length: float, omega: Any, strip_height: float) -> Any:
    """``(left, right)`` contact trapezoids (n, 4, 3) of section 3, open by ``theta`` (n,).

    They stand as those of `closed_forms.sphere_unit`: outer base ‖AB‖ at z = h/2, base angle
    ``omega`` (radians, scalar or (n,)). ValueError where h leaves no inner base.
    """
    radius = contact_radius(edge_length, omega) / edge_length
    require(
        strip_height < radius * edge_length,
        "Strip height h = {value:.6g} is too large for omega {0:.4g}°: the inner base vanishes at "
        "{1:.6g}; raise {HeightRatio} or omega (a larger sphere).",
        strip_height,
        np.degrees(omega),
        radius * edge_length,
        parameter="HeightRatio",
    )
    t = np.asarray(theta, float) / 2
    rho = 1 / (2 * np.cos(t))
    zero = np.zeros_like(t)
    b = np.stack([np.cos(t), zero, zero], -1)
    centre = np.stack([np.cos(t) - rho, zero, -np.sqrt(radius**2 + 0.25 - rho**2)], -1)
    share = np.broadcast_to(1 - strip_height / (radius * edge_length), t.shape)[:, None]
    found = []
    for side in (-1, 1):
        a = np.stack([zero, side * np.sin(t), zero], -1)
        lower = [centre + share * (corner - centre) for corner in (b, a)]
        quads = np.stack([a, b, *lower], 1) * edge_length
        quads[..., 2] += strip_height / 2
        found.append(quads)
    return found


def contact_pairs(
    placement: "Placement", strip_height: float, sines: NDArray | None = None
) -> tuple[NDArray, NDArray]:
    """``(left, right)`` contacts of the n units of a placement for `general_unit`: (n, 4, 3) each.

    Where the joint is left of the path (``sides`` +1) the unit is turned over about its leg, so
    its *left* contact is the one ahead: every unit then has the hand of `plane_unit`.

    With a pitch the two axes of a unit's double hinge are parallel, each in the plane of its block:
    so both run along the line in which these planes meet. Contacts are moved by half the double
    hinge, to the leg in the middle. ``sines`` (n,), added to sin(θ/2), opens them wider.
    """
    quads = contact_quads(placement, strip_height)
    behind, ahead = quads[:-1], quads[1:, [1, 0, 3, 2]]
    if placement.pitch > 0:
        if placement.centre is not None:
            behind, ahead = _leaning(placement, strip_height, behind, ahead)
        shift = (ahead[:, 1:2] - behind[:, 1:2]) / 2
        behind, ahead = behind + shift, ahead - shift
    if sines is not None and np.any(sines):
        behind, ahead = _opened(behind, ahead, sines)
    turned = (placement.sides > 0)[:, None, None]
    return np.where(turned, ahead, behind), np.where(turned, behind, ahead)


def _leaning(
    placement: "Placement", strip_height: float, behind: NDArray, ahead: NDArray
) -> list[NDArray]:
    """Thick contacts, whose legs meet in a point of the unit's own, nearer than the viewpoint V.

    The planes of both blocks pass V and meet in a line V-Q, with Q on a block's mid-line beyond
    its joint B; the leg at B is parallel to it. It meets the leg of the block's midpoint M at the
    share |B − M| / |Q − M| of the way from M to V: 1 without thickness. The mean of both blocks
    counts, and h cuts the legs as in `contact_quads`.
    """
    v, r = placement.centre, placement.distances_from_centre
    along, legs = normalised(placement.reaches), placement.legs
    normals = np.cross(along, legs)
    leg = normalised(np.cross(normals[:-1], normals[1:]))
    leg *= np.sign((leg * legs[:-1]).sum(1, keepdims=True))
    shares, reaches = [], []
    for quads, k, out in ((behind, slice(None, -1), along), (ahead, slice(1, None), -along)):
        m, out, normal = placement.midpoints[k], out[k], normals[k]
        q = -_triple(m - v, leg, normal) / _triple(out, leg, normal)
        require(
            q > 0,
            "The blocks{at} lean so much that their planes meet on the wrong side: make "
            "{EdgeLength} shorter or move {Ruling}'s viewpoint nearer to square with the curve.",
            parameter="EdgeLength",
        )
        shares.append(((quads[:, 1] - m) * out).sum(1) / q)
        reaches.append(shares[-1] * ((m + q[:, None] * out - v) * leg).sum(1))
    share, reach = np.mean(shares, axis=0), np.mean(reaches, axis=0)[:, None]
    at_joints = (r[:-1] + r[1:]) / 2
    require(
        share * at_joints > strip_height,
        "Strip height h = {0:.6g}{at} does not fit between the curve and the point where the legs "
        "of its thick panels meet, {value:.6g} away: raise {HeightRatio}, make the panels thinner "
        "({FaceThickness}, {GapBetweenPlanes}) or {Gamma} larger.",
        share * at_joints, strip_height,
        parameter="HeightRatio",

    )  # fmt: skip
    far = np.append(r[:1], at_joints[:-1]), np.append(at_joints[1:], r[-1:])
    found = []
    for quads, distance in zip((behind, ahead), far, strict=True):
        a, b = quads[:, 0], quads[:, 1]
        cut_a, cut_b = (strip_height / (share * x)[:, None] for x in (distance, at_joints))
        a_low = a - cut_a * (a - (b - reach * leg))
        found.append(np.stack([a, b, b - cut_b * reach * leg, a_low], 1))
    return found


def _opened(behind: NDArray, ahead: NDArray, sines: NDArray) -> list[NDArray]:
    """Contacts turned about the leg at B, half each, so that sin(θ/2) grows by ``sines``."""
    pivot = behind[:, 2:3]
    leg = normalised(behind[:, 1] - behind[:, 2])
    outs = [normalised(np.cross(np.cross(leg, q[:, 0] - q[:, 1]), leg)) for q in (behind, ahead)]
    half = np.arctan2(*(np.linalg.norm(v, axis=1) for v in (outs[1] - outs[0], outs[0] + outs[1])))
    change = np.arcsin(np.sin(half) + sines) - half
    change *= np.sign(_triple(outs[0], outs[1], leg))
    return [
        pivot + (q - pivot) @ np.swapaxes(rigid.rotation(way * change[:, None] * leg), 1, 2)
        for q, way in ((behind, -1), (ahead, 1))
    ]


def normalised_contacts(
    contact_left: NDArray, contact_right: NDArray | None
) -> tuple[NDArray, ...]:
    """Contacts as (n, 2, 4, 3) with ‖AB‖ = 1 about the middle of the leg at B; origin and scale."""
    pair = [np.array(q, float) for q in (contact_left, contact_right)]
    if pair[0].shape != pair[1].shape or pair[0].shape[-2:] != (4, 3) or pair[0].ndim > 3:
        raise Refusal(
            "Contacts: give two arrays of shape (4, 3) or (n, 4, 3) with the corners A_upper, "
            "B_upper, B_lower, A_lower; these have shapes {left} and {right}.",
            left=pair[0].shape,
            right=pair[1].shape,
        )
    quads = np.stack([q.reshape(-1, 4, 3) for q in pair], 1)
    if not len(quads):
        raise Refusal("Contacts: there is no unit; give at least one pair of quadrilaterals.")
    require(
        np.isfinite(quads).all((1, 2, 3)),
        "Contacts{at} have coordinates that are not finite numbers; give them numbers in mm.",
    )
    origin = quads[:, :, 1:3].mean((1, 2))
    edges = np.linalg.norm(quads - np.roll(quads, -1, axis=2), axis=-1)
    scale = edges[..., 0].mean(1)
    require(
        edges.min((1, 2)) > THINNEST * scale,
        "A contact quadrilateral{at} has an edge of length {value:.3g}: corners coincide; give "
        "four different corners (A_upper, B_upper, B_lower, A_lower).",
        edges.min((1, 2)),
    )
    quads = (quads - origin[:, None, None]) / scale[:, None, None, None]
    _check_contacts(quads)
    return quads, origin, scale


def _check_contacts(quads: NDArray) -> None:
    """ValueError unless the contacts are planar and convex, share B, and one ruling fits both."""
    a, b, b_low, a_low = np.moveaxis(quads, 2, 0)
    legs = normalised(a - a_low)
    leg_b = normalised(b - b_low)
    require(
        np.linalg.norm(quads[:, 0, 1:3] - quads[:, 1, 1:3], axis=-1).max(1) <= INPUT_SLACK,
        "The two contact quadrilaterals{at} do not share the leg at B: give both with the corners "
        "A_upper, B_upper, B_lower, A_lower and the same B_upper and B_lower.",
    )
    off = np.abs(_triple(legs, leg_b, normalised(a - b))).max(1)
    require(
        off <= INPUT_SLACK,
        "A contact quadrilateral{at} is not planar (by {value:.2g} of its size): move its corners "
        "into one plane.",
        off,
    )
    bends = normalised(np.cross(np.roll(quads, -1, 2) - quads, np.roll(quads, -2, 2) - quads))
    convex = (bends * bends[:, :, :1]).sum(-1).min((1, 2)) > 0
    require(
        convex,
        "A contact quadrilateral{at} is not convex: its legs cross or its corners are out of "
        "order; make the strip lower (raise {HeightRatio}) or move {Ruling}'s viewpoint away.",
        parameter="HeightRatio",
    )
    off = np.abs(_triple(legs[:, 0], legs[:, 1], normalised(a[:, 0] - a[:, 1])))
    require(
        off <= INPUT_SLACK,
        "The legs{at} are neither parallel nor all through one point (by {value:.2g}): a "
        "flat-foldable unit needs one {Ruling}, a direction or a viewpoint, for both contacts.",
        off,
        parameter="Ruling",
    )


def check_opening(theta: NDArray) -> None:
    """ValueError unless the contacts open by an angle between 0° and 180° (radians, (n,))."""
    require(
        (theta > 1e-4) & (theta < np.pi - 1e-4),
        "The contacts{at} open by {value:.4g}° about the leg at B: the opening must lie between "
        "0° and 180°; use a larger {Gamma} or {EdgeLength}.",
        np.degrees(theta),
        parameter="Gamma",
    )


def _triple(a: NDArray, b: NDArray, c: NDArray) -> NDArray:
    return (a * np.cross(b, c)).sum(-1)
