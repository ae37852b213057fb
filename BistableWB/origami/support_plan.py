# SPDX-License-Identifier: LGPL-2.1-or-later
"""What soluble support fills in the flat-folded print (``hinges.md`` 6): convex prisms, as plans.

Between two stacked panels: where both their cores are, which no barrel enters. Under the part of
the upper contact panel and triangles that has no border panel below it: outside the barrels of the
hinges at C'. Prisms touch panels and keep the clearance from barrels, by construction.
"""

from . import plan


def unit_prisms(layout, parameters):
    """[(corners, low, high)] of one unit: convex plan polygons and heights (mm)."""
    half = parameters.gap_between_planes / 2
    outer, inner = parameters.pitch, 0.0
    found = []
    for outside, inside, height in _stacked():
        common = plan.intersection(*(layout.plates[name].core for name in (outside, inside)))
        level = height * (outer if "contact" in outside or "primary" in outside else inner)
        found.append((common, level - half, level + half))
    for low, high, hinge_name in _tall():
        cores = [layout.plates[name].core for name in (low, high)]
        common = plan.intersection(*cores)
        beyond = _beyond(layout.hinges[hinge_name], layout, parameters)
        if common:
            common = plan.clip(common, [None] * len(common), *beyond, None)[0]
        found.append((common, -outer - half, outer + half))
    return [prism for prism in found if prism[0]]


def joint_prisms(below, above, to_print):
    """[corners] between the triangles of two stacked units, in the print's plan.

    ``below``, ``above``: cores of the lower unit's upper triangles and of the upper unit's lower
    ones; ``to_print(core, which)`` carries a core of unit 0 (below) or 1 (above) into that plan.
    """
    lower = [to_print(core, 0) for core in below]
    upper = [to_print(core, 1) for core in above]
    common = [plan.intersection(a, b) for a in lower for b in upper]
    return [corners for corners in common if corners]


def _stacked():
    pairs = [("border_left", "border_right", 0)]
    for side, sign in (("left", -1), ("right", 1)):
        pairs.append((f"contact_{side}", f"border_{side}", sign))
        for end in ("upper", "lower"):
            pairs.append((f"primary_{side}_{end}", f"secondary_{side}_{end}", sign))
    for end in ("upper", "lower"):
        pairs.append((f"secondary_left_{end}", f"secondary_right_{end}", 0))
    return pairs


def _tall():
    yield "contact_left", "contact_right", "leg_C"
    for end in ("upper", "lower"):
        yield f"primary_left_{end}", f"primary_right_{end}", f"PC_{end}"


def _beyond(hinge, layout, parameters):
    """(origin, normal) of the half-plane on the far side of a hinge at C' from its panels."""
    core = layout.plates[hinge.bodies[0]].core
    away = 1j * hinge.direction
    if plan.dot(sum(core) / len(core) - hinge.origin, away) > 0:
        away = -away
    return hinge.origin + parameters.cut_back * away, away
