# SPDX-License-Identifier: LGPL-2.1-or-later
"""PrusaSlicer as another program: where it is, and slicing with it. No window is opened."""

import os
import shutil
import subprocess
import tempfile
from pathlib import Path

from ..origami.errors import Refusal
from ..origami.progress import NOBODY
from . import gcode

VARIABLE = "PRUSASLICER"  # environment variable with the path of the program
_NAMES = ("prusa-slicer", "PrusaSlicer", "prusa-slicer-console")
_PLACES = (
    "/Applications/PrusaSlicer.app/Contents/MacOS/PrusaSlicer",
    "/Applications/Original Prusa Drivers/PrusaSlicer.app/Contents/MacOS/PrusaSlicer",
    r"C:\Program Files\Prusa3D\PrusaSlicer\prusa-slicer-console.exe",
)
_FLATPAK = "com.prusa3d.PrusaSlicer"
_POLL = 0.2  # seconds between two looks at a running slicer


class NoSlicer(Refusal):
    """PrusaSlicer is not there; the text says what to do."""


def find():
    """The command, a list, that runs PrusaSlicer; `NoSlicer` where it is not installed.

    ``$PRUSASLICER``, else the first on the PATH, else where installers put it, else the flatpak.
    """
    wanted = os.environ.get(VARIABLE)
    if wanted:
        found = shutil.which(wanted)
        if found is None:
            raise NoSlicer(
                "{variable} is {wanted!r}, which is no program: set it to the path of PrusaSlicer.",
                variable=VARIABLE,
                wanted=wanted,
            )
        return [found]
    found = next(filter(None, map(shutil.which, (*_NAMES, *_PLACES))), None)
    if found:
        return [found]
    if _has_flatpak():
        return ["flatpak", "run", f"--filesystem={tempfile.gettempdir()}", _FLATPAK]
    raise NoSlicer(
        "PrusaSlicer was not found: install it (Debian: apt install prusa-slicer), or set the "
        "environment variable {variable} to its path.",
        variable=VARIABLE,
    )


def _has_flatpak():
    if not shutil.which("flatpak"):
        return False
    asked = subprocess.run(["flatpak", "info", _FLATPAK], capture_output=True, check=False)
    return asked.returncode == 0


def slice_stl(write, settings, progress=NOBODY):
    """Slice what ``write(path)`` writes as STL, where it stands: (`gcode.Lines`, `gcode.Estimate`).

    ``settings``: text of a configuration file; where ``progress``, which is asked several
    times a second, raises `Cancelled`, the slicer is ended. `NoSlicer`; ValueError with what it
    says where it makes nothing.
    """
    command = find()
    with tempfile.TemporaryDirectory(prefix="bistable-slicing-") as folder:
        model, config, out, said = (
            Path(folder) / name for name in ("print.stl", "print.ini", "print.gcode", "said.txt")
        )
        write(model)
        config.write_text(settings, encoding="utf-8")
        arguments = ["--datadir", folder, "--load", config, "--dont-arrange", "--export-gcode"]
        _run([*command, *map(str, arguments), "-o", str(out), str(model)], said, progress)
        if not out.is_file():
            raise Refusal(
                "PrusaSlicer made no toolpaths, it says {said!r}: change that, or slice the "
                "exported STL by hand to see more.",
                said=_last_words(said),
            )
        return gcode.read(out)


def _run(command, said, progress):
    """Run a command to its end, its words into the file ``said``; end it where progress raises."""
    with said.open("wb") as words:
        process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=words, stderr=subprocess.STDOUT
        )
        try:
            while process.poll() is None:
                progress.step()
                try:
                    process.wait(_POLL)
                except subprocess.TimeoutExpired:
                    continue
        finally:
            if process.poll() is None:
                process.kill()
                process.wait()


def _last_words(said):
    words = said.read_text(errors="replace").strip().splitlines()
    told = [line for line in words if "[trace]" not in line]
    return told[-1][:200] if told else "nothing"
