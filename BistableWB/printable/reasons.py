# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why *Make it printable* sets a property: one phrase each, for a table and for macros."""

import math

from ..origami.errors import NOTHING, phrase

RULING = phrase("seen from there, the weakest unit is firmest")
THICKNESS = phrase("room for the thick panels")
FLIP = phrase("units follow the bends better from this side")
LEVEL = phrase("how the segments are held on a climbing curve")
TOLERANCE = phrase("what the tube may leave the curve by, to open evenly")
STEERED_FREELY = phrase("it was measured without")
BED = phrase("your printer's room")
LAYER = phrase("cones of fine hinges are nearer to each other than thicker layers")
NO_PART = phrase("no print is left for it")
COMPENSATE = phrase("without it thick panels do not snap")
PRELOAD = phrase("margins were measured with it")
MEASURED = phrase("as in your hinges, which margins were measured with")
KNUCKLES = phrase("margins are those of knuckles: flexible hinges have no play to measure")


def gentler(option, wish):
    """Of a curve that is not followed as drawn."""
    return phrase(
        "the drawn one bends too tightly for units with a margin of {margin:.3g}: up to "
        "{change:.3g} mm beside it they have that",
        margin=wish.margin,
        change=option.change,
    )


def edge_length(found):
    """Of ‖AB‖."""
    return phrase(
        "{count} units along {length:.4g} mm of curve",
        count=len(found.margins),
        length=found.design.placement().length,
    )


def gamma(found):
    """Of the first angle."""
    low, high = (math.degrees(f(found.design.placement().thetas)) for f in (min, max))
    return phrase(
        "units open by {low:.0f}° to {high:.0f}°, the weakest has a margin of {margin:.3g}",
        low=low,
        high=high,
        margin=found.margin,
    )


def rule(option):
    """Of the placement rule."""
    if option.rule.name == "Steered":
        return phrase("units open more evenly behind bends, and both ends are met")
    return phrase("the tube ends where the curve does")


def height(design):
    """Of ‖AB‖ / h."""
    if design.height_ratio < 2.5:
        return phrase("a higher strip has room for its hinges where the curve climbs")
    return phrase("the usual height of the strip")


def ratios(chosen, wish):
    """Of the ratio rule."""
    if chosen.name == "TargetSnap":
        return phrase("every unit aims for a margin of its own")
    return phrase(
        "near the least ratio, as the narrow units need it for {margin:.3g}",
        margin=wish.margin,
    )


def target(name, wish):
    """Of what TargetSnap aims for."""
    if name == "TargetMargin":
        return phrase("a little above the wanted {margin:.3g}", margin=wish.margin)
    return phrase("the play of these hinges") if name == "HingePlay" else NOTHING


def panels(preferred):
    """Of hinge and panel numbers."""
    if preferred:
        return phrase("the usual panels are fine enough")
    return phrase("finer hinges have less play, and fit round tighter bends")


def part(number, count, wish):
    """Of the units of one print."""
    if count == 1:
        return phrase("all units fit one print")
    return phrase(
        "print {number} of {count}: the bed is {height:.4g} mm high",
        number=number + 1,
        count=count,
        height=wish.bed[2],
    )
