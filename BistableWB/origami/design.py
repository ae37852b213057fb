# SPDX-License-Identifier: LGPL-2.1-or-later
"""The design of a tube as one value: from its inputs to placement, tube and thick tube.

    geometry = CurveGeometry(Bezier([(0, 0), (60, 120), (180, 120), (240, 0)]))
    design = TubeDesign(Placing(geometry, edge_length=40, gamma=radians(20), pitch=1.8))
    design.placement(), design.tube(), design.thick()

Designs are frozen and compare by value, curves too. What they find is remembered (`memory`), so
equality *is* the cache key: an equal design, made anew from the same inputs, solves nothing.
Lengths in mm, angles in radians.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .curves.placement import Placement, place
from .curves.rules import PAPER, PlacementRule
from .hinges.parameters import HingeParameters
from .memory import remembered
from .progress import NOBODY, Progress
from .snap.bearing import Preloader
from .snap.margin import barrier
from .thick.linkage import ThickUnit
from .thick.thick_tube import ThickTube, thick_tube
from .units import tube as tubes
from .units.angles import angles_for
from .units.certificate import certified
from .units.ratios import RatioRule

if TYPE_CHECKING:
    from .curves.curve import Curve

_SAMPLES = 129  # parameters at which curves are compared
_IN_A_PIECE = 5  # more of them in every piece of a curve made of pieces
_BARRIER_STEPS = 25
_SAME_PITCH = 1e-9  # mm


@dataclass(frozen=True, eq=False)
class CurveGeometry:
    """A curve as the mathematics wants it: ``curve`` in space, its family, its strip's legs.

    ``curve``: any object with ``point(s)`` for s in [0, 1]; ``family``: one of `families.FAMILIES`;
    ``legs`` as for `placement.place`. Curves are equal where they have the same points at the same
    parameters.
    """

    curve: Any
    family: str = "Plane"
    legs: tuple | None = None
    sphere_radius: float | None = None

    @property
    def ruling(self) -> tuple:
        """Its ``legs``; parallel to z where none are given."""
        return ("parallel", (0, 0, 1)) if self.legs is None else self.legs

    @cached_property
    def value(self) -> tuple:
        """What makes it this curve: comparable and hashable."""
        kind, vector = self.ruling
        legs = kind, np.asarray(vector, float).tobytes()
        return points_of(self.curve), self.family, legs, self.sphere_radius

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, CurveGeometry) and self.value == other.value)

    def __hash__(self) -> int:
        return hash(self.value)


def points_of(curve: "Curve") -> bytes:
    """Points of a curve that tell it from any other that is not equal to it."""
    s = np.linspace(0, 1, _SAMPLES)
    breaks = np.asarray(getattr(curve, "breaks", ()), float)
    if len(breaks) > 1:
        inner = np.linspace(0, 1, _IN_A_PIECE + 1)[:-1]
        pieces = breaks[:-1, None] + inner * np.diff(breaks)[:, None]
        s = np.union1d(s, np.clip(pieces, 0, 1))
    return np.asarray(curve.point(s), float).tobytes()


@dataclass(frozen=True)
class Placing:
    """Where triangles stand along a curve: the arguments of `placement.place`."""

    geometry: CurveGeometry
    edge_length: float = 40.0
    gamma: float = np.radians(20.0)
    pitch: float = 0.0
    flip: bool = False
    level: bool = False
    rule: PlacementRule = PAPER

    @remembered(16)
    def placement(self) -> Placement:
        """The `Placement`; ValueError where the triangles cannot follow the curve."""
        return self.placed()

    def placed(
        self, extra: NDArray | Sequence[Any] = (), near: Placement | None = None
    ) -> Placement:
        """The `Placement` with ``extra`` room for thick panels: not remembered.

        ``near``: the placement before, which it is to differ little from.
        """
        return place(
            self.geometry.curve,
            self.edge_length,
            self.gamma,
            self.pitch,
            self.geometry.legs,
            self.flip,
            extra,
            self.level,
            replace(self.rule, near=near) if near is not None else self.rule,
        )


@dataclass(frozen=True)
class Single:
    """One unit that stands by itself: opening angle ``theta``, base angle ``omega`` (π/2: plane).

    ``pitch`` (mm): of the panels that its ratio is chosen for.
    """

    theta: float
    edge_length: float = 60.0
    omega: float = np.pi / 2
    pitch: float = 0.0

    @property
    def family(self) -> str:
        """The family of surfaces that such units make."""
        return "Plane" if self.omega == np.pi / 2 else "Sphere"


@dataclass(frozen=True)
class Thickness:
    """Panels ``face`` thick with gaps ``gap`` between them (mm); ``compensate``: shift hinge axes.

    ``preload``: gap (mm) that they are shifted by further, so that deployed cones bear; None: as
    much for each unit as its cones need to bear. ``hinges``: whose cones; without them nothing says
    how preloaded units stand. What `TubeDesign.thick` needs of the hinges.
    """

    face: float = 1.2
    gap: float = 0.6
    compensate: bool = True
    preload: float | None = 0.0
    hinges: HingeParameters | None = None

    def __post_init__(self) -> None:
        """Stand-offs move no axis: tubes that differ in them only are solved once."""
        if self.hinges is not None and self.hinges.standoffs is not None:
            object.__setattr__(self, "hinges", replace(self.hinges, standoffs=None))

    @property
    def pitch(self) -> float:
        """Distance between the mid-planes of stacked panels (mm)."""
        return self.face + self.gap


@dataclass(frozen=True)
class TubeDesign:
    """All that shapes a tube, whatever its Deployment. ``height_ratio`` = ‖AB‖ / h.

    ``where``: a `Placing` along a curve, or a `Single` unit; ``thickness`` is only for `thick`.
    """

    where: Placing | Single
    rule: RatioRule = field(default_factory=RatioRule)
    height_ratio: float = 2.5
    thickness: Thickness | None = None

    @property
    def edge_length(self) -> float:
        """‖AB‖, mm."""
        return self.where.edge_length

    @property
    def pitch(self) -> float:
        """Pitch (mm) that placement and ratios allow for; 0 is the paper's rule."""
        return self.where.pitch

    @property
    def allows_for_thickness(self) -> bool:
        """Whether the triangles stand as panels of this thickness need it."""
        if self.thickness is None or not isinstance(self.where, Placing):
            return False
        return abs(self.pitch - self.thickness.pitch) < _SAME_PITCH

    def placement(self) -> Any:
        """The `Placement` along the curve, None for a single unit."""
        return self.where.placement() if isinstance(self.where, Placing) else None

    def tube(self) -> tubes.Tube:
        """The `Tube` of zero thickness; ValueError where units cannot be made."""
        return self.thin()._tube()

    def barriers(self) -> np.ndarray:
        """Energy barriers (n,) in EA·‖AB‖ of the symmetric units with the same θ and ratio."""
        return self.thin()._barriers()

    def thin(self) -> "TubeDesign":
        """The same design without thickness."""
        return self if self.thickness is None else self._thin

    @cached_property
    def _thin(self) -> "TubeDesign":
        return replace(self, thickness=None)

    @remembered(16)
    def _tube(self) -> tubes.Tube:
        if isinstance(self.where, Single):
            where = self.where
            unit = tubes.make_unit(
                where.family, np.array([where.theta]), where.edge_length, self.height_ratio,
                self.rule, where.omega,
            )  # fmt: skip
            tube = tubes.single(unit)
        else:
            tube = self._along(self.where.placement())
        leaves_open = self.rule.name == "Paper" and tube.unit.omega is not None
        return certified(tube, self.edge_length, self.pitch, leaves_open)

    @remembered(16)
    def _barriers(self) -> NDArray:
        unit = self.tube().unit
        theta = np.atleast_1d(unit.theta)
        ratio = np.maximum(np.broadcast_to(unit.ratio, theta.shape), np.sin(theta / 2))
        alpha, beta, _ = angles_for(theta, ratio)
        return barrier(alpha, beta, _BARRIER_STEPS)[0]

    def _along(self, placed: Placement, tuning: tubes.Tuning | None = None) -> tubes.Tube:
        where: Any = self.where  # never `Single`, which has a unit only
        geometry = where.geometry
        return tubes.along(
            placed, geometry.family, self.height_ratio, self.rule, geometry.sphere_radius, tuning
        )

    @remembered(6)
    def thick(self, progress: Progress = NOBODY) -> ThickTube:
        """The `ThickTube` of panels of ``thickness``, compensated so that it closes if so wished.

        Where the triangles allow for this thickness the whole tube follows the curve; else it
        strays (`ThickTube.deviation`). ValueError where panels are too thick.
        """
        if self.thickness is None:
            raise TypeError("This design has no thickness.")  # a mistake of the program
        t, g, compensate = self.thickness.face, self.thickness.gap, self.thickness.compensate
        preload = Preloader(self.thickness.preload, self.thickness.hinges)
        if self.allows_for_thickness:
            return thick_tube(self._placed_for, self._made_for, t, g, compensate, progress, preload)
        tube = self.tube()
        progress.step("Thick panels…")
        thick = ThickUnit(tube.unit, t, g)
        thick = preload(thick.compensated()) if compensate else thick
        return ThickTube(tube, thick, self.placement())

    def _placed_for(self, tuning: tubes.Tuning) -> Placement:
        """The placement with the room that panels ask for; without any it is the thin tube's."""
        where: Any = self.where
        if not tuning.extra.any():
            return where.placement()
        return where.placed(tuning.extra, tuning.near)

    def _made_for(self, placed: Placement, tuning: tubes.Tuning) -> tubes.Tube:
        """The tube as panels ask for; without any change it is the thin tube."""
        changed = tuning.extra.any() or tuning.sines.any()
        return self._along(placed, tuning) if changed else self.tube()
