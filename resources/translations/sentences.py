# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sentences of errors, warnings and findings, out of the sources: templates for translators.

The packages that write them know nothing of languages; the window shows a finished sentence in the
user's own (`BistableWB.taskpanels.sentences`). A template is a string of the sources with {0}, {1},
{2} for what is filled in: "Ratio{0} is {1}: …". What is filled in may be a phrase, with a template
of its own: "which welds them". Where one of two words is filled in, there is a template for each.
"""

import ast
import itertools
import re

CONTEXT = "BistableSentence"
# Modules all of whose texts are sentences or parts of sentences.
WHOLE = (
    "checks", "fitting.py", "imports/__init__.py", "imports/curves.py", "imports/fold.py",
    "imports/text.py", "objects", "openscad.py", "origami", "slicing/gcode.py",
    "slicing/slicer.py", "slicing/toolpaths.py", "solids",
)  # fmt: skip
# Modules with other texts: what they raise counts, and the parts of it named here.
RAISING = (
    "design_text.py", "document_report.py", "exporters", "make.py", "slicing/comparison.py",
    "slicing/painting.py",
)  # fmt: skip
PARTS = (
    "choose another folder", "free some space there", "it has none", "it has {0}", "no suffix",
    "the suffix {0}", "deployed", "flat",
    # words that `checks` fills in
    "floor", "layer", "nozzle", "wall",
)  # fmt: skip
# Texts with spaces that are no sentences: progress, labels of drawings, names of files and formats.
_CALLS = {"Prop", "Result", "compile", "findall", "match", "search", "split", "sub", "fullmatch"}
_OTHER = re.compile(
    r"[<>\n\\]|=\"|^/App|^; (?:estimated|filament)|^not closed$|\(curve\)$|^\) mm$|"
    r"^(?:Hinged solids|Lets Repair|Measuring|Placing|Support material|Wipe tower)|"
    r"^(?:overlaps|(?:to )?unit) \{|^(?:\{\d\} × )*\{\d\} (?:mm|cm²)$"
)
_MOST = 12  # letters of a word that is filled in from a variable


def templates(package):
    """Set of the templates in the sources below ``package`` (a Path)."""
    found = set(PARTS)
    for path in sorted(package.rglob("*.py")):
        name = path.relative_to(package).as_posix()
        whole = _is_in(name, WHOLE)
        if whole or _is_in(name, RAISING):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            found |= _Reader(tree).templates(whole)
    return found


def _is_in(name, parts):
    return any(name == part or name.startswith(f"{part}/") for part in parts)


class _Reader:
    """The texts of a module."""

    def __init__(self, tree):
        self.tree = tree
        self.constants = {}
        for node in tree.body:
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                text = self._text(node.value)
                if text:
                    self.constants[node.targets[0].id] = text
        self.found = set()

    def templates(self, whole):
        """Templates of all texts, or of what is raised."""
        if whole:
            self._visit(self.tree, {})
        else:
            for node in ast.walk(self.tree):
                if isinstance(node, ast.Raise):
                    self._visit(node, {})
        return self.found

    def _visit(self, node, words):
        if isinstance(node, ast.Call) and _name(node.func) in _CALLS:
            return
        if isinstance(node, ast.FunctionDef):
            words = _words_of(node)
        text = self._text(node)
        if text is not None:
            self._add(numbered(text))
            return
        if isinstance(node, ast.JoinedStr):
            for text in _alternatives(node, words):
                self._add(numbered(text))
            for value in node.values:
                inner = getattr(value, "value", None)
                if isinstance(inner, ast.AST) and not _choices(inner, words):
                    self._visit(inner, words)
            return
        for child in ast.iter_child_nodes(node):
            if not (isinstance(child, ast.Expr) and isinstance(child.value, ast.Constant)):
                self._visit(child, words)  # else a docstring

    def _text(self, node):
        """The text of a constant expression, or None."""
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            return node.value
        if isinstance(node, ast.Name):
            return self.constants.get(node.id) if isinstance(node.ctx, ast.Load) else None
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            left, right = self._text(node.left), self._text(node.right)
            return None if left is None or right is None else left + right
        if isinstance(node, ast.Subscript) and ast.unparse(node.slice) == ":-1":
            text = self._text(node.value)
            return None if text is None else text[:-1]
        return None

    def _add(self, template):
        plain = re.sub(r"\{\d+\}", "", template)
        if re.search(r"[a-z]{2}", plain) and " " in template and not _OTHER.search(template):
            self.found.add(template)


def numbered(text):
    """``text`` with its fields numbered in their order, whatever stands in them."""
    count = itertools.count()
    return re.sub(r"\{[^{}]*\}", lambda _: f"{{{next(count)}}}", text)


def _alternatives(node, words):
    """Templates of an f-string: one for each choice of the words that are filled in."""
    parts = []
    for value in node.values:
        if isinstance(value, ast.Constant):
            parts.append((value.value,))
        else:
            parts.append(_choices(value.value, words) or (None,))
    for chosen in itertools.product(*parts):
        yield "".join("{}" if text is None else text for text in chosen)


def _choices(node, words):
    """The two words that an expression chooses from, or None."""
    if isinstance(node, ast.Name):
        return words.get(node.id)
    if isinstance(node, ast.IfExp):
        both = [getattr(side, "value", None) for side in (node.body, node.orelse)]
        return tuple(both) if all(isinstance(text, str) for text in both) else None
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mult):
        ending = node.left
    elif isinstance(node, ast.Subscript):
        ending = node.value
    else:
        return None
    text = getattr(ending, "value", None)
    return ("", text) if isinstance(text, str) else None


def _words_of(function):
    """{variable: its two words} of a function: ``are = "are" if several else "is"``."""
    words = {}
    for node in ast.walk(function):
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.IfExp):
            both = _choices(node.value, {})
            if both and all(text and " " not in text and len(text) < _MOST for text in both):
                words[_name(node.targets[0])] = both
    return words


def _name(node):
    return getattr(node, "attr", getattr(node, "id", ""))
