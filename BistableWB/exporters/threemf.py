# SPDX-License-Identifier: LGPL-2.1-or-later
"""3MF: one object with a named, coloured part for every body; millimetres.

PrusaSlicer reads names and extruders of the parts from a file of its own; any slicer sees one
object, which nothing pulls apart on the bed. An assembly has an object a body instead, of which
those of the same shape share its triangles; PrusaSlicer 2.5 without a window lays its bodies out
one by one. The same bodies give the same bytes.
"""

import zipfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple
from xml.sax.saxutils import quoteattr

import numpy as np
from numpy.typing import NDArray

from .. import __version__, colours
from ..origami.errors import Refusal
from ..origami.meshes import Mesh, joined, unpaired_edges
from .meshes import ANGULAR_DEFLECTION, LINEAR_DEFLECTION, Mesher

_OTHER = "other"  # what is none of our kinds of bodies
_LOOKS = {**colours.KINDS, _OTHER: colours.of("")}  # base materials
_CONTENT_TYPES = """<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
"""
_RELATIONS = """<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" \
Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
"""
_MATERIALS, _FIRST_OBJECT = 1, 2  # resource numbers
_SLICER_FILE = "Metadata/Slic3r_PE_model.config"
_OTHER_MATERIALS = "flexure", "support"  # kinds that are not printed in what panels are made of


class Part(NamedTuple):
    """A body to write: its `Mesh`, which others may share, and the matrix (4, 4) that places it."""

    name: str
    kind: str
    mesh: Mesh
    matrix: np.ndarray


def write(
    bodies: Sequence[Any],
    path: Path,
    linear_deflection: float = LINEAR_DEFLECTION,
    angular_deflection: float = ANGULAR_DEFLECTION,
    one_object: bool = True,
    assembly: bool = False,
) -> None:
    """Write ``bodies``. Curved faces become triangles within the deflections (mm, radians).

    ``assembly``: an object a body, components of one, instead of one object with parts; so does
    ``one_object=False``, which macros of 0.1.0 say.
    """
    tessellator = Mesher(linear_deflection, angular_deflection)
    parts = [Part(b.name, b.kind or _OTHER, *tessellator.original(b.shape)) for b in bodies]
    for name, _, mesh, _ in parts:
        if not len(mesh.triangles) or len(unpaired_edges(mesh.triangles)):
            raise Refusal(
                "{name} is not a closed solid, which 3MF needs: choose the hinged solids, or "
                "export to STL, OBJ or STEP.",
                name=name,
            )
    extruders = extruders_for([part.kind for part in parts])
    if assembly or one_object is False:
        write_parts(parts, path, title=path.stem)
    else:
        write_one(parts, extruders, path, title=path.stem)


def extruders_for(kinds: Sequence[str]) -> list[int]:
    """Number of the extruder, from 1, of bodies by kind: panels first, then other materials."""
    others = [kind for kind in _OTHER_MATERIALS if kind in kinds]
    return [2 + others.index(kind) if kind in others else 1 for kind in kinds]


def write_parts(parts: Sequence[Part], path: Path, title: str) -> None:
    """Write `Part` tuples as an assembly; a mesh may occur several times."""
    _pack(path, {"3D/3dmodel.model": _model(title, _assembly(parts, title))})


def write_one(parts: Sequence[Part], extruders: Sequence[int], path: Path, title: str) -> None:
    """Write parts as for `write_parts` as one object, each printed by its extruder."""
    named = [part.name for part in parts]
    meshes = [part.mesh.moved(part.matrix) for part in parts]
    counts = [len(mesh.triangles) for mesh in meshes]
    looks = np.repeat([list(_LOOKS).index(part.kind) for part in parts], counts)
    model = _model(title, _one_object(meshes, looks, title))
    slicer = _slicer_file(named, counts, extruders, title)
    _pack(path, {"3D/3dmodel.model": model, _SLICER_FILE: [slicer]})


def _pack(path: Path, files: Mapping[str, Any]) -> None:
    """Write a package of files {name: pieces of text}."""
    files = {"[Content_Types].xml": [_CONTENT_TYPES], "_rels/.rels": [_RELATIONS], **files}
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=6) as package:
        for name, text in files.items():
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            with package.open(entry, "w", force_zip64=True) as file:
                for piece in text:
                    file.write(piece.encode())


def _model(title: str, objects: Iterator[Any]) -> Iterator[str]:
    """The model file piece by piece, about ``objects``, its resources and what is built."""
    yield (
        '<?xml version="1.0" encoding="UTF-8"?>\n<model unit="millimeter" xml:lang="en-US" '
        'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">\n'
        f'<metadata name="Title">{_text(title)}</metadata>\n'
        f'<metadata name="Application">Bistable Workbench {__version__}</metadata>\n'
        f'<resources>\n<basematerials id="{_MATERIALS}">\n'
    )
    for kind, colour in _LOOKS.items():
        yield f'<base name="{kind}" displaycolor="{colour}FF"/>\n'
    yield "</basematerials>\n"
    yield from objects
    yield "</build>\n</model>\n"


def _one_object(meshes: Sequence[Mesh], looks: NDArray, title: str) -> Iterator[str]:
    """One mesh of all bodies; every triangle bears the look of its body."""
    look = f'type="model" pid="{_MATERIALS}" pindex="{looks[0]}"'
    yield f'<object id="{_FIRST_OBJECT}" name={quoteattr(title)} {look}>\n'
    yield from _mesh(joined(meshes), looks)
    yield f'</object>\n</resources>\n<build>\n<item objectid="{_FIRST_OBJECT}"/>\n'


def _slicer_file(
    named: Sequence[str], counts: Sequence[int], extruders: Sequence[int], title: str
) -> str:
    """What PrusaSlicer wants to know of the object: which triangles are which part."""
    lines = ['<?xml version="1.0" encoding="UTF-8"?>', "<config>"]
    lines.append(f' <object id="{_FIRST_OBJECT}" instances_count="1">')
    lines.append(f'  <metadata type="object" key="name" value={quoteattr(title)}/>')
    first = 0
    for name, count, extruder in zip(named, counts, extruders, strict=True):
        lines.append(f'  <volume firstid="{first}" lastid="{first + count - 1}">')
        known = {"name": name, "volume_type": "ModelPart", "extruder": str(extruder)}
        for key, value in known.items():
            lines.append(f'   <metadata type="volume" key="{key}" value={quoteattr(value)}/>')
        lines.append("  </volume>")
        first += count
    return "\n".join([*lines, " </object>", "</config>", ""])


def _assembly(parts: Sequence[Part], title: str) -> Iterator[str]:
    """One object a body, as components of one."""
    number, placed, shared = _FIRST_OBJECT, [], {}
    uses: dict[Any, Any] = {}
    for _, _, mesh, matrix in parts:
        uses.setdefault(id(mesh), []).append(_is_motion(matrix))
    for name, kind, mesh, matrix in parts:
        look = f'type="model" pid="{_MATERIALS}" pindex="{list(_LOOKS).index(kind)}"'
        named = f"name={quoteattr(name)}"
        if sum(uses[id(mesh)]) < 2 or not _is_motion(matrix):
            yield f'<object id="{number}" {named} {look}>\n'
            yield from _mesh(mesh.moved(matrix))
            yield "</object>\n"
        else:
            if (id(mesh), kind) not in shared:
                yield f'<object id="{number}" {look}>\n'
                yield from _mesh(mesh)
                yield "</object>\n"
                shared[id(mesh), kind] = number
                number += 1
            component = _component(shared[id(mesh), kind], matrix)
            yield f'<object id="{number}" {named} type="model">\n<components>\n{component}'
            yield "</components>\n</object>\n"
        placed.append(number)
        number += 1
    yield f'<object id="{number}" name={quoteattr(title)} type="model">\n<components>\n'
    yield "".join(f'<component objectid="{k}"/>\n' for k in placed)
    yield f'</components>\n</object>\n</resources>\n<build>\n<item objectid="{number}"/>\n'


def _mesh(mesh: Mesh, looks: NDArray | None = None) -> Iterator[str]:
    """Vertices and triangles; ``looks`` (t,): the material of each, if they differ."""
    vertices, triangles = mesh.vertices, mesh.triangles
    rounded = np.round(vertices, 5) + 0.0
    yield "<mesh>\n<vertices>\n"
    yield '<vertex x="%.5f" y="%.5f" z="%.5f"/>\n' * len(rounded) % tuple(rounded.ravel().tolist())
    yield "</vertices>\n<triangles>\n"
    line = '<triangle v1="%d" v2="%d" v3="%d"/>\n'
    if looks is not None:
        line = f'<triangle v1="%d" v2="%d" v3="%d" pid="{_MATERIALS}" p1="%d"/>\n'
        triangles = np.column_stack([triangles, looks])
    yield line * len(triangles) % tuple(triangles.ravel().tolist())
    yield "</triangles>\n</mesh>\n"


def _component(number: int, matrix: NDArray) -> str:
    rows = np.asarray(matrix)[:3].T.ravel().tolist()
    return f'<component objectid="{number}" transform="{" ".join(f"{x:.9g}" for x in rows)}"/>\n'


def _is_motion(matrix: NDArray) -> bool:
    """A mirror image is written out: not every program turns its triangles round."""
    return np.linalg.det(np.asarray(matrix)[:3, :3]) > 0


def _text(title: str) -> str:
    return quoteattr(title)[1:-1]
