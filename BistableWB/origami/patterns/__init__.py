# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets and sheets: the panels of a tube unfolded, to be cut, scored and glued."""
