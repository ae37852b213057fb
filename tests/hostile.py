# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels and names of files that look like something else, for tests of messages."""

HOSTILE = (
    "wall",
    "Gamma",
    "Unit 1",
    "{0}",
    "%s",
    "{EdgeLength}",
    "{unit}",
    "Hülle für Größe 2",
    "of unit 3",
    "EdgeLength ‖AB‖ is",
    "}{",
)
