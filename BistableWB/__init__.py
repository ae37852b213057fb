# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bistable Workbench: from a curve to a bistable tube that is printed flat-folded.

Only the version and the resource paths live here: importing the package must cost nothing.
"""

from pathlib import Path

__version__ = "0.1.0"

ROOT = Path(__file__).resolve().parent.parent
RESOURCES = ROOT / "resources"
ICONS = RESOURCES / "icons"
EXAMPLES = RESOURCES / "examples"
TRANSLATIONS = RESOURCES / "translations"
