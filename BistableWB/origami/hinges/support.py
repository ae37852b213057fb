# SPDX-License-Identifier: LGPL-2.1-or-later
"""What soluble support fills in the flat-folded print (hinges.md 6): convex prisms, as plans.

Between two stacked panels: where both their cores are, which no barrel enters. Under the part of
the upper contact panel and triangles that has no border panel below it: outside the barrels of the
hinges at C'. Prisms touch panels and keep the clearance from barrels, by construction.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from ..thick import print_stack
from . import polygons
from .bodies import in_print_plan, tube_layouts, walls
from .drafting import Draft

if TYPE_CHECKING:
    from ..thick.linkage import ThickUnit
    from .boundary import Boundary
    from .parameters import HingeParameters
    from .unit_layout import Hinge, Layout


def support_prisms(
    thick: "ThickUnit", parameters: "HingeParameters", incoming_left: NDArray | None = None
) -> "list[Boundary]":
    """Boundaries of a tube's support in the print frame: convex prisms.

    Arguments as for `bodies.tube_drawn`. They fill the gaps between stacked panels, touch them, and
    keep the clearance from every barrel; what overhangs outside the stack is the slicer's.
    """
    layouts = tube_layouts(thick, parameters)
    places = print_stack.frames(thick, incoming_left)
    if incoming_left is None:
        incoming_left = print_stack.alternating(len(layouts))
    prisms = []
    for k, layout in enumerate(layouts):
        for corners, low, high in unit_prisms(layout, parameters):
            z = sorted(float((places[k] @ [0, y, 0, 1])[2]) for y in (low, high))
            prisms.append(prism(in_print_plan(corners, places[k]), *z))
        if k + 1 < len(layouts):
            prisms += _between(layouts, places, incoming_left, k, parameters)
    return prisms


def prism(corners: Sequence[complex], low: float, high: float) -> "Boundary":
    """`Boundary` of an upright prism: plan corners x + i y, counter-clockwise, and two heights."""
    draft = Draft()
    rings = [[draft.vertex((p.real, p.imag, z)) for p in corners] for z in (low, high)]
    walls(draft, rings[0], rings[1])
    draft.polygon(*reversed(rings[0]))
    draft.polygon(*rings[1])
    return draft.boundary()


def _between(
    layouts: "Sequence[Layout]",
    places: NDArray,
    incoming_left: NDArray,
    k: int,
    parameters: "HingeParameters",
) -> "list[Boundary]":
    """Prisms between the triangles of unit k and of the unit on it."""
    leave = "right" if incoming_left[k] else "left"
    entry = "left" if incoming_left[k + 1] else "right"
    below, above = (
        [layout.plates[f"primary_{side}_{end}"].core for end in ("upper", "lower")]
        for layout, side in ((layouts[k], leave), (layouts[k + 1], entry))
    )
    plans = joint_prisms(below, above, lambda core, i: in_print_plan(core, places[k + i]))
    low = (4 * k + 4) * parameters.pitch - parameters.gap_between_planes
    return [prism(corners, low, low + parameters.gap_between_planes) for corners in plans]


def unit_prisms(
    layout: "Layout", parameters: "HingeParameters"
) -> list[tuple[list[complex], float, float]]:
    """[(corners, low, high)] of one unit: convex plan polygons and heights (mm)."""
    half = parameters.gap_between_planes / 2
    outer, inner = parameters.pitch, 0.0
    found = []
    for outside, inside, height in _stacked():
        common = polygons.intersection(*(layout.plates[name].core for name in (outside, inside)))
        level = height * (outer if "contact" in outside or "primary" in outside else inner)
        found.append((common, level - half, level + half))
    for low, high, hinge_name in _tall():
        cores = [layout.plates[name].core for name in (low, high)]
        common = polygons.intersection(*cores)
        beyond = _beyond(layout.hinges[hinge_name], layout, parameters)
        if common:
            common = polygons.clip(common, [None] * len(common), *beyond, None)[0]
        found.append((common, -outer - half, outer + half))
    return [prism for prism in found if prism[0]]


def joint_prisms(
    below: Sequence[Sequence[complex]],
    above: Sequence[Sequence[complex]],
    to_print: Callable[..., Any],
) -> list[list[complex]]:
    """[corners] between the triangles of two stacked units, in the print's plan.

    ``below``, ``above``: cores of the lower unit's upper triangles and of the upper unit's lower
    ones; ``to_print(core, which)`` carries a core of unit 0 (below) or 1 (above) into that plan.
    """
    lower = [to_print(core, 0) for core in below]
    upper = [to_print(core, 1) for core in above]
    common = [polygons.intersection(a, b) for a in lower for b in upper]
    return [corners for corners in common if corners]


def _stacked() -> list[tuple[str, str, int]]:
    pairs = [("border_left", "border_right", 0)]
    for side, sign in (("left", -1), ("right", 1)):
        pairs.append((f"contact_{side}", f"border_{side}", sign))
        for end in ("upper", "lower"):
            pairs.append((f"primary_{side}_{end}", f"secondary_{side}_{end}", sign))
    for end in ("upper", "lower"):
        pairs.append((f"secondary_left_{end}", f"secondary_right_{end}", 0))
    return pairs


def _tall() -> Iterator[tuple[str, ...]]:
    yield "contact_left", "contact_right", "leg_C"
    for end in ("upper", "lower"):
        yield f"primary_left_{end}", f"primary_right_{end}", f"PC_{end}"


def _beyond(
    hinge: "Hinge", layout: "Layout", parameters: "HingeParameters"
) -> tuple[complex, complex]:
    """(origin, normal) of the half-plane on the far side of a hinge at C' from its panels."""
    core = layout.plates[hinge.bodies[0]].core
    away = 1j * hinge.direction
    if polygons.dot(sum(core) / len(core) - hinge.origin, away) > 0:
        away = -away
    return hinge.origin + parameters.cut_back * away, away
