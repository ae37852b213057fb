# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenSCAD: a readable program for the hinged print.

A HingeSet of print-in-place knuckles becomes plates, knuckles and links with the design's
parameters on top; ends with joints or plates, and any other solid, become polyhedra with names.
See `scad_library` for the modules that the file carries. Millimetres, degrees.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import __version__
from ..colours import KINDS
from ..objects.base import global_placement
from ..origami.errors import Refusal
from ..origami.hinges import polygons
from ..origami.hinges.kinds import HINGE_KINDS
from ..origami.hinges.link_section import link_section
from ..origami.hinges.meshing import mesh_of
from ..origami.hinges.unit_layout import inward_of
from ..origami.thick import print_stack
from ..origami.units.creases import LAYER_HEIGHT_IN_PITCHES, layer_of
from ..solids.matrices import array_of
from ..solids.tessellation import shared
from ..solids.tube import BLOCK_INSET, in_print_plan, printed_layouts
from .scad_library import HEADER, HINGED, PLAIN

if TYPE_CHECKING:
    import FreeCAD as App


_AS_THEY_ARE = "joint", "foot"  # bodies that are more than the panel they are named after
_INTO_CORE = 0.5  # mm that tabs reach into their panel


def write(bodies: Sequence[Any], path: Path) -> None:
    """Write ``bodies``; ValueError for faces without a solid, such as those of a BistableUnit."""
    sources = list({body.source.Name: body.source for body in bodies}.values())
    text = HEADER.format(version=__version__, title=", ".join(obj.Label for obj in sources))
    if len(sources) == 1 and _has_knuckles(sources[0]):
        text += _Hinged(sources[0]).text()
    else:
        mesher = shared()
        parts = [_polyhedron(name, s, mesher) for body in bodies for name, s in _solids(body)]
        text += PLAIN + "\n".join(parts)
    path.write_text(text + "\n", encoding="utf-8")


def _has_knuckles(obj: "App.DocumentObject") -> Any:
    kind = getattr(getattr(obj, "Proxy", None), "Type", "")
    return kind == "Bistable::HingeSet" and HINGE_KINDS[obj.HingeType].knuckles


def _solids(body: Any) -> Any:
    """(name, solid) of all solids of a body."""
    solids = body.shape.Solids
    if not solids:
        raise Refusal(
            "{label} has faces but no solid, and OpenSCAD is for solids: choose a HingeSet or a "
            "HingeCoupon.",
            label=body.source.Label,
        )
    names = getattr(body.source, "BodyNames", [])
    if len(solids) == 1:
        names = [body.name]
    elif len(names) != len(solids):
        names = [f"{body.name}_{i + 1}" for i in range(len(solids))]
    return zip(names, solids, strict=True)


def _polyhedron(name: str, solid: Any, mesher: Any) -> Any:
    plain = name.replace("\\", "/").replace('"', "'")
    return f'part("{plain}") {_faces(mesher.mesh(solid))}'


def _faces(mesh: Any) -> str:
    """A mesh as a polyhedron."""
    points = ", ".join(_list(p, 6) for p in mesh.vertices)
    faces = ", ".join(f"[{c}, {b}, {a}]" for a, b, c in mesh.triangles.tolist())
    return f"polyhedron(convexity = 10,\n  points = [{points}],\n  faces = [{faces}]);"


class _Hinged:
    """The program of a HingeSet with knuckles: the layout of its hinges, as OpenSCAD's lists."""

    def __init__(self, obj: "App.DocumentObject") -> None:
        self.obj, self.model = obj, obj.Proxy.model(obj)
        self.parameters, tube = self.model.parameters, self.model.tube
        self.layouts = printed_layouts(tube.thick, self.parameters, tube.tube.incoming_left)
        self.places = print_stack.frames(tube.thick, tube.tube.incoming_left)
        # Units that lie turned over in the print (about their legs) are written as they lie.
        self.signs = [1 if place[2, 1] > 0 else -1 for place in self.places]

    def text(self) -> Any:
        """Parameters, modules and parts."""
        p, section = self.parameters, link_section(self.parameters)
        states = sorted({0.0, self.obj.Deployment, 1.0})
        head = HINGED.format(
            states=", ".join(f"{i} = {_state_name(s)}" for i, s in enumerate(states)),
            state=states.index(self.obj.Deployment),
            last=len(states) - 1,
            face_thickness=_number(p.face_thickness),
            gap_between_planes=_number(p.gap_between_planes),
            gap_length=_number(p.gap_length),
            cone_angle=_number(np.degrees(p.cone_angle)),
            nozzle=_number(p.nozzle_diameter),
            pivot=p.pivot.lower(),
            pin=_number(p.pin_radius),
            cut_back=_number(p.cut_back),
            web=_number(section.web),
            inner=_number(section.inner),
            outer=_number(section.outer),
            units=",\n  ".join(map(_unit_place, self.places, self.signs)),
            motions=self._motions(states),
        )
        parts, bodies = [], self.model.bodies
        for i, body in enumerate(bodies):
            if i == 0 or body.unit != bodies[i - 1].unit:
                parts.append(f"\n// ---- unit {body.unit + 1} ----")
            parts.append(self._part(i, body))
        return head + _colour_function() + "\n".join(parts)

    def _motions(self, states: Any) -> Any:
        """One row a body: its matrices in all states."""
        above = array_of(global_placement(self.obj))
        found = []
        for opening in states:
            turn = above
            if opening == 0:
                turn = above @ array_of(self.model.standing(self.obj.Orientation))
            found.append([turn @ motion for motion in self.model.motions(opening)])
        rows = []
        for matrices in zip(*found, strict=True):
            lists = (", ".join(_list(row, 9) for row in m[:3]) for m in matrices)
            rows.append("[" + ", ".join(f"[{text}]" for text in lists) + "]")
        return ",\n  ".join(rows)

    def _part(self, number: int, body: Any) -> Any:
        members, kind = body.members, body.kind
        if kind in _AS_THEY_ARE:
            layer = 4 * body.unit
            mesh = mesh_of(body.boundary).mesh.moved(body.place)
            return f'part({number}, "{body.name}", "{kind}", {_number(layer)}) {_faces(mesh)}'
        k, name = members[0]
        layer = 4 * k + (0 if kind == "link" else self._height(k, name))
        start = f'part({number}, "{body.name}", "{kind}", {_number(layer)})'
        if kind == "block":
            plates = "\n".join(f"  {self._plate(*member)}" for member in members)
            return f"{start} block({members[1][0]}, {self._filler(members)}) {{\n{plates}\n}}"
        return f"{start} {self._link(k, name) if kind == 'link' else self._plate(k, name)}"

    def _height(self, k: Any, name: str) -> Any:
        """Height of a panel's layer above the middle of its unit, in pitches, upwards in print."""
        return self.signs[k] * LAYER_HEIGHT_IN_PITCHES[layer_of(name)]

    def _plate(self, k: Any, name: str) -> Any:
        plate = self.layouts[k].plates[name]
        knuckles = [
            self._knuckle(k, t.hinge, t.index, self._depth(k, t, plate), t.crest)
            for t in plate.tabs
        ]
        core = ", ".join(self._point(k, p) for p in plate.core)
        inner = ",\n    ".join(knuckles)
        ribs = ",\n    ".join(self._stud(k, stud) for stud in plate.studs)
        ribs = f", [\n    {ribs}]" if ribs else ""
        return (
            f"in_unit({k + 1}) "
            f"plate({_number(self._height(k, name))}, [{core}], [\n    {inner}]{ribs});"
        )

    def _stud(self, k: Any, stud: Any) -> str:
        corners = ", ".join(self._point(k, p) for p in stud.corners)
        return f"[[{corners}], {_number(stud.height)}]"

    def _depth(self, k: Any, tab: Any, plate: Any) -> Any:
        """From the axis into the core, positive to the left of the axis in OpenSCAD's plan."""
        side = polygons.dot(inward_of(tab.hinge, plate.core), 1j * tab.hinge.direction)
        return -self.signs[k] * np.sign(side) * (max(tab.depths) + _INTO_CORE)

    def _knuckle(self, k: Any, hinge: Any, index: Any, depth: Any, crest: tuple) -> Any:
        half = self.parameters.gap_length / 2
        start, end = hinge.segments[index]
        height = self.signs[k] * hinge.height / self.parameters.pitch
        values = (height, depth, index, len(hinge.segments), hinge.cone_height, *crest)
        ends = ", ".join(self._point(k, hinge.point(s)) for s in (start - half, end + half))
        return f"[{ends}, {', '.join(map(_number, values))}]"

    def _link(self, k: Any, name: str) -> Any:
        link = self.layouts[k].links[name]
        crests = [(), ()]
        if link.crest:  # on the barrels that are the upper ones in the print
            crests[link.crest[2] > 0] = link.crest[:2]
        hinges = list(zip(link.hinges, crests, strict=True))
        pairs = [
            "[" + ", ".join(self._knuckle(k, h, index, 0.0, crest) for h, crest in hinges) + "]"
            for index in range(1, len(link.hinges[0].segments), 2)
        ]
        inner = ",\n    ".join(pairs)
        return f"in_unit({k + 1}) link({self._point(k, link.outward, 6)}, [\n    {inner}]);"

    def _point(self, k: Any, z: complex, digits: int = 4) -> Any:
        """A plan point x + i z of unit k as it lies in the print, seen from above."""
        return _list((self.signs[k] * z.real, -z.imag), digits)

    def _filler(self, members: Any) -> Any:
        cores = [
            in_print_plan(self.layouts[k].plates[name].core, self.places[k]) for k, name in members
        ]
        corners = polygons.intersection(cores[0], cores[1], BLOCK_INSET)
        return "[" + ", ".join(_list((p.real, p.imag)) for p in corners) + "]"


def _state_name(opening: float) -> Any:
    return {0.0: "flat-folded print", 1.0: "deployed"}.get(opening, f"deployment {opening:.4g}")


def _unit_place(place: Any, sign: Any) -> Any:
    """[x, y, angle] of a unit in the print."""
    angle = np.degrees(np.arctan2(sign * place[1, 0], sign * place[0, 0]))
    return _list((*place[:2, 3], angle), 6)


def _colour_function() -> Any:
    first = " :\n  ".join(f'kind == "{k}" ? "{c}"' for k, c in KINDS.items())
    return f'function colour(kind) = {first} : "grey";\n'


def _list(values: Any, digits: int = 4) -> Any:
    return "[" + ", ".join(_number(v, digits) for v in values) + "]"


def _number(value: Any, digits: int = 4) -> Any:
    text = f"{float(value):.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
