# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contact panels of units along a curve with any legs, and what section 4 asks of them."""

import numpy as np

from .bezier import normalised
from .errors import require

INPUT_SLACK = 1e-9  # in units of ‖AB‖: how far contacts may miss what section 4 asks of them
THINNEST = 1e-5  # smallest sine of a corner, and shortest edge in ‖AB‖, that still counts as one


def contact_quads(placement, strip_height):
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
        "Strip height h is {value:.6g}: set HeightRatio ‖AB‖/h to a number above 0.",
        strip_height,
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
            "is {value:.6g} away: raise HeightRatio or move Ruling's viewpoint away.",
            r, strip_height,
        )  # fmt: skip
        at_joints = (r[:-1] + r[1:]) / 2
        ends = np.stack([np.append(r[:1], at_joints), np.append(at_joints, r[-1:])], 1)
        lower = centre + (1 - strip_height / ends)[..., None] * (upper - centre)
    return np.stack([upper[:, 0], upper[:, 1], lower[:, 1], lower[:, 0]], 1)


def contact_pairs(placement, strip_height):
    """``(left, right)`` contacts of the n units of a placement for `general_unit`: (n, 4, 3) each.

    Where the joint is left of the path (``sides`` +1) the unit is turned over about its leg, so
    its *left* contact is the one ahead: every unit then has the hand of `plane_unit`. For thick
    placements with parallel legs (pitch > 0) each contact is moved by half the double hinge, to the
    leg in the middle; through a viewpoint thick contacts do not meet (ValueError).
    """
    quads = contact_quads(placement, strip_height)
    behind, ahead = quads[:-1], quads[1:, [1, 0, 3, 2]]
    if placement.pitch > 0:
        if placement.centre is not None:
            raise ValueError(
                "Thickness: contacts of thick panels whose legs meet at a viewpoint share no leg; "
                "place the curve with Thickness none."
            )
        shift = (ahead[:, 1:2] - behind[:, 1:2]) / 2
        behind, ahead = behind + shift, ahead - shift
    turned = (placement.sides > 0)[:, None, None]
    return np.where(turned, ahead, behind), np.where(turned, behind, ahead)


def normalised_contacts(contact_left, contact_right):
    """Contacts as (n, 2, 4, 3) with ‖AB‖ = 1 about the middle of the leg at B; origin and scale."""
    pair = [np.array(q, float) for q in (contact_left, contact_right)]
    if pair[0].shape != pair[1].shape or pair[0].shape[-2:] != (4, 3) or pair[0].ndim > 3:
        raise ValueError(
            "Contacts: give two arrays of shape (4, 3) or (n, 4, 3) with the corners A_upper, "
            f"B_upper, B_lower, A_lower; these have shapes {pair[0].shape} and {pair[1].shape}."
        )
    quads = np.stack([q.reshape(-1, 4, 3) for q in pair], 1)
    if not len(quads):
        raise ValueError("Contacts: there is no unit; give at least one pair of quadrilaterals.")
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


def _check_contacts(quads):
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
        "order; make the strip lower (raise HeightRatio) or move Ruling's viewpoint away.",
    )
    off = np.abs(_triple(legs[:, 0], legs[:, 1], normalised(a[:, 0] - a[:, 1])))
    require(
        off <= INPUT_SLACK,
        "The legs{at} are neither parallel nor all through one point (by {value:.2g}): a flat-"
        "foldable unit needs one Ruling, a direction or a viewpoint, for both contacts.",
        off,
    )


def check_opening(theta):
    """ValueError unless the contacts open by an angle between 0° and 180° (radians, (n,))."""
    require(
        (theta > 1e-4) & (theta < np.pi - 1e-4),
        "The contacts{at} open by {value:.4g}° about the leg at B: the opening must lie between 0° "
        "and 180°; use a larger Gamma or EdgeLength.",
        np.degrees(theta),
    )


def _triple(a, b, c):
    return (a * np.cross(b, c)).sum(-1)
