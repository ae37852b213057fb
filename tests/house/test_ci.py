# SPDX-License-Identifier: LGPL-2.1-or-later
"""The watchdog of .ci: what speaks may take its time, what hangs is ended."""

import subprocess
import time
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
WATCHDOG = ROOT / ".ci/while-it-speaks"


def watched(tmp_path, seconds, script):
    start = time.monotonic()
    done = subprocess.run(
        [str(WATCHDOG), str(seconds), str(tmp_path / "log"), "bash", "-c", script],
        capture_output=True, text=True, check=False, timeout=60,
    )  # fmt: skip
    return done, time.monotonic() - start


def test_the_exit_code_and_the_words_are_the_command_s(tmp_path):
    done, _ = watched(tmp_path, 60, "echo one; echo two >&2; exit 3")
    assert done.returncode == 3
    assert done.stdout == "one\ntwo\n" == (tmp_path / "log").read_text()


@pytest.mark.slow
def test_what_speaks_is_not_ended_however_long_it_takes(tmp_path):
    # ten times as often as it must: a busy machine lets it wait too
    done, took = watched(tmp_path, 5, "for i in $(seq 12); do echo $i; sleep 0.5; done")
    assert done.returncode == 0
    assert took > 5


@pytest.mark.slow
def test_what_says_nothing_is_ended_with_all_that_it_started(tmp_path):
    mark = tmp_path / "still there"
    done, took = watched(tmp_path, 2, f"echo on; (sleep 8; touch '{mark}') & sleep 60")
    assert done.returncode == 124
    assert took < 12
    time.sleep(8)
    assert not mark.exists()
