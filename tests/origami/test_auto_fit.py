# SPDX-License-Identifier: LGPL-2.1-or-later
"""The search for designs that fit a bed and snap."""

import numpy as np
import pytest

from BistableWB.origami import auto_fit as search
from BistableWB.origami import fit_steps, snap
from BistableWB.origami import tube as tubes
from BistableWB.origami.auto_fit import Course, Wanted, auto_fit, rule_of
from BistableWB.origami.bezier import Bezier
from BistableWB.origami.linkage import ThickUnit
from BistableWB.origami.placement import place

pytestmark = pytest.mark.slow

ARCH = Bezier([[0, 0, 0], [90, 180, 0], [270, 180, 0], [360, 0, 0]])


@pytest.fixture(scope="module")
def small():
    """A small search: three edges, two angles, two measurements."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(fit_steps, "EDGES", 3)
        patch.setattr(fit_steps, "GAMMAS", tuple(np.radians([18, 26])))
        patch.setattr(fit_steps, "_MEASURED", 2)
        yield


@pytest.fixture(scope="module")
def fit(small):
    seen = []
    found = auto_fit(Course(ARCH), Wanted(), lambda *step: seen.append(step))
    return found, seen


def test_candidates_meet_the_wishes(fit):
    found, _ = fit
    wanted = found.wanted
    assert found.tried == 6
    assert 1 <= len(found.candidates) <= 2
    for c in found.candidates:
        assert c.margin_min >= 0.97 * wanted.margin
        assert c.strain_max <= wanted.strain_limit
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
    """Placed and made by hand, the weakest unit of the whole tube is as weak as was said."""
    wanted, best = fit[0].wanted, fit[0].recommended
    placed = place(ARCH, best.edge_length, best.gamma, wanted.pitch)
    assert len(placed) == best.count
    rule = rule_of(best.rule, best.share, wanted, best.edge_length)
    tube = tubes.along(placed, "Plane", wanted.height_ratio, rule)
    some = tube.unit[np.unique(np.linspace(0, best.count - 1, 5).round().astype(int))]
    thick = ThickUnit(some, wanted.face_thickness, wanted.gap_between_planes).compensated()
    found = snap.assess(thick, wanted.play)
    assert found.margin.min() >= 0.97 * best.margin_min
    assert found.strain.max() <= 1.03 * best.strain_max


def test_progress_goes_forward(fit):
    fractions = [fraction for fraction, _ in fit[1]]
    assert fractions == sorted(fractions)
    assert fractions[-1] == 1
    assert all(text for _, text in fit[1])


def test_an_exception_cancels(small):
    class Cancelled(Exception):
        pass

    def progress(fraction, text):
        if fraction > 0.2:
            raise Cancelled

    with pytest.raises(Cancelled):
        auto_fit(Course(ARCH), Wanted(), progress)


@pytest.mark.parametrize(
    ("wishes", "limit", "cure"),
    [
        ({"margin": 8.0}, "snap too weakly: margin", "less play"),
        ({"bed": (250, 210, 15)}, "print higher than 15 mm", "higher bed"),
        ({"bed": (30, 30, 210)}, "too large for the bed of 30 × 30 mm", "larger bed"),
        ({"strain_limit": 0.002}, "beyond 0.20%", "tougher material"),
    ],
)
def test_where_nothing_fits_it_says_why_and_what_helps(small, wishes, limit, cure):
    with pytest.raises(ValueError, match="Nothing fits") as refused:
        auto_fit(Course(ARCH), Wanted(**wishes))
    assert limit in str(refused.value)
    assert cure in str(refused.value)


def test_a_sphere_has_its_one_ratio(small, monkeypatch):
    monkeypatch.setattr(fit_steps, "GAMMAS", (np.radians(25),))

    class GreatCircle:
        def point(self, s):
            turn = (np.asarray(s, float) - 0.5) * 500 / 300
            return 300 * np.stack([np.sin(turn), 0 * turn, np.cos(turn)], -1)

    course = Course(GreatCircle(), "Sphere", ("point", np.zeros(3)), 300.0)
    found = auto_fit(course, Wanted(margin=1.2))
    assert {c.rule for c in found.candidates} == {"Exact"}
    assert all(c.share is None for c in found.candidates)


@pytest.mark.parametrize("name", ["margin", "play", "face_thickness", "strain_limit"])
def test_bad_wishes_are_refused(name):
    with pytest.raises(ValueError, match="set it to a number above 0"):
        auto_fit(Course(ARCH), Wanted(**{name: 0.0}))


def test_undominated():
    assert sorted(fit_steps.undominated([(1, 2), (2, 1), (2, 2), (1, 2)])) == [0, 1]
    assert search.Fit([], 0, Wanted()).tried == 0
