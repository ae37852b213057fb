# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every file is written whole, or the old one stays and nothing is left behind."""

import os
import resource
import signal
import stat
import subprocess
import sys
import zipfile
from contextlib import contextmanager
from pathlib import Path

import pytest

from BistableWB.files import whole_file, write_text

ROOT = Path(__file__).resolve().parents[2]


@contextmanager
def full_disk(free=4096):
    """No file can become larger than ``free`` bytes: the system itself refuses to write more."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (free, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, handler)


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_a_full_disk_leaves_the_old_file_and_nothing_else(tmp_path):
    path = tmp_path / "a.txt"
    write_text(path, "old")
    with full_disk(), pytest.raises(OSError, match="too large"):
        write_text(path, "new" * 10_000)
    assert path.read_text() == "old"
    assert names(tmp_path) == ["a.txt"]


@pytest.mark.parametrize("error", [KeyboardInterrupt, ValueError, OSError])
def test_whatever_goes_wrong_the_old_file_stays(tmp_path, error):
    path = tmp_path / "a.txt"
    path.write_text("old")

    def write_half():
        with whole_file(path) as unfinished:
            unfinished.write_text("ne")
            raise error

    with pytest.raises(error):
        write_half()
    assert path.read_text() == "old"
    assert names(tmp_path) == ["a.txt"]


def test_what_is_empty_or_broken_does_not_replace_anything(tmp_path):
    path = tmp_path / "a.fcstd"
    with zipfile.ZipFile(path, "w") as package:
        package.writestr("Document.xml", "<Document/>" * 50)
    whole = path.read_bytes()
    for content in (b"", whole[: len(whole) // 2], b"no zip at all"):
        with pytest.raises(OSError, match="written"), whole_file(path) as unfinished:
            unfinished.write_bytes(content)
    with pytest.raises(OSError, match="nothing was written"), whole_file(path):
        pass
    assert path.read_bytes() == whole
    assert names(tmp_path) == ["a.fcstd"]


def test_a_new_file_keeps_permissions_links_and_its_own_suffix(tmp_path):
    target, link = tmp_path / "a.txt", tmp_path / "link.txt"
    target.write_text("old")
    target.chmod(0o640)
    link.symlink_to(target)
    with whole_file(link) as unfinished:
        assert unfinished.suffix == ".txt"
        unfinished.write_text("new")
    assert link.is_symlink()
    assert target.read_text() == "new"
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


def test_two_who_write_at_once_do_not_mix(tmp_path):
    path = tmp_path / "a.txt"
    with whole_file(path) as first, whole_file(path) as second:
        first.write_text("first")
        second.write_text("second")
        assert first != second
    assert path.read_text() == "first"
    assert names(tmp_path) == ["a.txt"]


def test_a_killed_writer_leaves_the_old_file(tmp_path):
    path = tmp_path / "a.txt"
    path.write_text("old")
    code = (
        "import os, sys; from BistableWB.files import whole_file\n"
        "with whole_file(sys.argv[1]) as unfinished:\n"
        "    unfinished.write_text('new'); os.kill(os.getpid(), 9)"
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, "-c", code, str(path)], env=environment, check=False)
    assert done.returncode == -9
    assert path.read_text() == "old"


def test_pictures_are_written_so(tmp_path):
    pytest.importorskip("matplotlib")
    from BistableWB.pictures.page import figure

    path = tmp_path / "a.png"
    path.write_bytes(b"old")
    with full_disk(500), pytest.raises(OSError, match="too large"), figure(path, 3, 3) as sheet:
        sheet.text(0.5, 0.5, "θ")
    assert path.read_bytes() == b"old"
    assert names(tmp_path) == ["a.png"]


def test_nothing_else_replaces_files():
    """One home: no other module renames what it has written, or saves beside."""
    homes = [
        path.name
        for path in (ROOT / "BistableWB").rglob("*.py")
        if "os.replace(" in path.read_text(encoding="utf-8")
    ]
    assert homes == ["files.py"]
