# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m BistableWB design.toml --out DIR``: see `BistableWB.cli`."""

import sys

from .cli import main

if __name__ == "__main__":
    sys.exit(main())
