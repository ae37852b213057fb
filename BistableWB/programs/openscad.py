# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenSCAD, where it is installed: an independent kernel that judges our meshes and programs.

It renders with exact numbers (CGAL): what it calls one closed body is one.
"""

import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..exporters import stl
from ..origami.errors import ERROR, NOTE, Finding, Refusal, phrase
from ..origami.meshes import Mesh
from ..origami.progress import NOBODY

VOLUME_TOLERANCE = 0.005  # share by which its volume may differ from ours
SECONDS_A_TRIANGLE = 0.0006  # that it takes, about
# A lone mesh is passed through unread: joined to this cube (mm), it is read and must be closed.
_CUBE = 0.1
_UNION = 'union() {{ import("{}"); translate([{:.6f}, {:.6f}, {:.6f}]) cube({}); }}\n'
_TROUBLE = "ERROR", "WARNING", "not closed"


class NotInstalled(Refusal):
    """There is no OpenSCAD here."""


class MadeNothing(Refusal):
    """OpenSCAD broke, or refused what it was given."""


class Rendered(NamedTuple):
    """``mesh`` of what OpenSCAD made, the number of its ``bodies``, and what it complained of."""

    mesh: Mesh
    bodies: int
    complaints: list


def program():
    """Path of OpenSCAD: that of the environment variable OPENSCAD, else the first on the PATH."""
    found = shutil.which(os.environ.get("OPENSCAD") or "openscad")
    if found is None:
        raise NotInstalled(
            "OpenSCAD was not found: install it (openscad.org), or put its path into the "
            "environment variable OPENSCAD.",
        )
    return found


def installed():
    """Whether OpenSCAD can be asked."""
    try:
        return bool(program())
    except NotInstalled:
        return False


def render(path, settings=(), progress=NOBODY):
    """`Rendered` of the OpenSCAD file ``path``; ``settings``: "name=value" texts.

    It may take minutes; where ``progress`` raises `Cancelled`, OpenSCAD is ended.
    `NotInstalled` without OpenSCAD; `MadeNothing` where it breaks.
    """
    with tempfile.TemporaryDirectory() as folder:
        out, log = Path(folder) / "rendered.stl", Path(folder) / "log"
        definitions = [part for text in settings for part in ("-D", text)]
        with open(log, "w") as said:
            running = subprocess.Popen(
                [program(), *definitions, "-o", str(out), str(path)],
                stdin=subprocess.DEVNULL, stdout=said, stderr=said,
            )  # fmt: skip
            try:
                while running.poll() is None:
                    progress.step()
                    time.sleep(0.05)
            finally:
                if running.poll() is None:
                    running.kill()
                    running.wait()
        lines = log.read_text(errors="replace").splitlines()
        complaints = [line for line in lines if any(word in line for word in _TROUBLE)]
        if not out.exists():
            last = complaints or lines[-1:] or [f"exit code {running.returncode}"]
            raise MadeNothing("OpenSCAD made nothing: {reason}.", reason=last[0].rstrip("."))
        return Rendered(_read_stl(out), _bodies(lines), complaints)


def check(meshes, progress=NOBODY):
    """Findings: whether a print of ``meshes`` (`Mesh`, mm) is closed and the same for OpenSCAD.

    Bodies that overlap a little are not seen, for all are read as one mesh: `checks` sees them.
    Without OpenSCAD one note says so.
    """
    try:
        program()
    except NotInstalled as missing:
        return [
            Finding(
                severity=NOTE,
                code="openscad",
                message=missing.message,
            )
        ]
    low = np.min([mesh.bounds[0] for mesh in meshes], axis=0) - 10
    with tempfile.TemporaryDirectory() as folder:
        stl.write_meshes(meshes, Path(folder) / "print.stl")
        path = Path(folder) / "print.scad"
        path.write_text(_UNION.format("print.stl", *low.tolist(), _CUBE), encoding="utf-8")
        try:
            made = render(path, progress=progress)
        except MadeNothing as error:
            return [_refused(error.message)]
    if made.complaints:
        complaint = made.complaints[0].rstrip(".")
        return [
            _refused(phrase("OpenSCAD does not accept the mesh: {complaint}.", complaint=complaint))
        ]
    ours, its = sum(mesh.volume for mesh in meshes), made.mesh.volume - _CUBE**3
    return _compared(len(meshes), made.bodies - 1, ours, its)


def _refused(message):
    cure = phrase("see what the check of closed solids finds")
    return Finding(
        severity=ERROR,
        code="openscad",
        message=message,
        cure=cure,
    )


def _compared(bodies, its_bodies, volume, its_volume):
    off = abs(its_volume - volume) / volume
    if its_bodies != bodies:
        return [
            Finding(
                severity=ERROR,
                code="openscad",
                number=float(its_bodies),
                limit=float(bodies),
                message=phrase(
                    "OpenSCAD finds {found} separate bodies where there are {bodies}.",
                    found=its_bodies,
                    bodies=bodies,
                ),
                cure=phrase("see which bodies touch in the check of clearances"),
            )
        ]
    if off > VOLUME_TOLERANCE:
        return [
            Finding(
                severity=ERROR,
                code="openscad",
                number=off,
                limit=VOLUME_TOLERANCE,
                message=phrase(
                    "OpenSCAD measures {found:.6g} mm³, {off:.2%} off our {volume:.6g} mm³.",
                    found=its_volume,
                    off=off,
                    volume=volume,
                ),
                cure=phrase("see what the check of closed solids finds"),
            )
        ]
    text = phrase(
        "OpenSCAD agrees: {bodies} closed bodies of {volume:.6g} mm³ ({off:.3%} off ours).",
        bodies=bodies,
        volume=its_volume,
        off=off,
    )
    return [
        Finding(
            severity=NOTE,
            code="openscad",
            number=off,
            limit=VOLUME_TOLERANCE,
            message=text,
        )
    ]


def _bodies(lines):
    """Closed bodies by its log; its "volumes" count the outside too."""
    found = [line.split()[-1] for line in lines if line.strip().startswith("Volumes:")]
    return int(found[-1]) - 1 if found else 1


def _read_stl(path):
    """`Mesh` of a text STL; corners are not joined."""
    words = [line.split()[1:] for line in path.read_text().splitlines() if "vertex" in line]
    corners = np.array(words, float).reshape(-1, 3)
    return Mesh(corners, np.arange(len(corners)).reshape(-1, 3))
