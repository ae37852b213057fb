# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links between objects: what was linked and is gone, and what an App::Link stands for.

FreeCAD empties a link when its target is deleted, or is not copied along. An object that then took
the empty link for a choice would become another one without a word: so each remembers, in a hidden
property, which of its links were ever set, until somebody sets one that is there to nothing.
"""

from ..origami.errors import Refusal, name_of

REMEMBERED = "LinkedOnce"  # the hidden property: names of links


def link_names(proxy) -> list[str]:
    """Names of the links among the properties of a proxy."""
    return [prop.name for prop in proxy.PROPERTIES if prop.kind.startswith("Link")]


def target_of(obj, name):
    """What a link, or a link with sub-elements, points to; None where it is empty."""
    value = getattr(obj, name)
    return value[0] if isinstance(value, tuple) else value


def may_be_freed(obj, name) -> bool:
    """Whether a link that is set now may be set to nothing by somebody who means it.

    FreeCAD itself does that when the target is deleted, and while it reads files and copies.
    """
    target, document = target_of(obj, name), obj.Document
    states = (getattr(document, state, False) for state in ("Restoring", "Importing"))
    return target is not None and not target.Removing and not any(states)


def remember(obj, name, freed=False):
    """Note that a link was set, or (``freed``) set to nothing."""
    if REMEMBERED not in obj.PropertiesList:
        return
    known = list(getattr(obj, REMEMBERED))
    if target_of(obj, name) is not None:
        if name not in known:
            setattr(obj, REMEMBERED, [*known, name])
    elif name in known and freed:
        setattr(obj, REMEMBERED, [other for other in known if other != name])


def linked(obj, name):
    """What a link points to, None where it never was set; `Refusal` where that is gone."""
    target = target_of(obj, name)
    if target is None and name in getattr(obj, REMEMBERED, ()):
        raise Refusal(
            "{link} of {label} is gone: it was deleted, or not copied along",
            cure="undo that, or choose another {link}",
            parameter=name,
            link=name_of(name),
            label=obj.Label,
        )
    if target is not None and leads_back(target, obj):
        raise goes_round(obj, target.Label, name)
    return target


def leads_back(target, obj) -> bool:
    """Whether ``target`` is made of ``obj``, by whatever way, or is itself ``obj``."""
    return any(one is obj for one in _along(target, "OutList"))


def made_of(obj):
    """Objects of the workbench that are made of ``obj``, by whatever way."""
    return [o for o in _along(obj, "InList")[1:] if hasattr(getattr(o, "Proxy", None), "refusal")]


def _along(start, links):
    """``start`` and all that it leads to; what FreeCAD has for it gives up at cycles."""
    found, seen = [start], {start.Name}
    for one in found:
        for other in getattr(one, links):
            if other.Name not in seen:
                seen.add(other.Name)
                found.append(other)
    return found


def goes_round(obj, target, name="") -> Refusal:
    """The `Refusal` of a link that leads back to the object that has it."""
    return Refusal(
        "{target} is itself made of {label}, which therefore cannot follow it",
        cure="choose geometry that does not depend on {label}",
        parameter=name,
        target=target,
        label=obj.Label,
    )


def followed(target):
    """The object that an App::Link, or a link to a link, stands for; others are themselves."""
    if target is not None and hasattr(target, "getLinkedObject"):
        real = target.getLinkedObject(True)
        return target if real is None else real
    return target


def refuse_foreign(obj, name, target):
    """`Refusal` where ``target`` lives in another document than ``obj``, which links to it."""
    if target is not None and target.Document is not obj.Document:
        raise Refusal(
            "{link}: {target} is in the document {other}, and links do not leave a document",
            cure="copy it into {own} first, or make an App::Link to it there",
            parameter=name,
            link=name_of(name),
            target=target.Label,
            other=target.Document.Label,
            own=obj.Document.Label,
        )
