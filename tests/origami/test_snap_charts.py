# SPDX-License-Identifier: LGPL-2.1-or-later
"""Charts of snap: they are drawn, for one unit, few and many, with and without play."""

import numpy as np
import pytest

from BistableWB.origami.fit.search import Candidate, Fit, Wanted

pytest.importorskip("matplotlib")
from BistableWB.pictures import snap_charts

pytestmark = pytest.mark.slow


def drawn(path):
    return path.stat().st_size > 8000 and path.read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize("count", [1, 3, 30])
def test_energy(tmp_path, count):
    fractions = np.linspace(0, 1, 30)
    energies = np.linspace(1, 2, count)[:, None] * 1e-5 * np.sin(np.pi * fractions) ** 2
    assert drawn(snap_charts.energy_chart(tmp_path / "energy.png", fractions, energies))


@pytest.mark.parametrize("margins", [[np.inf], [0.4, 1.6, 1.0], np.linspace(0.5, 2, 60)])
def test_margins(tmp_path, margins):
    assert drawn(snap_charts.margin_chart(tmp_path / "margins.png", margins, target=1.5))


def test_candidates(tmp_path):
    row = (8, (0.5, 0.9), 1.5, 0.01, 3, (90.0, 95.0, 57.0), 0.95)
    rows = [
        Candidate(90.0, 0.4, "TargetSnap", None, *row, 3.0, (1.0,) * 5),
        Candidate(70.0, 0.5, "Adaptive", 0.045, *row, 2.0, (1.1,) * 5),
    ]
    assert drawn(snap_charts.fit_chart(tmp_path / "fit.png", Fit(rows, 48, Wanted())))
