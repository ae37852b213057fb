# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether and how strongly a unit snaps between its two stable states (docs/theory/hinges.md 4)."""

from .margin import energy_path

__all__ = ["energy_path"]
