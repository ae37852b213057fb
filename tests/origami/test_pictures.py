# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures: what is hidden is hidden, scales are equal, nothing is clipped."""

import numpy as np
import pytest

from BistableWB import colours
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.units import tube as tubes
from BistableWB.origami.units.ratios import RatioRule

pytest.importorskip("matplotlib")
from BistableWB import pictures
from BistableWB.origami.meshes import Mesh, PlacedMesh
from BistableWB.pictures import film, hinge, page, prints, rendering, shading, stage, states
from BistableWB.pictures.raster import rasterise

pytestmark = pytest.mark.slow

FRONT = rendering.Camera(np.eye(3))  # looks down on the xy plane
SQUARE = np.array([[0.0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]])


@pytest.fixture(scope="module")
def arch():
    curve = Bezier([(0, 0), (60, 120), (180, 120), (240, 0)])
    placed = place(curve, 60, np.radians(20))
    return curve, placed, tubes.along(placed, "Plane", 2.5, RatioRule())


def shade(code):
    return np.array(colours.rgb(code))


def drawn(polygons, fills):
    return shading.render_solids(FRONT, stage.sheets(polygons, fills), 20)


def test_the_nearer_panel_hides_the_other_whatever_their_order():
    near, far = SQUARE * 0.5 + [2.5, 2.5, 4], SQUARE
    for order in ((near, far), (far, near)):
        fills = ["#ff0000" if p is near else "#0000ff" for p in order]
        image, (left, right, bottom, top) = drawn(order, fills)
        rows, columns = image.shape[:2]
        middle, rim = image[rows // 2, columns // 2], image[rows // 2, int(0.1 * columns)]
        assert middle[0] > 0.5 > middle[2]
        assert rim[2] > 0.3 > rim[0]
        assert (right - left) / columns == pytest.approx((top - bottom) / rows)


def test_crossing_panels_each_hide_a_part():
    tilted = SQUARE.copy()
    tilted[:, 2] = SQUARE[:, 0] - 5
    image, _ = drawn([SQUARE, tilted], ["#0000ff", "#ff0000"])
    row = image[image.shape[0] // 2]
    assert row[len(row) // 4, 2] > row[len(row) // 4, 0]
    assert row[3 * len(row) // 4, 0] > row[3 * len(row) // 4, 2]


def test_nothing_is_clipped_and_the_ground_is_transparent():
    image, _ = drawn([SQUARE], ["#ff0000"])
    alpha = image[..., 3]
    assert alpha[0].max() == alpha[-1].max() == alpha[:, 0].max() == alpha[:, -1].max() == 0
    assert alpha.sum() / 20**2 == pytest.approx(100, rel=0.03)


def test_a_camera_is_a_right_handed_frame():
    view = rendering.camera((1, 2, 0.5), (0, 0, 1), 0.6)
    assert view.axes @ view.axes.T == pytest.approx(np.eye(3))
    assert np.linalg.det(view.axes) == pytest.approx(1)
    assert view.seen([0, 0, 1])[1] > 0  # up is up
    assert view.seen([1, 2, 0])[2] < 0  # ahead is away


def test_the_stack_has_every_sheet_at_a_height_of_its_own(arch):
    _, _, tube = arch
    stacked = states._stack(tube, 2.0)
    polygons, kinds = states._polygons(stacked, tube)
    assert len(polygons) == len(kinds) == 12 * len(tube)
    heights = np.array([p[:, 2] for p in map(np.asarray, polygons)], dtype=object)
    assert all(np.ptp(h) < 1e-9 for h in heights)
    levels = {round(float(h[0]), 6) for h in heights}
    assert len(levels) == 4 * len(tube)
    assert max(levels) - min(levels) == pytest.approx(2.0 * (4 * len(tube) - 1))


def test_a_shared_contact_panel_is_drawn_once(arch):
    _, _, tube = arch
    polygons, kinds = states._polygons(tube.deployed(), tube)
    assert kinds.count("contact") == len(tube) + 1
    assert len(polygons) == 11 * len(tube) + 1


def test_pictures_are_made_for_tubes_of_any_size(arch, tmp_path):
    from matplotlib.image import imread

    curve, placed, tube = arch
    plan = pictures.top_view(tmp_path / "plan.png", placed, curve, np.radians(20))
    angles = pictures.angle_chart(
        tmp_path / "angles.png", placed.thetas, tube.unit.ratio, placed.sides
    )
    alone = tubes.single(tubes.make_unit("Plane", np.array([0.8]), 60, 2.5, RatioRule()))
    unit = pictures.both_states(tmp_path / "unit.png", alone)
    for path in (plan, angles, unit):
        image = imread(path)[..., :3]
        assert image.shape[1] >= 700
        border = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
        assert border.min() > 0.99, f"{path.name} is clipped"
        assert image.min() < 0.3
    vector = pictures.angle_chart(tmp_path / "angles.svg", [0.8], 0.5)
    assert vector.read_text().startswith("<?xml")


def cube(size=10.0, at=(0.0, 0, 0)):
    """`Mesh` of a cube, its outside outside."""
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)]) * size + at
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return Mesh(corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))]))


def test_the_rasteriser_agrees_with_every_triangle_taken_by_itself():
    corners = np.random.default_rng(5).uniform(-5, 45, (60, 3, 3))
    near, owner = rasterise(corners, 40, 30)
    y, x = np.mgrid[:30, :40] + 0.5
    best = np.full((30, 40), -np.inf)
    for a, b, c in corners:
        m = np.stack([b - a, c - a])
        share = np.stack([x - a[0], y - a[1]], -1) @ np.linalg.inv(m[:, :2])
        inside = (share >= 0).all(-1) & (share.sum(-1) <= 1)
        best = np.maximum(best, np.where(inside, a[2] + share @ m[:, 2], -np.inf))
    assert ((owner >= 0) == np.isfinite(best)).all()
    assert near[owner >= 0] == pytest.approx(best[owner >= 0], abs=1e-3)


def test_neighbouring_triangles_leave_no_hole():
    view = rendering.camera((0.3, 1, 0), (0, 0, 1), 0.5)
    image, _ = shading.render_solids(view, [shading.Solid(cube().corners, "#ff0000")], 23)
    alpha = image[..., 3]
    for line in (*alpha, *alpha.T):
        covered = np.flatnonzero(line > 0.5)
        assert not len(covered) or (line[covered[0] : covered[-1] + 1] > 0.5).all()
    assert alpha[0].max() == alpha[-1].max() == alpha[:, 0].max() == alpha[:, -1].max() == 0


def test_a_cut_solid_shows_its_inside_filled():
    solid = shading.Solid(cube().corners, "#ff0000")
    image, extent = shading.render_solids(FRONT, [solid], 20, cut=((0, 0, 4), (0.2, 0, 1)))
    middle = image[image.shape[0] // 2, :, :3][20:-20]
    assert (middle[:, 0] > 0.5).all()
    assert extent[1] - extent[0] == pytest.approx(10, abs=0.5)
    corners, body = shading._cut_off(
        solid.corners, np.zeros(12, int), np.array([0, 0, 4.0]), np.array([0, 0, 1.0])
    )
    assert corners[..., 2].max() == pytest.approx(4)
    area = np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    assert area.sum() / 2 == pytest.approx(100 + 4 * 40)
    assert len(body) == len(corners)


def test_a_solid_casts_its_shadow_on_the_ground_only_where_light_is_hidden():
    view = rendering.camera((0, 1, 0), (0, 0, 1), 0.7)
    ground = shading.Ground(np.array([-40.0, -40]), np.array([50.0, 50]), 0.0)
    image, extent = shading.render_solids(
        view, [shading.Solid(cube().corners, "#ff0000")], 8, [ground]
    )

    def brightness(point):
        x, y, _ = view.seen(point)
        row = image.shape[0] - 1 - int((y - extent[2]) * 8)
        return image[row, int((x - extent[0]) * 8), :3].mean()

    points = shading.shadow_points(view, [shading.Solid(cube().corners, "#ff0000")], 0.0)
    assert brightness([-30, -30, 0]) == pytest.approx(1, abs=0.01)
    assert brightness(0.3 * np.array([10, 5, 0]) + 0.7 * points[points[:, 0].argmax()]) < 0.9


def placed(name, mesh, kind="primary"):
    return PlacedMesh(name, mesh, np.eye(4), kind=kind)


def test_prints_are_drawn_without_clipping(tmp_path, monkeypatch):
    from matplotlib.image import imread

    from BistableWB.origami.hinges.parameters import HingeParameters

    for module in (page, prints, hinge):
        monkeypatch.setattr(module, "DPI", 60)
    bodies = [
        placed("unit01_primary_left_upper", cube()),
        placed("unit01_link_B", cube(8, (0, 0, 12)), "link"),
        placed("flexure_AB", cube(6, (0, 0, 22)), "flexure"),
    ]
    apart = [np.eye(4), np.eye(4), None]
    apart[1] = apart[1] + np.outer([1, 0, 0, 0], [0, 0, 0, 40.0])
    assert stage.kinds_of(bodies) == ["primary", "link", "flexure"]
    both = pictures.stack_and_tube(tmp_path / "both.png", bodies, apart, (1, 0, 0), (0, 1, 0))
    way = pictures.openings(tmp_path / "way.png", bodies[:2], {0: apart[:2], 0.5: apart[:2]})
    bed = pictures.print_on_bed(tmp_path / "bed.png", [placed("plate", cube())])
    names, axis = [body.name for body in bodies[:2]], np.array([[0, 0, 5.0], [10, 0, 5]])
    close = pictures.hinge_detail(
        tmp_path / "hinge.png", bodies[:2], apart[:2], names, axis, HingeParameters()
    )
    for path in (both, way, bed):
        image = imread(path)[..., :3]
        border = np.concatenate([image[0], image[-1], image[:, 0], image[:, -1]])
        assert border.min() > 0.95, f"{path.name} is clipped"
        assert image.min() < 0.3
    assert imread(close)[..., :3].min() < 0.3


def test_a_film_goes_from_flat_to_deployed_and_back_for_ever(tmp_path, monkeypatch):
    from PIL import Image

    monkeypatch.setattr(film, "_FRAMES", 5)
    monkeypatch.setattr(film, "_WIDTH", 200)
    bodies = [
        placed("unit01_primary_left_upper", cube()),
        placed("unit01_link_B", cube(8, (0, 0, 12)), "link"),
    ]

    def motions(opening):
        aside = np.eye(4)
        aside[0, 3] = 40 * opening
        return [np.eye(4), aside]

    path = film.deployment(tmp_path / "a.gif", bodies, motions)
    with Image.open(path) as shown:
        frames, times = [], []
        for number in range(shown.n_frames):
            shown.seek(number)
            frames.append(np.asarray(shown.convert("RGB"), int))
            times.append(shown.info["duration"])
        assert shown.info["loop"] == 0
        assert shown.width == pytest.approx(200, abs=2)
    assert len(frames) == 8
    assert times == [film._HELD, *3 * [film._PAUSE], film._HELD, *3 * [film._PAUSE]]
    for there, back in zip(frames[1:4], frames[:4:-1], strict=True):
        assert np.abs(there - back).max() < 8
    wide = [np.ptp(np.flatnonzero((frame.min(2) < 150).any(0))) for frame in frames[:5]]
    assert all(np.diff(wide) > 0)  # it opens
    for frame in frames:
        border = np.concatenate([frame[0], frame[-1], frame[:, 0], frame[:, -1]])
        assert border.min() > 200, "clipped"  # shadows may reach the border


def test_colours_of_panels_differ_in_lightness_too():
    """So that they stay apart in greyscale and for colour-blind eyes."""
    grey = sorted(shade(code) @ [0.2126, 0.7152, 0.0722] for code in colours.PANELS.values())
    assert min(np.diff(grey)) > 0.08


def test_without_matplotlib_one_sentence_says_what_to_install(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(pictures.NoMatplotlib, match="install python3-matplotlib"):
        pictures.require()
