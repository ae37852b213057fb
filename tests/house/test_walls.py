# SPDX-License-Identifier: LGPL-2.1-or-later
"""The walls of the house: who may import whom, by the table docs/walls.toml.

The arrows run one way: commands → taskpanels → make → objects → solids → origami.
"""

import ast
import functools
import graphlib
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "BistableWB"
WALLS = tomllib.loads((ROOT / "docs/walls.toml").read_text(encoding="utf-8"))
MAY_IMPORT = {part: {part, *wall["may"]} for part, wall in WALLS.items()}
GUI_PARTS = {part for part, wall in WALLS.items() if wall.get("gui") == "always"}
# These know no GUI at all, not even inside a function.
NEVER_GUI = {part for part, wall in WALLS.items() if wall.get("gui") == "never"}


class Import(NamedTuple):
    module: str
    line: int
    in_function: bool
    if_gui_up: bool

    @property
    def top(self) -> str:
        return self.module.split(".")[0]

    @property
    def part(self) -> str | None:
        """Return which part of BistableWB it names: "BistableWB" for its constants, else None."""
        names = self.module.split(".")
        if names[0] != "BistableWB":
            return None
        constant = len(names) == 1 or names[1].isupper() or names[1].startswith("__")
        return "BistableWB" if constant else names[1]

    @property
    def is_gui(self) -> bool:
        return self.top.endswith("Gui") or self.top.startswith(("PySide", "pivy", "shiboken"))


def imports(source: str, package: tuple[str, ...]) -> Iterator[Import]:
    """Yield what ``source``, a module of ``package``, imports anywhere in it."""

    def visit(node, in_function, if_gui_up):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield Import(alias.name, node.lineno, in_function, if_gui_up)
        elif isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else ()
            origin = ".".join([*base, *([node.module] if node.module else [])])
            for alias in node.names:
                yield Import(f"{origin}.{alias.name}", node.lineno, in_function, if_gui_up)
        in_function |= isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)
        if isinstance(node, ast.If):
            gui = "GuiUp" in ast.unparse(node.test)
            for child in node.body:
                yield from visit(child, in_function, if_gui_up or gui)
            for child in node.orelse:
                yield from visit(child, in_function, if_gui_up)
        else:
            for child in ast.iter_child_nodes(node):
                yield from visit(child, in_function, if_gui_up)

    yield from visit(ast.parse(source), False, False)


def broken_walls(part: str, found: Import) -> Iterator[str]:
    """Yield what is wrong with ``part``, a directory or module of BistableWB, importing that."""
    if found.is_gui and part not in GUI_PARTS and (part in NEVER_GUI or not found.in_function):
        yield f"imports the GUI module {found.top}"
    if found.part and found.part not in MAY_IMPORT.get(part, set()):
        yield f"imports {found.module}"
    if part == "origami" and found.top not in {"BistableWB", "numpy", *sys.stdlib_module_names}:
        yield f"imports {found.top}: the mathematics knows numpy only"


def modules() -> list[Path]:
    return sorted(PACKAGE.rglob("*.py"))


@functools.cache
def nodes_of(path: Path) -> list[ast.AST]:
    """Every node of a module, which several tests look through."""
    return list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))


@functools.cache
def imports_of(path: Path) -> list[Import]:
    """What a module of the package imports."""
    return list(imports(path.read_text(encoding="utf-8"), path.relative_to(ROOT).parts[:-1]))


def part_of(path: Path) -> str:
    return path.relative_to(PACKAGE).parts[0].removesuffix(".py")


def test_walls_of_the_house_hold():
    broken = [
        f"{path.relative_to(ROOT)}:{found.line}: {part_of(path)} {problem}"
        for path in modules()
        for found in imports_of(path)
        for problem in broken_walls(part_of(path), found)
    ]
    assert broken == []


def test_the_table_lists_every_part_and_nothing_else():
    assert set(WALLS) == {part_of(path) for path in modules()} - {"__init__"}
    assert {other for wall in WALLS.values() for other in wall["may"]} <= {*WALLS, "BistableWB"}


def test_no_arrow_leads_back():
    """Raise CycleError, which names the parts, if parts could import each other in a circle."""
    order = graphlib.TopologicalSorter({part: wall["may"] for part, wall in WALLS.items()})
    assert list(order.static_order())


def test_every_door_is_used():
    """A permission that nobody needs is a wall that is missing."""
    used = {part: set() for part in WALLS}
    for path in modules():
        for found in imports_of(path):
            if part_of(path) in used and found.part:
                used[part_of(path)].add(found.part)
    doors = {(part, other) for part, wall in WALLS.items() for other in wall["may"]}
    assert doors - {(part, other) for part in used for other in used[part]} == set()


@pytest.mark.parametrize(
    ("part", "source"),
    [
        ("origami", "import FreeCAD"),
        ("origami", "import scipy.optimize"),
        ("origami", "from BistableWB import ROOT"),
        ("origami", "from ..solids import plates"),
        ("origami", "def f():\n    from PySide import QtGui"),
        ("solids", "from BistableWB.objects import curve"),
        ("solids", "from BistableWB import objects"),
        ("solids", "from .. import objects"),
        ("solids", "import PartGui"),
        ("checks", "from ..objects import curve"),
        ("objects", "import FreeCADGui as Gui"),
        ("objects", "if App.GuiUp:\n    import FreeCADGui"),
        ("objects", "from ..viewproviders import unit"),
        ("objects", "def f():\n    from ..viewproviders import unit"),
        ("objects", "if App.GuiUp:\n    from ..viewproviders import unit"),
        ("objects", "def f():\n    if not x:\n        from ..commands import unit"),
        ("objects", "from .. import make"),
        ("exporters", "try:\n    from pivy import coin\nexcept ImportError:\n    pass"),
        ("make", "from .taskpanels import unit"),
        ("make", "def f():\n    if App.GuiUp:\n        from . import viewproviders"),
        ("objects", "def f():\n    if App.GuiUp:\n        from ..viewproviders import unit"),
        ("make", "from . import exporters"),
        ("viewproviders", "def f():\n    from ..taskpanels import base"),
        ("taskpanels", "from ..commands import base"),
        ("slicing", "from ..checking import check"),
        ("program", "from PySide import QtCore"),
    ],
)
def test_a_broken_wall_is_seen(part, source):
    package = ("BistableWB",) if part in {"make", "program"} else ("BistableWB", part)
    assert [p for found in imports(source, package) for p in broken_walls(part, found)]


@pytest.mark.parametrize(
    ("part", "source"),
    [
        (
            "origami",
            "import math\nimport numpy as np\nfrom . import angles\nfrom .unit import Unit",
        ),
        (
            "solids",
            "import Part\nfrom ..origami import unit\nfrom BistableWB.origami import angles",
        ),
        ("objects", "import FreeCAD as App\nfrom ..solids import x"),
        ("viewproviders", "from pivy import coin\nfrom BistableWB import ICONS"),
        ("make", "from .objects import curve"),
        ("commands", "import FreeCADGui as Gui\nfrom PySide import QtGui\nfrom .. import make"),
    ],
)
def test_an_open_door_is_open(part, source):
    package = ("BistableWB",) if part == "make" else ("BistableWB", part)
    assert [p for found in imports(source, package) for p in broken_walls(part, found)] == []


def test_only_the_package_is_importable_from_the_root():
    """FreeCAD puts the root on sys.path: a module there could hide another add-on's."""
    modules_at_root = {path.name for path in ROOT.glob("*.py")}
    assert modules_at_root <= {"Init.py", "InitGui.py"}
    packages = {path.parent.name for path in ROOT.glob("*/__init__.py")}
    assert packages == {"BistableWB"}
    assert list((ROOT / "tests").rglob("__init__.py")) == []


def test_no_file_is_too_long_to_read():
    lengths = {
        str(path.relative_to(ROOT)): len(path.read_text(encoding="utf-8").splitlines())
        for path in [*modules(), *(ROOT / "tests").rglob("*.py")]
    }
    assert {name: lines for name, lines in lengths.items() if lines >= 400} == {}


def test_no_function_is_longer_than_a_screen():
    lengths = {
        f"{path.relative_to(ROOT)}: {node.name}": node.end_lineno - node.lineno + 1
        for path in modules()
        for node in nodes_of(path)
        if isinstance(node, ast.FunctionDef)
    }
    assert {name: lines for name, lines in lengths.items() if lines > 52} == {}


def test_public_names_are_documented():
    public = [
        node
        for path in modules()
        for node in nodes_of(path)
        if isinstance(node, ast.FunctionDef | ast.ClassDef) and not node.name.startswith("_")
    ]
    assert sum(ast.get_docstring(node) is not None for node in public) >= 0.92 * len(public)
