# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feet: a deployed tube stands square on a given plane; measured on the exported solids."""

import FreeCAD as App
import numpy as np
import pytest

from BistableWB import checking, exporters, make
from BistableWB.solids.tessellation import mesh_of

POINTS = [(0, 0, 0), (0, 120, 0), (100, 220, 0), (220, 220, 0)]


@pytest.fixture
def standing(doc, valid):
    """An arch of a quarter whose start stands on the plane y = −30."""
    curve = make.make_curve(doc, points=POINTS)
    triangles = make.make_triangle_placement(doc, curve, edge_length=80)
    hinges = make.make_hinge_set(doc, make.make_bistable_unit(doc, triangles))
    hinges.StartPart, hinges.LastUnit = "Foot", 2
    hinges.FootPoint, hinges.FootNormal = App.Vector(0, -30, 0), App.Vector(0, 1, 0)
    valid(doc)
    return hinges


def named(bodies, name):
    return next(shape for found, shape, _ in bodies if found == name)


def test_a_foot_stands_square_on_its_plane_and_under_its_flange(standing):
    hinges = standing
    deployed = hinges.Proxy.bodies_at(hinges, 1.0)
    foot = named(deployed, "start_foot")
    assert foot.isValid()
    assert pytest.approx(-30, abs=1e-6) == foot.BoundBox.YMin
    sole = [f for f in foot.Faces if (f.CenterOfMass.y + 30) ** 2 < 1e-12]
    assert len(sole) == 1
    assert abs(sole[0].normalAt(0, 0).y) == pytest.approx(1)
    flange = next(shape for _, shape, kind in deployed if kind == "foot" and shape is not foot)
    assert flange.distToShape(foot)[0] < 1e-6
    assert flange.common(foot).Volume < 1e-3
    others = [shape for name, shape, _ in deployed if name != "start_foot" and shape is not flange]
    assert min(foot.distToShape(shape)[0] for shape in others[:20]) > 0.3
    holes = [f for f in foot.Faces if f.Surface.TypeId == "Part::GeomCylinder"]
    through = [f for f in flange.Faces if f.Surface.TypeId == "Part::GeomCylinder"
               and abs(f.Surface.Radius - 1.7) < 1e-6]  # fmt: skip
    assert len(through) >= 4
    for hole in holes:  # each goes on where a hole of the flange ends
        axes = [(g.Surface.Center - hole.Surface.Center).cross(hole.Surface.Axis).Length
                for g in through]  # fmt: skip
        assert min(axes) < 1e-6


def test_it_is_printed_on_its_sole_beside_the_stack(standing, tmp_path):
    hinges = standing
    bodies = hinges.Proxy.export_bodies(hinges)
    foot = named(bodies, "start_foot")
    assert pytest.approx(0, abs=1e-6) == foot.BoundBox.ZMin
    rest = [s.BoundBox.XMax for n, s, k in bodies if n not in ("start_foot", "pillars")]
    assert max(rest) <= foot.BoundBox.XMin - 4.9
    exporters.export([hinges], tmp_path / "it.3mf")
    assert mesh_of(foot).volume == pytest.approx(foot.Volume, rel=0.01)
    assert [str(f) for f in checking.check(hinges) if f.severity == "error"] == []
    assert np.allclose(hinges.PrintSize.z, max(s.BoundBox.ZMax for _, s, _ in bodies), atol=0.3)


def test_a_bed_without_room_for_the_foot_is_refused(standing):
    hinges = standing
    x, y = hinges.PrintSize.x, hinges.PrintSize.y
    hinges.Bed = App.Vector(max(x, y) - 5, min(x, y) + 26, 200)
    hinges.Document.recompute()
    assert not hinges.isValid()
    assert "feet beside the stack" in str(hinges.Proxy.refusal)


@pytest.mark.parametrize(("point", "normal", "word", "parameter"), [
    ((0, -30, 0), (0, 0, 1), "misses", "FootNormal"),
    ((0, -30, 0), (0, -1, 0), "misses", "FootNormal"),
    ((0, 10, 0), (0, 1, 0), "move FootPoint", "FootPoint"),
    ((0, -30, 0), (0, 0, 0), "no direction", "FootNormal"),
])  # fmt: skip
def test_planes_that_cannot_be_are_refused_with_a_cure(standing, point, normal, word, parameter):
    hinges = standing
    hinges.FootPoint, hinges.FootNormal = App.Vector(*point), App.Vector(*normal)
    hinges.Document.recompute()
    assert not hinges.isValid()
    assert hinges.Proxy.refusal.parameter == parameter
    assert word in str(hinges.Proxy.refusal)
