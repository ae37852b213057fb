# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clips that snap: a post with a catch on one half, a tongue beside a window in the other.

The tongue lies in the plane of its panel and bends in it, so it prints without support, along its
layers, and is a cantilever: its tip pushed aside by y, its root is strained by 3 w y / (2 L²), w
its width and L its length. So the strain that the material bears gives the length. Nothing stands
out of either half beyond what the other fills.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .outward import Outward
    from .parameters import HingeParameters

PLAY = 0.15  # mm round a post
_POST = 2.0, 3.0  # mm, across the tongue and along it


@dataclass(frozen=True)
class Clip:
    """Sizes (mm) of one clip, in its own plan: x across the tongue, y from its root to its tip.

    ``length`` L of the tongue to its tip, ``width`` w in which it bends, ``overhang`` y of the
    catch; ``thickness`` of each half, half of which the tongue has; ``slack`` under the catch.
    """

    length: float
    width: float
    overhang: float
    thickness: float
    slack: float

    @property
    def ledge(self) -> float:
        """Thickness (mm) of the tongue."""
        return self.thickness / 2

    @property
    def strain(self) -> float:
        """Of the tongue's root while the catch goes by, which pushes it at the post's middle."""
        arm = self.length - PLAY - _POST[1] / 2
        return 1.5 * self.width * self.overhang / arm**2

    @property
    def across(self) -> tuple[float, ...]:
        """Where (mm) the window's parts begin: slit, post, tongue's two sides, and the end."""
        first = _POST[0] + PLAY
        last = first + self.width
        return first - self.width / 2 - PLAY, -PLAY, first, last, last + self.overhang + 2 * PLAY

    @property
    def size(self) -> tuple[complex, complex]:
        """The window's two corners, as complex numbers."""
        _, low, _, _, high = self.across
        return complex(low, 0), complex(high, self.length + self.width)

    @property
    def opening(self) -> list[complex]:
        """The window as a whole, without the tongue, counter-clockwise: eight corners.

        The second and third are the tongue's root.
        """
        slit, low, first, last, high = self.across
        end, foot = self.length + self.width, self.length - _POST[1] - 2 * PLAY
        return [
            complex(slit, 0), complex(first, 0), complex(last, 0), complex(high, 0),
            complex(high, end), complex(low, end), complex(low, foot), complex(slit, foot),
        ]  # fmt: skip

    @property
    def tongue(self) -> list[complex]:
        """The tongue, counter-clockwise from its root."""
        _, _, first, last, _ = self.across
        ends = first, last, last + 1j * self.length, first + 1j * self.length
        return [complex(p) for p in ends]


def clip_for(strain: float, thickness: float, parameters: "HingeParameters") -> Clip:
    """`Clip` whose tongue is strained by ``strain`` at most, in halves of this thickness (mm)."""
    width = 2 * parameters.nozzle_diameter
    overhang = parameters.nozzle_diameter + PLAY
    arm = max(sqrt(1.5 * width * overhang / strain), 2 * width)
    length = arm + PLAY + _POST[1] / 2
    return Clip(length, width, overhang, thickness, parameters.layer_height / 2)


def draw_post(
    outward: "Outward", clip: Clip, place: Callable[[complex], complex], cap: float
) -> list[int]:
    """Post and catch on the level ``cap`` of a half; returns the loop of its foot.

    ``place(x + i y)``: the plan point of the print for a point of the clip's own plan.
    """
    wide, deep = _POST
    start = clip.length - PLAY - deep
    catch = clip.ledge + clip.slack
    profile = [
        (0.0, 0.0), (wide, 0.0), (wide, catch), (wide + clip.overhang, catch),
        (wide, clip.thickness), (0.0, clip.thickness),
    ]  # fmt: skip
    near, far = (
        [outward.ring([place(complex(x, y))], cap + z)[0] for x, z in profile]
        for y in (start, start + deep)
    )
    outward.upright(*near)
    outward.upright(*far[::-1])
    for k in range(1, len(profile)):
        after = (k + 1) % len(profile)
        outward.upright(near[k], far[k], far[after], near[after])
    return outward.draft.ring([near[0], near[1], far[1], far[0]])


def draw_window(
    outward: "Outward",
    clip: Clip,
    place: Callable[[complex], complex],
    cap: float,
    inside: float,
) -> tuple[list[int], list[int]]:
    """Window and tongue through a half, from its level ``cap`` to the panel's ``inside``.

    Returns the loops in both, counter-clockwise from above.
    """
    window, tongue = ([place(p) for p in points] for points in (clip.opening, clip.tongue))
    below = outward.ring([window[0], *window[3:]], inside)
    above = outward.ring(window, cap)
    shelf = outward.ring(tongue, cap - clip.ledge)
    tip = outward.ring(tongue[2:], cap)
    # the wall of the root, at y = 0, looks into the window; it has the tongue's section in it
    outward.upright(below[1], below[0], *above[:2], *shelf[:2], *above[2:4])
    low, high = [*below[1:], below[0]], [*above[3:], above[0]]
    outward.walls(low, high, hole=True, closed=False)
    outward.walls([*shelf[1:], shelf[0]], [above[2], *tip, above[1]], closed=False)
    outward.plane(False, outward.draft.ring(shelf))
    rim = [*above[:2], tip[1], tip[0], *above[2:]]
    return outward.draft.ring(rim), outward.draft.ring(below)
