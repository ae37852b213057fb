# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether an object is what its inputs say now: what every export, check and report asks first."""

from ..origami.errors import Refusal
from . import links
from .refused import refusal_of


def chain_of(obj):
    """Objects of the workbench that ``obj`` is made of, the first input first, itself last.

    `Refusal` where a link is gone, or leads back to ``obj``.
    """
    return list(_chain(obj, ()))


def _chain(obj, above):
    proxy = getattr(obj, "Proxy", None)
    if obj in above:
        raise links.goes_round(obj, obj.Label)
    if hasattr(proxy, "PROPERTIES"):
        for name in links.link_names(proxy):
            target = links.followed(links.linked(obj, name))
            if target is not None:
                yield from _chain(target, (*above, obj))
    yield obj


def refuse_stale(obj):
    """`Refusal` where ``obj``, or anything that it is made of, is invalid or not recomputed.

    A refused input leaves what is above it as it was, and FreeCAD calls that valid.
    """
    for one in chain_of(obj):
        if not one.isValid():
            raise Refusal(
                "{label} is invalid, correct it first: {refused}",
                label=one.Label,
                refused=refusal_of(one),
            )
        if "Touched" in one.State:
            raise Refusal(
                "{label} is not computed yet",
                cure="recompute the document first",
                label=one.Label,
            )
