# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every format refuses in a sentence what cannot be written, and never leaves half a file."""

import contextlib
import os
import resource
import signal

import Part
import pytest

from BistableWB import make
from BistableWB.exporters import FORMATS, export

NETS = (".fold", ".svg", ".dxf")  # of panels without thickness
CUTS = tuple(suffix for suffix in FORMATS if suffix.startswith(".cut."))  # of thick ones, cut


@pytest.fixture(params=sorted(FORMATS))
def suffix(request):
    return request.param


@pytest.fixture
def subject(doc, valid, suffix):
    """Something that can be written in the format."""
    if suffix in CUTS:
        obj = make.make_bistable_unit(doc, theta=50, ratio=0.5, edge_length=800)
    elif suffix in NETS:
        obj = make.make_bistable_unit(doc, theta=50, ratio=0.5, edge_length=60)
    elif suffix == ".xml":  # a mechanism is of a print that opens
        unit = make.make_bistable_unit(doc, theta=50, ratio=0.5, edge_length=60)
        obj = make.make_hinge_set(doc, unit)
        obj.Segmentations = 3
    else:
        obj = make.make_hinge_coupon(doc)
        obj.Segmentations = 3
    valid(doc)
    return obj


@contextlib.contextmanager
def disk_that_is_full_after(size):
    """The system itself refuses to write more bytes to a file, in whatever language."""
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, handler)


@pytest.mark.parametrize("share", [0.0, 0.5, 0.999])
def test_a_disk_that_fills_up_leaves_the_old_file(subject, suffix, tmp_path, share):
    path = tmp_path / f"print{suffix}"
    whole = export(subject, path).stat().st_size
    path.write_text("old")
    with (
        disk_that_is_full_after(int(share * whole)),
        pytest.raises(ValueError, match=f"print{suffix} was not written to .*: "),
    ):
        export(subject, path)
    assert path.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


def test_targets_that_cannot_be_written(subject, suffix, tmp_path, monkeypatch):
    (tmp_path / f"folder{suffix}").mkdir()
    for name, message in (
        (f"nowhere/a{suffix}", "There is no folder .*nowhere: make it"),
        (f"folder{suffix}", "is a folder: add a file name"),
        (f"a{suffix}x", f"the suffix .{suffix.split('.')[-1]}x: name the file with one of "),
        ("a", "has no suffix: name the file"),
    ):
        with pytest.raises(ValueError, match=message):
            export(subject, tmp_path / name)
    with pytest.raises(ValueError, match="export has no option 'smell'"):
        export(subject, tmp_path / f"a{suffix}", smell="none")
    monkeypatch.setattr(os, "access", lambda *_: False)  # root may write everywhere
    with pytest.raises(ValueError, match="cannot be written: choose another one"):
        export(subject, tmp_path / f"a{suffix}")
    assert [p.name for p in tmp_path.iterdir()] == [f"folder{suffix}"]


@pytest.mark.provokes_errors
def test_selections_that_cannot_be_written(doc, subject, suffix, tmp_path):
    path = tmp_path / f"a{suffix}"
    path.write_text("old")
    for nothing in (None, [], ()):
        with pytest.raises(ValueError, match="Nothing is selected to export: choose"):
            export(nothing, path)
    group = doc.addObject("App::DocumentObjectGroup", "Group")
    with pytest.raises(ValueError, match="Group has no shape"):
        export([subject, group], path)
    line = doc.addObject("Part::Feature", "Line")
    line.Shape = Part.makeLine((0, 0, 0), (1, 0, 0))
    doc.recompute()
    with pytest.raises(ValueError, match="Line has no faces"):
        export(line, path)
    fresh = make.make_bistable_unit(doc, theta=45)
    with pytest.raises(ValueError, match="is not computed yet: recompute"):
        export(fresh, path)
    invalid = make.make_bistable_unit(doc, theta=45, ratio=0.1)
    doc.recompute()
    with pytest.raises(ValueError, match="is invalid, correct it first: Ratio"):
        export(invalid, path)
    assert path.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == [path.name]


def test_a_full_disk_leaves_the_document_that_was_saved_before(doc, tmp_path):
    """FreeCAD itself says nothing of a document that it could not write to its end."""
    from BistableWB.designs import building
    from BistableWB.designs.reading import Design
    from BistableWB.origami.progress import NOBODY

    result = building.Result(Design(tmp_path / "a.toml", "", {}), tmp_path)
    doc.addObject("Part::Box", "Box").Label = "first"
    doc.recompute()
    building._save(result, doc, NOBODY)
    (path,) = tmp_path.iterdir()
    before = path.read_bytes()
    doc.addObject("Part::Sphere", "Sphere")
    doc.recompute()
    with disk_that_is_full_after(2000), contextlib.suppress(OSError):
        building._save(result, doc, NOBODY)
    assert path.read_bytes() == before
    assert list(tmp_path.iterdir()) == [path]
