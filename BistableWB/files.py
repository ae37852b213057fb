# SPDX-License-Identifier: LGPL-2.1-or-later
"""How every file of ours is written: aside, whole, then in one step to its place."""

import contextlib
import errno
import os
import shutil
import tempfile
import zipfile
from pathlib import Path

from .origami.errors import Refusal

_FORBIDDEN = {ord(character): "-" for character in [*'<>:"/\\|?*', *map(chr, range(32))]}
_LONGEST = 60  # characters of a label: where each takes four bytes, a number and a suffix fit too
_ZIPPED = (".3mf", ".fcstd")  # read again before they take their place


@contextlib.contextmanager
def whole_file(path):
    """A path to write to; what is there takes the place of ``path`` when the block has ended well.

    It lies in a folder of its own beside ``path``, so that its name and suffix are those of the
    file, and is on the disk before it replaces an old file, whose permissions it keeps. Where
    anything fails the old file stays, and nothing is left behind. OSError for what is empty or
    broken, as on a full disk.
    """
    path = Path(os.path.realpath(path))  # a link stays one
    folder = Path(tempfile.mkdtemp(prefix=".writing-", dir=path.parent))
    try:
        unfinished = folder / path.name
        yield unfinished
        _check(unfinished)
        _to_disk(unfinished)
        if path.is_file():
            shutil.copymode(path, unfinished)
        os.replace(unfinished, path)
        _to_disk(path.parent)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def write_text(path, text, encoding="utf-8", newline=None):
    """Write a text as a `whole_file`."""
    with whole_file(path) as unfinished:
        unfinished.write_text(text, encoding=encoding, newline=newline)


def file_name(label):
    """``label`` of any object as a file name that every system takes, without a suffix."""
    name = label.translate(_FORBIDDEN).strip(" .")[:_LONGEST].strip(" .")
    return name or "-"


def check_target(path):
    """`Refusal`, with the cure, where no file can be written at ``path``."""
    if path.is_dir():
        raise Refusal("{path} is a folder: add a file name to it.", path=path)
    if not path.parent.is_dir():
        raise Refusal(
            "There is no folder {folder}: make it, or choose another one.", folder=path.parent
        )
    if not os.access(path.parent, os.W_OK | os.X_OK):
        raise Refusal(
            "The folder {folder} cannot be written: choose another one.", folder=path.parent
        )


def refuse_to_write(path, error):
    """`Refusal`, one sentence with the cure, for an `OSError` while ``path`` was written."""
    full = error.errno == errno.ENOSPC
    raise Refusal(
        "{name} was not written to {folder} ({reason})",
        cure="free some space there" if full else "choose another folder",
        name=path.name,
        folder=path.parent,
        reason=error.strerror or str(error),
    ) from error


def _check(path):
    if not path.is_file() or not path.stat().st_size:
        raise OSError("nothing was written")
    if path.suffix.lower() in _ZIPPED:
        try:
            with zipfile.ZipFile(path) as package:
                broken = package.testzip()
        except zipfile.BadZipFile as error:
            raise OSError("it was not written whole") from error
        if broken:
            raise OSError("it was not written whole")


def _to_disk(path):
    """Have the system put a file, or what a folder lists, on the disk now."""
    if path.is_dir() and os.name != "posix":
        return  # only there folders can be opened
    handle = os.open(path, os.O_RDONLY)
    try:
        os.fsync(handle)
    except OSError as error:
        if error.errno != errno.EINVAL:  # a file system that has no such thing
            raise
    finally:
        os.close(handle)
