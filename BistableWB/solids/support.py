# SPDX-License-Identifier: LGPL-2.1-or-later
"""The soluble support between the panels of a flat-folded print, as one body of many prisms."""

from typing import TYPE_CHECKING, Any

import Part

from ..origami.hinges.support import support_prisms
from .shapes import shape_of
from .tube import Body

if TYPE_CHECKING:
    from ..origami.hinges.parameters import HingeParameters
    from ..origami.thick.linkage import ThickUnit


def support_body(
    thick: "ThickUnit", parameters: "HingeParameters", incoming_left: Any = None
) -> Body:
    """`Body` "support" of a tube in the print frame: a compound of `support.support_prisms`."""
    prisms = support_prisms(thick, parameters, incoming_left)
    return Body("support", Part.makeCompound([shape_of(p) for p in prisms]), 0, (), "support")
