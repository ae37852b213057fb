# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is in a file of ours, as any other program would read it: readers that know no writer.

Each gives an `Outline`: a box, and a volume where the format has one. `Refusal`, or what the
libraries raise (ValueError, KeyError …), where a file is not whole.
"""

import base64
import html.parser
import json
import struct
import zipfile
import zlib
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import numpy as np
from numpy.typing import NDArray

from ..origami.errors import Refusal


class Outline(NamedTuple):
    """``box`` (2, 3) mm, None where there is none; ``volume`` mm³, None of what is not solid.

    ``open_edges``: of its triangles, that lack a partner: 0 of closed bodies.
    """

    box: NDArray | None = None
    volume: float | None = None
    open_edges: int = 0


def outline_of(path: Path) -> Outline:
    """The `Outline` of a file by its suffix; `Unknown` where there is no reader for it."""
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        raise Unknown
    return reader(path)


class Unknown(Exception):
    """No reader for such files."""


def _of_triangles(corners: NDArray) -> Outline:
    """Triangles (n, 3, 3) of closed bodies."""
    a, b, c = np.moveaxis(corners - corners.reshape(-1, 3).mean(0), 1, 0)
    volume = float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)
    points = np.ascontiguousarray(corners.reshape(-1, 3))
    _, index = np.unique(points.view([("", points.dtype)] * 3).ravel(), return_inverse=True)
    triangles = index.reshape(-1, 3)
    ends = np.stack([triangles, np.roll(triangles, -1, axis=1)], -1).reshape(-1, 2)
    there = ends[:, 0] * len(points) + ends[:, 1]
    back = ends[:, 1] * len(points) + ends[:, 0]
    return Outline(_box(points), volume, int((~np.isin(there, back)).sum()))


def _box(points: NDArray) -> NDArray:
    if not np.isfinite(points).all() or not len(points):
        raise Refusal("it holds no finite points")
    return np.stack([points.min(0), points.max(0)])


def _stl(path: Path) -> Outline:
    content = path.read_bytes()
    (count,) = struct.unpack_from("<I", content, 80)
    if len(content) != 84 + 50 * count:
        there = (len(content) - 84) / 50
        raise Refusal("it says {count} triangles and holds {there:.6g}", count=count, there=there)
    facets = np.frombuffer(content, np.dtype([("f", "<f4", (4, 3)), ("a", "<u2")]), offset=84)
    return _of_triangles(facets["f"][:, 1:].astype(float))


def _threemf(path: Path) -> Outline:
    with zipfile.ZipFile(path) as packed:
        if packed.testzip():
            raise Refusal("its packing is broken")
        root = ElementTree.fromstring(packed.read("3D/3dmodel.model"))
    space = root.tag.partition("}")[0] + "}"
    meshes, composed = {}, {}
    for one in root.iter(f"{space}object"):
        mesh = one.find(f"{space}mesh")
        if mesh is not None:
            vertices = mesh.iter(f"{space}vertex")
            points = np.array([[v.attrib[k] for k in "xyz"] for v in vertices], float)
            triangles = mesh.iter(f"{space}triangle")
            rows = np.array([[t.attrib[f"v{k}"] for k in (1, 2, 3)] for t in triangles], int)
            meshes[one.get("id")] = points[rows]
        else:
            composed[one.get("id")] = [
                (c.get("objectid"), c.get("transform")) for c in one.iter(f"{space}component")
            ]
    parts = []
    for item in root.iter(f"{space}item"):
        moves = composed.get(item.get("objectid"), [(item.get("objectid"), None)])
        parts += [_moved(_moved(meshes[k], m), item.get("transform")) for k, m in moves]
    return _of_triangles(np.concatenate(parts))


def _moved(corners: NDArray, transform: str | None) -> NDArray:
    if transform is None:
        return corners
    matrix = np.array(transform.split(), float).reshape(4, 3)
    return corners @ matrix[:3] + matrix[3]


def _obj(path: Path) -> Outline:
    points = [
        line.split()[1:4] for line in path.read_text("utf-8").splitlines() if line.startswith("v ")
    ]
    return Outline(_box(np.array(points, float)))


def _fold(path: Path) -> Outline:
    content = json.loads(path.read_text("utf-8"))
    points = np.array(content["vertices_coords"], float)
    for face in content["faces_vertices"]:
        points[face]  # an index that leads nowhere raises
    return Outline(_box(points))


def _glb(path: Path) -> Outline:
    content = path.read_bytes()
    magic, version, length = struct.unpack_from("<4sII", content)
    size, kind = struct.unpack_from("<I4s", content, 12)
    if (magic, version, length, kind) != (b"glTF", 2, len(content), b"JSON"):
        raise Refusal("its head is not that of a whole GLB file")
    told = json.loads(content[20 : 20 + size])
    room = len(content) - (28 + size)
    for view in told["bufferViews"]:
        if view.get("byteOffset", 0) + view["byteLength"] > room:
            raise Refusal("its data end early")
    return Outline()


def _xml(path: Path) -> Outline:
    ElementTree.parse(path)
    return Outline()


def _scad(path: Path) -> Outline:
    text = path.read_text("utf-8")
    if any(text.count(a) != text.count(b) for a, b in ("()", "[]", "{}")):
        raise Refusal("its brackets do not match")
    return Outline()


def _png(path: Path) -> Outline:
    content = path.read_bytes()
    if content[:8] != b"\x89PNG\r\n\x1a\n":
        raise Refusal("it does not begin as a picture")
    at, data = 8, b""
    while at < len(content):
        (length,) = struct.unpack_from(">I", content, at)
        chunk = content[at + 4 : at + 8 + length]
        if zlib.crc32(chunk) != struct.unpack_from(">I", content, at + 8 + length)[0]:
            raise Refusal("a checksum is wrong")
        data += chunk[4:] if chunk[:4] == b"IDAT" else b""
        at += 12 + length
        if chunk[:4] == b"IEND":
            zlib.decompress(data)
            return Outline()
    raise Refusal("it ends early")


def _html(path: Path) -> Outline:
    text = path.read_text("utf-8")
    html.parser.HTMLParser().feed(text)
    if not text.rstrip().endswith("</html>"):
        raise Refusal("it ends early")
    for data in text.split("base64,")[1:]:
        end = next(k for k, c in enumerate(data) if c in "\"')")
        base64.b64decode(data[:end], validate=True)
    return Outline()


_READERS = {
    ".stl": _stl,
    ".3mf": _threemf,
    ".obj": _obj,
    ".fold": _fold,
    ".glb": _glb,
    ".xml": _xml,
    ".svg": _xml,
    ".scad": _scad,
    ".png": _png,
    ".html": _html,
}
