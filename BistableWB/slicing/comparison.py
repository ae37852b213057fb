# SPDX-License-Identifier: LGPL-2.1-or-later
"""The flat-folded print against the same bodies printed deployed, by PrusaSlicer's own reckoning.

All are sliced with the same settings (`profile`): soluble support wherever the slicer wants some,
the only way to fill the gaps of the flat print. Changing the material takes no time in these
numbers; how often it happens is counted. Runs inside FreeCAD.
"""

from dataclasses import dataclass, replace
from itertools import repeat

import numpy as np

from ..checks.printer import printer_of
from ..origami.errors import Phrase, Refusal, phrase
from ..origami.meshes import joined
from ..origami.progress import as_progress
from ..solids.matrices import array_of
from ..solids.tessellation import placed_meshes
from . import orientations
from .contact import contacts
from .profile import for_process, line_width
from .toolpaths import contact_findings, sliced

TRIES = 4  # deployed orientations that are sliced: those that look quickest
_NAMES = {"Flat": phrase("flat-folded"), "OnEdge": phrase("flat-folded, on edge")}


@dataclass(frozen=True)
class Sliced:
    """One way to print the bodies, as the slicer reckons it.

    ``seconds``; ``model`` and ``support``: filament, mm³; ``size`` (3,): extent of all that is
    laid, mm; ``layers``, those of the support between them too; ``changes`` of the material;
    ``fits``: whether it goes into the printer.
    """

    name: Phrase | str
    seconds: float
    model: float
    support: float
    size: tuple
    layers: int
    changes: int
    fits: bool

    @property
    def footprint(self):
        """Area of the rectangle that it takes on the bed, mm²."""
        return self.size[0] * self.size[1]


@dataclass(frozen=True)
class Comparison:
    """Ways to print the same bodies, and what the toolpaths show.

    ``flat``: the print as the HingeSet has it; ``other``: flat-folded the other way up;
    ``deployed``: the orientations tried, the quickest first (`Sliced`, all of them); ``contacts``:
    `contact.Contact`s and ``findings``: `Finding`s on the toolpaths of ``flat``.
    """

    flat: Sliced
    other: Sliced
    deployed: tuple
    contacts: list
    findings: list

    @property
    def prints(self):
        """All of them, the print itself first."""
        return [self.flat, self.other, *self.deployed]


def compare(hinge_set, progress=None, printer=None, tries=TRIES):
    """`Comparison` of a recomputed HingeSet: a minute for a unit, many minutes for a tube.

    ``progress``: a `Progress` (or a function that takes a text), asked several times a second;
    where it raises `Cancelled`, the slicer is ended. ``printer``: `checks.printer.Printer`, that
    of the object if not given; ``tries``: how many deployed orientations are sliced.
    `prusaslicer.NoSlicer` where there is none; ValueError where hinges are flexible or the slicer
    refuses.
    """
    progress = as_progress(progress)
    model, printer = hinge_set.Proxy.model(hinge_set), printer or printer_of(hinge_set)
    if not model.parameters.has_knuckles:
        raise Refusal(
            "{HingeType} of {label} is Flexible: strips that bend have no deployed solid to "
            "slice, set {HingeType} to Rotational.",
            parameter="HingeType",
            label=hinge_set.Label,
        )
    bodies = placed_meshes(model.bodies)
    ways = {way: _moved(bodies, repeat(array_of(model.standing(way)))) for way in _NAMES}
    chosen = ways.pop(hinge_set.Orientation)
    own = for_process(model.parameters.process)
    flat, lines = sliced_as(_NAMES[hinge_set.Orientation], chosen, printer, progress, own)
    told = progress.named("toolpaths of bodies that move")
    found = contacts(lines, chosen, printer.layer_height, told)
    ((way, meshes),) = ways.items()
    other, _ = sliced_as(_NAMES[way], meshes, printer, progress)
    opened = _moved(bodies, model.motions(1))
    return Comparison(
        flat,
        other,
        _deployed(opened, printer, progress, tries),
        found,
        contact_findings(found, bodies, model.parameters),
    )


def _deployed(opened, printer, progress, tries):
    """`Sliced` of the deployed meshes in the orientations that look best, the quickest first."""
    made, ways = [], orientations.best_guesses(joined(opened), tries, printer.steepest)
    for k, turn in enumerate(ways, 1):
        move = np.eye(4)
        move[:3, :3] = turn
        meshes = [mesh.moved(move) for mesh in opened]
        name = phrase("deployed, way {number}", number=k)
        made.append(sliced_as(name, meshes, printer, progress)[0])
    made.sort(key=lambda one: one.seconds)
    names = (phrase("deployed {number}", number=k) for k in range(1, len(made) + 1))
    return tuple(replace(one, name=name) for one, name in zip(made, names, strict=True))


def sliced_as(name, meshes, printer, progress, extra=None):
    """(`Sliced`, `gcode.Lines`) of meshes as they stand, with ``extra`` settings of the slicer."""
    told = progress.named(f"slicing {name}")
    lines, estimate = sliced(meshes, printer, told, (extra or {}).items())
    width, depth = np.ptp(lines.ends.reshape(-1, 2), axis=0) + line_width(printer)
    size = float(width), float(depth), float(np.ptp(lines.top)) + printer.layer_height
    model, support = (*estimate.volumes, 0.0)[:2]
    fits = _fits(size, printer.bed)
    numbers = size, estimate.layers, estimate.tool_changes, fits
    return Sliced(name, estimate.seconds, model, support, *numbers), lines


def _moved(bodies, motions):
    """Meshes of ``bodies``, each carried by its motion (4, 4)."""
    return [body.mesh.moved(m @ body.place) for body, m in zip(bodies, motions, strict=False)]


def _fits(size, room):
    """Whether it goes into the printer, along its sides or turned by a quarter."""
    low, high = sorted(size[:2])
    narrow, wide = sorted((room.width, room.depth))
    return low <= narrow and high <= wide and size[2] <= room.height
