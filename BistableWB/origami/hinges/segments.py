# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a hinge is divided into knuckles: an odd number of segments, a gap length ga apart.

By a count (the paper's Segmentations) all are equally long. By a wanted width (SegmentWidth) the
first and the last are short, so that the outermost cones stand near the very ends of the hinge:
rigid bodies are held only there, and the same clearance lets them move less
(docs/theory/hinges.md 4).
"""

from math import floor

from .parameters import CONE_HEIGHT_IN_GAPS, PIN, HingeParameters

END_SHARE = 0.4  # of the wanted width: what is left of the first and the last knuckle
_ALIKE = 1e-9
# Fewer hold one of the two axial directions at one end of the hinge only; and what is usual.
_ENOUGH, _FEW = 5, 7


def segment_lengths(length: float, parameters: HingeParameters) -> list[float]:
    """Lengths (mm) of the segments of a hinge ``length`` mm long; empty if not even one fits.

    They and the gaps between them take all of the length.
    """
    if parameters.segment_width:
        return _by_width(length, parameters)
    most = parameters.segmentations
    return _equal(length, max(0, min(_fitting(length, parameters), most)), parameters.gap_length)


def cone_height_for(segment: float, parameters: HingeParameters) -> float:
    """Height (mm) of the cones of a hinge whose shortest segments are ``segment`` mm long."""
    lowest = CONE_HEIGHT_IN_GAPS[1] * parameters.gap_length
    room = max(segment - parameters.nozzle_diameter, lowest)
    return min(parameters.full_cone_height, room)


def _fitting(length: float, parameters: HingeParameters) -> int:
    """Largest odd number of segments that fits (0: none)."""
    gap, least = parameters.gap_length, parameters.shortest_segment
    count = floor((length + gap) / (least + gap) + _ALIKE)
    return max(0, count - 1 + count % 2)


def _equal(length: float, count: int, gap: float) -> list[float]:
    return [(length - (count - 1) * gap) / count] * count


def _by_width(length: float, parameters: HingeParameters) -> list[float]:
    gap, width = parameters.gap_length, parameters.segment_width
    end, fitting = _end(parameters), _fitting(length, parameters)
    few = _equal(length, min(fitting, _FEW), gap) if fitting else []
    inner = length - 2 * (end + gap)
    if not few or few[0] <= end or inner < end:
        return few  # a hinge so short that equal knuckles are as short as those at its ends
    count = min(max(_ENOUGH, 2 * round(((inner + gap) / (width + gap) - 1) / 2) + 3), fitting)
    return [end, *_equal(inner, count - 2, gap), end]


def _end(parameters: HingeParameters) -> float:
    """Length of the first and the last knuckle: its cone and a floor, or its share of the width."""
    holds = 2 * parameters.nozzle_diameter
    if parameters.pivot != PIN:
        holds = parameters.full_cone_height + parameters.nozzle_diameter
    return max(holds, END_SHARE * parameters.segment_width)
