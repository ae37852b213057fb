# SPDX-License-Identifier: LGPL-2.1-or-later
"""The formats of files for other programs: one table, pure data.

To add one, write its module (``write(bodies, path, **options)``) and add a line: the dialog, the
panel, design files and docs/formats.md read it.
"""

from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from pathlib import Path

# What a format is of: shapes of any object, solids of a print, or panels without thickness.
SHAPES, SOLIDS, NETS = "any object", "HingeSet, HingeCoupon, any solid", "BistableUnit, HingeSet"


class Format(NamedTuple):
    """``module`` of this package, what it is ``of`` and ``holds``.

    ``has_states``: whether ``state`` chooses what is written (nets hold every state);
    ``keys``: options that [output] of a design file may give too; ``panel``: those that the window
    asks for; ``options``: further ones, of `export` only; ``same_as``: another suffix of the same.
    """

    module: str
    of: str
    holds: str
    has_states: bool = True
    keys: tuple = ()
    panel: tuple = ()
    options: tuple = ()
    same_as: str = ""


_MESH = ("linear_deflection", "angular_deflection")
_SHEET = ("sheet", "tabs", "tab_depth")
_CUT_SOLIDS = ("panel_thickness", "panel_hinge", "stock", "edge_gap")
_CUT = (*_CUT_SOLIDS, "kerf")

# Suffix -> format, in the order of the dialog: first what most people send to a printer.
FORMATS = {
    ".3mf": Format(
        "threemf", SOLIDS, "one object with a named, coloured part a body",
        options=("assembly", "one_object", *_MESH),
    ),
    ".stl": Format("stl", SOLIDS, "triangles of all bodies", options=_MESH),
    ".step": Format("step", SHAPES, "one named shape a body, exact surfaces"),
    ".stp": Format("step", SHAPES, "the same as STEP", same_as=".step"),
    ".obj": Format("obj", SHAPES, "named bodies; straight panels as polygons", options=_MESH),
    ".glb": Format(
        "glb", SHAPES, "bodies with the deployment as an animation", False,
        options=("frames", *_MESH),
    ),
    ".xml": Format(
        "mjcf", SOLIDS, "a mechanism for MuJoCo (MJCF), of a HingeSet", False,
        options=("closure", "density", "stiffness", "fixed"),
    ),
    ".scad": Format("scad", SOLIDS, "a program for OpenSCAD", has_states=False),
    ".fold": Format(
        "fold", NETS, "surface, deployed and flat-folded", False, ("deployment_frames",),
        ("deployment_frames", "title", "author"), ("title", "author"),
    ),
    ".svg": Format(
        "svg", NETS, "nets on sheets, to cut and score", False, _SHEET, (*_SHEET, "colours"),
        ("page", "colours"),
    ),
    ".dxf": Format("dxf", NETS, "the same as SVG", False, _SHEET, _SHEET, ("page",)),
    ".cut.html": Format(
        "cut_html", NETS, "a page: thick panels cut from sheets, hinges, sheets as pictures", False,
        _CUT, _CUT,
    ),
    ".cut.csv": Format("cut_csv", NETS, "the cut list as a table", False, _CUT, _CUT),
    ".cut.svg": Format(
        "cut_svg", NETS, "thick panels nested on sheets, to cut and drill", False, _CUT, _CUT,
        ("page",),
    ),
    ".cut.dxf": Format("cut_dxf", NETS, "the same as .cut.svg", False, _CUT, _CUT, ("page",)),
    ".cut.step": Format(
        "cut_step", NETS, "the nested panels as solids", False, _CUT_SOLIDS, _CUT_SOLIDS
    ),
}  # fmt: skip


def suffixes() -> Any:
    """Suffixes that `export` knows, as text for people."""
    return ", ".join(FORMATS)


def suffix_of(path: "Path") -> str:
    """The suffix of a path as `FORMATS` has it: ".cut.svg" where that is one; small letters."""
    known = [suffix for suffix in FORMATS if path.name.lower().endswith(suffix)]
    return max(known, key=len, default=path.suffix.lower())


def named(of: str | None = None) -> tuple[str, ...]:
    """Names in design files ("stl") of all formats, or of those that are ``of`` this."""
    return tuple(
        suffix[1:]
        for suffix, entry in FORMATS.items()
        if not entry.same_as and of in (None, entry.of)
    )


def formats_with(key: str) -> tuple[str, ...]:
    """Names of the formats that use ``key`` of a design file's [output]."""
    return tuple(suffix[1:] for suffix, entry in FORMATS.items() if key in entry.keys)
