# SPDX-License-Identifier: LGPL-2.1-or-later
"""The families of curves: one table, pure data (theory: geometry.md 2).

To add one, add a line; `tube.along` makes its units. Objects, the panel of a curve, design files
and docs/theory/geometry.md read it.
"""

from typing import NamedTuple


class Family(NamedTuple):
    """``curve`` and ``legs``: what they are; ``icon`` of such a Curve object.

    ``tip``: what it is to someone who chooses it in a panel, by names of properties;
    ``wraps``: whether points without heights are a plan that is laid on it;
    ``keys``: {key of [curve]: property} of what only this family uses; ``needed``: those without
    which there is none, with an example; ``instead``: {one of these: another that gives it};
    ``found``: whether they count where it was found too.
    """

    curve: str
    legs: str
    icon: str = "Curve"
    keys: dict = {}
    needed: dict = {}
    instead: dict = {}
    found: bool = False
    tip: str = ""
    wraps: bool = False


FAMILIES = {
    "Plane": Family("any plane curve", "parallel to the plane's normal", tip="any plane in space"),
    "Sphere": Family(
        "on a sphere about V",
        "through the centre V",
        "CurveOnSphere",
        {
            "sphere_radius": "SphereRadius",
            "sphere_center": "SphereCenter",
            "omega": "Omega",
            "omega_edge_length": "OmegaEdgeLength",
        },
        {"sphere_radius": "150 (mm)"},
        {"sphere_radius": "omega"},
        tip="on the sphere of SphereRadius about SphereCenter",
        wraps=True,
    ),
    "General": Family(
        "any smooth curve in space that is seen once from there",
        "parallel to one direction, **or** through one point V",
        keys={"ruling_kind": "RulingKind", "ruling": "Ruling"},
        found=True,
        tip="any space curve, see Ruling",
    ),
}
AUTOMATIC = "Automatic"  # the family is found
KINDS = (AUTOMATIC, *FAMILIES)
# Tooltips of panels.
KINDS_TIP = ". ".join(
    [
        f"{AUTOMATIC}: what the curve is found to be, see FoundKind",
        *(f"{name}: {family.tip or family.curve}" for name, family in FAMILIES.items()),
    ]
)
FOUND_TIP = "What the curve is taken for: " + " or ".join(
    [", ".join([*FAMILIES][:-1]), [*FAMILIES][-1]]
)


def wraps(kind: str) -> bool:
    """Whether points without heights of a curve of this ``kind`` are a plan to be laid on it."""
    return kind in FAMILIES and FAMILIES[kind].wraps


def counts(family: str, kind: str, found: str = "") -> bool:
    """Whether what only a ``family`` uses counts for a curve of a ``kind``, found to be ``found``.

    Before it is found ("") whatever may count does.
    """
    if kind == AUTOMATIC:
        return FAMILIES[family].found and found in ("", family)
    return kind == family
