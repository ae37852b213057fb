# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tubes of cut panels: what other programs read from the files is the tube, and nests apart."""

import csv
import itertools

import numpy as np
import pytest

from BistableWB.exporters import cut_csv, cut_dxf, cut_html, cut_svg
from BistableWB.origami import rigid
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.rules import END_FIT
from BistableWB.origami.design import CurveGeometry, Placing, Single, TubeDesign
from BistableWB.origami.errors import Refusal
from BistableWB.origami.hinges.meshing import mesh_of
from BistableWB.origami.meshes import unpaired_edges
from BistableWB.origami.patterns.cut_plan import CutWishes, carried, cut_plan
from BistableWB.origami.patterns.nesting import distance
from BistableWB.origami.patterns.panel_hinges import PANEL_HINGES
from BistableWB.origami.patterns.panel_solid import panel_boundary
from BistableWB.origami.units.creases import (
    BODIES,
    CREASES,
    LAYER_HEIGHT_IN_PITCHES,
    layer_of,
)
from tests.judges import judge

pytestmark = pytest.mark.slow

STOCK = 2500, 1250
PERGOLA = Bezier([(0, 0), (2500, 3600), (7500, 3600), (10_000, 0)])
RISING = Bezier([(0, 0, 0), (2500, 3600, 300), (7500, 3600, 1200), (10_000, 0, 1500)])


SMALL = TubeDesign(Single(np.radians(50), edge_length=180))


def design(curve=PERGOLA, edge=1000.0, family="Plane"):
    legs = None if family == "Plane" else ("parallel", (0, 0, 1))
    geometry = CurveGeometry(curve, family, legs)
    return TubeDesign(Placing(geometry, edge, np.radians(20), rule=END_FIT))


@pytest.fixture(scope="module")
def exact():
    """Panels that end on their axes, so that they can be compared with the tube."""
    return cut_plan("Pergola", design(), CutWishes(edge_gap=0.0))


@pytest.fixture(scope="module")
def pergola():
    return cut_plan("Pergola", design(), CutWishes())


def area(points):
    return abs((np.roll(points, -1) * points.conj()).imag.sum()) / 2


def outlines_of_dxf(path):
    """{(sheet, label): corners} of the closed polylines on CUT, by the text inside each."""
    ezdxf = judge("ezdxf")
    space = ezdxf.readfile(path).modelspace()
    cuts = [
        np.array([complex(v.dxf.location.x, v.dxf.location.y) for v in line.vertices])
        for line in space.query('POLYLINE[layer=="CUT"]')
    ]
    found = {}
    for text in space.query('TEXT[layer=="LABEL"]'):
        at = complex(text.dxf.align_point.x, text.dxf.align_point.y)
        (around,) = [c for c in cuts if winds_round(c, at)]
        found[text.dxf.text] = around
    assert len(found) == len(cuts)
    return found


def winds_round(corners, point):
    turned = np.angle(np.roll(corners, -1) - point) - np.angle(corners - point)
    turned = (turned + np.pi) % (2 * np.pi) - np.pi
    return abs(turned.sum()) > 1


def axis_polygon(thick, unit, panel):
    """Corners of a panel: where its neighbouring hinge axes meet in plan."""
    lines = [
        thick.axes[unit, k][:, [0, 2]] @ [1, 1j]
        for k, crease in enumerate(CREASES)
        if panel in crease.bodies
    ]
    middle = np.mean(lines)
    lines.sort(key=lambda ends: np.angle(ends.mean() - middle))
    corners = []
    for (a, b), (c, d) in zip(lines, [*lines[1:], lines[0]], strict=True):
        u, v = b - a, d - c
        s = ((c - a) * v.conjugate()).imag / (u * v.conjugate()).imag
        corners.append(a + s * u)
    return np.array(corners)


def test_a_dxf_reader_finds_panels_of_the_areas_of_the_tube(exact, tmp_path):
    cut_dxf.write([exact], tmp_path / "it.cut.dxf")
    found = outlines_of_dxf(tmp_path / "it.cut.dxf")
    assert len(found) == len(exact.pieces) == 15 * len(exact.tube.tube)
    for piece in exact.pieces:
        assert area(found[piece.label]) == pytest.approx(piece.area, rel=1e-6)
        if piece.kind != "link":
            goal = axis_polygon(exact.tube.thick, piece.unit, piece.name)
            assert area(found[piece.label]) == pytest.approx(area(goal), rel=1e-5)
            sides = sorted(abs(np.roll(goal, -1) - goal))
            read = sorted(abs(np.roll(found[piece.label], -1) - found[piece.label]))
            assert read == pytest.approx(sides, abs=2e-3)


@pytest.mark.parametrize(("curve", "family"), [(PERGOLA, "Plane"), (RISING, "General")])
def test_panels_that_are_read_fold_back_to_the_tube(curve, family, tmp_path):
    """Cut, laid into the flat unit, opened and joined at the axes: the deployed tube."""
    plan = cut_plan("It", design(curve, family=family), CutWishes(edge_gap=0.0, hinge="Tape"))
    cut_dxf.write([plan], tmp_path / "it.cut.dxf")
    found = outlines_of_dxf(tmp_path / "it.cut.dxf")
    thick = plan.tube.thick
    poses, pitch = thick.poses(1.0), thick.pitch
    edges = {}
    for piece in plan.pieces:
        if piece.kind == "link":
            continue
        seen, local = found[piece.label], np.array(piece.outline)
        back = fitted(seen, local)  # a turn and a shift, no mirror image
        assert np.abs(back - local).max() < 1e-3
        pose = poses[piece.unit, BODIES.index(piece.name)]
        plan_points = back.conj() if piece.is_mirrored else back
        for k, crease in enumerate(piece.edges):
            height = next(c.height for c in CREASES if c.name == crease) * pitch
            ends = plan_points[[k, (k + 1) % len(local)]]
            corners = np.stack([ends.real, [height] * 2, ends.imag], 1)
            edges.setdefault((piece.unit, crease), []).append(rigid.apply(pose, corners))
    single = {crease.name for crease in CREASES if not crease.double}
    checked = 0
    for (_, crease), both in edges.items():
        if crease in single:
            (a, b), (c, d) = both
            along = (d - c) / np.linalg.norm(d - c)
            for point in (a, b):
                assert np.linalg.norm(np.cross(point - c, along)) < 2e-3
            checked += 1
    assert checked == len(single) * len(thick)
    assert plan.tube.deviation() < 1e-3


def fitted(points, goal):
    """Points turned and shifted onto a goal."""
    turn = np.vdot(points - points.mean(), goal - goal.mean())
    return turn / abs(turn) * (points - points.mean()) + goal.mean()


def test_pieces_lie_apart_on_their_sheets(pergola):
    manifold3d = judge("manifold3d")
    sheets = {}
    for place in pergola.placed:
        corners = carried(np.array(pergola.pieces[place.piece].outline), place)
        assert corners.real.min() >= 14.9
        assert corners.imag.min() >= 14.9
        assert corners.real.max() <= STOCK[0] - 14.9
        assert corners.imag.max() <= STOCK[1] - 14.9
        sheets.setdefault(place.sheet, []).append(corners)
    assert sorted(sheets) == list(range(pergola.sheet_count))
    assert sorted(place.piece for place in pergola.placed) == list(range(len(pergola.pieces)))
    for laid in sheets.values():
        shapes = [manifold3d.CrossSection([np.stack([c.real, c.imag], 1).tolist()]) for c in laid]
        wide = [s.offset(3.5, manifold3d.JoinType.Round) for s in shapes]
        for a, b in itertools.combinations(range(len(laid)), 2):
            assert (wide[a] ^ wide[b]).area() == 0
    assert distance(np.array([0, 1, 1j]), np.array([2, 3, 2 + 1j])) == pytest.approx(1)


def test_the_pergola_fits_its_sheets_and_its_list_says_so(pergola, tmp_path):
    assert pergola.sheet_count <= 28
    assert pergola.utilisation > 0.6
    cut_csv.write([pergola], tmp_path / "it.cut.csv")
    rows = list(csv.reader((tmp_path / "it.cut.csv").read_text(encoding="utf-8").splitlines()))
    blank = rows.index([])
    pieces = [dict(zip(rows[0], row, strict=True)) for row in rows[1:blank]]
    hinges = [dict(zip(rows[blank + 1], row, strict=True)) for row in rows[blank + 2 :]]
    assert len(pieces) == 15 * len(pergola.tube.tube)
    assert len(hinges) == 23 * len(pergola.tube.tube)
    assert max(int(row["sheet"]) for row in pieces) == pergola.sheet_count
    for row in pieces:
        assert float(row["length_mm"]) <= STOCK[0]
    total = sum(float(row["area_mm2"]) for row in pieces)
    share = total / (pergola.sheet_count * STOCK[0] * STOCK[1])
    assert share == pytest.approx(pergola.utilisation, abs=1e-4)
    page = cut_html.page_of(pergola)
    assert "no play, so there is no snap margin" in page
    assert page.count("<svg") == pergola.sheet_count
    assert " inf" not in page
    assert "nan" not in page


def test_svg_paths_run_half_a_kerf_outside(pergola, tmp_path):
    svgelements = judge("svgelements")
    wide = cut_plan("Pergola", design(), CutWishes(kerf=4.0))
    areas = []
    for plan in (pergola, wide):
        cut_svg.write([plan], tmp_path / "it.cut.svg", page=1)
        svg = svgelements.SVG.parse(tmp_path / "it.cut.svg", ppi=25.4)
        cut = next(g for g in svg.select() if getattr(g, "id", "") == "cut")
        points = [
            np.array([complex(p) for p in itertools.islice(path.as_points(), 0, None)])
            for path in cut
        ]
        areas.append(sorted(area(np.array(list(dict.fromkeys(p.tolist())))) for p in points))
        known = sorted(plan.pieces[place.piece].area for place in plan.placed if place.sheet == 0)
        if plan is pergola:
            assert areas[0] == pytest.approx(known, rel=1e-4)
        else:
            for got, piece in zip(areas[1], known, strict=True):
                assert got > piece + 2 * 2 * np.sqrt(np.pi * piece)  # kerf / 2 · perimeter


@pytest.mark.parametrize("hinge", PANEL_HINGES)
def test_screws_lie_inside_their_panels_on_the_face_that_is_seen(hinge):
    plan = cut_plan("It", design(), CutWishes(hinge=hinge))
    kind = PANEL_HINGES[hinge]
    pitch = 18.0 + kind.gap
    assert any(piece.holes for piece in plan.pieces) == bool(kind.screw_pitch)
    for piece in plan.pieces:
        outline = np.array(piece.outline)
        for place, _ in piece.holes:
            assert winds_round(outline, place)
        if piece.kind == "link" or not piece.holes:
            continue
        corners = outline.conj() if piece.is_mirrored else outline
        a, b, c = (np.array([p.real, 0.0, p.imag]) for p in corners[:3])
        up = np.sign(np.cross(b - a, c - b)[1])  # towards whom it is anticlockwise
        height = LAYER_HEIGHT_IN_PITCHES[layer_of(piece.name)] * pitch
        creases = [k for k in CREASES if piece.name in k.bodies]
        sides = [np.sign(k.height * pitch - height) for k in creases]
        assert sum(side == up for side in sides) * 2 >= len(sides)
        seen = sum(seen for _, seen in piece.holes)
        assert (seen == len(piece.holes)) == all(side == up for side in sides)


@pytest.mark.parametrize(
    ("make", "words"),
    [
        (lambda: cut_plan("It", design(edge=2600.0), CutWishes()), "larger than a sheet"),
        (lambda: cut_plan("It", SMALL, CutWishes()), "too short for leaves"),
        (lambda: CutWishes(hinge="Rope"), "choose one of Piano"),
        (lambda: CutWishes(panel_thickness=0), "panel_thickness is 0"),
        (lambda: CutWishes(kerf=float("nan")), "kerf is nan"),
        (lambda: cut_plan("It", design(), CutWishes(stock="large")), "2500x1250"),
    ],
)
def test_what_cannot_be_cut_is_refused_with_the_cure(make, words):
    with pytest.raises(Refusal, match=words):
        make()


def test_the_edge_length_that_a_refusal_names_fits():
    with pytest.raises(Refusal) as error:
        cut_plan("It", design(), CutWishes(stock="900x600"))
    assert error.value.parameter == "EdgeLength"
    most = float(error.value.message.pieces["most"])
    cut_plan("It", design(edge=most), CutWishes(stock="900x600"))


def test_a_panel_with_pilot_holes_is_closed_and_lacks_what_is_drilled():
    outline = [0j, 400 + 0j, 380 + 250j, 20 + 250j]
    holes = [(50 + 20j, True), (200 + 20j, True), (60 + 230j, False)]
    mesh = mesh_of(panel_boundary(outline, holes, 2.0, 18.0), 0.001).mesh
    assert not len(unpaired_edges(mesh.triangles))
    drilled = 3 * np.pi * 1.0**2 * 12.0
    assert mesh.volume == pytest.approx(380 * 250 * 18 - drilled, abs=0.02 * drilled)
    below = mesh.vertices[np.abs(mesh.vertices[:, 2] - 12) < 1e-6]
    assert np.linalg.norm(below[:, :2] - [60, 230], axis=1) == pytest.approx(1, abs=1e-6)
