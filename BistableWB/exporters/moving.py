# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tubes that move, as plain data: bodies as meshes, and where each stands at every opening."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..objects.base import global_placement
from ..objects.bistable_unit import tube_of
from ..origami import rigid
from ..origami.meshes import Mesh
from ..origami.units.creases import INDEX, PANELS, kind_of
from ..solids.matrices import array_of
from ..solids.tessellation import placed_meshes, shared

if TYPE_CHECKING:
    import FreeCAD as App

    from .bodies import Body


class MovingBody(NamedTuple):
    """A body on its way from flat to deployed; lengths in mm, in space.

    ``kind``: a key of `colours.KINDS`, or empty. ``mesh``, shared by all its copies, stands at
    ``place`` (4, 4), which may mirror it, in the flat state; ``motions`` (k, 4, 4) carry it from
    there to each of the openings that were asked for. None: the body is there in the flat state
    only (what bends, what is taken out).
    """

    name: str
    kind: str
    mesh: Mesh
    place: NDArray
    motions: NDArray | None


def moving_bodies(
    bodies: "Sequence[Body]", openings: NDArray, linear: float, angular: float
) -> list[MovingBody]:
    """`MovingBody` list of the objects that exported ``bodies`` come from, each once.

    ``openings`` (k,): fractions of θ; ``linear``, ``angular``: deflections of round faces. Objects
    that do not move stand still.
    """
    sources = list({id(body.source): body.source for body in bodies}.values())
    found: list[Any] = []
    for obj in sources:
        kind = getattr(getattr(obj, "Proxy", None), "Type", "")
        if kind == "Bistable::HingeSet":
            found += _print_bodies(obj, openings, linear, angular)
        elif kind == "Bistable::BistableUnit":
            found += _panels(obj, openings)
        else:
            found += _still([b for b in bodies if b.source is obj], openings, linear, angular)
    return found


def _into_space(obj: "App.DocumentObject") -> NDArray:
    return array_of(global_placement(obj))


def _print_bodies(
    obj: "App.DocumentObject", openings: NDArray, linear: float, angular: float
) -> Iterator[MovingBody]:
    """Bodies of a HingeSet, from its flat print to its curve."""
    model = obj.Proxy.model(obj)
    space = _into_space(obj)
    back = np.linalg.inv(space)
    states = [model.motions(opening) for opening in openings]
    for k, body in enumerate(placed_meshes(model.bodies, linear, angular)):
        moved = None
        if states[0][k] is not None:
            moved = np.array([space @ state[k] @ back for state in states])
        yield MovingBody(body.name, body.kind, body.mesh, space @ body.place, moved)


def _panels(obj: "App.DocumentObject", openings: NDArray) -> Iterator[MovingBody]:
    """Panels of zero thickness: each as rigid as the state of least misfit lets it be."""
    tube = tube_of(obj)
    space = np.eye(4) if obj.Triangles is not None else _into_space(obj)
    states = np.array([rigid.apply(space, tube.state(opening)) for opening in openings])
    for k in range(len(tube)):
        for name, corners in PANELS.items():
            points = states[:, k, [INDEX[v] for v in corners]]  # (openings, 3|4, 3)
            fan = np.array([[0, i, i + 1] for i in range(1, len(corners) - 1)])
            both = np.concatenate([fan, fan[:, ::-1]])  # seen from either side
            corner_points = np.concatenate([points[0], points[0]])
            both[len(fan) :] += len(corners)
            motions = rigid.fit(np.broadcast_to(points[0], points.shape), points)
            yield MovingBody(
                f"unit{k + 1:02d}_{name}",
                kind_of(name),
                Mesh(corner_points, both),
                np.eye(4),
                motions,
            )


def _still(
    bodies: Sequence[Any], openings: NDArray, linear: float, angular: float
) -> Iterator[Any]:
    tessellator = shared(linear, angular)
    stay = np.broadcast_to(np.eye(4), (len(openings), 4, 4))
    for body in bodies:
        yield MovingBody(body.name, body.kind, *tessellator.original(body.shape), stay)
