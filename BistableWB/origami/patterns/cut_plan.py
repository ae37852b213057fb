# SPDX-License-Identifier: LGPL-2.1-or-later
"""The plan of a tube of cut panels: pieces on sheets, hinges to buy, and what it will be like.

    plan = cut_plan("Pergola", design, CutWishes(panel_thickness=18, hinge="Piano"))
    plan.sheets, plan.pieces, plan.hinges, plan.utilisation

Nothing here has play, so there is no snap margin: no number of clearances would let rigid panels
pass. What the panels and hinges must give on the way is their misfit (`CutPlan.misfit`).
"""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..design import Placing, Thickness, TubeDesign
from ..errors import Refusal
from ..hinges import polygons
from ..thick.thick_tube import ThickTube
from .cut_panels import CutHinge, Piece, pieces_of
from .nesting import Placed, TooLarge, nested, stock_size
from .panel_hinges import PANEL_HINGES, PanelHinge
from .sheets import CUT, SHEET, Circle, Line, Sheet, Text, fitted

DRILL, BELOW = "drill", "below"
MARGIN, SPACING = 15.0, 8.0  # mm: kept free along a sheet's edges, and between pieces
_LARGEST_TEXT, _TITLE = 24.0, 10.0  # mm
_STEPS = 20


@dataclass(frozen=True)
class CutWishes:
    """How a tube is cut, mm: ``panel_thickness``; ``hinge``: of `PANEL_HINGES`; ``stock``: sheets.

    ``kerf``: of the cutter: paths run half of it outside the pieces; ``edge_gap``: by how much
    panels end before their hinge axes.
    """

    panel_thickness: float = 18.0
    hinge: str = "Piano"
    stock: Any = "2500x1250"
    kerf: float = 0.0
    edge_gap: float = 0.5

    def __post_init__(self) -> None:
        if self.hinge not in PANEL_HINGES:
            raise Refusal(
                "Hinge {hinge!r} is unknown: choose one of {names}.",
                hinge=self.hinge,
                names=", ".join(PANEL_HINGES),
            )
        for what, value, least in (
            ("panel_thickness", self.panel_thickness, 0.1),
            ("kerf", self.kerf, 0.0),
            ("edge_gap", self.edge_gap, 0.0),
        ):
            if not least <= value <= 1000:
                raise Refusal(
                    "{what} is {value:.6g} mm: set it from {least:g} to 1000.",
                    what=what, value=value, least=least,
                )  # fmt: skip

    @property
    def panel_hinge(self) -> PanelHinge:
        """The entry of its hinge."""
        return PANEL_HINGES[self.hinge]


@dataclass(frozen=True)
class CutPlan:
    """Everything to cut and to buy for one tube; ``placed``: where each of ``pieces`` lies."""

    name: str
    tube: ThickTube
    wishes: CutWishes
    pieces: list[Piece]
    hinges: list[CutHinge]
    placed: list[Placed]

    @property
    def stock(self) -> tuple[float, float]:
        """Size (mm) of a sheet."""
        return stock_size(self.wishes.stock)

    @property
    def sheet_count(self) -> int:
        """Number of sheets."""
        return 1 + max(place.sheet for place in self.placed)

    @property
    def utilisation(self) -> float:
        """Share of the sheets' area that the pieces take."""
        area = sum(piece.area for piece in self.pieces)
        return area / (self.sheet_count * self.stock[0] * self.stock[1])

    @cached_property
    def misfit(self) -> float:
        """Largest misfit (mm) of any hinge on the way: what panels and hinges must give."""
        steps = np.linspace(0, 1, _STEPS + 1)
        return float(self.tube.thick.misfit(steps).max())

    @property
    def sheets(self) -> list[Sheet]:
        """`Sheet` list to write: cuts, holes, labels."""
        return [self._sheet(number) for number in range(self.sheet_count)]

    def _sheet(self, number: int) -> Sheet:
        width, height = self.stock
        corners = np.array([0, width, complex(width, height), 1j * height])
        lines, texts = [Line(SHEET, corners, True)], []
        circles: list[Circle] = []
        for place in self.placed:
            if place.sheet != number:
                continue
            piece = self.pieces[place.piece]
            lines.append(Line(CUT, carried(self.path(piece), place), True))
            laid = carried(np.array(piece.outline), place)
            middle = np.roll(laid, -1) - laid
            along = middle[np.abs(middle).argmax()]
            along *= np.sign(along.real) or np.sign(along.imag)
            texts.append(fitted(piece.label, laid, along / abs(along), _LARGEST_TEXT))
            radius = self.wishes.panel_hinge.hole / 2
            circles += [
                Circle(DRILL if seen else BELOW, complex(carried(np.array([p]), place)[0]), radius)
                for p, seen in piece.holes
            ]
        title = f"{self.name}  {number + 1}/{self.sheet_count}  {self.wishes.panel_thickness:g} mm"
        texts.append(Text(SHEET, title, complex(MARGIN, MARGIN / 2), 0.0, _TITLE / 2, "start"))
        return Sheet(self.stock, lines, texts, [], circles)

    def path(self, piece: Piece) -> NDArray:
        """What the cutter follows round a piece: half the kerf outside it."""
        corners = list(piece.outline)
        if self.wishes.kerf:
            corners = polygons.intersection(corners, corners, inset=-self.wishes.kerf / 2)
        return np.array(corners)


def carried(points: NDArray, place: Placed) -> NDArray:
    """A piece's points where it lies on its sheet."""
    return points * place.turn + place.shift


def cut_plan(name: str, design: TubeDesign, wishes: CutWishes) -> CutPlan:
    """`CutPlan` of a tube, whatever thickness its design has.

    `Refusal` for a panel that is larger than a sheet, or too small for its hinges.
    """
    hinge = wishes.panel_hinge
    thickness = Thickness(wishes.panel_thickness, hinge.gap)
    where = design.where
    if isinstance(where, Placing):
        where = replace(where, pitch=thickness.pitch)
    tube = replace(design, where=where, thickness=thickness).thick()
    pieces, hinges = pieces_of(tube.thick, hinge, wishes.edge_gap)
    outlines = [np.array(piece.outline) for piece in pieces]
    stock = stock_size(wishes.stock)
    try:
        placed = nested(outlines, stock, SPACING + wishes.kerf, MARGIN + wishes.kerf)
    except TooLarge as error:
        raise _too_large(pieces[error.index], error, stock, design.edge_length) from error
    return CutPlan(name, tube, wishes, pieces, hinges, placed)


def _too_large(
    piece: Piece, error: TooLarge, stock: tuple[float, float], edge_length: float
) -> Refusal:
    long, short = sorted((error.width, error.height), reverse=True)
    room = sorted(error.room, reverse=True)
    share = min(room[0] / long, room[1] / short)
    return Refusal(
        "Panel {label} is {long:.0f} × {short:.0f} mm, larger than a sheet of {width:g} × "
        "{height:g} mm with its margins: make {EdgeLength} {most:.0f} mm or less, or take sheets "
        "that hold it.",
        parameter="EdgeLength", label=piece.label, long=long, short=short, width=stock[0],
        height=stock[1], most=np.floor(share * edge_length), unit=piece.unit + 1,
    )  # fmt: skip
