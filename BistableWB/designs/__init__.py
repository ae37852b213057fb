# SPDX-License-Identifier: LGPL-2.1-or-later
"""Design files: TOML keys, reading, writing, and building what they ask for."""
