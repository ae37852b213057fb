# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kernel's solids of bodies that `origami.hinges` draws as boundaries. No document objects.

Nothing is sewn, and no boolean operation is run: the kernel reads a boundary as text, and meshes
are made from the boundary itself.
"""
