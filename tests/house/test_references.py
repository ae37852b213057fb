# SPDX-License-Identifier: LGPL-2.1-or-later
"""What docstrings, comments and pages refer to exists: sections, functions, files."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "BistableWB"
THEORY = ROOT / "docs/theory"
PAGES = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]
SOURCES = [p for folder in ("BistableWB", "tests", "benchmarks", "resources")
           for p in sorted((ROOT / folder).rglob("*.py"))]  # fmt: skip
SECTION = re.compile(r"(\S*?)((?:geometry|hinges)\.md)[`)]*,? (\d(?:(?:, | and )\d)*)")
DOTTED = re.compile(r"(?<!`)`([a-z_]\w*(?:\.\w+)+)(?:\(\))?`(?!`)")


def defined(path):
    """Names that a module defines, those of its classes' members with the class before them."""
    found = set()

    def visit(body, before=""):
        for node in body:
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                found.add(before + node.name)
                if isinstance(node, ast.ClassDef):
                    visit(node.body, f"{before}{node.name}.")
                for part in ast.walk(node) if not before else ():
                    if isinstance(part, ast.Attribute) and isinstance(part.ctx, ast.Store):
                        found.add(f"{node.name}.{part.attr}")
            elif isinstance(node, ast.Assign | ast.AnnAssign):
                targets = node.targets if isinstance(node, ast.Assign) else [node.target]
                names = [n for t in targets for n in ast.walk(t) if isinstance(n, ast.Name)]
                found.update(before + name.id for name in names)
            elif isinstance(node, ast.ImportFrom | ast.Import):
                found.update(before + (a.asname or a.name) for a in node.names)
            elif isinstance(node, ast.If | ast.Try):
                visit(node.body, before)

    visit(ast.parse(path.read_text(encoding="utf-8")).body)
    return found


def _modules():
    """{(…, package, module): names defined there}."""
    found = {}
    for path in PACKAGE.rglob("*.py"):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[parts[:-1] if parts[-1] == "__init__" else parts] = defined(path)
    return found


MODULES = _modules()


def exists(name):
    """Whether some module of ours, by the end of its path, has it; a module itself also counts."""
    parts = tuple(name.split("."))
    for cut in range(len(parts), 0, -1):
        head, rest = parts[:cut], ".".join(parts[cut:])
        for path, names in MODULES.items():
            if path[-len(head) :] == head and (not rest or rest in names):
                return True
            if not rest and path[-len(head) + 1 :] == head[:-1] and head[-1] in names:
                return True
    return False


def docstrings(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            text = ast.get_docstring(node)
            if text:
                yield text


@pytest.mark.parametrize("page", sorted(THEORY.glob("*.md")), ids=lambda p: p.name)
def test_every_function_that_theory_names_exists(page):
    text = page.read_text(encoding="utf-8")
    named = {n for n in DOTTED.findall(text) if not n.startswith(("docs.", "tests."))}
    assert len(named) > 20
    assert {name for name in named if not exists(name)} == set()


def test_every_section_that_sources_name_exists():
    """Sections have numbers in docs/theory only, so "hinges.md 3" is of the page there."""
    assert "## 1." not in (ROOT / "docs/hinges.md").read_text(encoding="utf-8")
    sections = {
        page.name: set(re.findall(r"^## (\d)\.", page.read_text(encoding="utf-8"), re.MULTILINE))
        for page in THEORY.glob("*.md")
    }
    wrong, count = [], 0
    for path in SOURCES:
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            for folder, page, numbers in SECTION.findall(line):
                count += 1
                missing = set(re.findall(r"\d", numbers)) - sections[page]
                if missing or ("/" in folder and not folder.endswith("theory/")):
                    wrong.append(f"{path.relative_to(ROOT)}:{number}: {line.strip()}")
    assert wrong == []
    assert count > 30


def test_docstrings_name_what_is_there():
    ours = {name for path in MODULES for name in path}
    wrong = [
        f"{path.relative_to(ROOT)}: {name}"
        for path in sorted(PACKAGE.rglob("*.py"))
        for text in docstrings(path)
        for name in DOTTED.findall(text)
        if not exists(name) and name.split(".")[0] not in FOREIGN - ours
    ]
    assert wrong == []


FOREIGN = {"np", "numpy", "scipy", "matplotlib", "coin", "str", "dict", "ast", "json", "math"}


@pytest.mark.parametrize("page", PAGES, ids=lambda p: str(p.relative_to(ROOT)))
def test_links_of_pages_lead_somewhere(page):
    links = re.findall(r"\]\(([^)#\s]+)", page.read_text(encoding="utf-8"))
    files = [link for link in links if "://" not in link and not link.startswith("mailto:")]
    assert [link for link in files if not (page.parent / link).exists()] == []
