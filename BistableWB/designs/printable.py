# SPDX-License-Identifier: LGPL-2.1-or-later
"""``make_printable = true`` in a design file: the search sets what the file leaves open."""

from typing import TYPE_CHECKING, Any

from ..objects.refused import refusal_of
from ..origami.errors import Refusal
from ..origami.progress import Progress
from ..printable import chain_of, proposed, request_of
from .reading import DesignError
from .wording import with_keys

if TYPE_CHECKING:
    import FreeCAD as App

    from .reading import Design

MARGIN = 1.2


def wants_it(design: "Design") -> bool:
    """Whether a design asks for it."""
    return bool(design.get("design", "make_printable", False))


def make_it(
    doc: "App.Document", design: "Design", objects: dict[str, Any], progress: Progress
) -> list[str]:
    """Set ``objects`` {table: object} to what the search finds; ``hinges``: the first print.

    Returns sentences: what stands in the way of what is wished, none where nothing does.
    `DesignError` where nothing at all can be made.
    """
    if not wants_it(design):
        return []
    doc.recompute([objects["curve"]])
    if refusal_of(objects["curve"]) is not None:
        return []  # the recompute of all says it
    chain = chain_of(objects["hinges"])
    try:
        request = request_of(chain, margin=design.get("design", "snap_margin", MARGIN))
        proposal = proposed(chain, request, request.search(progress))
    except Refusal as error:
        raise _error(design, with_keys(design, "hinges", error)) from error
    blocked = proposal.blocked
    if proposal.found is None:
        raise _error(design, with_keys(design, None, blocked))
    made = proposal.do(doc)
    for change in proposal.changes:
        progress.step(str(change))
    objects |= {name: made[name] for name in ("curve", "triangles", "unit", "hinges")}
    if blocked is None:
        return []
    return [f"make_printable: {with_keys(design, None, blocked)}"]


def _error(design: "Design", why: Any) -> DesignError:
    return DesignError(
        "{path}: [design] make_printable: {why}.", path=design.path, why=str(why).rstrip(".")
    )
