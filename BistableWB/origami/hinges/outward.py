# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws on the outer face of an end panel, whichever way it looks: heights grow away from it."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .bodies import walls
from .drafting import Draft


class Outward:
    """Faces of what stands on, or goes into, the outer face of a panel that lies in the print.

    Plan points x + i y are those of the print, or of another plan that the motion ``plan`` (4, 4)
    carries there, counter-clockwise from above; heights (mm) are measured from the face at height
    ``face``, upwards or downwards. Whether a face looks out, away from the panel, or in, is all
    that needs to be said of it.
    """

    def __init__(
        self, draft: Draft, face: float, upwards: bool, plan: NDArray | None = None
    ) -> None:
        self.draft, self.upwards = draft, upwards
        frame = np.diag([1.0, 1.0, 1.0 if upwards else -1.0, 1.0])
        frame[2, 3] = face
        if plan is not None:
            frame[:2, [0, 1, 3]] = plan[:2, [0, 1, 3]]
        draft.set_frame(frame)

    def ring(self, points: Sequence[complex], height: float) -> list[int]:
        """New vertices."""
        return [self.draft.vertex((p.real, p.imag, height)) for p in points]

    def circle(self, centre: complex, radius: float, height: float) -> int:
        """New full circle, counter-clockwise from above."""
        along, across = (radius, 0.0, 0.0), (0.0, radius, 0.0)
        return self.draft.circle((centre.real, centre.imag, height), along, across)

    def seen(self, loop: list[int], looks_out: bool) -> list[int]:
        """A loop, counter-clockwise from above, as one sees it who looks at such a face."""
        return loop if looks_out == self.upwards else [~edge for edge in reversed(loop)]

    def plane(self, looks_out: bool, outline: list[int], *holes: list[int]) -> None:
        """Level face; loops are counter-clockwise from above."""
        turned = (self.seen(loop, not looks_out) for loop in holes)
        self.draft.plane(self.seen(outline, looks_out), *turned)

    def walls(
        self, low: Sequence[int], high: Sequence[int], hole: bool = False, closed: bool = True
    ) -> None:
        """Upright faces between two rings, the first nearer to the panel; of a ``hole`` in it.

        ``closed`` as of `bodies.walls`.
        """
        if hole:
            low, high = low[::-1], high[::-1]
        walls(self.draft, *((low, high) if self.upwards else (high, low)), closed=closed)

    def round_walls(self, low: int, high: int, hole: bool = False) -> None:
        """Cylinder between two circles."""
        first, second = (low, high) if self.upwards else (high, low)
        self.draft.ruled(first, second, -1 if hole else 1)

    def upright(self, *corners: int) -> None:
        """Face with straight edges, counter-clockwise from outside if heights grew upwards."""
        self.draft.polygon(*(corners if self.upwards else corners[::-1]))
