# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make it printable: a curve becomes a tube that prints, snaps and ends where the curve does.

    from BistableWB import fitting
    made = fitting.make_printable(curve)
    made.margin, made.end_gap, made.changes, made.blocked

In three steps, of which the second may go on beside a window: `chain.chain_of` and
`request.request_of` read the document, `request.Request.search` searches, `proposal.Writer` says
what is to be changed. How the search goes: `origami.fit.printable`.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from ..origami.errors import Refusal, phrase
from ..origami.fit.options import Wish
from ..origami.progress import NOBODY
from .chain import Chain, chain_of
from .gentler import follow_gentler
from .proposal import Proposal, Writer
from .request import Request, request_of

__all__ = ["Made", "Proposal", "Wish", "chain_of", "follow_gentler", "make_printable", "proposed",
           "request_of"]  # fmt: skip


@dataclass
class Made:
    """What `make_printable` made: document objects, recomputed.

    ``hinge_sets``: one a print; ``changes``: sentences, what was set and why; ``blocked``: None, or
    what stands in the way of what was asked; ``margin``: weakest real snap margin of all units,
    and ``promised``, what the search measured; ``end_gap``: mm from the last midpoint to the
    curve's end.
    """

    curve: object
    triangles: object = None
    unit: object = None
    hinge_sets: list = field(default_factory=list)
    changes: list = field(default_factory=list)
    blocked: str | None = None
    margin: float = 0.0
    promised: float = 0.0
    end_gap: float = math.inf


def make_printable(curve, printer=None, margin=1.2, progress=None):
    """A printable tube along a Curve object, made and recomputed in one step of undo.

    ``curve``: the Curve, or triangles, units or a hinge set along it; ``printer``: None for the bed
    of its hinge set or the usual one, a bed (x, y, z) in mm, or an object with such a ``bed``;
    ``margin``: smallest snap margin of all units, as `HingeSet.SnapMargins` measures it;
    ``progress``: an `origami.progress.Progress`. Triangles, units and hinge sets that already go
    along the curve are used. Where no tube holds all that is asked, the nearest that does is made,
    along a gentler curve if need be, and ``blocked`` or ``changes`` say what stood in the way.
    Returns a `Made`; `Refusal` for what is no Curve.
    """
    chain = chain_of(curve)
    request = request_of(chain, getattr(printer, "bed", printer), margin)
    proposal = proposed(chain, request, request.search(progress or NOBODY))
    made = Made(chain.curve)
    if proposal.blocked is not None:
        made.blocked = str(proposal.blocked)
    if proposal.found is None:
        return made
    doc = chain.document
    doc.openTransaction("Make it printable")
    try:
        objects = proposal.do(doc)
        doc.recompute()
        _tell(made, proposal, objects)
    except Exception:
        doc.abortTransaction()
        raise
    doc.commitTransaction()
    return made


def proposed(chain: Chain, request: Request, answer) -> Proposal:
    """The `Proposal` of a search's answer; without steps where nothing at all can be made."""
    if answer.found is None:
        return Proposal(None, answer.blocked)
    return Writer(chain, request, answer.found, answer.blocked).write()


def _tell(made, proposal, objects):
    """Numbers of the document, not of the search."""
    made.curve, made.triangles, made.unit = (objects[n] for n in ("curve", "triangles", "unit"))
    made.hinge_sets = [objects[name] for name in proposal.hinge_sets]
    made.changes = [str(change) for change in proposal.changes]
    bad = [o for o in (made.curve, made.triangles, made.unit, *made.hinge_sets) if not o.isValid()]
    if bad:
        raise Refusal("{label}: {why}", label=bad[0].Label, why=bad[0].getStatusString())
    # In the window solids and margins follow beside it: here they are waited for.
    models = [hinges.Proxy.model(hinges) for hinges in made.hinge_sets]
    made.promised = proposal.found.margin
    made.margin = min(float(np.min(model.snap.margin)) for model in models)
    deviation = max(model.deviation for model in models)
    made.end_gap = made.triangles.EndGap.Value + deviation
    if len(models) > 1:
        parts = phrase(
            "The tube of {count} units is printed in {parts} parts.",
            count=len(proposal.found.margins),
            parts=len(models),
        )
        made.changes.append(str(parts))
