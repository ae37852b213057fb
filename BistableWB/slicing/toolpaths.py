# SPDX-License-Identifier: LGPL-2.1-or-later
"""The toolpaths of a print, and whether they leave its bodies apart. Touches no document."""

import numpy as np

from ..checks.layering import CONTACT_LIMIT, WELDED
from ..checks.printing import cure_for
from ..exporters import stl
from ..origami.errors import ERROR, NOTE, WARNING, Finding, phrase
from ..origami.progress import NOBODY
from ..programs import prusaslicer
from . import profile
from .contact import contacts

SECONDS_A_TRIANGLE = 0.0002  # that slicing and looking take, about


def check_toolpaths(bodies, parameters, printer, progress=NOBODY):
    """Findings on the sliced print: joints whose bodies touch; else one note with the largest.

    ``bodies``: `PlacedMesh` list of the print as it stands on the bed; ``parameters``:
    `HingeParameters`; ``printer``: `checks.printer.Printer`. Where ``progress``, which is
    asked several times a second, raises `Cancelled`, the slicer is ended. Without PrusaSlicer the
    one finding says so.
    """
    meshes = [body.placed for body in bodies]
    try:
        prusaslicer.find()
    except prusaslicer.NoSlicer as missing:
        return [
            Finding(
                severity=WARNING,
                code="slicer",
                message=missing.message,
            )
        ]
    extra = profile.for_process(parameters.process)
    lines, _ = sliced(meshes, printer, progress, extra.items())
    found = contacts(lines, meshes, printer.layer_height, progress)
    return contact_findings(found, bodies, parameters)


def sliced(meshes, printer, progress=NOBODY, extra=()):
    """`gcode.Lines`, in the frame of the ``meshes``, and the slicer's `gcode.Estimate`.

    ``extra``: (name, value) pairs of the slicer's settings that replace ours.
    """
    bounds = np.array([mesh.bounds for mesh in meshes])
    low, high = bounds[:, 0].min(0), bounds[:, 1].max(0)
    shift = np.array([*profile.MIDDLE, 0.0]) - [*(low + high)[:2] / 2, low[2]]
    move = np.eye(4)
    move[:3, 3] = shift
    lines, estimate = prusaslicer.slice_stl(
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
    kinds = (
        (ERROR, welded, phrase("are welded")),
        (WARNING, stiff, phrase("might not come free")),
    )
    told = [
        _finding(severity, several, state, bodies, parameters, limit)
        for severity, several, state in kinds
        if several
    ]
    if told:
        return told
    largest = max((one.area for one in rigid), default=0.0)
    message = phrase(
        "On the toolpaths of the slicer the {count} bodies {touch}.",
        count=len(bodies),
        touch=phrase(
            "touch by at most {area:.2f} mm²" if largest else "do not touch anywhere", area=largest
        ),
    )
    return [
        Finding(
            severity=NOTE,
            code="contact",
            number=largest,
            limit=limit,
            message=message,
        )
    ]


def _finding(severity, several, state, bodies, parameters, limit):
    worst = max(several, key=lambda one: one.area)
    pair = [bodies[k] for k in worst.bodies]
    one, other = (body.name for body in pair)
    more = len(several) - 1
    others = phrase(
        " (and {count} other pairs less)" if more > 1 else " (and {count} other pair less)",
        count=more,
    )
    return Finding(
        severity=severity,
        code="contact",
        bodies=(one, other),
        number=worst.area,
        limit=limit,
        message=phrase(
            "{one} and {other} touch by {area:.2f} mm² on the toolpaths{others}, more "
            "than {limit:g} mm², and {state}.",
            one=one,
            other=other,
            area=worst.area,
            others=others if more else "",
            limit=limit,
            state=state,
        ),
        cure=cure_for(pair, parameters),
        points=tuple(contact.point for contact in several),
    )
