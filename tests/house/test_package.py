# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the Addon Manager, a packager and a reader find at the root of the repository."""

import ast
import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

import BistableWB

ROOT = Path(__file__).resolve().parents[2]
NAMESPACE = {"p": "https://wiki.freecad.org/Package_Metadata"}
REPOSITORY = "https://github.com/bistable-workbench/bistable-workbench"


@pytest.fixture(scope="module")
def package():
    return ET.parse(ROOT / "package.xml").getroot()


def text(element, path):
    """Return the text of the one child at ``path``."""
    (found,) = element.findall("/".join(f"p:{name}" for name in path.split("/")), NAMESPACE)
    assert found.text
    return found.text.strip()


def repository_files():
    """Return every file that is, or would be, in the repository."""
    if (ROOT / ".git").exists() and shutil.which("git"):
        listed = subprocess.run(
            ["git", "-c", "safe.directory=*", "ls-files", "-coz", "--exclude-standard"],
            cwd=ROOT,
            check=True,
            capture_output=True,
            text=True,
        ).stdout.split("\0")
        paths = [ROOT / name for name in listed if name]
    else:
        outside = {"build", ".git", "__pycache__", ".hypothesis", ".pytest_cache", ".ruff_cache"}
        paths = [p for p in ROOT.rglob("*") if outside.isdisjoint(p.relative_to(ROOT).parts)]
    return sorted(path for path in paths if path.is_file())


def test_package_xml_has_what_the_addon_manager_requires(package):
    assert package.tag == f"{{{NAMESPACE['p']}}}package"
    assert package.get("format") == "1"
    assert text(package, "name")
    assert text(package, "description")
    assert text(package, "license") == "LGPL-2.1-or-later"
    assert package.find("p:license", NAMESPACE).get("file") == "LICENSE"
    assert package.find("p:maintainer", NAMESPACE).get("email")
    urls = {url.get("type"): url for url in package.findall("p:url", NAMESPACE)}
    assert urls["repository"].text == REPOSITORY
    assert urls["repository"].get("branch") == "main"
    assert urls["readme"].text.startswith(REPOSITORY)
    assert package.findall("p:tag", NAMESPACE)
    assert re.fullmatch(r"\d{4}-\d\d-\d\d", text(package, "date"))


def test_package_xml_names_the_oldest_supported_versions(package):
    assert text(package, "freecadmin") == "0.20.2"
    assert text(package, "content/workbench/freecadmin") == "0.20.2"
    assert text(package, "pythonmin") == "3.11"


def test_the_workbench_of_package_xml_is_the_class_of_init_gui(package):
    assert text(package, "content/workbench/subdirectory") == "./"
    tree = ast.parse((ROOT / "InitGui.py").read_text(encoding="utf-8"))
    classes = {node.name for node in ast.walk(tree) if isinstance(node, ast.ClassDef)}
    assert text(package, "content/workbench/classname") in classes


@pytest.mark.parametrize("path", ["icon", "content/workbench/icon"])
def test_icons_of_package_xml_are_svg_files_that_exist(package, path):
    icon = ROOT / text(package, path)
    assert icon.is_file()
    assert ET.parse(icon).getroot().tag == "{http://www.w3.org/2000/svg}svg"


def test_versions_agree(package):
    assert text(package, "version") == BistableWB.__version__
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    released = re.search(r"^## \[?v?(\d+\.\d+\.\d+)", changelog, re.MULTILINE)
    assert released, "CHANGELOG.md has no heading like '## 0.1.0'"
    assert released[1] == BistableWB.__version__


def test_the_licence_is_the_whole_lgpl():
    licence = (ROOT / "LICENSE").read_text(encoding="utf-8")
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in licence
    assert "Version 2.1, February 1999" in licence
    assert "END OF TERMS AND CONDITIONS" in licence


def test_no_file_names_a_path_of_somebodys_machine():
    """A path that exists on one machine only: a home directory, a mounted workspace."""
    personal = re.compile(rb"(?<![\w.~$})/-])/(?:home/\w+|Users/\w+|root|work)/[\w.]")
    named = [
        f"{path.relative_to(ROOT)}: {found[0].decode()}…"
        for path in repository_files()
        if (found := personal.search(path.read_bytes()))
    ]
    assert named == []


def test_the_search_for_files_finds_files():
    names = {str(path.relative_to(ROOT)) for path in repository_files()}
    assert {"Makefile", "BistableWB/__init__.py", "tests/house/test_package.py"} <= names
    assert not [name for name in names if name.startswith(("build/", ".git/"))]
