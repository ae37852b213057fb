# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which files for other programs a design asks for."""

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from ..exporters.formats import FORMATS
from .keys import FORMATS_OF, NET_FORMATS, PRINT_FORMATS, STATES, TEST_PRINTS

if TYPE_CHECKING:
    import FreeCAD as App

    from .reading import Design


def wanted_files(
    design: "Design", objects: "Mapping[str, App.DocumentObject]"
) -> "Iterator[tuple[App.DocumentObject, str, dict[str, Any]]]":
    """(object, end of the file's name, options) of every file for other programs."""
    prints = design.get("output", "print_states", ["flat"])
    for suffix in design.formats:
        of_print = suffix in PRINT_FORMATS or "unit" not in objects
        if of_print and suffix not in NET_FORMATS:
            for hinges, part in _parts(design, objects):
                if not FORMATS[f".{suffix}"].has_states:
                    yield hinges, f"-print{part}.{suffix}", {}
                    continue
                for state in prints:
                    name = "print" if state == "flat" else f"print-{state}"
                    yield hinges, f"-{name}{part}.{suffix}", {"state": state}
            for table in TEST_PRINTS:
                if table in objects:
                    yield objects[table], f"-{table}.{suffix}", {}
        elif suffix in NET_FORMATS and "unit" in objects:
            yield objects["unit"], f".{suffix}", _net_options(design, suffix)
        elif "unit" in objects and not FORMATS[f".{suffix}"].has_states:
            yield objects["unit"], f".{suffix}", {}
        elif "unit" in objects:
            for state in design.get("output", "states", list(STATES)):
                yield objects["unit"], f"-{state}.{suffix}", {"state": state}


def _parts(
    design: "Design", objects: "Mapping[str, App.DocumentObject]"
) -> "list[tuple[App.DocumentObject, str]]":
    """(HingeSet, what its files' names end in) of every print."""
    if "hinges" not in objects:
        return []
    searched = design.get("design", "make_printable", False)
    if not (design.get("output", "parts", False) or searched):
        return [(objects["hinges"], "")]
    from .parts import hinge_sets  # only FreeCAD has prints

    if searched and len(hinge_sets(objects)) == 1:
        return [(objects["hinges"], "")]
    return [(obj, f"-part{n}") for n, obj in enumerate(hinge_sets(objects), 1)]


def _net_options(design: "Design", suffix: str) -> dict[str, Any]:
    given = {key: design.get("output", key) for key, of in FORMATS_OF.items() if suffix in of}
    return {key: value for key, value in given.items() if value is not None}
