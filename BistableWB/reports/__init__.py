# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports: one HTML page on a design, its numbers, findings and pictures."""
