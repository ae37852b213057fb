# SPDX-License-Identifier: LGPL-2.1-or-later
"""Messages are data: templates with fields, which nobody parses."""

import ast
import itertools
import re
import string
from pathlib import Path

import pytest

from BistableWB import TRANSLATIONS
from BistableWB.origami.errors import Phrase
from tests.hostile import HOSTILE
from tests.translations import load

PACKAGE = Path(__file__).parents[2] / "BistableWB"
TREES = {
    path.relative_to(PACKAGE).as_posix(): ast.parse(path.read_text(encoding="utf-8"))
    for path in sorted(PACKAGE.rglob("*.py"))
}
# Modules that may use regular expressions: what other programs write, and names. None on sentences.
REGULAR = {
    "commands/output.py",  # what no file name may hold
    "exporters/obj.py",  # names without spaces
    "exporters/step.py",
    "language/labels.py",  # words of the name of a property
    "objects/curve.py",  # paths of points in formulas
    "objects/self_drawn.py",  # names of bodies in files of 0.1.0
    "programs/gcode.py",
    "scene/camera.py",  # what Coin writes
}
sentences = load("sentences")


def calls_of_templates():
    """(module, line, number of the template's argument, call, its templates) of all calls."""
    place = sentences.places(TREES.values())
    for module, tree in TREES.items():
        for call, constants in sentences.calls(tree, place):
            yield module, call, sentences.given(call, place, constants)


def fields(template):
    return [field for _, field, _, _ in string.Formatter().parse(template) if field]


def test_every_field_is_filled():
    checked = 0
    for module, call, templates in calls_of_templates():
        given = {word.arg for word in call.keywords}
        if None in given:  # **pieces
            continue
        name = ast.unparse(call.func)
        given |= set() if name == "phrase" else {"unit", "body"}
        if name == "require":
            given |= {"value", "at", *map(str, range(len(call.args) - 3))}
        for template in itertools.chain(*templates):
            small = {field for field in fields(template) if not field[:1].isupper()}
            assert small <= given, f"{module}:{call.lineno}: {template}"
            checked += 1
    assert checked > 300


def test_templates_are_texts_that_the_translator_finds():
    """A template that is put together at run time would stay English."""
    for module, call, templates in calls_of_templates():
        if module != "origami/errors.py":  # their home hands them on
            found = {len(texts) for texts in templates}
            assert 0 not in found, f"{module}:{call.lineno}: {ast.unparse(call)[:80]}"


@pytest.mark.parametrize("path", sorted(TRANSLATIONS.glob("*.ts")), ids=lambda path: path.stem)
def test_translations_have_the_same_fields(path):
    known = load("update").read(path)
    ours = {text: own for (context, text), own in known.items() if context == sentences.CONTEXT}
    assert len(ours) > 250
    for text, own in ours.items():
        parts = [
            sorted((field, spec, how) for _, field, spec, how in string.Formatter().parse(side)
                   if field)
            for side in (text, own)
        ]  # fmt: skip
        assert parts[0] == parts[1], text


def test_values_of_enumerations_are_choices():
    """So that German says them as its panels do; an unknown one stays what a macro wrote."""
    values = ("process", "hinge_type", "pivot", "orientation", "joint", "material")
    values = {f".{one}" for one in (*values, *map(str.title, values))} | {".HingeType"}
    found = 0
    for module, call, templates in calls_of_templates():
        if any(" unknown" in text for text in itertools.chain(*templates)):
            continue
        for word in call.keywords:
            given = ast.unparse(word.value)
            is_one = given.endswith((*values, "material.name"))
            assert not is_one, f"{module}:{call.lineno}: {word.arg}={given}"
            found += given.startswith("Choice(")
    assert found >= 6


def test_german_says_du():
    formal = re.compile(r"\b[a-zäöü]+(?:en|ln|rn) Sie\b|(?<=[a-zäöü,] )Ihr(?:e[mnrs]?)?\b")
    known = load("update").read(TRANSLATIONS / "Bistable_de.ts")
    assert [own for own in known.values() if formal.search(own)] == []


def test_what_is_refused_is_a_refusal():
    """A ValueError that says a sentence is taken for a mistake of the program, as it is in some."""
    mistakes = {f"origami/hinges/{name}.py" for name in ("drafting", "fingers", "triangulation")}
    for module in TREES.keys() - mistakes:
        tree = TREES[module]
        for node in ast.walk(tree):
            if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
                raised = ast.unparse(node.exc)
                assert not re.match(r"ValueError\(f?['\"].* ", raised), f"{module}:{node.lineno}"


def test_nobody_parses_sentences():
    using = {
        module
        for module, tree in TREES.items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Import) and any(name.name == "re" for name in node.names)
    }
    files = {module for module in using if module.startswith("imports/")}  # and what is in them
    assert using - files - REGULAR == set()


def filled(template, label):
    """Pieces for every field of a template: ``label``, a number where it shows one."""
    return {
        field: 2.5 if spec else label
        for _, field, spec, _ in string.Formatter().parse(template)
        if field and not field[:1].isupper()
    }


@pytest.mark.parametrize("label", HOSTILE)
def test_no_label_file_or_unit_changes_in_any_sentence_of_either_language(label):
    """Each sentence with the label is that of a neutral word with the label in its place."""
    german = {
        text: own
        for (context, text), own in load("update").read(TRANSLATIONS / "Bistable_de.ts").items()
        if context == sentences.CONTEXT
    }
    assert len(german) > 500
    for template in german:
        said, marked = (Phrase(template, filled(template, one)) for one in (label, "\N{SNOWMAN}"))
        for translate in (str, german.get):
            words = said.in_words(translate, str.lower)
            neutral = marked.in_words(translate, str.lower)
            assert words == neutral.replace("\N{SNOWMAN}", label).replace(
                repr("\N{SNOWMAN}"), repr(label)
            )
            shown = [value for value in said.pieces.values() if value == label]
            assert words.count(label) >= len(shown)
