# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command line: what it makes, what it says, how it exits. Reading designs needs no FreeCAD."""

import os
import re
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import FreeCAD as App
import pytest

from BistableWB import EXAMPLES, ROOT
from BistableWB.designs import reading
from BistableWB.program import cli

ARCH = """
[design]
name = "Small <arch>"
[curve]
points = [[0, 0], [60, 120], [180, 120], [240, 0]]
[triangles]
edge_length = 80
"""
BARE = ARCH + "[output]\npictures = false\nreport = false\nformats = []\n"
UNIT = "[unit]\ntheta = 45\nedge_length = 60\n"
PYTHON = shutil.which("python3", path="/usr/bin") or shutil.which("python3")


@pytest.fixture
def write(tmp_path):
    def write(text, name="arch.toml"):
        path = tmp_path / name
        path.write_bytes(text if isinstance(text, bytes) else textwrap.dedent(text).encode())
        return path

    return write


def run(capsys, *args):
    """Exit code, lines of stdout, stderr of the program, in this FreeCAD."""
    documents = set(App.listDocuments())
    try:
        code = cli.main([str(arg) for arg in args])
    except SystemExit as stop:
        code = stop.code
    assert set(App.listDocuments()) == documents
    captured = capsys.readouterr()
    return code, captured.out.splitlines(), captured.err


def outside(*args, **environment):
    """The program as a user starts it: a Python without FreeCAD, which starts freecadcmd."""
    clean = {k: v for k, v in os.environ.items() if not k.startswith(("PYTHON", "BISTABLE"))}
    return subprocess.run(
        [PYTHON, "-m", *map(str, args)],
        cwd=ROOT,
        env={**clean, **environment},
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
    )


def test_everything_is_made_and_a_second_run_replaces_it(capsys, write, tmp_path):
    path, out = write(ARCH), tmp_path / "a folder" / "out"
    code, made, _ = run(capsys, path, "--out", out)
    assert code == 0
    names = {p.name for p in (out / "arch").iterdir()}
    assert names == {Path(p).name for p in made}
    assert names == {
        "arch.FCStd", "arch-flat.step", "arch-flat.obj", "arch-deployed.step", "arch-deployed.obj",
        "arch-plan.png", "arch-states.png", "arch-angles.png", "report.html",
    }  # fmt: skip
    for name in names:
        (out / "arch" / name).write_text("old")
    assert run(capsys, path, "--out", out, "--quiet")[0] == 0
    assert {p.name for p in (out / "arch").iterdir()} == names
    assert all(p.stat().st_size > 1000 for p in (out / "arch").iterdir())


def test_the_report_is_one_file_with_everything_in_it(capsys, write, tmp_path):
    run(capsys, write(ARCH), "--out", tmp_path / "out")
    text = (tmp_path / "out/arch/report.html").read_text(encoding="utf-8")
    assert "Small &lt;arch&gt;" in text
    assert "<arch>" not in text
    assert text.count("data:image/png;base64,") == 3
    links = re.findall(r'(?:src|href)="(?!data:|#)([^"]+)"', text)
    assert links
    assert all((tmp_path / "out/arch" / link).is_file() for link in links)
    assert str(tmp_path) not in text
    assert "edge_length = 80" in text


def test_the_saved_document_is_what_the_design_says(capsys, write, tmp_path):
    run(capsys, write(BARE + "states = []\n"), "--out", tmp_path)
    doc = App.openDocument(str(tmp_path / "arch/arch.FCStd"))
    try:
        unit = doc.getObject("BistableUnit")
        assert unit.Triangles.EdgeLength.Value == 80
        assert unit.Deployment == 1
        area = unit.Shape.Area
        unit.Triangles.touch()
        doc.recompute()
        assert unit.isValid()
        assert unit.Shape.Area == pytest.approx(area, rel=1e-12)
    finally:
        App.closeDocument(doc.Name)


def test_a_single_unit_needs_no_curve(capsys, write, tmp_path):
    code, made, _ = run(capsys, write(UNIT), "--out", tmp_path)
    assert code == 0
    assert sorted(Path(p).suffix for p in made).count(".png") == 1


def test_a_curve_from_a_file(capsys, write, tmp_path):
    import Part

    Part.makeCircle(100, App.Vector(), App.Vector(0, 0, 1), 0, 150).exportBrep(
        str(tmp_path / "arc.brep")
    )
    text = '[curve]\nsource = "arc.brep"\n[output]\npictures = false\nformats = ["OBJ"]\n'
    code, made, error = run(capsys, write(text), "--out", tmp_path / "out")
    assert code == 0, error
    assert {Path(p).suffix for p in made} == {".FCStd", ".obj", ".html"}


def test_examples_make_valid_objects(capsys, tmp_path):
    from BistableWB.designs import building

    paths = sorted(EXAMPLES.glob("*.toml"))
    assert len(paths) >= 3
    for path in paths:
        read = reading.read(path)
        if "hinges" in read.tables:
            continue  # test_demo.py prints these
        doc = App.newDocument("Example", hidden=True)
        objects = building.build(doc, read)
        assert objects["unit"].IsometryError < 1e-12
        assert objects["triangles"].Coverage > 0.9
        App.closeDocument(doc.Name)


BAD = {
    "empty": ("", "the file is empty; add a table [curve]"),
    "comment": ("# nothing\n", "the file is empty"),
    "not utf-8": (b"[curve]\nname = '\xff'", "line 2 is not UTF-8"),
    "broken": ("[curve]\npoints = [[0, 0], [1, 1]\nkind = 1", "line 3, column"),
    "twice": ("[curve]\n[curve]\n", "line 2"),
    "deep": ("[curve]\npoints = " + "[" * 9000 + "]" * 9000, "nested too deeply"),
    "digits": ("[triangles]\ngamma = " + "9" * 6000, "not valid TOML"),
    "too large": (b"#" * 1_000_001, "larger than 1000 kB"),
    "unknown table": ("[curv]\nkind = 'Plane'", "unknown table [curv]; did you mean [curve]?"),
    "unknown key": (ARCH.replace("edge_l", "edge_L"), "edge_Length; did you mean edge_length?"),
    "wrong table": (ARCH + "points = [[0, 0]]", "[triangles] has an unknown key points; put it"),
    "no table": ("gamma = 20", "unknown key gamma outside a table; put it under [triangles]"),
    "table is a number": ("curve = 3", "curve must be a table"),
    "text for a number": (ARCH + "gamma = 'wide'", '[triangles] gamma is the text "wide"'),
    "true for a number": (ARCH + "gamma = true", "gamma is true; give it an angle"),
    "date for a number": (ARCH + "gamma = 2020-01-01", "gamma is a date or time"),
    "nan": (ARCH + "gamma = nan", "gamma is nan; give it a finite number"),
    "inf": (ARCH + "thickness = -inf", "thickness is -inf"),
    "huge": (ARCH.replace("= 80", "= 1e300"), "edge_length is 1e+300; it must lie between"),
    "overflow": (ARCH.replace("= 80", "= 1e400"), "edge_length is inf"),
    "zero": (ARCH.replace("= 80", "= 0"), "edge_length is 0"),
    "flag": (ARCH + "flip_side = 1", "flip_side is 1; set it to true or false"),
    "choice": ("[curve]\nkind = 'Torus'", '"Torus"; choose one of Automatic, Plane'),
    "no points": ("[curve]\nkind = 'Plane'", "neither points nor source; add points = [[0, 0]"),
    "one point": ("[curve]\npoints = [[0, 0]]", "give it two or more points"),
    "no numbers": ("[curve]\npoints = [[0, 0], ['a', 1]]", "point 2, has a coordinate that"),
    "four numbers": ("[curve]\npoints = [[0, 0], [1, 1, 1, 1]]", "point 2, is a list of 4"),
    "nan point": ("[curve]\npoints = [[0, 0], [nan, 1]]", "point 2, has a coordinate that is nan"),
    "huge point": ("[curve]\npoints = [[0, 0], [1e300, 1]]", "that is 1e+300; it must lie"),
    "coincident": ("[curve]\npoints = [[0, 0], [0, 0.0]]", "points 1 and 2, coincide"),
    "million points": ("[curve]\npoints = [" + "[0,1]," * 20_000 + "]", "has 20000 control"),
    "both": (ARCH.replace("[tri", "source = 'a.step'\n[tri"), "both points and source"),
    "number without a file": (ARCH.replace("[tri", "number = 2\n[tri"), "add source, or remove"),
    "plane with radius": (ARCH.replace("[tri", "sphere_radius = 9\n[tri"), "needs the kind Sphere"),
    "plane with ruling": (ARCH.replace("[tri", "ruling = [0,0,1]\n[tri"), "needs the kind General"),
    "sphere without": ("[curve]\nkind = 'sphere'\npoints = [[0, 0], [9, 0]]", "sphere_radius"),
    "triangles alone": ("[triangles]\ngamma = 3", "[triangles] needs a curve"),
    "nothing": ("[design]\nname = 'x'", "describes nothing"),
    "mixed": (ARCH + "[unit]\ntheta = 40", "[unit] theta is for a single unit"),
    "ratio unused": (UNIT + "ratio = 0.5\nratio_rule = 'Paper'", "not used by ratio_rule Paper"),
    "line break": ('[design]\nname = "a\\nb"', "characters that do not print"),
    "format": (ARCH + "[output]\nformats = ['dwg']", "choose one of 3mf, stl, step, obj"),
    "tabs of no net": (ARCH + "[output]\ntabs = true", "tabs is for svg and dxf; add one to"),
    "net of a coupon": ("[coupon]\n[output]\nformats = ['svg']", "which is of a tube; add a"),
    "print without hinges": (ARCH + "[output]\nformats = ['stl']", "add a table [hinges]"),
    "hinges alone": ("[hinges]\npivot = 'Pin'", "[hinges] needs a tube"),
    "hinge key": (UNIT + "[hinges]\ngap_lenght = 1", "did you mean gap_length?"),
    "preset": (UNIT + "[hinges]\npreset = 'Hinge12'", "choose one of Hinge1, Hinge2"),
    "half a knuckle": (UNIT + "[hinges]\nsegmentations = 6.5", "give it a whole number"),
    "target unused": (UNIT + "target_margin = 2", 'set ratio_rule = "TargetSnap"'),
    "no suffix": ("[curve]\nsource = 'a.png'", "source a.png is no shape file"),
    "no source": ("[curve]\nsource = 'a.step'", "source a.step is not there"),
    # what only the geometry can tell, in the words of the file
    "too long": (ARCH.replace("= 80", "= 4000"), "[triangles] edge_length ‖AB‖ = 4000 mm is too"),
    "gamma": (ARCH + "gamma = 0", "[triangles] gamma is 0"),
    "closed": ("[curve]\npoints = [[0, 0], [90, 90], [-90, 90], [0, 0]]\n"
               "[triangles]\nplacement_rule = 'Paper'", "closed at (0, 0, 0)"),
    "not planar": ("[curve]\nkind = 'Plane'\npoints = [[0,0],[90,0,50],[90,90],[200,0]]",
                   "Curve is not planar"),
    "ratio": (ARCH + "[unit]\nratio = 0.2", "[unit] ratio of unit 1 is 0.2"),
    "many units": (ARCH.replace("= 80", "= 0.4"), "edge_length 0.4 gives"),
    "even knuckles": (UNIT + "[hinges]\nsegmentations = 6", "[hinges] segmentations is 6"),
    "narrow gap": (UNIT + "[hinges]\ngap_length = 0.1", "set gap_length to 0.2 mm or more"),
    "thin pin": (UNIT + "[hinges]\npivot = 'pin'\nface_thickness = 0.6", "set face_thickness to"),
    "small unit": (UNIT.replace("= 60", "= 20") + "[hinges]", "[unit] height_ratio"),
    "flat cones": (UNIT + "[hinges]\ncone_angle = 30", "cone_angle is 30°"),
    "coupon": ("[coupon]\nlength_x = 3", "[coupon] "),
    "theta": ("[unit]\ntheta = 70\nomega = 80\nratio_rule='exact'", "below 60°"),
}  # fmt: skip


@pytest.mark.parametrize("case", BAD)
def test_bad_input_is_one_sentence_with_file_key_and_cure(case, capsys, write, tmp_path):
    text, part = BAD[case]
    path = write(text, "bad.toml")
    code, made, error = run(capsys, path, "--out", tmp_path / "out")
    assert code == 2, error
    assert made == []
    told = [line for line in error.splitlines() if not line.startswith("bad: ")]
    assert len(told) == 1, error
    assert told[0].startswith(f"{path}: ")
    assert part in told[0]
    assert told[0].endswith((".", "?"))
    assert len(told[0]) < 330 + len(str(path))


@pytest.mark.parametrize(
    ("name", "part"),
    [
        ("missing.toml", "there is no such file"),
        ("folder.toml", "this is a folder"),
        ("notes.txt", "ends in .toml"),
    ],
)
def test_what_is_no_design_file(name, part, capsys, tmp_path):
    (tmp_path / "folder.toml").mkdir()
    (tmp_path / "notes.txt").write_text("[curve]")
    code, _, error = run(capsys, tmp_path / name, "--out", tmp_path / "out")
    assert code == 2
    assert part in error


def test_the_good_ones_of_several_are_made(capsys, write, tmp_path):
    code, made, error = run(
        capsys, write("", "bad.toml"), write(BARE, "good.toml"), "--out", tmp_path / "out"
    )
    assert code == 2
    assert "bad.toml: the file is empty" in error
    assert [Path(p).name for p in made] == ["good.FCStd"]


def test_two_designs_for_one_folder_are_refused(capsys, write, tmp_path):
    (tmp_path / "other").mkdir()
    code, made, error = run(
        capsys, write(BARE), write(BARE, "other/ARCH.toml"), "--out", tmp_path / "out"
    )
    assert (code, made) == (2, [])
    assert "same folder" in error


def test_an_out_that_is_a_file(capsys, write, tmp_path):
    code, _, error = run(capsys, write(BARE), "--out", write("", "taken"))
    assert code == 2
    assert "choose another folder" in error


@pytest.mark.parametrize(
    "args", [[], ["--out"], ["a.toml"], ["a.toml", "--out", "x", "--jobs", "0"]]
)
def test_bad_options_exit_with_2(args, capsys):
    code, _, error = run(capsys, *args)
    assert code == 2
    assert "usage: python3 -m BistableWB" in error


def test_help_names_every_option(capsys):
    code, out, _ = run(capsys, "--help")
    assert code == 0
    assert all(word in "\n".join(out) for word in ("--out DIR", "--jobs N", "FREECADCMD", "report"))


def test_without_matplotlib_the_rest_is_made(capsys, write, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    code, made, error = run(capsys, write(ARCH), "--out", tmp_path)
    assert code == 1
    assert "apt install python3-matplotlib" in error
    assert {Path(p).suffix for p in made} == {".FCStd", ".step", ".obj", ".html"}
    assert "python3-matplotlib" in (tmp_path / "arch/report.html").read_text(encoding="utf-8")


def test_a_failed_export_is_told_and_keeps_the_old_file(capsys, write, tmp_path, monkeypatch):
    from BistableWB.exporters import step

    old = tmp_path / "arch" / "arch-flat.step"
    old.parent.mkdir()
    old.write_text("old")

    def fail(bodies, path):
        path.write_text("half")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(step, "write", fail)
    code, made, error = run(capsys, write(ARCH), "--out", tmp_path, "--quiet")
    assert code == 1
    assert error.count("free some space") == 2
    assert old.read_text() == "old"
    assert len(made) == 7
    assert not list(tmp_path.rglob(".writing-*"))


def test_outside_freecad_it_starts_itself_and_keeps_the_streams_apart(write, tmp_path):
    ended = outside("BistableWB", write(BARE), "--out", tmp_path)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.splitlines() == [str(tmp_path / "arch/arch.FCStd")]
    assert ended.stderr.splitlines()[0].startswith("arch: ")


def test_outside_freecad_exit_codes_are_kept(write, tmp_path):
    ended = outside("BistableWB", write(BARE.replace("= 80", "= 4000")), "--out", tmp_path)
    assert ended.returncode == 2
    assert "edge_length ‖AB‖ = 4000 mm is too long" in ended.stderr
    assert "Traceback" not in ended.stderr
    assert ended.stdout == ""
    absent = outside("BistableWB", write(BARE), "--out", tmp_path, FREECADCMD="no-such-program")
    assert absent.returncode == 1
    assert "no-such-program" in absent.stderr
    killed = outside("BistableWB", write(BARE), "--out", tmp_path, FREECADCMD="false")
    assert killed.returncode == 1


def test_jobs_share_the_designs_out(capfd, write, tmp_path):
    paths = [write(BARE, f"{name}.toml") for name in ("one", "two", "three")]
    bad = write(BARE.replace("= 80", "= 4000"), "four.toml")
    code = cli.main([*map(str, paths), str(bad), "--out", str(tmp_path / "out"), "--jobs", "2"])
    made = sorted(Path(line).stem for line in capfd.readouterr().out.splitlines())
    assert code == 2
    assert made == ["one", "three", "two"]
