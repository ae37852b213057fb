# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scripts of resources/translations as modules."""

import importlib.util
import sys

from BistableWB import TRANSLATIONS


def load(name):
    """The script ``name``."""
    module = f"bistable_{name}"
    if module not in sys.modules:
        spec = importlib.util.spec_from_file_location(module, TRANSLATIONS / f"{name}.py")
        sys.modules[module] = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(sys.modules[module])
    return sys.modules[module]
