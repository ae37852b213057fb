# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves, and how segments of one length are placed along them (theory: geometry.md 2, 5)."""
