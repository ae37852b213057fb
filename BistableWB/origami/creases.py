# SPDX-License-Identifier: LGPL-2.1-or-later
"""The crease table: which panels a unit has, in which layer, and how they are hinged.

One home for this data (``hinges.md`` 1 and 2): compensation, solids, snap, drawing and checks all
read it. Heights are in pitches p = face thickness + gap between planes, measured along the stack
(+y of the unit's flat frame, "up" in the print) from the unit's middle: *left* is below.
"""

from typing import NamedTuple

VERTICES = (
    "B_upper", "B_lower", "A_left_upper", "A_left_lower", "A_right_upper", "A_right_lower",
    "C_upper", "C_lower", "P_upper", "P_lower",
)  # fmt: skip
INDEX = {name: i for i, name in enumerate(VERTICES)}


def _panels():
    panels = {}
    for side in ("left", "right"):
        a = f"A_{side}"
        panels[f"contact_{side}"] = (f"{a}_upper", "B_upper", "B_lower", f"{a}_lower")
        panels[f"border_{side}"] = (f"{a}_upper", "C_upper", "C_lower", f"{a}_lower")
        for end in ("upper", "lower"):
            panels[f"primary_{side}_{end}"] = (f"{a}_{end}", f"B_{end}", f"P_{end}")
            panels[f"secondary_{side}_{end}"] = (f"{a}_{end}", f"P_{end}", f"C_{end}")
    return panels


PANELS = _panels()
KINDS = ("contact", "border", "primary", "secondary")


def kind_of(panel):
    """Panel kind ("contact", "border", "primary", "secondary") of a panel's name."""
    return panel.split("_")[0]


def layer_of(panel):
    """Layer 1…4 (bottom to top of the print) of a panel: ``hinges.md`` 1."""
    outer = kind_of(panel) in ("contact", "primary")
    if "left" in panel:
        return 1 if outer else 2
    return 4 if outer else 3


LAYER_HEIGHT_IN_PITCHES = {1: -1.5, 2: -0.5, 3: 0.5, 4: 1.5}

# Links of the double hinges: one body between the two axes at −p and +p.
LINKS = {
    "link_upper": ("P_upper", "B_upper"),
    "link_B": ("B_upper", "B_lower"),
    "link_lower": ("P_lower", "B_lower"),
}
BODIES = (*PANELS, *LINKS)


class Crease(NamedTuple):
    """One hinge axis of a unit.

    ``vertices`` are the two ends of the crease, ``bodies`` the two it joins (panel or link names),
    ``height`` the axis height in pitches. ``stretch`` names the part of the crease that may carry
    knuckles: both crease ends, or one end and "C" (the foot of C' on A–B).
    """

    name: str
    vertices: tuple
    bodies: tuple
    height: int
    stretch: tuple
    double: bool = False


def _creases():
    table = []
    for side, h in (("left", -1), ("right", 1)):
        a = f"A_{side}"
        leg = (f"{a}_upper", f"{a}_lower")
        table.append(Crease(f"leg_A_{side}", leg, (f"contact_{side}", f"border_{side}"), h, leg))
        for end in ("upper", "lower"):
            ae, b, c, p = f"{a}_{end}", f"B_{end}", f"C_{end}", f"P_{end}"
            primary, secondary = f"primary_{side}_{end}", f"secondary_{side}_{end}"
            table += [
                Crease(f"AP_{side}_{end}", (ae, p), (primary, secondary), h, (ae, p)),
                Crease(f"AB_{side}_{end}", (ae, b), (f"contact_{side}", primary), h, (c, b)),
                Crease(f"AC_{side}_{end}", (ae, c), (f"border_{side}", secondary), h, (ae, c)),
            ]
    for end in ("upper", "lower"):
        pc = (f"P_{end}", f"C_{end}")
        table.append(
            Crease(f"PC_{end}", pc, (f"secondary_left_{end}", f"secondary_right_{end}"), 0, pc)
        )
    leg = ("C_upper", "C_lower")
    table.append(Crease("leg_C", leg, ("border_left", "border_right"), 0, leg))
    for side, h in (("left", -1), ("right", 1)):
        for end in ("upper", "lower"):
            pb = (f"P_{end}", f"B_{end}")
            table.append(
                Crease(
                    f"PB_{side}_{end}", pb, (f"primary_{side}_{end}", f"link_{end}"), h, pb, True
                )
            )
        leg = ("B_upper", "B_lower")
        table.append(Crease(f"leg_B_{side}", leg, (f"contact_{side}", "link_B"), h, leg, True))
    return tuple(table)


CREASES = _creases()
