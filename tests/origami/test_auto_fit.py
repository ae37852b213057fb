# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search for designs that fit a bed and snap."""

import numpy as np
import pytest

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.fit import search, steps
from BistableWB.origami.fit.search import Course, Wanted, auto_fit, rule_of
from BistableWB.origami.progress import Cancelled, Progress
from BistableWB.origami.snap import margin
from BistableWB.origami.snap.bearing import Preloader
from BistableWB.origami.snap.contact import holding
from BistableWB.origami.snap.table import USUAL
from BistableWB.origami.thick.thick_tube import thick_tube
from BistableWB.origami.units import tube as tubes

pytestmark = pytest.mark.slow

ARCH = Bezier([[0, 0, 0], [90, 180, 0], [270, 180, 0], [360, 0, 0]])


@pytest.fixture(scope="module")
def small():
    """A small search: three edges, two angles, two measurements."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(steps, "EDGES", 3)
        patch.setattr(steps, "GAMMAS", tuple(np.radians([18, 26])))
        patch.setattr(steps, "_MEASURED", 2)
        yield


@pytest.fixture(scope="module")
def fit(small):
    seen = []
    found = auto_fit(Course(ARCH), Wanted(), Progress(lambda text, part: seen.append((part, text))))
    return found, seen


def test_candidates_meet_the_wishes(fit):
    found, _ = fit
    wanted = found.wanted
    assert found.tried == 6
    assert 1 <= len(found.candidates) <= 2
    for c in found.candidates:
        assert c.margin_min >= 0.95 * wanted.margin
        assert wanted.holds(*c.print_size[:2])
        assert c.print_size[2] == wanted.height(c.count) <= wanted.bed[2]
        assert 0.75 <= c.coverage <= 1
        assert 0 < c.deviation < c.edge_length


def test_the_best_comes_first_and_none_is_beaten(fit):
    candidates = fit[0].candidates
    assert fit[0].recommended is candidates[0]
    assert [c.score for c in candidates] == sorted(c.score for c in candidates)
    used = np.array([c.used for c in candidates])
    for row in used:
        assert not ((used <= row).all(1) & (used < row).any(1)).any()


def test_a_candidate_is_what_one_gets(fit):
    """The whole tube made as a hinge set makes it: its weakest unit is as weak as was said."""
    wanted, best = fit[0].wanted, fit[0].recommended
    rule = rule_of(best.rule, best.share, wanted, best.edge_length)

    def placed(tuning):
        return place(ARCH, best.edge_length, best.gamma, wanted.pitch, extra=tuning.extra)

    def made(found, tuning):
        return tubes.along(found, "Plane", wanted.height_ratio, rule, tuning=tuning)

    sizes = wanted.face_thickness, wanted.gap_between_planes
    tube = thick_tube(placed, made, *sizes, preload=Preloader(None, wanted.parameters))
    assert len(tube.tube) == best.count
    found = margin.assess(tube.thick, holding(tube.thick, USUAL))
    assert found.margin.min() == pytest.approx(best.margin_min, rel=0.01)
    assert found.margin.argmin() + 1 == best.weakest
    assert found.strain.max() == pytest.approx(best.strain_max, rel=0.01)


def test_progress_goes_forward(fit):
    fractions = [fraction for fraction, _ in fit[1]]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1
    assert all(text for _, text in fit[1])


def test_it_can_be_cancelled(small):
    seen = []
    progress = Progress(lambda text, fraction: seen.append(fraction), lambda: seen[-1:] >= [0.2])
    with pytest.raises(Cancelled):
        auto_fit(Course(ARCH), Wanted(), progress)
    assert max(seen) == 0.2  # where measuring began


@pytest.mark.parametrize(
    ("requirements", "limit", "cure"),
    [
        ({"margin": 8.0}, "snap too weakly: margin", "less play"),
        ({"bed": (250, 210, 15)}, "print higher than 15 mm", "higher bed"),
        ({"bed": (30, 30, 210)}, "too large for the bed of 30 × 30 mm", "larger bed"),
        ({"strain_limit": 0.002, "margin": 0.5}, "beyond 0.20%", "tougher material"),
    ],
)
def test_where_nothing_fits_it_says_why_and_what_helps(small, requirements, limit, cure):
    with pytest.raises(ValueError, match="Nothing fits") as refused:
        auto_fit(Course(ARCH), Wanted(**requirements))
    assert limit in str(refused.value)
    assert cure in str(refused.value)


def test_a_sphere_has_its_one_ratio(small, monkeypatch):
    monkeypatch.setattr(steps, "GAMMAS", (np.radians(25),))

    class GreatCircle:
        def point(self, s):
            turn = (np.asarray(s, float) - 0.5) * 500 / 300
            return 300 * np.stack([np.sin(turn), 0 * turn, np.cos(turn)], -1)

    course = Course(GreatCircle(), "Sphere", ("point", np.zeros(3)), 300.0)
    found = auto_fit(course, Wanted(margin=1.2))
    assert {c.rule for c in found.candidates} == {"Exact"}
    assert all(c.share is None for c in found.candidates)


@pytest.mark.parametrize("name", ["margin", "play", "face_thickness"])
def test_bad_wishes_are_refused(name):
    with pytest.raises(ValueError, match="set it to a number above 0"):
        auto_fit(Course(ARCH), Wanted(**{name: 0.0}))


def test_undominated():
    assert sorted(steps.undominated([(1, 2), (2, 1), (2, 2), (1, 2)])) == [0, 1]
    assert search.Fit([], 0, Wanted()).tried == 0
