# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the formats of cut panels write: the plans of the chosen objects' tubes."""

from collections.abc import Sequence
from typing import Any

from ..origami.errors import Refusal
from ..origami.patterns.cut_plan import CutPlan, CutWishes, cut_plan
from .thin import ThinModel, unit_of


def plan_of(
    bodies: Sequence[Any],
    panel_thickness: float,
    panel_hinge: str,
    stock: Any,
    edge_gap: float,
    kerf: float = 0.0,
) -> CutPlan:
    """The `CutPlan` of the one tube that ``bodies`` come from; a HingeSet stands for its unit.

    The rest is as of `CutWishes`. What is a `CutPlan` already, made without FreeCAD, stays.
    """
    if len(bodies) == 1 and isinstance(bodies[0], CutPlan):
        return bodies[0]
    if any(isinstance(body, ThinModel) for body in bodies):
        raise TypeError("A tube without thickness has no plan.")  # a mistake of the program
    from ..objects.bistable_unit import design_of

    units = list({unit.Name: unit for unit in (unit_of(body.source) for body in bodies)}.values())
    if len(units) > 1:
        raise Refusal(
            "{count} tubes are chosen to cut: choose one.",
            count=len(units),
        )
    wishes = CutWishes(
        panel_thickness=panel_thickness,
        hinge=panel_hinge,
        stock=stock,
        kerf=kerf,
        edge_gap=edge_gap,
    )
    return cut_plan(units[0].Label, design_of(units[0]), wishes)
