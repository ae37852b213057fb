# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves that designers draw: what *Make it printable* chooses for each, and the figures.

    python3 benchmarks/curves.py [--pictures DIR] [--hard] [NAME …]

A table in Markdown on stdout; ``--hard``: of curves at the limit of what can be made, else those of
`tests/data/curves.json`. Needs numpy only; pictures need matplotlib. The bed is 250 × 210 × 210 mm,
the wanted margin 1.2.
"""

import argparse
import json
import sys
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from BistableWB.origami.curves.bezier import Bezier  # noqa: E402
from BistableWB.origami.curves.gentler import Spline  # noqa: E402
from BistableWB.origami.curves.kinds import found_kind, plane_normal  # noqa: E402
from BistableWB.origami.curves.ruling import default_ruling  # noqa: E402
from BistableWB.origami.curves.spheres import Projected  # noqa: E402
from BistableWB.origami.design import CurveGeometry  # noqa: E402
from BistableWB.origami.fit.options import Wish  # noqa: E402
from BistableWB.origami.fit.printable import printable  # noqa: E402
from BistableWB.origami.units.creases import INDEX, PANELS  # noqa: E402

COLOURS = {"contact": "#d98c3f", "border": "#7aa6c2", "primary": "#4f7d5d", "secondary": "#c9c27a"}
HEADS = (
    "curve", "found", "length", "units", "parts", "‖AB‖", "γ", "rule", "panels / gaps", "h",
    "weakest margin", "end gap / ‖AB‖", "gentler by", "time",
)  # fmt: skip


def geometry_of(case):
    """`CurveGeometry` of one case, its kind found as the Curve object finds it."""
    points = np.asarray(case["points"], float)
    closed = bool(np.allclose(points[0], points[-1]))
    curve = Bezier(points) if case["bezier"] else Spline(points, closed)
    kind, centre, radius = found_kind(curve)
    if kind == "Plane":
        return CurveGeometry(curve, kind, ("parallel", tuple(plane_normal(curve))))
    if kind == "Sphere":
        projected = Projected(curve, centre, radius)
        return CurveGeometry(projected, kind, ("point", tuple(centre)), radius)
    return CurveGeometry(curve, kind, default_ruling(curve))


def hard_cases():
    """{name: case} of knots, loops and helices in space."""
    turn = np.linspace(0, 2 * np.pi, 241)

    def trefoil(size):
        x, y = np.sin(turn) + 2 * np.sin(2 * turn), np.cos(turn) - 2 * np.cos(2 * turn)
        return size * np.stack([x, y, -np.sin(3 * turn)], 1)

    def torus(large, small):
        out = large + small * np.cos(3 * turn)
        return np.stack([out * np.cos(turn), out * np.sin(turn), small * np.sin(3 * turn)], 1)

    def coaster(size):
        along = turn / (2 * np.pi)
        x, z = 400 * along - 60 * np.sin(turn), 100 * (1 - np.cos(turn))
        return size * np.stack([x, 60 * along, z], 1)

    def helix(radius, rise, turns):
        a = np.linspace(0, 2 * np.pi * turns, 80 * turns)
        return np.stack([radius * np.cos(a), radius * np.sin(a), rise * a / (2 * np.pi)], 1)

    found = {
        "trefoil_300": trefoil(50), "trefoil_1m": trefoil(170), "torus_150_40": torus(150, 40),
        "torus_300_60": torus(300, 60), "coaster_400": coaster(1), "coaster_800": coaster(2),
        "helix_3_100_80": helix(100, 80, 3), "helix_3_150_200": helix(150, 200, 3),
        "helix_4_200_150": helix(200, 150, 4),
    }  # fmt: skip
    return {name: {"points": points, "bezier": False} for name, points in found.items()}


def stacked(wish):
    """Parts by the printer's height alone."""

    def parts(tube, hinges):
        most, count = wish.in_one(hinges), len(tube.tube)
        return [(first, min(first + most, count) - 1) for first in range(0, count, most)]

    return parts


def row(name, geometry, answer, seconds):
    """One line of the table."""
    found = answer.found
    if found is None:
        empty = ["–"] * (len(HEADS) - 4)
        return [name, geometry.family, *empty, str(answer.blocked), f"{seconds:.0f} s"]
    option, hinges = found.option, found.option.hinges
    margin = f"{found.margin:.2f}" + (f" ({answer.blocked})" if answer.blocked else "")
    ruling = {True: " level", False: ""}[option.level]
    return [
        name, geometry.family + ruling, f"{found.design.placement().length:.0f}",
        str(len(found.margins)), str(len(found.parts)), f"{option.edge_length:.0f}",
        f"{np.degrees(option.gamma):.0f}°", option.rule.name,
        f"{hinges.face_thickness:g} / {hinges.gap_between_planes:g} / {hinges.gap_length:g}",
        f"‖AB‖/{found.design.height_ratio:g}", margin,
        f"{found.end_gap / option.edge_length:.0e}", f"{option.change:.1f}", f"{seconds:.0f} s",
    ]  # fmt: skip


def draw(name, found, folder):
    """A picture of the tube, flat and deployed."""
    from matplotlib import pyplot
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    tube = found.design.tube()
    figure = pyplot.figure(figsize=(9, 3.8))
    for column, opening in enumerate((0, 1), 1):
        points = tube.state(opening)
        axes = figure.add_subplot(1, 2, column, projection="3d")
        for unit in range(len(tube)):
            faces = [points[unit][[INDEX[c] for c in corners]] for corners in PANELS.values()]
            shades = [COLOURS[panel.split("_")[0]] for panel in PANELS]
            axes.add_collection3d(
                Poly3DCollection(faces, facecolors=shades, edgecolors="#333333", linewidths=0.2)
            )
        low, high = points.reshape(-1, 3).min(0), points.reshape(-1, 3).max(0)
        reach = max(high - low) / 2 * 1.02
        middle = (low + high) / 2
        for axis, centre in zip("xyz", middle, strict=True):
            getattr(axes, f"set_{axis}lim")(centre - reach, centre + reach)
        axes.set_axis_off()
        axes.set_box_aspect((1, 1, 1), zoom=1.6)
        axes.view_init(38, -65)
    figure.suptitle(f"{name}: flat and deployed", fontsize=10)
    figure.subplots_adjust(0, 0, 1, 0.95, 0, 0)
    folder.mkdir(parents=True, exist_ok=True)
    figure.savefig(folder / f"{name}.png", dpi=110)
    pyplot.close(figure)


EIGHT = ("spiral", "wave", "heart_half", "helix_stair", "bracelet", "tree_branch", "bridge", "n30")


def sheet(folder):
    """Eight of the pictures on one: the one of docs/will-it-snap.md."""
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(4, 2, figsize=(9, 7.8))
    for name, each in zip(EIGHT, axes.ravel(), strict=True):
        each.imshow(pyplot.imread(folder / f"{name}.png"))
        each.set_axis_off()
    figure.subplots_adjust(0, 0, 1, 1, 0.02, 0.02)
    figure.savefig(folder / "curves.png", dpi=100)


def main():
    """The table, and pictures if asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--pictures", type=Path)
    parser.add_argument("--hard", action="store_true")
    given = parser.parse_args()
    cases = json.loads((ROOT / "tests/data/curves.json").read_text(encoding="utf-8"))
    if given.hard:
        cases = hard_cases()
    wish = Wish()
    print("| " + " | ".join(HEADS) + " |\n|" + "---|" * len(HEADS))
    for name in given.names or cases:
        start = time.monotonic()
        geometry = geometry_of(cases[name])
        answer = printable(geometry, wish, stacked(wish))
        print("| " + " | ".join(row(name, geometry, answer, time.monotonic() - start)) + " |")
        sys.stdout.flush()
        if given.pictures and answer.found is not None:
            draw(name, answer.found, given.pictures)
    if given.pictures and all((given.pictures / f"{name}.png").is_file() for name in EIGHT):
        sheet(given.pictures)


if __name__ == "__main__":
    main()
