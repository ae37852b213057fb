# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m BistableWB --verify DIR``: whether outputs are whole, and what documents say.

A line a file. Exit code 0: all are; 1: something is not; 2: there is nothing to look at.
"""

import sys
from pathlib import Path

from ..origami.errors import Refusal
from .cli import BAD_INPUT, DONE, FAILED


def main(args: list[str]) -> int:
    """Verify the designs in the folder ``args[0]``; returns the exit code."""
    from ..designs.verifying import verify

    count = bad = 0
    try:
        for path, wrong in verify(Path(args[0])):
            count += 1
            bad += wrong is not None
            print(f"{path}: {'whole' if wrong is None else wrong}")
    except Refusal as refusal:
        print(refusal, file=sys.stderr)
        return BAD_INPUT
    print(f"{count} files, {bad} of them wrong")
    return FAILED if bad else DONE
