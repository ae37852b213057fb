# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units and tubes of thick panels on hinges that really close (docs/theory/hinges.md 1, 3, 5)."""
