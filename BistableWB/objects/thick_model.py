# SPDX-License-Identifier: LGPL-2.1-or-later
"""The model of a print: all bodies of a thick tube, and where they stand in any state.

Nothing here touches a document, so a model can be made in a thread of its own.
"""

import hashlib
from dataclasses import dataclass, field, fields, is_dataclass, replace
from functools import cached_property

import FreeCAD as App
import numpy as np
import Part

from ..origami.design import Placing, TubeDesign
from ..origami.errors import gathered, phrase
from ..origami.hinges.edge_turn import best_turn, standing
from ..origami.hinges.ends import Ends, stands_out
from ..origami.hinges.meshing import mesh_of
from ..origami.hinges.parameters import HingeParameters
from ..origami.hinges.parts import part_drawn
from ..origami.hinges.propping import propped_print
from ..origami.hinges.tying import tied
from ..origami.meshes import PlacedMesh
from ..origami.progress import NOBODY
from ..origami.snap.contact import holding
from ..origami.snap.margin import assess
from ..origami.thick.preload import without
from ..origami.units.creases import BODIES
from ..solids.matrices import array_of, placement_of
from ..solids.shapes import adopt, shape_of
from ..solids.support import support_body
from ..solids.tube import bodies_of
from .print_limits import check_bed_of, size_of, units_of

_OFF_CURVE = 0.01  # of ‖AB‖: further off is worth a warning
_SOLVING = 0.3  # of the time that a model takes
_MAKING = 0.5  # the same, until its solids are made, where ties follow
_MAKER = "2"  # of solids; another number where other solids are made of the same inputs


@dataclass(frozen=True)
class Order:
    """What a print is made by; equal orders make equal models.

    ``units``: the properties FirstUnit and LastUnit; ``room``: Bed and Orientation, which only
    decide whether it is refused; ``triangles``: label of the placement, for sentences; ``ends``:
    joint and end parts.
    """

    design: TubeDesign
    parameters: HingeParameters
    units: tuple
    room: tuple
    triangles: str = ""
    ends: Ends = field(default_factory=Ends)

    def _value(self):
        value = self.design, self.parameters, self.units
        return value if self.ends == Ends() else (*value, self.ends)

    def __eq__(self, other):
        return isinstance(other, Order) and self._value() == other._value()

    def __hash__(self):
        return hash(self._value())

    @property
    def digest(self):
        """A short text that equal orders have in common, in another session too."""
        text = repr((_MAKER, _plain(self._value())))
        return hashlib.sha256(text.encode()).hexdigest()[:32]

    def made(self, progress=NOBODY, saved=()):
        """The `Model`; `Refusal` where it cannot be, `Cancelled` where ``progress`` ends it.

        ``saved``: solids that a file keeps of an equal order; they are not made again.
        """
        self.parameters.check()
        whole = self.design.thick(progress.part(0, _SOLVING))
        first, last = units_of(self.units, len(whole.tube))
        part = whole.part(first, last)
        check_bed_of(part, self)
        notes, left = [], whole.tube.incoming_left
        is_tied = self.parameters.is_tied and self.room[1] == "OnEdge"
        rest = progress.part(_SOLVING, _MAKING if is_tied else 1)
        drawn, lift = part_drawn(
            whole.thick, self.parameters, first, last, left, rest, self.ends, whole.is_closed,
            notes, part.motions(1.0) if self.ends.has_feet else None,
        )  # fmt: skip
        part = replace(part, lift=lift)
        if len(saved) == len(drawn):
            for body, solid in zip(drawn, saved, strict=True):
                adopt(body.boundary, body.place, solid)
        bodies = bodies_of(drawn)
        warnings = _deviation_warnings(whole, self)
        model = Model(part, self.parameters, bodies, [*warnings, *gathered(notes)])
        model.more = stands_out(self.ends, self.parameters, whole.is_closed)
        if is_tied:
            model.tied(progress.part(_MAKING, 1))
        return model


def _plain(value):
    """Nested tuples of texts that are the same for values that differ by rounding only."""
    if hasattr(value, "value") and isinstance(value.value, tuple):  # a CurveGeometry
        return _plain(value.value)
    if is_dataclass(value):
        return type(value).__name__, *(_plain(getattr(value, f.name)) for f in fields(value))
    if isinstance(value, tuple):
        return tuple(_plain(item) for item in value)
    if isinstance(value, bytes):
        return _plain(tuple(np.frombuffer(value).tolist()))
    if isinstance(value, float):
        return f"{value:.9g}" if abs(value) > 1e-9 else "0"
    return repr(value)


class Model:
    """All bodies of a thick tube in the print frame, and where they stand in any state.

    Flexible strips (`Body.members` empty) bend, so they are there in the flat print only.
    """

    more = 0.0, 0.0  # by how much its ends widen the print and make it higher, mm
    _tied = None
    _propped = None
    studied = None  # conditions and `snap.study.Study`, once asked for

    def __init__(self, tube, parameters, bodies, warnings):
        self.tube, self.parameters, self.bodies = tube, parameters, bodies
        self._warnings = warnings
        self.deviation = tube.deviation()
        self.deployed_misfit = without(tube.thick).misfit(1.0).max()
        self.deployed_size = size_of(bodies, self.motions(1))
        self._size = size_of(bodies, [np.eye(4)] * len(bodies))
        self._compound = None
        self.findings = {}  # of checks: what they depend on besides -> {code: list}

    @property
    def preloads(self):
        """Gap lengths that the hinges of every unit take up when it is deployed."""
        rest = self.tube.thick.rest
        none = np.zeros(len(self.tube.thick))
        return (none if rest is None else rest.amounts / self.parameters.gap_length).tolist()

    @cached_property
    def snap(self):
        """The `Snap` of the units. It takes as long as the solids, so it follows them."""
        return assess(self.tube.thick, holding(self.tube.thick, self.parameters))

    @property
    def is_measured(self):
        """Whether `snap` is known."""
        return "snap" in self.__dict__

    @property
    def warnings(self):
        """What to look at before printing, as far as is known."""
        said = gathered(self.snap.warnings()) if self.is_measured else []
        return [*self.parameters.warnings(), *said, *self._warnings]

    def measured(self, progress=NOBODY):
        """The model itself, with its `snap`."""
        progress.step("Snap margins…")
        return self if self.snap is not None else None

    def has_ties(self, orientation):
        """Whether the print is held by ties in an orientation."""
        return self.parameters.is_tied and orientation == "OnEdge"

    @cached_property
    def edge_turn(self):
        """Turn (radians) about the stack of the print on edge, with which it wants fewest ties."""
        p = self.parameters
        if not p.is_tied:
            return 0.0
        return best_turn(self._drawn(np.eye(4)), p.layer_height, p.nozzle_diameter)

    def tied(self, progress=NOBODY):
        """`Tied`: the ties of the print on edge, as it stands on the bed; seconds a unit."""
        if self._tied is None:
            p, stand = self.parameters, array_of(self.standing("OnEdge"))
            self._tied = tied(self._drawn(stand), p.layer_height, p.nozzle_diameter, progress)
        return self._tied

    def tie_meshes(self):
        """`Mesh` of every tie, where it stands."""
        return [mesh_of(tie.boundary()).mesh for tie in self.tied().ties]

    def has_pillars(self, orientation):
        """Whether loose pillars hold what no stand-off can in the print."""
        return self.parameters.has_pillars and orientation == "Flat"

    def propped(self, progress=NOBODY):
        """`Propped`: the pillars of the flat print; a third of a second a unit."""
        if self._propped is None:
            self._propped = propped_print(self.bodies, self.parameters, progress)
        return self._propped

    @property
    def is_propped(self):
        """Whether its pillars are known."""
        return self._propped is not None

    def with_pillars(self, progress=NOBODY):
        """The model itself, with its pillars known."""
        return self if self.propped(progress) else None

    def pillar_bodies(self):
        """`PlacedMesh` of every pillar, in the unit of what it holds."""
        found = self.propped()
        return [
            PlacedMesh(f"pillar{k}", mesh_of(boundary).mesh, np.eye(4),
                       self.bodies[pillar.holds].unit, (), "foot")
            for k, (pillar, boundary) in enumerate(
                zip(found.pillars, found.boundaries, strict=True), 1
            )
        ]  # fmt: skip

    def foot_meshes(self, orientation):
        """`Mesh` of every tie or pillar of a print, where it stands."""
        if self.has_ties(orientation):
            return self.tie_meshes()
        return [body.mesh for body in self.pillar_bodies()] if self.has_pillars(orientation) else []

    def _drawn(self, stand):
        """`PlacedMesh` of all bodies of the flat print, carried by ``stand`` (4, 4)."""
        return [
            PlacedMesh(body.name, mesh_of(body.boundary).mesh, stand @ body.place, body.unit,
                       body.members, body.kind)
            for body in self.bodies
        ]  # fmt: skip

    def print_size(self, orientation):
        """Length, width and height (mm) of the flat print in its orientation."""
        if orientation != "Flat" and self.edge_turn:
            stand = array_of(self.standing(orientation))
            return size_of(self.bodies, [stand] * len(self.bodies))
        x, y, z = self._size
        return (x, y, z) if orientation == "Flat" else (z, y, x)

    def motions(self, opening):
        """Motions (bodies, 4, 4) from the flat print to an opening; None for flexible strips."""
        return self._of_bodies(self.tube.motions(opening))

    @cached_property
    def unloaded(self):
        """The `ThickTube` without preload: rigid hinges close its loops in both stable states."""
        return replace(self.tube, thick=without(self.tube.thick))

    def unloaded_motions(self, opening):
        """`motions` of the tube without preload."""
        return self._of_bodies(self.unloaded.motions(opening))

    def extremes(self, slop):
        """Motions, as of `motions`, to both ends of a `snap.slop.Slop` of the deployed tube."""
        tube = self.tube
        ends = slop.extremes(tube.thick, tube.tube.incoming_left)
        if tube.placement is not None:
            ends = tube.onto_curve() @ ends
        return [self._of_bodies(each) for each in ends]

    def _of_bodies(self, found):
        return [_motion_of(body, found) for body in self.bodies]

    def shapes(self, opening, orientation="Flat"):
        """Shapes of the bodies at an opening; at 0 all of them, in the orientation of the print."""
        if opening == 0:
            turn = self.standing(orientation)
            return [_moved(body.shape, turn) for body in self.bodies]
        return [
            _moved(body.shape, placement_of(motion))
            for body, motion in zip(self.bodies, self.motions(opening), strict=True)
            if motion is not None
        ]

    def compound(self, opening, orientation="Flat"):
        """`shapes` as one, from memory if they were the last ones asked for."""
        wanted = opening, orientation
        if self._compound is None or self._compound[0] != wanted:
            self._compound = wanted, Part.makeCompound(self.shapes(opening, orientation))
        return self._compound[1]

    def standing(self, orientation):
        """Placement of the flat print on the bed: as it is, or on the ends of its layers."""
        if orientation == "Flat":
            return App.Placement()
        if self.edge_turn:
            turn = standing(self.edge_turn)
            low = min(body.boundary.bounds(turn @ body.place)[0, 2] for body in self.bodies)
            turn[2, 3] = -low
            return placement_of(turn)
        turn = App.Placement(App.Vector(), App.Rotation(App.Vector(0, 1, 0), -90))
        low = min(body.shape.BoundBox.XMin for body in self.bodies)
        return App.Placement(App.Vector(0, 0, -low), App.Rotation()) * turn

    def tie_shape(self):
        """Shape of all ties, where they stand."""
        return Part.makeCompound([shape_of(tie.boundary()) for tie in self.tied().ties])

    def pillar_shape(self):
        """Shape of all pillars, where they stand."""
        return Part.makeCompound([shape_of(one) for one in self.propped().boundaries])

    def support(self):
        """Shape of the soluble support in the print frame."""
        tube = self.tube
        found = support_body(tube.thick, self.parameters, tube.tube.incoming_left).shape
        return _moved(found, App.Placement(App.Vector(0, 0, tube.lift), App.Rotation()))


def _motion_of(body, found):
    """Of one body, from ``found`` (units, 15, 4, 4); None for what bends."""
    if body.seat is not None:
        unit, name, onto = body.seat
        return found[unit, BODIES.index(name)] @ onto
    if not body.members:
        return None
    unit, name = body.members[0]
    return found[unit, BODIES.index(name)]


def _moved(shape, placement):
    moved = Part.Shape(shape)
    moved.Placement = placement * moved.Placement
    return moved


def _deviation_warnings(tube, order):
    off, design = tube.deviation(), order.design
    if off <= _OFF_CURVE * design.edge_length:
        return []
    cure = phrase(": compensate")
    if isinstance(design.where, Placing) and not design.allows_for_thickness:
        cure = phrase(
            "; set {Thickness} of {label} to {pitch:.4g} mm",
            label=order.triangles,
            pitch=design.thickness.pitch,
        )
    return [
        phrase(
            "Deployed, the tube strays up to {off:.3g} mm from its curve{cure}.",
            off=off,
            cure=cure,
        )
    ]
