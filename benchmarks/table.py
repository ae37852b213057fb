# SPDX-License-Identifier: LGPL-2.1-or-later
"""One table of how long things take: medians, ratios in one run, and the change since the last one.

    python3 benchmarks/table.py [NAME…]         all rows, or those whose name contains a NAME

Each row is measured in a process of its own, so that its peak memory is its own too. Solids are
made inside FreeCAD; build123d, CadQuery and manifold3d, installed for this benchmark only into
build/bench, each in an environment of its own, make the same panel. The rows are saved as
build/bench/last.json and compared with the rows that were there. *CPU* is the time of processor: on
a machine that does other work too it tells more than the seconds on the clock.
"""

import json
import os
import resource
import statistics
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
HOME = ROOT / "build" / "bench"
VERSIONS = {"build123d": "0.13.0", "cadquery": "2.7.0", "manifold3d": "3.5.4"}
_TOLD = (  # what is said of a row besides
    "exponent", "bodies", "findings", "solids", "stall", "per second", "solids made",
)  # fmt: skip
THIN, THICK = (10, 100, 1000, 10_000), (10, 25, 50, 100, 200)


def timed(work):
    """({seconds, cpu}, result) of one run."""
    start, cpu = time.perf_counter(), time.process_time()
    result = work()
    seconds = time.perf_counter() - start
    return {"seconds": seconds, "cpu": time.process_time() - cpu}, result


def median(work, repeats=5):
    """Medians {seconds, cpu} of some runs, after one that does not count."""
    rows = [timed(work)[0] for _ in range(repeats + 1)][1:]
    return {what: statistics.median(row[what] for row in rows) for what in rows[0]}


def thick_units(count):
    """Compensated units whose angles all differ, so that no body is another unit's copy."""
    import numpy as np

    from BistableWB.origami.hinges.parameters import HingeParameters
    from BistableWB.origami.thick.linkage import ThickUnit
    from BistableWB.origami.unit import plane_unit

    parameters = HingeParameters()
    thetas = np.radians(np.linspace(40, 50, count))
    units = plane_unit(thetas, 0.05 + thetas / np.radians(45) * 0.37, 60.0, 24.0)
    thick = ThickUnit(units, parameters.face_thickness, parameters.gap_between_planes)
    return thick.compensated(), parameters


def panel():
    """The contact panel of a unit with all its knuckles: its `Plate` and parameters."""
    from BistableWB.origami.hinges.layout import unit_layout

    thick, parameters = thick_units(1)
    return unit_layout(thick.axes[0], parameters).plates["contact_left"], parameters


def panel_for_others(path):
    """Write the same panel as numbers for other programs, in the frame (x, −z, height)."""
    from BistableWB.origami.hinges.meshing import CHORD_ERROR, chords_for

    plate, p = panel()
    half = p.face_thickness / 2
    tabs = []
    for tab in plate.tabs:
        hinge, count = tab.hinge, len(tab.hinge.segments)
        start, end = hinge.segments[tab.index]
        arm = [tab.corner(0, 0.0), tab.corner(0), tab.corner(1), tab.corner(1, 0.0)]
        tabs.append({
            "arm": _around(arm),
            "start": [*_flat(hinge.point(start)), hinge.height],
            "end": [*_flat(hinge.point(end)), hinge.height],
            "axis": [*_flat(hinge.direction), 0.0],
            "length": end - start,
            "cone": hinge.cone_height,
            "has_cone": tab.index < count - 1,
            "has_recess": tab.index > 0,
        })  # fmt: skip
    tip = p.tip_radius(plate.tabs[0].hinge.cone_height)
    path.write_text(json.dumps({
        "low": plate.height - half, "high": plate.height + half, "core": _around(plate.core),
        "radius": p.radius, "base": p.cone_base, "tip": tip, "tabs": tabs,
        "chords": chords_for(p.radius, 6.2832, CHORD_ERROR),
    }), encoding="utf-8")  # fmt: skip


def _flat(z):
    return z.real, -z.imag


def _around(points):
    from BistableWB.origami.hinges import polygons

    turned = [z.conjugate() for z in points]
    turned = turned if polygons.area(turned) > 0 else turned[::-1]
    return [(z.real, z.imag) for z in turned]


def row_panel_solid():
    """A panel as a solid of the kernel (inside FreeCAD)."""
    from BistableWB.origami.hinges.knuckles import plate_boundary
    from BistableWB.solids.shapes import shape_of

    plate, parameters = panel()
    made = shape_of(plate_boundary(plate, parameters))
    row = median(lambda: shape_of(plate_boundary(plate, parameters)))
    return {**row, "volume": made.Volume}


def row_panel_mesh():
    """The same panel as a watertight mesh, without the kernel."""
    from BistableWB.origami.hinges.knuckles import plate_boundary
    from BistableWB.origami.hinges.meshing import meshed

    plate, parameters = panel()
    mesh = meshed(plate_boundary(plate, parameters)).mesh
    return {**median(lambda: meshed(plate_boundary(plate, parameters))), "volume": mesh.volume}


def row_tube(count):
    """From the angles of different units to the STL of their print, without the kernel."""
    from BistableWB.exporters import write_bodies
    from BistableWB.exporters.bodies import Body
    from BistableWB.origami.hinges.bodies import tube_drawn

    def make():
        thick, parameters = thick_units(count)
        drawn = tube_drawn(thick, parameters)
        path = HOME / "tube.stl"
        write_bodies([Body(body.name, body, (), None, body.kind) for body in drawn], path)
        path.unlink()
        return len(drawn)

    row, bodies = timed(make)
    return {**row, "bodies": bodies}


def row_checks(count):
    """All checks of the meshes of such a print: soundness, walls, clearances, layers, poses."""
    from BistableWB.checks.printer import Printer
    from BistableWB.checks.suite import Suite
    from BistableWB.checks.table import OPENINGS
    from BistableWB.origami.hinges.bodies import tube_drawn
    from BistableWB.origami.hinges.meshing import mesh_of
    from BistableWB.origami.meshes import PlacedMesh
    from BistableWB.origami.thick import print_stack

    thick, parameters = thick_units(count)
    drawn = tube_drawn(thick, parameters)
    meshes = [
        PlacedMesh(b.name, mesh_of(b.boundary).mesh, b.place, b.unit, b.members, b.kind)
        for b in drawn
    ]
    suite = Suite(meshes, [b.boundary.volume for b in drawn], parameters, Printer())

    def check():
        found = suite.findings()
        for opening in OPENINGS:
            motions = print_stack.motions(thick, opening)
            found += suite._whole().check_poses(motions, opening, thick.misfit(opening))
        return found

    row, found = timed(check)
    return {**row, "findings": len(found)}


def row_margin(count):
    """Snap margins, of one unit in a batch."""
    from BistableWB.origami.snap.contact import holding
    from BistableWB.origami.snap.margin import assess

    def margins():
        thick, parameters = thick_units(count)
        assess(thick, holding(thick, parameters))

    return {what: value / count for what, value in median(margins, 3).items()}


def row_force(count):
    """Barrier, force and stresses of elastic panels, of one unit in a batch."""
    from BistableWB.origami.hinges.bodies import tube_layouts
    from BistableWB.origami.snap.forces import snap_forces
    from BistableWB.origami.snap.materials import MATERIALS, material

    def forces():
        thick, parameters = thick_units(count)
        layouts = tube_layouts(thick, parameters)
        snap_forces(thick, layouts, parameters, material(next(iter(MATERIALS))), "Flat")

    return {what: value / count for what, value in timed(forces)[0].items()}


def row_scaling(what, counts):
    """Seconds by number of units, and the exponent of the last steps."""
    from math import log

    from BistableWB.origami.hinges.bodies import tube_drawn
    from BistableWB.origami.unit import plane_unit

    def thin(count):
        import numpy as np

        plane_unit(np.radians(np.linspace(40, 50, count)), 0.6, 60.0, 24.0)

    work = thin if what == "thin" else lambda count: tube_drawn(*thick_units(count))
    rows = [timed(lambda n=count: work(n))[0] for count in counts]
    times = [row["cpu"] for row in rows]
    exponent = log(times[-1] / times[-2]) / log(counts[-1] / counts[-2])
    return {**rows[-1], "by units": dict(zip(map(str, counts), times, strict=True)),
            "exponent": exponent}  # fmt: skip


ROWS = {
    "panel, solid": (row_panel_solid, ()),
    "panel, mesh": (row_panel_mesh, ()),
    "24 units to STL": (row_tube, (24,)),
    "100 units to STL": (row_tube, (100,)),
    "checks of 24 units": (row_checks, (24,)),
    "margin, one unit": (row_margin, (24,)),
    "force, one unit": (row_force, (4,)),
    "thin, 10 to 10000 units": (row_scaling, ("thin", THIN)),
    "thick, 10 to 200 units": (row_scaling, ("thick", THICK)),
}
_IN_FREECAD = ("panel, solid",)
SCRIPTS = {  # benchmarks with several rows: what is run inside FreeCAD
    "report": ("host", "--script", "benchmarks/report.py", "{result}"),
    "window": ("--gui", "host", "--script", "benchmarks/live.py", "--json", "{result}", "13", "24"),
}


def measured(name):
    """One row, measured in a process of its own."""
    HOME.mkdir(parents=True, exist_ok=True)
    result = HOME / "row.json"
    result.unlink(missing_ok=True)
    command = ["/usr/bin/python3", __file__, "--row", name, str(result)]
    if name in _IN_FREECAD:
        command = [str(ROOT / ".ci" / "in-freecad"), "host", "--script", *command[1:]]
    environment = {**os.environ, "PYTHONPATH": str(ROOT), "OPENBLAS_NUM_THREADS": "1"}
    subprocess.run(command, check=True, env=environment, cwd=ROOT, stdout=subprocess.DEVNULL)
    return json.loads(result.read_text(encoding="utf-8"))


def scripted(name):
    """Rows {name: row} of one of the `SCRIPTS`."""
    result = HOME / "rows.json"
    result.unlink(missing_ok=True)
    arguments = [part.format(result=result) for part in SCRIPTS[name]]
    command = [str(ROOT / ".ci" / "in-freecad"), *arguments]
    subprocess.run(command, check=True, cwd=ROOT, stdout=subprocess.DEVNULL)
    return json.loads(result.read_text(encoding="utf-8"))


def elsewhere():
    """Rows of the same panel by other programs; those that cannot be installed are left out."""
    path, rows = HOME / "panel.json", {}
    panel_for_others(path)
    for program, version in VERSIONS.items():
        python = HOME / program / "bin" / "python"
        if not python.exists():
            subprocess.run(["/usr/bin/python3", "-m", "venv", HOME / program], check=True)
            wanted = f"{program}=={version}"
            subprocess.run([python, "-m", "pip", "install", "-q", wanted], check=False)
        script = Path(__file__).with_name("panel_elsewhere.py")
        made = subprocess.run([python, script, program, path], capture_output=True, text=True)
        if made.returncode == 0:
            rows[f"panel, {program}"] = json.loads(made.stdout)
    return rows


def show(rows, last):
    """Print the table: seconds, CPU, how many times those of our own row, and of the last run."""
    ours = {True: "panel, mesh", False: "panel, solid"}
    print(f"{'':34}{'seconds':>9}{'CPU':>9}{'peak MB':>9}{'× ours':>8}{'× last':>8}")
    for name, row in rows.items():
        own = rows.get(ours[name.endswith("manifold3d")]) if name.startswith("panel") else None
        before = last.get(name, {})
        base = next((what for what in ("cpu", "seconds") if what in row and what in before), None)
        cells = (
            f"{row['seconds']:9.4f}",
            f"{row['cpu']:9.4f}" if "cpu" in row else "",
            f"{row['peak']:9.0f}" if "peak" in row else "",
            f"{row['seconds'] / own['seconds']:8.1f}" if own else "",
            f"{row[base] / before[base]:8.2f}" if base else "",
        )
        widths = 9, 9, 9, 8, 8
        told = ", ".join(f"{what} {row[what]:.3g}" for what in _TOLD if what in row)
        line = "".join(cell.rjust(width) for cell, width in zip(cells, widths, strict=True))
        print(f"{name:34}{line}  {told}")


def main(names):
    sys.path.insert(0, str(ROOT))
    wanted = [name for name in ROWS if not names or any(part in name for part in names)]
    path = HOME / "last.json"
    last = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    rows = {name: measured(name) for name in wanted}
    if any(name.startswith("panel") for name in wanted):
        rows |= elsewhere()
    for name in SCRIPTS:
        if not names or name in names:
            rows |= scripted(name)
    show(rows, last)
    path.write_text(json.dumps({**last, **rows}, indent=1), encoding="utf-8")


def row(name, path):
    """Measure one row here and write it."""
    sys.path.insert(0, str(ROOT))
    work, arguments = ROWS[name]
    found = work(*arguments)
    found["peak"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    Path(path).write_text(json.dumps(found), encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1:2] == ["--row"]:
        row(*sys.argv[2:])
    else:
        main(sys.argv[1:])
