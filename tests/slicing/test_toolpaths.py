"""Toolpaths with known answers: what a G-code says, and where its lines touch. Plain numpy."""

import os
import time

import numpy as np
import pytest

from BistableWB.origami.meshes import Mesh
from BistableWB.origami.progress import Cancelled, Progress
from BistableWB.programs import gcode, prusaslicer
from BistableWB.slicing import NoSlicer, orientations
from BistableWB.slicing.contact import contacts

LAYER, WIDTH = 0.2, 0.45
GCODE = """\
G92 E0
T0
;LAYER_CHANGE
;Z:0.2
;HEIGHT:0.2
G1 X1 Y1 F7800
;TYPE:External perimeter
;WIDTH:0.45
G1 X4 Y1 E.5
G1 X4 Y5 E1 ; a comment with X9 Y9 E9
G1 E-2 F2400
G1 X0 Y0 F7800
T1
;TYPE:Support material
;WIDTH:0.4
G1 X0 Y2 E.2
T0
;LAYER_CHANGE
;Z:.4
;HEIGHT:0.2
;TYPE:Solid infill
;WIDTH:0.5
G1 Y-3 E.3
; filament used [cm3] = 1.5, 0.25
; estimated printing time (normal mode) = 1d 2h 3m 4s
"""
FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))


def box(low, high, turn=0.0):
    """A closed box, turned about z by an angle (radians)."""
    corners = np.array([[(low, high)[i >> 2 & 1][0], (low, high)[i >> 1 & 1][1],
                         (low, high)[i & 1][2]] for i in range(8)], float)  # fmt: skip
    triangles = np.array([f for a, b, c, d in FACES for f in ((a, b, c), (a, c, d))])
    mesh = Mesh(corners @ about_z(turn)[:3, :3].T, triangles)
    return mesh if mesh.volume > 0 else Mesh(mesh.vertices, triangles[:, ::-1])


def about_z(turn):
    move = np.eye(4)
    move[:2, :2] = [[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]]
    return move


def lines(*given, turn=0.0, kind="Perimeter"):
    """`gcode.Lines` from (x, y, x, y, layer) of each, turned about z."""
    table = np.array(given, float)
    ends = table[:, :4].reshape(-1, 2, 2) @ about_z(turn)[:2, :2].T
    top = (table[:, 4] + 1) * LAYER
    full = np.ones(len(table))
    return gcode.Lines(ends, top, WIDTH * full, LAYER * full, np.zeros(len(table), int), (kind,))


def test_lines_kinds_time_and_filament_are_read(tmp_path):
    path = tmp_path / "print.gcode"
    path.write_text(GCODE)
    found, estimate = gcode.read(path)
    assert found.ends.tolist() == [
        [[1, 1], [4, 1]], [[4, 1], [4, 5]], [[0, 0], [0, 2]], [[0, 2], [0, -3]],
    ]  # fmt: skip
    assert found.lengths.tolist() == [3, 4, 2, 5]
    assert [found.kinds[k] for k in found.kind] == [
        "External perimeter", "External perimeter", "Support material", "Solid infill",
    ]  # fmt: skip
    assert found.width.tolist() == [0.45, 0.45, 0.4, 0.5]
    assert found.top.tolist() == [0.2, 0.2, 0.2, 0.4]
    assert len(found.of_model().top) == 3
    assert estimate == (93784.0, (1500.0, 250.0), 2, 2)


def test_other_gcode_is_refused(tmp_path):
    path = tmp_path / "other.gcode"
    path.write_text("G1 X1 Y1 E1\n")
    with pytest.raises(ValueError, match="as PrusaSlicer writes them"):
        gcode.read(path)


@pytest.mark.parametrize("turn", [0.0, 0.3, np.pi / 4, 1.2])
@pytest.mark.parametrize(("apart", "touching"), [(0.38, True), (0.55, False)])
def test_lines_beside_each_other_touch_where_they_are_nearer_than_their_width(
    turn, apart, touching
):
    edge = apart / 2
    bodies = [
        box((-2, -1, 0), (-edge + 0.1, 11, 1), turn),
        box((edge - 0.1, -1, 0), (2, 11, 1), turn),
    ]
    laid = lines((-edge, 0, -edge, 10, 2), (edge, 0, edge, 10, 2), turn=turn)
    found = contacts(laid, bodies, LAYER)
    assert [contact.bodies for contact in found] == [(0, 1)] * touching
    if touching:
        assert found[0].beside == pytest.approx(10 * LAYER, rel=0.06)
        assert found[0].above == 0
        assert found[0].point == pytest.approx((*(about_z(turn)[:2, 1] * 5), 2.5 * LAYER), abs=0.1)


@pytest.mark.parametrize("air", [0, 1])
def test_a_line_on_a_line_of_another_body_touches_it_unless_there_is_air_between(air):
    bodies = [box((-1, -1, 0), (11, 1, 0.6)), box((-1, -1, 0.6), (11, 1, 2))]
    found = contacts(lines((0, 0, 10, 0, 2), (0, 0, 10, 0, 3 + air)), bodies, LAYER)
    assert [contact.above for contact in found] == pytest.approx(
        [] if air else [10 * WIDTH], rel=0.03
    )


def test_a_line_through_a_closed_gap_touches_with_its_section():
    bodies = [box((0, -1, 0), (4.96, 1, 1)), box((5.04, -1, 0), (10, 1, 1))]
    (found,) = contacts(lines((1, 0.1, 9, 0.1, 2)), bodies, LAYER)
    assert found.beside == pytest.approx(WIDTH * LAYER, rel=0.1)


def test_support_does_not_count():
    bodies = [box((-2, -1, 0), (0, 11, 1)), box((0.2, -1, 0), (2, 11, 1))]
    joint = [(-0.2, 0, -0.2, 10, 2), (0.1, 0, 0.1, 10, 2)]
    assert contacts(lines(*joint), bodies, LAYER)
    one, other = lines(joint[0]), lines(joint[1], kind="Support material interface")
    both = gcode.Lines(
        *(np.concatenate(pair) for pair in zip(one[:-1], other[:-1], strict=True)),
        (*one.kinds, *other.kinds),
    )
    both = both._replace(kind=np.array([0, 1]))
    assert contacts(both, bodies, LAYER) == []


def test_lines_of_another_print_are_refused():
    with pytest.raises(ValueError, match="lie in none of the bodies"):
        contacts(lines((0, 0, 10, 0, 2)), [box((0, 5, 0), (10, 7, 1))], LAYER)


def test_it_can_be_stopped():
    stop = Progress(cancelled=lambda: True)
    with pytest.raises(Cancelled):
        contacts(lines((0, 0, 10, 0, 2)), [box((-1, -1, 0), (11, 1, 1))], LAYER, stop)


def test_a_body_comes_to_rest_on_its_faces():
    tilt = orientations.upright(np.array([0.36, 0.48, 0.8]))
    mesh = box((0, 0, 0), (10, 20, 30), 0.4)
    mesh = Mesh(mesh.vertices @ tilt.T, mesh.triangles)
    heights = []
    for down in orientations.candidates(mesh)[6:]:
        turned = mesh.vertices @ orientations.upright(down).T
        heights.append(np.ptp(turned[:, 2]))
    assert sorted(heights) == pytest.approx([10, 10, 20, 20, 30, 30], abs=0.01)
    best = orientations.best_guesses(mesh, 3, 60)
    assert len(best) == 3
    assert np.ptp(mesh.vertices @ best[0][2]) == pytest.approx(10, abs=0.01)


def program(folder, name, text):
    path = folder / name
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)
    return path


def test_where_the_slicer_is(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(prusaslicer, "_PLACES", ())
    monkeypatch.delenv(prusaslicer.VARIABLE, raising=False)
    with pytest.raises(NoSlicer, match="apt install prusa-slicer"):
        prusaslicer.find()
    program(tmp_path, "flatpak", "exit 1")
    with pytest.raises(NoSlicer):
        prusaslicer.find()
    program(tmp_path, "flatpak", "exit 0")
    assert prusaslicer.find()[-1] == "com.prusa3d.PrusaSlicer"
    own = program(tmp_path, "PrusaSlicer", "exit 0")
    assert prusaslicer.find() == [str(own)]
    monkeypatch.setenv(prusaslicer.VARIABLE, "nowhere/slicer")
    with pytest.raises(NoSlicer, match="PRUSASLICER is 'nowhere/slicer', which is no program"):
        prusaslicer.find()
    monkeypatch.setenv(prusaslicer.VARIABLE, str(own))
    assert prusaslicer.find() == [str(own)]


def test_a_slicer_that_refuses_is_quoted_and_one_that_is_not_wanted_any_more_ends(
    tmp_path, monkeypatch
):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.setenv(
        prusaslicer.VARIABLE, str(program(tmp_path, "no", "echo Too large.; exit 1"))
    )
    with pytest.raises(ValueError, match="it says 'Too large"):
        prusaslicer.slice_stl(lambda path: path.write_text("solid"), "")
    pid = tmp_path / "pid"
    slow = program(tmp_path, "slow", f"echo $$ > {pid}\nexec sleep 60")
    monkeypatch.setenv(prusaslicer.VARIABLE, str(slow))

    stop = Progress(cancelled=lambda: pid.is_file() and bool(pid.read_text().strip()))
    start = time.time()
    with pytest.raises(Cancelled):
        prusaslicer.slice_stl(lambda path: path.write_text("solid"), "", stop)
    assert time.time() - start < 20
    with pytest.raises(ProcessLookupError):
        os.kill(int(pid.read_text()), 0)
    assert {path.name for path in tmp_path.iterdir()} == {"no", "slow", "pid"}
