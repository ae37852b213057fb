# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a tube may follow."""

from typing import Any, Protocol

from numpy.typing import NDArray


class Curve(Protocol):
    """Anything with a point for every s from 0 to 1.

    What else a curve may know (``breaks`` between its pieces, ``normals``) is asked for by name.
    """

    def point(self, s: Any) -> NDArray:
        """Points (…, 3) at the parameters ``s`` (…)."""
        ...
