# SPDX-License-Identifier: LGPL-2.1-or-later
"""The processes: what each gives makes hinges, and a gap that it cannot keep open is refused."""

import pytest

from BistableWB.origami.errors import Refusal
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.processes import PROCESSES
from BistableWB.origami.snap.materials import MATERIALS


@pytest.mark.parametrize("name", PROCESSES)
def test_what_a_process_gives_makes_hinges(name):
    process = PROCESSES[name]
    made = HingeParameters(process=name, **process.gives)
    made.check()
    assert not made.warnings()
    assert process.material in MATERIALS
    assert process.orientation in ("Flat", "OnEdge")
    assert process.sources


@pytest.mark.parametrize(("field", "name"), [
    ("gap_length", "GapLength"), ("gap_between_planes", "GapBetweenPlanes"),
])  # fmt: skip
def test_a_gap_below_the_least_of_the_process_is_refused(field, name):
    powder = PROCESSES["Powder"].gives
    with pytest.raises(Refusal, match=r"Powder keeps no gap below 0\.3 mm open") as said:
        HingeParameters(process="Powder", **{**powder, field: 0.25}).check()
    assert said.value.parameter == name


def test_an_unknown_process_is_refused():
    with pytest.raises(Refusal, match="Process 'Clay' is unknown"):
        HingeParameters(process="Clay").check()
