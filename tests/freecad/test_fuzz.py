# SPDX-License-Identifier: LGPL-2.1-or-later
"""A slice of ``make fuzz``: the same seeds each time, so that a red run can be had again."""

import pytest

from tests.fuzz.run import tried

pytestmark = pytest.mark.slow


def test_hostile_designs_break_nothing():
    done, problems, told = tried(seed=20_000, count=150)
    assert done == 150
    assert not problems
    assert told["made anew"] > 50
    assert told["reopen"] > 20
    assert sum(count for text, count in told.items() if "refused" in text) > 100
