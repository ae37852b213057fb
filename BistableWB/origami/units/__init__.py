# SPDX-License-Identifier: LGPL-2.1-or-later
"""One unit of zero-thickness panels, and whole tubes of them (theory: geometry.md 1, 3, 4, 6)."""
