# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the poses of thick units are looked for first, and when they have jumped elsewhere."""

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..units.creases import INDEX, LINKS, PANELS
from .closure import BODY

# Change of a pose between two nodes of the path that no body makes by turning steadily.
_JUMP = 0.25
# The two panels between which each link turns.
_BESIDE = {
    "link_upper": ("primary_left_upper", "primary_right_upper"),
    "link_B": ("contact_left", "contact_right"),
    "link_lower": ("primary_left_lower", "primary_right_lower"),
}


def without_thickness(flat: NDArray, deployed: NDArray) -> NDArray:
    """Poses (n, 15, 4, 4) of the panels without thickness, of the links half way between two.

    ``flat``, ``deployed``: corners (n, 10, 3) of units in both states; poses are as seen from the
    first panel.
    """
    corners = [[INDEX[v] for v in panel] for panel in PANELS.values()]
    poses = [rigid.fit(flat[:, c], deployed[:, c]) for c in corners]
    for link, (start, _) in LINKS.items():
        a, b = (poses[BODY[panel]] for panel in _BESIDE[link])
        turn = rigid.between(a, b, 0.5)[:, :3, :3]
        i = INDEX[start]
        poses.append(rigid.pose(turn, deployed[:, i] - (turn @ flat[:, i, :, None])[..., 0]))
    stacked = np.stack(poses, 1)
    return rigid.inverse(stacked[:, :1]) @ stacked


def jumps_between(poses: NDArray, others: NDArray) -> NDArray:
    """Which of the states (…, 15, 4, 4) lie on different branches of the path."""
    return np.abs(poses - others).max((-3, -2, -1)) > _JUMP
