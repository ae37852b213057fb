# SPDX-License-Identifier: LGPL-2.1-or-later
"""All checks of a print, in the order in which a panel, a report and the command line show them."""

from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from typing import NamedTuple

import numpy as np

from ..origami.creases import CREASES
from ..origami.hinge_parameters import FLEXIBLE
from ..origami.thick_tube import ThickTube
from ..solids.mesh import Mesh
from . import walls
from .bed import check_bed
from .findings import ERROR, NOTE, WARNING, Finding
from .layering import Layering
from .printing import Print
from .snapping import check_snap

OPENINGS = (0.25, 0.5, 0.75, 1.0)  # at which bodies may overlap no more than the snap
_WALL_TOLERANCE = 0.03  # mm by which triangles cut into round walls
_CONE_TOLERANCE = 3.0  # degrees that triangles are steeper than a round cone


class Standing(NamedTuple):
    """How a print stands on the bed: ``turn`` (4, 4) from the flat one, and its support."""

    turn: np.ndarray
    on_edge: bool = False
    support: Mesh | None = None


class Suite:
    """The checks of one print.

    ``bodies``: `PlacedMesh` list, flat; ``volumes`` of their solids, mm³; ``parameters``:
    `HingeParameters`; ``printer``: `printer.Printer`; ``tube``: `ThickTube` and ``snap``:
    `origami.snap.Snap`, for all but coupons; ``standing``: `Standing`, flat if not given.
    """

    def __init__(self, bodies, volumes, parameters, printer, tube=None, snap=None, standing=None):
        self.bodies, self.volumes = list(bodies), list(volumes)
        self.parameters, self.printer = parameters, printer
        self.tube: ThickTube | None = tube
        self.snap = snap
        self.standing = standing or Standing(np.eye(4))
        self._print = None

    def steps(self):
        """(code, function that returns a list of `Finding`) of every check, the quick ones first.

        Codes: size, snap, solids, clearances, layers, walls, and overlaps with an opening in %.
        """
        if self.tube is not None:
            yield "size", self.check_size
            yield "snap", lambda: check_snap(self.snap)
        yield "solids", lambda: self._whole().check_soundness(self.volumes)
        yield "clearances", lambda: self._whole().check_flat(self.printer.resolution)
        yield "layers", self.check_layers
        yield "walls", self.check_walls
        if self.tube is not None and self.parameters.hinge_type != FLEXIBLE:
            for opening in OPENINGS:
                yield f"overlaps {opening:.0%}", lambda o=opening: self.check_pose(o)

    def findings(self):
        """`Finding` list of all steps."""
        return [finding for _, step in self.steps() for finding in step()]

    def check_size(self):
        """Whether it fits the bed."""
        given = self.printer.bed, self.tube.tube.incoming_left, self.standing.on_edge
        return check_bed(self.tube.thick, self.parameters, *given)

    def check_pose(self, opening):
        """Overlaps at an opening."""
        thick = self.tube.thick
        misfits = thick.misfit(opening).reshape(-1, len(CREASES))
        compensated = bool(np.any(thick.shifts))
        motions = self.tube.motions(opening)
        return self._whole().check_poses(motions, opening, misfits, compensated)

    def check_layers(self):
        """What the layers make of the print as it stands on the bed."""
        support = self.standing.support
        state = "off" if self.tube is not None and not self.standing.on_edge else "none"
        state = state if support is None else "on"
        return Layering(self.standing_bodies(), self.printer, support, state).findings()

    def check_walls(self):
        """Walls against the nozzle, floors against the layers, cones against the overhang."""
        bodies = self.standing_bodies()
        trees = self._whole().trees
        distinct = {}
        for body, tree in zip(bodies, trees, strict=True):
            upright = tuple(np.round(np.abs(body.place[2, :3]), 6))
            distinct.setdefault((id(tree), upright), (body, tree))
        with ThreadPoolExecutor(cpu_count()) as pool:
            found = list(pool.map(lambda pair: self._body_walls(*pair), distinct.values()))
        thin = [wall for made, _ in found for wall in made]
        cones = [cone for _, cone in found if cone]
        return [*self._wall_findings(thin), *self._cone_findings(cones)]

    def _body_walls(self, body, tree):
        reach = max(self.printer.nozzle_diameter, self.printer.layer_height)
        thin = walls.thinnest_walls(tree, body.place, reach)
        cone = walls.steepest_cone(body.placed)
        return [(wall, body.name) for wall in thin], cone and (*cone, body.name)

    def _wall_findings(self, thin):
        printer, found = self.printer, []
        for floor, what, least, limit in (
            (False, "wall", "nozzle", printer.nozzle_diameter),
            (True, "floor", "layer", printer.layer_height),
        ):
            short = [
                (wall.thickness, name, tuple(wall.point.tolist()))
                for wall, name in thin
                if wall.floor == floor and wall.thickness < limit - _WALL_TOLERANCE
            ]
            if short:
                thickness, name, _ = min(short)
                other = len(short) - 1
                more = f" (and of {other} other bod{'ies' if other > 1 else 'y'})" if other else ""
                found.append(Finding(
                    ERROR, "wall", (name,), thickness, limit,
                    f"A {what} of {name}{more} is {thickness:.2f} mm thick, less than the {least} "
                    f"of {limit:g} mm, and would be left out.",
                    "make FaceThickness larger", tuple(entry[2] for entry in sorted(short)[:20]),
                ))  # fmt: skip
        text = "No wall is thinner than the nozzle, no floor thinner than a layer."
        return found or [Finding(NOTE, "wall", (), None, printer.nozzle_diameter, text)]

    def _cone_findings(self, cones):
        if not cones:
            return []
        angle, point, name = max(cones, key=lambda entry: entry[0])
        steepest, where = self.printer.steepest, (tuple(point.tolist()),)
        if angle <= steepest + _CONE_TOLERANCE:
            text = (
                f"The cones hang over by {angle:.0f}° from the vertical and print without support."
            )
            return [Finding(NOTE, "cone", (), angle, steepest, text)]
        return [Finding(
            WARNING, "cone", (name,), angle, steepest,
            f"The cones of {name} hang over by {angle:.0f}° from the vertical, more than the "
            f"{steepest:g}° that print without support.",
            "set Orientation to Flat: on edge, slanted hinges lean their cones"
            if self.standing.on_edge
            else f"make ConeAngle {steepest:g}° or less",
            where,
        )]  # fmt: skip

    def standing_bodies(self):
        """`PlacedMesh` list of the bodies as they stand on the bed."""
        turn = self.standing.turn
        return [body._replace(place=turn @ body.place) for body in self.bodies]

    def _whole(self):
        """The `Print`, made when it is asked for first."""
        self._print = self._print or Print(self.bodies, self.parameters)
        return self._print
