# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that are drawn over everything, so that panels do not hide them."""

from pivy import coin

SOLID, DASHES = 0xFFFF, 0xF0F0


def overlay(layers, points, lines):
    """Switch with one child: lines drawn after, and over, everything else.

    ``layers``: (colour, width, pattern), lowest first.
    """
    annotation = coin.SoAnnotation()
    pick = coin.SoPickStyle()
    pick.style = coin.SoPickStyle.UNPICKABLE
    light = coin.SoLightModel()
    light.model = coin.SoLightModel.BASE_COLOR
    for node in (pick, light, points):
        annotation.addChild(node)
    lines.numVertices.setNum(0)
    for colour, width, pattern in layers:
        style, base = coin.SoDrawStyle(), coin.SoBaseColor()
        style.lineWidth, style.linePattern, base.rgb = width, pattern, colour
        for node in (style, base, lines):
            annotation.addChild(node)
    switch = coin.SoSwitch()
    switch.addChild(annotation)
    return switch


def polyline(corners, *layers):
    """A shown overlay of one line through ``corners`` (n, 3); ``layers`` as of `overlay`."""
    points, lines = coin.SoCoordinate3(), coin.SoLineSet()
    switch = overlay(layers, points, lines)
    points.point.setValues(0, len(corners), corners.tolist())
    lines.numVertices.setValues(0, 1, [len(corners)])
    switch.whichChild = coin.SO_SWITCH_ALL
    return switch
