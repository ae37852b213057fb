# SPDX-License-Identifier: LGPL-2.1-or-later
"""Refusals and findings as data: what fills a template never changes."""

import copy
import json
import pickle

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from BistableWB.origami.errors import (
    NOTE,
    Choice,
    Finding,
    Refusal,
    as_data,
    from_data,
    gathered,
    joined,
    message_of,
    name_of,
    phrase,
    require,
    verbatim,
)
from tests.hostile import HOSTILE

MARK = "\ufdd0"  # no character: nothing else can be it


def translate(template):
    """A translation that would spoil any text which is taken for a template."""
    german = {"wall": "Wand", "Unit": "Einheit", "of": "von", "is": "ist", "Source": "Quelle"}
    return " ".join(german.get(word, word) for word in template.split(" "))


def name(parameter):
    """A name that would spoil any text in which parameters are looked for."""
    return f"<{parameter.lower()}>"


def all_that_is_said(text):
    """Sentences with ``text`` as a piece, in a phrase in a phrase, in a list, in a refusal."""
    wall = phrase("the wall of {body}", body=text)
    refusal = Refusal(
        "{Source} {label} has a kink in {wall}.",
        cure="make {Gamma} of {label} smaller",
        parameter="Source",
        label=text,
        wall=wall,
    )
    warned = [phrase("Unit {unit}: {body} is thin.", unit=k, body=text) for k in (1, 2, 3)]
    return (
        wall,
        refusal,
        phrase("Unit {unit}: {refused}", unit=2, refused=refusal),
        joined([wall, phrase("{name!r} is no {EdgeLength}", name=text)]),
        verbatim(text),
        message_of(ValueError(text)),
        message_of(refusal),
        *gathered(warned),
        Finding(severity=NOTE, code="x", message=phrase("{body} is.", body=text), cure=wall),
    )


@given(st.text())
@pytest.mark.parametrize("words", [{}, {"translate": translate, "name": name}])
def test_what_fills_a_template_never_changes(words, text):
    """Whatever a label says, the sentence is that of another label with the label in its place."""
    for said, marked in zip(all_that_is_said(text), all_that_is_said(MARK), strict=True):
        expected = marked.in_words(**words)
        expected = expected.replace(repr(MARK), repr(text)).replace(MARK, text)
        assert said.in_words(**words) == expected


for _hostile in HOSTILE:
    test_what_fills_a_template_never_changes = example(text=_hostile)(
        test_what_fills_a_template_never_changes
    )


def test_a_refusal_in_another_language_with_other_names():
    refusal = all_that_is_said("wall")[1]
    assert str(refusal) == (
        "Source wall has a kink in the wall of wall: make Gamma of wall smaller."
    )
    assert refusal.in_words(translate, name) == (
        "<source> wall has a kink in the Wand von wall: make <gamma> von wall smaller."
    )
    assert refusal.parameter == "Source"


def test_a_phrase_can_be_kept_in_a_file():
    wall, refusal, nested, *_ = all_that_is_said("{0}")
    for said in (wall, phrase("{a:.2f} {b} {c!r}", a=np.float64(2), b=np.int64(3), c=None)):
        assert from_data(json.loads(json.dumps(as_data(said)))) == said
    for said in (refusal, nested):
        assert str(from_data(json.loads(json.dumps(as_data(said))))) == str(said)


def test_a_choice_is_said_in_the_words_of_the_panel():
    def panel(text):
        return "Kegel, {0}" if isinstance(text, Choice) else text

    said = phrase("{Pivot} {pivot} of {body} and {rule!r}",
                  pivot=Choice("Cone"), body="Cone", rule=Choice("Pin"))  # fmt: skip
    assert str(said) == "Pivot Cone of Cone and 'Pin'"
    kept = from_data(json.loads(json.dumps(as_data(said))))
    copied = pickle.loads(pickle.dumps(said))
    for one in (said, kept, copied):
        told = one.in_words(panel, name)
        assert told == "<pivot> Kegel, {0} of Cone and 'Kegel, {0}'"


@pytest.mark.parametrize("copied", [copy.copy, lambda it: pickle.loads(pickle.dumps(it))])
def test_a_refusal_survives_copies(copied):
    refusal = Refusal("{Gamma} is {value:.1f}{of}.", parameter="Gamma", value=2, of=phrase("°"))
    other = copied(refusal)
    assert (str(other), other.parameter) == ("Gamma is 2.0°.", "Gamma")


def test_require_picks_the_entry_that_is_wrong():
    with pytest.raises(Refusal) as caught:
        require(
            np.array([True, False, False]),
            "{name} is {value:g}{at}, {limit:g} asked.",
            np.array([1.0, 2.0, 3.0]),
            parameter="Ratio",
            name=name_of("Ratio"),
            limit=np.array([4.0, 5.0, 6.0]),
        )
    assert str(caught.value) == "Ratio is 2 of unit 2, 5 asked."
    assert (caught.value.unit, caught.value.parameter) == (2, "Ratio")


def test_the_same_of_many_units_is_said_once():
    thin = [phrase("Unit {unit}: {hinge} is {x:.1f} mm thin.", unit=k, hinge="AB", x=k / 10)
            for k in (1, 3, 4)]  # fmt: skip
    other = phrase("Unit {unit}: {hinge} is {x:.1f} mm thin.", unit=2, hinge="AC", x=0.2)
    assert list(map(str, gathered([*thin, other]))) == [
        "Unit 1: AB is 0.1 mm thin. (Also units 3, 4.)",
        "Unit 2: AC is 0.2 mm thin.",
    ]


def test_a_cure_names_its_parameter():
    cure = phrase("make {GapLength} larger than {gap:g} mm, or {EdgeLength} longer", gap=1)
    finding = Finding(severity=NOTE, code="x", message=phrase("They touch."), cure=cure)
    assert finding.parameter == "GapLength"
    assert str(finding) == "They touch: make GapLength larger than 1 mm, or EdgeLength longer."
    assert phrase("Nothing of the kind.").parameter == ""
