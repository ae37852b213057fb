# SPDX-License-Identifier: LGPL-2.1-or-later
"""What no tube may leave the mathematics without: finite, isometric, and joined unit to unit.

Nothing here knows how a tube was made: its corners are measured in both states.
"""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from .creases import INDEX, PANELS

if TYPE_CHECKING:
    from .tube import Tube

ISOMETRY = 1e-9  # relative change of a panel's edges between flat and deployed
_FAR = 1e9  # mm: further away is no tube
JOIN = 1e-9  # in ‖AB‖: how far contact panels that two units share may miss each other
_BLOCK = 5  # pitches that the block between two thick contact panels sets them apart, at most
_TURNED = [1, 0, 3, 2]  # what is A to a unit is B to its neighbour


def certified(tube: "Tube", edge_length: float, pitch: float, leaves_open: bool = False) -> "Tube":
    """``tube`` itself, where it is what a tube is (docs/theory/geometry.md 2); else a `Refusal`.

    ``edge_length``, ``pitch``: mm; ``leaves_open``: its ratio rule does not close on a sphere,
    which is shown as its residual (the paper's 1/2), so isometry is not asked for.
    """
    deployed = tube.deployed()
    finite = (np.abs([deployed, tube.unit.flat]) <= _FAR).all((0, 2, 3))
    if not finite.all():
        raise Refusal(
            "Unit {unit} cannot be computed: some of its corners are nowhere",
            cure="make {EdgeLength} shorter or {Gamma} smaller",
            parameter="EdgeLength",
            unit=int(np.argmin(finite)) + 1,
        )
    changes = np.broadcast_to(tube.unit.isometry_error(), len(tube))
    if not leaves_open and changes.max() > ISOMETRY:
        raise Refusal(
            "Unit {unit} cannot be computed exactly enough: between flat and deployed its panels "
            "change by {change:.1g} of their size",
            cure="keep {Gamma} further away from 90°",
            parameter="Gamma",
            unit=int(np.argmax(changes)) + 1,
            change=float(changes.max()),
        )
    gaps = shared_panel_gaps(tube, deployed)
    apart = gaps > JOIN * edge_length + _BLOCK * pitch
    if apart.any():
        first = int(np.argmax(apart))
        raise Refusal(
            "Units {unit} and {after} do not join: their contact panels are {gap:.3g} mm apart, as "
            "the curve turns back on itself there",
            cure="make {EdgeLength} shorter or the curve smoother",
            parameter="EdgeLength",
            unit=first + 1,
            after=first + 2,
            gap=float(gaps[first]),
        )
    return tube


def shared_panel_gaps(tube: "Tube", deployed: NDArray) -> NDArray:
    """Distance (n − 1,) of corners of contact panels that neighbours share, mm, at most.

    ``deployed``: vertices (n, 10, 3) in space.
    """
    left, right = (
        deployed[:, [INDEX[corner] for corner in PANELS[f"contact_{side}"]]]
        for side in ("left", "right")
    )
    is_left = tube.incoming_left[:, None, None]
    before, after = np.where(is_left, left, right), np.where(is_left, right, left)
    return np.linalg.norm(after[:-1] - before[1:][:, _TURNED], axis=-1).max(-1, initial=0.0)
