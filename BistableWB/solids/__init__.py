# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part solids of hinged panels, links, whole tubes and test prints. No document objects.

Built without booleans: the faces of a body are made directly and sewn, and its volume is compared
with the one that the layout predicts (``hinges.md`` 7: ``isValid()`` is not enough).
"""
