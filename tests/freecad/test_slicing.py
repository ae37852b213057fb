"""Real slices: hinges stay free, broken ones do not, and flat-folding is compared fairly."""

import shutil
from dataclasses import replace

import numpy as np
import pytest

from BistableWB import make, slicing
from BistableWB.checks import ERROR, NOTE, WARNING
from BistableWB.checks.printer import Printer
from BistableWB.designs import building, reading
from BistableWB.origami import unit as thin
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.hinges.presets import PRESETS
from BistableWB.origami.meshes import PlacedMesh
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.programs import prusaslicer
from BistableWB.slicing import comparison, toolpaths
from BistableWB.slicing.comparison import Comparison, Sliced
from BistableWB.slicing.contact import Contact, contacts
from BistableWB.slicing.section import section
from BistableWB.solids.coupons import coupon_bodies
from BistableWB.solids.tessellation import placed_meshes
from BistableWB.solids.tube import tube_bodies

LIMIT = 0.15  # mm² of contact in a joint
PRINTER = Printer(layer_height=0.2, nozzle_diameter=0.4)
needs_slicer = pytest.mark.skipif(not shutil.which("prusa-slicer"), reason="needs prusa-slicer")


def unit_bodies(parameters):
    """Meshes of one unit of 60 mm."""
    plane = thin.plane_unit(np.radians([45.0]), np.array([0.42]), 60.0, 24.0)
    thick = ThickUnit(plane, parameters.face_thickness, parameters.gap_between_planes)
    return placed_meshes(tube_bodies(thick.compensated(), parameters))


def dihedral(parameters):
    """Meshes of the smallest print with a hinge."""
    return placed_meshes(coupon_bodies("Dihedral", parameters, 24.0, 16.0))


@pytest.mark.slow
@needs_slicer
@pytest.mark.parametrize("preset", [None, "Recommended"])
def test_no_joint_of_a_unit_with_the_recommended_hinges_fuses(preset):
    parameters = HingeParameters()
    if preset:
        parameters = PRESETS[preset].parameters(parameters)
    bodies = unit_bodies(parameters)
    meshes = [body.placed for body in bodies]
    lines, estimate = toolpaths.sliced(meshes, PRINTER)
    assert estimate.volumes[0] == pytest.approx(sum(m.volume for m in meshes), rel=0.1)
    found = contacts(lines, meshes, PRINTER.layer_height)
    assert max((contact.area for contact in found), default=0) <= LIMIT
    (note,) = toolpaths.contact_findings(found, bodies, parameters)
    assert note.severity == NOTE
    assert "15 bodies" in str(note.message)


@pytest.mark.slow
@needs_slicer
@pytest.mark.parametrize(
    ("change", "smallest"),
    [
        ({"gap_length": 0.12}, 1.0),  # below the layer height
        ({"gap_length": 0.2}, LIMIT),
        ({"gap_between_planes": 0.08, "face_thickness": 1.12}, 1.0),
    ],
)
def test_a_hinge_made_for_finer_layers_fuses(change, smallest):
    parameters = HingeParameters(segmentations=3, layer_height=0.08, **change)
    bodies = dihedral(parameters)
    found = toolpaths.check_toolpaths(bodies, parameters, PRINTER)
    assert found[0].number > smallest
    assert found[0].severity == (ERROR if found[0].number >= 1 else WARNING)
    assert set(found[0].bodies) <= {body.name for body in bodies}
    assert "Gap" in str(found[0].cure)
    low, high = np.array([body.placed.bounds for body in bodies]).transpose(1, 0, 2)
    assert (low.min(0) <= found[0].points[0]).all()
    assert (found[0].points[0] <= high.max(0)).all()


@pytest.mark.slow
@needs_slicer
def test_bodies_that_were_pushed_together_fuse_and_good_ones_do_not():
    parameters = HingeParameters(segmentations=3)
    one, other = dihedral(parameters)
    (note,) = toolpaths.check_toolpaths([one, other], parameters, PRINTER)
    assert (note.severity, note.number) == (NOTE, 0)
    pushed = np.eye(4)
    pushed[:2, 3] = 0.4, 0.4
    other = other._replace(place=pushed @ other.place)
    (found,) = toolpaths.check_toolpaths([one, other], parameters, PRINTER)
    assert found.severity == ERROR
    assert found.bodies == (one.name, other.name)


@pytest.mark.slow
@needs_slicer
def test_a_unit_flat_folded_against_deployed(doc, valid):
    unit = make.make_bistable_unit(doc, theta=45, ratio=0.42, edge_length=45)
    hinges = make.make_hinge_set(doc, unit, process="FDM, soluble")
    hinges.Segmentations = 3
    valid(doc)
    told = []
    found = slicing.compare(hinges, told.append, tries=1)
    flat, (best,) = found.flat, found.deployed
    volume = sum(solid.Volume for solid in hinges.Shape.Solids)
    for one in found.prints:
        assert one.model == pytest.approx(volume, rel=0.12)
        assert one.support > 0
        assert one.changes > 0
        assert one.fits
    # The extents are those of what is laid, with the support around it.
    assert flat.size[2] == pytest.approx(hinges.PrintSize.z, abs=0.2)
    assert flat.layers == 33
    assert found.other.size[2] == pytest.approx(hinges.PrintSize.x, abs=0.5)
    assert best.layers >= round(best.size[2] / 0.2)  # support has layers of its own in between
    assert flat.seconds < best.seconds  # what the slicer says, here
    assert [finding.severity for finding in found.findings] == [NOTE]
    assert list(dict.fromkeys(told)) == [
        "slicing flat-folded",
        "toolpaths of bodies that move",
        "slicing flat-folded, on edge",
        "slicing deployed, way 1",
    ]


def test_contacts_become_two_findings_at_most_and_strips_may_touch():
    names = ["unit01_contact_left", "unit01_border_left", "unit01_link_B", "flexure_leg_A_left"]
    bodies = [PlacedMesh(name, None, None, 0, ((0, name[7:]),)) for name in names]
    bodies[3] = bodies[3]._replace(kind="flexure")
    found = [
        Contact((0, 3), 40.0, 40.0, (0, 0, 0)),
        Contact((0, 1), 1.0, 0.5, (1, 2, 3)),
        Contact((0, 2), 0.3, 0.1, (4, 5, 6)),
        Contact((1, 2), 0.1, 0.1, (7, 8, 9)),
        Contact((1, 3), 0.0, 0.1, (0, 0, 0)),
    ]
    welded, stiff = toolpaths.contact_findings(found, bodies, HingeParameters())
    assert (welded.severity, welded.number, welded.bodies) == (ERROR, 1.5, (names[0], names[1]))
    assert "make GapLength larger" in str(welded.cure)  # they share a hinge
    assert (stiff.severity, stiff.number) == (WARNING, 0.4)
    assert "(and 1 other pair less)" in str(stiff.message)
    assert stiff.points == ((4, 5, 6), (7, 8, 9))
    (note,) = toolpaths.contact_findings(found[:1], bodies, HingeParameters())
    assert (note.severity, note.number) == (NOTE, 0)


def test_flexible_hinges_have_no_deployed_solids(doc, unit):
    hinges = make.make_hinge_set(doc, unit)
    hinges.HingeType = "Flexible"
    doc.recompute()
    with pytest.raises(ValueError, match="set HingeType to Rotational"):
        slicing.compare(hinges)


def canned():
    """A comparison in which flat-folding wins time and loses plastic."""
    flat = Sliced("flat-folded", 7200, 9000, 5000, (70, 60, 6.6), 33, 28, True)
    deployed = Sliced("deployed 1", 14400, 8000, 17000, (70, 60, 300.0), 1500, 900, False)
    return Comparison(flat, replace(flat, name="on edge"), (deployed,), [], [])


def test_the_comparison_says_what_is_better_and_what_is_worse():
    told = section(canned())
    text = str(told.text)
    assert "less time (2 h 00 min against 4 h 00 min), support" in text
    assert "and more model (9.0 cm³ against 8.0 cm³)." in text
    assert "area" not in text  # the same
    assert "Deployed it does not fit the printer." in text
    assert str(told.rows[2][0]) == "deployed 1 (too large)"
    assert {len(row) for row in told.rows} == {len(told.columns)}


@pytest.fixture
def unit_design(tmp_path):
    path = tmp_path / "unit.toml"
    text = "[unit]\ntheta = 45\nratio = 0.42\n[hinges]\nsegmentations = 3\n"
    text += 'preload = 0\npreload_rule = "Given"\n'
    path.write_text(f"{text}[output]\nformats = []\npictures = false\nslicer = true\n")
    return path


def test_a_report_has_the_comparison(unit_design, tmp_path, monkeypatch):
    monkeypatch.setattr(comparison, "compare", lambda *_, **__: canned())
    result = building.produce(reading.read(unit_design), tmp_path / "out")
    assert result.problems == []
    page = (tmp_path / "out/report.html").read_text()
    assert "<h3>Flat-folded or deployed</h3>" in page
    assert "<td>deployed 1 (too large)</td><td>4 h 00 min</td>" in page


def test_without_the_slicer_the_rest_is_made(unit_design, tmp_path, monkeypatch):
    monkeypatch.setenv(prusaslicer.VARIABLE, "nowhere")
    result = building.produce(reading.read(unit_design), tmp_path / "out")
    assert list(map(str, result.problems)) == [
        "slicer: PRUSASLICER is 'nowhere', which is no program: set it to the path of PrusaSlicer."
    ]
    assert (tmp_path / "out/report.html").is_file()
    parameters = HingeParameters(segmentations=3)
    (found,) = toolpaths.check_toolpaths(dihedral(parameters), parameters, PRINTER)
    assert found.severity == WARNING
    assert "is no program" in str(found.message)


def test_only_a_print_that_opens_is_sliced(tmp_path):
    path = tmp_path / "coupon.toml"
    path.write_text("[coupon]\n[output]\nslicer = true\n")
    with pytest.raises(reading.DesignError, match=r"add a table \[hinges\]"):
        reading.read(path)
