# SPDX-License-Identifier: LGPL-2.1-or-later
"""What becomes of every file in tests/data/import, as a table.

python3 benchmarks/import_cases.py                              what is read
.ci/in-freecad trixie --script benchmarks/import_cases.py       and the wire that FreeCAD makes
"""

import csv
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from BistableWB.imports import curves_in  # noqa: E402

try:
    from BistableWB.imports.curves import wire_of
except ImportError:  # not inside FreeCAD
    wire_of = None


def result_of(path):
    """(length in mm or None, what became of the file in words)."""
    try:
        curves = curves_in(path)
    except ValueError as refusal:
        return None, f"refused: {refusal}"
    count = f"{len(curves)} curve{'s' * (len(curves) > 1)}"
    wire = f", wire {wire_of(curves[0]).Length:.6g} mm" if wire_of else ""
    return curves[0].length, f"{curves[0].length:.8g} mm, {count}, {curves.receipt.unit}{wire}"


def main():
    """Print a line a file: name, length of the table, what was read; then how many agree."""
    agree = total = 0
    for table in sorted((ROOT / "tests/data/import").glob("*/expected.tsv")):
        with table.open(encoding="utf-8") as file:
            for name, expected, _ in csv.reader(file, delimiter="\t"):
                length, told = result_of(table.parent / name)
                near = length is not None and abs(length - float(expected)) <= 1e-3 * length
                agree, total = agree + near, total + 1
                print(f"{'=' if near else ' '} {name:38} {float(expected):14.8g}  {told}")
    print(f"{agree} of {total} agree with the table within 0.1 % (tests/imports/test_cases.py says")
    print("what of the others: a length of 0 in the table is of a file that nobody measured)")


main()
