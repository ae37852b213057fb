# SPDX-License-Identifier: LGPL-2.1-or-later
"""The same tube by every process that lays filament: time, plastic, waste, changes, height.

    from BistableWB import slicing
    for mode in slicing.modes(hinge_set): print(mode)

By PrusaSlicer's reckoning; where it is not installed by `estimate`'s, and each says so. Runs inside
FreeCAD.
"""

from dataclasses import dataclass, replace

import numpy as np

from ..checks.printer import printer_of
from ..origami.errors import Choice, phrase
from ..origami.hinges.processes import BY_STANDOFFS, BY_SUPPORT, PROCESSES
from ..origami.hinges.standoff_inputs import LINE_IN_NOZZLES, StandOffs, usual_air
from ..origami.progress import as_progress
from ..programs import prusaslicer
from ..solids.matrices import array_of
from ..solids.tessellation import placed_meshes
from .comparison import sliced_as
from .estimate import guess
from .profile import SPEEDS, for_process
from .section import Section, duration, volume

_COLUMNS = (
    phrase("process"),
    phrase("time"),
    phrase("plastic"),
    phrase("waste"),
    phrase("material changes"),
    phrase("height"),
)


@dataclass(frozen=True)
class Mode:
    """One process for one tube: ``seconds``, ``plastic`` and ``waste`` (mm³), ``height`` (mm).

    ``changes`` of the material; ``fits`` the printer; ``is_guess``: no slicer was asked, ``waste``
    and ``changes`` are not known (None) where support is wanted; ``is_best``: the quickest of those
    that fit.
    """

    process: str
    seconds: float
    plastic: float
    waste: float | None
    changes: int | None
    height: float
    fits: bool
    is_guess: bool
    is_best: bool = False


def modes(hinge_set, progress=None, printer=None, speed="quality"):
    """`Mode` of every process for filament, of a recomputed HingeSet with its own numbers.

    ``progress``: a `Progress`; ``printer``: `checks.printer.Printer`, that of the object if not
    given; ``speed``: one of `profile.SPEEDS`, a slower or a faster printer.
    """
    progress = as_progress(progress)
    printer = printer or printer_of(hinge_set)
    try:
        has_slicer = bool(prusaslicer.find())
    except prusaslicer.NoSlicer:
        has_slicer = False
    found = []
    for name, process in PROCESSES.items():
        if not process.has_layers_of_lines:
            continue
        model = _model(hinge_set, name)
        stand = array_of(model.standing(process.orientation))
        meshes = [b.mesh.moved(stand @ b.place) for b in placed_meshes(model.bodies)]
        ties = model.foot_meshes(process.orientation)
        make = _sliced if has_slicer else _guessed
        made = make(name, [*meshes, *ties], printer, progress, speed)
        cut = sum(tie.volume for tie in ties)  # comes off as waste
        found.append(replace(made, waste=made.waste + cut) if cut else made)
    best = min((m.seconds for m in found if m.fits), default=None)
    return [replace(m, is_best=m.fits and m.seconds == best) for m in found]


def _model(hinge_set, name):
    """The model of the object by another process, its numbers as they are."""
    order = hinge_set.Proxy.order(hinge_set)
    given = order.parameters
    ribs = given.standoffs or StandOffs(
        width=LINE_IN_NOZZLES * given.nozzle_diameter,
        air_layers=usual_air(given.layer_height, given.gap_between_planes),
    )
    wanted = ribs if PROCESSES[name].held == BY_STANDOFFS and given.has_knuckles else None
    given = replace(given, process=name, standoffs=wanted)
    if given == order.parameters:
        return hinge_set.Proxy.model(hinge_set)
    return replace(order, parameters=given).made()


def _sliced(name, meshes, printer, progress, speed):
    extra = {**SPEEDS[speed], **for_process(name)}
    made, _ = sliced_as(name, meshes, printer, progress, extra)
    return Mode(
        name, made.seconds, made.model, made.support, made.changes, made.size[2], made.fits, False
    )


def _guessed(name, meshes, printer, _progress, speed):
    made = guess(meshes, printer, speed)
    bounds = np.array([mesh.bounds for mesh in meshes])
    size = bounds[:, 1].max(0) - bounds[:, 0].min(0)
    room = printer.bed
    fits = sorted(size[:2]) <= sorted((room.width, room.depth)) and size[2] <= room.height
    unknown = PROCESSES[name].held == BY_SUPPORT
    nothing = None if unknown else 0
    return Mode(name, made.seconds, made.volume, nothing, nothing, float(size[2]), fits, True)


def section(found, speed="quality"):
    """`Section` of `Mode`s: a table for people, the best marked."""
    is_guess = found[0].is_guess
    if speed == "quality":
        text = phrase(
            "At quality speeds, estimated, without a slicer."
            if is_guess
            else "At quality speeds, as PrusaSlicer reckons."
        )
    else:
        text = phrase(
            "At fast speeds, estimated, without a slicer."
            if is_guess
            else "At fast speeds, as PrusaSlicer reckons."
        )
    return Section(phrase("Ways to print it"), text, _COLUMNS, [_row(mode) for mode in found])


def _row(mode):
    process, time = Choice(mode.process), duration(mode.seconds)
    height = f"{mode.height:.1f} mm"
    return [
        phrase("{process} (best)", process=process) if mode.is_best else process,
        phrase("about {time}", time=time) if mode.is_guess else time,
        volume(mode.plastic),
        "–" if mode.waste is None else volume(mode.waste),
        "–" if mode.changes is None else str(mode.changes),
        height if mode.fits else phrase("{height} (too large)", height=height),
    ]
