# SPDX-License-Identifier: LGPL-2.1-or-later
"""A report on one or several designs: one HTML file with everything in it, pictures included.

It is in the language of FreeCAD's window, without a window in English: what is told is a phrase,
and `_e` says it. Titles, labels and names of files stay as they are.
"""

import base64
import html
import os
import platform
import urllib.parse
from importlib import metadata
from pathlib import Path

import FreeCAD as App
import numpy as np

from .. import __version__
from ..files import write_text
from ..language.words import in_words, own_template
from ..origami.errors import phrase
from .live_view import LIVE_STYLE, live_view, script
from .looks import PAGE, STYLE

_ANY_TUBE = phrase("A bistable, flat-foldable tube.")
_TITLES = {
    "hinges": phrase("The print"),
    "coupon": phrase("The test print"),
    "calibration": phrase("The calibration plate"),
}


def write(path, results, title=None, subtitle=None):
    """Write the report on ``results`` (`building.Result`) to ``path``; returns the path."""
    path = Path(path)
    several = len(results) > 1
    first = results[0].design
    contents = _contents(results) if several else ""
    page = PAGE.substitute(
        language=_e(phrase("en")),  # "de" in German
        title=_e(title or first.title),
        subtitle=_e(subtitle or first.get("design", "description", _ANY_TUBE)),
        style=STYLE + LIVE_STYLE,
        contents=contents,
        sections="\n".join(_section(result, path.parent, several) for result in results),
        versions=" · ".join(map(_e, versions())),
        script=script() if any(result.live for result in results) else "",
    )
    write_text(path, page)
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
        found.append(phrase("without matplotlib"))
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
            f'<div class="problems"><strong>{_e(phrase("What went wrong:"))}</strong>'
            f"<ul>{items}</ul></div>"
        )
    parts += [_print(facts.prints[table], table) for table in facts.prints]
    if facts.numbers:
        heading = _heading(phrase("Geometry")) if facts.prints else ""
        parts.append(heading + _numbers(facts.numbers))
    files = _heading(phrase("Files")) + _files(result.files, home)
    parts += [live_view(glb, caption, _e) for caption, glb in result.live.items()]
    parts += [_figure(path, caption) for caption, path in result.pictures.items()]
    parts.append(
        '<div class="columns"><div>'
        + _heading(phrase("Parameters"))
        + _table([phrase("property"), phrase("value")], facts.parameters)
        + "</div>"
        + (f"<div>{files}</div>" if result.files else "")
        + "</div>"
    )
    if facts.rows:
        parts.append(_heading(phrase("Units")) + _table(facts.columns, facts.rows, "units"))
    if design.text:
        parts.append(_recipe(design, result.attached))
    parts.append("</section>")
    return "\n".join(parts)


def _recipe(design, attached):
    """How to make the same again: the design file, and what has to lie beside it."""
    name = _e(design.path.name)
    told = phrase(
        "Save this as {name}, {files} beside it, and run {command}."
        if attached
        else "Save this as {name}, and run {command}.",
        name=f"<code>{name}</code>",
        files=", ".join(_link(*one) for one in attached.items()),
        command=f"<code>python3 -m BistableWB {name} --out DIR</code>",
    )
    said = told.in_words(lambda text: _e(own_template(text)))
    return f"{_heading(phrase('Make it again'))}<p>{said}</p><pre>{_e(design.text.strip())}</pre>"


def _link(file, text):
    data = base64.b64encode(text.encode()).decode()
    return f'<a download="{_e(file)}" href="data:text/plain;base64,{data}">{_e(file)}</a>'


def _print(facts, table):
    """Numbers of a print and, the worst first, what was found."""
    order = {"error": 0, "warning": 1, "note": 2}
    found = sorted(facts.findings, key=lambda finding: order[finding.severity])
    items = "".join(f'<li class="{f.severity}">{_e(f)}</li>' for f in found)
    listed = f'<ul class="findings">{items}</ul>' if found else ""
    more = "".join(
        f"{_heading(part.title)}<p>{_e(part.text)}</p>{_table(part.columns, part.rows)}"
        for part in facts.sections
    )
    return f"{_heading(_TITLES[table])}{_numbers(facts.numbers)}{listed}{more}"


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


def _heading(text):
    return f"<h3>{_e(text)}</h3>"


def _e(said):
    """A phrase, refusal or finding in the user's language, a text as it is; for HTML."""
    return html.escape(in_words(said), quote=True)
