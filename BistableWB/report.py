# SPDX-License-Identifier: LGPL-2.1-or-later
"""A report on one or several designs: one HTML file with everything in it, pictures included."""

import base64
import html
import os
import platform
import string
import urllib.parse
from dataclasses import dataclass, field
from importlib import metadata
from pathlib import Path

import FreeCAD as App
import numpy as np

from . import __version__
from .design_text import unused

_STYLE = """
:root { --ink: #14283c; --muted: #5b6b7b; --line: #d9e0e6; --wash: #f5f8fa; --accent: #1f5f99; }
* { box-sizing: border-box; }
body { margin: 0; color: var(--ink); background: white;
       font: 15px/1.55 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
main { max-width: 1080px; margin: 0 auto; padding: 2.2rem 1.4rem 4rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.45rem; margin: 3.2rem 0 .3rem; padding-top: 1.2rem;
     border-top: 2px solid var(--ink); }
h3 { font-size: 1.02rem; margin: 1.8rem 0 .5rem; }
p { margin: .3rem 0 .8rem; max-width: 46rem; }
.muted, figcaption { color: var(--muted); }
nav ul { display: flex; flex-wrap: wrap; gap: .4rem 1.6rem; list-style: none; padding: 0; }
a { color: var(--accent); }
.numbers { display: flex; flex-wrap: wrap; gap: .7rem; margin: 1.1rem 0; padding: 0; }
.numbers div { flex: 1 1 8.2rem; background: var(--wash); border-radius: 8px;
               padding: .6rem .9rem; }
.numbers dt { color: var(--muted); font-size: .84rem; }
.numbers dd { margin: 0; font-size: 1.22rem; font-variant-numeric: tabular-nums; }
figure { margin: 1.4rem 0; padding: 1rem; border: 1px solid var(--line); border-radius: 10px; }
figure img { display: block; width: 100%; height: auto; }
figcaption { font-size: .9rem; margin-top: .6rem; }
.columns { display: flex; flex-wrap: wrap; gap: 0 2.6rem; }
.columns > div { flex: 1 1 20rem; min-width: 0; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: .92rem;
        font-variant-numeric: tabular-nums; }
th { text-align: left; font-weight: 600; border-bottom: 1.5px solid var(--ink); }
th, td { padding: .28rem .8rem .28rem 0; }
td { border-bottom: 1px solid var(--line); }
.units th, .units td { text-align: right; white-space: nowrap; }
ul.files { padding-left: 1.1rem; margin: .2rem 0; }
pre { background: var(--wash); border-radius: 8px; padding: .8rem 1rem; overflow-x: auto;
      font: 13px/1.45 "DejaVu Sans Mono", monospace; }
.problems { border-left: 4px solid #d81b72; background: #fdf0f5; padding: .6rem 1rem; }
ul.findings { list-style: none; padding: 0; }
.findings li { margin: .3rem 0; padding-left: 1.5rem; text-indent: -1.5rem; }
.findings li::before { display: inline-block; width: 1.5rem; text-indent: 0; font-weight: 700; }
.findings .note::before { content: "✓"; color: #2b7a4b; }
.findings .warning::before { content: "!"; color: #b36200; }
.findings .error::before { content: "✗"; color: #d81b72; }
footer { margin-top: 3.5rem; border-top: 1px solid var(--line); padding-top: .8rem;
         font-size: .88rem; }
@media print { main { max-width: none; padding: 0; } figure, .numbers div { break-inside: avoid; }
               h2 { break-before: page; border: 0; } }
"""

_PAGE = string.Template("""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>$title</title>
<style>$style</style>
</head>
<body>
<main>
<header>
<h1>$title</h1>
<p class="muted">$subtitle</p>
$contents
</header>
$sections
<footer class="muted">
<p>$versions</p>
</footer>
</main>
</body>
</html>
""")


@dataclass(frozen=True)
class Facts:
    """Numbers of a design as text: (name, value) pairs and the table of units.

    ``prints``: `hinged.PrintFacts` by the table of the design that asks for the print.
    """

    numbers: list
    parameters: list
    columns: list
    rows: list
    prints: dict = field(default_factory=dict)


def facts_of(objects, prints, progress=lambda text: None):
    """`Facts` of recomputed ``objects`` {table: object} and ``prints`` {table: `hinged` object}."""
    facts = {}
    for table, made in prints.items():
        progress(f"checks of the {'print' if table == 'hinges' else table}")
        facts[table] = made.facts(progress)
    numbers, columns, rows = [], [], []
    if "unit" in objects:
        numbers, columns, rows = _unit_facts(objects)
    if "hinges" in facts:
        columns = columns + facts["hinges"].columns
        rows = _with_print(rows, facts["hinges"], objects["hinges"].FirstUnit - 1)
    return Facts(numbers, _parameters(objects), columns, rows, facts)


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
    numbers = [("units", str(len(thetas))), ("opening angle θ", spread)]
    if triangles is not None:
        numbers += [
            ("length of the curve", f"{objects['curve'].Length.Value:.1f} mm"),
            ("of it followed", f"{100 * triangles.Coverage:.1f} %"),
        ]
    numbers += [
        ("isometry error", f"{unit.IsometryError:.1e}"),
        ("residual of the rule", f"{unit.Residual:.1e}"),
    ]
    columns = ["k", "θ", "α", "β", "β′", "ratio c", "sin(θ/2)"]
    rows = [
        [str(k + 1), *(f"{x:.2f}°" for x in angles), f"{ratio:.4f}", f"{limit:.4f}"]
        for k, (*angles, ratio, limit) in enumerate(
            zip(thetas, unit.Alphas, unit.Betas, unit.BetaPrimes, unit.Ratios,
                np.sin(np.radians(thetas) / 2), strict=True)
        )
    ]  # fmt: skip
    return numbers, columns, rows


def _parameters(objects):
    """Inputs of the objects that count, by the names that the document shows."""
    found = []
    for obj in objects.values():
        without = unused(obj)
        for name in obj.PropertiesList:
            if obj.getGroupOfProperty(name) in ("", "Base", "Results") or name in without:
                continue
            if set(obj.getEditorMode(name)) & {"Hidden", "ReadOnly"}:
                continue
            if not obj.getTypeIdOfProperty(name).startswith("App::PropertyLink"):
                found.append((f"{obj.Label}.{name}", _as_text(getattr(obj, name))))
    return found


def _as_text(value):
    if isinstance(value, App.Units.Quantity):
        return f"{value.Value:g} mm" if value.Unit == App.Units.Length else f"{value.Value:g}°"
    if isinstance(value, App.Vector):
        return "(" + ", ".join(f"{x:g}" for x in value) + ") mm"
    if isinstance(value, list):
        return " ".join("(" + ", ".join(f"{x:g}" for x in point) + ")" for point in value)
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:g}" if isinstance(value, float) else str(value)


def write(path, results, title=None, subtitle=None):
    """Write the report on ``results`` (`produce.Result`) to ``path``; returns the path."""
    path = Path(path)
    several = len(results) > 1
    first = results[0].design
    contents = _contents(results) if several else ""
    page = _PAGE.substitute(
        title=_e(title or first.title),
        subtitle=_e(
            subtitle or first.get("design", "description", "A bistable, flat-foldable tube.")
        ),
        style=_STYLE,
        contents=contents,
        sections="\n".join(_section(result, path.parent, several) for result in results),
        versions=_e(" · ".join(versions())),
    )
    unfinished = path.with_name(f".{path.name}.writing")
    try:
        unfinished.write_text(page, encoding="utf-8")
        os.replace(unfinished, path)
    finally:
        unfinished.unlink(missing_ok=True)
    return path


def versions():
    """What made it: names with versions."""
    found = [
        f"Bistable Workbench {__version__}",
        f"FreeCAD {'.'.join(App.Version()[:3])}",
        f"Python {platform.python_version()}",
        f"numpy {np.__version__}",
    ]
    try:
        found.append(f"matplotlib {metadata.version('matplotlib')}")
    except metadata.PackageNotFoundError:
        found.append("without matplotlib")
    return found


def _contents(results):
    links = "".join(
        f'<li><a href="#{_e(r.design.stem)}">{_e(r.design.title)}</a></li>' for r in results
    )
    return f"<nav><ul>{links}</ul></nav>"


def _section(result, home, several):
    """One design: numbers, pictures, files, parameters, units, how to make it again."""
    design, facts = result.design, result.facts
    parts = [f'<section id="{_e(design.stem)}">']
    if several:
        parts.append(f"<h2>{_e(design.title)}</h2>")
        parts.append(f"<p>{_e(design.get('design', 'description', ''))}</p>")
    if result.problems:
        items = "".join(f"<li>{_e(problem)}</li>" for problem in result.problems)
        parts.append(
            f'<div class="problems"><strong>What went wrong:</strong><ul>{items}</ul></div>'
        )
    parts += [_print(facts.prints[table], table) for table in facts.prints]
    if facts.numbers:
        parts.append(("<h3>Geometry</h3>" if facts.prints else "") + _numbers(facts.numbers))
    parts += [_figure(path, caption) for caption, path in result.pictures.items()]
    parts.append(
        '<div class="columns"><div><h3>Parameters</h3>'
        + _table(["property", "value"], facts.parameters)
        + "</div>"
        + (f"<div><h3>Files</h3>{_files(result.files, home)}</div>" if result.files else "")
        + "</div>"
    )
    if facts.rows:
        parts.append("<h3>Units</h3>" + _table(facts.columns, facts.rows, "units"))
    if design.text:
        parts.append(_recipe(design, result.attached))
    parts.append("</section>")
    return "\n".join(parts)


def _recipe(design, attached):
    """How to make the same again: the design file, and what has to lie beside it."""
    name = _e(design.path.name)
    beside = "".join(
        f' and <a download="{_e(file)}" href="data:text/plain;base64,'
        f'{base64.b64encode(text.encode()).decode()}">{_e(file)}</a> beside it'
        for file, text in attached.items()
    )
    return (
        f"<h3>Make it again</h3><p>Save this as <code>{name}</code>{beside}, and run "
        f"<code>python3 -m BistableWB {name} --out DIR</code>.</p>"
        f"<pre>{_e(design.text.strip())}</pre>"
    )


def _print(facts, table):
    """Numbers of a print and, the worst first, what was found."""
    title = {"hinges": "The print", "coupon": "The test print"}[table]
    order = {"error": 0, "warning": 1, "note": 2}
    found = sorted(facts.findings, key=lambda finding: order[finding.severity])
    items = "".join(f'<li class="{f.severity}">{_e(f)}</li>' for f in found)
    listed = f'<ul class="findings">{items}</ul>' if found else ""
    more = "".join(
        f"<h3>{_e(part.title)}</h3><p>{_e(part.text)}</p>{_table(part.columns, part.rows)}"
        for part in facts.sections
    )
    return f"<h3>{title}</h3>{_numbers(facts.numbers)}{listed}{more}"


def _numbers(pairs):
    items = "".join(f"<div><dt>{_e(name)}</dt><dd>{_e(value)}</dd></div>" for name, value in pairs)
    return f'<dl class="numbers">{items}</dl>'


def _figure(path, caption):
    data = base64.b64encode(path.read_bytes()).decode()
    return (
        f'<figure><img alt="{_e(caption)}" src="data:image/png;base64,{data}">'
        f"<figcaption>{_e(caption)}.</figcaption></figure>"
    )


def _table(columns, rows, kind=""):
    head = "".join(f"<th>{_e(c)}</th>" for c in columns)
    body = "".join("<tr>" + "".join(f"<td>{_e(x)}</td>" for x in row) + "</tr>" for row in rows)
    return (
        f'<div class="wide"><table class="{kind}"><thead><tr>{head}</tr></thead>'
        f"<tbody>{body}</tbody></table></div>"
    )


def _files(paths, home):
    items = []
    for path in paths:
        link = Path(os.path.relpath(path, home)).as_posix()
        size = path.stat().st_size / 1000
        shown = f"{size:.0f} kB" if size < 1000 else f"{size / 1000:.1f} MB"
        link = f'<a href="{_e(urllib.parse.quote(link))}">{_e(path.name)}</a>'
        items.append(f'<li>{link} <span class="muted">{shown}</span></li>')
    return f'<ul class="files">{"".join(items)}</ul>'


def _e(text):
    return html.escape(str(text), quote=True)
