# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's placements and matrices, and arrays (4, 4): one conversion each way."""

from typing import Any

import numpy as np
from FreeCAD import Matrix, Placement
from numpy.typing import NDArray


def array_of(placement: Any) -> NDArray:
    """Matrix (4, 4) of a placement."""
    return np.array(placement.toMatrix().A).reshape(4, 4)


def matrix_of(array: NDArray) -> Any:
    """FreeCAD's matrix of an array (4, 4)."""
    return Matrix(*np.asarray(array, float).ravel().tolist())


def placement_of(array: NDArray) -> Any:
    """FreeCAD's placement of a rigid motion (4, 4)."""
    return Placement(matrix_of(array))
