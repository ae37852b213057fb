# SPDX-License-Identifier: LGPL-2.1-or-later
"""All checks of one print on its meshes: sound, separate when flat, free when it unfolds."""

import numpy as np

from ..origami.creases import BODIES, CREASES
from . import soundness
from .clearance import clearances
from .findings import ERROR, NOTE, WARNING, Finding
from .penetration import penetrations
from .trees import Scene, Tree

CLEARANCE_TOLERANCE = 0.02  # mm by which measured clearances may lie below the one asked for
OVERLAP_TOLERANCE = 0.01  # mm of overlap in the deployed state that is taken for rounding
_COMPENSATE = "switch Compensate on, so that the hinges close"
_UNITS_AT_ONCE = 2  # limits the memory
_HINGES = {frozenset(crease.bodies): k for k, crease in enumerate(CREASES)}


class Print:
    """The bodies of a print as meshes, with what the checks share.

    ``bodies``: `PlacedMesh` list; ``parameters``: `HingeParameters`.
    """

    def __init__(self, bodies, parameters):
        self.bodies, self.parameters = list(bodies), parameters
        known = {}
        for body in self.bodies:
            if id(body.mesh) not in known:
                known[id(body.mesh)] = Tree(body.mesh)
        self.trees = [known[id(body.mesh)] for body in self.bodies]
        self.first_unit = np.array([min(_units(body)) for body in self.bodies])
        self.last_unit = np.array([max(_units(body)) for body in self.bodies])

    def check_soundness(self, solid_volumes=None):
        """Findings on every mesh; ``solid_volumes`` (mm³, one a body) are compared if given."""
        found, seen = [], set()
        for k, (body, tree) in enumerate(zip(self.bodies, self.trees, strict=True)):
            if id(tree) not in seen:
                seen.add(id(tree))
                found += soundness.check_mesh(body.name, body.mesh, tree)
            if solid_volumes is not None:
                found += soundness.check_volume(body.name, body.mesh, solid_volumes[k])
        return found

    def check_flat(self, resolution=0.0):
        """Findings: any two bodies nearer than the smallest clearance; else one note, the least.

        Clearances that are as asked for but below the printer's ``resolution`` (mm) are errors too.
        """
        asked = self.parameters.smallest_clearance
        limit = max(asked - CLEARANCE_TOLERANCE, resolution)
        reach = max(asked + CLEARANCE_TOLERANCE, resolution)
        least, found = np.inf, []
        for scene, pairs, names in self._scenes(None, reach):
            result = clearances(scene, reach, pairs)
            least = min(least, result.distances.min(initial=np.inf))
            for row in np.flatnonzero(result.distances < limit):
                bodies = [names[i] for i in result.pairs[row]]
                found.append(
                    self._too_near(bodies, result.distances[row], result.points[row], resolution)
                )
        if found:
            return sorted(found, key=lambda finding: finding.number)
        number = None if least == np.inf else float(least)
        text = f"at least {asked:.3f} mm" if number is None else f"{least:.3f} mm"
        return [
            Finding(
                NOTE,
                "clearance",
                (),
                number,
                asked,
                f"The nearest two moving bodies are {text} apart in the flat print.",
            )
        ]

    def check_poses(self, motions, opening, misfits=None, compensated=True):
        """Findings on bodies that overlap at an opening (0 flat, 1 deployed).

        ``motions`` (units, 15, 4, 4) from `print_stack.motions`. Deployed nothing may overlap; on
        the way no overlap may be deeper than the play of a hinge. Two bodies of one hinge may
        overlap by its misfit, if given (``misfits`` (units, 23) mm, `ThickUnit.misfit`): that is
        the snap, which the bodies take up by bending. Not ``compensated`` units overlap because
        they do not close.
        """
        limit = OVERLAP_TOLERANCE if opening in (0, 1) else self.parameters.play
        found, deepest = [], 0.0
        for scene, pairs, names in self._scenes(motions, 0.0):
            result = penetrations(scene, pairs)
            deepest = max(deepest, result.depths.max(initial=0))
            for row in np.flatnonzero(result.depths > limit):
                bodies = [names[i] for i in result.pairs[row]]
                depth, own = result.depths[row], max(limit, _misfit(bodies, misfits))
                if depth > own:
                    cure = cure_for(bodies, self.parameters)
                    cure = cure if compensated or opening == 0 else _COMPENSATE
                    found.append(_overlap(bodies, depth, own, opening, cure, result.points[row]))
        if found:
            return sorted(found, key=lambda finding: -finding.number)
        text = f"overlap by at most {deepest:.3f} mm" if deepest else "do not overlap"
        return [
            Finding(
                NOTE,
                "overlap",
                (),
                float(deepest),
                limit,
                f"Bodies {text} when opened to {opening:.0%}.",
            )
        ]

    def _scenes(self, motions, reach):
        """Scenes of a few units and the next one: scene, pairs of rigid bodies, bodies."""
        for low in range(0, int(self.last_unit.max()) + 1, _UNITS_AT_ONCE):
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
            yield (
                scene,
                pairs[(start >= low) & (start < high) & (apart <= 1) & rigid[a] & rigid[b]],
                bodies,
            )

    @staticmethod
    def _pose(body, motions):
        if motions is None or not body.members:
            return body.place
        unit, name = body.members[0]
        return motions[unit, BODIES.index(name)] @ body.place

    def _too_near(self, bodies, distance, point, resolution):
        asked, names = self.parameters.smallest_clearance, [body.name for body in bodies]
        state = f"{distance:.3f} mm apart" if distance > 0 else "in contact"
        least = f"{asked:.3g} mm asked for"
        if asked - CLEARANCE_TOLERANCE < resolution:
            least = f"{resolution:.3g} mm that a slicer keeps open"
        return Finding(
            ERROR, "clearance", tuple(names), float(distance), max(asked, resolution),
            f"{names[0]} and {names[1]} are {state} in the flat print, less than the {least}, and "
            "would fuse.",
            cure_for(bodies, self.parameters), _points(point), 0.0,
        )  # fmt: skip


def _overlap(bodies, depth, limit, opening, cure, point):
    names = [body.name for body in bodies]
    asked = f"more than {limit:.3g} mm of play and snap" if opening not in (0, 1) else "at rest"
    return Finding(
        ERROR if opening in (0, 1) else WARNING, "overlap", tuple(names), float(depth), limit,
        f"{names[0]} and {names[1]} run {depth:.3f} mm into each other when opened to "
        f"{opening:.0%}, {asked}.",
        cure, _points(point), float(opening),
    )  # fmt: skip


def _units(body):
    return [unit for unit, _ in body.members] or [body.unit]


def _points(point):
    return () if np.isnan(point).any() else (tuple(point.tolist()),)


def common_hinges(bodies):
    """(unit, index of the hinge) of all hinges between two bodies."""
    return [
        (unit, _HINGES[frozenset((one, two))])
        for unit, one in bodies[0].members
        for other, two in bodies[1].members
        if unit == other and frozenset((one, two)) in _HINGES
    ]


def _misfit(bodies, misfits):
    """Largest misfit (mm) of the hinges between two bodies; 0 if they have none."""
    if misfits is None:
        return 0.0
    return max((float(misfits[place]) for place in common_hinges(bodies)), default=0.0)


def cure_for(bodies, parameters):
    """The parameter that keeps two bodies apart: of their common hinge, or between layers."""
    if common_hinges(bodies):
        return f"make GapLength larger than {parameters.gap_length:.3g} mm"
    return (
        f"make GapBetweenPlanes larger than {parameters.gap_between_planes:.3g} mm, or EdgeLength "
        "longer"
    )
