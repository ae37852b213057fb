# SPDX-License-Identifier: LGPL-2.1-or-later
"""GLB (glTF 2.0, binary): the bodies in colour, with the deployment as an animation.

What browsers, presentations and phones show. Metres, y up, as glTF asks for; at rest the tube is
deployed, and the animation "deployment" goes from flat to deployed. Copies of a body share its
mesh. The same bodies give the same bytes.
"""

import json
import struct
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import __version__, colours
from ..solids.tessellation import VIEW
from .bodies import bodies_of
from .moving import MovingBody, moving_bodies

if TYPE_CHECKING:
    import FreeCAD as App

    from ..origami.meshes import Mesh
    from .bodies import Body

LINEAR, ANGULAR = 0.1, 1.6  # mm, radians: round faces as people look at them
_SECONDS = 4.0
_FLOAT, _SHORT, _INT = 5126, 5123, 5125
_VERTICES, _INDICES = 34962, 34963
_MILLIMETRE = 0.001
_UPRIGHT = [-(0.5**0.5), 0.0, 0.0, 0.5**0.5]  # z up → y up


def write(
    bodies: "Sequence[Body]",
    path: Path,
    linear_deflection: float = LINEAR,
    angular_deflection: float = ANGULAR,
    frames: int = 49,
) -> None:
    """Write ``bodies``; ``frames``: states of the animation between flat and deployed, both too."""
    openings = np.linspace(0, 1, max(int(frames), 2))
    moving = moving_bodies(bodies, openings, linear_deflection, angular_deflection)
    path.write_bytes(packed(moving, openings, path.stem))


def live_model(obj: "App.DocumentObject", title: str, frames: int = 25) -> bytes:
    """GLB of a recomputed document object of ours, light enough to lie in a page."""
    openings = np.linspace(0, 1, frames)
    return packed(moving_bodies(bodies_of([obj]), openings, *VIEW), openings, title)


def packed(moving: list[MovingBody], openings: NDArray, title: str) -> bytes:
    """The file: ``moving`` bodies whose motions belong to ``openings`` (k,)."""
    return _Gltf(title, openings).of(moving)


class _Gltf:
    """A glTF document that grows: lists of JSON objects and one buffer."""

    def __init__(self, title: str, openings: NDArray) -> None:
        self.title = title
        self.data = bytearray()
        self.views: list[Any] = []
        self.accessors: list[Any] = []
        self.meshes: list[Any] = []
        self.materials: list[Any] = []
        self.nodes: list[Any] = [{}]  # the root: filled at the end
        self.channels: list[Any] = []
        self.samplers: list[Any] = []
        self.known: dict[Any, Any] = {}
        self.times = self._accessor((openings * _SECONDS).astype("<f4")[:, None], "SCALAR", None)
        self.gone: Any = None  # times and scales of bodies that are there when flat only

    def of(self, moving: Sequence[MovingBody]) -> bytes:
        roots = [self._body(body) for body in moving]
        self.nodes[0] = {
            "name": self.title,
            "rotation": _UPRIGHT,
            "scale": [_MILLIMETRE] * 3,
            "children": roots,
        }
        document = {
            "asset": {"version": "2.0", "generator": f"Bistable Workbench {__version__}"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": self.nodes,
            "meshes": self.meshes,
            "materials": self.materials,
            "animations": [
                {"name": "deployment", "channels": self.channels, "samplers": self.samplers}
            ],
            "accessors": self.accessors,
            "bufferViews": self.views,
            "buffers": [{"byteLength": len(self.data)}],
        }
        text = json.dumps(document, separators=(",", ":"), ensure_ascii=False).encode()
        return _container(text, bytes(self.data))

    def _body(self, body: MovingBody) -> int:
        """Node that moves, and the node that holds its mesh in the flat state."""
        mesh = self._mesh(body.mesh, colours.of(body.kind))
        holder: dict[str, Any] = {"mesh": mesh}
        if not np.array_equal(body.place, np.eye(4)):
            holder["matrix"] = [float(x) for x in np.asarray(body.place).T.ravel()]
        self.nodes.append(holder)
        node: dict[str, Any] = {"name": body.name, "children": [len(self.nodes) - 1]}
        self.nodes.append(node)
        number = len(self.nodes) - 1
        if body.motions is None:
            node["scale"] = [0.0, 0.0, 0.0]
            self._vanish(number)
            return number
        turns, steps = _quaternions(body.motions), body.motions[:, :3, 3]
        node["rotation"], node["translation"] = turns[-1].tolist(), steps[-1].tolist()
        for path, values, kind in (("rotation", turns, "VEC4"), ("translation", steps, "VEC3")):
            output = self._accessor(values.astype("<f4"), kind, None)
            self._channel(number, path, self.times, output)
        return number

    def _vanish(self, node: int) -> None:
        """Shown while flat, gone as soon as the tube opens."""
        if self.gone is None:
            times = np.array([[0], [1e-3]], "<f4")
            scales = np.array([[1, 1, 1], [0, 0, 0]], "<f4")
            self.gone = self._accessor(times, "SCALAR", None), self._accessor(scales, "VEC3", None)
        times_of, scales_of = self.gone
        self._channel(node, "scale", times_of, scales_of, "STEP")

    def _channel(self, node: int, path: str, times: int, output: int, how: str = "LINEAR") -> None:
        self.samplers.append({"input": times, "output": output, "interpolation": how})
        target = {"node": node, "path": path}
        self.channels.append({"sampler": len(self.samplers) - 1, "target": target})

    def _mesh(self, mesh: "Mesh", colour: str) -> int:
        if (id(mesh), colour) not in self.known:
            short = len(mesh.vertices) < 65535
            position = self._accessor(mesh.vertices.astype("<f4"), "VEC3", _VERTICES)
            numbers = mesh.triangles.ravel()[:, None].astype("<u2" if short else "<u4")
            primitive = {
                "attributes": {"POSITION": position},
                "indices": self._accessor(numbers, "SCALAR", _INDICES),
                "material": self._material(colour),
            }
            self.meshes.append({"primitives": [primitive]})
            self.known[id(mesh), colour] = len(self.meshes) - 1, mesh  # kept: its id stays its own
        return self.known[id(mesh), colour][0]

    def _material(self, colour: str) -> int:
        if colour not in self.known:
            linear = [round(_linear(x), 5) for x in colours.rgb(colour)]
            look = {"baseColorFactor": [*linear, 1], "metallicFactor": 0, "roughnessFactor": 0.7}
            self.materials.append({"name": colour, "pbrMetallicRoughness": look})
            self.known[colour] = len(self.materials) - 1
        return self.known[colour]

    def _accessor(self, values: NDArray, kind: str, target: int | None) -> int:
        component = {"<f4": _FLOAT, "<u2": _SHORT, "<u4": _INT}[values.dtype.str]
        view = {"buffer": 0, "byteOffset": len(self.data), "byteLength": values.nbytes}
        if target:
            view["target"] = target
        self.views.append(view)
        self.data += values.tobytes() + bytes(-values.nbytes % 4)
        accessor = {
            "bufferView": len(self.views) - 1,
            "componentType": component,
            "count": len(values),
            "type": kind,
        }
        if target != _INDICES:
            accessor["min"], accessor["max"] = values.min(0).tolist(), values.max(0).tolist()
        self.accessors.append(accessor)
        return len(self.accessors) - 1


def _container(text: bytes, data: bytes) -> bytes:
    """The chunks JSON and BIN behind the header of GLB."""
    text += b" " * (-len(text) % 4)
    length = 12 + 8 + len(text) + 8 + len(data)
    head = struct.pack("<4sII", b"glTF", 2, length)
    return b"".join(
        [head, struct.pack("<I4s", len(text), b"JSON"), text,
         struct.pack("<I4s", len(data), b"BIN\0"), data]
    )  # fmt: skip


def _linear(value: float) -> float:
    """A value of sRGB as light: glTF's factors are linear."""
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def _quaternions(poses: NDArray) -> NDArray:
    """Unit quaternions (k, 4), x y z w, of poses (k, 4, 4); neighbours lie on the same side."""
    turns = poses[:, :3, :3]
    found = np.empty((len(turns), 4))
    for k, m in enumerate(turns):
        # the eigenvector of Bar-Itzhack's matrix: exact for any rotation, half turns too
        (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = m
        whole = np.array(
            [
                [xx - yy - zz, yx + xy, zx + xz, zy - yz],
                [yx + xy, yy - xx - zz, zy + yz, xz - zx],
                [zx + xz, zy + yz, zz - xx - yy, yx - xy],
                [zy - yz, xz - zx, yx - xy, xx + yy + zz],
            ]
        )
        found[k] = np.linalg.eigh(whole)[1][:, -1]
        if k and found[k] @ found[k - 1] < 0:
            found[k] = -found[k]
    return found / np.linalg.norm(found, axis=1, keepdims=True)
