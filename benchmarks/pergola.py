#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pergola of docs/cut-panels.md: its numbers, its cut list, and the picture of its sheets.

python3 benchmarks/pergola.py [FOLDER for pergola.cut.html and others]
"""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT))

import numpy as np  # noqa: E402

from BistableWB.exporters import cut_csv, cut_dxf, cut_html, cut_svg  # noqa: E402
from BistableWB.exporters.svg import drawn  # noqa: E402
from BistableWB.origami.curves.bezier import Bezier  # noqa: E402
from BistableWB.origami.curves.rules import END_FIT  # noqa: E402
from BistableWB.origami.design import CurveGeometry, Placing, TubeDesign  # noqa: E402
from BistableWB.origami.patterns.cut_plan import CutWishes, cut_plan  # noqa: E402

CURVE = Bezier([(0, 0), (2500, 3600), (7500, 3600), (10_000, 0)])
_SHOWN = 4  # sheets in the picture


def pergola():
    """The `CutPlan`: 10 m long, ‖AB‖ 1,000 mm, panels of 18 mm, piano hinges."""
    where = Placing(CurveGeometry(CURVE), 1000.0, np.radians(20), rule=END_FIT)
    return cut_plan("Pergola", TubeDesign(where), CutWishes(panel_thickness=18.0, hinge="Piano"))


def main():
    plan = pergola()
    print("\n".join(cut_html.facts(plan)))
    picture = drawn(plan.sheets[:_SHOWN], plan.name)
    # lines of half a millimetre are not seen where 2.5 m are as wide as a page
    picture = picture.replace("stroke-width:0.", "stroke-width:4.")
    (ROOT / "docs/pergola-sheets.svg").write_text(picture, encoding="utf-8")
    if len(sys.argv) > 1:
        folder = Path(sys.argv[1])
        folder.mkdir(parents=True, exist_ok=True)
        for module, suffix in (
            (cut_html, "html"), (cut_csv, "csv"), (cut_svg, "svg"), (cut_dxf, "dxf"),
        ):  # fmt: skip
            module.write([plan], folder / f"pergola.cut.{suffix}")


if __name__ == "__main__":
    main()
