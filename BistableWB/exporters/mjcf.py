# SPDX-License-Identifier: LGPL-2.1-or-later
"""MJCF: the hinged print for MuJoCo, a simulator of rigid bodies in contact.

Every body with its mesh and mass, joined by hinges along a tree from the first block; each further
hinge closes a loop. Loops are closed by springs at both ends of the hinge's axis ("equality"), or
by slack of the hinge's clearance ("clearance"): then it is rigid bodies with play, as printed.
Keys "flat" and "deployed" are the two stable states, three more are on the way; hinges turn as far
as on the way and little further (there panels meet); every unit has servos on its leg at B.
Metres, kilograms; the frame of the print.
"""

import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import colours
from ..origami import rigid
from ..origami.errors import Refusal
from ..origami.meshes import PlacedMesh
from ..origami.thick import print_stack
from ..origami.units.creases import CREASES
from ..solids.tessellation import VIEW, placed_meshes

if TYPE_CHECKING:
    import FreeCAD as App

    from .bodies import Body

PLA = 1240.0  # kg/m³
_M = 0.001  # a millimetre in metres
_CLOSURES = "equality", "clearance"
_KEYS = {"flat": 0.0, "ajar": 0.25, "half": 0.5, "wide": 0.75, "deployed": 1.0}  # openings
_SPARE = 0.1  # radians that a hinge may turn further than on the way: panels meet there


def write(
    bodies: "Sequence[Body]",
    path: Path,
    closure: str = "equality",
    density: float = PLA,
    stiffness: float = 3e3,
    fixed: bool = True,
) -> None:
    """Write the HingeSet that ``bodies`` come from.

    ``closure``: "equality" or "clearance"; ``density``: kg/m³; ``stiffness``: of the springs that
    close loops, N/m; ``fixed``: hold the first block, else all of it is free to move.
    """
    sources = list({body.source.Name: body.source for body in bodies}.values())
    if len(sources) > 1 or getattr(sources[0].Proxy, "Type", "") != "Bistable::HingeSet":
        raise Refusal("MJCF is the mechanism of one print", cure="choose one HingeSet")
    if closure not in _CLOSURES:
        raise Refusal(
            "closure is {value!r}", cure="choose one of {known}",
            value=closure, known=", ".join(_CLOSURES),
        )  # fmt: skip
    mechanism = mechanism_of(sources[0])
    document = _Document(mechanism, path.stem, density, stiffness, closure, fixed).text()
    path.write_text(document, encoding="utf-8")


class Hinge(NamedTuple):
    """A hinge: its name, the two bodies (indices), its axis (2, 3) in the flat print, mm."""

    name: str
    bodies: tuple[int, int]
    axis: NDArray


class Mechanism(NamedTuple):
    """A print that moves: bodies in the print frame, hinges, play (mm), motions by opening.

    ``states``: {name: motions (bodies, 4, 4) from the flat print, the first body held}.
    """

    bodies: list[PlacedMesh]
    hinges: list[Hinge]
    play: float
    states: dict[str, NDArray]


def mechanism_of(obj: "App.DocumentObject") -> Mechanism:
    """`Mechanism` of a HingeSet object, without preload; a `Refusal` for hinges that bend."""
    model = obj.Proxy.model(obj)
    if any(not body.members and body.seat is None for body in model.bodies):
        raise Refusal(
            "{label} has flexible hinges, and MJCF has hinges that turn",
            cure="set {HingeType} to Rotational",
            parameter="HingeType",
            label=obj.Label,
        )
    thick, incoming = model.unloaded.thick, model.tube.tube.incoming_left
    places = print_stack.frames(thick, incoming)
    places[:, 2, 3] += model.tube.lift
    axes = np.asarray(thick.axes).reshape(-1, *np.shape(thick.axes)[-3:])
    number = {member: k for k, body in enumerate(model.bodies) for member in body.members}
    hinges = [
        Hinge(
            f"unit{unit + 1:02d}_{crease.name}",
            (number[unit, crease.bodies[0]], number[unit, crease.bodies[1]]),
            rigid.apply(places[unit], axes[unit, k]),
        )
        for unit in range(len(places))
        for k, crease in enumerate(CREASES)
    ]
    flat = rigid.inverse(np.array(model.unloaded_motions(0)))
    states = {}
    for name, opening in _KEYS.items():
        motions = flat @ np.array(model.unloaded_motions(opening))
        states[name] = rigid.inverse(motions[0]) @ motions
    play = float(model.parameters.play)
    return Mechanism(placed_meshes(model.bodies, *VIEW), hinges, play, states)


def tree(mechanism: Mechanism) -> dict[int, tuple[int, Hinge]]:
    """Parent and hinge of every body but the first, which is nobody's child: breadth first."""
    beside: dict[int, list] = {}
    for hinge in mechanism.hinges:
        for a, b in (hinge.bodies, hinge.bodies[::-1]):
            beside.setdefault(a, []).append((b, hinge))
    found: dict[int, tuple[int, Hinge]] = {}
    order = [0]
    for body in order:
        for other, hinge in beside[body]:
            if other != 0 and other not in found:
                found[other] = body, hinge
                order.append(other)
    return found


def angles(mechanism: Mechanism, child: int, parent: int | None, hinge: Hinge) -> dict[str, float]:
    """Angle (radians) by which a hinge of the tree is turned in each of the states."""
    found = {}
    for name, motions in mechanism.states.items():
        between = rigid.inverse(motions[parent]) @ motions[child]
        found[name] = float(rigid.twist_angle(between[:3, :3], _direction(hinge)))
    return found


def _direction(hinge: Hinge) -> NDArray:
    along = hinge.axis[1] - hinge.axis[0]
    return along / np.linalg.norm(along)


class _Document:
    """The text, element by element."""

    def __init__(
        self,
        mechanism: Mechanism,
        title: str,
        density: float,
        stiffness: float,
        closure: str,
        fixed: bool,
    ) -> None:
        self.mechanism, self.closure, self.fixed = mechanism, closure, fixed
        self.tree = tree(mechanism)
        self.of_tree = {hinge.name for _, hinge in self.tree.values()}
        self.root = root = ET.Element("mujoco", model=title)
        ET.SubElement(root, "compiler", angle="radian")
        option = ET.SubElement(root, "option", timestep="0.0001", integrator="implicitfast")
        ET.SubElement(option, "flag", contact="disable")
        default = ET.SubElement(root, "default")
        ET.SubElement(default, "geom", type="mesh", density=f"{density:g}")
        ET.SubElement(default, "joint", type="hinge", damping="2e-4", armature="1e-6")
        rate = 2 * np.sqrt(stiffness * 1e-3)  # of a gram on that spring, critically damped
        self.spring = f"{-stiffness:g} {-rate:g}"
        self.asset = ET.SubElement(root, "asset")
        self.world = ET.SubElement(root, "worldbody")
        self.closing = ET.SubElement(root, "equality" if closure == "equality" else "tendon")
        self.actuator = ET.SubElement(root, "actuator")
        self.keys = ET.SubElement(root, "keyframe")
        self.turned: dict[Any, Any] = {}  # joint -> its angles by state

    def text(self) -> str:
        """All of it, as XML."""
        sites = self._sites()
        self._bodies(sites)
        for hinge in self.mechanism.hinges:
            if hinge.name not in self.of_tree:
                self._close(hinge)
        self._servos()
        self._states()
        ET.indent(self.root)
        return ET.tostring(self.root, encoding="unicode", xml_declaration=True) + "\n"

    def _sites(self) -> dict[int, list[tuple[str, NDArray]]]:
        """{body: [(name, point)]}: both ends of every hinge that closes a loop, on its bodies."""
        found: dict[Any, Any] = {}
        for hinge in self.mechanism.hinges:
            if hinge.name not in self.of_tree:
                for side, body in zip("ab", hinge.bodies, strict=True):
                    ends = [(f"{hinge.name}_{k}{side}", p) for k, p in enumerate(hinge.axis)]
                    found.setdefault(body, []).extend(ends)
        return found

    def _bodies(self, sites: Mapping[int, Sequence[tuple[str, NDArray]]]) -> None:
        """Bodies, each inside the one that it hangs on; at rest all lie in the flat print."""
        made: dict[Any, Any] = {}
        for k in [0, *self.tree]:
            body = self.mechanism.bodies[k]
            parent, hinge = self.tree.get(k, (None, None))
            element = ET.SubElement(made[parent] if k else self.world, "body", name=body.name)
            made[k] = element
            if hinge is not None:
                way = 1 if hinge.bodies[0] == parent else -1
                joint = ET.SubElement(
                    element, "joint", name=hinge.name,
                    pos=_text(hinge.axis[0] * _M), axis=_text(way * _direction(hinge)),
                )  # fmt: skip
                turned = angles(self.mechanism, k, parent, hinge)
                self.turned[hinge.name] = {state: way * a for state, a in turned.items()}
                low, high = (end(self.turned[hinge.name].values()) for end in (min, max))
                joint.set("range", _text([low - _SPARE, high + _SPARE]))
            elif not self.fixed:
                ET.SubElement(element, "freejoint", name="base")
            self._mesh(element, body)
            for name, point in sites.get(k, []):
                ET.SubElement(element, "site", name=name, pos=_text(point * _M), size="0.0005")

    def _mesh(self, element: ET.Element, body: PlacedMesh) -> None:
        mesh = body.placed
        ET.SubElement(
            self.asset, "mesh", name=body.name, scale=f"{_M} {_M} {_M}",
            vertex=_text(mesh.vertices.ravel()), inertia="exact",
            face=" ".join(map(str, mesh.triangles.ravel().tolist())),
        )  # fmt: skip
        red, green, blue = colours.rgb(colours.of(body.kind))
        look = f"{red:.3f} {green:.3f} {blue:.3f} 1"
        ET.SubElement(element, "geom", name=body.name, mesh=body.name, rgba=look)

    def _close(self, hinge: Hinge) -> None:
        """Both ends of the axis stay together, by springs or as far as the clearance lets them."""
        for k in range(2):
            name, a, b = f"{hinge.name}_{k}", f"{hinge.name}_{k}a", f"{hinge.name}_{k}b"
            if self.closure == "equality":
                ET.SubElement(
                    self.closing, "connect", name=name, site1=a, site2=b, solref=self.spring,
                    solimp="0.95 0.99 0.0001",
                )  # fmt: skip
            else:
                play = f"0 {self.mechanism.play * _M:.9g}"
                slack = ET.SubElement(
                    self.closing, "spatial", name=name, limited="true", range=play,
                    solreflimit=self.spring,
                )  # fmt: skip
                ET.SubElement(slack, "site", site=a)
                ET.SubElement(slack, "site", site=b)

    def _servos(self) -> None:
        """A servo on both axes of every unit's leg at B: angles as in the keys."""
        for name in self.turned:
            if "leg_B" in name:
                ET.SubElement(
                    self.actuator, "position", name=f"open_{name}", joint=name, kp="2", kv="0.02"
                )

    def _states(self) -> None:
        base = [] if self.fixed else [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
        # in the order of the document, which is how MuJoCo counts joints
        joints = [joint.get("name") for joint in self.world.iter("joint")]
        for state in _KEYS:
            turned = [self.turned[name][state] for name in joints]
            ET.SubElement(self.keys, "key", name=state, qpos=_text([*base, *turned]))


def _text(numbers: ArrayLike) -> str:
    return " ".join(f"{x:.9g}" for x in np.asarray(numbers, float).tolist())
