# SPDX-License-Identifier: LGPL-2.1-or-later
"""Design files without FreeCAD: the tube of zero thickness, its nets, angles and a short report.

    python3 -m BistableWB.designs.library arch.toml --out build

For what ``pip install`` gives, numpy only. Curves by points, plane in z = 0 or of kind General, and
single units; prints, curves from files and on spheres, documents and checks need FreeCAD, and are
refused in a sentence that says so.
"""

import argparse
import html
import sys
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import __version__
from ..exporters import dxf, fold, svg
from ..exporters.thin import ThinModel
from ..files import whole_file, write_text
from ..origami.curves.bezier import Bezier
from ..origami.curves.rules import PlacementRule
from ..origami.curves.ruling import default_ruling
from ..origami.design import CurveGeometry, Placing, Single, TubeDesign
from ..origami.errors import Refusal
from ..origami.hinges.parameters import HingeParameters
from ..origami.hinges.presets import PRESETS
from ..origami.snap.targets import FIRM, TargetBarrier, TargetMargin
from ..origami.units.ratios import DEFAULT_SHARE, RatioRule
from .reading import DesignError, read

if TYPE_CHECKING:
    from ..origami.units.tube import Tube
    from .reading import Design

_NEEDS = "{what} needs FreeCAD: install it, and run python3 -m BistableWB {name}"
_STYLE = "body{font:15px sans-serif;max-width:60em;margin:2em auto}td,th{padding:.2em .8em}"


def tube_design(design: "Design") -> TubeDesign:
    """`TubeDesign` of a `reading.Design`; `Refusal` where FreeCAD is needed, or no tube can be."""
    where: Placing | Single
    if "curve" in design.tables:
        where = _placing(design)
    elif "unit" in design.tables:
        where = Single(
            np.radians(design.get("unit", "theta", 45.0)),
            design.get("unit", "edge_length", 60.0),
            np.radians(design.get("unit", "omega", 90.0)),
            design.get("unit", "thickness", 0.0),
        )
    else:
        _refuse("a coupon", design)
    return TubeDesign(where, _rule(design, where), design.get("unit", "height_ratio", 2.5))


def angles(tube: "Tube") -> dict[str, NDArray]:
    """{name: values (n,)} of a tube's units, degrees and shares of ‖AB‖."""
    unit = tube.unit
    values = {
        "theta": np.degrees(unit.theta),
        "alpha": np.degrees(unit.alpha),
        "beta": np.degrees(unit.beta),
        "beta_prime": np.degrees(unit.beta_prime),
        "ratio": unit.ratio,
    }
    return {name: np.broadcast_to(value, len(tube)) for name, value in values.items()}


def write(design: "Design", folder: Path) -> list[Path]:
    """Write nets (SVG, DXF, FOLD), angles (CSV) and a report (HTML) of a design; their paths."""
    tube = tube_design(design).tube()
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    model = [ThinModel(design.title, tube, np.eye(4))]
    made = []
    for suffix, module in ((".svg", svg), (".dxf", dxf), (".fold", fold)):
        made.append(folder / f"{design.stem}{suffix}")
        with whole_file(made[-1]) as unfinished:
            module.write(model, unfinished)
    table = angles(tube)
    rows = [[f"{value:.6f}" for value in row] for row in zip(*table.values(), strict=True)]
    made.append(folder / f"{design.stem}-angles.csv")
    write_text(made[-1], "\n".join(map(",".join, [["unit", *table], *_numbered(rows)])) + "\n")
    made.append(folder / "report.html")
    write_text(made[-1], _page(design, tube, table, rows))
    return made


def _numbered(rows: Sequence[Sequence[str]]) -> list[list[str]]:
    return [[str(k), *row] for k, row in enumerate(rows, 1)]


def _page(
    design: "Design", tube: "Tube", table: Mapping[str, NDArray], rows: Sequence[Sequence[str]]
) -> str:
    def line(cells: Sequence[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{html.escape(c)}</{tag}>" for c in cells) + "</tr>"

    worst = float(np.max(tube.unit.isometry_error()))
    title = html.escape(design.title)
    return (
        f'<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>{title}</title>'
        f"<style>{_STYLE}</style><h1>{title}</h1><p>{len(tube)} units, ‖AB‖ "
        f"{tube.unit.edge_length:g} mm; panels keep their lengths between flat and deployed to "
        f"{worst:.1e}.</p><table>{line(['unit', *table], 'th')}"
        + "".join(line(row, "td") for row in _numbered(rows))
        + f"</table><p>Bistable Workbench {__version__}, without FreeCAD.</p></html>\n"
    )


def _placing(design: "Design") -> Placing:
    kind = design.get("curve", "kind", "Plane")
    points = design.get("curve", "points")
    if points is None:
        _refuse("a curve from a file", design)
    curve = Bezier(points)
    heights = np.array([p[2] if len(p) > 2 else 0.0 for p in points])
    if kind == "Plane" and np.ptp(heights) == 0:
        geometry = CurveGeometry(curve)
    elif kind == "General":
        geometry = CurveGeometry(curve, "General", _legs(design, curve))
    else:
        _refuse("a tilted plane" if kind == "Plane" else f"a curve of kind {kind}", design)
    given = design.tables.get("triangles", {})
    return Placing(
        geometry,
        given.get("edge_length", 40.0),
        np.radians(given.get("gamma", 20.0)),
        given.get("thickness", _pitch(design)),
        given.get("flip_side", False),
        given.get("level", False),
        _placement_rule(given),
    )


def _placement_rule(given: Mapping[str, Any]) -> PlacementRule:
    """The `PlacementRule` of [triangles]; EndFit where none is named, as for new objects."""
    name = given.get("placement_rule", "EndFit")
    if name != "Steered":
        return PlacementRule(name)
    ends = (given.get(key, "Free") for key in ("start_direction", "end_direction"))
    return PlacementRule(name, given.get("tolerance"), given.get("symmetric", False), *ends)


def _pitch(design: "Design") -> float:
    """Pitch of the panels of a print, which its triangles allow for; 0 without one."""
    hinges = design.tables.get("hinges")
    if hinges is None:
        return 0.0
    made = HingeParameters()
    if "preset" in hinges:
        made = PRESETS[hinges["preset"]].parameters()
    given = {key: hinges[key] for key in ("face_thickness", "gap_between_planes") if key in hinges}
    return replace(made, **given).pitch


def _legs(design: "Design", curve: Any) -> Any:
    ruling = design.get("curve", "ruling")
    if ruling is None:
        return default_ruling(curve)
    is_point = design.get("curve", "ruling_kind", "Direction") == "Viewpoint"
    return "point" if is_point else "parallel", tuple(ruling)


def _rule(design: "Design", where: Placing | Single) -> RatioRule:
    given = design.tables.get("unit", {})
    default = "TargetSnap" if "hinges" in design.tables and where.pitch else "Adaptive"
    default = "Adaptive" if "ratio_share" in given else default
    name = given.get("ratio_rule", "Fixed" if "ratio" in given else default)
    if name == "Adaptive":
        return RatioRule(name, share=given.get("ratio_share", DEFAULT_SHARE))
    if name == "Fixed":
        return RatioRule(name, ratio=given.get("ratio", 0.5))
    if name != "TargetSnap":
        return RatioRule(name)
    if given.get("target_barrier"):
        return RatioRule(name, target=TargetBarrier(given["target_barrier"]))
    numbers = {
        field: given[key]
        for key, field in (
            ("target_margin", "margin"), ("hinge_play", "play"), ("strain_limit", "strain_limit")
        )
        if key in given
    }  # fmt: skip
    numbers["margin"] = tuple(given.get("unit_margins", ())) or numbers.get("margin", FIRM)
    return RatioRule(name, target=TargetMargin(where.edge_length, where.pitch, **numbers))


def _refuse(what: str, design: "Design") -> None:
    raise Refusal(_NEEDS, what=what[:1].upper() + what[1:], name=design.path.name)


def main(arguments: Any = None) -> Any:
    """The command line; 0 if all was written, 2 for bad input."""
    parser = argparse.ArgumentParser(prog="bistable-thin", description=__doc__.splitlines()[0])
    parser.add_argument("designs", nargs="+", type=Path, metavar="DESIGN.toml")
    parser.add_argument("--out", type=Path, default=Path("build"), metavar="DIR")
    options = parser.parse_args(arguments)
    code = 0
    for path in options.designs:
        try:
            for made in write(read(path), options.out / path.stem):
                print(made)
        except (DesignError, ValueError, OSError) as error:
            print(f"{path}: {error}" if not isinstance(error, DesignError) else error,
                  file=sys.stderr)  # fmt: skip
            code = 2
    return code


if __name__ == "__main__":
    sys.exit(main())
