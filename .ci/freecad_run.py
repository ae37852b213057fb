# SPDX-License-Identifier: LGPL-2.1-or-later
"""What `.ci/in-freecad` lets FreeCAD execute: pytest or one script, with the exit code kept.

FreeCAD swallows exceptions (in recompute, in observers, in slots) and only prints them. So a
traceback that FreeCAD printed during a test fails it, unless it is marked ``provokes_errors``.
"""

import ctypes
import os
import re
import sys
import time
import traceback
from pathlib import Path

import FreeCAD as App
import numpy
import pytest

TRACEBACK = "Traceback (most recent call last)"
REFUSED = re.compile(
    re.escape(TRACEBACK)
    + r':\n  File ".*", line \d+, in execute\n(?: .*\n)+'
    + r"<class '(?:ValueError|BistableWB\.[\w.]+)'>"
)


def swallowed(log):
    """Return ``log`` if it holds a traceback other than a refused input, else an empty string.

    A ValueError, or an error of our own, out of ``execute`` is how an object refuses its input:
    tests see it in its state.
    """
    return log if TRACEBACK in REFUSED.sub("", log) else ""


class PrintedTracebacks:
    """A pytest plugin: what FreeCAD swallowed and printed during a test is that test's failure."""

    @staticmethod
    def pytest_report_header():
        """Say in pytest's header which FreeCAD this is."""
        version = ".".join(App.Version()[:3]) + (" with a window" if App.GuiUp else "")
        return f"FreeCAD {version}, numpy {numpy.__version__}"

    @staticmethod
    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_makereport(item, call):
        """Turn a passed step that printed a traceback into a failed one."""
        report = (yield).get_result()
        printed = "\n".join(text for name, text in report.sections if name.endswith(call.when))
        if report.passed and swallowed(printed) and not item.get_closest_marker("provokes_errors"):
            report.outcome = "failed"
            report.longrepr = f"FreeCAD printed a traceback during {call.when}:\n{printed}"


def run(args):
    """Return the exit code of pytest with ``args``, or of ``--script FILE ARGS``."""
    if args[:1] == ["--script"]:
        sys.argv = args[1:]
        # not runpy: that hides FreeCAD's own __main__, in which its commands look for App and Gui
        source = Path(args[1]).read_text(encoding="utf-8")
        exec(compile(source, args[1], "exec"), {"__name__": "__main__", "__file__": args[1]})
        return 0
    return int(pytest.main([*args, "-p", "no:cacheprovider"], plugins=[PrintedTracebacks()]))


def flush():
    """Hand everything printed so far to whoever reads it."""
    sys.stdout.flush()
    sys.stderr.flush()


def swallowed_so_far():
    """Return everything FreeCAD printed so far if it holds a traceback, else an empty string."""
    flush()
    time.sleep(0.1)  # the log is written by another process
    return swallowed(Path(os.environ["BISTABLE_LOG"]).read_text(errors="replace"))


def main():
    """Run, leave the exit code in the file ``BISTABLE_RESULT``, and end FreeCAD with it."""
    args = os.environ["BISTABLE_ARGS"].splitlines()
    problem = swallowed_so_far() and "while it started"  # a workbench that does not load
    try:
        code = run(args)
    except SystemExit as stop:
        code = stop.code if isinstance(stop.code, int) else int(stop.code is not None)
    except BaseException:
        traceback.print_exc()
        code = 1
    if args[0] == "--script":
        problem = problem or (swallowed_so_far() and "while the script ran")
    if problem:
        print(f"in-freecad: FreeCAD printed a traceback {problem} (above)", file=sys.stderr)
        code = code or 1
    Path(os.environ["BISTABLE_RESULT"]).write_text(str(code))
    flush()
    os._exit(code)  # past FreeCAD's own exit, which may ask to save documents


sys.path.insert(0, os.getcwd())
libc = ctypes.CDLL(None)
# unbuffered, so that what FreeCAD prints from C++ belongs to the test that made it print
libc.setvbuf(ctypes.c_void_p.in_dll(libc, "stdout"), None, 2, 0)
if App.GuiUp:
    from PySide import QtCore

    # when the window is there and idle; kept in a name because the timer must outlive this file
    App.bistable_start = main
    QtCore.QTimer.singleShot(1000, App.bistable_start)
else:
    main()
