# SPDX-License-Identifier: LGPL-2.1-or-later
"""Layers, overhangs, walls and cones of small meshes with known answers. Plain numpy."""

from types import SimpleNamespace

import numpy as np
import pytest

from BistableWB.checks import ERROR, NOTE, WARNING
from BistableWB.checks.bvh import Tree
from BistableWB.checks.layering import Layering
from BistableWB.checks.layers import PIXEL, crossings, layers
from BistableWB.checks.printer import Printer
from BistableWB.checks.snapping import check_snap
from BistableWB.checks.suite import Standing, Suite
from BistableWB.checks.walls import steepest_cone, thinnest_walls
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.meshes import Mesh, PlacedMesh, joined

PRINTER = Printer()


def body(name, *meshes, unit=0):
    return PlacedMesh(name, joined(meshes), np.eye(4), unit)


def findings(*bodies, printer=PRINTER, support=None):
    found = Layering(bodies, printer, support).findings()
    return {finding.code: finding for finding in found}


def prism(points, height):
    """An upright prism over plan points, anticlockwise."""
    n = len(points)
    low = np.column_stack([points, np.zeros(n)])
    sides = [
        t
        for i in range(n)
        for t in ((i, (i + 1) % n, n + (i + 1) % n), (i, n + (i + 1) % n, n + i))
    ]
    caps = [t for i in range(1, n - 1) for t in ((0, i + 1, i), (n, n + i, n + i + 1))]
    high = low + np.array([0, 0, height])
    return Mesh(np.concatenate([low, high]), np.array(sides + caps))


def box(low, high):
    (x, y, z), (right, back, top) = low, high
    made = prism(np.array([[x, y], [right, y], [right, back], [x, back]]), top - z)
    return made._replace(vertices=made.vertices + np.array([0, 0, z]))


def turned(angle, x, y, z):
    matrix = np.eye(4)
    matrix[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    matrix[:3, 3] = x, y, z
    return matrix


def cone(angle, radius=1.1, sides=24):
    """A blunt cone along x whose surface makes ``angle`` degrees with its base."""
    turn = np.arange(sides) * 2 * np.pi / sides
    ring = np.column_stack([np.cos(turn), np.sin(turn)])
    mesh = prism(ring, 1.0)
    points = mesh.vertices.copy()
    height = 0.6
    top = points[:, 2] > 0
    points[~top, :2] *= radius
    points[top, :2] *= radius - height / np.tan(np.radians(angle))
    points[top, 2] = height
    return Mesh(points[:, [2, 0, 1]], mesh.triangles)  # the axis becomes x, still right-handed


@pytest.mark.parametrize("angle", [0.0, 0.4])
def test_layers_have_the_area_of_their_sections(angle):
    mesh = box((0, 0, 0), (20, 7, 1.2)).moved(turned(angle, 3.3, -2.1, 0.4))
    found = layers(mesh, 0.2)
    assert found.first[0] == 2
    assert len(found.inside) == 6
    areas = found.inside.sum((1, 2)) * PIXEL**2
    assert areas == pytest.approx(140, abs=54 * PIXEL / 2)
    middle = found.middle(np.array(found.inside.shape) // 2, 0.2)
    centre = np.mean(mesh.bounds, axis=0)
    assert middle == pytest.approx(centre, abs=0.2)


@pytest.mark.parametrize(
    ("z", "steps"),
    [
        (13.100000000000001, (-2, -1, 2, -1)),
        (61.900000000000006, (-3, -3, -1, -3)),
        (54.900000000000006, (-2, 3, -1, 3)),
        (28.700000000000003, (3, 3, -1, -2)),
    ],
)
def test_edges_that_are_level_but_for_rounding_lead_nowhere_else(z, steps):
    """A bottom in the middle of a layer, but for steps of rounding, is cut between its corners."""
    block = prism([(0, 0), (9, 0), (9, 7), (0, 7)], 1.0)
    corners = block.vertices.copy()
    corners[:4, 2], corners[4:, 2] = z + np.spacing(z) * np.array(steps), z + 1
    found = layers(Mesh(corners, block.triangles), 0.2)
    assert (np.array(found.inside.shape[1:]) <= (71, 91)).all()


def test_windows_of_layers_reach_beyond_the_body():
    found = layers(box((0, 0, 0), (1, 1, 1)), 0.2)
    window = found.window(found.first - 3, found.end + 3)
    assert window.shape == tuple(np.add(found.inside.shape, 6))
    assert window.sum() == found.inside.sum() == 5 * 100
    assert not found.window([50, 0, 0], [52, 5, 5]).any()
    assert layers(box((0, 0, 0.12), (1, 1, 0.18)), 0.2).inside.size == 0


def table(span):
    """A board 8 mm wide on two legs that are ``span`` mm apart."""
    legs = [box((x, 0, 0), (x + 2, 8, 4)) for x in (0, 2 + span)]
    return body("table", *legs, box((0, 0, 4), (span + 4, 8, 5)))


def test_a_short_bridge_is_spanned_and_a_long_one_hangs():
    assert findings(table(4.5))["overhang"].number == 0
    found = findings(table(9))["overhang"]
    assert found.severity == WARNING
    # what sticks out from a leg by no more than the overhang is carried
    assert found.number == pytest.approx((9 - 2 * 0.4) * 8, rel=0.05)
    assert found.points[0][2] == pytest.approx(4.1)
    assert "5 mm" in str(found.message)
    filler = box((2, 0, 0), (11, 8, 4))
    assert findings(table(9), support=filler)["overhang"].number == 0


def test_a_narrow_ledge_is_a_note():
    ledge = body("ledge", box((0, 0, 0), (4, 30, 4)), box((4, 0, 3), (7, 30, 4)))
    found = findings(ledge)["overhang"]
    assert found.severity == NOTE
    assert found.number == pytest.approx((3 - 0.4) * 30, rel=0.05)
    assert "narrower" in str(found.message)


@pytest.mark.parametrize(("angle", "hangs"), [(45, False), (58, False), (75, True)])
def test_a_slope_prints_up_to_its_overhang(angle, hangs):
    wall = box((0, 0, 0), (12, 12, 4))
    leaning = wall.vertices.copy()
    leaning[:, 0] += np.tan(np.radians(angle)) * leaning[:, 2]
    found = findings(body("wall", Mesh(leaning, wall.triangles)))["overhang"]
    assert (found.number > 0) == hangs


def test_a_body_that_starts_in_mid_air():
    ground = body("ground", box((0, 0, 0), (9, 9, 1)))
    near = body("near", box((1, 1, 1.6), (3, 3, 4)))
    assert "island" not in findings(ground, near)
    far = body("far", box((5, 5, 8), (7, 7, 9)))
    found = findings(ground, near, far)["island"]
    assert (found.severity, found.bodies) == (WARNING, ("far",))
    assert found.number == pytest.approx(8.1)
    assert "island" not in findings(ground, far, support=box((5, 5, 1), (7, 7, 8)))


def test_a_gap_that_no_layer_falls_into_fuses():
    def stack(low, high):
        return body("lower", box((0, 0, 0), (5, 4, low))), body(
            "upper", box((1, 1, high), (5, 4, 3))
        )

    open_gap = findings(*stack(1.0, 1.2))["fused"]
    assert (open_gap.severity, open_gap.number) == (NOTE, 0)
    closed = findings(*stack(1.12, 1.28))["fused"]
    assert closed.severity == ERROR
    assert closed.bodies == ("lower", "upper")
    assert closed.number == pytest.approx(12, rel=0.03)
    assert "LayerHeight" in str(closed.cure)
    thick = findings(*stack(1.0, 1.2), printer=Printer(layer_height=0.5))["fused"]
    assert thick.severity == ERROR
    few = findings(*(b._replace(unit=k) for k, b in enumerate(stack(1.12, 1.28))))
    assert few["fused"].number == closed.number  # also between units


def test_layers_that_change_the_thickness():
    good = findings(body("plate", box((0, 0, 0), (9, 9, 1.2))))["layers"]
    assert (good.severity, good.number) == (NOTE, pytest.approx(1))
    bad = findings(body("plate", box((0, 0, 0), (9, 9, 1.0))), printer=Printer(layer_height=0.3))
    assert bad["layers"].severity == WARNING
    assert bad["layers"].number == pytest.approx(0.9, abs=0.01)
    assert "0.1 mm off" in str(bad["layers"].message)


def test_walls_are_measured_and_sharp_corners_are_none():
    sharp = prism(np.array([[0, 0], [40, 0], [34, 8]]), 1.2)
    assert thinnest_walls(Tree(sharp), np.eye(4), 0.5) == []
    thin = box((0, 0, 0), (0.3, 12, 5))
    (wall,) = thinnest_walls(Tree(thin), np.eye(4), 0.5)
    assert (wall.thickness, wall.floor) == (pytest.approx(0.3), False)
    assert wall.point[0] == pytest.approx(0.15, abs=0.01)
    lying = np.array([[0, 0, -1.0, 0], [0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
    (wall,) = thinnest_walls(Tree(thin), lying, 0.5)
    assert wall.floor
    # two blocks that meet at a corner have a neck there, but no wall
    neck = joined([box((0, 0, 0), (5, 5, 2)), box((4.8, 4.8, 2.1), (9, 9, 4))])
    assert [w for w in thinnest_walls(Tree(neck), np.eye(4), 0.5) if not w.floor] == []
    slot = joined([box((0, 0, 0), (2, 9, 3)), box((2.2, 0, 0), (4, 9, 3))])
    assert thinnest_walls(Tree(slot), np.eye(4), 0.5) == []


@pytest.mark.parametrize("angle", [45, 55, 70])
def test_the_overhang_of_a_cone(angle):
    found, point = steepest_cone(cone(angle))
    assert found == pytest.approx(angle, abs=1.5)
    assert point[2] < 0
    upright = cone(angle).moved(
        np.array([[0, 0, -1.0, 0], [0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
    )
    assert steepest_cone(upright) is None  # it narrows upwards


def test_a_barrel_is_no_cone():
    turn = np.arange(24) * 2 * np.pi / 24
    barrel = prism(np.column_stack([np.cos(turn), np.sin(turn)]), 5.0)
    assert steepest_cone(Mesh(barrel.vertices[:, [2, 0, 1]], barrel.triangles)) is None


def suite(*bodies, printer=PRINTER, **options):
    volumes = [made.mesh.volume for made in bodies]
    return Suite(bodies, volumes, HingeParameters(), printer, **options)


def test_thin_walls_and_steep_cones_are_findings():
    good = suite(body("block", box((0, 0, 0), (3, 3, 3))), body("cone", cone(55))).check_walls()
    assert [(f.code, f.severity) for f in good] == [("wall", NOTE), ("cone", NOTE)]
    bad = [
        body("thin", box((0, 0, 0), (0.3, 12, 5))),
        body("film", box((9, 0, 0), (19, 9, 0.1))),
        body("steep", cone(70)),
    ]
    found = suite(*bad).check_walls()
    assert [(f.code, f.severity, f.bodies) for f in found] == [
        ("wall", ERROR, ("thin",)),
        ("wall", ERROR, ("film",)),
        ("cone", WARNING, ("steep",)),
    ]
    assert [f.limit for f in found] == [0.4, 0.2, 60]
    assert all(f.points and f.cure for f in found)
    fine = Printer(layer_height=0.1, nozzle_diameter=0.25)
    assert suite(*bad[:2], printer=fine).check_walls()[0].severity == NOTE


def test_clearances_below_the_resolution_of_the_slicer():
    parameters = HingeParameters(gap_length=0.05, gap_between_planes=0.05)
    near = [body("a", box((0, 0, 0), (3, 3, 3))), body("b", box((3.06, 0, 0), (6, 3, 3)))]
    checked = Suite(near, [27, 26.46], parameters, PRINTER)
    (found,) = dict(checked.steps())["clearances"]()
    assert found.severity == ERROR
    assert found.number == pytest.approx(0.06, abs=1e-3)
    assert "slicer" in str(found.message)


def test_a_print_is_looked_at_as_it_stands():
    lying = np.array([[0, 0, -1.0, 5], [0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]])
    tall = body("tall", box((0, 0, 0), (12, 9, 1)), box((0, 0, 1), (12, 1, 4)))
    flat, upright = (
        suite(tall, standing=Standing(turn, on_edge)).check_layers()
        for turn, on_edge in ((np.eye(4), False), (lying, True))
    )
    assert {f.code: f.number for f in flat}["overhang"] == 0
    assert {f.code: f.number for f in upright}["overhang"] == 0
    fallen = np.diag([1.0, -1.0, -1.0, 1.0])
    fallen[2, 3] = 4
    found = suite(tall, standing=Standing(fallen)).check_layers()
    hanging = {f.code: f for f in found}["overhang"]
    assert hanging.severity == WARNING
    assert hanging.number == pytest.approx(12 * (8 - 0.4), rel=0.05)


def test_floppy_units_are_named():
    margin = np.array([1.2, 0.8, 1.1, 0.5])
    (found,) = check_snap(SimpleNamespace(margin=margin, bistable=np.full(4, True)))
    assert (found.severity, found.number) == (WARNING, 0.5)
    assert found.bodies == ("unit02", "unit04")
    assert str(found.message).startswith("Units 2, 4 of 4 are floppy, margin 0.50")
    (found,) = check_snap(SimpleNamespace(margin=1.4, bistable=False))
    assert str(found.message).startswith("The unit is floppy, without a second stable state")
    assert "Compensate" in str(found.cure)
    (found,) = check_snap(SimpleNamespace(margin=margin + 1, bistable=np.full(4, True)))
    assert (found.severity, str(found.message)) == (NOTE, "All 4 units snap: margin 1.50 or more.")
    (found,) = check_snap(SimpleNamespace(margin=np.inf, bistable=True))
    assert found.number is None  # no margin tells of strips
    assert "measure" in str(found.cure)


def test_outlines_close_however_corners_are_rounded():
    """Corners on the lines through the pixels' middles, or a rounding error beside them."""
    random = np.random.default_rng(2)
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])
    for _ in range(1000):
        corners = random.integers(-40, 40, (4, 3)) * 0.05
        corners[1:3, 1] = corners[0, 1] + random.choice([0, 1e-16, -2e-16, 4e-16], 2)
        mesh = Mesh(corners, faces)
        mesh = mesh if mesh.volume > 0 else Mesh(corners, faces[:, ::-1])
        layer, row, _, sign = crossings(mesh, 0.2)
        lines, which = np.unique(np.stack([layer, row]), axis=1, return_inverse=True)
        assert not np.bincount(which.ravel(), sign, lines.shape[1]).any()


def test_every_place_that_starts_in_mid_air_is_counted():
    """Three towers of one body: two over air, one on something two layers of air below."""
    ground = body("ground", box((0, 0, 0), (30, 9, 1)))
    high = [box((1, 1, 3), (3, 3, 4)), box((20, 1, 3), (24, 3, 4))]
    towers = body("towers", *high, box((10, 1, 1.4), (13, 3, 4)))
    made = Layering([ground, towers], PRINTER, None, "none", alone=True)
    island = {finding.code: finding for finding in made.findings()}["island"]
    assert "2 places start, 12 mm² in all" in str(island.message)
    assert len(island.points) == 2
