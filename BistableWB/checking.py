# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks of a print in a document: ``checking.check(hinge_set)`` → list of `checks.Finding`.

What is checked is in `checks.suite`; here it is told which bodies, and how they are printed.
"""

from .checks.printer import printer_of
from .checks.suite import Standing, Suite
from .objects import type_of
from .objects.current import refuse_stale
from .objects.hinge_inputs import hinge_parameters
from .programs import openscad
from .slicing.toolpaths import check_toolpaths
from .solids.matrices import array_of
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
        found += check_toolpaths(suite.printed_bodies(), suite.parameters, suite.printer)
    return found


def bodies_of(obj):
    """`solids.tube.Body` list of a print, flat; `Refusal` where it is not what its inputs say."""
    refuse_stale(obj)
    model = _model(obj)
    return model.bodies if model else obj.Proxy.bodies(obj)


def suite_of(obj, bodies, meshes, printer=None):
    """The `Suite` of a print's ``bodies`` and their ``meshes`` (`PlacedMesh`).

    What a check of a HingeSet has found stays with its model: panel and report ask once.
    """
    volumes = [body.volume for body in bodies]
    slacks = [body.slack for body in bodies]
    printer = printer or printer_of(obj)
    model = _model(obj)
    if model is None:
        asked = getattr(obj.Proxy, "parameters", hinge_parameters)
        suite = Suite(meshes, volumes, asked(obj), printer, slacks=slacks)
        suite.is_trial = type_of(obj) == "Bistable::CalibrationPlate"
        return suite
    turn = array_of(model.standing(obj.Orientation))
    support = mesh_of(model.support()).moved(turn) if obj.Support else None
    ties = tuple(model.tie_meshes()) if model.has_ties(obj.Orientation) else None
    pillars = model.pillar_bodies if model.has_pillars(obj.Orientation) else None
    standing = Standing(turn, obj.Orientation == "OnEdge", support, model.more, ties, pillars)
    given = model.parameters, printer, model.tube, model.snap, standing
    suite = Suite(meshes, volumes, *given, slacks=slacks)
    suite.known = model.findings.setdefault((printer, obj.Orientation, obj.Support), {})
    return suite


def _model(obj):
    return obj.Proxy.model(obj) if type_of(obj) == "Bistable::HingeSet" else None
