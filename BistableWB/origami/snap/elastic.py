# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elastic units: from layout and material to energy, torque and forces on the way (hinges.md 4)."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..thick.closure import FIRST, SECOND
from ..units.creases import BODIES, CREASES, INDEX
from . import knuckles, panels
from .minimum import ElasticUnit

if TYPE_CHECKING:
    from ..hinges.parameters import HingeParameters
    from ..hinges.unit_layout import Layout, Plate, Tab
    from ..thick.linkage import ThickUnit
    from .contact import Contacts
    from .materials import Material

MODES = 10  # of a panel: what is left of its give counts at the knuckle
HERTZ = 1e3  # N/mm: between two solid bodies that touch at a cone
_JOINED = "contact_left", "contact_right"


@dataclass(frozen=True)
class Options:
    """How finely panels are condensed; the defaults are what results are made with.

    ``count`` modes of a panel, of polynomials of a ``degree``; ``rigid_knuckles``: only panels give
    way; ``hertz``: what a contact between solid bodies gives way by, N/mm.
    """

    count: int = MODES
    degree: int = panels.DEGREE
    rigid_knuckles: bool = False
    hertz: float = HERTZ


def elastic_unit(
    thick: "ThickUnit",
    layout: "Layout",
    found: "Contacts",
    parameters: "HingeParameters",
    material: "Material",
    joined: Sequence[bool] = (False, False),
    options: Options = Options(),
) -> ElasticUnit:
    """`ElasticUnit` of one compensated unit.

    ``thick``: `ThickUnit` of one unit; ``layout``: its `unit_layout.Layout`; ``found``: its
    `contact.Contacts` (a batch of one), one place a cone; ``material``: `materials.Material`;
    ``joined``: whether the left and the right contact panel is half of a block.
    """
    shape = found.valid[0].shape
    modes = [np.zeros((*shape, 3, options.count)) for _ in range(2)]
    give = [np.tile(np.eye(3) / (2 * options.hertz), (*shape, 1, 1)) for _ in range(2)]
    block = panels.in_block(parameters.face_thickness, parameters.gap_between_planes)
    for body, name in enumerate(BODIES):
        plate = layout.plates.get(name)
        if plate is None:
            continue
        places, tabs = _places(body, layout, plate, found)
        stiffening = block if name in _JOINED and joined[_JOINED.index(name)] else (1.0, 1.0)
        soft, local = _condensed(
            plate, found, places, tabs, parameters, material, stiffening, options
        )
        for k, (side, hinge, place, _) in enumerate(places):
            modes[side][hinge, place, :, : soft.shape[1]] = soft[3 * k : 3 * k + 3]
            give[side][hinge, place] += local[k]
    shared = _shared(found)
    give = [each * shared for each in give]
    return as_unit(thick, found, tuple(modes), tuple(give))


def bare_unit(thick: "ThickUnit", found: "Contacts", hertz: float = HERTZ) -> ElasticUnit:
    """`ElasticUnit` whose panels and knuckles are rigid: only cones give, by ``hertz``, N/mm."""
    shape = found.valid[0].shape
    modes = np.zeros((*shape, 3, 0))
    give = np.tile(np.eye(3) / (2 * hertz), (*shape, 1, 1)) * _shared(found)
    return as_unit(thick, found, (modes, modes), (give, give))


def as_unit(thick: "ThickUnit", found: "Contacts", modes: Any, give: Any) -> ElasticUnit:
    """`ElasticUnit` of contacts, a batch of one, and of what both their bodies give way by."""
    flat = thick.unit.flat.reshape(-1, 10, 3)[0]
    leg = flat[INDEX["B_upper"]] - flat[INDEX["B_lower"]]
    return ElasticUnit(
        found.points[0], found.axes[0], found.slope[0], found.lean[0], found.valid[0], found.gap,
        modes, give, leg / np.linalg.norm(leg), float(thick._closure.turn[0]), thick.scale,
    )  # fmt: skip


def tabs_of(
    layout: "Layout", found: "Contacts", parameters: "HingeParameters"
) -> dict[tuple[int, ...], tuple[knuckles.Tab, int, list[int]]]:
    """Tabs that bear contacts: {(side, hinge, index): (`knuckles.Tab`, knuckle, its places)}.

    ``side`` 0, 1: of the hinge's first or second body; ``knuckle``: its segment, from 0.
    """
    tabs: dict[Any, Any] = {}
    for body, name in enumerate(BODIES):
        plate = layout.plates.get(name)
        if plate is None:
            continue
        places, own = _places(body, layout, plate, found)
        for side, hinge, place, k in places:
            if (side, hinge, k) not in tabs:
                tab = knuckles.tab_of(own[k], plate.height, parameters.face_thickness)
                tabs[side, hinge, k] = (tab, own[k].index, [])
            tabs[side, hinge, k][2].append(place)
    return tabs


def _shared(found: "Contacts") -> NDArray:
    """How many places share the knuckles of each: they give way together, each by its part."""
    cones, valid = found.cones[0], found.valid[0]
    same = (cones[:, :, None] == cones[:, None]) & valid[:, None]
    return np.maximum(same.sum(-1), 1)[..., None, None]


def _places(body: int, layout: "Layout", plate: "Plate", found: "Contacts") -> "Any":
    """Contacts of a plate: [(side, hinge, place, index of its tab)], and the tabs."""
    tabs, places = list(plate.tabs), []
    for side, bodies in enumerate((FIRST, SECOND)):
        for hinge in np.flatnonzero(bodies == body):
            name = CREASES[hinge].name
            own = [k for k, tab in enumerate(tabs) if tab.hinge.name == name]
            axis = layout.hinges[name]
            for place in np.flatnonzero(found.valid[0, hinge]):
                x, _, z = found.points[0, hinge, place]
                along = (complex(x, z) - axis.origin) * axis.direction.conjugate()
                off = [_outside(tabs[k], along.real) for k in own]
                places.append((side, hinge, place, own[int(np.argmin(off))]))
    return places, tabs


def _outside(tab: "Tab", along: float) -> float:
    start, end = tab.hinge.segments[tab.index]
    return max(start - along, along - end)


def _condensed(
    plate: "Plate",
    found: "Contacts",
    places: Sequence[Any],
    tabs: "Sequence[Tab]",
    parameters: "HingeParameters",
    material: "Material",
    stiffening: Any,
    options: Options,
) -> tuple[NDArray, NDArray]:
    """Modes (3n, count) of a plate at its n contacts, and what is left there (n, 3, 3), mm/N."""
    t = parameters.face_thickness
    core = np.array([[p.real, p.imag] for p in plate.core])
    roots = np.array([[[tab.corner(k).real, tab.corner(k).imag] for k in (0, 1)] for tab in tabs])
    shape = panels.Plate(core, t, roots, stiffening)
    at_roots = panels.compliance(shape, material.poisson, options.degree) / material.young
    arms = [knuckles.tab_of(tab, plate.height, t) for tab in tabs]
    reach = np.zeros((3 * len(places), len(at_roots)))
    local = np.zeros((len(places), 3, 3))
    for k, (_, hinge, place, tab) in enumerate(places):
        point, own = found.points[0, hinge, place], arms[tab]
        reach[3 * k : 3 * k + 3, 6 * tab : 6 * tab + 6] = np.hstack(
            [np.eye(3), -rigid.skew(point - own.root)]
        )
        if not options.rigid_knuckles:
            local[k] = knuckles.compliance(own, point, material.poisson) / material.young
    whole = reach @ at_roots @ reach.T
    soft = panels.modes(whole, options.count)
    left = (whole - soft @ soft.T).reshape(len(places), 3, len(places), 3)
    each = np.arange(len(places))
    return soft, local + left[each, :, each]
