# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures: what is hidden is hidden, scales are equal, nothing is clipped."""

import numpy as np
import pytest

from BistableWB import colours
from BistableWB.origami import tube as tubes
from BistableWB.origami.bezier import Bezier
from BistableWB.origami.placement import place
from BistableWB.origami.ratios import RatioRule

pytest.importorskip("matplotlib")
from BistableWB import pictures
from BistableWB.pictures import rendering, states

FRONT = rendering.Camera(np.eye(3))  # looks down on the xy plane
SQUARE = np.array([[0.0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0]])


@pytest.fixture(scope="module")
def arch():
    curve = Bezier([(0, 0), (60, 120), (180, 120), (240, 0)])
    placed = place(curve, 60, np.radians(20))
    return curve, placed, tubes.along(placed, "Plane", 2.5, RatioRule())


def shade(code):
    return np.array(colours.rgb(code))


def test_the_nearer_panel_hides_the_other_whatever_their_order():
    near, far = SQUARE * 0.5 + [2.5, 2.5, 4], SQUARE
    for order in ((near, far), (far, near)):
        fills = ["#ff0000" if p is near else "#0000ff" for p in order]
        image, (left, right, bottom, top) = rendering.render(FRONT, order, fills, 20)
        rows, columns = image.shape[:2]
        middle, rim = image[rows // 2, columns // 2], image[rows // 2, int(0.1 * columns)]
        assert middle[0] > 0.5 > middle[2]
        assert rim[2] > 0.3 > rim[0]
        assert (right - left) / columns == pytest.approx((top - bottom) / rows)


def test_crossing_panels_each_hide_a_part():
    tilted = SQUARE.copy()
    tilted[:, 2] = SQUARE[:, 0] - 5
    image, _ = rendering.render(FRONT, [SQUARE, tilted], ["#0000ff", "#ff0000"], 20)
    row = image[image.shape[0] // 2]
    assert row[len(row) // 4, 2] > row[len(row) // 4, 0]
    assert row[3 * len(row) // 4, 0] > row[3 * len(row) // 4, 2]


def test_nothing_is_clipped_and_the_ground_is_transparent():
    image, _ = rendering.render(FRONT, [SQUARE], ["#ff0000"], 20)
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


def test_colours_of_panels_differ_in_lightness_too():
    """So that they stay apart in greyscale and for colour-blind eyes."""
    grey = sorted(shade(code) @ [0.2126, 0.7152, 0.0722] for code in colours.PANELS.values())
    assert min(np.diff(grey)) > 0.08


def test_without_matplotlib_one_sentence_says_what_to_install(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(pictures.NoMatplotlib, match="install python3-matplotlib"):
        pictures.require()
