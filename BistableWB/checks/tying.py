# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether ties hold all that begins in mid-air on edge, and come off again. On the meshes' layers.

What ties are meant to be (`origami.hinges.ties`) is not asked: only what their meshes are.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..origami.errors import ERROR, NOTE, WARNING, Finding, phrase
from ..origami.hinges.edge_turn import LEFT
from ..origami.hinges.starts import Start, starts_of
from ..origami.layers import PIXEL, Layers, layers
from ..origami.meshes import Mesh, joined

if TYPE_CHECKING:
    from ..origami.meshes import PlacedMesh

NECK_LIMIT = 1.75  # times the nozzle's square that the thinnest section of a tie may have
_Box = tuple[np.ndarray, np.ndarray]


def check_ties(
    bodies: Sequence["PlacedMesh"], ties: Sequence[Mesh], layer_height: float, nozzle: float
) -> list[Finding]:
    """Findings on ``bodies`` as they stand on the bed and the meshes of their ``ties``."""
    boxes = np.array([tie.bounds for tie in ties]).reshape(-1, 2, 3)
    lost: list[tuple[float, str, tuple]] = []
    met: list[dict[str, int]] = [{} for _ in ties]
    made = [layers(tie, layer_height) for tie in ties]
    covered = [np.zeros(one.inside.shape, bool) for one in made]
    count = 0
    for body in bodies:
        own = layers(body.placed, layer_height)
        near = _near(boxes, body.placed.bounds)
        support = layers(joined([ties[k] for k in near]), layer_height) if len(near) else None
        count += len(starts_of(0, own))
        for start in starts_of(0, own, support):
            lost.append((start.area, body.name, _point(start, layer_height)))
        for k in near:
            here = own.window(made[k].first, made[k].end) & made[k].inside
            if here.any():
                met[k][body.name] = int(here.sum())
                covered[k] |= here
    units = len({body.unit for body in bodies})
    return [
        *_left(lost, units, count, len(ties)),
        *_fused(ties, met, made, covered, nozzle),
    ]


def _near(boxes: np.ndarray, bounds: np.ndarray) -> np.ndarray:
    """Numbers of the boxes (n, 2, 3) that meet ``bounds`` (2, 3)."""
    return np.flatnonzero(((boxes[:, 0] < bounds[1]) & (boxes[:, 1] > bounds[0])).all(1))


def _point(start: Start, layer_height: float) -> tuple:
    row, column = start.pixels.mean(0) + 0.5
    return float(column * PIXEL), float(row * PIXEL), float(start.layer * layer_height)


def _left(lost: list, units: int, count: int, ties: int) -> list[Finding]:
    area, limit = sum(entry[0] for entry in lost), LEFT * units
    if area <= limit:
        text = phrase(
            "{count} places begin in mid-air; {ties} ties hold them, and {area:.2f} mm² are left.",
            count=count,
            ties=ties,
            area=area,
        )
        return [Finding(severity=NOTE, code="start", number=area, limit=limit, message=text)]
    worst = max(lost)
    return [
        Finding(
            severity=WARNING,
            code="start",
            bodies=(worst[1],),
            number=area,
            limit=limit,
            message=phrase(
                "{area:.1f} mm² in {places} places begin in mid-air and no tie holds them, the "
                "largest {worst:.2f} mm² of {body} at a height of {height:.1f} mm.",
                area=area,
                places=len(lost),
                worst=worst[0],
                body=worst[1],
                height=worst[2][2],
            ),
            cure=phrase("set {Process} to FDM, ties, or let the slicer add support there").setting(
                Process="FDM, ties"
            ),
            points=tuple(entry[2] for entry in sorted(lost, reverse=True)[:20]),
        )
    ]


def _fused(
    ties: Sequence[Mesh],
    met: Sequence[dict[str, int]],
    made: Sequence[Layers],
    covered: Sequence[np.ndarray],
    nozzle: float,
) -> list[Finding]:
    """Ties that join more than two bodies, or that are too thick to be cut between them."""
    limit, found = NECK_LIMIT * nozzle**2, []
    for k, tie in enumerate(ties):
        names = sorted(met[k], key=lambda name: -met[k][name])
        free = (made[k].inside & ~covered[k]).sum((1, 2)) * PIXEL**2
        thinnest = float(free[free > 0].min(initial=np.inf))
        if len(names) > 2:
            what = phrase("a tie joins {count} of them", count=len(names))
        elif len(names) == 2 and not limit >= thinnest:
            what = phrase(
                "a tie joins them by {area:.2f} mm², more than the {limit:.2f} mm² that come off",
                area=thinnest if np.isfinite(thinnest) else 0.0,
                limit=limit,
            )
        else:
            continue
        found.append((names, what, tuple(tie.vertices.mean(0).tolist()), thinnest))
    if not found:
        return []
    names, what, _, thinnest = found[0]
    return [
        Finding(
            severity=ERROR,
            code="tie",
            bodies=tuple(names[:2]),
            number=thinnest if np.isfinite(thinnest) else 0.0,
            limit=limit,
            message=phrase(
                "{one} and {other} stay fused: {what} ({count} such ties).",
                one=names[0],
                other=names[1],
                what=what,
                count=len(found),
            ),
            cure=phrase("make {GapBetweenPlanes} and {GapLength} larger"),
            points=tuple(entry[2] for entry in found[:20]),
        )
    ]
