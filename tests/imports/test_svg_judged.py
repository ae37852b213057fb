# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random drawings, read here and by svgelements, which shares no code with our reader."""

import io
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from BistableWB.imports import svg_path
from BistableWB.imports.lengths import measure
from BistableWB.imports.svg import read_svg
from tests.judges import judge

svgelements = judge("svgelements")

number = st.one_of(
    st.integers(-200, 200).map(float), st.floats(-200, 200).map(lambda x: round(x, 3))
)
radius = st.floats(0.5, 120).map(lambda x: round(x, 2))
flag = st.sampled_from("01")


def numbers(count):
    return st.lists(number, min_size=count, max_size=count).map(minified)


def minified(values):
    """Numbers as minifiers write them: no blank before a sign, no zero before a point."""
    text = ""
    for value in values:
        word = f"{value:g}"
        word = word.replace("0.", ".", 1) if word.lstrip("-").startswith("0.") else word
        text += word if word.startswith("-") or not text else f" {word}"
    return text


arc = st.tuples(radius, radius, number, flag, flag, numbers(2)).map(
    lambda a: f"{a[0]:g} {a[1]:g} {a[2]:g} {a[3]}{a[4]}{a[5]}"
)


def drawn(letters, *counts):
    """Commands after each other, such as "Cs": in capitals or not, with that many numbers."""
    return st.tuples(
        *(
            st.tuples(st.sampled_from(letter.upper() + letter.lower()), numbers(count))
            for letter, count in zip(letters, counts, strict=True)
        )
    ).map(lambda words: "".join(c + n for c, n in words))


# T and S only behind their like: svgelements mirrors control points of other commands too, which
# the specification (9.3.6, 9.3.7) excludes; and no radius of 0, of which it makes no line.
segment = st.one_of(
    drawn("L", 2), drawn("L", 4), drawn("H", 1), drawn("V", 1), drawn("C", 6), drawn("C", 12),
    drawn("CS", 6, 4), drawn("CSS", 6, 4, 4), drawn("Q", 4), drawn("QT", 4, 2),
    drawn("QTT", 4, 2, 2), drawn("M", 4),
    st.tuples(st.sampled_from("Aa"), arc).map("".join), st.sampled_from("Zz"),
)  # fmt: skip
paths = st.tuples(numbers(2), st.lists(segment, min_size=1, max_size=6)).map(
    lambda p: f"M{p[0]}{''.join(p[1])}"
)
small = st.floats(-3, 3).map(lambda x: round(x, 2))
transform = st.one_of(
    st.tuples(number, number).map(lambda t: f"translate({t[0]:g},{t[1]:g})"),
    st.tuples(small, small).map(lambda t: f"scale({t[0] or 1:g} {t[1] or 1:g})"),
    st.tuples(number, number, number).map(lambda t: f"rotate({t[0]:g} {t[1]:g} {t[2]:g})"),
    st.floats(-60, 60).map(lambda a: f"skewX({a:.3g})"),
    st.floats(-60, 60).map(lambda a: f"skewY({a:.3g})"),
    st.lists(small, min_size=6, max_size=6).map(
        lambda m: f"matrix({m[0] or 1:g} {m[1]:g} {m[2]:g} {m[3] or 1:g} {m[4]:g} {m[5]:g})"
    ),
)
transforms = st.lists(transform, max_size=3).map(" ".join)


def sampled(piece, count=4001):
    return piece.at(np.linspace(0, 1, count))


def length_of(points):
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def judged(segment):
    """The points of a segment of svgelements at equal parameters, as ours are."""
    t = np.linspace(0, 1, 33)
    return np.array([[p.x, p.y] for p in map(segment.point, t)])


@given(paths)
def test_path_data_draws_what_svgelements_draws(text):
    ours = [piece for sub in svg_path.PathData(text).subpaths for piece in sub]
    theirs = [
        s for s in svgelements.Path(text) if not isinstance(s, svgelements.Move) and _moves(s)
    ]
    ours = [piece for piece in ours if np.ptp(sampled(piece, 17), axis=0).max() > 1e-9]
    assert len(ours) == len(theirs), text
    for mine, other in zip(ours, theirs, strict=True):
        points = judged(other)
        off = np.abs(mine.at(np.linspace(0, 1, 33))[:, :2] - points).max()
        assert off < 1e-6 * (1 + np.abs(points).max()), (text, other)


def _moves(segment):
    return np.ptp(judged(segment), axis=0).max() > 1e-9


@given(paths, transforms, transforms, st.sampled_from(["mm", "cm", "in", "pt", "pc", "px", ""]),
       st.sampled_from(["", "none", "xMidYMid meet", "xMinYMax slice", "xMaxYMin"]))  # fmt: skip
def test_transforms_units_and_view_boxes_give_what_svgelements_gives(a, outer, inner, unit, fit):
    text = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="320{unit}" height="170{unit}" '
        f'viewBox="-20 10 400 300" preserveAspectRatio="{fit}">'
        f'<g transform="{outer}"><path d="{a}" transform="{inner}"/></g></svg>'
    )
    total = sum(length_of(sampled(p)) for s in _strokes(text) for p in s.pieces)
    drawing = svgelements.SVG.parse(io.StringIO(text), ppi=96.0, reify=False)
    points = [
        judged_fine(segment, shape.transform)
        for shape in drawing.elements()
        if isinstance(shape, svgelements.Path)
        for segment in shape
        if not isinstance(segment, svgelements.Move) and _moves(segment)
    ]
    other = sum(map(length_of, points)) * 25.4 / 96
    assert total == pytest.approx(other, rel=1e-6, abs=1e-6)


def judged_fine(segment, matrix):
    """Points of a segment, mapped: svgelements itself makes arcs of arcs that became ellipses."""
    points = np.asarray(segment.npoint(np.linspace(0, 1, 4001)), float)
    linear = np.array([[matrix.a, matrix.c], [matrix.b, matrix.d]])
    return points @ linear.T + [matrix.e, matrix.f]


def _strokes(text, tmp={}):  # noqa: B006 -- one folder for all examples
    import tempfile
    from pathlib import Path

    folder = tmp.setdefault("folder", tempfile.TemporaryDirectory())
    path = Path(folder.name) / "drawing.svg"
    path.write_text(text, encoding="utf-8")
    return read_svg(path).strokes


@given(st.floats(1, 100), st.floats(1, 100), st.floats(0, 7), st.floats(0.01, 6.2))
def test_length_of_an_ellipse_is_that_of_a_fine_polygon(rx, ry, first, span):
    points = [(rx * math.cos(first + span * t), ry * math.sin(first + span * t)) for t in (0, 1)]
    large = int(span > math.pi)
    (x, y), end = points
    d = f"M{x!r} {y!r}A{rx!r} {ry!r} 0 {large}1 {end[0]!r} {end[1]!r}"
    ((piece,),) = svg_path.PathData(d).subpaths
    alone = piece.length
    piece.__dict__.pop("length")
    measure([piece])
    assert piece.length == pytest.approx(alone, rel=1e-10)
    t = first + span * np.linspace(0, 1, 20001)
    polygon = length_of(np.column_stack([rx * np.cos(t), ry * np.sin(t)]))
    assert piece.length == pytest.approx(polygon, rel=2e-6)
