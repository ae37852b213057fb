# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench itself: start-up, toolbar, menu, icons."""

import os
import subprocess
import sys
import time
import xml.etree.ElementTree as ET

import FreeCADGui as Gui
import pytest
from PySide import QtGui, QtSvg

from BistableWB import ICONS, ROOT
from BistableWB.objects import TYPES


def commands():
    from BistableWB.commands import COMMANDS

    return COMMANDS


def test_start_up_is_quick_and_imports_nothing_but_the_package(monkeypatch):
    added = []
    monkeypatch.setattr(Gui, "addWorkbench", added.append)
    source = (ROOT / "InitGui.py").read_text(encoding="utf-8")
    for name in [name for name in sys.modules if name.partition(".")[0] == "BistableWB"]:
        monkeypatch.delitem(sys.modules, name)
    start = time.perf_counter()
    exec(compile(source, "InitGui.py", "exec"), {"__name__": "InitGui"})
    assert time.perf_counter() - start < 0.15
    assert len(added) == 1
    assert {name for name in sys.modules if name.startswith("BistableWB")} == {
        "BistableWB", "BistableWB.hooks", "BistableWB.wiring",
    }  # fmt: skip


def test_importing_the_package_loads_none_of_its_parts():
    code = (
        "import sys; sys.path.insert(0, sys.argv[1]); import BistableWB; "
        "print([m for m in sys.modules if m.startswith('BistableWB.') or m == 'numpy'])"
    )
    done = subprocess.run(
        ["/usr/bin/python3", "-c", code, str(ROOT)],
        capture_output=True,
        text=True,
        check=True,
        env={k: v for k, v in os.environ.items() if not k.startswith("PYTHON")},
    )
    assert done.stdout.strip() == "[]"


def test_the_workbench_activates_with_name_and_icon(gui):
    workbench = Gui.activeWorkbench()
    assert workbench.MenuText == "Bistable"
    assert os.path.samefile(workbench.Icon, ICONS / "BistableWorkbench.svg")


def test_toolbar_and_menu_hold_the_commands_with_icons(gui):
    window = Gui.getMainWindow()
    (bar,) = [
        b for b in window.findChildren(QtGui.QToolBar) if b.windowTitle() == "Bistable design"
    ]
    shown = [a for a in bar.actions() if not a.isSeparator()]
    assert [a.text().replace("&", "") for a in shown] == [
        "New tube",
        "Draw curve",
        "Curve",
        "Curve on sphere",
        "Import curve",
        "Triangle placement",
        "Bistable units",
        "Make it printable",
    ]
    assert not any(action.icon().isNull() for action in shown)
    titles = [action.text().replace("&", "") for action in window.menuBar().actions()]
    assert "Bistable" in titles


def test_every_command_is_registered_and_says_what_it_does(gui):
    registered = Gui.listCommands()
    shortcuts = []
    for command in commands():
        assert command.name in registered
        resources = command.GetResources()
        assert resources["MenuText"]
        assert len(resources["ToolTip"]) > 20
        assert resources["StatusTip"]
        assert resources["Pixmap"].endswith(".svg")
        shortcuts.append(resources.get("Accel"))
        assert command.run.__doc__
    given = [s for s in shortcuts if s]
    assert len(given) == len(set(given))


def icon_names():
    return sorted(path.stem for path in ICONS.glob("*.svg"))


@pytest.mark.parametrize("name", icon_names())
@pytest.mark.parametrize("background", ["#f5f5f5", "#2b2b2b"])
def test_icons_can_be_told_from_light_and_dark_toolbars(name, background):
    path = ICONS / f"{name}.svg"
    assert ET.parse(path).getroot().get("viewBox") == "0 0 64 64"
    image = QtGui.QImage(16, 16, QtGui.QImage.Format_ARGB32)
    image.fill(QtGui.QColor(background))
    painter = QtGui.QPainter(image)
    QtSvg.QSvgRenderer(str(path)).render(painter)
    painter.end()
    ground = QtGui.QColor(background).lightness()
    pixels = [image.pixelColor(x, y).lightness() for x in range(16) for y in range(16)]
    assert sum(abs(p - ground) > 60 for p in pixels) > 40


def test_every_type_and_every_command_has_an_icon_of_its_own():
    wanted = {name.removeprefix("Bistable::") for name in TYPES}
    wanted |= {command.icon for command in commands()} | {"BistableWorkbench"}
    assert wanted <= set(icon_names())
