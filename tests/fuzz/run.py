# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hostile designs by the thousand: ``make fuzz`` (SEED=n COUNT=n SECONDS=n).

Random documents are made, edited, undone, saved, copied, moved and made anew; design files and
drawings are mutated. What breaks is told with the seed that breaks it again; the exit code is 1.
"""

import collections
import json
import os
import random
import sys
import tempfile
import time
import traceback
from pathlib import Path

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT))

from BistableWB.designs import reading  # noqa: E402 (the path first)
from BistableWB.imports import curves_in  # noqa: E402
from BistableWB.origami.errors import Refusal  # noqa: E402
from tests.fuzz.documents import TOO_LONG, Broken, Session  # noqa: E402
from tests.fuzz.drawn import mutated  # noqa: E402

DESIGNS = sorted((ROOT / "resources/examples").glob("*.toml"))
DRAWINGS = sorted((ROOT / "tests/data/import").glob("*/*.*"))


def a_document(seed, folder, told):
    """One random document; its output is looked through for tracebacks."""
    session = Session(seed, folder)
    try:
        session.run()
    finally:
        told.update(session.told)


def a_design(seed, folder, told):
    """One mutated design file: a design, or one sentence."""
    rng = random.Random(seed)
    path = folder / "design.toml"
    path.write_bytes(mutated(rng, rng.choice(DESIGNS).read_bytes()))
    _one_sentence(lambda: reading.read(path), told, "design")


def a_drawing(seed, folder, told):
    """One mutated drawing or table: curves, or one sentence."""
    rng = random.Random(seed)
    source = rng.choice([path for path in DRAWINGS if path.name != "expected.tsv"])
    path = folder / f"drawing{source.suffix}"
    path.write_bytes(mutated(rng, source.read_bytes()))
    start = time.process_time()
    _one_sentence(lambda: curves_in(path), told, "drawing")
    took = time.process_time() - start
    if took > TOO_LONG:
        raise Broken(f"{source.name} took {took:.0f} s")


def _one_sentence(read, told, what):
    try:
        read()
        told[f"{what} read"] += 1
    except Refusal as refused:
        if "\n" in str(refused).strip() and what == "design":
            raise Broken(f"more than a line: {refused}") from refused
        told[f"{what} refused"] += 1


class Said:
    """What FreeCAD and Python print meanwhile, by file descriptor."""

    def __enter__(self):
        self._kept = [os.dup(1), os.dup(2)]
        self._file = tempfile.TemporaryFile()
        for descriptor in (1, 2):
            os.dup2(self._file.fileno(), descriptor)
        return self

    def __exit__(self, *_):
        for descriptor, kept in zip((1, 2), self._kept, strict=True):
            sys.stdout.flush()
            sys.stderr.flush()
            os.dup2(kept, descriptor)
            os.close(kept)
        self._file.seek(0)
        self.text = self._file.read().decode(errors="replace")
        self._file.close()


def attempt(kind, seed, folder, told):
    """What went wrong with one seed, or ""."""
    problem = ""
    with Said() as said:
        try:
            kind(seed, folder, told)
        except Broken as broken:
            problem = str(broken)
        except Exception:
            problem = traceback.format_exc()
    if not problem and "Traceback" in said.text:
        problem = said.text[said.text.index("Traceback") :][:1500]
    return problem


_TELL = 100
KINDS = (a_document, a_document, a_document, a_design, a_drawing)


def tried(seed, count, seconds=float("inf")):
    """(designs tried, problems, what happened how often) of ``count`` seeds from ``seed`` on."""
    end = time.monotonic() + seconds
    told, problems, done = collections.Counter(), [], 0
    with tempfile.TemporaryDirectory() as folder:
        while done < count and time.monotonic() < end:
            kind = KINDS[(seed + done) % len(KINDS)]
            problem = attempt(kind, seed + done, Path(folder), told)
            if problem:
                problems.append(f"SEED={seed + done} COUNT=1: {kind.__name__}: {problem}")
                print(problems[-1], flush=True)
            done += 1
            if done % _TELL == 0:  # who watches a run ends it when it is silent
                print(f"{done} designs, {len(problems)} problems", flush=True)
    return done, problems, told


def main():
    """Run until COUNT or SECONDS are over; a summary by kind, as text and JSON."""
    seed, count = int(os.environ.get("SEED", "1")), int(os.environ.get("COUNT", "10000"))
    done, problems, told = tried(seed, count, float(os.environ.get("SECONDS", "inf")))
    summary = {"designs": done, "seed": seed, "problems": len(problems), "told": dict(told)}
    home = ROOT / "build" / "fuzz.json"
    home.write_text(json.dumps(summary, indent=1), encoding="utf-8")
    for text, times in told.most_common(60):
        print(f"{times:7} {text}")
    print(f"{done} designs from seed {seed}: {len(problems)} problems")
    return int(bool(problems))


if __name__ == "__main__":
    sys.exit(main())
