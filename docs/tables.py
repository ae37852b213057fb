#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings the tables of these pages up to date with the registries, and draws the architecture.

    python3 docs/tables.py

A table stands between ``<!-- name -->`` and ``<!-- /name -->``. Needs numpy, and no FreeCAD.
"""

import re
import sys
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))


def formats():
    """Rows of the formats of files."""
    from BistableWB.exporters.formats import FORMATS

    yield "suffix", "of", "holds", "options"
    for suffix, entry in FORMATS.items():
        if not entry.same_as:
            names = [*entry.keys, *entry.options, *(["state"] if entry.has_states else [])]
            yield f"`{suffix}`", entry.of, entry.holds, ", ".join(f"`{n}`" for n in names) or "–"


def checks():
    """Rows of the checks of a print, and what they find."""
    from BistableWB.checks.table import CHECKS

    yield "code", "what is measured", "limit", "finding"
    for check in CHECKS.values():
        for row in check.finds:
            yield f"`{row.code}`", row.measured, row.limit, row.finding
    yield ("`contact`", "on demand: contact of moving bodies on PrusaSlicer's toolpaths "
           "([slicing.md](slicing.md))", "0.15 mm² a pair; from 1 mm² it is welded",
           "warning; error")  # fmt: skip
    yield ("`openscad`", "on demand: closed, number of bodies and volume in OpenSCAD", "0.5 %",
           "error")  # fmt: skip


def hinge_kinds():
    """Rows of the kinds of hinges."""
    from BistableWB.origami.hinges.kinds import HINGE_KINDS

    yield "`HingeType`", "what it is", "play"
    for name, kind in HINGE_KINDS.items():
        yield name, kind.what, "of its knuckles" if kind.knuckles else "none: it bends"


def processes():
    """Rows of the processes that print a tube."""
    from BistableWB.origami.hinges.processes import PROCESSES

    yield ("`Process`", "what it is", "`GapLength`", "`GapBetweenPlanes`", "`FaceThickness`",
           "`LayerHeight`", "thinnest wall", "material", "from")  # fmt: skip
    fields = ("gap_length", "gap_between_planes", "face_thickness", "layer_height",
              "nozzle_diameter")  # fmt: skip
    for name, process in PROCESSES.items():
        numbers = [f"{process.gives[field]:g}" for field in fields]
        yield name, process.what, *numbers, process.material, process.sources


def joints():
    """Rows of the joints between halves of contact blocks."""
    from BistableWB.origami.hinges.joints import JOINTS

    yield "`Joint`", "what it is"
    for name, kind in JOINTS.items():
        yield name, kind.what


def end_parts():
    """Rows of the end parts of open tubes."""
    from BistableWB.origami.hinges.ends import END_PARTS

    yield "`StartPart`, `EndPart`", "what it is"
    for name, kind in END_PARTS.items():
        yield name, kind.what


def panel_hinges():
    """Rows of the hinges of cut panels."""
    from BistableWB.origami.patterns.panel_hinges import PANEL_HINGES

    yield "`panel_hinge`", "what it is", "gap between layers, mm", "double hinges"
    for name, hinge in PANEL_HINGES.items():
        links = "slats" if hinge.has_slats else "strips"
        yield f"`{name}`", hinge.what, f"{hinge.gap:g}", links


def families():
    """Rows of the families of curves."""
    from BistableWB.origami.curves.families import FAMILIES

    yield "family", "curve", "legs of the strip", "keys of its own"
    for name, family in FAMILIES.items():
        keys = ", ".join(f"`{key}`" for key in family.keys) or "–"
        yield name, family.curve, family.legs, keys


def parts():
    """Rows of the parts of the house."""
    yield "part", "is", "imports"
    for name, wall in walls().items():
        yield f"`{name}`", wall["is"], ", ".join(wall["may"]) or "–"


def walls():
    """The table of the walls: {part: {"is", "may"}}."""
    return tomllib.loads((HERE / "walls.toml").read_text(encoding="utf-8"))


# Table -> page, and what gives its rows, heads first.
TABLES = {
    "formats": ("formats.md", formats),
    "checks": ("checks.md", checks),
    "hinge kinds": ("hinges.md", hinge_kinds),
    "processes": ("slicing.md", processes),
    "joints": ("hinges.md", joints),
    "end parts": ("hinges.md", end_parts),
    "panel hinges": ("cut-panels.md", panel_hinges),
    "families": ("theory/geometry.md", families),
    "parts": ("architecture.md", parts),
}


def markdown(rows):
    """A table of rows of texts, the first its head."""
    head, *rest = rows
    lines = [head, ["---"] * len(head), *rest]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def page_with(name):
    """The text of the page of a table, with the table as it should be."""
    page, rows = TABLES[name]
    text = (HERE / page).read_text(encoding="utf-8")
    start, end = f"<!-- {name} -->\n", f"\n<!-- /{name} -->"
    pattern = re.compile(f"{re.escape(start)}.*?{re.escape(end)}", re.DOTALL)
    if not pattern.search(text):
        raise SystemExit(f"{page} has no place for the table of {name}")
    return pattern.sub(lambda _: start + markdown(rows()) + end, text)


def levels():
    """{part: how many steps it stands above those that import nothing}."""
    known, table = {}, walls()

    def level(part):
        if part not in known:
            below = [level(other) for other in table[part]["may"] if other in table]
            known[part] = 1 + max(below, default=-1)
        return known[part]

    return {part: level(part) for part in table}


def direct(table):
    """Arrows (part, other) that do not follow from longer ways: those that are drawn."""

    def reach(part):
        found = set()
        for other in table[part]["may"]:
            if other in table:
                found |= {other} | reach(other)
        return found

    for part, wall in table.items():
        others = {other for other in wall["may"] if other in table}
        for other in sorted(others):
            if not any(other in reach(third) for third in others - {other}):
                yield part, other


_WIDTH, _HEIGHT, _ACROSS, _DOWN = 150, 40, 172, 84


def picture():
    """The architecture as SVG: a part stands above all that it imports."""
    table, level = walls(), levels()
    rows = {}
    for part, at in level.items():
        rows.setdefault(at, []).append(part)
    top, most = max(rows), max(map(len, rows.values()))
    places = {}
    for at, names in rows.items():
        for k, part in enumerate(names):
            x = (k + (most - len(names)) / 2) * _ACROSS + 20
            places[part] = x, (top - at) * _DOWN + 20
    size = most * _ACROSS + 20, (top + 1) * _DOWN
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size[0]:g} {size[1]:g}" '
        'font-family="sans-serif">',
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="6" '
        'markerHeight="6" orient="auto"><path d="M0 0 8 4 0 8z" fill="#6B7A89"/></marker></defs>',
        f'<rect width="{size[0]:g}" height="{size[1]:g}" fill="white"/>',
    ]
    for part, other in direct(table):
        (x, y), (u, v) = places[part], places[other]
        x, y, u = x + _WIDTH / 2, y + _HEIGHT, u + _WIDTH / 2
        lines.append(
            f'<path d="M{x:g} {y:g}C{x:g} {y + 24:g} {u:g} {v - 24:g} {u:g} {v:g}" fill="none" '
            'stroke="#6B7A89" marker-end="url(#tip)"/>'
        )
    fills = {"always": "#FBD07C", "never": "#83C3EC"}
    for part, (x, y) in places.items():
        fill = fills.get(table[part].get("gui"), "#D9E0E6")
        what = table[part]["is"]
        lines += [
            f'<g><title>{what}</title><rect x="{x:g}" y="{y:g}" width="{_WIDTH}" '
            f'height="{_HEIGHT}" rx="6" fill="{fill}" stroke="#14283C"/>',
            f'<text x="{x + _WIDTH / 2:g}" y="{y + 17:g}" text-anchor="middle" font-size="13" '
            f'font-weight="bold" fill="#14283C">{part}</text>',
            f'<text x="{x + _WIDTH / 2:g}" y="{y + 31:g}" text-anchor="middle" font-size="8" '
            f'fill="#14283C">{what}</text></g>',
        ]
    return "\n".join([*lines, "</svg>", ""])


def main():
    """Write all tables and the picture."""
    for name, (page, _) in TABLES.items():
        (HERE / page).write_text(page_with(name), encoding="utf-8")
    (HERE / "architecture.svg").write_text(picture(), encoding="utf-8")


if __name__ == "__main__":
    main()
