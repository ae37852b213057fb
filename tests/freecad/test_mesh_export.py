"""STL and 3MF of hinged prints: what other programs read in them is what we built."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree
import zipfile

import MeshPart
import numpy as np
import Part
import pytest
from FreeCAD import Vector

from BistableWB import make
from BistableWB.checks import NOTE, soundness
from BistableWB.exporters import export, stl, threemf
from BistableWB.exporters.bodies import Body
from BistableWB.origami import unit
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.meshes import Mesh, component_labels, unpaired_edges
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.programs import openscad
from BistableWB.solids.tessellation import VIEW, Tessellator, mesh_of, placed_meshes, shared
from BistableWB.solids.tube import tube_bodies

PARAMETERS = HingeParameters(segmentations=3)
NAMESPACE = {"m": "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"}


@pytest.fixture(scope="module")
def bodies():
    two = unit.plane_unit(np.radians([45, 50]), np.array([0.42, 0.47]), 60.0, 24.0)
    thick = ThickUnit(two, PARAMETERS.face_thickness, PARAMETERS.gap_between_planes)
    return tube_bodies(thick.compensated(), PARAMETERS)


def read_stl(path):
    """One mesh; corners with the same numbers are one vertex."""
    content = path.read_bytes()
    count = int(np.frombuffer(content[80:84], "<u4")[0])
    assert len(content) == 84 + 50 * count
    records = np.frombuffer(content[84:], stl._RECORD)
    corners = records["corners"].reshape(-1, 3)
    vertices, numbers = np.unique(corners, axis=0, return_inverse=True)
    return Mesh(vertices.astype(float), numbers.reshape(-1, 3)), records["normal"]


def read_model(path):
    with zipfile.ZipFile(path) as package:
        assert package.testzip() is None
        return ElementTree.fromstring(package.read("3D/3dmodel.model"))


def test_meshes_are_closed_and_have_the_volume_of_the_solids(bodies):
    for body, mesh in zip(bodies, placed_meshes(bodies), strict=True):
        placed = mesh.placed
        assert len(unpaired_edges(placed.triangles)) == 0
        assert soundness.check_volume(body.name, placed, body.shape.Volume) == []
        box = body.shape.BoundBox
        assert placed.bounds[1] - placed.bounds[0] == pytest.approx(
            [box.XLength, box.YLength, box.ZLength], abs=0.1
        )


def test_copies_are_meshed_once_and_lie_where_their_solids_are():
    cut = Part.makeBox(5, 4, 3).cut(Part.makeCylinder(1, 9, Vector(1.5, 1.5, -1)))
    cut = cut.fuse(Part.makeCone(0.8, 0.3, 1, Vector(4, 3, 3)))
    copies = [
        cut,
        cut.translated(Vector(9, 0, 0)),
        cut.rotated(Vector(1, 2, 3), Vector(1, 1, 0), 30),
        cut.mirror(Vector(0, 0, 0), Vector(0, 0, 1)),
        cut.mirror(Vector(0, 2, 0), Vector(0, 1, 0)).translated(Vector(1, 2, 3)),
    ]
    tessellator = Tessellator()
    meshes = [tessellator.mesh(shape) for shape in copies]
    assert len({id(tessellator.original(shape)[0]) for shape in copies}) == 1
    for shape, mesh in zip(copies, meshes, strict=True):
        assert mesh.volume == pytest.approx(shape.Volume, rel=0.01)
        for point in mesh.vertices[:: max(1, len(mesh.vertices) // 20)]:
            distance = Part.Vertex(*point.tolist()).distToShape(shape)[0]
            assert distance < 1e-3


def test_different_solids_with_the_same_corners_are_not_copies():
    tessellator = Tessellator()
    thin, thick = Part.makeTorus(5, 1), Part.makeTorus(4, 2)
    for shape in (thin, thick, Part.makeSphere(3)):
        assert tessellator.mesh(shape).volume == pytest.approx(shape.Volume, rel=0.05)


def test_cones_are_strips_of_triangles():
    shape = Part.makeCone(2, 0.5, 1.5)
    mesh = mesh_of(shape)
    assert len(unpaired_edges(mesh.triangles)) == 0
    kernel = MeshPart.meshFromShape(Shape=shape, LinearDeflection=0.05, AngularDeflection=0.3)
    assert len(mesh.triangles) < 0.75 * kernel.CountFacets
    assert mesh.volume == pytest.approx(shape.Volume, rel=0.02)


def test_flats_lie_within_a_hundredth_of_round_faces_with_few_triangles(bodies):
    body = next(b for b in bodies if "secondary" in b.name)
    mesh = mesh_of(body.shape)
    kernel = mesh_of(body.shape.copy(), 0.01, 0.3)
    assert len(mesh.triangles) < 0.9 * len(kernel.triangles)
    sides = mesh.corners[:, [0, 1, 2]], mesh.corners[:, [1, 2, 0]]
    middles = np.unique(np.round(np.mean(sides, 0).reshape(-1, 3), 6), axis=0)
    shell = body.shape.Shells[0]
    off = [shell.distToShape(Part.Vertex(*p))[0] for p in middles[:: len(middles) // 200].tolist()]
    assert max(off) < 0.0101
    assert max(off) > 0.002  # the measure sees the flats


def test_triangles_know_the_face_they_lie_on(bodies):
    shape = next(b for b in bodies if "link" in b.name).shape
    found, matrix = shared(*VIEW).meshed(shape)
    corners, faces = found.mesh.moved(matrix).corners, shape.Faces
    assert set(found.faces) == set(range(len(faces)))
    assert {k for k, f in enumerate(faces) if isinstance(f.Surface, Part.Cone)} == set(found.cones)
    for row in range(0, len(corners), 23):
        vertex = Part.Vertex(*corners[row].mean(0).tolist())
        assert faces[found.faces[row]].distToShape(vertex)[0] < 0.3


def test_checks_and_files_share_one_mesh_a_body(bodies):
    first = placed_meshes(bodies)
    moved = Part.Shape(bodies[3].shape)
    moved.translate(Vector(1, 2, 3))
    mesh, matrix = shared().original(moved)
    assert mesh is first[3].mesh
    assert matrix == pytest.approx(first[3].place + _shift(1, 2, 3), abs=1e-9)
    assert all(a.mesh is b.mesh for a, b in zip(first, placed_meshes(bodies), strict=True))


def _shift(*by):
    matrix = np.zeros((4, 4))
    matrix[:3, 3] = by
    return matrix


def test_the_memory_of_meshes_is_limited(monkeypatch):
    monkeypatch.setattr("BistableWB.solids.tessellation._REMEMBERED", 3)
    tessellator = Tessellator()
    for k in range(8):
        assert tessellator.mesh(Part.makeBox(1, 1, 1 + k)).volume == pytest.approx(1 + k)
        assert len(tessellator._known) <= 3


def test_solids_that_touch_stay_apart():
    two = Part.makeCompound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, Vector(1, 0, 0))])
    mesh = mesh_of(two)
    assert len(unpaired_edges(mesh.triangles)) == 0
    assert component_labels(mesh.triangles, len(mesh.vertices)).max() == 1


def test_stl_has_every_body_closed(bodies, tmp_path):
    stl.write(bodies, tmp_path / "a.stl")
    mesh, normals = read_stl(tmp_path / "a.stl")
    assert len(unpaired_edges(mesh.triangles)) == 0
    assert component_labels(mesh.triangles, len(mesh.vertices)).max() + 1 == len(bodies)
    assert mesh.volume == pytest.approx(sum(body.shape.Volume for body in bodies), rel=0.005)
    assert np.linalg.norm(normals, axis=1) == pytest.approx(1, abs=1e-5)
    sides = mesh.corners[:, 1:] - mesh.corners[:, :1]
    across = np.cross(sides[:, 0], sides[:, 1])
    assert ((across * normals).sum(1) >= 0).all()


@pytest.mark.parametrize("suffix", ["stl", "3mf"])
def test_the_same_bodies_give_the_same_bytes(bodies, tmp_path, suffix):
    write = {"stl": stl.write, "3mf": threemf.write}[suffix]
    for name in ("a", "b"):
        (tmp_path / name).mkdir()
        write(bodies[:5], tmp_path / name / f"p.{suffix}")
    assert (tmp_path / f"a/p.{suffix}").read_bytes() == (tmp_path / f"b/p.{suffix}").read_bytes()


def test_3mf_has_one_named_object_a_body_in_one_assembly(bodies, tmp_path):
    path = tmp_path / "tube & co.3mf"
    threemf.write(bodies, path, assembly=True)
    model = read_model(path)
    assert model.get("unit") == "millimeter"
    objects = {o.get("id"): o for o in model.findall(".//m:object", NAMESPACE)}
    item = model.find("m:build/m:item", NAMESPACE).get("objectid")
    assert objects[item].get("name") == "tube & co"
    parts = [c.get("objectid") for c in objects[item].iter(f"{{{NAMESPACE['m']}}}component")]
    assert [objects[k].get("name") for k in parts] == [body.name for body in bodies]
    kinds = [base.get("name") for base in model.findall(".//m:base", NAMESPACE)]
    for body, number in zip(bodies, parts, strict=True):
        look = objects[number]
        component = look.find(".//m:component", NAMESPACE)
        if component is not None:
            look = objects[component.get("objectid")]
        assert kinds[int(look.get("pindex"))] == body.kind


def test_3mf_shares_the_triangles_of_bodies_that_are_moved_copies(tmp_path):
    shape = Part.makeBox(1, 2, 3).cut(Part.makeBox(0.5, 1, 1))
    copies = [Body(f"body{k}", shape.translated(Vector(4 * k, 0, 0)), (), None) for k in range(5)]
    mirrored = Body("mirrored", shape.mirror(Vector(-3, 0, 0), Vector(1, 0, 0)), (), None)
    threemf.write([*copies, mirrored], tmp_path / "a.3mf", assembly=True)
    model = read_model(tmp_path / "a.3mf")
    assert len(model.findall(".//m:mesh", NAMESPACE)) == 2
    threemf.write(copies[:1], tmp_path / "b.3mf", assembly=True)
    assert len(read_model(tmp_path / "b.3mf").findall(".//m:mesh", NAMESPACE)) == 1


def test_a_surface_is_no_3mf_and_the_message_says_so(doc, tmp_path):
    doc_unit = make.make_bistable_unit(doc, theta=45, edge_length=60)
    doc.recompute()
    with pytest.raises(ValueError, match=r"not a closed solid.*STL"):
        export(doc_unit, tmp_path / "a.3mf")
    assert list(tmp_path.iterdir()) == []
    export(doc_unit, tmp_path / "a.stl")
    assert len(read_stl(tmp_path / "a.stl")[0].triangles) == 16


def test_through_the_dispatcher_with_options(doc, tmp_path):
    box = doc.addObject("Part::Cylinder", "Cylinder")
    doc.recompute()
    sizes = []
    for deflection in (0.5, 0.1):
        export(box, tmp_path / "a.stl", angular_deflection=deflection, linear_deflection=1.0)
        sizes.append(len(read_stl(tmp_path / "a.stl")[0].triangles))
    assert sizes[1] > 2 * sizes[0]
    export(box, tmp_path / "a.3mf", assembly=True)
    assert read_model(tmp_path / "a.3mf").find(".//m:object", NAMESPACE).get("name") == "Cylinder"


@pytest.mark.skipif(not openscad.installed(), reason="needs openscad")
def test_openscad_sees_as_many_closed_bodies_of_the_same_volume(bodies):
    (found,) = openscad.check([mesh.placed for mesh in placed_meshes(bodies[:15])])
    assert found.severity == NOTE, str(found)
    assert "15 closed bodies" in str(found.message)


@pytest.mark.skipif(not shutil.which("prusa-slicer"), reason="needs prusa-slicer")
@pytest.mark.parametrize("suffix", ["stl", "3mf"])
def test_prusa_slicer_says_manifold(bodies, tmp_path, suffix):
    path = tmp_path / f"a.{suffix}"
    {"stl": stl.write, "3mf": threemf.write}[suffix](bodies, path)
    run = subprocess.run(
        ["prusa-slicer", "--info", str(path)],
        capture_output=True,
        text=True,
        timeout=300,
        check=True,
    )
    assert set(re.findall(r"manifold = (\w+)", run.stdout)) == {"yes"}
    parts = sum(map(int, re.findall(r"number_of_parts =\s*(\d+)", run.stdout)))
    assert parts == len(bodies)
    volume = sum(map(float, re.findall(r"volume = ([\d.]+)", run.stdout)))
    assert volume == pytest.approx(sum(body.shape.Volume for body in bodies), rel=0.005)
