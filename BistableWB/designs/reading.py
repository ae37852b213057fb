# SPDX-License-Identifier: LGPL-2.1-or-later
"""Design files: a TOML text becomes a checked `Design`, or one sentence that says what to change.

Only the standard library: a design is checked before FreeCAD is started. The keys lie in
`design_table`; what they become in a document, in `building`.
"""

import difflib
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..origami.curves.families import AUTOMATIC, FAMILIES, counts
from ..origami.errors import Phrase, Refusal
from .keys import (
    CHOSEN,
    FORMATS_OF,
    NET_FORMATS,
    OF_SOURCE,
    PRINT_FORMATS,
    PRINTS,
    RULE_OF,
    SINGLE_UNIT,
    TABLES,
    TEST_PRINTS,
    example_of,
)
from .values import BadValue

if TYPE_CHECKING:
    from .values import Key

MAX_BYTES = 1_000_000


class DesignError(Refusal):
    """Bad input: one sentence that names the file, the key and the cure."""


@dataclass(frozen=True)
class Design:
    """A checked design: ``tables`` {table: {key: value}} as written, without defaults."""

    path: Path
    text: str
    tables: dict

    @property
    def stem(self) -> str:
        """Name of the design's folder and start of its files' names."""
        return self.path.stem

    @property
    def title(self) -> str:
        """Name for people."""
        return self.tables.get("design", {}).get("name", self.stem)

    @property
    def formats(self) -> list[str]:
        """Suffixes without dots of the files for other programs."""
        has_print = any(table in self.tables for table in PRINTS)
        return self.get("output", "formats", ["stl", "3mf"] if has_print else ["step", "obj"])

    @property
    def makes_unit(self) -> bool:
        """Whether there is a tube or a single unit; else the design is of a test print only."""
        return "curve" in self.tables or "unit" in self.tables

    def get(self, table: str, key: str, default: Any = None) -> Any:
        """Value of ``key`` in ``[table]``, else ``default``."""
        return self.tables.get(table, {}).get(key, default)


def read(path: Path | str) -> Design:
    """The `Design` in the file ``path``; `DesignError` where there is none."""
    path = Path(path)
    return check(path, _text(path))


def check(path: Path, text: str) -> Design:
    """`Design` of a TOML ``text`` that came from ``path``; `DesignError` with file, key, cure."""
    try:
        tables = tomllib.loads(text)
    except RecursionError:
        raise DesignError(
            "{path}: nested too deeply; write tables of plain values.",
            path=path,
        ) from None
    except ValueError as error:  # also integers of thousands of digits
        raise DesignError(
            "{path}: not valid TOML: {error}; correct it there.",
            path=path,
            error=_lower(error),
        ) from None
    if not tables:
        raise DesignError(
            "{path}: the file is empty; add a table [curve] with points, or [unit] with theta.",
            path=path,
        )
    for name, values in tables.items():
        _check_table(path, name, values)
    tables = {
        name: {key: _checked(path, name, key, value) for key, value in values.items()}
        for name, values in tables.items()
    }
    _check_together(path, tables)
    return Design(path, text, tables)


def _check_name(path: Path) -> None:
    """ValueError where the file's name cannot name a folder and files of its own."""
    if not path.stem.strip(". "):
        raise DesignError(
            "{path}: its name has nothing but dots before .toml, and results are named after it; "
            "rename it.",
            path=path,
        )
    if not str(path).isprintable():  # also what is no valid text: it would end FreeCAD
        raise DesignError(
            "{path}: its name has characters that do not print; rename it.",
            path=str(path).encode("utf-8", "replace").decode(),
        )


def _text(path: Path) -> str:
    _check_name(path)
    if path.suffix.lower() != ".toml":
        raise DesignError(
            "{path}: a design file ends in .toml; rename it or give another file.",
            path=path,
        )
    try:
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except FileNotFoundError:
        raise DesignError(
            "{path}: there is no such file; check its name and folder.",
            path=path,
        ) from None
    except IsADirectoryError:
        raise DesignError(
            "{path}: this is a folder; give the design file in it.",
            path=path,
        ) from None
    except OSError as error:
        raise DesignError(
            "{path}: cannot be read ({reason}); check the file.",
            path=path,
            reason=error.strerror,
        ) from None
    if len(content) > MAX_BYTES:
        raise DesignError(
            "{path}: the file is larger than {most} kB; a design has a few lines, give fewer "
            "control points.",
            path=path,
            most=MAX_BYTES // 1000,
        )
    try:
        return content.decode("utf-8-sig").replace("\r\n", "\n")
    except UnicodeDecodeError as error:
        line = content[: error.start].count(b"\n") + 1
        raise DesignError(
            "{path}: line {line} is not UTF-8 text; save the file with the encoding UTF-8.",
            path=path,
            line=line,
        ) from None


def _check_table(path: Path, name: str, values: Mapping[str, Any]) -> None:
    if name not in TABLES:
        what = f"table [{name}]" if isinstance(values, dict) else f"key {name} outside a table"
        homes = [table for table, keys in TABLES.items() if name in keys]
        cure = f"put it under [{homes[0]}]." if homes else _nearest(name, TABLES, "[{}]")
        raise DesignError(
            "{path}: unknown {what}; {help}",
            path=path,
            what=what,
            help=cure,
        )
    if not isinstance(values, dict):
        raise DesignError(
            "{path}: {name} must be a table; write [{name}] once on a line.",
            path=path,
            name=name,
        )
    for key in values:
        if key not in TABLES[name]:
            raise DesignError(
                "{path}: [{name}] has an unknown key {key}; {help}",
                path=path,
                name=name,
                key=key,
                help=_elsewhere(key, name),
            )


def _elsewhere(key: "Key", table: str) -> Any:
    near = difflib.get_close_matches(key, TABLES[table], 1, 0.75)
    homes = [other for other, keys in TABLES.items() if key in keys]
    if homes and not near:
        return f"put it under [{homes[0]}]."
    return _nearest(key, TABLES[table])


def _nearest(name: Any, known: Any, form: str = "{}") -> Any:
    near = difflib.get_close_matches(name, known, 1, 0.5)
    if near:
        return f"did you mean {form.format(near[0])}?"
    return "use one of " + ", ".join(form.format(k) for k in known) + "."


def _checked(path: Path, table: str, key: str, value: Any) -> Any:
    entry = TABLES[table][key]
    try:
        return entry.kind(value, entry)
    except BadValue as problem:
        raise DesignError(
            "{path}: [{table}] {key}{problem}.",
            path=path,
            table=table,
            key=key,
            problem=problem.said,
        ) from None


def _check_together(path: Path, tables: Mapping[str, Mapping[str, Any]]) -> None:
    """What one key alone cannot tell."""

    def refuse(template: Any, **pieces: Any) -> None:
        raise DesignError("{path}: {problem}.", path=path, problem=Phrase(template, pieces))

    curve, unit = tables.get("curve"), tables.get("unit", {})
    _check_ratio_rule(unit, refuse)
    _check_prints(tables, refuse)
    if curve is None:
        if "triangles" in tables:
            refuse("[triangles] needs a curve; add a table [curve] with points")
        if "theta" not in unit and ("unit" in tables or not set(TEST_PRINTS) & set(tables)):
            refuse("describes nothing; add a table [curve] with points, or theta under [unit]")
        return
    for key in SINGLE_UNIT:
        if key in unit:
            refuse(
                "[unit] {key} is for a single unit, a tube has it from its curve; remove it, or "
                "remove the table [curve]",
                key=key,
            )
    if ("points" in curve) == ("source" in curve):
        if "points" in curve:
            refuse("[curve] has both points and source; keep one")
        refuse(
            "[curve] has neither points nor source; add points = {example}",
            example=example_of("curve", "points"),
        )
    _check_family(curve, refuse)


def _check_family(curve: Mapping[str, Any], refuse: Callable[..., Any]) -> None:
    """What only some curves have."""
    for key in OF_SOURCE:
        if key in curve and "source" not in curve:
            refuse(
                "[curve] {key} chooses in the file of a source; add source, or remove {key}",
                key=key,
            )
    kind = curve.get("kind", AUTOMATIC)
    instead = getattr(FAMILIES.get(kind), "instead", {})
    for key, example in getattr(FAMILIES.get(kind), "needed", {}).items():
        if key not in curve and instead.get(key) not in curve:
            refuse(
                "[curve] kind {kind} needs a {key}; add {key} = {example}",
                kind=kind,
                key=key,
                example=example,
            )
    for needed, family in FAMILIES.items():
        for key in family.keys:
            if key in curve and not counts(needed, kind):
                refuse(
                    '[curve] {key} needs the kind {needed}; add kind = "{needed}" or remove {key}',
                    key=key,
                    needed=needed,
                )


def _check_printable(tables: Any, refuse: Callable[..., Any]) -> None:
    """What `make_printable` needs, and what it chooses by itself."""
    design = tables.get("design", {})
    if not design.get("make_printable"):
        if "snap_margin" in design:
            refuse("[design] snap_margin is for make_printable; add make_printable = true")
        return
    for needed in ("curve", "hinges"):
        if needed not in tables:
            refuse("[design] make_printable needs a table [{needed}]; add it", needed=needed)
    for table, keys in CHOSEN.items():
        for key in keys:
            if key in tables.get(table, {}):
                refuse(
                    "[{table}] {key} is chosen by make_printable; remove one of them",
                    table=table,
                    key=key,
                )


def _check_ratio_rule(unit: Mapping[str, Any], refuse: Callable[..., Any]) -> None:
    default = "Fixed" if "ratio" in unit else "Adaptive"
    for key, rule in RULE_OF.items():
        chosen = unit.get("ratio_rule", default)
        if key in unit and chosen != rule and not (key == "ratio_share" and "ratio" in unit):
            refuse(
                "[unit] {key} is not used by ratio_rule {chosen}; remove it, or set ratio_rule = "
                '"{rule}"',
                key=key,
                chosen=chosen,
                rule=rule,
            )
    if "ratio" in unit and "ratio_share" in unit:
        refuse("[unit] has both ratio and ratio_share; keep one")


def _check_prints(tables: Mapping[str, Mapping[str, Any]], refuse: Callable[..., Any]) -> None:
    """Tables and formats of prints."""
    _check_printable(tables, refuse)
    if "hinges" in tables and not ("curve" in tables or "unit" in tables):
        refuse("[hinges] needs a tube; add a table [curve] with points, or [unit] with theta")
    has_print = any(table in tables for table in PRINTS)
    output = tables.get("output", {})
    formats = output.get("formats", ())
    for wanted in formats:
        if wanted in PRINT_FORMATS and not has_print:
            refuse(
                "[output] formats has {wanted}, which is of a print; add a table [hinges]",
                wanted=wanted,
            )
        if wanted in NET_FORMATS and not ("curve" in tables or "unit" in tables):
            refuse(
                "[output] formats has {wanted}, which is of a tube; add a table [curve]",
                wanted=wanted,
            )
    for key, homes in FORMATS_OF.items():
        if key in output and not set(homes) & set(formats):
            refuse(
                "[output] {key} is for {names}; add one to formats",
                key=key,
                names=" and ".join(homes),
            )
    if output.get("slicer") and "hinges" not in tables:
        refuse("[output] slicer is of a print that opens; add a table [hinges], or remove it")
    if output.get("openscad") and not has_print:
        refuse("[output] openscad is of a print; add a table [hinges], or remove it")
    if "print_states" in output and "hinges" not in tables:
        refuse("[output] print_states is of a print that opens; add a table [hinges]")


def _lower(error: Any) -> str:
    """The text of a TOML error as the middle of a sentence."""
    text = str(error).split(";")[0].rstrip(".")
    return text[:1].lower() + text[1:]
