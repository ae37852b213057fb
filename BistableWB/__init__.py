# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bistable Workbench: from a curve to a bistable tube that is printed flat-folded.

Only the version and the resource paths live here: importing the package must cost nothing.
"""

from pathlib import Path

__version__ = "0.1.0"

ROOT = Path(__file__).resolve().parent.parent
_PACKAGED = Path(__file__).resolve().parent / "resources"  # as pip installs them
RESOURCES = _PACKAGED if _PACKAGED.is_dir() else ROOT / "resources"
ICONS = RESOURCES / "icons"
EXAMPLES = RESOURCES / "examples"
TRANSLATIONS = RESOURCES / "translations"

# Modules that macros recorded by 0.1.0 import from here, and where they are now.
_MOVED = {"design": "designs.reading", "produce": "designs.building"}


def __getattr__(name):
    """Modules under the names that recorded macros know."""
    if name not in _MOVED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    import importlib

    return importlib.import_module(f"{__name__}.{_MOVED[name]}")
