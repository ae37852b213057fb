# SPDX-License-Identifier: LGPL-2.1-or-later
"""One panel by another program: ``python panel_elsewhere.py PROGRAM PANEL.json``; prints JSON.

PROGRAM: build123d, cadquery or manifold3d, installed for the benchmark only. The panel is that of
`benchmarks.table`: a prism, a barrel, an arm and a cone or recess for every knuckle, joined by
booleans, as one would draw it there.
"""

import json
import math
import statistics
import sys
import time
from pathlib import Path


def main(program, path):
    panel = json.loads(Path(path).read_text(encoding="utf-8"))
    make = {"build123d": _build123d, "cadquery": _cadquery, "manifold3d": _manifold3d}[program]
    times, volume = [], 0.0
    for _ in range(4):
        start = time.perf_counter()
        volume = make(panel)
        times.append(time.perf_counter() - start)
    print(json.dumps({"seconds": statistics.median(times[1:]), "volume": volume}))


def _build123d(panel):
    from build123d import Face, Plane, Polyline, Solid, Vector, Wire

    def prism(corners, low, high):
        points = [Vector(x, y, low) for x, y in corners]
        face = Face(Wire(Polyline(*points, close=True)))
        return Solid.extrude(face, Vector(0, 0, high - low))

    def along(start, axis):
        return Plane(origin=Vector(*start), z_dir=Vector(*axis))

    added = [prism(tab["arm"], panel["low"], panel["high"]) for tab in panel["tabs"]]
    taken = []
    for tab in panel["tabs"]:
        place = along(tab["start"], tab["axis"])
        added.append(Solid.make_cylinder(panel["radius"], tab["length"], place))
        cone = panel["base"], panel["tip"], tab["cone"]
        if tab["has_cone"]:
            added.append(Solid.make_cone(*cone, along(tab["end"], tab["axis"])))
        if tab["has_recess"]:
            taken.append(Solid.make_cone(*cone, place))
    body = prism(panel["core"], panel["low"], panel["high"]).fuse(*added).cut(*taken)
    return body.volume


def _cadquery(panel):
    from cadquery import Face, Solid, Vector, Wire

    def prism(corners, low, high):
        points = [Vector(x, y, low) for x, y in corners]
        face = Face.makeFromWires(Wire.makePolygon(points, close=True))
        return Solid.extrudeLinear(face, Vector(0, 0, high - low))

    added = [prism(tab["arm"], panel["low"], panel["high"]) for tab in panel["tabs"]]
    taken = []
    for tab in panel["tabs"]:
        start, end, axis = (Vector(*tab[name]) for name in ("start", "end", "axis"))
        added.append(Solid.makeCylinder(panel["radius"], tab["length"], start, axis))
        cone = panel["base"], panel["tip"], tab["cone"]
        if tab["has_cone"]:
            added.append(Solid.makeCone(*cone, end, axis))
        if tab["has_recess"]:
            taken.append(Solid.makeCone(*cone, start, axis))
    body = prism(panel["core"], panel["low"], panel["high"]).fuse(*added).cut(*taken)
    return body.Volume()


def _manifold3d(panel):
    from manifold3d import CrossSection, Manifold, OpType

    def prism(corners, low, high):
        return Manifold.extrude(CrossSection([corners]), high - low).translate((0, 0, low))

    def turned(solid, start, axis):
        turn = math.degrees(math.atan2(axis[1], axis[0]))
        return solid.rotate((0, 90, 0)).rotate((0, 0, turn)).translate(start)

    chords = panel["chords"]
    added = [prism(tab["arm"], panel["low"], panel["high"]) for tab in panel["tabs"]]
    taken = []
    for tab in panel["tabs"]:
        barrel = Manifold.cylinder(tab["length"], panel["radius"], panel["radius"], chords)
        added.append(turned(barrel, tab["start"], tab["axis"]))
        cone = Manifold.cylinder(tab["cone"], panel["base"], panel["tip"], chords)
        if tab["has_cone"]:
            added.append(turned(cone, tab["end"], tab["axis"]))
        if tab["has_recess"]:
            taken.append(turned(cone, tab["start"], tab["axis"]))
    whole = Manifold.batch_boolean(
        [prism(panel["core"], panel["low"], panel["high"]), *added], OpType.Add
    )
    return (whole - Manifold.batch_boolean(taken, OpType.Add)).volume()


if __name__ == "__main__":
    main(*sys.argv[1:])
