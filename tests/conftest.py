# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every test sees. Tests that need FreeCAD exist only inside FreeCAD: see .ci/in-freecad."""

import random
import sys

from hypothesis import settings

FREECAD = sys.modules.get("FreeCAD")

collect_ignore = []
if FREECAD is None:
    collect_ignore.append("freecad")
if FREECAD is None or not FREECAD.GuiUp:
    collect_ignore.append("gui")

# The same examples on each run, and no database: a red run can be repeated anywhere.
# No deadline: machines differ.
settings.register_profile("house", database=None, deadline=None, max_examples=40, derandomize=True)
settings.load_profile("house")


def pytest_addoption(parser):
    """``--shuffle SEED``: files, and the tests in each, in another order (0: as they are)."""
    parser.addoption("--shuffle", type=int, default=0, metavar="SEED")


def pytest_report_header(config):
    """Say which order it is, so that it can be had again."""
    seed = config.getoption("--shuffle")
    return f"shuffled: make test-random SEED={seed}" if seed else None


def pytest_collection_modifyitems(config, items):
    """Shuffle; tests of a file stay together, for what they share is made once."""
    seed = config.getoption("--shuffle")
    if not seed:
        return
    order = random.Random(seed)
    files = {}
    for item in items:
        files.setdefault(item.path, []).append(item)
    groups = list(files.values())
    order.shuffle(groups)
    for group in groups:
        order.shuffle(group)
    items[:] = [item for group in groups for item in group]
