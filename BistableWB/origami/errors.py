# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the mathematics refuses bad input: one sentence that names the first offender."""

import numpy as np


def require(valid, message, value=None, *more):
    """Raise ValueError with ``message`` unless every entry of ``valid`` holds.

    ``message`` may use ``{value}`` (the offending entry of ``value``), ``{0}``, ``{1}`` … (the
    same entry of ``more``) and ``{at}``, which becomes " of unit k" (counted from 1) for arrays
    and nothing for scalars.
    """
    valid = np.asarray(valid)
    if valid.all():
        return
    index = np.unravel_index(int(np.argmin(valid)), valid.shape)

    def pick(array):
        return None if array is None else float(np.broadcast_to(array, valid.shape)[index])

    at = f" of unit {index[0] + 1}" if valid.ndim else ""
    raise ValueError(message.format(*map(pick, more), value=pick(value), at=at))
