# SPDX-License-Identifier: LGPL-2.1-or-later
"""All bodies of a print as boundaries, without a CAD kernel: units on each other, and blocks.

theory/hinges.md 1: flat-folded units lie on each other; two contact panels and what fills the gap
between them are one block.
"""

import itertools
from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal, phrase
from ..progress import NOBODY
from ..thick import print_stack
from . import polygons
from .boundary import Boundary
from .copies import Copies, copies_for
from .drafting import Draft
from .fingers import draw_pocketed, flexure_boundary
from .flexures import strips
from .knuckles import draw_plate
from .layout import unit_layout
from .standoffs import with_standoffs

if TYPE_CHECKING:
    from ..progress import Progress
    from ..thick.linkage import ThickUnit
    from .parameters import HingeParameters
    from .unit_layout import Layout, Plate

# The part of a block between its two panels ends this far (mm) inside both.
BLOCK_INSET = 0.1


class Drawn(NamedTuple):
    """One body of a print: ``boundary``, shared by its copies, and ``place`` (4, 4) of this one.

    ``unit``, ``members`` and ``kind`` as in `solids.tube.Body`; ``seat``: of what is printed beside
    the stack, (unit, panel, motion (4, 4) from there to its seat on the flat panel).
    """

    name: str
    boundary: Boundary
    place: np.ndarray
    unit: int
    members: tuple
    kind: str
    seat: tuple | None = None


def tube_drawn(
    thick: "ThickUnit",
    parameters: "HingeParameters",
    incoming_left: NDArray | None = None,
    progress: "Progress" = NOBODY,
    notes: list[Any] | None = None,
) -> list[Drawn]:
    """`Drawn` list of all bodies of a tube in the print frame, n units: 15 n − (n − 1) bodies.

    ``thick``: `ThickUnit`, one or a batch, with the ``parameters``' face thickness and gap;
    ``incoming_left`` as in `tube.Tube` (alternating if not given); ``progress``
    steps after every unit; ``notes``: a list that takes remarks (hinges
    with fewer segments). `Refusal` where a hinge has no room.
    """
    layouts = printed_layouts(thick, parameters, incoming_left, notes)
    places = print_stack.frames(thick, incoming_left)
    count = len(layouts)
    if incoming_left is None:
        incoming_left = print_stack.alternating(count)
    contacts = [print_stack.contact_names(left) for left in incoming_left]
    copies = copies_for(parameters)
    bodies = []
    for k, layout in enumerate(layouts):
        entry, leave = contacts[k]
        joined = ({entry} if k > 0 else set()) | ({leave} if k < count - 1 else set())
        bodies += _unit_bodies(layout, copies, joined, places[k], k)
        if k < count - 1:
            bodies.append(_block(layouts, places, contacts, k, parameters))
        progress.step("Hinged solids…", (k + 1) / count)
    return bodies


def _unit_bodies(
    layout: "Layout", copies: Copies, joined: set[str], place: NDArray, k: int
) -> list[Drawn]:
    """Bodies of one unit without the contact panels that blocks take (``joined``)."""
    return [
        Drawn(
            f"unit{k + 1:02d}_{name}", boundary, place @ matrix, k,
            () if kind == "flexure" else ((k, name),), kind,
        )
        for name, boundary, matrix, kind in layout_drawn(layout, copies.parameters, copies, joined)
    ]  # fmt: skip


def layout_drawn(
    layout: "Layout",
    parameters: "HingeParameters",
    copies: Copies | None = None,
    without: Collection[str] = (),
) -> list[tuple[str, Boundary, NDArray, str]]:
    """(name, `Boundary`, matrix that carries it, kind) of all bodies of a `unit_layout.Layout`.

    In its frame: plates and links, or plates with pockets and flexures ("flexure_" and the hinge's
    name).
    """
    copies = copies or Copies(parameters)
    plates = {name: plate for name, plate in layout.plates.items() if name not in without}
    if parameters.has_knuckles:
        made = [(name, *copies.plate(plate), plate.kind) for name, plate in plates.items()]
        return made + [(name, *copies.link(link), "link") for name, link in layout.links.items()]
    found, here = strips(layout, parameters), np.eye(4)
    made = []
    for name, plate in plates.items():
        draft = Draft()
        draw_panel(draft, plate, parameters, found)
        made.append((name, draft.boundary(), here, plate.kind))
    for name, strip in found.items():
        made.append((f"flexure_{name}", flexure_boundary(strip, parameters), here, "flexure"))
    return made


def draw_panel(
    draft: Draft,
    plate: "Plate",
    parameters: "HingeParameters",
    found: Any = None,
    holes: Mapping[int, Sequence[Sequence[int]]] | None = None,
) -> None:
    """Draws a panel with its knuckles, or with the pockets for the flexures ``found`` (`strips`).

    ``holes``: {−1 or 1: loops} in its lower or upper face, clockwise from outside.
    """
    if not parameters.has_knuckles:
        fingers = [f for strip in found.values() for f in strip.fingers.get(plate.name, ())]
        draw_pocketed(draft, plate, fingers, parameters, holes)
    else:
        draw_plate(draft, plate, parameters, holes)


def printed_layouts(
    thick: "ThickUnit",
    parameters: "HingeParameters",
    incoming_left: NDArray | None = None,
    notes: list[Any] | None = None,
) -> list["Layout"]:
    """`tube_layouts` with the stand-offs that a print has; arguments as of `tube_drawn`."""
    layouts = tube_layouts(thick, parameters, notes)
    return with_standoffs(layouts, thick, parameters, incoming_left)


def tube_layouts(
    thick: "ThickUnit", parameters: "HingeParameters", notes: list[Any] | None = None
) -> "list[Layout]":
    """`unit_layout.Layout` of every unit; a `Refusal` says which unit (counted from 1)."""
    if abs(thick.pitch - parameters.pitch) > 1e-9:
        raise Refusal(
            "The unit's pitch is {pitch:.6g} mm and the hinges' {hinges:.6g} mm: give both the "
            "same {FaceThickness} and {GapBetweenPlanes}.",
            parameter="FaceThickness",
            pitch=thick.pitch,
            hinges=parameters.pitch,
        )
    layouts = []
    for k, axes in enumerate(np.asarray(thick.axes).reshape(-1, *np.shape(thick.axes)[-3:])):
        try:
            layouts.append(unit_layout(axes, parameters, thick.unit.edge_length))
        except Refusal as error:
            raise Refusal(
                "Unit {unit}: {refused}",
                parameter=error.parameter,
                unit=k + 1,
                refused=error,
            ) from error
        if notes is not None:
            notes += [
                phrase("Unit {unit}: {note}", unit=k + 1, note=note) for note in layouts[-1].notes
            ]
    return layouts


def block_inset(parameters: "HingeParameters") -> float:
    """How far (mm) a block's filler ends inside both its panels: clear of a flexure's fingers."""
    if not parameters.has_knuckles:
        return BLOCK_INSET + parameters.bond_width + 2 * parameters.nozzle_diameter
    return BLOCK_INSET


def filler_between(
    cores: Sequence[Sequence[complex]], parameters: "HingeParameters", below: int
) -> list[complex]:
    """Corners x + i y of what fills the gap between two panels' ``cores`` (print plan).

    ``below``: index of the lower unit, for the `Refusal` where they have nothing in common.
    """
    filler = polygons.intersection(cores[0], cores[1], block_inset(parameters))
    if not filler:
        raise Refusal(
            "Units {unit} and {following} have no common contact panel: make {EdgeLength} larger.",
            parameter="EdgeLength",
            unit=below + 1,
            following=below + 2,
        )
    return filler


def _block(
    layouts: "Sequence[Layout]",
    places: NDArray,
    contacts: Sequence[Sequence[str]],
    k: int,
    parameters: "HingeParameters",
) -> Drawn:
    """Block between units k and k + 1: both contact panels and what fills the gap between them."""
    two = slice(k, k + 2)
    names = contacts[k][1], contacts[k + 1][0]
    plates = [layout.plates[name] for layout, name in zip(layouts[two], names, strict=True)]
    cores = [
        in_print_plan(plate.core, place) for plate, place in zip(plates, places[two], strict=True)
    ]
    filler = filler_between(cores, parameters, k)
    low = (4 * k + 4) * parameters.pitch - parameters.gap_between_planes
    draft = Draft()
    rings = [
        [draft.vertex((p.real, p.imag, z)) for p in filler]
        for z in (low, low + parameters.gap_between_planes)
    ]
    walls(draft, rings[0], rings[1])
    openings = [~edge for edge in reversed(draft.ring(rings[0]))], draft.ring(rings[1])
    for plate, place, layout, opening in zip(
        plates, places[two], layouts[two], openings, strict=True
    ):
        found = strips(layout, parameters) if not parameters.has_knuckles else None
        draft.set_frame(place)
        draw_panel(draft, plate, parameters, found, {outer_side(plate): [opening]})
    name = f"block{k + 1:02d}_{k + 2:02d}"
    members = (k, names[0]), (k + 1, names[1])
    return Drawn(name, draft.boundary(), np.eye(4), k, members, "block")


def outer_side(plate: "Plate") -> int:
    """Face of a contact panel (−1 lower, 1 upper, in its unit) that looks away from the unit."""
    return 1 if plate.height > 0 else -1


def walls(draft: Draft, lower: Sequence[int], upper: Sequence[int], *, closed: bool = True) -> None:
    """Upright faces of a prism between two rings of vertices, counter-clockwise from above.

    Not ``closed``: between two rows, that do not go on from their ends to their starts.
    """
    posts = list(zip(lower, upper, strict=True))
    for (a, c), (b, d) in itertools.pairwise([*posts, posts[0]] if closed else posts):
        draft.polygon(a, b, d, c)


def in_print_plan(points: Sequence[complex], place: NDArray) -> list[complex]:
    """Plan points (x + i z of the unit) as x + i y of the print frame, counter-clockwise."""
    flat = np.array([[p.real, 0.0, p.imag, 1.0] for p in points]) @ place.T
    moved_points = [complex(x, y) for x, y in flat[:, :2]]
    return moved_points if polygons.area(moved_points) > 0 else moved_points[::-1]
