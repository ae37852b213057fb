# SPDX-License-Identifier: LGPL-2.1-or-later
"""Printed hinges and panels: parameters, layout in plan, volumes (docs/theory/hinges.md 2)."""
