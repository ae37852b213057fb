# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where things of space are in a 3D view, and what lies under a place of the view.

Read from the camera's text: FreeCAD 1.1 crashes after Python has asked a viewer for its Coin
camera. Places in the view are shares of its width and height from the lower left corner.
"""

import math
import re

import FreeCAD as App


class Camera:
    """The camera of ``view`` as it is now; ``aspect``: width / height of the view."""

    def __init__(self, view, aspect):
        text = view.getCamera()
        axis = _numbers(text, "orientation", 4, (0, 0, 1, 0))
        turn = App.Rotation(App.Vector(*axis[:3]), math.degrees(axis[3]))
        self.position = App.Vector(*_numbers(text, "position", 3, (0, 0, 1)))
        self.right, self.up, self.forward = (
            turn.multVec(App.Vector(*axis)) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, -1))
        )
        self.is_perspective = "PerspectiveCamera" in text
        if self.is_perspective:
            high = 2 * math.tan(_numbers(text, "heightAngle", 1, (math.pi / 4,))[0] / 2)
        else:
            high = _numbers(text, "height", 1, (2,))[0]
        high /= min(1.0, aspect)
        self.width, self.height = high * aspect, high

    def project(self, point):
        """Place (x, y) of a point of space."""
        offset = App.Vector(*point) - self.position
        depth = offset.dot(self.forward) if self.is_perspective else 1.0
        return (
            0.5 + offset.dot(self.right) / (depth * self.width),
            0.5 + offset.dot(self.up) / (depth * self.height),
        )

    def ray(self, place):
        """Point of space and unit direction of what lies under a place."""
        aside = self.right * ((place[0] - 0.5) * self.width)
        aside += self.up * ((place[1] - 0.5) * self.height)
        if self.is_perspective:
            return App.Vector(self.position), (self.forward + aside).normalize()
        return self.position + aside, App.Vector(self.forward)


def _numbers(text, field, count, default):
    """Numbers of a field; Coin leaves out those that are at their default."""
    found = re.search(rf"\b{field}\s+((?:[-+\d.eE]+\s+){{{count}}})", text + "\n")
    return tuple(float(number) for number in found.group(1).split()) if found else default
