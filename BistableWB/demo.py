# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m BistableWB.demo --out build/demo``: the main job, headless, on the examples.

Every design of ``resources/examples`` becomes a folder of files, and index.html shows them all.
Exit codes and streams as in `BistableWB.cli`.
"""

import argparse
import sys
import time
from pathlib import Path

from . import EXAMPLES, cli, launcher
from .design import DesignError, read

_TITLE = "Bistable Workbench: examples"
_SUBTITLE = (
    "From a curve to a tube of bistable origami units, flat-folded and deployed. Both states have "
    "the same panels; the way between them bends them, so that the tube snaps."
)


def main(args=None):
    """Run the demo with ``args`` (default: the command line's); returns the exit code."""
    parser = argparse.ArgumentParser(
        prog="python3 -m BistableWB.demo",
        description="Make the examples, and a page that shows them.",
    )
    parser.add_argument("--out", type=Path, default=Path("build/demo"), metavar="DIR",
                        help="folder for the results (default build/demo)")  # fmt: skip
    options = parser.parse_args(args)
    try:
        if not launcher.available():
            return launcher.start("demo", ["--out", str(options.out)]).wait()
        return _run(options.out)
    except launcher.NoFreeCAD as missing:
        print(missing, file=sys.stderr)
        return cli.FAILED
    except KeyboardInterrupt:
        return cli.INTERRUPTED


def _run(out):
    from . import produce, report

    problem = cli.make_folder(out)
    if problem:
        print(problem, file=sys.stderr)
        return cli.BAD_INPUT
    started, results, failed = time.monotonic(), [], False
    # The hinged prints join here: an example with a table [hinges] is enough.
    for path in sorted(EXAMPLES.glob("*.toml")):
        began = time.monotonic()
        try:
            result = produce.produce(read(path), out / path.stem)
        except (DesignError, ValueError, OSError) as error:
            print(f"{path.name}: {error}", file=sys.stderr)
            failed = True
            continue
        results.append(result)
        _tell(result, time.monotonic() - began)
        failed |= bool(result.problems)
    if not results:
        print(f"{EXAMPLES}: no example could be made.", file=sys.stderr)
        return cli.FAILED
    index = report.write(out / "index.html", results, _TITLE, _SUBTITLE)
    print(f"\nOpen {index} to see everything ({time.monotonic() - started:.0f} s).")
    return cli.FAILED if failed else cli.DONE


def _tell(result, seconds):
    """One paragraph on stdout: the design, its numbers, its files, what went wrong."""
    numbers = dict(result.facts.numbers)
    print(
        f"{result.design.title}: {numbers['units']} units, θ {numbers['opening angle θ']}, "
        f"isometry error {numbers['isometry error']} ({seconds:.1f} s)"
    )
    kinds = sorted({path.suffix for path in result.files})
    print(f"  {result.folder}: {len(result.files)} files ({' '.join(kinds)})", flush=True)
    for problem in result.problems:
        print(f"{result.design.path}: {problem}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
