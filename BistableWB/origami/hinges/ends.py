# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the two ends of a print are: halves of contact blocks, plates, flanges.

Whatever it is, it lies on the outer face of the end's contact panel, where no other panel, barrel
or link of the unit ever comes: they all open away from it.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, NamedTuple

from numpy.typing import NDArray

from .. import rigid
from ..errors import Refusal
from . import polygons
from .bodies import draw_panel, outer_side
from .drafting import Draft
from .feet import Plane
from .flexures import strips
from .joints import Joint, clearance_hole, half_thickness
from .outward import Outward
from .strips import beside_holes

if TYPE_CHECKING:
    from .boundary import Boundary
    from .joints import Feature, Plan
    from .parameters import HingeParameters
    from .unit_layout import Layout, Plate

PLAIN, PLATE, FLANGE, FOOT = "Plain", "Plate", "Flange", "Foot"


class EndKind(NamedTuple):
    """``what`` it is, and what belongs to it.

    ``is_wider``: whether its plate stands out, with screw holes; ``stands``: whether it has a foot.
    """

    what: str
    has_plate: bool = True
    is_wider: bool = False
    stands: bool = False


END_PARTS = {
    PLAIN: EndKind("the contact panel as it is", has_plate=False),
    PLATE: EndKind("a plate over the whole end, over the slots of its hinges too"),
    FLANGE: EndKind("a plate that stands out all round, with four screw holes", is_wider=True),
    FOOT: EndKind(
        "a flange, and a foot for it that stands square on the plane of `FootPoint` and "
        "`FootNormal` when the tube is deployed",
        is_wider=True,
        stands=True,
    ),
}


@dataclass(frozen=True)
class Ends:
    """How a print ends: the ``joint`` where tubes are cut or close, and end parts of open ones.

    ``start``, ``end``: of `END_PARTS`; ``thickness`` of their plates (mm; 0: twice the panels');
    ``ground``: the plane on which feet stand.
    """

    joint: Joint = field(default_factory=Joint)
    start: str = PLAIN
    end: str = PLAIN
    thickness: float = 0.0
    ground: Plane = field(default_factory=Plane)

    def __post_init__(self) -> None:
        for parameter, value in (("StartPart", self.start), ("EndPart", self.end)):
            if value not in END_PARTS:
                raise Refusal(
                    "{name} is unknown: choose one of {names}.",
                    parameter=parameter, name=repr(value), names=", ".join(END_PARTS),
                )  # fmt: skip
        if not 0 <= self.thickness < float("inf"):
            raise Refusal(
                "{PlateThickness} is {value:.6g} mm: set it to a length, or to 0 for twice the "
                "panels'.",
                parameter="PlateThickness", value=self.thickness,
            )  # fmt: skip

    @property
    def has_feet(self) -> bool:
        """Whether an open tube stands on a foot."""
        return any(END_PARTS[kind].stands for kind in (self.start, self.end))

    def plate_thickness(self, parameters: "HingeParameters") -> float:
        """Thickness (mm) of plates and flanges."""
        return self.thickness or 2 * parameters.face_thickness


class EndPanel:
    """The contact panel ``name`` of a unit at an end of a print.

    ``layout`` of its unit, ``place`` (4, 4) of that in the print; ``upwards``: nothing is above.
    """

    def __init__(
        self,
        layout: "Layout",
        name: str,
        place: NDArray,
        parameters: "HingeParameters",
        upwards: bool,
    ) -> None:
        self.layout, self.place, self.parameters = layout, place, parameters
        self.plate, self.upwards = layout.plates[name], upwards
        middle = float((place @ [0.0, self.plate.height, 0.0, 1.0])[2])
        way = 1.0 if upwards else -1.0
        self.face = middle + way * parameters.face_thickness / 2

    def half_block(
        self, corners: "Plan", features: "Sequence[Feature]", plan: NDArray
    ) -> "Boundary":
        """`Boundary` of the panel with half of a block's filler on it, and a joint's features.

        ``corners`` of the filler, counter-clockwise, and the features are in a plan that both
        halves share; ``plan`` (4, 4) carries it into the print's.
        """
        draft = Draft()
        outward = Outward(draft, self.face, self.upwards, plan)
        cap, inside = self.parameters.gap_between_planes / 2, -self.parameters.face_thickness
        rings = [outward.ring(corners, z) for z in (0.0, cap)]
        outward.walls(rings[0], rings[1])
        drawn = [draw(outward, cap, inside, self.upwards) for draw in features]
        outward.plane(True, draft.ring(rings[1]), *(loop for loop, _ in drawn))
        return self._closed(outward, rings[0], [loop for _, loop in drawn if loop])

    def with_plate(
        self,
        filler: "Plan",
        outline: "Plan",
        holes: Sequence[tuple[complex, float]],
        thickness: float,
    ) -> "Boundary":
        """`Boundary` of the panel with a plate a gap away from it, held by ``filler``.

        ``outline`` of the plate and ``holes`` [(centre, radius)] are in the print's plan.
        """
        draft = Draft()
        outward = Outward(draft, self.face, self.upwards)
        low = self.parameters.gap_between_planes
        posts = [outward.ring(filler, z) for z in (0.0, low)]
        outward.walls(posts[0], posts[1])
        edges = [outward.ring(outline, z) for z in (low, low + thickness)]
        outward.walls(edges[0], edges[1])
        rims = []
        for centre, radius in holes:
            rim = [outward.circle(centre, radius, z) for z in (low, low + thickness)]
            outward.round_walls(rim[0], rim[1], hole=True)
            rims.append(rim)
        inner = [draft.ring(posts[1]), *([rim] for rim, _ in rims)]
        outward.plane(False, draft.ring(edges[0]), *inner)
        outward.plane(True, draft.ring(edges[1]), *([rim] for _, rim in rims))
        return self._closed(outward, posts[0], [])

    def _closed(
        self, outward: Outward, foot: list[int], through: Sequence[list[int]]
    ) -> "Boundary":
        """The panel itself, with what goes on its outer face and through its inner face."""
        draft, side = outward.draft, outer_side(self.plate)
        plate = self._beside([draft.outline(loop) for loop in through])
        holes = {
            side: [outward.seen(draft.ring(foot), False)],
            -side: [outward.seen(loop, True) for loop in through],
        }
        found = None
        if not self.parameters.has_knuckles:
            found = strips(self.layout, self.parameters)
        draft.set_frame(self.place)
        draw_panel(draft, plate, self.parameters, found, holes)
        return draft.boundary()

    def _beside(self, through: Sequence[NDArray]) -> "Plate":
        """The panel with its stand-offs beside what goes ``through`` it, loops in the print."""
        back = rigid.inverse(self.place)
        holes = [
            points[:, 0] + 1j * points[:, 2] for points in (rigid.apply(back, p) for p in through)
        ]
        wall = self.parameters.nozzle_diameter
        studs = [
            stud._replace(corners=corners)
            for stud in self.plate.studs
            for corners in beside_holes(stud.corners, holes, wall)
        ]
        return replace(self.plate, studs=tuple(studs))


def flange_rim(joint: Joint, parameters: "HingeParameters") -> float:
    """How far (mm) a flange stands out: a screw hole, and walls of half of it or four nozzles."""
    diameter = clearance_hole(joint.screw_diameter)
    return diameter + 2 * max(2 * parameters.nozzle_diameter, diameter / 2)


def plate_plan(
    quad: "Plan", joint: Joint, kind: str, parameters: "HingeParameters"
) -> "tuple[Plan, list[tuple[complex, float]]]":
    """Outline and holes [(centre, radius)] of a plate or flange over an end.

    ``quad``: corners of the end's contact panel without thickness, in the print's plan.
    """
    if not END_PARTS[kind].is_wider:
        return list(quad), []
    rim, radius = flange_rim(joint, parameters), clearance_hole(joint.screw_diameter) / 2
    outline = polygons.intersection(quad, quad, inset=-rim)
    centres = polygons.intersection(quad, quad, inset=-rim / 2)
    return outline, [(p, radius) for p in centres]


def end_height(kind: str, ends: Ends, parameters: "HingeParameters") -> float:
    """How far (mm) an end part stands out from the end's contact panel."""
    if not END_PARTS[kind].has_plate:
        return 0.0
    return parameters.gap_between_planes + ends.plate_thickness(parameters)


def joint_height(parameters: "HingeParameters") -> float:
    """How far (mm) half a block stands out from its contact panel."""
    return half_thickness(parameters) - parameters.face_thickness


def stands_out(ends: Ends, parameters: "HingeParameters", closed: bool) -> tuple[float, float]:
    """By how much (mm) ends widen a print all round, and make it higher; for a printer's bed."""
    if closed:
        return 0.0, 2 * joint_height(parameters)
    kinds = ends.start, ends.end
    wide = any(END_PARTS[kind].is_wider for kind in kinds)
    heights = (end_height(kind, ends, parameters) for kind in kinds)
    return flange_rim(ends.joint, parameters) if wide else 0.0, sum(heights)
