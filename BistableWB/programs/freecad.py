# SPDX-License-Identifier: LGPL-2.1-or-later
"""Our command-line programs start themselves inside freecadcmd where FreeCAD is not importable.

FreeCAD's own libraries fill stdout with statistics, so inside the process that we start the file
descriptor 1 leads nowhere, and only Python's ``sys.stdout`` reaches the caller.
"""

import importlib
import importlib.util
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

_ROOT = Path(__file__).resolve().parents[2]
_VARIABLE = "BISTABLE_LAUNCH"
_NAMES = ("freecadcmd", "FreeCADCmd", "freecadcmd-python3")
# below 255 bytes: freecadcmd 1.1 takes it for the name of a file first, and ends on a longer one
_CODE = (
    f"import json, os, sys; sys.path.insert(0, json.loads(os.environ['{_VARIABLE}'])['root']); "
    "from BistableWB.programs import freecad; freecad.inside()"
)


class NoFreeCAD(Exception):
    """FreeCAD is neither importable nor installed as a command; the text says what to do."""


def available():
    """Whether this very process can import FreeCAD."""
    return "FreeCAD" in sys.modules or importlib.util.find_spec("FreeCAD") is not None


def find_freecadcmd():
    """Path of freecadcmd: ``$FREECADCMD``, else the first on the PATH; `NoFreeCAD` if none."""
    wanted = os.environ.get("FREECADCMD")
    found = shutil.which(wanted) if wanted else next(filter(None, map(shutil.which, _NAMES)), None)
    if found is None:
        what = f"FREECADCMD is {wanted!r}, which is no program" if wanted else "was not found"
        raise NoFreeCAD(
            f"FreeCAD {what}: install it (Debian: apt install freecad), or set FREECADCMD to the "
            "path of its freecadcmd."
        )
    return found


def start(module, args):
    """Start ``BistableWB.<module>.main(args)`` inside freecadcmd; returns the running process.

    Its exit code is what ``main`` returns. ``stdout`` and ``stderr`` are this process's own.
    """
    job = {"root": str(_ROOT), "module": module, "args": list(args)}
    keep = ()
    if os.name == "posix":
        sys.stdout.flush()
        job["stdout"] = os.dup(1)
        keep = (job["stdout"],)
    environment = {**os.environ, _VARIABLE: json.dumps(job)}
    environment.pop("PYTHONHOME", None)
    try:
        return subprocess.Popen(
            [find_freecadcmd(), "-c", _CODE],
            env=environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL if keep else None,
            pass_fds=keep,
        )
    finally:
        for descriptor in keep:
            os.close(descriptor)


def inside():
    """What freecadcmd executes: run the program, and end this process with its exit code."""
    job = json.loads(os.environ.pop(_VARIABLE))
    if "stdout" in job:
        sys.stdout = os.fdopen(job["stdout"], "w", encoding="utf-8", errors="replace")
    code = 1
    try:
        code = importlib.import_module(f"BistableWB.{job['module']}").main(job["args"])
    except SystemExit as stop:
        code = stop.code if isinstance(stop.code, int) else int(stop.code is not None)
    except KeyboardInterrupt:
        code = 130
    except BaseException:
        sys.excepthook(*sys.exc_info())
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:  # whoever reads it has gone
            code = code or 1
    os._exit(int(code or 0))  # FreeCAD's own exit loses the exit code on some versions
