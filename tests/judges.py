# SPDX-License-Identifier: LGPL-2.1-or-later
"""Other people's Python packages that judge our results: build/python, fetched by .ci/judges."""

import importlib
import sys
from pathlib import Path
from types import ModuleType

import pytest

_FETCHED = Path(__file__).parents[1] / "build" / "python"


def judge(name, absent=()):
    """The package ``name``; where it is not here, or is built for another Python, a skip.

    ``absent``: packages that it imports for its window, which is not wanted here.
    """
    if str(_FETCHED) not in sys.path and _fits():
        sys.path.append(str(_FETCHED))
    for one in absent:
        sys.modules.setdefault(one, ModuleType(one))
    try:
        return importlib.import_module(name)
    except ImportError as why:
        pytest.skip(f"could not import {name!r}: {why}", allow_module_level=True)


def _fits():
    """Whether what was fetched was built for this Python; other Debians have others."""
    tag = sys.implementation.cache_tag
    return any(_FETCHED.glob(f"mujoco/*.{tag}-*.so"))
