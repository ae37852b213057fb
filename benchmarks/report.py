# SPDX-License-Identifier: LGPL-2.1-or-later
"""The report on nine hinged units, and the report after the check panel has looked at them.

.ci/in-freecad host --script benchmarks/report.py [FILE]      FILE: where to write the rows as JSON
"""

import json
import sys
import tempfile
import time
from pathlib import Path

import FreeCAD as App

from BistableWB import checking, document_report, make

UNITS, REACH = 9, 32.0


def timed(work):
    """Seconds of wall and of processor."""
    start, cpu = time.perf_counter(), time.process_time()
    work()
    return {"seconds": time.perf_counter() - start, "cpu": time.process_time() - cpu}


def tube():
    """A HingeSet of about nine units, no two of them alike."""
    doc, width = App.newDocument("Report"), REACH * UNITS / 1.2
    points = [(0, 0), (width / 3, width / 4), (2 * width / 3, width / 5), (width, 0)]
    curve = make.make_curve(doc, points=[(*point, 0) for point in points])
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    hinges = make.make_hinge_set(doc, make.make_bistable_unit(doc, triangles))
    doc.recompute()
    return triangles.Count, hinges


def main(path=None):
    """Print both rows, and write them where asked for."""
    count, hinges = tube()
    folder = Path(tempfile.mkdtemp())
    name = f"report of {count} units"
    rows = {
        f"checks of a tube of {count} units": timed(lambda: checking.check(hinges)),
        f"{name} after its check": timed(lambda: document_report.write(hinges, folder / "a.html")),
    }
    hinges.Proxy.model(hinges).findings.clear()
    hinges.Proxy.model(hinges).studied = None
    rows[name] = timed(lambda: document_report.write(hinges, folder / "b.html"))
    for name, row in rows.items():
        print(f"{name}: {row['seconds']:.2f} s, CPU {row['cpu']:.2f} s", flush=True)
    if path:
        Path(path).write_text(json.dumps(rows), encoding="utf-8")


main(*sys.argv[1:2])
