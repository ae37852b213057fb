# SPDX-License-Identifier: LGPL-2.1-or-later
"""All checks of one print on its meshes: sound, separate when flat, free when it unfolds."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..origami.errors import ERROR, NOTE, WARNING, Finding, phrase
from ..origami.units.creases import BODIES, CREASES
from . import soundness
from .bvh import Scene, Tree
from .clearance import clearances
from .penetration import penetrations

if TYPE_CHECKING:
    from ..origami.errors import Phrase
    from ..origami.hinges.parameters import HingeParameters
    from ..origami.meshes import PlacedMesh

CLEARANCE_TOLERANCE = 0.02  # mm by which measured clearances may lie below the one asked for
OVERLAP_TOLERANCE = 0.01  # mm of overlap in the deployed state that is taken for rounding
_COMPENSATE = phrase("switch {Compensate} on, so that the hinges close").setting(Compensate=True)
_LESS_PRELOAD = phrase(
    "set {Preload} to less than was found ({Preloads}), or {SegmentWidth} to 5 mm, so that cones "
    "at the ends of the hinges hold them"
)
_UNITS_AT_ONCE = 2  # limits the memory
_HINGES = {frozenset(crease.bodies): k for k, crease in enumerate(CREASES)}


class Print:
    """The bodies of a print as meshes, with what the checks share.

    ``bodies``: `PlacedMesh` list; ``parameters``: `HingeParameters`.
    """

    def __init__(self, bodies: "Sequence[PlacedMesh]", parameters: "HingeParameters") -> None:
        self.bodies, self.parameters = list(bodies), parameters
        known = {}
        for body in self.bodies:
            if id(body.mesh) not in known:
                known[id(body.mesh)] = Tree(body.mesh)
        self.trees = [known[id(body.mesh)] for body in self.bodies]
        self.first_unit = np.array([min(_units(body)) for body in self.bodies])
        self.last_unit = np.array([max(_units(body)) for body in self.bodies])

    def check_soundness(
        self,
        solid_volumes: Sequence[float] | None = None,
        known: Mapping[int, Sequence[Any]] | None = None,
        slacks: Sequence[float] | None = None,
    ) -> list[Finding]:
        """Findings on every mesh; ``solid_volumes`` (mm³, one a body) are compared if given.

        ``known``: findings {id of tree: list} on single meshes, if they were made already;
        ``slacks``: mm³ that the chords of round faces may take from each body.
        """
        found: Any
        found, seen = [], set()
        for k, (body, tree) in enumerate(zip(self.bodies, self.trees, strict=True)):
            if id(tree) not in seen:
                seen.add(id(tree))
                if known is not None:
                    found += known[id(tree)]
                else:
                    found += soundness.check_mesh(body.name, body.mesh, tree)
                    tree.forget()
            if solid_volumes is not None:
                slack = slacks[k] if slacks is not None else 0.0
                found += soundness.check_volume(body.name, body.mesh, solid_volumes[k], slack)
        return found

    def check_flat(self, resolution: float = 0.0) -> list[Finding] | None:
        """Findings: any two bodies nearer than the smallest clearance; else one note, the least.

        Clearances that are as asked for but below the printer's ``resolution`` (mm) are errors too.
        """
        asked = self.parameters.smallest_clearance
        limit = max(asked - CLEARANCE_TOLERANCE, resolution)
        reach = max(asked + CLEARANCE_TOLERANCE, resolution)
        least, found = np.inf, []
        for result, names in self._measured(
            None, reach, lambda *at: clearances(at[0], reach, at[1])
        ):
            least = min(least, result.distances.min(initial=np.inf))
            for row in np.flatnonzero(result.distances < limit):
                bodies = [names[i] for i in result.pairs[row]]
                found.append(
                    self._too_near(bodies, result.distances[row], result.points[row], resolution)
                )
        if found:
            return sorted(found, key=lambda finding: finding.number or 0.0)
        number = None if least == np.inf else float(least)
        text = phrase(
            "at least {distance:.3f} mm" if number is None else "{distance:.3f} mm",
            distance=asked if number is None else least,
        )
        return [
            Finding(
                severity=NOTE,
                code="clearance",
                number=number,
                limit=asked,
                message=phrase(
                    "The nearest two moving bodies are {distance} apart in the flat print.",
                    distance=text,
                ),
            )
        ]

    def check_poses(
        self,
        motions: NDArray,
        opening: float,
        misfits: NDArray | None = None,
        compensated: bool = True,
        pressed: NDArray | None = None,
    ) -> list[Finding]:
        """Findings on bodies that overlap at an opening (0 flat, 1 deployed).

        ``motions`` (units, 15, 4, 4) from `print_stack.motions`. Deployed nothing may overlap; on
        the way no overlap may be deeper than the play of a hinge. Two bodies of one hinge may
        overlap by its misfit, if given (``misfits`` (units, 23) mm, `ThickUnit.misfit`): that is
        the snap, which the bodies take up by bending. Preloaded, they press into each other when
        deployed, by ``pressed`` (units,) mm where only rigid bodies may move; misfits do not count
        then. Not ``compensated`` units overlap because they do not close.
        """
        limit = OVERLAP_TOLERANCE if opening in (0, 1) else self.parameters.play
        found, deepest = [], 0.0
        for result, names in self._measured(motions, 0.0, penetrations):
            deepest = max(deepest, result.depths.max(initial=0))
            for row in np.flatnonzero(result.depths > limit):
                bodies = [names[i] for i in result.pairs[row]]
                depth, own = result.depths[row], limit + _pressed(bodies, pressed)
                own = own if pressed is not None else max(limit, _misfit(bodies, misfits))
                if depth > own:
                    cure = cure_for(bodies, self.parameters)
                    cure = cure if compensated or opening == 0 else _COMPENSATE
                    cure = cure if pressed is None else _LESS_PRELOAD
                    found.append(_overlap(bodies, depth, own, opening, cure, result.points[row]))
        if found:
            return sorted(found, key=lambda finding: -(finding.number or 0.0))
        text = phrase(
            "overlap by at most {depth:.3f} mm" if deepest else "do not overlap", depth=deepest
        )
        if deepest > limit and pressed is not None:
            text = phrase(
                "press into each other by at most {depth:.3f} mm, their preload,", depth=deepest
            )
        return [
            Finding(
                severity=NOTE,
                code="overlap",
                number=float(deepest),
                limit=limit,
                message=phrase(
                    "Bodies {overlap} when opened to {opening:.0%}.",
                    overlap=text,
                    opening=opening,
                ),
            )
        ]

    def _measured(
        self,
        motions: NDArray | None,
        reach: float,
        measure: "Callable[[Scene, NDArray], Any]",
    ) -> "Iterator[tuple[Any, list[PlacedMesh]]]":
        """(``measure(scene, pairs)``, bodies) of the scenes of every few units and the next one."""
        starts = range(0, int(self.last_unit.max()) + 1, _UNITS_AT_ONCE)

        def of_units(low: int) -> Any:
            scene, pairs, bodies = self._scene(low, motions, reach)
            return measure(scene, pairs), bodies

        with ThreadPoolExecutor(cpu_count()) as pool:
            yield from pool.map(of_units, starts)

    def _scene(
        self, low: int, motions: NDArray | None, reach: float
    ) -> "tuple[Scene, NDArray, list[PlacedMesh]]":
        """The scene of a few units from ``low`` on and the next one, pairs of rigid bodies, bodies.

        Pairs of which both are in the next one belong to the scene after.
        """
        high = low + _UNITS_AT_ONCE
        chosen = np.flatnonzero((self.last_unit >= low) & (self.first_unit <= high))
        bodies = [self.bodies[i] for i in chosen]
        poses = [self._pose(body, motions) for body in bodies]
        scene = Scene([self.trees[i] for i in chosen], poses)
        pairs = scene.body_pairs(max(reach, 1e-6))
        first, last = self.first_unit[chosen], self.last_unit[chosen]
        a, b = pairs.T
        start = np.minimum(first[a], first[b])
        rigid = np.array([body.material == "rigid" for body in bodies])
        apart = np.maximum(first[a], first[b]) - np.minimum(last[a], last[b])
        mine = (start >= low) & (start < high) & (apart <= 1) & rigid[a] & rigid[b]
        return scene, pairs[mine], bodies

    @staticmethod
    def _pose(body: "PlacedMesh", motions: NDArray | None) -> NDArray:
        if motions is None or not body.members:
            return body.place
        unit, name = body.members[0]
        return motions[unit, BODIES.index(name)] @ body.place

    def _too_near(
        self, bodies: "Sequence[PlacedMesh]", distance: float, point: NDArray, resolution: float
    ) -> Finding:
        asked, names = self.parameters.smallest_clearance, [body.name for body in bodies]
        state = phrase(
            "{distance:.3f} mm apart" if distance > 0 else "in contact", distance=distance
        )
        least = phrase("{least:.3g} mm asked for", least=asked)
        if asked - CLEARANCE_TOLERANCE < resolution:
            least = phrase("{least:.3g} mm that a slicer keeps open", least=resolution)
        return Finding(
            severity=ERROR,
            code="clearance",
            bodies=tuple(names),
            number=float(distance),
            limit=max(asked, resolution),
            message=phrase(
                "{one} and {other} are {state} in the flat print, less than the "
                "{least}, and would fuse.",
                one=names[0],
                other=names[1],
                state=state,
                least=least,
            ),
            cure=cure_for(bodies, self.parameters),
            points=_points(point),
            opening=0.0,
        )


def _overlap(
    bodies: "Sequence[PlacedMesh]",
    depth: float,
    limit: float,
    opening: float,
    cure: "Phrase",
    point: NDArray,
) -> Finding:
    names = [body.name for body in bodies]
    asked = phrase(
        "more than {limit:.3g} mm of play and snap" if opening not in (0, 1) else "at rest",
        limit=limit,
    )
    return Finding(
        severity=ERROR if opening in (0, 1) else WARNING,
        code="overlap",
        bodies=tuple(names),
        number=float(depth),
        limit=limit,
        message=phrase(
            "{one} and {other} run {depth:.3f} mm into each other when opened to "
            "{opening:.0%}, {asked}.",
            one=names[0],
            other=names[1],
            depth=depth,
            opening=opening,
            asked=asked,
        ),
        cure=cure,
        points=_points(point),
        opening=float(opening),
    )


def _units(body: "PlacedMesh") -> list[int]:
    return [unit for unit, _ in body.members] or [body.unit]


def _points(point: NDArray) -> Any:
    return () if np.isnan(point).any() else (tuple(point.tolist()),)


def common_hinges(bodies: "Sequence[PlacedMesh]") -> list[tuple[int, int]]:
    """(unit, index of the hinge) of all hinges between two bodies."""
    return [
        (unit, _HINGES[frozenset((one, two))])
        for unit, one in bodies[0].members
        for other, two in bodies[1].members
        if unit == other and frozenset((one, two)) in _HINGES
    ]


def _misfit(bodies: "Sequence[PlacedMesh]", misfits: NDArray | None) -> float:
    """Largest misfit (mm) of the hinges between two bodies; 0 if they have none."""
    if misfits is None:
        return 0.0
    return max((float(misfits[place]) for place in common_hinges(bodies)), default=0.0)


def _pressed(bodies: "Sequence[PlacedMesh]", pressed: NDArray | None) -> float:
    """How deep (mm) preload may press two bodies of a unit into each other when deployed.

    Rigid ones, which only move; on a hinge, or on either side of a link. Twice what their cones
    press: knuckles tilt, and links have two hinges.
    """
    if pressed is None:
        return 0.0
    one, other = ({unit for unit, _ in body.members} for body in bodies)
    return 2 * max((float(pressed[unit]) for unit in one & other), default=0.0)


def cure_for(bodies: "Sequence[PlacedMesh]", parameters: "HingeParameters") -> "Phrase":
    """The parameter that keeps two bodies apart: of their common hinge, or between layers."""
    if common_hinges(bodies):
        return phrase("make {GapLength} larger than {gap:.3g} mm", gap=parameters.gap_length)
    return phrase(
        "make {GapBetweenPlanes} larger than {gap:.3g} mm, or {EdgeLength} longer",
        gap=parameters.gap_between_planes,
    )
