# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m BistableWB design.toml --out DIR``: designs in, folders of files out.

Exit code 0: all was made and every object is valid; 1: something could not be made; 2: bad input,
with one sentence that names file, key and cure. Progress goes to stderr, the paths of the files
that were made to stdout.
"""

import argparse
import sys
import traceback
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from . import __version__, launcher
from .design import DesignError, read

DONE, FAILED, BAD_INPUT, INTERRUPTED = 0, 1, 2, 130

_EPILOG = """\
Each DESIGN.toml gives a folder DIR/DESIGN with the document (.FCStd), the flat and the deployed
faces (.step, .obj), pictures and a report. docs/design-files.md describes the files, and
resources/examples has some to start from:

  python3 -m BistableWB resources/examples/plane-arch.toml --out build/arch
  python3 -m BistableWB resources/examples/*.toml --out build/examples --jobs 3

Where FreeCAD cannot be imported, the program starts itself inside freecadcmd: the one of the
environment variable FREECADCMD, else the first on the PATH.
"""


def main(args=None):
    """Run the program with ``args`` (default: the command line's); returns the exit code."""
    options = _parser().parse_args(args)
    designs, bad = _read_all(options.designs)
    try:
        problem = make_folder(options.out) or _same_names(designs)
        if problem:
            print(problem, file=sys.stderr)
            return BAD_INPUT
        code = _make_all(designs, options) if designs else DONE
    except launcher.NoFreeCAD as missing:
        print(missing, file=sys.stderr)
        code = FAILED
    except KeyboardInterrupt:
        print("Interrupted.", file=sys.stderr)
        return INTERRUPTED
    return BAD_INPUT if bad or code == BAD_INPUT else code


def _parser():
    parser = argparse.ArgumentParser(
        prog="python3 -m BistableWB",
        description="Make bistable, flat-foldable tubes from design files.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    add("designs", nargs="+", metavar="DESIGN.toml", help="design files")
    add("--out", required=True, metavar="DIR", type=Path, help="folder for the results")
    at_once = "designs made at the same time, each in a process of its own (default 1)"
    add("--jobs", type=_count, default=1, metavar="N", help=at_once)
    add("--quiet", action="store_true", help="no progress, only what went wrong")
    add("--version", action="version", version=f"Bistable Workbench {__version__}")
    return parser


def _count(text):
    if not text.isdecimal() or not 1 <= int(text) <= 256:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number from 1 to 256")
    return int(text)


def _read_all(paths):
    """The designs that can be read, and whether there were others; says why."""
    designs, bad = [], False
    for path in dict.fromkeys(paths):
        try:
            designs.append(read(path))
        except DesignError as error:
            print(error, file=sys.stderr)
            bad = True
    return designs, bad


def make_folder(folder):
    """Make the folder for the results; returns a sentence where it cannot be."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        return f"--out {folder}: there is a file of that name; choose another folder."
    except OSError as error:
        return f"--out {folder}: cannot be made ({error.strerror}); choose another folder."
    return None


def _same_names(designs):
    """A sentence where two designs would write to one folder."""
    seen = {}
    for design in designs:
        other = seen.setdefault(design.stem.lower(), design)
        if other is not design:
            return (
                f"{design.path}: would write to the same folder as {other.path}; rename one of "
                "them, or give them different --out."
            )
    return None


def _make_all(designs, options):
    """Make designs here, or shared out to processes of their own; the worst exit code."""
    jobs = min(options.jobs, len(designs))
    if jobs == 1 and launcher.available():
        return max(_make(design, options) for design in designs)
    switches = ["--out", str(options.out), *["--quiet"] * options.quiet]
    batches = [[str(d.path) for d in designs[i::jobs]] for i in range(jobs)]
    running = [launcher.start("cli", [*switches, "--", *batch]) for batch in batches]
    try:
        with ThreadPoolExecutor(jobs) as pool:
            codes = list(pool.map(lambda process: process.wait(), running))
    except KeyboardInterrupt:
        for process in running:
            process.terminate()
        raise
    for code in codes:
        if code not in (DONE, FAILED, BAD_INPUT, INTERRUPTED):
            print(f"FreeCAD ended with code {code}: not everything was made.", file=sys.stderr)
    return max(code if code in (DONE, FAILED, BAD_INPUT) else FAILED for code in codes)


def _make(design, options):
    """Make one design here and say what happens; returns its exit code."""
    from . import produce

    told = []

    def progress(text):  # long steps say the same again and again
        if not options.quiet and told[-1:] != [text]:
            told.append(text)
            print(f"{design.stem}: {text}", file=sys.stderr, flush=True)

    try:
        result = produce.produce(design, options.out / design.stem, progress)
    except DesignError as error:
        print(error, file=sys.stderr, flush=True)
        return BAD_INPUT
    except (ValueError, OSError) as error:
        print(f"{design.path}: {error}", file=sys.stderr, flush=True)
        return FAILED
    except Exception:
        traceback.print_exc()
        print(
            f"{design.path}: this is a mistake of the program, please report it.", file=sys.stderr
        )
        return FAILED
    for path in result.files:
        print(path)
    for problem in result.problems:
        print(f"{design.path}: {problem}", file=sys.stderr, flush=True)
    return FAILED if result.problems else DONE
