# SPDX-License-Identifier: LGPL-2.1-or-later
"""One design file makes all parts of a long tube, and one makes its tube printable."""

import pytest

from BistableWB.designs.building import build
from BistableWB.designs.outputs import wanted_files
from BistableWB.designs.reading import DesignError, check, read
from BistableWB.origami.progress import Progress

DESIGN = """
[design]
name = "Long"
[curve]
points = [[0, 0], [0, 160], [220, 160], [220, 0]]
[triangles]
edge_length = 60
gamma = 25
[hinges]
bed = [250, 210, 60]
[output]
formats = ["stl"]
parts = true
pictures = false
report = false
"""


def test_a_long_tube_comes_in_parts_that_fit_the_bed(doc, tmp_path):
    path = tmp_path / "long.toml"
    path.write_text(DESIGN, encoding="utf-8")
    design = read(path)
    objects = build(doc, design)
    files = list(wanted_files(design, objects))
    names = [name for _, name, _ in files]
    assert names == [f"-print-part{n}.stl" for n in range(1, len(names) + 1)]
    assert len(names) >= 2
    last = 0
    for hinges, _, _ in files:
        assert hinges.isValid()
        assert hinges.FirstUnit == last + 1
        assert hinges.PrintSize.z <= 60
        last = hinges.LastUnit
    assert last == objects["triangles"].Count


PRINTABLE = """
[design]
make_printable = true
snap_margin = 1.3
[curve]
points = [[0, 0], [120, 240], [360, 240], [480, 0]]
[hinges]
bed = [250, 210, 24]
"""


def test_a_design_file_makes_its_tube_printable(doc, tmp_path):
    path = tmp_path / "arch.toml"
    path.write_text(PRINTABLE, encoding="utf-8")
    design, told, problems = read(path), [], []
    objects = build(doc, design, Progress(lambda text, fraction: told.append(text)), problems)
    assert problems == []
    assert any("EdgeLength" in text and "→" in text for text in told)
    prints = {hinges for hinges, *_ in wanted_files(design, objects)}
    assert len(prints) >= 2
    margins = [m for hinges in prints for m in hinges.SnapMargins]
    assert len(margins) == objects["triangles"].Count
    assert min(margins) >= 0.999 * 1.3
    assert objects["triangles"].EndGap.Value <= 0.01 * objects["triangles"].EdgeLength.Value
    assert all(hinges.PrintSize.z <= 24 for hinges in prints)


def test_a_curve_that_is_too_short_says_how_much_longer_it_must_be(doc, tmp_path):
    text = PRINTABLE.replace("[120, 240], [360, 240], [480, 0]", "[4, 3], [9, 0]")
    with pytest.raises(DesignError, match=r"too short.*drawn .* times as large, .* mm longer"):
        build(doc, check(tmp_path / "short.toml", text))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("[hinges]", "[triangles]\ngamma = 20\n[hinges]"), "gamma is chosen by make_printable"),
        (("[hinges]\nbed = [250, 210, 24]", ""), r"needs a table \[hinges\]"),
        (("make_printable = true\n", ""), "snap_margin is for make_printable"),
        (("1.3", "-1"), "snap_margin is -1"),
    ],
)
def test_what_make_printable_cannot_use_is_said(tmp_path, change, said):
    with pytest.raises(DesignError, match=said):
        check(tmp_path / "arch.toml", PRINTABLE.replace(*change))
