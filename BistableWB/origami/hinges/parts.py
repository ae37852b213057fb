# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tube, or some of its units, as one print: bodies, and what its two ends are.

An end is cut from the rest of the tube, or meets the tube's other end when it is deployed (closed
tubes): there half a contact block with a joint (`joints`). Or it is an end of an open tube and has
an end part (`ends`).
"""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..errors import phrase
from ..progress import NOBODY
from ..thick import print_stack
from ..units.creases import BODIES, INDEX, PANELS
from . import polygons
from .bodies import (
    Drawn,
    block_inset,
    filler_between,
    in_print_plan,
    printed_layouts,
    tube_drawn,
    tube_layouts,
)
from .ends import END_PARTS, PLAIN, EndPanel, Ends, end_height, joint_height, plate_plan
from .feet import Flange, foot_for
from .joints import features

if TYPE_CHECKING:
    from ..progress import Progress
    from ..thick.linkage import ThickUnit
    from .boundary import Boundary
    from .parameters import HingeParameters


BESIDE = 5.0  # mm between the stack and a foot that is printed beside it


class Part(NamedTuple):
    """The `bodies.Drawn` list of a print on the bed, and how much higher it lies than its units.

    ``lift`` (mm): what `print_stack.frames` and `print_stack.motions` know nothing of.
    """

    bodies: list
    lift: float


class _End(NamedTuple):
    """One end of a print: ``unit`` of the tube; ``below``, ``above``: units that meet there."""

    unit: int
    upwards: bool
    pair: tuple | None
    kind: str


def part_drawn(
    thick: "ThickUnit",
    parameters: "HingeParameters",
    first: int,
    last: int,
    incoming_left: NDArray | None = None,
    progress: "Progress" = NOBODY,
    ends: Ends | None = None,
    closed: bool = False,
    notes: list | None = None,
    deployed: NDArray | None = None,
) -> Part:
    """`Part` of units ``first`` … ``last`` of a tube, counted from 0.

    Arguments as for `bodies.tube_drawn`; ``ends``: `Ends`; ``closed``: the tube's last block is its
    first; ``deployed``: motions (units, 15, 4, 4) of the part from flat to deployed, for feet.
    `bed.split` tells how a bed splits a tube. Names and units count from the part's first unit.
    """
    ends = ends or Ends()
    count = len(thick)
    left = print_stack.alternating(count) if incoming_left is None else np.asarray(incoming_left)
    part, own = thick[first : last + 1], left[first : last + 1]
    bodies = tube_drawn(part, parameters, own, progress, notes)
    layouts = printed_layouts(part, parameters, own)
    here = print_stack.frames(part, own)
    lift, flanges = 0.0, []
    for end in _ends(first, last, count, ends, closed):
        k, height = end.unit - first, 0.0
        name = print_stack.contact_names(left[end.unit])[end.upwards]
        index = next(i for i, body in enumerate(bodies) if (k, name) in body.members)
        body = bodies[index]
        panel = EndPanel(layouts[k], name, here[k], parameters, end.upwards)
        if end.pair is not None:
            corners, move = _joint_plan(thick, left, end, here[k], parameters)
            drawn = panel.half_block(corners, features(ends.joint, corners, parameters), move)
            half = body._replace(name=f"half_{body.name}", kind="joint")
            bodies[index] = half._replace(boundary=drawn, place=np.eye(4))
            height = joint_height(parameters)
        elif end.kind != PLAIN:
            drawn, flange = _plated(panel, thick, end, name, ends)
            if END_PARTS[end.kind].stands and deployed is not None:
                flange = flange._replace(motion=deployed[k, BODIES.index(name)])
                flanges.append(((k, name), end.upwards, flange))
            bodies[index] = body._replace(boundary=drawn, place=np.eye(4), kind="foot")
            height = end_height(end.kind, ends, parameters)
        lift = lift if end.upwards else height
    up = np.eye(4)
    up[2, 3] = lift
    bodies = [body._replace(place=up @ body.place) for body in bodies]
    for member, upwards, outer in flanges:
        bodies.append(_foot(outer, member, upwards, bodies, up, ends, parameters))
    return Part(bodies, lift)


def _foot(
    flange: Flange,
    member: tuple[int, str],
    upwards: bool,
    bodies: list,
    up: NDArray,
    ends: Ends,
    parameters: "HingeParameters",
) -> Drawn:
    """The foot of an end, on its sole beside all ``bodies``, which ``up`` (4, 4) has lifted."""
    end = phrase("end") if upwards else phrase("start")
    least = ends.plate_thickness(parameters)
    foot = foot_for(flange, ends.ground, ends.joint.screw_diameter, least, end)
    bounds = np.array([body.boundary.bounds(body.place) for body in bodies])
    low, high = bounds[:, 0].min(0), bounds[:, 1].max(0)
    own = foot.boundary.bounds(np.eye(4))
    place = np.eye(4)
    place[:2, 3] = high[0] + BESIDE - own[0, 0], (low[1] + high[1]) / 2 - own[:, 1].mean()
    onto = up @ foot.seat @ rigid.inverse(place)
    name = "end_foot" if upwards else "start_foot"
    return Drawn(name, foot.boundary, place, member[0], (), "foot", (*member, onto))


def _ends(first: int, last: int, count: int, ends: Ends, closed: bool) -> list[_End]:
    """The two `_End`s of units ``first`` … ``last``."""
    joins = [first > 0 or closed, last < count - 1 or closed]
    pairs = ((first - 1) % count, first), (last, (last + 1) % count)
    kinds = ends.start, ends.end
    return [
        _End(unit, upwards, pair if joined else None, kind)
        for unit, upwards, pair, joined, kind in zip(
            (first, last), (False, True), pairs, joins, kinds, strict=True
        )
    ]


def _joint_plan(
    thick: "ThickUnit", left: NDArray, end: _End, here: NDArray, parameters: "HingeParameters"
) -> tuple[Any, NDArray]:
    """Corners of the filler between the two units that meet, and the motion into this print."""
    pair = np.array(end.pair, int)
    units, sides = thick[pair], np.asarray(left)[pair]
    layouts, places = tube_layouts(units, parameters), print_stack.frames(units, sides)
    names = print_stack.contact_names(sides[0])[1], print_stack.contact_names(sides[1])[0]
    cores = [
        in_print_plan(layout.plates[name].core, place)
        for layout, name, place in zip(layouts, names, places, strict=True)
    ]
    corners = filler_between(cores, parameters, int(pair[0]))
    return corners, here @ np.linalg.inv(places[0 if end.upwards else 1])


def _plated(
    panel: EndPanel, thick: "ThickUnit", end: _End, name: str, ends: Ends
) -> "tuple[Boundary, Flange]":
    """Boundary of an end panel with its plate or flange, and that flange."""
    parameters = panel.parameters
    corners = thick.unit.flat.reshape(-1, *thick.unit.flat.shape[-2:])[end.unit]
    quad = in_print_plan(
        [complex(*p[[0, 2]]) for p in corners[[INDEX[vertex] for vertex in PANELS[name]]]],
        panel.place,
    )
    core = in_print_plan(panel.plate.core, panel.place)
    filler = polygons.intersection(core, core, inset=block_inset(parameters))
    outline, holes = plate_plan(quad, ends.joint, end.kind, parameters)
    thickness, way = ends.plate_thickness(parameters), 1.0 if end.upwards else -1.0
    level = panel.face + way * (parameters.gap_between_planes + thickness)
    flange = Flange(outline, [centre for centre, _ in holes], level, way, np.eye(4))
    return panel.with_plate(filler, outline, holes, thickness), flange
