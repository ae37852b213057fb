# SPDX-License-Identifier: LGPL-2.1-or-later
"""The crease table: which panels a unit has, in which layer, and how they are hinged.

One home for this data (hinges.md 1 and 2): compensation, solids, snap, drawing and checks all
read it. Heights are in pitches p = face thickness + gap between planes, measured along the stack
(+y of the unit's flat frame, "up" in the print) from the unit's middle: *left* is below.
"""

from typing import Any, NamedTuple

VERTICES = (
    "B_upper", "B_lower", "A_left_upper", "A_left_lower", "A_right_upper", "A_right_lower",
    "C_upper", "C_lower", "P_upper", "P_lower",
)  # fmt: skip
INDEX = {name: i for i, name in enumerate(VERTICES)}


def _panels() -> Any:
    panels: dict[str, tuple[str, ...]] = {}
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
# Links of the double hinges: one body between the two axes at −p and +p.
LINKS = {
    "link_upper": ("P_upper", "B_upper"),
    "link_B": ("B_upper", "B_lower"),
    "link_lower": ("P_lower", "B_lower"),
}
BODIES = (*PANELS, *LINKS)

_KIND_OF = {panel: kind for kind in KINDS for panel in PANELS if panel.startswith(f"{kind}_")}
_KIND_OF |= dict.fromkeys(LINKS, "link")
# Layer (1…4, bottom to top of the print) of the outer and of the inner panels of each side.
_LAYERS = {"left": (1, 2), "right": (4, 3)}
_LAYER_OF = {
    panel: _LAYERS[side][kind in ("border", "secondary")]
    for panel, kind in _KIND_OF.items()
    for side in _LAYERS
    if f"_{side}" in panel
}


def kind_of(body: str) -> str:
    """Kind of a panel ("contact", "border", "primary", "secondary"), or "link" of a link."""
    return _KIND_OF[body]


def layer_of(panel: str) -> int:
    """Layer 1…4 (bottom to top of the print) of a panel: docs/theory/hinges.md 1."""
    return _LAYER_OF[panel]


LAYER_HEIGHT_IN_PITCHES = {1: -1.5, 2: -0.5, 3: 0.5, 4: 1.5}


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


def _creases() -> tuple[Crease, ...]:
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
