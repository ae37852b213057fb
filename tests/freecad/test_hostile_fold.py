# SPDX-License-Identifier: LGPL-2.1-or-later
"""FOLD files that somebody has changed: refused in one sentence, whatever stands where."""

import copy
import json

import numpy as np
import pytest

from BistableWB import make
from BistableWB.exporters import export
from BistableWB.imports.fold import read_unit
from BistableWB.origami.errors import Refusal

WRONG = (10**400, -(10**400), 1e308, float("nan"), float("inf"), None, [], {}, "x", True, -1, 0,
         [[[]]], 10**20)  # fmt: skip


def places(value, path=()):
    """Paths to what a JSON value holds; of long lists the first three entries."""
    if path:
        yield path
    if isinstance(value, dict):
        for key in value:
            yield from places(value[key], (*path, key))
    elif isinstance(value, list):
        for k in range(min(len(value), 3)):
            yield from places(value[k], (*path, k))


def changed(content, path, wrong):
    """The content with something else at one place."""
    content = copy.deepcopy(content)
    inner = content
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = wrong
    return json.dumps(content)


def read_or_refused(path):
    try:
        return read_unit(path)
    except Refusal as refused:
        return refused


@pytest.mark.slow
def test_whatever_stands_anywhere_it_is_the_unit_or_a_refusal(doc, tmp_path):
    unit = make.make_bistable_unit(doc)
    doc.recompute()
    path = tmp_path / "unit.fold"
    export([unit], path)
    content = json.loads(path.read_text())
    good, tried = read_unit(path), 0
    for place in places(content):
        for wrong in WRONG:
            path.write_text(changed(content, place, wrong))
            tried += 1
            found = read_or_refused(path)
            if isinstance(found, Refusal):
                assert str(found).isprintable()
            else:
                assert found[:-1] == good[:-1]
                assert found.place == pytest.approx(np.asarray(good.place), abs=1e-6)
    assert tried > 2000


@pytest.mark.parametrize("text", ["[" * 100_000, '{"a":' * 100_000, "[" * 9000 + "]" * 9000])
def test_deep_nesting_is_refused(tmp_path, text):
    path = tmp_path / "deep.fold"
    path.write_text(text)
    with pytest.raises(Refusal, match=r"is not a (whole )?FOLD file"):
        read_unit(path)
