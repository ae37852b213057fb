# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's start and the first activation of the workbench cost: CPU ms, least of 7.

    .ci/in-freecad --gui host --script benchmarks/startup.py [ROOT…]

Of this checkout, or of others (an older commit, say). *Start* is what InitGui.py imports and joins,
every time FreeCAD starts; *activation* is what the commands and their panels import, once. numpy
and Qt are loaded before, and so are compiled modules, as they are with a user.
"""

import sys
import time
from pathlib import Path

import FreeCADGui as Gui
import numpy  # noqa: F401
from PySide import QtCore, QtGui  # noqa: F401

ROUNDS = 7


def forget(root):
    """Every module of the package goes; the next import finds the one of ``root``."""
    for name in [name for name in sys.modules if name.split(".")[0] == "BistableWB"]:
        del sys.modules[name]
    sys.path[:] = [str(root), *(path for path in sys.path if "istable" not in path)]


def spent(work, *given):
    """CPU milliseconds of ``work(*given)``."""
    before = time.process_time()
    work(*given)
    return 1e3 * (time.process_time() - before)


def start(root):
    """What FreeCAD does with InitGui.py, but for adding the workbench a second time."""
    source = (root / "InitGui.py").read_text(encoding="utf-8")
    source = source.replace("Gui.addWorkbench(", "str(")
    exec(compile(source, "InitGui.py", "exec"), {})


def activation():
    """What the first look at the toolbars imports."""
    import BistableWB.commands  # noqa: F401


def main():
    """Print a line for each checkout."""
    sys.dont_write_bytecode = False
    roots = [Path(name).resolve() for name in sys.argv[1:]] or [Path.cwd()]
    print(f"{'checkout':42}    start  activation  modules  of them at start")
    for root in roots:
        starts, activations = [], []
        for _ in range(ROUNDS):
            forget(root)
            starts.append(spent(start, root))
            early = sum(name.startswith("BistableWB") for name in sys.modules)
            activations.append(spent(activation))
        late = sum(name.startswith("BistableWB") for name in sys.modules)
        print(
            f"{str(root)[-42:]:42} {min(starts):5.0f} ms {min(activations):7.0f} ms"
            f" {late:8} {early:17}"
        )


assert Gui.getMainWindow(), "this needs a window: see the first lines"
main()
