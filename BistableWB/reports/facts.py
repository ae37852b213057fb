# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of a design for a report: what the objects of a document say of themselves.

Names and words are phrases, which the page says in the user's language; numbers are text.
"""

from dataclasses import dataclass, field

import FreeCAD as App
import numpy as np

from ..language.labels import label_of, translated
from ..origami.errors import phrase
from ..origami.progress import NOBODY

_DIRECTIONS = ("Gravity", "Ruling")  # vectors that are no lengths


@dataclass(frozen=True)
class Facts:
    """Numbers of a design: (name, value) pairs and the table of units, texts and phrases.

    ``prints``: `print_facts.PrintFacts` by the table of the design that asks for the print.
    """

    numbers: list
    parameters: list
    columns: list
    rows: list
    prints: dict = field(default_factory=dict)


def facts_of(objects, prints, unused, progress=NOBODY):
    """`Facts` of recomputed ``objects`` {table: object} and ``prints`` {table: object that prints}.

    ``unused(obj)`` names properties that have no effect as an object stands.
    """
    facts = {}
    for table, made in prints.items():
        progress.step(f"checks of the {'print' if table == 'hinges' else table}")
        facts[table] = made.facts(progress)
    numbers, columns, rows = [], [], []
    if "unit" in objects:
        numbers, columns, rows = _unit_facts(objects)
    if "hinges" in facts:
        columns = columns + facts["hinges"].columns
        rows = _with_print(rows, facts["hinges"], objects["hinges"].FirstUnit - 1)
    return Facts(numbers, _parameters(objects, unused), columns, rows, facts)


def _with_print(rows, made, first):
    """Rows of all units with those of a print, which may be a part of them from ``first`` on."""
    printed = dict(enumerate(made.rows, first))
    without = ["–"] * len(made.columns)
    return [row + printed.get(k, without) for k, row in enumerate(rows)]


def _unit_facts(objects):
    """Numbers, columns and rows of a tube or a unit."""
    unit, triangles = objects["unit"], objects.get("triangles")
    thetas = np.array(triangles.Thetas if triangles else [unit.Theta.Value])
    spread = f"{thetas.min():.1f}° … {thetas.max():.1f}°" if len(thetas) > 1 else f"{thetas[0]:g}°"
    numbers = [
        (phrase("units"), str(len(thetas))),
        (phrase("opening angle θ"), spread),
    ]
    if triangles is not None:
        numbers += [
            (phrase("length of the curve"), f"{objects['curve'].Length.Value:.1f} mm"),
            (phrase("of it followed"), f"{100 * triangles.Coverage:.1f} %"),
        ]
    numbers += [
        (phrase("isometry error"), f"{unit.IsometryError:.1e}"),
        (phrase("residual of the rule"), f"{unit.Residual:.1e}"),
    ]
    columns = ["k", "θ", "α", "β", "β′", phrase("ratio c"), "sin(θ/2)"]
    rows = [
        [str(k + 1), *(f"{x:.2f}°" for x in angles), f"{ratio:.4f}", f"{limit:.4f}"]
        for k, (*angles, ratio, limit) in enumerate(
            zip(thetas, unit.Alphas, unit.Betas, unit.BetaPrimes, unit.Ratios,
                np.sin(np.radians(thetas) / 2), strict=True)
        )
    ]  # fmt: skip
    return numbers, columns, rows


def _parameters(objects, unused):
    """Inputs of the objects that count, called what the panels call them."""
    found = []
    for obj in objects.values():
        without = unused(obj)
        for name in obj.PropertiesList:
            if obj.getGroupOfProperty(name) in ("", "Base", "Results") or name in without:
                continue
            if set(obj.getEditorMode(name)) & {"Hidden", "ReadOnly"}:
                continue
            if not obj.getTypeIdOfProperty(name).startswith("App::PropertyLink"):
                called = f"{obj.Label}: {translated(label_of(name))}"
                found.append((called, _as_text(obj, name)))
    return found


def _as_text(obj, name):
    value = getattr(obj, name)
    if obj.getTypeIdOfProperty(name) == "App::PropertyEnumeration":
        return translated(value)
    if isinstance(value, App.Units.Quantity):
        return f"{value.Value:g} mm" if value.Unit == App.Units.Length else f"{value.Value:g}°"
    if isinstance(value, App.Vector):
        shown = "(" + ", ".join(f"{x:g}" for x in value) + ")"
        return shown if name in _DIRECTIONS else f"{shown} mm"
    if isinstance(value, list):
        return " ".join("(" + ", ".join(f"{x:g}" for x in point) + ")" for point in value)
    if isinstance(value, bool):
        return phrase("yes") if value else phrase("no")
    return f"{value:g}" if isinstance(value, float) else str(value)
