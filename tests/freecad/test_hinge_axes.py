"""Every hinge of the crease table, found again in the solids: its knuckles, and its axis when open.

Nothing here asks the layout: cones are looked for among the faces of the printed bodies,
and carried by the bodies' own motions.
"""

from typing import NamedTuple

import numpy as np
import Part
import pytest

from BistableWB import make
from BistableWB.origami import rigid
from BistableWB.origami.thick import print_stack
from BistableWB.origami.units.creases import CREASES

NEAR = 0.02  # mm from an axis at which a cone counts as standing on it


class Cone(NamedTuple):
    apex: np.ndarray
    axis: np.ndarray


@pytest.fixture(scope="module", params=["plane", "sphere"])
def model(request):
    import FreeCAD as App

    doc = App.newDocument("Hinges")
    unit = make.make_bistable_unit(doc, theta=45, ratio=0.42, edge_length=60)
    if request.param == "sphere":
        unit.Omega, unit.RatioRule = 80, "Exact"
    hinges = make.make_hinge_set(doc, unit)
    hinges.Preload = 0  # which shifts axes on purpose
    doc.recompute()
    assert hinges.isValid(), hinges.getStatusString()
    yield hinges.Proxy.model(hinges)
    App.closeDocument(doc.Name)


def cones_of(shape):
    surfaces = (face.Surface for face in shape.Faces)
    return [Cone(np.array(s.Apex), np.array(s.Axis)) for s in surfaces if isinstance(s, Part.Cone)]


def on_line(cones, ends):
    """Cones with their apex and axis on the line through ``ends`` (2, 3), between them."""
    start, end = ends
    along = (end - start) / np.linalg.norm(end - start)
    found = []
    for cone in cones:
        reach = (cone.apex - start) @ along
        off = np.linalg.norm(cone.apex - start - reach * along)
        aligned = np.linalg.norm(np.cross(cone.axis, along)) < 1e-3
        if off < NEAR and aligned and -1 < reach < np.linalg.norm(end - start) + 1:
            found.append(cone)
    return found


def hinges_of(model):
    """(crease, cones of its first body, of its second, motions of both when deployed)."""
    place = print_stack.frames(model.tube.thick)[0]
    cones = {body.members[0][1]: cones_of(body.shape) for body in model.bodies}
    motions = model.motions(1.0)
    motion = {b.members[0][1]: m for b, m in zip(model.bodies, motions, strict=True)}
    for crease, ends in zip(CREASES, model.tube.thick.axes[0], strict=True):
        ends = rigid.apply(place, ends)
        first, second = (on_line(cones[name], ends) for name in crease.bodies)
        yield crease, first, second, [motion[name] for name in crease.bodies]


def test_every_hinge_has_at_least_three_segments(model):
    for crease, first, second, _ in hinges_of(model):
        # every pair of neighbouring knuckles is a cone and its recess
        segments = 1 + (len(first) + len(second)) / 2
        assert segments >= 3, crease.name
        assert first, crease.name
        assert second, crease.name


def test_both_bodies_of_every_hinge_stay_coaxial_when_deployed(model):
    for crease, first, second, (move, other) in hinges_of(model):
        lines = [
            [rigid.apply(m, np.array([c.apex, c.apex + c.axis])) for c in cones]
            for m, cones in ((move, first), (other, second))
        ]
        origin = lines[0][0][0]
        along = lines[0][0][1] - origin
        for start, _ in lines[1]:
            off = start - origin
            assert np.linalg.norm(off - (off @ along) * along) < 1e-3, crease.name
        far = lines[0][-1][0] - origin
        assert np.linalg.norm(far - (far @ along) * along) < 1e-3
