# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nets to cut: panels keep their shape, nothing overlaps, edges that meet bear the same number."""

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.patterns import sheets
from BistableWB.origami.patterns.nets import overlap, unfolded, unit_nets
from BistableWB.origami.patterns.surface import EDGES, OUTWARD, surface_of
from BistableWB.origami.unit import plane_unit, sphere_unit
from BistableWB.origami.units.creases import INDEX
from BistableWB.origami.units.ratios import RatioRule
from BistableWB.origami.units.tube import along, single

ARCH = Bezier([(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)])
RISING = Bezier([(0, 0, 0), (60, 120, 6), (180, 120, 14), (240, 0, 20)])


def tube_along(curve=ARCH, family="Plane", pitch=0.0, edge_length=40.0):
    placed = place(curve, edge_length, np.radians(20), pitch, ("parallel", (0, 0, 1.0)))
    return along(placed, family, 2.5, RatioRule("Adaptive", share=0.1))


def distances(points):
    return np.abs(np.subtract.outer(points, points))


def check(nets, unit, deployed=True):
    """Every panel once, congruent in the plane and in space; no overlap; seams in pairs."""
    names = [name for net in nets for name in net.polygons]
    assert sorted(names) == sorted(OUTWARD)
    for net in nets:
        for name, polygon in net.polygons.items():
            for state in (unit.flat, unit.deployed) if deployed else (unit.flat,):
                corners = state[[INDEX[v] for v in OUTWARD[name]]]
                lengths = np.linalg.norm(corners[:, None] - corners[None], axis=-1)
                assert distances(polygon) == pytest.approx(lengths, rel=1e-9)
            turn = np.angle((np.roll(polygon, -1) - polygon) / (polygon - np.roll(polygon, 1)))
            assert (turn > 0).all()  # anticlockwise: seen from outside
        for one, other in combinations(net.shapes, 2):
            assert not overlap(one, other)
        edges = np.roll(net.outline, -1) - net.outline
        area = (net.outline.conj() * edges).imag.sum() / 2
        assert area == pytest.approx(sum(_area(p) for p in net.shapes), rel=1e-9)
    check_seams([seam for net in nets for seam in net.seams])
    folds = sum(len(net.folds) for net in nets)
    assert folds == len(OUTWARD) - len(nets)
    assert 2 * (len(EDGES) - folds) == sum(len(net.seams) for net in nets)


def check_seams(seams):
    by_number = {}
    for seam in seams:
        by_number.setdefault(seam.number, []).append(seam)
    assert sorted(by_number) == list(range(1, len(by_number) + 1))
    for pair in by_number.values():
        lengths = [abs(s.end - s.start) for s in pair]
        assert len(pair) == 2
        assert lengths[0] == pytest.approx(lengths[1], rel=1e-9)
        assert pair[0].fold == pair[1].fold
        assert sum(s.tab is not None for s in pair) <= 1


def _area(polygon):
    return (polygon.conj() * np.roll(polygon, -1)).imag.sum() / 2


@given(st.floats(0.15, 2.4), st.floats(0.02, 0.9), st.floats(0.3, 4))
def test_plane_units_are_one_net(theta, share, height_ratio):
    ratio = np.sin(theta / 2) + share * (1 - np.sin(theta / 2))
    unit = plane_unit(theta, ratio, 60.0, 60.0 / height_ratio)
    nets = unit_nets(unit)
    check(nets, unit)
    assert len(nets) == 1


@given(st.floats(0.15, 1.04), st.floats(0.8, 1.5), st.floats(0.2, 0.5))
def test_spherical_units_are_one_net_with_tabs(theta, omega, height):
    unit = sphere_unit(theta, 60.0, omega, height * 30.0 * np.tan(omega))
    nets = unit_nets(unit, tab_depth=5.0)
    check(nets, unit)
    assert len(nets) == 1


def test_units_of_a_general_curve_have_nets():
    tube = tube_along(RISING, "General")
    for k in range(len(tube)):
        check(unit_nets(tube.unit[k], tab_depth=5.0), tube.unit[k])


def test_every_seam_gets_one_tab():
    unit = plane_unit(np.radians(45), 0.45, 100.0, 40.0)
    (net,) = unit_nets(unit, tab_depth=6.0)
    tabs = [seam for seam in net.seams if seam.tab]
    assert len(tabs) == 9
    for seam in tabs:
        assert overlap(np.array(seam.tab), np.array(seam.tab))
        out = [np.imag((z - seam.start) / (seam.end - seam.start)) for z in seam.tab]
        assert [out[0], out[3]] == pytest.approx([0, 0], abs=1e-12)
        assert out[1] == pytest.approx(out[2])
        assert out[1] < 0


def test_net_folds_up_into_the_deployed_unit():
    """Panels joined along a fold, turned by the unit's fold angles, close the net's seams."""
    unit = plane_unit(np.radians(50), 0.5, 60.0, 24.0)
    tube = single(unit)
    surface = surface_of(tube)
    points = surface.points(tube.deployed())
    folds = surface.fold_angles(points, points)
    angles = dict(zip(map(frozenset, surface.edges.tolist()), folds, strict=True))
    (net,) = unit_nets(unit)
    placed = {"border_left": _in_space(net.polygons["border_left"])}
    while len(placed) < 12:
        for (a, b), panels in EDGES.items():
            inside = [p for p in panels if p in placed]
            if len(inside) == 1 and _creased(net, (a, b), panels):
                other = panels[panels[0] == inside[0]]
                angle = angles[frozenset((INDEX[a], INDEX[b]))]
                placed[other] = _folded(net, inside[0], other, (a, b), angle, placed[inside[0]])
    found = {}
    for name, corners in placed.items():
        for vertex, point in zip(OUTWARD[name], corners, strict=True):
            found.setdefault(vertex, []).append(point)
    for images in found.values():
        assert np.ptp(images, axis=0) == pytest.approx(0, abs=1e-9)


def _in_space(polygon):
    return np.stack([polygon.real, polygon.imag, 0 * polygon.real], 1)


def _creased(net, edge, panels):
    ends = [net.polygons[p][OUTWARD[p].index(v)] for v in edge for p in panels]
    return abs(ends[0] - ends[1]) + abs(ends[2] - ends[3]) < 1e-9


def _folded(net, panel, other, edge, angle, corners):
    """Corners in space of ``other``, hinged at ``edge`` to ``panel``, whose corners are given."""
    flat = _in_space(net.polygons[panel])
    frame = np.linalg.lstsq(np.c_[flat[:, :2], np.ones(len(flat))], corners, rcond=None)[
        0
    ]  # plane → space
    x, y, origin = frame
    normal = np.cross(x, y)
    loop = OUTWARD[panel]
    a, b = edge if loop[(loop.index(edge[0]) + 1) % len(loop)] == edge[1] else edge[::-1]
    start = corners[loop.index(a)]
    axis = corners[loop.index(b)] - start
    axis /= np.linalg.norm(axis)
    z = net.polygons[other]
    offset = np.outer(z.real, x) + np.outer(z.imag, y) + origin - start
    along_axis = np.outer(offset @ axis, axis)
    away = offset - along_axis
    # the other panel lies to the right of a → b; a valley (positive) lifts it towards the normal
    size = np.linalg.norm(away, axis=1)[:, None]
    right = np.cross(axis, normal)
    return start + along_axis + size * (np.cos(angle) * right + np.sin(angle) * normal)


def test_outward_panels_bound_the_unit():
    unit = plane_unit(np.radians(50), 0.5, 1.0, 0.4)
    surface = surface_of(single(unit))
    points = surface.points(unit.deployed[None])
    assert len(surface.faces) == 12
    assert len(surface.edges) == 20
    fans = [(points[[f[0], f[i], f[i + 1]]]) for f in surface.faces for i in range(1, len(f) - 1)]
    assert sum(np.linalg.det(t) for t in fans) / 6 > 0  # outwards
    assert set(unfolded(unit)) == set(OUTWARD)


@pytest.mark.parametrize(("family", "pitch"), [("Plane", 0.0), ("Plane", 1.8), ("General", 0.0)])
def test_skin_of_a_tube_keeps_its_folds_on_their_side(family, pitch):
    tube = tube_along(ARCH if family == "Plane" else RISING, family, pitch)
    surface, n = surface_of(tube), len(tube)
    shared = n - 1 if pitch == 0 else 0
    assert len(surface.faces) == 12 * n - shared
    assert surface.corners.max() + 1 == 10 * n - 4 * shared
    assert surface.is_manifold == (shared == 0)
    deployed = surface.points(tube.deployed())
    assert deployed[surface.corners] == pytest.approx(tube.deployed(), abs=1e-6)
    sides = np.sign(surface.fold_angles(deployed, deployed))
    assert (sides != 0).all()
    for opening in (0.0, 0.02, 0.5, 1.0):
        angles = surface.fold_angles(surface.points(tube.state(opening)), deployed)
        folded = np.abs(angles) > 1e-6
        assert (np.sign(angles)[folded] == sides[folded]).all()
    flat = np.abs(surface.fold_angles(surface.points(tube.state(0.0)), deployed))
    assert np.minimum(flat, np.pi - flat).max() < 1e-6


def test_sheets_hold_all_nets_without_overlap():
    tube = tube_along(edge_length=60.0)
    pages = sheets.lay_out([("arch", tube)], "A4", tab_depth=5.0)
    nets = [net for page in pages for net in page.nets]
    assert sum(len(net.polygons) for net in nets) == 12 * len(tube)
    for page in pages:
        corners = np.concatenate([net.outline for net in page.nets])
        assert corners.real.min() >= sheets.MARGIN - 1e-9
        assert corners.real.max() <= 297 - sheets.MARGIN + 1e-9
        assert corners.imag.min() >= sheets.MARGIN + sheets.FOOTER - 1e-9
        assert corners.imag.max() <= 210 - sheets.MARGIN + 1e-9
        for one, other in combinations(page.nets, 2):
            assert not any(overlap(p, q) for p in one.shapes for q in other.shapes)


def test_labels_say_unit_neighbour_and_seam():
    tube = tube_along(edge_length=90.0)
    (page, *_), count = sheets.lay_out([("arch", tube)]), len(tube)
    found = [text.text for page in sheets.lay_out([("arch", tube)]) for text in page.texts]
    for k in range(1, count + 1):
        assert f"unit {k}" in found
    assert found.count("start") == found.count("end") == 1
    assert found.count("to unit 2") == (2 if count > 2 else 1)
    assert found.count("1") == found.count("6.") == 2 * count
    assert any(text.text.startswith("arch") for text in page.texts)


def test_a_net_too_large_for_the_sheet_falls_apart():
    unit = plane_unit(np.radians(45), 0.45, 230.0, 92.0)
    tube = single(unit)
    (one,) = sheets.lay_out([("big", tube)])
    assert len(one.nets) == 1
    pages = sheets.lay_out([("big", tube)], "A4")
    nets = [net for page in pages for net in page.nets]
    assert len(nets) > 1
    check(nets, unit)
    with pytest.raises(ValueError, match=r"Unit 1: Panel contact_\w+ is too large for the sheet"):
        sheets.lay_out([("big", single(plane_unit(np.radians(45), 0.45, 400.0, 160.0)))], "A4")


@pytest.mark.parametrize("sheet", ["B5", "10x10", "600", (1, 2, 3), "axb", 7, (np.inf, 300)])
def test_unknown_sheets_are_refused(sheet):
    with pytest.raises(ValueError, match="use A4"):
        sheets.sheet_size(sheet)


def test_sheet_sizes():
    assert sheets.sheet_size("a3") == (420, 297)
    assert sheets.sheet_size("600x400") == (600, 400)
    with pytest.raises(ValueError, match="deep"):
        sheets.lay_out([("x", single(plane_unit(1.0, 0.6, 60.0, 24.0)))], tab_depth=-1.0)


def test_overlap_of_convex_polygons():
    square = np.array([0, 1, 1 + 1j, 1j])
    assert overlap(square, square + 0.5)
    assert overlap(square, (square - 0.5 - 0.5j) * np.exp(0.7j) + 1)
    assert not overlap(square, square + 1)  # side by side
    assert not overlap(square, square + 1 + 1j)  # corner to corner
    assert not overlap(square, square + 1.2)
