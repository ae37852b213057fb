# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of bodies and lines, as "#RRGGBB": one table for the 3D view, pictures and files.

The strip is blue, the pyramids are orange; within each the lighter one is the inner panel. Hue and
lightness both differ, so that the kinds stay apart in greyscale and for colour-blind eyes.
"""

PANELS = {
    "contact": "#1F5F99",
    "border": "#83C3EC",
    "primary": "#EE7F2D",
    "secondary": "#FBD07C",
}
INK = "#14283C"  # edges, zigzag, text
CURVE = "#D81B72"
MUTED = "#6B7A89"  # secondary text, construction lines
FAINT = "#D9E0E6"  # graticules, frames
REFUSED = "#F3D9DF"  # where no unit exists

# Kind of a body -> colour, in the order of a legend. A body knows its kind from where it is made.
KINDS = {
    **PANELS,
    "block": PANELS["contact"],
    "link": MUTED,
    "flexure": CURVE,
    "support": FAINT,
    "foot": "#4F8A6B",
    "joint": "#8468A8",
}


def of(kind):
    """Colour of a kind of bodies; of a body that is none of ours (``kind`` empty): grey."""
    return KINDS[kind] if kind else MUTED


def rgb(code):
    """(red, green, blue) in 0…1 of a "#RRGGBB"."""
    return tuple(int(code[i : i + 2], 16) / 255 for i in (1, 3, 5))
