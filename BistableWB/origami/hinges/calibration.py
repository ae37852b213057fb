# SPDX-License-Identifier: LGPL-2.1-or-later
"""The calibration plate: what a printer keeps apart, found out by one small print.

Hinges with growing clearance lie open on the bed, so nothing hangs over air and only the clearance
decides whether they turn. Beside them lie pairs of plates, the upper one on ribs with one and two
layers of air: what comes apart tells how stand-offs have to end. Numbers are engraved: hundredths
of a millimetre, and layers.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import isfinite, pi
from typing import TYPE_CHECKING, Any

import numpy as np

from ..errors import Refusal, phrase
from .bodies import Drawn, walls
from .coupons import UPRIGHT, dihedral, opened
from .drafting import Draft
from .engraving import ROWS, engrave, width_of
from .knuckles import at, draw_plate, plate_boundary
from .parameters import SEGMENT_WIDTH, HingeParameters

if TYPE_CHECKING:
    from .boundary import Boundary

AIR_LAYERS = (1, 2)
FEWEST, MOST = 5, 15  # hinges on a plate
LINE_IN_NOZZLES = 1.125  # usual width of one line of plastic
RIB_SPACING = 8.0
_APART = 4.0  # mm between the parts of the plate
_ROW = 4  # hinges in a row
_SQUARE = 1.2  # mm of a square of the engraved digits
_PAIR, _GRIP = 30.0, 7.0  # mm: the upper plate of a pair, what the lower one is longer
_RIM = 0.5  # mm from the edge of a plate to the ribs' rim


@dataclass(frozen=True)
class Series:
    """The clearances of a plate's hinges, mm: ``count`` from ``least`` on, ``step`` apart."""

    least: float = 0.2
    step: float = 0.05
    count: int = 7

    @property
    def clearances(self) -> list:
        """Clearance of every hinge, mm."""
        return [round(self.least + k * self.step, 6) for k in range(self.count)]

    def check(self) -> None:
        """`Refusal` where these make no series that can be engraved."""
        if not FEWEST <= self.count <= MOST:
            raise Refusal(
                "{Count} is {count}: set it between {fewest} and {most} hinges.",
                parameter="Count",
                count=self.count,
                fewest=FEWEST,
                most=MOST,
            )
        if not (isfinite(self.step) and self.step >= 0.01):
            raise Refusal(
                "{Step} is {step:.4g} mm: set it to 0.01 mm or more, the numbers are hundredths.",
                parameter="Step",
                step=self.step,
            )
        if not (isfinite(self.least) and self.least > 0):
            raise Refusal(
                "{Least} is {least:.4g} mm: set it to a clearance above 0.",
                parameter="Least",
                least=self.least,
            )


def number_of(clearance: float) -> str:
    """What is engraved on the hinge of a clearance (mm): hundredths of a millimetre."""
    return f"{round(100 * clearance):d}"


def plate_drawn(
    parameters: HingeParameters, series: Series, notes: list[Any] | None = None
) -> tuple[list[Drawn], list[float]]:
    """(`Drawn` bodies of a calibration plate on the bed, the clearances that are on it).

    ``parameters``: of the hinges, all but their gap length; ``notes``: a list that takes remarks.
    Clearances that these parameters cannot have are left out, with a remark; `Refusal` where
    fewer than `FEWEST` are left. Pairs of plates are as far apart as panels, or as ribs need.
    """
    series.check()
    if not parameters.has_knuckles:
        raise Refusal(
            "{HingeType} is Flexible: strips have no clearance to find, set {HingeType} to "
            "Rotational.",
            parameter="HingeType",
        )
    made: dict = {}
    refused = None
    for clearance in series.clearances:
        one = replace(parameters, gap_length=clearance, rotation_angle=0.0)
        try:
            one.check()
            made[clearance] = _hinge(one, clearance, len(made))
        except Refusal as error:
            refused = error
            if notes is not None:
                notes.append(
                    phrase(
                        "Left out, clearance {clearance:.2f} mm: {refused}",
                        clearance=clearance,
                        refused=error,
                    )
                )
    if len(made) < FEWEST and refused is not None:
        raise refused
    pairs = [_pair(parameters, layers, len(made) + layers) for layers in AIR_LAYERS]
    return _laid_out([*made.values(), *pairs]), list(made)


def _hinge(parameters: HingeParameters, clearance: float, unit: int) -> list[Drawn]:
    """Two plates in a row on the bed, with their hinge between them."""
    length = 4 * SEGMENT_WIDTH
    depth = parameters.radius + parameters.cut_back + (ROWS + 3) * _SQUARE
    layout = dihedral(parameters, length, depth)
    turn = opened(layout.hinges["crease"], pi)
    lower, upper = (layout.plates[f"plate_{side}"] for side in ("lower", "upper"))
    draft, text = Draft(), number_of(clearance)
    left, low = (length - width_of(text, _SQUARE)) / 2, depth - 1.5 * _SQUARE
    face = lower.height + parameters.face_thickness / 2
    sunk = depth_of(parameters)

    def place(u: float, v: float, below: int) -> tuple[float, ...]:
        return at(complex(left + u, low - v), face - below * sunk)

    draw_plate(draft, lower, parameters, {1: engrave(draft, text, _SQUARE, place)})
    name = f"hinge_{round(100 * clearance):03d}"
    return [
        Drawn(f"{name}_lower", draft.boundary(), UPRIGHT, unit, ((unit, "lower"),), "contact"),
        Drawn(
            f"{name}_upper", plate_boundary(upper, parameters), UPRIGHT @ turn, unit,
            ((unit, "upper"),), "border",
        ),
    ]  # fmt: skip


def depth_of(parameters: HingeParameters) -> float:
    """How deep numbers are engraved, mm: whole layers, about a third of a panel."""
    layer = parameters.layer_height
    return max(int(parameters.face_thickness / 3 / layer + 1e-9), 1) * layer


def _pair(parameters: HingeParameters, layers: int, unit: int) -> list[Drawn]:
    """A plate with ribs, and one that hovers over them by some ``layers`` of air."""
    t, layer = parameters.face_thickness, parameters.layer_height
    gap = max(parameters.gap_between_planes, (AIR_LAYERS[-1] + 1) * layer)
    rib = gap - layers * layer
    name, members = f"pair_{layers}", ((unit, "lower"), (unit, "upper"))
    here, lower = np.eye(4), _ribbed(t, rib, LINE_IN_NOZZLES * parameters.nozzle_diameter)
    upper = _numbered(t + gap, t, str(layers), depth_of(parameters))
    return [
        Drawn(f"{name}_lower", lower, here, unit, members[:1], "primary"),
        Drawn(f"{name}_upper", upper, here, unit, members[1:], "secondary"),
    ]


def _rectangle(low: Sequence[float], high: Sequence[float]) -> list[tuple[float, float]]:
    """Corners (x, y), anticlockwise."""
    return [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]


def _ribbed(thickness: float, rib: float, line: float) -> "Boundary":
    """A plate with a rim and ribs both ways on it, as stand-offs are, and a grip beside them."""
    draft, base = Draft(), _rectangle((0.0, -_GRIP), (_PAIR, _PAIR))
    rings = [[draft.vertex((x, y, z)) for x, y in base] for z in (0.0, thickness)]
    walls(draft, *rings)
    draft.polygon(*reversed(rings[0]))
    lines = _rib_lines(line)
    last = len(lines) - 1
    top = [[draft.vertex((x, y, thickness + rib)) for y in lines] for x in lines]
    foot = {(i, j): draft.vertex((lines[i], lines[j], thickness)) for i in (0, last)
            for j in (0, last)}  # fmt: skip
    round_it = [(0, 0), (last, 0), (last, last), (0, last)]
    draft.plane(
        draft.ring(rings[1]),
        [~edge for edge in reversed(draft.ring([foot[corner] for corner in round_it]))],
    )
    for (i, j), (k, m) in zip(round_it, round_it[1:] + round_it[:1], strict=True):
        steps = range(last, -1, -1)
        along = [top[i + (k - i) * n // last][j + (m - j) * n // last] for n in steps]
        draft.polygon(foot[i, j], foot[k, m], *along)
    for i in range(last):
        for j in range(last):
            ring = [top[i][j], top[i + 1][j], top[i + 1][j + 1], top[i][j + 1]]
            if i % 2 and j % 2:
                _cell(draft, ring, [(lines[i + a], lines[j + b], thickness) for a, b in _AROUND])
            else:
                draft.polygon(*ring)
    return draft.boundary()


_AROUND = ((0, 0), (1, 0), (1, 1), (0, 1))


def _rib_lines(line: float) -> list[float]:
    """Where the sides of ribs lie, mm: rim, cell, rib, cell, … rim, the same both ways."""
    span = _PAIR - 2 * _RIM
    count = round(span / RIB_SPACING)
    cell = (span - (count + 1) * line) / count
    return [_RIM + k * (cell + line) + side for k in range(count + 1) for side in (0.0, line)]


def _cell(draft: Draft, top: Sequence[int], floor: Sequence[Sequence[float]]) -> None:
    """The room between ribs: walls down from a ``top`` ring of vertices, and its floor."""
    low = [draft.vertex(point) for point in floor]
    for a, b, c, d in zip(low, top, [*top[1:], top[0]], [*low[1:], low[0]], strict=True):
        draft.polygon(a, b, c, d)
    draft.polygon(*low)


def _numbered(low: float, thickness: float, text: str, depth: float) -> "Boundary":
    """A plate from a height on, with a number in its upper face."""
    draft, high, square = Draft(), low + thickness, 2 * _SQUARE
    corners = _rectangle((0.0, 0.0), (_PAIR, _PAIR))
    rings = [[draft.vertex((x, y, z)) for x, y in corners] for z in (low, high)]
    walls(draft, *rings)
    draft.polygon(*reversed(rings[0]))
    left, below = (_PAIR - width_of(text, square)) / 2, (_PAIR - ROWS * square) / 2
    rims = engrave(
        draft, text, square, lambda u, v, sunk: (left + u, below + v, high - sunk * depth)
    )
    draft.plane(draft.ring(rings[1]), *rims)
    return draft.boundary()


def _laid_out(parts: Sequence[Sequence[Drawn]]) -> list[Drawn]:
    """`Drawn` bodies of all ``parts`` in rows from the corner of the bed on, `_APART`."""
    placed, corner, row_end = [], np.zeros(3), 0.0
    pairs = len(AIR_LAYERS)
    for k, part in enumerate(parts):
        if k and (k % _ROW == 0 if k < len(parts) - pairs else k == len(parts) - pairs):
            corner = np.array([0.0, row_end + _APART, 0.0])
        bounds = np.array([body.boundary.bounds(body.place) for body in part])
        move = np.eye(4)
        move[:3, 3] = corner - bounds[:, 0].min(0)
        size = np.ptp(np.concatenate(bounds), axis=0)
        placed += [body._replace(place=move @ body.place) for body in part]
        row_end = max(row_end, corner[1] + size[1])
        corner[0] += size[0] + _APART
    return placed
