# SPDX-License-Identifier: LGPL-2.1-or-later
"""The toolpaths of a print, and whether they leave its bodies apart. Touches no document."""

import numpy as np

from ..checks import ERROR, NOTE, WARNING, Finding
from ..checks.layering import CONTACT_LIMIT, WELDED
from ..checks.printing import cure_for
from ..exporters import stl
from . import profile, slicer
from .contact import contacts

SECONDS_A_TRIANGLE = 0.0002  # that slicing and looking take, about


def check_toolpaths(bodies, parameters, printer, progress=lambda: None):
    """Findings on the sliced print: joints whose bodies touch; else one note with the largest.

    ``bodies``: `PlacedMesh` list of the print as it stands on the bed; ``parameters``:
    `HingeParameters`; ``printer``: `checks.printer.Printer`. ``progress()`` is called several times
    a second and may raise to cancel: the slicer is ended then. Without PrusaSlicer the one
    finding says so.
    """
    meshes = [body.placed for body in bodies]
    try:
        slicer.find()
    except slicer.NoSlicer as missing:
        return [Finding(WARNING, "slicer", (), None, None, str(missing))]
    lines, _ = sliced(meshes, printer, progress)
    found = contacts(lines, meshes, printer.layer_height, progress)
    return contact_findings(found, bodies, parameters)


def sliced(meshes, printer, progress=lambda: None, extra=()):
    """`gcode.Lines`, in the frame of the ``meshes``, and the slicer's `gcode.Estimate`.

    ``extra``: (name, value) pairs of the slicer's settings that replace ours.
    """
    bounds = np.array([mesh.bounds for mesh in meshes])
    low, high = bounds[:, 0].min(0), bounds[:, 1].max(0)
    shift = np.array([*profile.MIDDLE, 0.0]) - [*(low + high)[:2] / 2, low[2]]
    move = np.eye(4)
    move[:3, 3] = shift
    lines, estimate = slicer.slice_stl(
        lambda path: stl.write_meshes([mesh.moved(move) for mesh in meshes], path),
        profile.settings(printer, extra),
        progress,
    )
    return lines._replace(ends=lines.ends - shift[:2], top=lines.top - shift[2]), estimate


def contact_findings(found, bodies, parameters, limit=CONTACT_LIMIT):
    """Findings on `contact.Contact`s between ``bodies`` (mm² above ``limit``); else one note.

    One finding for all that are welded and one for all that might not come free. Flexible strips
    touch the panels that they join; only contacts of rigid bodies are told.
    """
    rigid = [one for one in found if all(bodies[k].material == "rigid" for k in one.bodies)]
    welded = [one for one in rigid if one.area >= WELDED]
    stiff = [one for one in rigid if limit < one.area < WELDED]
    kinds = (ERROR, welded, "are welded"), (WARNING, stiff, "might not come free")
    told = [
        _finding(severity, several, state, bodies, parameters, limit)
        for severity, several, state in kinds
        if several
    ]
    if told:
        return told
    largest = max((one.area for one in rigid), default=0.0)
    text = f"touch by at most {largest:.2f} mm²" if largest else "do not touch anywhere"
    message = f"On the toolpaths of the slicer the {len(bodies)} bodies {text}."
    return [Finding(NOTE, "contact", (), largest, limit, message)]


def _finding(severity, several, state, bodies, parameters, limit):
    worst = max(several, key=lambda one: one.area)
    pair = [bodies[k] for k in worst.bodies]
    one, other = (body.name for body in pair)
    more = len(several) - 1
    others = f" (and {more} other pair{'s' * (more > 1)} less)" if more else ""
    return Finding(
        severity, "contact", (one, other), worst.area, limit,
        f"{one} and {other} touch by {worst.area:.2f} mm² on the toolpaths{others}, more than "
        f"{limit:g} mm², and {state}.",
        cure_for(pair, parameters), tuple(contact.point for contact in several),
    )  # fmt: skip
