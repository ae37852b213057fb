# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is exported: named shapes in global coordinates, or a sentence why there are none."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from ..objects.current import refuse_stale
from ..origami.errors import Refusal

if TYPE_CHECKING:
    import FreeCAD as App
    import Part


STATES = {"flat": 0.0, "deployed": 1.0}  # name -> opening


class Body(NamedTuple):
    """One thing to export: ``name``, ``shape`` (global, mm), ``face_names`` (or empty), object.

    ``kind``: as of `solids.tube.Body`; empty for what is no body of a print of ours.
    """

    name: str
    shape: Any
    face_names: tuple
    source: Any
    kind: str = ""


def bodies_of(objects: Sequence[Any], state: str | None = None) -> list[Body]:
    """`Body` list of document objects; ValueError where one has nothing to export.

    An object's proxy may offer ``export_bodies(obj)`` → [(name, shape, kind), …] in the object's
    own frame (for one body each of a print), ``bodies_at(obj, opening)`` for those of another
    ``state``, a name in `STATES`, and ``face_names(obj)`` for its own shape's faces. Several
    prints that would lie in each other are laid out on one plate (`plate.laid_out`).
    """
    if state is not None and state not in STATES:
        raise Refusal(
            "state is {state!r}: choose one of {names}.",
            state=state,
            names=", ".join(STATES),
        )
    if not objects:
        raise Refusal("Nothing is selected to export: choose one or more objects.")
    others: Any
    prints: Any
    others, prints = [], []
    for obj in objects:
        _check(obj)
        is_print = hasattr(getattr(obj, "Proxy", None), "export_bodies") and state != "deployed"
        (prints if is_print else others).append(_made_of(obj, state))
    found = [body for bodies in others for body in bodies]
    from .plate import laid_out  # needs FreeCAD; what names the formats does not

    return _with_unique_names(found + laid_out(prints))


def _made_of(obj: "App.DocumentObject", state: str | None) -> list[Body]:
    """`Body` list of one object, where it stands."""
    move = _into_global(obj)
    proxy: Any = getattr(obj, "Proxy", None)
    if state is not None:
        names = _face_names(obj, proxy)
        made = _bodies_at(obj, proxy, state)
        return [Body(name, move(shape), names, obj, kind) for name, shape, kind in made]
    if hasattr(proxy, "export_bodies"):
        made = proxy.export_bodies(obj)
        return [Body(name, move(shape), (), obj, kind) for name, shape, kind in made]
    return [Body(obj.Label, move(obj.Shape), _face_names(obj, proxy), obj)]


def _bodies_at(
    obj: "App.DocumentObject", proxy: Any, state: str
) -> "list[tuple[str, Part.Shape, str]]":
    if not hasattr(proxy, "bodies_at"):
        raise Refusal(
            "{label} cannot be {state}: export it without a state.",
            label=obj.Label,
            state=state,
        )
    return proxy.bodies_at(obj, STATES[state])


def _check(obj: "App.DocumentObject") -> None:
    label = getattr(obj, "Label", repr(obj))
    if not hasattr(obj, "Shape"):
        raise Refusal(
            "{label} has no shape to export: choose a unit, a tube or a solid.",
            label=label,
        )
    refuse_stale(obj)
    if obj.Shape.isNull():
        raise Refusal(
            "{label} is not computed yet",
            cure="recompute the document first",
            label=label,
        )
    if not obj.Shape.Faces:
        raise Refusal(
            "{label} has no faces to export: choose a unit, a tube or a solid.",
            label=label,
        )


def _into_global(obj: "App.DocumentObject") -> Callable[..., Any]:
    """Function that moves a shape of ``obj`` from where Shape has it to the global frame."""
    whole = obj.getGlobalPlacement() if hasattr(obj, "getGlobalPlacement") else obj.Placement
    above = whole * obj.Placement.inverse()

    def move(shape: "Part.Shape") -> "Part.Shape":
        if above.isIdentity():
            return shape
        from .plate import another

        shape = another(shape)
        shape.Placement = above * shape.Placement
        return shape

    return move


def _face_names(obj: "App.DocumentObject", proxy: Any) -> tuple[str, ...]:
    """Names of the faces of a shape, or an empty tuple where they have none."""
    if hasattr(proxy, "face_names"):
        return tuple(proxy.face_names(obj))
    if getattr(proxy, "Type", "") == "Bistable::BistableUnit":
        from ..origami.units.creases import PANELS

        count = len(obj.Shape.Faces) // len(PANELS)
        return tuple(f"unit_{k + 1}_{panel}" for k in range(count) for panel in PANELS)
    return ()


def _with_unique_names(bodies: Sequence[Body]) -> list[Body]:
    seen: Any
    seen, unique = {}, []
    for body in bodies:
        count = seen[body.name] = seen.get(body.name, 0) + 1
        unique.append(body if count == 1 else body._replace(name=f"{body.name}_{count}"))
    return unique
