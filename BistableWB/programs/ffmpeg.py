# SPDX-License-Identifier: LGPL-2.1-or-later
"""ffmpeg, where it is installed: films that every player and website takes."""

import os
import shutil
import subprocess
import tempfile
import threading
from pathlib import Path

from ..files import whole_file
from ..origami.errors import Refusal

_AT_MOST = 300  # s that a film of some dozens of pictures may take


def program():
    """Path of ffmpeg: that of the environment variable FFMPEG, else on the PATH; else None."""
    return shutil.which(os.environ.get("FFMPEG") or "ffmpeg")


def write_mp4(pictures, path, pause):
    """A film of PNG files, there and back; ``pause``: ms that each one is shown.

    `Refusal` where ffmpeg makes none; nothing is left at ``path`` then.
    """
    pictures = [Path(picture) for picture in pictures]
    with (
        whole_file(path) as unfinished,
        tempfile.TemporaryFile() as film,  # no pipe: where ffmpeg ends early, it ends FreeCAD 1.0
        tempfile.TemporaryFile() as said,
    ):
        command = [
            program(), "-y", "-loglevel", "error", "-f", "image2pipe", "-framerate",
            f"1000/{pause}", "-i", "-", "-pix_fmt", "yuv420p", "-movflags", "+faststart",
            str(unfinished),
        ]  # fmt: skip
        for picture in [*pictures, *pictures[-2:0:-1]]:
            film.write(picture.read_bytes())
        film.seek(0)
        running = subprocess.Popen(command, stdin=film, stdout=said, stderr=said)
        end = threading.Timer(_AT_MOST, running.kill)
        end.start()
        running.wait()
        end.cancel()
        said.seek(0)
        lines = said.read().decode(errors="replace").split("\n")
        if running.returncode or not unfinished.is_file():
            reason = next((line.strip(" .") for line in lines if line.strip()), "")
            raise Refusal(
                "ffmpeg made no film: {reason}.",
                reason=reason or f"exit code {running.returncode}",
            )
