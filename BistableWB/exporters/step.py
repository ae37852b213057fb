# SPDX-License-Identifier: LGPL-2.1-or-later
"""STEP: one named shape a body, exact surfaces, millimetres."""

import re
import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import FreeCAD as App
import Import

from .. import __version__

if TYPE_CHECKING:
    from .bodies import Body

_FILE_NAME = re.compile(rb"FILE_NAME\(.*?\);", re.DOTALL)


def write(bodies: "Sequence[Body]", path: Path) -> None:
    """Write ``bodies`` with their names."""
    before = App.ActiveDocument
    doc = App.newDocument("StepExport", hidden=True, temp=True)
    try:
        features = []
        for body in bodies:
            feature = doc.addObject("Part::Feature", "Body")
            feature.Label = body.name
            feature.Shape = body.shape
            features.append(feature)
        Import.export(features, str(path))
    finally:
        App.closeDocument(doc.Name)
        if before is not None:
            App.setActiveDocument(before.Name)
    content = path.read_bytes() if path.is_file() else b""
    if not content.rstrip().endswith(b"END-ISO-10303-21;"):
        raise OSError("the STEP writer did not finish")
    path.write_bytes(_named(content, path.name))


def _named(content: bytes, name: str) -> bytes:
    """The file with its own name in the header, not that of the temporary one it was written to."""
    plain = name.encode("ascii", "replace").replace(b"'", b"''").decode()
    now = time.strftime("%Y-%m-%dT%H:%M:%S")
    entry = (
        f"FILE_NAME('{plain}','{now}',(''),(''),'Bistable Workbench {__version__}',"
        f"'FreeCAD {'.'.join(App.Version()[:3])}','');"
    )
    return _FILE_NAME.sub(lambda _: entry.encode(), content, count=1)
