# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wavefront OBJ: one ``o`` a body, one ``g`` a named face; straight panels stay polygons.

Millimetres, z up. Corners that coincide within a body become one vertex, so that neighbouring
panels share their edges.
"""

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .. import __version__
from ..origami.hinges.bodies import Drawn
from .meshes import Mesher

if TYPE_CHECKING:
    import Part

    from .bodies import Body

_DIGITS = 6  # of a millimetre; also how near two corners are one vertex


def write(
    bodies: "Sequence[Body]",
    path: Path,
    linear_deflection: float = 0.05,
    angular_deflection: float = 0.3,
) -> None:
    """Write ``bodies``. Curved faces become triangles within the deflections (mm, radians)."""
    lines = [f"# Bistable Workbench {__version__}; millimetres"]
    first = 1
    for body in bodies:
        vertices: Any
        vertices, groups = {}, []
        for name, polygons in _polygons(body, linear_deflection, angular_deflection):
            groups.append(f"g {name}")
            for corners in polygons:
                indices = [vertices.setdefault(_rounded(p), len(vertices)) for p in corners]
                groups.append("f " + " ".join(str(first + i) for i in indices))
        lines.append(f"o {_plain(body.name)}")
        lines += ["v {:.{d}f} {:.{d}f} {:.{d}f}".format(*v, d=_DIGITS) for v in vertices]
        lines += groups
        first += len(vertices)
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def _polygons(
    body: "Body", linear: float, angular: float
) -> Iterator[tuple[str, list[list[tuple[Any, ...]]]]]:
    """(group name, polygons) of a body: its faces' own corners where all are straight."""
    faces = () if isinstance(body.shape, Drawn) else body.shape.Faces
    if faces and all(_is_straight(face) for face in faces):
        names = body.face_names or [f"{_plain(body.name)}_{k + 1}" for k in range(len(faces))]
        for name, face in zip(names, faces, strict=True):
            yield name, [_corners(face)]
        return
    yield _plain(body.name), Mesher(linear, angular).mesh(body.shape).corners.tolist()


def _is_straight(face: "Part.Shape") -> bool:
    """A face with one wire of straight edges and three or four corners."""
    if len(face.Wires) != 1 or len(face.Edges) > 4:
        return False
    return all(_is_chord(edge) for edge in face.Edges)


def _is_chord(edge: "Part.Shape") -> bool:
    """As long as the way between its ends: true of degenerate edges too, so these are refused."""
    ends = [v.Point for v in edge.Vertexes]
    straight = len(ends) == 2 and ends[0].distanceToPoint(ends[1])
    return straight > 0 and abs(edge.Length - straight) < 1e-9 * (1 + straight)


def _corners(face: "Part.Shape") -> list[tuple[float, ...]]:
    """Corners of a face in the order that its normal sees anticlockwise."""
    corners = [tuple(v.Point) for v in face.OuterWire.OrderedVertexes]
    return corners[::-1] if face.Orientation == "Reversed" else corners


def _rounded(point: Sequence[float]) -> tuple[float, ...]:
    return tuple(round(x, _DIGITS) + 0.0 for x in point)


def _plain(name: str) -> str:
    """A name without blanks, as OBJ readers want it."""
    return re.sub(r"\s+", "_", name.strip()) or "body"
