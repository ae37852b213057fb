# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a print may be: units that there are, and a bed that has room for it."""

import numpy as np

from ..origami.errors import ERROR, Refusal, phrase
from ..origami.hinges.bed import Bed, check_bed, split
from ..origami.hinges.ends import stands_out


def units_of(units, count):
    """First and last unit, counted from 0, of the properties FirstUnit and LastUnit."""
    first, last = units[0] - 1, (units[1] or count) - 1
    if not 0 <= first <= last < count:
        raise Refusal(
            "{FirstUnit} {first} and {LastUnit} {last} do not name units of a tube of {count}: "
            "set {FirstUnit} to 1 or more and {LastUnit} to at most {count} (0: the last).",
            parameter="FirstUnit",
            first=units[0],
            last=units[1],
            count=count,
        )
    return first, last


def check_feet(bodies, order):
    """Refuse a bed that has no room for the feet beside the stack."""
    bed, orientation = order.room
    if not (order.ends.has_feet and any(bed) and orientation == "Flat"):
        return
    x, y, _ = size_of(bodies, [np.eye(4)] * len(bodies))
    if min(x, y) > min(bed[:2]) + 1e-6 or max(x, y) > max(bed[:2]) + 1e-6:
        raise Refusal(
            "With its feet beside the stack the print takes {x:.0f} × {y:.0f} mm, and the bed has "
            "{length:.4g} × {width:.4g} mm: choose Flange instead of Foot, or a smaller "
            "{EdgeLength}.",
            parameter="Bed",
            x=x,
            y=y,
            length=bed[0],
            width=bed[1],
        )


def check_bed_of(tube, order):
    """Refuse, by the bed of an `Order`, a print that does not fit it, with the parts that would."""
    size, orientation = order.room
    if not any(size):
        return
    first = order.units[0] - 1
    given = (
        tube.thick,
        order.parameters,
        Bed(*size),
        tube.tube.incoming_left,
        orientation == "OnEdge",
        stands_out(order.ends, order.parameters, tube.is_closed),
    )
    finding = check_bed(*given)[0]
    if finding.severity == ERROR:
        parts = ", ".join(f"{a + first + 1}–{b + first + 1}" for a, b in split(*given))
        cure = finding.cure
        if parts:
            cure = phrase("set {FirstUnit} and {LastUnit} to print the parts {parts}", parts=parts)
        raise Refusal(
            "{Bed}: {finding} Cure: {help}.",
            parameter="Bed",
            finding=finding.message,
            help=cure,
        )


def size_of(bodies, motions):
    """Length, width and height (mm) of bodies moved by matrices (4, 4); those of None count not."""
    boxes = np.array([
        body.boundary.bounds(motion @ body.place)
        for body, motion in zip(bodies, motions, strict=True)
        if motion is not None
    ])  # fmt: skip
    return tuple((boxes[:, 1].max(0) - boxes[:, 0].min(0)).tolist())
