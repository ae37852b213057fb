# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coin nodes and what moves them: bodies, handles, pointers, motion. Knows the 3D view only."""
