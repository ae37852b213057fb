# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for other programs: ``export(objects, "print.stl", **options)``, one module a format.

A module has ``write(bodies, path, **options)``: it writes ``bodies``, a list of `Body`, to ``path``
or raises. It need not care about half-written files: `export` lets it write into a temporary folder
beside the target, and only a whole file takes the old one's place.
"""

import errno
import importlib
import inspect
import os
import shutil
import tempfile
from pathlib import Path

from .bodies import Body, bodies_of

__all__ = ["FORMATS", "Body", "export", "suffixes"]

# Suffix -> module of this package. To add a format, add its module and a line here.
FORMATS = {
    ".3mf": "threemf",
    ".dxf": "dxf",
    ".fold": "fold",
    ".obj": "obj",
    ".scad": "scad",
    ".step": "step",
    ".stl": "stl",
    ".stp": "step",
    ".svg": "svg",
}
# Those that hold every state, or a program that makes them.
_ALL_STATES = (".dxf", ".fold", ".scad", ".svg")


def suffixes():
    """Suffixes that `export` knows, as text for people."""
    return ", ".join(FORMATS)


def export(objects, path, **options):
    """Write document objects to ``path`` in the format of its suffix; returns the path.

    ``objects``: one object or several, recomputed. Options are the format's own; formats of shapes
    also take ``state``: "flat" or "deployed" (without it prints are flat, and faces are as they
    are shown). A file that is there is replaced only by a whole new one. ValueError, one sentence
    with the cure, for an unknown suffix or option, a folder that cannot be written, no objects, an
    invalid object.
    """
    path = Path(path)
    write = _writer(path, options)
    state = options.pop("state", None)
    if not isinstance(objects, list | tuple):
        objects = [objects] if objects is not None else []
    bodies = bodies_of(objects, state)
    check_target(path)
    try:
        _write_whole(write, bodies, path, options)
    except OSError as error:
        refuse_to_write(path, error)
    return path


def _writer(path, options):
    """Function that writes the format of ``path``, its options checked."""
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        what = f"the suffix {path.suffix}" if path.suffix else "no suffix"
        raise ValueError(f"{path.name} has {what}: name the file with one of {suffixes()}.")
    write = importlib.import_module(f"{__name__}.{FORMATS[suffix]}").write
    known = [p.name for p in inspect.signature(write).parameters.values()][2:]
    known += [] if suffix in _ALL_STATES else ["state"]
    for name in options:
        if name not in known:
            offers = f"it has {', '.join(known)}" if known else "it has none"
            raise ValueError(f"{suffix} export has no option {name!r}: {offers}.")
    return write


def check_target(path):
    """ValueError, with the cure, where no file can be written at ``path``."""
    if path.is_dir():
        raise ValueError(f"{path} is a folder: add a file name to it.")
    if not path.parent.is_dir():
        raise ValueError(f"There is no folder {path.parent}: make it, or choose another one.")
    if not os.access(path.parent, os.W_OK | os.X_OK):
        raise ValueError(f"The folder {path.parent} cannot be written: choose another one.")


def refuse_to_write(path, error):
    """ValueError, one sentence with the cure, for an `OSError` while ``path`` was written."""
    cure = "free some space there" if error.errno == errno.ENOSPC else "choose another folder"
    raise ValueError(
        f"{path.name} was not written to {path.parent} ({error.strerror or error}): {cure}."
    ) from error


def _write_whole(write, bodies, path, options):
    folder = Path(tempfile.mkdtemp(prefix=".writing-", dir=path.parent))
    try:
        unfinished = folder / path.name
        write(bodies, unfinished, **options)
        if not unfinished.is_file() or not unfinished.stat().st_size:
            raise OSError("nothing was written")
        os.replace(unfinished, path)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
