# SPDX-License-Identifier: LGPL-2.1-or-later
"""What can be wrong with a print, measured on its meshes and given as plain data (`Finding`)."""

from ..origami.errors import ERROR, NOTE, WARNING, Finding

__all__ = ["ERROR", "NOTE", "WARNING", "Finding"]
