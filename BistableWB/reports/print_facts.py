# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is made and told of a hinged print: numbers, findings of the checks, pictures.

Works on the recomputed HingeSet or HingeCoupon of a design; runs inside FreeCAD.
"""

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from .. import checking, pictures
from ..checks import ERROR, WARNING, Finding
from ..objects.refused import warnings_of
from ..origami import rigid
from ..origami.errors import phrase
from ..origami.meshes import PlacedMesh
from ..origami.progress import NOBODY
from ..origami.snap.margin import energy_path
from ..origami.thick import print_stack
from ..origami.thick.linkage import ThickUnit
from ..origami.units.creases import CREASES
from ..solids.matrices import array_of
from ..solids.tessellation import VIEW, placed_meshes
from .snap_section import snap_section
from .tie_section import pillar_section, tie_section

_OPENINGS = (0, 0.25, 0.5, 0.75, 1)
_CLOSE_UP = "AP_left_upper"  # the hinge of the close-up
_FINE = 0.02, 0.12  # deflections of the close-up, mm and radians


@dataclass(frozen=True)
class PrintFacts:
    """(name, value) pairs, `Finding` list, and a table of units: texts and phrases.

    ``sections``: more of them, with a title and a text (`slicing.section.Section`).
    """

    numbers: list
    findings: list
    columns: list
    rows: list
    sections: list = field(default_factory=list)

    @property
    def errors(self):
        """Findings on what makes the print fail."""
        return [finding for finding in self.findings if finding.severity == ERROR]


class HingedTube:
    """A HingeSet object with the meshes of its bodies, which pictures and checks share."""

    def __init__(self, obj):
        self.obj, self.model = obj, obj.Proxy.model(obj)

    @cached_property
    def meshes(self):
        """`PlacedMesh` of every body in the print frame."""
        return placed_meshes(self.model.bodies)

    def facts(self, progress=NOBODY):
        """`PrintFacts` by the object's results and the checks on its meshes.

        ``progress`` steps after every check.
        """
        return PrintFacts(
            [*_size_numbers(self.obj, self._volume), *self._motion_numbers()],
            [*_warnings(self.obj), *_found(self.obj, self.model.bodies, self.meshes, progress)],
            [phrase("snap margin"), phrase("needed clearance")],
            self._rows(),
            self._sections(progress),
        )

    def _studied(self, progress=NOBODY):
        """How it snaps and stands."""
        return self.obj.Proxy.measure(self.obj, progress)

    def _sections(self, progress):
        progress.step("Will it snap, will it stand?")
        found = self._studied(progress)
        conditions = self.obj.Proxy.conditions(self.obj)
        told = [snap_section(found, conditions)]
        if self._has_ties:
            names = [body.name for body in self.model.bodies]
            given = names, self._volume, self.model.parameters, conditions.material
            told.append(tie_section(self.model.tied(), *given))
        if self.model.has_pillars(self.obj.Orientation):
            propped = self.model.propped(progress)
            told += [pillar_section(propped, self._volume)] * bool(propped.pillars)
        return told

    @property
    def _has_ties(self):
        return self.model.has_ties(self.obj.Orientation)

    def draw(self, draw):
        """The pictures; ``draw(name, caption, function, *args)`` makes one."""
        model, tube = self.model, self.model.tube
        view = _upright(tube)
        stand = array_of(model.standing(self.obj.Orientation))
        draw(
            "print",
            phrase("The flat-folded print and the deployed tube, in one light, at one scale"),
            pictures.stack_and_tube,
            self.meshes,
            model.motions(1),
            *view,
            stand,
        )
        if self._has_ties:
            stood = [body._replace(place=stand @ body.place) for body in self.meshes]
            ties = [
                PlacedMesh(f"tie{k}", mesh, np.eye(4), 0, (), "foot")
                for k, mesh in enumerate(self.model.tie_meshes())
            ]
            draw(
                "ties",
                phrase("The print on edge with its ties, green: where to cut"),
                pictures.print_with_ties,
                stood,
                ties,
            )
        self._draw_snap(draw)
        first = [k for k, body in enumerate(model.bodies) if body.unit == 0]
        bodies = [self.meshes[k] for k in first]
        states = {o: _held(model.motions(o), first) for o in _OPENINGS}
        draw(
            "opening",
            phrase("The first unit on its way from flat to deployed"),
            pictures.openings,
            bodies,
            states,
        )
        if model.parameters.has_knuckles:
            fine = placed_meshes([model.bodies[k] for k in first], *_FINE)
            pair, axis = _hinge(model, fine)
            draw(
                "hinge",
                phrase("A hinge close up, and cut along its axis"),
                pictures.hinge_detail,
                fine,
                states[1],
                pair,
                axis,
                model.parameters,
            )

    def film(self, path):
        """The print on its way from flat to deployed and back, as a GIF; returns the path."""
        coarse = placed_meshes(self.model.bodies, *VIEW)
        view = _upright(self.model.tube)
        return pictures.deployment(path, coarse, self.model.motions, *view)

    def _draw_snap(self, draw):
        """Snap margin of every unit, and the energy that it has to pass without thickness."""
        draw(
            "margins",
            phrase("Snap margin of every unit: below 1 it is floppy"),
            pictures.margin_chart,
            self.model.snap.margin,
        )
        found = self._studied()
        draw(
            "forces",
            phrase("Torque about the leg at B that opening and folding back take"),
            pictures.torque_chart,
            found.units,
        )
        draw(
            "safety",
            phrase("Safety of every deployed unit against folding under the tube's weight"),
            pictures.safety_chart,
            found.load.factors,
        )
        if not found.flexible:
            draw(
                "slop",
                phrase("The deployed tube, and as ghosts how far its play lets it go"),
                pictures.slop_picture,
                self.meshes,
                self.model.motions(1),
                self.model.extremes(found.slop),
                found.slop.end,
            )
        unit = self.model.tube.tube.unit
        draw(
            "energy",
            phrase("Energy of the units, without thickness, on the way"),
            pictures.energy_chart,
            *energy_path(unit.alpha, unit.beta),
        )

    @cached_property
    def _volume(self):
        return sum(body.mesh.volume for body in self.meshes)

    def _motion_numbers(self):
        tube, snap = self.model.tube, self.model.snap
        raw = ThickUnit(tube.thick.unit, tube.thick.face_thickness,
                        tube.thick.gap_between_planes)  # fmt: skip
        before, after = raw.misfit(1.0).max(), self.obj.DeployedMisfit.Value
        numbers = [
            (phrase("deployed"), _millimetres(self.obj.DeployedSize)),
            (phrase("misfit without compensation"), f"{before:.2f} mm"),
            (phrase("misfit as made"), _small(after)),
            (phrase("snap margin"), _range(np.atleast_1d(snap.margin), "{:.2f}")),
        ]
        if tube.placement is not None:
            numbers.insert(1, (phrase("off the curve"), _small(self.obj.CurveDeviation.Value)))
        return numbers

    def _rows(self):
        snap = self.model.snap
        columns = (snap.margin, snap.needed_gap)
        return [
            [phrase("{margin:.2f} floppy", margin=m) if m < 1 else f"{m:.2f}", f"{d:.2f} mm"]
            for m, d in zip(*(np.atleast_1d(c) for c in columns), strict=True)
        ]


class Coupon:
    """A HingeCoupon object with the meshes of its bodies."""

    def __init__(self, obj):
        self.obj, self.bodies = obj, obj.Proxy.bodies(obj)

    @cached_property
    def meshes(self):
        """`PlacedMesh` of every body as printed, and as it is exported."""
        return placed_meshes(self.bodies)

    def facts(self, progress=NOBODY):
        """`PrintFacts` by the object's results and the checks on its meshes.

        ``progress`` steps after every check.
        """
        volume = sum(body.mesh.volume for body in self.meshes)
        findings = [
            *_warnings(self.obj),
            *_found(self.obj, self.bodies, self.meshes, progress),
        ]
        return PrintFacts(_size_numbers(self.obj, volume), findings, [], [])

    def draw(self, draw):
        """The picture; ``draw(name, caption, function, *args)`` makes it."""
        fine = placed_meshes(self.bodies, *_FINE)
        draw("coupon", phrase("The test print on its bed"), pictures.print_on_bed, fine)


def _size_numbers(obj, volume):
    return [
        (phrase("moving bodies"), str(obj.BodyCount)),
        (phrase("print"), _millimetres(obj.PrintSize)),
        (phrase("material"), f"{volume / 1000:.1f} cm³"),
    ]


def _found(obj, bodies, meshes, progress):
    found = []
    for code, check in checking.suite_of(obj, bodies, meshes).steps():
        found += check()
        progress.step(f"checked: {code}")
    return found


def _warnings(obj):
    return [
        Finding(
            severity=WARNING,
            code="warning",
            message=said,
        )
        for said in warnings_of(obj)
    ]


def _millimetres(vector):
    return f"{vector.x:.0f} × {vector.y:.0f} × {vector.z:.1f} mm"


def _small(length):
    return f"{length:.2g} mm" if length >= 0.001 else phrase("below 0.001 mm")


def _range(values, form):
    low, high = values.min(), values.max()
    if np.isinf(low):
        return phrase("no play")
    same = form.format(low) == form.format(high)
    return form.format(low) if same else f"{form.format(low)} … {form.format(high)}"


def _upright(tube):
    """Direction of the deployed tube's legs, and the horizontal one to look along; or None."""
    if tube.placement is None:
        return None, None
    return pictures.standing_view(tube.tube)


def _held(motions, chosen):
    """Motions of the ``chosen`` bodies while the first of them stays in its place."""
    back = np.linalg.inv(motions[chosen[0]])
    return [None if motions[k] is None else back @ motions[k] for k in chosen]


def _hinge(model, bodies):
    """Names of the two bodies of the close-up's hinge, and its axis (2, 3) in the print frame."""
    index = [crease.name for crease in CREASES].index(_CLOSE_UP)
    thick = model.tube.thick
    axes = np.asarray(thick.axes).reshape(-1, *np.shape(thick.axes)[-3:])
    place = print_stack.frames(thick, model.tube.tube.incoming_left)[0]
    pair = [
        body.name for name in CREASES[index].bodies for body in bodies if (0, name) in body.members
    ]
    return pair, rigid.apply(place, axes[0, index])
