# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moving pictures of tubes: Coin nodes that follow an opening, without making shapes anew.

A motion has ``root`` (the node to show), ``show(opening, moving)`` and ``colour_by(what)``, one of
`COLOURS`, ``made_of``, the `Material` whose breaking strain is the full colour; nothing of it
touches the document.
"""

import numpy as np
from pivy import coin

from .. import colours, settings
from ..objects import type_of
from ..objects.base import global_placement
from ..objects.bistable_unit import tube_of
from ..objects.snap_results import conditions_of
from ..origami.snap.materials import PLA, material
from ..origami.units.creases import BODIES, CREASES, INDEX, PANELS, kind_of
from ..origami.units.deployment import misfit, panel_strains
from ..solids.matrices import array_of
from .body_nodes import FULL, MOVING, BodyNodes, meshed, sb_matrix

COLOURS = ("panels", "misfit", "strain")
_STEPS = 240  # openings that are computed; between them the vertices go straight
_GHOST, _PALE = colours.rgb("#5A6F80"), 0.8
_COOL, _WARM = np.array(colours.rgb("#DCE6EE")), np.array(colours.rgb("#C2185B"))


def motion_of(obj):
    """The motion of a BistableUnit or a HingeSet; ValueError where it cannot be computed."""
    if type_of(obj) == "Bistable::HingeSet":
        return BodiesMotion(obj)
    return FacesMotion(tube_of(obj), global_placement(obj) if obj.Triangles is None else None)


class FacesMotion:
    """Twelve faces a unit of a `Tube`; one array of vertices is exchanged for every state.

    ``placement``: where a tube that is not in global coordinates stands.
    """

    def __init__(self, tube, placement=None):
        self.tube, self.made_of = tube, material(PLA)  # thin panels are of nothing yet
        self._states = {}
        self._by, self._opening = "panels", 0.0
        self._lengths = None
        self.root = coin.SoSeparator()
        if placement is not None:
            self.root.addChild(_matrix_node(array_of(placement)))
        self.coordinates, self.material = coin.SoCoordinate3(), coin.SoMaterial()
        self._add_faces()
        self.misfit_limit = self._largest_misfit()

    def show(self, opening, moving=False):
        """Bring all faces to ``opening``; at rest as ``moving``."""
        self._opening = opening
        points = self.state(opening).reshape(-1, 3)
        self.coordinates.point.setValues(0, len(points), points.tolist())
        if self._by != "panels":
            self._colour()

    def state(self, opening):
        """Vertices (n, 10, 3) in global coordinates, from memory where they were asked for."""
        place = opening * _STEPS
        low = min(int(place), _STEPS - 1)
        share = place - low
        if share < 1e-6:
            return self._known(low)
        if share > 1 - 1e-6:
            return self._known(low + 1)
        return (1 - share) * self._known(low) + share * self._known(low + 1)

    def colour_by(self, what):
        """Colour by kind of panel, by the unit's misfit or by the panel's strain as it is open."""
        self._by = what
        self._colour()

    def misfit(self, opening):
        """Largest change of length in every unit, mm: (n,)."""
        return misfit(self.tube.unit, self.state(opening))

    def strain(self, opening):
        """Largest relative change of length in every panel: (n, 12)."""
        return panel_strains(self.tube.unit, self.state(opening))

    def _known(self, step):
        if step not in self._states:
            self._states[step] = self.tube.state(step / _STEPS)
        return self._states[step]

    def _largest_misfit(self):
        return max(float(self.misfit(k / 8).max()) for k in range(9)) or 1.0

    def _colour(self):
        if self._by == "panels":
            wanted = [settings.colour(kind_of(panel)) for panel in PANELS] * len(self.tube)
        elif self._by == "misfit":
            shares = self.misfit(self._opening) / self.misfit_limit
            wanted = np.repeat(_blend(shares), len(PANELS), axis=0).tolist()
        else:
            wanted = _blend(
                self.strain(self._opening).ravel() / self.made_of.breaking_strain
            ).tolist()
        self.material.diffuseColor.setNum(len(wanted))
        self.material.diffuseColor.setValues(0, len(wanted), wanted)

    def _add_faces(self):
        faces, outlines = [], []
        for unit in range(len(self.tube)):
            for corners in PANELS.values():
                rows = [10 * unit + INDEX[corner] for corner in corners]
                faces += [*rows, -1]
                outlines += [*rows, rows[0], -1]
        binding, face_set = coin.SoMaterialBinding(), coin.SoIndexedFaceSet()
        binding.value = coin.SoMaterialBinding.PER_FACE
        face_set.coordIndex.setValues(0, len(faces), faces)
        line_set = coin.SoIndexedLineSet()
        line_set.coordIndex.setValues(0, len(outlines), outlines)
        for node in (
            _two_sided(), self.coordinates, binding, self.material, _set_back(), face_set,
            *_thin_ink(), line_set,
        ):  # fmt: skip
            self.root.addChild(node)
        self._colour()


class BodiesMotion:
    """Thick bodies; every one has a transform of its own."""

    def __init__(self, obj):
        self.model = obj.Proxy.model(obj)
        self.tube, self.made_of = self.model.tube.tube, conditions_of(obj).material
        self._by, self._opening = "panels", 0.0
        self._motions, self.ghosts = {}, None
        self.root = coin.SoSeparator()
        self.root.addChild(_matrix_node(array_of(global_placement(obj))))
        self.nodes = BodyNodes(fast=True)
        self.nodes.show([meshed(body.shape) for body in self.model.bodies])
        self.root.addChild(self.nodes.faces)
        self._colour()
        self.misfit_limit = max(float(self._hinges(k / 8).max()) for k in range(9)) or 1.0

    def show(self, opening, moving=False):
        """Bring all bodies to ``opening``; while they are ``moving`` with less detail."""
        self._opening = opening
        self.nodes.detail(MOVING if moving else FULL)
        self.nodes.move(self._known(opening))
        if self._by != "panels":
            self._colour()

    def add_ghosts(self, slop):
        """Both ends of a `snap.slop.Slop`, pale; they are shown with the deployed state."""
        self.ghosts = coin.SoSwitch()
        self.root.addChild(self.ghosts)
        bodies = [meshed(body.shape) for body in self.model.bodies]
        for motions in self.model.extremes(slop):
            nodes = BodyNodes(fast=True)
            nodes.show([b for b, motion in zip(bodies, motions, strict=True) if motion is not None])
            there = [motion for motion in motions if motion is not None]
            for transform, motion in zip(nodes.transforms, there, strict=True):
                transform.matrix = sb_matrix(motion)
            nodes.colour([_GHOST], _PALE)
            self.ghosts.addChild(nodes.faces)

    def show_ghosts(self, are_shown):
        """Show or hide them, if there are any."""
        if self.ghosts is not None:
            self.ghosts.whichChild = coin.SO_SWITCH_ALL if are_shown else coin.SO_SWITCH_NONE

    def colour_by(self, what):
        """Colour by kind of panel, or by the misfit of a body's worst hinge or its strain by it."""
        self._by = what
        self._colour()

    def misfit(self, opening):
        """Largest misfit of the hinges of every unit, mm: (n,)."""
        return self._hinges(opening).max(1)

    def strain(self, opening):
        """Largest strain of every unit, by its hinges' misfit over ‖AB‖ (`margin.assess`): (n,)."""
        return self.misfit(opening) / self.tube.unit.edge_length

    def _hinges(self, opening):
        return self.model.tube.thick.misfit(opening).reshape(len(self.tube), -1)

    def _known(self, opening):
        step = round(opening * _STEPS)
        if step not in self._motions:
            self._motions[step] = [
                None if motion is None else sb_matrix(motion)
                for motion in self.model.motions(step / _STEPS)
            ]
        return self._motions[step]

    def _colour(self):
        wanted = [settings.colour(body.kind) for body in self.model.bodies]
        if self._by != "panels":
            full = self.made_of.breaking_strain * self.tube.unit.edge_length
            full = self.misfit_limit if self._by == "misfit" else full
            wanted = _blend(np.array(self._body_misfits()) / full).tolist()
        self.nodes.colour(wanted)

    def _body_misfits(self):
        hinges = self._hinges(self._opening)
        worst = np.zeros((len(hinges), len(BODIES)))
        for row, crease in enumerate(CREASES):
            for name in crease.bodies:
                column = BODIES.index(name)
                worst[:, column] = np.maximum(worst[:, column], hinges[:, row])
        return [
            max((worst[k, BODIES.index(name)] for k, name in body.members), default=0.0)
            for body in self.model.bodies
        ]


def _blend(shares):
    shares = np.clip(shares, 0, 1)[:, None]
    return (1 - shares) * _COOL + shares * _WARM


def _two_sided():
    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    hints.creaseAngle = 0.4
    return hints


def _set_back():
    offset = coin.SoPolygonOffset()
    offset.factor, offset.units = 1.0, 1.0
    return offset


def _thin_ink():
    light, style, colour = coin.SoLightModel(), coin.SoDrawStyle(), coin.SoBaseColor()
    binding = coin.SoMaterialBinding()
    binding.value = coin.SoMaterialBinding.OVERALL
    light.model = coin.SoLightModel.BASE_COLOR
    style.lineWidth = 1.0
    colour.rgb = colours.rgb(colours.INK)
    return binding, light, style, colour


def _matrix_node(matrix):
    node = coin.SoMatrixTransform()
    node.matrix = sb_matrix(matrix)
    return node
