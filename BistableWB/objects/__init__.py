# SPDX-License-Identifier: LGPL-2.1-or-later
"""FeaturePython proxies. Thin: read properties, call origami and solids, set Shape and results."""

import importlib

# Type name -> (module, class): the one list of what the workbench puts into documents.
TYPES = {
    "Bistable::Curve": ("curve", "Curve"),
    "Bistable::TrianglePlacement": ("triangle_placement", "TrianglePlacement"),
    "Bistable::BistableUnit": ("bistable_unit", "BistableUnit"),
    "Bistable::HingeSet": ("hinge_set", "HingeSet"),
    "Bistable::HingeCoupon": ("hinge_coupon", "HingeCoupon"),
}


def proxy_class(type_name):
    """Class of the proxy for a ``Proxy.Type`` string; ValueError for a foreign one."""
    if type_name not in TYPES:
        raise ValueError(f"{type_name!r} is not a type of the Bistable workbench.")
    module, name = TYPES[type_name]
    return getattr(importlib.import_module(f"{__name__}.{module}"), name)


def type_of(obj):
    """``Proxy.Type`` of a document object of ours, else an empty string."""
    return getattr(getattr(obj, "Proxy", None), "Type", "")
