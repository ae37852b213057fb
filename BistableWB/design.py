# SPDX-License-Identifier: LGPL-2.1-or-later
"""Design files: a TOML text becomes a checked `Design`, or one sentence that says what to change.

Only the standard library: a design is checked before FreeCAD is started. The keys lie in
`design_table`; what they become in a document, in `produce`.
"""

import difflib
import tomllib
from dataclasses import dataclass
from pathlib import Path

from .design_table import (
    FORMATS_OF,
    NET_FORMATS,
    PRINT_FORMATS,
    RULE_OF,
    SINGLE_UNIT,
    TABLES,
    BadValue,
    example_of,
)

MAX_BYTES = 1_000_000


class DesignError(Exception):
    """Bad input. The text is one sentence that names the file, the key and the cure."""


@dataclass(frozen=True)
class Design:
    """A checked design: ``tables`` {table: {key: value}} as written, without defaults."""

    path: Path
    text: str
    tables: dict

    @property
    def stem(self):
        """Name of the design's folder and start of its files' names."""
        return self.path.stem

    @property
    def title(self):
        """Name for people."""
        return self.tables.get("design", {}).get("name", self.stem)

    @property
    def formats(self):
        """Suffixes without dots of the files for other programs."""
        has_print = "hinges" in self.tables or "coupon" in self.tables
        return self.get("output", "formats", ["stl", "3mf"] if has_print else ["step", "obj"])

    @property
    def makes_unit(self):
        """Whether there is a tube or a single unit; else the design is of a coupon only."""
        return "curve" in self.tables or "unit" in self.tables

    def get(self, table, key, default=None):
        """Value of ``key`` in ``[table]``, else ``default``."""
        return self.tables.get(table, {}).get(key, default)


def read(path):
    """The `Design` in the file ``path``; `DesignError` where there is none."""
    path = Path(path)
    return check(path, _text(path))


def check(path, text):
    """`Design` of a TOML ``text`` that came from ``path``; `DesignError` with file, key, cure."""
    try:
        tables = tomllib.loads(text)
    except RecursionError:
        raise DesignError(f"{path}: nested too deeply; write tables of plain values.") from None
    except ValueError as error:  # also integers of thousands of digits
        raise DesignError(f"{path}: not valid TOML: {_lower(error)}; correct it there.") from None
    if not tables:
        raise DesignError(
            f"{path}: the file is empty; add a table [curve] with points, or [unit] with theta."
        )
    for name, values in tables.items():
        _check_table(path, name, values)
    tables = {
        name: {key: _checked(path, name, key, value) for key, value in values.items()}
        for name, values in tables.items()
    }
    _check_together(path, tables)
    return Design(path, text, tables)


def _text(path):
    if path.suffix.lower() != ".toml":
        raise DesignError(f"{path}: a design file ends in .toml; rename it or give another file.")
    try:
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except FileNotFoundError:
        raise DesignError(f"{path}: there is no such file; check its name and folder.") from None
    except IsADirectoryError:
        raise DesignError(f"{path}: this is a folder; give the design file in it.") from None
    except OSError as error:
        raise DesignError(f"{path}: cannot be read ({error.strerror}); check the file.") from None
    if len(content) > MAX_BYTES:
        raise DesignError(
            f"{path}: the file is larger than {MAX_BYTES // 1000} kB; a design has a few lines, "
            "give fewer control points."
        )
    try:
        return content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise DesignError(
            f"{path}: line {line} is not UTF-8 text; save the file with the encoding UTF-8."
        ) from None


def _check_table(path, name, values):
    if name not in TABLES:
        what = f"table [{name}]" if isinstance(values, dict) else f"key {name} outside a table"
        homes = [table for table, keys in TABLES.items() if name in keys]
        cure = f"put it under [{homes[0]}]." if homes else _nearest(name, TABLES, "[{}]")
        raise DesignError(f"{path}: unknown {what}; {cure}")
    if not isinstance(values, dict):
        raise DesignError(f"{path}: {name} must be a table; write [{name}] once on a line.")
    for key in values:
        if key not in TABLES[name]:
            raise DesignError(f"{path}: [{name}] has an unknown key {key}; {_elsewhere(key, name)}")


def _elsewhere(key, table):
    near = difflib.get_close_matches(key, TABLES[table], 1, 0.75)
    homes = [other for other, keys in TABLES.items() if key in keys]
    if homes and not near:
        return f"put it under [{homes[0]}]."
    return _nearest(key, TABLES[table])


def _nearest(name, known, form="{}"):
    near = difflib.get_close_matches(name, known, 1, 0.5)
    if near:
        return f"did you mean {form.format(near[0])}?"
    return "use one of " + ", ".join(form.format(k) for k in known) + "."


def _checked(path, table, key, value):
    entry = TABLES[table][key]
    try:
        return entry.kind(value, entry)
    except BadValue as problem:
        raise DesignError(f"{path}: [{table}] {key}{problem}.") from None


def _check_together(path, tables):
    """What one key alone cannot tell."""

    def refuse(text):
        raise DesignError(f"{path}: {text}.")

    curve, unit = tables.get("curve"), tables.get("unit", {})
    _check_ratio_rule(unit, refuse)
    _check_prints(tables, refuse)
    if curve is None:
        if "triangles" in tables:
            refuse("[triangles] needs a curve; add a table [curve] with points")
        if "theta" not in unit and ("unit" in tables or "coupon" not in tables):
            refuse("describes nothing; add a table [curve] with points, or theta under [unit]")
        return
    for key in SINGLE_UNIT:
        if key in unit:
            refuse(
                f"[unit] {key} is for a single unit, a tube has it from its curve; remove it, or "
                "remove the table [curve]"
            )
    if ("points" in curve) == ("source" in curve):
        both = "both points and source; keep one" if "points" in curve else "neither points nor "
        refuse(f"[curve] has {both}" + ("" if "points" in curve else "source; add points = "
               + example_of("curve", "points")))  # fmt: skip
    kind = curve.get("kind", "Plane")
    if kind == "Sphere" and "sphere_radius" not in curve:
        refuse("[curve] kind Sphere needs a sphere_radius; add sphere_radius = 150 (mm)")
    for key, needed in (
        ("sphere_radius", "Sphere"), ("sphere_center", "Sphere"),
        ("ruling_kind", "General"), ("ruling", "General"),
    ):  # fmt: skip
        if key in curve and kind != needed:
            refuse(f'[curve] {key} needs the kind {needed}; add kind = "{needed}" or remove {key}')


def _check_ratio_rule(unit, refuse):
    default = "Fixed" if "ratio" in unit else "Adaptive"
    for key, rule in RULE_OF.items():
        chosen = unit.get("ratio_rule", default)
        if key in unit and chosen != rule and not (key == "ratio_share" and "ratio" in unit):
            refuse(
                f"[unit] {key} is not used by ratio_rule {chosen}; remove it, or set "
                f'ratio_rule = "{rule}"'
            )
    if "ratio" in unit and "ratio_share" in unit:
        refuse("[unit] has both ratio and ratio_share; keep one")


def _check_prints(tables, refuse):
    """Tables and formats of prints."""
    if "hinges" in tables and not ("curve" in tables or "unit" in tables):
        refuse("[hinges] needs a tube; add a table [curve] with points, or [unit] with theta")
    output = tables.get("output", {})
    formats = output.get("formats", ())
    for wanted in formats:
        if wanted in PRINT_FORMATS and not ("hinges" in tables or "coupon" in tables):
            refuse(f"[output] formats has {wanted}, which is of a print; add a table [hinges]")
        if wanted in NET_FORMATS and not ("curve" in tables or "unit" in tables):
            refuse(f"[output] formats has {wanted}, which is of a tube; add a table [curve]")
    for key, homes in FORMATS_OF.items():
        if key in output and not set(homes) & set(formats):
            refuse(f"[output] {key} is for {' and '.join(homes)}; add one to formats")
    if output.get("slicer") and "hinges" not in tables:
        refuse("[output] slicer is of a print that opens; add a table [hinges], or remove it")
    if output.get("openscad") and not ("hinges" in tables or "coupon" in tables):
        refuse("[output] openscad is of a print; add a table [hinges], or remove it")
    if "print_states" in output and "hinges" not in tables:
        refuse("[output] print_states is of a print that opens; add a table [hinges]")


def _lower(error):
    """The text of a TOML error as the middle of a sentence."""
    text = str(error).split(";")[0].rstrip(".")
    return text[:1].lower() + text[1:]
