# SPDX-License-Identifier: LGPL-2.1-or-later
"""3MF: one named object a body, coloured by panel kind, together one part to print; millimetres.

The bodies are components of one assembly. Bodies of the same shape share its triangles. Prints of
several materials are one object instead, whose parts PrusaSlicer gives an extruder each: it reads
materials from a file of its own only (``hinges.md`` 7), and pulls assemblies apart when it is run
without a window. The same bodies give the same bytes.
"""

import zipfile
from xml.sax.saxutils import quoteattr

import numpy as np

from .. import __version__, colours
from ..solids.mesh import joined, unpaired_edges
from ..solids.tessellation import ANGULAR_DEFLECTION, LINEAR_DEFLECTION, shared

# Kinds of bodies, each a base material; a body is of the first kind that its name contains.
KINDS = {
    "support": colours.FAINT,
    "strip": colours.CURVE,
    "block": colours.PANELS["contact"],
    "link": colours.MUTED,
    **colours.PANELS,
    "other": colours.MUTED,
}
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
_OTHER_MATERIALS = "strip", "support"  # kinds that are not printed in what panels are made of


def write(
    bodies,
    path,
    linear_deflection=LINEAR_DEFLECTION,
    angular_deflection=ANGULAR_DEFLECTION,
    one_object=None,
):
    """Write ``bodies``. Curved faces become triangles within the deflections (mm, radians).

    ``one_object``: True for one object whose parts have names and extruders for PrusaSlicer; False
    for an assembly; None: what the materials need.
    """
    tessellator = shared(linear_deflection, angular_deflection)
    parts = [(body.name, *tessellator.original(body.shape)) for body in bodies]
    for name, mesh, _ in parts:
        if not len(mesh.triangles) or len(unpaired_edges(mesh.triangles)):
            raise ValueError(
                f"{name} is not a closed solid, which 3MF needs: choose the hinged solids, or "
                "export to STL, OBJ or STEP."
            )
    extruders = extruders_for([name for name, _, _ in parts])
    if max(extruders) > 1 if one_object is None else one_object:
        write_one(parts, extruders, path, title=path.stem)
    else:
        write_parts(parts, path, title=path.stem)


def extruders_for(names):
    """Number of the extruder, from 1, of each body: panels first, then each other material."""
    kinds = [kind_of(name) for name in names]
    others = [kind for kind in _OTHER_MATERIALS if kind in kinds]
    return [2 + others.index(kind) if kind in others else 1 for kind in kinds]


def write_parts(parts, path, title):
    """Write (name, `Mesh`, matrix (4, 4) that places it) tuples; a mesh may occur several times."""
    _pack(path, {"3D/3dmodel.model": _model(title, _assembly(parts, title))})


def write_one(parts, extruders, path, title):
    """Write parts as for `write_parts` as one object, each printed by its extruder."""
    named = [name for name, _, _ in parts]
    meshes = [mesh.moved(matrix) for _, mesh, matrix in parts]
    counts = [len(mesh.triangles) for mesh in meshes]
    model = _model(title, _one_object(named, meshes, counts, title))
    slicer = _slicer_file(named, counts, extruders, title)
    _pack(path, {"3D/3dmodel.model": model, _SLICER_FILE: [slicer]})


def _pack(path, files):
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


def kind_of(name):
    """Kind of a body, a key of `KINDS`, from its name."""
    return next((kind for kind in KINDS if kind in name.lower()), "other")


def _model(title, objects):
    """The model file piece by piece, about ``objects``, its resources and what is built."""
    yield (
        '<?xml version="1.0" encoding="UTF-8"?>\n<model unit="millimeter" xml:lang="en-US" '
        'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">\n'
        f'<metadata name="Title">{_text(title)}</metadata>\n'
        f'<metadata name="Application">Bistable Workbench {__version__}</metadata>\n'
        f'<resources>\n<basematerials id="{_MATERIALS}">\n'
    )
    for kind, colour in KINDS.items():
        yield f'<base name="{kind}" displaycolor="{colour}FF"/>\n'
    yield "</basematerials>\n"
    yield from objects
    yield "</build>\n</model>\n"


def _one_object(named, meshes, counts, title):
    """One mesh of all bodies; every triangle bears the look of its body."""
    looks = np.repeat([list(KINDS).index(kind_of(name)) for name in named], counts)
    look = f'type="model" pid="{_MATERIALS}" pindex="0"'
    yield f'<object id="{_FIRST_OBJECT}" name={quoteattr(title)} {look}>\n'
    yield from _mesh(joined(meshes), looks)
    yield f'</object>\n</resources>\n<build>\n<item objectid="{_FIRST_OBJECT}"/>\n'


def _slicer_file(named, counts, extruders, title):
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


def _assembly(parts, title):
    """One object a body, as components of one."""
    number, placed, shared = _FIRST_OBJECT, [], {}
    uses = {}
    for _, mesh, matrix in parts:
        uses.setdefault(id(mesh), []).append(_is_motion(matrix))
    for name, mesh, matrix in parts:
        kind = kind_of(name)
        look = f'type="model" pid="{_MATERIALS}" pindex="{list(KINDS).index(kind)}"'
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


def _mesh(mesh, looks=None):
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


def _component(number, matrix):
    rows = np.asarray(matrix)[:3].T.ravel().tolist()
    return f'<component objectid="{number}" transform="{" ".join(f"{x:.9g}" for x in rows)}"/>\n'


def _is_motion(matrix):
    """A mirror image is written out: not every program turns its triangles round."""
    return np.linalg.det(np.asarray(matrix)[:3, :3]) > 0


def _text(title):
    return quoteattr(title)[1:-1]
