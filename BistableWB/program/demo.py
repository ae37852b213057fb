# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m BistableWB.program.demo --out build/demo``: the main job, headless, on the examples.

Every design of ``resources/examples`` becomes a folder of files, and index.html shows them all.
``--pictures resources/pictures`` makes the pictures and the film of the README anew instead. Exit
codes and streams as in `BistableWB.program.cli`.
"""

import argparse
import sys
import time
from pathlib import Path

from .. import EXAMPLES
from ..designs.reading import read
from ..files import whole_file
from ..origami.errors import Refusal
from ..programs import freecad
from . import cli

_TITLE = "Bistable Workbench: examples"
_SUBTITLE = (
    "From a curve to a tube of bistable origami units, flat-folded and deployed. Both states have "
    "the same panels; the way between them bends them, so that the tube snaps. The hinged ones are "
    "ready to print, flat-folded."
)
# Picture of the README -> the example that it shows, and the name of the picture there.
_README = {
    "tube.png": ("hinged-arch", "print"),
    "deployment.gif": ("hinged-arch", "film"),
    "hinge.png": ("spherical-unit", "hinge"),
    "states.png": ("spherical-unit", "opening"),
}
_PALETTE = 200  # colours of a README picture: a third of the size, and nothing to be seen of it


def main(args=None):
    """Run the demo with ``args`` (default: the command line's); returns the exit code."""
    parser = argparse.ArgumentParser(
        prog="python3 -m BistableWB.program.demo",
        description="Make the examples, and a page that shows them.",
    )
    parser.add_argument("--out", type=Path, default=Path("build/demo"), metavar="DIR",
                        help="folder for the results (default build/demo)")  # fmt: skip
    parser.add_argument("--pictures", type=Path, metavar="DIR",
                        help="make only the pictures of the README, in this folder")  # fmt: skip
    options = parser.parse_args(args)
    folder = options.pictures or options.out
    try:
        if not freecad.available():
            switch = "--pictures" if options.pictures else "--out"
            return freecad.start("program.demo", [switch, str(folder)]).wait()
        problem = cli.make_folder(folder)
        if problem:
            print(problem, file=sys.stderr)
            return cli.BAD_INPUT
        return _make_pictures(folder) if options.pictures else _run(folder)
    except freecad.NoFreeCAD as missing:
        print(missing, file=sys.stderr)
        return cli.FAILED
    except KeyboardInterrupt:
        return cli.INTERRUPTED


def _run(out):
    from ..designs import building
    from ..reports import page

    started, results, failed = time.monotonic(), [], False
    for path in sorted(EXAMPLES.glob("*.toml")):
        began = time.monotonic()
        try:
            result = building.produce(read(path), out / path.stem)
        except (Refusal, OSError) as error:
            print(f"{path.name}: {error}", file=sys.stderr)
            failed = True
            continue
        results.append(result)
        _tell(result, time.monotonic() - began)
        failed |= bool(result.problems)
    if not results:
        print(f"{EXAMPLES}: no example could be made.", file=sys.stderr)
        return cli.FAILED
    index = page.write(out / "index.html", results, _TITLE, _SUBTITLE)
    print(f"\nOpen {index} to see everything ({time.monotonic() - started:.0f} s).")
    return cli.FAILED if failed else cli.DONE


def _tell(result, seconds):
    """One paragraph on stdout: the design, its numbers, its files, what went wrong."""
    numbers = _by_name(result.facts)
    told = [f"θ {numbers['opening angle θ']}, isometry error {numbers['isometry error']}"]
    told += [
        f"{n['moving bodies']} bodies, print {n['print']}, snap margin {n['snap margin']}"
        for table, facts in result.facts.prints.items()
        for n in [_by_name(facts)]
        if table == "hinges"
    ]
    count = "1 unit" if numbers["units"] == "1" else f"{numbers['units']} units"
    print(f"{result.design.title}: {count}, {', '.join(told)} ({seconds:.1f} s)")
    kinds = sorted({path.suffix for path in result.files})
    print(f"  {result.folder}: {len(result.files)} files ({' '.join(kinds)})", flush=True)
    for problem in result.problems:
        print(f"{result.design.path}: {problem}", file=sys.stderr, flush=True)


def _by_name(facts):
    """Numbers of a design or a print, {name: text} in English."""
    return {str(name): str(value) for name, value in facts.numbers}


def _make_pictures(folder):
    """The pictures of the README, each from its example."""
    from .. import pictures
    from ..designs import building

    try:
        pictures.require()
        for example in dict.fromkeys(example for example, _ in _README.values()):
            wanted = {name: file for file, (home, name) in _README.items() if home == example}
            for path in building.pictures_of(read(EXAMPLES / f"{example}.toml"), folder, wanted):
                if path.suffix == ".png":
                    _shrink(path)
                print(path, flush=True)
    except (Refusal, OSError) as error:
        print(error, file=sys.stderr)
        return cli.FAILED
    return cli.DONE


def _shrink(path):
    """Give a picture a palette."""
    from PIL import Image  # matplotlib brings it along

    with Image.open(path) as image:
        small = image.convert("RGB").quantize(_PALETTE, dither=Image.Dither.NONE)
    with whole_file(path) as unfinished:
        small.save(unfinished, optimize=True)


if __name__ == "__main__":
    sys.exit(main())
