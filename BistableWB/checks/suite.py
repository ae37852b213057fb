# SPDX-License-Identifier: LGPL-2.1-or-later
"""All checks of a print, in the order in which a panel, a report and the command line show them."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from os import cpu_count
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..origami.errors import ERROR, NOTE, WARNING, Finding, phrase
from ..origami.hinges.bed import check_bed
from ..origami.hinges.processes import BY_POWDER, BY_STANDOFFS, BY_TIES, PROCESSES
from ..origami.meshes import Mesh, joined
from ..origami.units.creases import CREASES
from . import walls
from .layering import Layering
from .printer import tighter_than_known
from .printing import Print
from .snapping import check_snap
from .soundness import check_mesh
from .table import ALL, CHECKS, TIED, TUBES
from .tying import check_ties

if TYPE_CHECKING:
    from ..origami.hinges.parameters import HingeParameters
    from ..origami.meshes import PlacedMesh
    from .bvh import Tree
    from .table import Check

_WALL_TOLERANCE = 0.03  # mm by which triangles cut into round walls
_CONE_TOLERANCE = 3.0  # degrees that triangles are steeper than a round cone

_THIN_WALL = (
    "A wall of {body}{more} is {thickness:.2f} mm thick, less than the nozzle of {limit:g} mm, and "
    "would be left out."
)
_THIN_FLOOR = (
    "A floor of {body}{more} is {thickness:.2f} mm thick, less than the layer of {limit:g} mm, and "
    "would be left out."
)


class Standing(NamedTuple):
    """How a print stands on the bed: ``turn`` (4, 4) from the flat one, and its support.

    ``more``: by how much its ends widen it and make it higher (mm), as of `bed.print_size`.
    ``ties``: where they stand, or None where nothing is to be tied; ``pillars``: finds the
    `PlacedMesh` of those that the print has.
    """

    turn: np.ndarray
    on_edge: bool = False
    support: Mesh | None = None
    more: tuple[float, float] = (0.0, 0.0)
    ties: tuple[Mesh, ...] | None = None
    pillars: "Callable[[], list[PlacedMesh]] | None" = None


class Suite:
    """The checks of one print.

    ``bodies``: `PlacedMesh` list, flat; ``volumes`` of their solids, mm³; ``parameters``:
    `HingeParameters`; ``printer``: `printer.Printer`; ``tube``: `ThickTube` and ``snap``:
    `margin.Snap`, for all but coupons; ``standing``: `Standing`, flat if not given; ``is_trial``:
    whether it is printed to see what fuses, which is no error then; ``known``: findings {code:
    list} of checks that were made already, which an equal suite may take over.
    """

    def __init__(
        self,
        bodies: "Sequence[PlacedMesh]",
        volumes: Sequence[float],
        parameters: "HingeParameters",
        printer: Any,
        tube: Any = None,
        snap: Any = None,
        standing: Standing | None = None,
        slacks: Sequence[float] | None = None,
    ) -> None:
        self.bodies, self.volumes, self.slacks = list(bodies), list(volumes), slacks
        self.parameters, self.printer = parameters, printer
        self.tube = tube
        self.snap = snap
        self.standing = standing or Standing(np.eye(4))
        self.is_trial = False
        self.known: dict[str, list[Finding]] = {}
        self._print: Any = None
        self._pass: Any = None

    def steps(self) -> Iterator[tuple[str, Callable[..., Any]]]:
        """(code, function that returns a list of `Finding`) of every check that applies.

        Codes are those of `table.CHECKS`; of a check at several openings with each in %.
        """
        for code, check in CHECKS.items():
            if not self._is_for(check):
                continue
            method = getattr(self, check.method)
            if not check.openings:
                yield code, partial(self._once, code, method)
            for opening in check.openings:
                at = f"{code} {opening:.0%}"
                yield at, partial(self._once, at, method, opening)

    def _once(self, code: str, method: Callable[..., Any], *given: float) -> list[Finding]:
        """What a check finds, from ``known`` if it was asked before."""
        if code not in self.known:
            self.known[code] = list(method(*given))
        return list(self.known[code])

    def _is_for(self, check: "Check") -> bool:
        if self.tube is None:
            return check.of == ALL
        if check.of == TIED:
            return self.standing.ties is not None
        return check.of in (ALL, TUBES) or self.parameters.has_knuckles

    def findings(self) -> Any:
        """`Finding` list of all steps."""
        return [finding for _, step in self.steps() for finding in step()]

    def check_size(self) -> list[Finding]:
        """Whether it fits the bed."""
        given = self.printer.bed, self.tube.tube.incoming_left, self.standing.on_edge
        return check_bed(self.tube.thick, self.parameters, *given, self.standing.more)

    def check_snap(self) -> list[Finding]:
        """Whether the units snap."""
        return check_snap(self.snap)

    def check_solids(self) -> list[Any]:
        """Whether every body is a sound solid of the volume that it should have."""
        return self._whole().check_soundness(self.volumes, self._own()[0], self.slacks)

    def check_clearances(self) -> list[Finding] | None:
        """Distances of moving bodies in the flat print."""
        found = self._whole().check_flat(self.printer.resolution)
        return [*found, *tighter_than_known(self.parameters, self.printer)]

    def check_pose(self, opening: float) -> list[Finding]:
        """Overlaps at an opening."""
        thick = self.tube.thick
        misfits = thick.misfit(opening).reshape(-1, len(CREASES))
        compensated = bool(np.any(thick.shifts))
        motions = self.tube.motions(opening)
        pressed = thick.rest.pressed if opening == 1 and thick.rest is not None else None
        return self._whole().check_poses(motions, opening, misfits, compensated, pressed)

    def check_layers(self) -> list[Finding]:
        """What the layers make of the print as it stands on the bed."""
        support, ties = self.standing.support, self.standing.ties
        if ties:
            support = joined(list(ties) if support is None else [support, *ties])
        process = PROCESSES[self.parameters.process]
        state = "off" if self.tube is not None and not self.standing.on_edge else "none"
        if process.held == BY_STANDOFFS and self.parameters.standoffs is not None:
            state = "stand-offs"
        state = state if support is None else "on"
        alone = support is None and (state == "stand-offs" or process.held == BY_TIES)
        layering = Layering(self.printed_bodies(), self.printer, support, state, alone)
        found = [*layering.findings(), *self._pillar_notes()]
        if process.held == BY_POWDER:
            found = [finding for finding in found if finding.code not in ("overhang", "island")]
        if not self.is_trial:
            return found
        return [replace(f, severity=WARNING) if f.severity == ERROR else f for f in found]

    def _pillars(self) -> "list[PlacedMesh]":
        return self.standing.pillars() if self.standing.pillars is not None else []

    def _pillar_notes(self) -> list[Finding]:
        """What is to be taken out when the print is opened."""
        pillars = self._pillars()
        volume = sum(pillar.mesh.volume for pillar in pillars)
        note = phrase(
            "{count} loose pillars, {volume:.1f} cm³, hold what reaches beyond the panels below: "
            "they fall out when the tube is opened.",
            count=len(pillars),
            volume=volume / 1000,
        )
        number = volume / 1000
        return [Finding(severity=NOTE, code="pillar", number=number, message=note)] * bool(pillars)

    def check_ties(self) -> list[Finding]:
        """Whether ties hold what begins in mid-air, and come off."""
        printer, ties = self.printer, self.standing.ties or ()
        return check_ties(
            self.standing_bodies(), ties, printer.layer_height, printer.nozzle_diameter
        )

    def check_walls(self) -> list[Finding]:
        """Walls against the nozzle, floors against the layers, cones against the overhang."""
        _, thin, cones = self._own()
        return [*self._wall_findings(thin), *self._cone_findings(cones)]

    def _own(
        self,
    ) -> tuple[
        dict[int, list[Any]], list[tuple[walls.Wall, str]], list[tuple[float, NDArray, str]]
    ]:
        """What every mesh tells of itself, in one pass: (its findings, thin walls, cones).

        Copies tell the same, once for every way in which they stand; ``findings`` by id of tree.
        """
        if self._pass is None:
            alike: dict[Any, Any] = {}
            for body, tree in zip(self.standing_bodies(), self._whole().trees, strict=True):
                upright = tuple(np.round(np.abs(body.place[2, :3]), 6))
                alike.setdefault(id(tree), (tree, {}))[1].setdefault(upright, body)
            with ThreadPoolExecutor(cpu_count()) as pool:
                found = list(pool.map(lambda entry: self._own_of(*entry), alike.values()))
            sound = dict(zip(alike, (findings for findings, _, _ in found), strict=True))
            thin = [wall for _, made, _ in found for wall in made]
            self._pass = sound, thin, [cone for _, _, made in found for cone in made]
        return self._pass

    def _own_of(
        self, tree: "Tree", bodies: "Mapping[tuple[float, ...], PlacedMesh]"
    ) -> tuple[list[Any], list[tuple[walls.Wall, str]], list[tuple[float, NDArray, str]]]:
        """The same of one tree, whose copies ``bodies`` {way of standing: body}."""
        reach = max(self.printer.nozzle_diameter, self.printer.layer_height)
        thin, cones = [], []
        for body in bodies.values():
            thin += [(w, body.name) for w in walls.thinnest_walls(tree, body.place, reach)]
            cone = walls.steepest_cone(body.placed)
            cones += [(*cone, body.name)] if cone else []
        name = next(iter(bodies.values())).name
        findings = check_mesh(name, tree.mesh, tree)
        tree.forget()
        return findings, thin, cones

    def _wall_findings(self, thin: Sequence[tuple[walls.Wall, str]]) -> list[Finding]:
        printer, found = self.printer, []
        for floor, limit in (False, printer.nozzle_diameter), (True, printer.layer_height):
            short = [
                (wall.thickness, name, tuple(wall.point.tolist()))
                for wall, name in thin
                if wall.floor == floor and wall.thickness < limit - _WALL_TOLERANCE
            ]
            if short:
                thickness, name, _ = min(short)
                other = len(short) - 1
                more = phrase(
                    " (and of {count} other bodies)"
                    if other > 1
                    else " (and of {count} other body)",
                    count=other,
                )
                found.append(
                    Finding(
                        severity=ERROR,
                        code="wall",
                        bodies=(name,),
                        number=thickness,
                        limit=limit,
                        message=phrase(
                            _THIN_FLOOR if floor else _THIN_WALL,
                            body=name,
                            more=more if other else "",
                            thickness=thickness,
                            limit=limit,
                        ),
                        cure=phrase("make {FaceThickness} larger"),
                        points=tuple(entry[2] for entry in sorted(short)[:20]),
                    )
                )
        text = phrase("No wall is thinner than the nozzle, no floor thinner than a layer.")
        return found or [
            Finding(
                severity=NOTE,
                code="wall",
                limit=printer.nozzle_diameter,
                message=text,
            )
        ]

    def _cone_findings(self, cones: Sequence[tuple[float, NDArray, str]]) -> list[Finding]:
        if not cones:
            return []
        angle, point, name = max(cones, key=lambda entry: entry[0])
        steepest, where = self.printer.steepest, (tuple(point.tolist()),)
        if angle <= steepest + _CONE_TOLERANCE:
            text = phrase(
                "The cones hang over by {angle:.0f}° from the vertical and print without support.",
                angle=angle,
            )
            return [
                Finding(
                    severity=NOTE,
                    code="cone",
                    number=angle,
                    limit=steepest,
                    message=text,
                )
            ]
        return [
            Finding(
                severity=WARNING,
                code="cone",
                bodies=(name,),
                number=angle,
                limit=steepest,
                message=phrase(
                    "The cones of {name} hang over by {angle:.0f}° from the vertical, more "
                    "than the {steepest:g}° that print without support.",
                    name=name,
                    angle=angle,
                    steepest=steepest,
                ),
                cure=phrase(
                    "set {Orientation} to Flat: on edge, slanted hinges lean their cones"
                ).setting(Orientation="Flat")
                if self.standing.on_edge
                else phrase(
                    "make {ConeAngle} {steepest:g}° or less",
                    steepest=steepest,
                ).setting(ConeAngle=steepest),
                points=where,
            )
        ]

    def standing_bodies(self) -> "list[PlacedMesh]":
        """`PlacedMesh` list of the bodies as they stand on the bed."""
        turn = self.standing.turn
        return [body._replace(place=turn @ body.place) for body in self.bodies]

    def printed_bodies(self) -> "list[PlacedMesh]":
        """`standing_bodies` and the pillars that are printed with them."""
        return [*self.standing_bodies(), *self._pillars()]

    def _whole(self) -> Any:
        """The `Print`, made when it is asked for first."""
        self._print = self._print or Print(self.bodies, self.parameters)
        return self._print
