# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base angle ω of a spherical tube as an input: the sphere's radius follows from it."""

import numpy as np
import pytest

from BistableWB import make
from BistableWB.designs import reading


@pytest.mark.parametrize("omega", [68.0, 75.0, 82.5])
def test_units_have_the_base_angle_that_was_wanted(doc, valid, omega):
    curve = make.make_curve(doc, points=[(-60, -20, 0), (0, 25, 0), (60, -15, 0)], kind="Sphere")
    curve.Omega, curve.OmegaEdgeLength = omega, 44
    placement = make.make_triangle_placement(doc, curve, edge_length=44)
    unit = make.make_bistable_unit(doc, placement)
    valid(doc)
    assert unit.Omegas == pytest.approx([omega] * len(unit.Omegas), abs=1e-9)
    # on the solids: angle at the ends of the bases of the contact trapezoids
    angles = []
    for face in unit.Shape.Faces:
        for edge in face.Edges:
            if abs(edge.Length - 44) < 1e-6 and len(face.Vertexes) == 4:
                a, b = (v.Point for v in edge.Vertexes)
                other = [v.Point for v in face.Vertexes if min(v.Point.distanceToPoint(p)
                         for p in (a, b)) > 1e-6]  # fmt: skip
                nearest = min(other, key=a.distanceToPoint)
                angles.append(np.degrees((b - a).getAngle(nearest - a)))
    assert any(abs(angle - omega) < 1e-6 for angle in angles)


def test_the_radius_follows_a_changed_edge_length(doc, valid):
    curve = make.make_curve(doc, points=[(-60, -20, 0), (0, 25, 0), (60, -15, 0)], kind="Sphere")
    curve.Omega, curve.OmegaEdgeLength = 75, 40
    valid(doc)
    small = curve.SphereRadius.Value
    curve.OmegaEdgeLength = 80
    valid(doc)
    assert curve.SphereRadius.Value == pytest.approx(2 * small)
    curve.Omega = 0
    curve.SphereRadius = 155
    valid(doc)
    assert curve.SphereRadius.Value == 155


@pytest.mark.parametrize(("omega", "edge", "name"), [(90, 40, "Omega"), (75, 0, "OmegaEdgeLength")])
def test_angles_that_cannot_be_are_refused(doc, omega, edge, name):
    curve = make.make_curve(doc, kind="Sphere")
    curve.Omega, curve.OmegaEdgeLength = omega, edge
    doc.recompute()
    assert not curve.isValid()
    assert curve.Proxy.refusal.parameter == name


def test_a_design_file_gives_omega_instead_of_a_radius(doc, tmp_path):
    path = tmp_path / "globe.toml"
    path.write_text('[curve]\nkind = "Sphere"\npoints = [[-60, 0, 0], [0, 20, 0], [60, 0, 0]]\n'
                    'omega = 75\nomega_edge_length = 44\n[triangles]\nedge_length = 44\n'
                    '[unit]\n')  # fmt: skip
    assert reading.read(path).get("curve", "omega") == 75
