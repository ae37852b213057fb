# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m BistableWB design.toml --out DIR``: designs in, folders of files out.

Exit code 0: all was made and every object is valid; 1: something could not be made; 2: bad input,
with one sentence that names file, key and cure. Progress goes to stderr, the paths of the files
that were made to stdout.
"""

import argparse
import signal
import sys
import threading
import traceback
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from .. import __version__
from ..designs.reading import DesignError, read
from ..origami.errors import Refusal
from ..origami.progress import Progress
from ..programs import freecad

DONE, FAILED, BAD_INPUT, INTERRUPTED = 0, 1, 2, 130
_PATIENCE = 5  # s that a FreeCAD which is to end has for it

_EPILOG = """\
Each DESIGN.toml gives a folder DIR/DESIGN with the document (.FCStd), the flat and the deployed
faces (.step, .obj), pictures and a report. docs/design-files.md describes the files, and
resources/examples has some to start from:

  python3 -m BistableWB resources/examples/plane-arch.toml --out build/arch
  python3 -m BistableWB resources/examples/*.toml --out build/examples --jobs 3

Where FreeCAD cannot be imported, the program starts itself inside freecadcmd: the one of the
environment variable FREECADCMD, else the first on the PATH. Without any FreeCAD, it makes the
meshes of prints along plane curves and of single units (.stl, .3mf), and nets.
"""


def main(args=None):
    """Run the program with ``args`` (default: the command line's); returns the exit code."""
    options = _parser(args).parse_args(args)
    _end_like_interrupted()
    if options.verify:
        return _verify(options.verify)
    designs, bad = _read_all(options.designs)
    try:
        problem = make_folder(options.out) or _same_names(designs)
        if problem:
            _say(problem)
            return BAD_INPUT
        code = _make_all(designs, options) if designs else DONE
    except freecad.NoFreeCAD as missing:
        _say(missing)
        code = max(_make_plain(design, options) for design in designs)
    except KeyboardInterrupt:
        _say("Interrupted.")
        return INTERRUPTED
    return BAD_INPUT if bad or code == BAD_INPUT else code


def _parser(args=None):
    parser = argparse.ArgumentParser(
        prog="python3 -m BistableWB",
        description="Make bistable, flat-foldable tubes from design files.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    add = parser.add_argument
    verify = "--verify" in (sys.argv[1:] if args is None else args)
    add("designs", nargs="*" if verify else "+", metavar="DESIGN.toml", help="design files")
    add("--out", required=not verify, metavar="DIR", type=Path, help="folder for the results")
    looks = "open every output in a folder again: is it whole, and what its document says?"
    add("--verify", metavar="DIR", type=Path, help=looks)
    at_once = "designs made at the same time, each in a process of its own (default 1)"
    add("--jobs", type=_count, default=1, metavar="N", help=at_once)
    add("--quiet", action="store_true", help="no progress, only what went wrong")
    add("--version", action="version", version=f"Bistable Workbench {__version__}")
    return parser


def _verify(folder):
    """Look at outputs that are there already; returns the exit code."""
    from . import verify

    if freecad.available():
        return verify.main([str(folder)])
    try:
        return freecad.start("program.verify", [str(folder)]).wait()
    except freecad.NoFreeCAD as missing:
        _say(missing)
        return FAILED


def _end_like_interrupted():
    """An end from outside (TERM, a closed terminal) cleans up as Ctrl-C does."""

    def interrupt(*_):
        raise KeyboardInterrupt

    if threading.current_thread() is threading.main_thread():
        for name in ("SIGTERM", "SIGHUP"):
            if hasattr(signal, name):
                signal.signal(getattr(signal, name), interrupt)


def _say(text):
    """A line for people: nothing that a file holds steers their terminal."""
    shown = "".join(
        c if c.isprintable() or c == "\n" else "\N{REPLACEMENT CHARACTER}" for c in str(text)
    )
    print(shown, file=sys.stderr, flush=True)


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
            _say(error)
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
    if jobs == 1 and freecad.available():
        return max(_make(design, options) for design in designs)
    switches = ["--out", str(options.out), *["--quiet"] * options.quiet]
    batches = [[str(d.path) for d in designs[i::jobs]] for i in range(jobs)]
    running = [freecad.start("program.cli", [*switches, "--", *batch]) for batch in batches]
    with ThreadPoolExecutor(jobs) as pool:  # it waits until they have ended, whatever happens
        try:
            codes = list(pool.map(lambda process: process.wait(), running))
        except KeyboardInterrupt:
            for process in running:
                process.terminate()
                threading.Timer(_PATIENCE, process.kill).start()
            raise
    for code in codes:
        if code not in (DONE, FAILED, BAD_INPUT, INTERRUPTED):
            _say(f"FreeCAD ended with code {code}: not everything was made.")
    return max(code if code in (DONE, FAILED, BAD_INPUT) else FAILED for code in codes)


def _make_plain(design, options):
    """What of one design can be made without FreeCAD: meshes of the print, and nets."""
    try:
        from ..designs import plain
    except ImportError as missing:
        _say(f"Without FreeCAD, numpy is needed: {missing}.")
        return FAILED

    def progress(text):
        if not options.quiet:
            _say(f"{design.stem}: {text}")

    try:
        paths, problems = plain.files_of(design, options.out / design.stem, progress)
    except DesignError as error:
        _say(error)
        return FAILED
    except (ValueError, OSError) as error:
        _say(f"{design.path}: {error}")
        return FAILED
    for path in paths:
        print(path)
    for problem in problems:
        _say(f"{design.path}: {problem}")
    return FAILED if problems else DONE


def _make(design, options):
    """Make one design here and say what happens; returns its exit code."""
    from ..designs import building

    told = []

    def say(text, fraction):  # long steps say the same again and again
        if not options.quiet and text and told[-1:] != [text]:
            told.append(text)
            _say(f"{design.stem}: {text}")

    try:
        result = building.produce(design, options.out / design.stem, Progress(say))
    except DesignError as error:
        _say(error)
        return BAD_INPUT
    except (Refusal, OSError) as error:
        _say(f"{design.path}: {error}")
        return FAILED
    except Exception:
        traceback.print_exc()
        _say(f"{design.path}: this is a mistake of the program, please report it.")
        return FAILED
    for path in result.files:
        print(path)
    for problem in result.problems:
        _say(f"{design.path}: {problem}")
    return FAILED if result.problems else DONE
