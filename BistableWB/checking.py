# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of a print in a document: ``checking.check(hinge_set)`` → list of `checks.Finding`.

What is checked is in `checks.suite`; here it is told which bodies, and how they are printed.
"""

import numpy as np

from . import openscad
from .checks.bed import Bed
from .checks.printer import Printer
from .checks.suite import Standing, Suite
from .objects import type_of
from .objects.hinge_inputs import hinge_parameters
from .slicing.toolpaths import check_toolpaths
from .solids.tessellation import mesh_of, placed_meshes


def check(obj, printer=None, with_openscad=False, with_slicer=False):
    """`Finding` list on a recomputed HingeSet or HingeCoupon.

    ``printer``: `Printer`, that of the object if not given; ``with_openscad``, ``with_slicer``: ask
    OpenSCAD and PrusaSlicer too, which takes minutes. ValueError where the object has no print.
    """
    bodies = bodies_of(obj)
    meshes = placed_meshes(bodies)
    suite = suite_of(obj, bodies, meshes, printer)
    found = suite.findings()
    if with_openscad:
        found += openscad.check([body.placed for body in meshes])
    if with_slicer:
        found += check_toolpaths(suite.standing_bodies(), suite.parameters, suite.printer)
    return found


def bodies_of(obj):
    """`solids.tube.Body` list of a print, flat."""
    model = _model(obj)
    return model.bodies if model else obj.Proxy.bodies(obj)


def suite_of(obj, bodies, meshes, printer=None):
    """The `Suite` of a print's ``bodies`` and their ``meshes`` (`PlacedMesh`)."""
    volumes = [body.shape.Volume for body in bodies]
    printer = printer or printer_of(obj)
    model = _model(obj)
    if model is None:
        return Suite(meshes, volumes, hinge_parameters(obj), printer)
    turn = np.array(model.standing(obj.Orientation).toMatrix().A).reshape(4, 4)
    support = mesh_of(model.support()).moved(turn) if obj.Support else None
    standing = Standing(turn, obj.Orientation == "OnEdge", support)
    return Suite(meshes, volumes, model.parameters, printer, model.tube, model.snap, standing)


def printer_of(obj, bed=None):
    """`Printer` by the object's own properties; ``bed`` where it has none."""
    own = getattr(obj, "Bed", None)
    room = Bed(*own) if own and any(own) else bed or Bed()
    return Printer(obj.LayerHeight.Value, obj.NozzleDiameter.Value, room)


def _model(obj):
    return obj.Proxy.model(obj) if type_of(obj) == "Bistable::HingeSet" else None
