# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m BistableWB design.toml --out DIR``: see `BistableWB.program.cli`."""

import sys

from .program.cli import main

if __name__ == "__main__":
    sys.exit(main())
