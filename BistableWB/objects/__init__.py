# SPDX-License-Identifier: LGPL-2.1-or-later
"""FeaturePython proxies. Thin: read properties, call origami and solids, set Shape and results."""

import importlib
from typing import NamedTuple

from ..origami.errors import Refusal


class Type(NamedTuple):
    """What the workbench knows of a type of objects; parts are named, not imported.

    ``module`` and ``proxy``: class of the proxy; ``view`` and ``panel``: module and class in
    `viewproviders` and `taskpanels`; ``table`` of a design file that makes one, and the property
    that links it to its ``input``; ``menu``: commands that go on from it (in the context menu);
    ``is_heavy``: made on Apply and OK only; ``is_print``: it is printed.
    """

    module: str
    proxy: str
    view: tuple = ("base", "BistableView")
    panel: tuple = ("base", "ObjectPanel")
    table: str = ""
    input: str = ""
    menu: tuple = ()
    is_heavy: bool = False
    is_print: bool = False


# Type name -> all about it: the one list of what the workbench puts into documents.
TYPES = {
    "Bistable::Curve": Type(
        "curve", "Curve", ("lines", "CurveView"), ("curve", "CurvePanel"), "curve",
        menu=("TrianglePlacement", "Units", "MakePrintable"),
    ),
    "Bistable::TrianglePlacement": Type(
        "triangle_placement", "TrianglePlacement", ("lines", "TrianglePlacementView"),
        table="triangles", input="Curve", menu=("Units", "MakePrintable"),
    ),
    "Bistable::BistableUnit": Type(
        "bistable_unit", "BistableUnit", ("bistable_unit", "BistableUnitView"), table="unit",
        input="Triangles", menu=("MakePrintable", "Deploy", "Plots", "HingeSet", "ExportPrint"),
    ),
    "Bistable::HingeSet": Type(
        "hinge_set", "HingeSet", ("bodies", "HingeSetView"), ("base", "HeavyPanel"), "hinges",
        "Unit", ("MakePrintable", "Deploy", "Plots", "Check", "ExportPrint", "Report"),
        is_heavy=True, is_print=True,
    ),
    "Bistable::HingeCoupon": Type(
        "hinge_coupon", "HingeCoupon", ("bodies", "BodiesView"), table="coupon",
        menu=("Check", "ExportPrint", "Report"), is_print=True,
    ),
    "Bistable::CalibrationPlate": Type(
        "calibration_plate", "CalibrationPlate", ("bodies", "BodiesView"),
        ("calibration", "CalibrationPanel"), "calibration",
        menu=("Check", "ExportPrint", "Report"), is_print=True,
    ),
}  # fmt: skip


def proxy_class(type_name):
    """Class of the proxy for a ``Proxy.Type`` string; ValueError for a foreign one."""
    if type_name not in TYPES:
        raise Refusal(
            "{type_name!r} is not a type of the Bistable workbench.",
            type_name=type_name,
        )
    entry = TYPES[type_name]
    return getattr(importlib.import_module(f"{__name__}.{entry.module}"), entry.proxy)


def type_of(obj):
    """``Proxy.Type`` of a document object of ours, else an empty string."""
    return getattr(getattr(obj, "Proxy", None), "Type", "")


def is_heavy(obj):
    """Whether an object of a document takes so long that panels make it on Apply and OK only."""
    return type_of(obj) in TYPES and TYPES[type_of(obj)].is_heavy
