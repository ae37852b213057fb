"""Distances, overlaps and soundness of small meshes with known answers. Plain numpy."""

import numpy as np
import pytest

from BistableWB.checks import ERROR, soundness, triangles
from BistableWB.checks.bvh import Scene, Tree
from BistableWB.checks.clearance import ACCURACY, clearances
from BistableWB.checks.penetration import penetrations
from BistableWB.checks.printing import Print
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.meshes import Mesh, PlacedMesh, component_labels, joined

QUADS = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def box(low=(0, 0, 0), high=(1, 1, 1)):
    corners = np.array([[(low, high)[i >> 2 & 1][0], (low, high)[i >> 1 & 1][1],
                         (low, high)[i & 1][2]] for i in range(8)], float)  # fmt: skip
    faces = [f for a, b, c, d in QUADS for f in ((a, b, c), (a, c, d))]
    mesh = Mesh(corners, np.array(faces)[:, ::-1])
    return mesh if mesh.volume > 0 else Mesh(corners, np.array(faces))


def ball(radius=1.0, n=24):
    """A sphere of triangles, its corners on the radius."""
    polar, turn = np.meshgrid(np.linspace(0, np.pi, n)[1:-1], np.arange(2 * n) * np.pi / n)
    ring = np.stack([np.sin(polar) * np.cos(turn), np.sin(polar) * np.sin(turn), np.cos(polar)], -1)
    rows, columns = ring.shape[:2]
    vertices = np.concatenate([ring.reshape(-1, 3), [[0, 0, 1], [0, 0, -1]]]) * radius
    faces = []
    for i in range(rows):
        j = (i + 1) % rows
        for k in range(columns - 1):
            a, b, c, d = i * columns + k, i * columns + k + 1, j * columns + k, j * columns + k + 1
            faces += [(a, b, d), (a, d, c)]
        faces += [
            (rows * columns, i * columns, j * columns),
            (rows * columns + 1, j * columns + columns - 1, i * columns + columns - 1),
        ]
    return Mesh(vertices, np.array(faces))


def at(x, y=0.0, z=0.0, turn=0.0):
    pose = np.eye(4)
    pose[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
    pose[:3, 3] = x, y, z
    return pose


def scene(*placed):
    return Scene([Tree(mesh) for mesh, _ in placed], [pose for _, pose in placed])


def test_a_box_and_a_ball_are_sound():
    for mesh, volume in ((box(), 1), (ball(), 4 / 3 * np.pi)):
        assert mesh.volume == pytest.approx(volume, rel=0.02)
        assert soundness.check_mesh("it", mesh, Tree(mesh)) == []
    assert box().moved(np.diag([-1.0, 1, 1, 1])).volume == pytest.approx(1)


def test_distances_of_random_triangles_are_those_of_many_points_on_them():
    rng = np.random.default_rng(1)
    first, second = rng.normal(size=(40, 3, 3)), rng.normal(size=(40, 3, 3)) + rng.normal(size=3)
    weights = np.array([(i, j, 20 - i - j) for i in range(21) for j in range(21 - i)]) / 20
    found = triangles.distances(first, second)
    for p, q, distance in zip(first, second, found, strict=True):
        a, b = weights @ p, weights @ q
        sampled = np.sqrt(((a[:, None] - b[None]) ** 2).sum(-1).min())
        assert distance <= sampled + 1e-12
        assert sampled - distance < 0.2


@pytest.mark.parametrize("turn", [0.0, 0.3])
def test_distance_of_two_balls(turn):
    bodies = [(ball(), at(0)), (ball(), at(2.3, 0.4, 0.2, turn))]
    expected = np.linalg.norm([2.3, 0.4, 0.2]) - 2
    found = clearances(scene(*bodies), 1.0)
    assert found.distances == pytest.approx([expected], abs=0.02)
    assert found.points[0] == pytest.approx(np.array([2.3, 0.4, 0.2]) / 2, abs=0.1)
    assert len(clearances(scene(*bodies), 0.2).pairs) == 0


def test_distance_of_boxes_is_exact_and_copies_are_measured_once():
    bodies = [(box(), at(1.25 * k)) for k in range(4)]
    tree = Tree(box())
    whole = Scene([tree] * 4, [pose for _, pose in bodies])
    found = clearances(whole, 0.5)
    assert found.pairs.tolist() == [[0, 1], [1, 2], [2, 3]]
    assert found.distances == pytest.approx([0.25] * 3, abs=ACCURACY)
    assert len(whole.distinct(found.pairs)[0]) == 1


def test_a_body_inside_another_and_bodies_that_touch():
    inside = scene((box(), at(0)), (box((0.4, 0.4, 0.4), (0.6, 0.6, 0.6)), at(0)))
    assert penetrations(inside).pairs.tolist() == [[0, 1]]
    touching = scene((box(), at(0)), (box(), at(1)))
    assert clearances(touching, 0.5).distances == pytest.approx([0])
    assert penetrations(touching).depths.max(initial=0) < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("depth", [0.01, 0.1, 0.19])
@pytest.mark.parametrize("turn", [0.0, 0.4])
def test_depth_of_a_corner_a_face_and_a_ball(depth, turn):
    for other in (box((0.4, 0.3, 0.2), (2, 0.7, 0.8)), box((-2, 0.3, 0.2), (0.6, 0.7, 0.8))):
        left = other.bounds[0][0] < 0
        shift = depth - 0.6 if left else 0.6 - depth
        found = penetrations(scene((box(), at(0)), (other, at(shift))))
        assert found.depths == pytest.approx([depth], rel=0.05)
    found = penetrations(scene((ball(), at(0)), (ball(), at(2 - depth, turn=turn))))
    assert found.depths == pytest.approx([depth], rel=0.15, abs=0.01)


def test_a_blade_right_through_a_plate_is_as_deep_as_the_plate_is_thick():
    plate, blade = box((0, 0, 0), (10, 10, 1)), box((4, 4, -3), (6, 4.2, 4))
    found = penetrations(scene((plate, at(0)), (blade, at(0))))
    assert found.depths == pytest.approx([0.5], rel=0.05)


def test_every_way_to_break_a_mesh_is_found():
    def codes(mesh):
        return {finding.code for finding in soundness.check_mesh("it", mesh, Tree(mesh))}

    whole = ball()
    flipped = whole.triangles.copy()
    flipped[5] = flipped[5, ::-1]
    dented = whole.vertices.copy()
    dented[whole.triangles[300, 0]] *= -1.5
    sliver = whole.vertices.copy()
    a, b, c = whole.triangles[200]
    sliver[c] = (sliver[a] + sliver[b]) / 2
    assert codes(Mesh(whole.vertices, whole.triangles[1:])) == {"open"}
    assert codes(Mesh(whole.vertices, flipped)) == {"orientation"}
    assert codes(Mesh(whole.vertices, whole.triangles[:, ::-1])) == {"inside_out"}
    assert "self_intersection" in codes(Mesh(dented, whole.triangles))
    assert "degenerate" in codes(Mesh(sliver, whole.triangles))
    assert codes(joined([whole, whole.moved(at(5))])) == {"parts"}
    assert codes(joined([whole, whole.moved(at(1))])) == {"parts", "self_intersection"}


def test_volume_and_count():
    assert soundness.check_volume("it", box(), 1.004) == []
    assert soundness.check_volume("it", box(), 1.006)[0].code == "volume"
    two = joined([box(), box((3, 0, 0), (4, 1, 1))])
    parts = component_labels(two.triangles, len(two.vertices)).max() + 1
    assert parts == 2
    assert soundness.check_count(parts, 2) == []
    assert soundness.check_count(parts, 3)[0].severity == ERROR


@pytest.mark.parametrize(("gap", "severity"), [(0.3, "note"), (0.215, "note"), (0.2, "error")])
def test_a_gap_is_compared_with_the_one_asked_for(gap, severity):
    bodies = [PlacedMesh(name, box(), at(x), 0, ((0, name),))
              for name, x in (("contact_left", 0), ("primary_left_upper", 1 + gap))]  # fmt: skip
    found = Print(bodies, HingeParameters()).check_flat()
    assert [finding.severity for finding in found] == [severity]
    if severity == ERROR:
        assert found[0].bodies == ("contact_left", "primary_left_upper")
        assert found[0].number == pytest.approx(gap, abs=1e-4)
        assert "GapLength" in str(found[0].cure)
        assert str(found[0]).endswith("mm.")
