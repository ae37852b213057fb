# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a tube starts from where nobody has said: ‖AB‖ by the curve and the printer."""

_EDGES = 10.0  # edge lengths along a curve: some thirty units
_LEAST = 20.0  # mm: shorter edges of usual panels are all hinge
_FIRM = 60.0  # mm: with usual hinges, units that open by some 60° snap by 1.4 or more
_FEW = 2.5  # edge lengths of the shortest curve, some three units
_BED = 250.0
_OF_BED = 0.4  # of the bed's longer side: the print is about twice as wide as ‖AB‖


def usual_edge_length(length: float, bed: float = _BED) -> float:
    """‖AB‖ (mm, whole) to begin with along a curve of ``length`` on a ``bed`` so long."""
    return float(round(min(max(length / _EDGES, _LEAST), _OF_BED * bed)))


def first_edge_length(length: float, bed: float = _BED) -> float:
    """‖AB‖ (mm, whole) of a new tube along a curve of ``length``, on a ``bed`` so long.

    Usual hinges snap by it wherever the curve lets units open; a short curve holds three units.
    """
    firm = min(max(length / _EDGES, _FIRM), _OF_BED * bed)
    return float(max(round(min(firm, length / _FEW)), 1))
