# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is exported: named shapes in global coordinates, or a sentence why there are none."""

from typing import Any, NamedTuple

STATES = {"flat": 0.0, "deployed": 1.0}  # name -> opening


class Body(NamedTuple):
    """One thing to export: ``name``, ``shape`` (global, mm), ``face_names`` (or empty), object."""

    name: str
    shape: Any
    face_names: tuple
    source: Any


def bodies_of(objects, state=None):
    """`Body` list of document objects; ValueError where one has nothing to export.

    An object's proxy may offer ``export_bodies(obj)`` → [(name, shape), …] in the object's own
    frame (for one body each of a print), ``bodies_at(obj, opening)`` for those of another
    ``state``, a name in `STATES`, and ``face_names(obj)`` for its own shape's faces.
    """
    if state is not None and state not in STATES:
        raise ValueError(f"state is {state!r}: choose one of {', '.join(STATES)}.")
    if not objects:
        raise ValueError("Nothing is selected to export: choose one or more objects.")
    found = []
    for obj in objects:
        _check(obj)
        move = _into_global(obj)
        proxy = getattr(obj, "Proxy", None)
        if state is not None:
            names = _face_names(obj, proxy)
            found += [Body(n, move(s), names, obj) for n, s in _bodies_at(obj, proxy, state)]
        elif hasattr(proxy, "export_bodies"):
            found += [Body(n, move(s), (), obj) for n, s in proxy.export_bodies(obj)]
        else:
            found.append(Body(obj.Label, move(obj.Shape), _face_names(obj, proxy), obj))
    return _with_unique_names(found)


def _bodies_at(obj, proxy, state):
    if not hasattr(proxy, "bodies_at"):
        raise ValueError(f"{obj.Label} cannot be {state}: export it without a state.")
    return proxy.bodies_at(obj, STATES[state])


def _check(obj):
    label = getattr(obj, "Label", repr(obj))
    if not hasattr(obj, "Shape"):
        raise ValueError(f"{label} has no shape to export: choose a unit, a tube or a solid.")
    if not obj.isValid():
        raise ValueError(f"{label} is invalid, correct it first: {obj.getStatusString()}")
    if obj.Shape.isNull() or "Touched" in obj.State:
        raise ValueError(f"{label} is not computed yet: recompute the document, then export.")
    if not obj.Shape.Faces:
        raise ValueError(f"{label} has no faces to export: choose a unit, a tube or a solid.")


def _into_global(obj):
    """Function that moves a shape of ``obj`` from where Shape has it to the global frame."""
    whole = obj.getGlobalPlacement() if hasattr(obj, "getGlobalPlacement") else obj.Placement
    above = whole * obj.Placement.inverse()

    def move(shape):
        if above.isIdentity():
            return shape
        shape = shape.copy()
        shape.Placement = above * shape.Placement
        return shape

    return move


def _face_names(obj, proxy):
    """Names of the faces of a shape, or an empty tuple where they have none."""
    if hasattr(proxy, "face_names"):
        return tuple(proxy.face_names(obj))
    if getattr(proxy, "Type", "") == "Bistable::BistableUnit":
        from ..origami.creases import PANELS

        count = len(obj.Shape.Faces) // len(PANELS)
        return tuple(f"unit_{k + 1}_{panel}" for k in range(count) for panel in PANELS)
    return ()


def _with_unique_names(bodies):
    seen, unique = {}, []
    for body in bodies:
        count = seen[body.name] = seen.get(body.name, 0) + 1
        unique.append(body if count == 1 else body._replace(name=f"{body.name}_{count}"))
    return unique
