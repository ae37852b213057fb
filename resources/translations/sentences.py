# SPDX-License-Identifier: LGPL-2.1-or-later
"""The templates of refusals, warnings and findings, out of the sources, for translators.

A template (see `BistableWB.origami.errors`) is what the sources give to ``phrase``, ``require`` and
``Refusal`` or a class made of it: its first text, and its ``cure``. It may be one of two (``a if b
else c``), joined of several by ``+``, or a constant of the module. What the command line alone says
(`ENGLISH`) is not translated.
"""

import ast
import re

CONTEXT = "BistableSentence"
ENGLISH = {"DesignError", "BadValue", "refuse"}
_PLACE = {"phrase": 0, "Refusal": 0, "require": 1}  # of the template among the arguments
_SAYS = re.compile(r"[^\W\d_]{2}")  # a word, outside of fields
FIELD = re.compile(r"\{[^{}]*\}")


def templates(package):
    """Set of the templates in the sources below ``package`` (a Path)."""
    trees = [ast.parse(path.read_text(encoding="utf-8")) for path in sorted(package.rglob("*.py"))]
    place = places(trees)
    return {
        text
        for tree in trees
        for call, constants in calls(tree, place)
        for texts in given(call, place, constants)
        for text in texts
        if _SAYS.search(FIELD.sub("", text))
    }


def places(trees):
    """{function that takes a template: which of its arguments that is} for modules' trees."""
    return dict.fromkeys((name for tree in trees for name in _refusals(tree)), 0) | _PLACE


def _refusals(tree):
    """Names of the classes that are made of Refusal, and take a template as it does."""
    for node in ast.walk(tree):
        made = isinstance(node, ast.ClassDef) and "Refusal" in map(_name, node.bases)
        if made and node.name not in ENGLISH and "__init__" not in map(_name, node.body):
            yield node.name


def calls(tree, place):
    """(call, constants of the module) of all calls that give a template."""
    constants = {
        node.targets[0].id: node.value
        for node in tree.body
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
    }
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and (_takes(node, place) or _is_super(node)):
            yield node, constants


def _takes(call, place):
    """Whether a call is of a function that takes a template, and gives it one."""
    return len(call.args) > place.get(_name(call.func), len(call.args))


def _is_super(call):
    """Whether a call is ``super().__init__`` with a text first, as of a class of refusals."""
    called = ast.unparse(call.func) == "super().__init__"
    return called and len(call.args) == 1 and len(call.keywords) > 1


def given(call, place, constants):
    """The templates that a call gives, a list for each of its texts."""
    first = place.get(_name(call.func), 0)
    arguments = call.args[first : first + 1]
    if _name(call.func) != "phrase":  # which may have a piece of that name
        arguments += [word.value for word in call.keywords if word.arg == "cure"]
    return [_texts(argument, constants) for argument in arguments]


def _texts(node, constants):
    """What an expression of texts may say."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return [node.value]
    if isinstance(node, ast.IfExp):
        return _texts(node.body, constants) + _texts(node.orelse, constants)
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        ends = _texts(node.right, constants)
        return [start + end for start in _texts(node.left, constants) for end in ends]
    if isinstance(node, ast.Name) and node.id in constants:
        return _texts(constants[node.id], constants)
    return []


def _name(node):
    return next((getattr(node, kind) for kind in ("attr", "id", "name") if hasattr(node, kind)), "")
