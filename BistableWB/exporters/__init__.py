# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files for other programs: ``export(objects, "print.stl", **options)``, one module a format.

A module has ``write(bodies, path, **options)``: it writes ``bodies``, a list of `Body`, to ``path``
or raises. It need not care about half-written files: `export` lets it write into a temporary folder
beside the target, and only a whole file takes the old one's place.
"""

import importlib
import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..files import check_target, refuse_to_write, whole_file
from ..origami.errors import Refusal, phrase
from .bodies import Body, bodies_of
from .formats import FORMATS, suffix_of, suffixes

if TYPE_CHECKING:
    import FreeCAD as App

__all__ = ["FORMATS", "Body", "export", "suffix_of", "suffixes"]


def export(
    objects: "App.DocumentObject | Iterable[Any] | Sequence[Any]", path: Path, **options: Any
) -> Path:
    """Write document objects to ``path`` in the format of its suffix; returns the path.

    ``objects``: one object or several, recomputed. Options are the format's own; formats of shapes
    also take ``state``: "flat" or "deployed" (without it prints are flat, and faces are as they
    are shown). A file that is there is replaced only by a whole new one. ValueError, one sentence
    with the cure, for an unknown suffix or option, a folder that cannot be written, no objects, an
    invalid object.
    """
    path = Path(path)
    write = _writer(path, options)
    state = options.pop("state", None)
    if not isinstance(objects, list | tuple):
        objects = [objects] if objects is not None else []
    bodies = bodies_of(objects, state)
    return _written(write, bodies, path, options)


def write_bodies(bodies: Sequence[Any], path: Path, **options: Any) -> Path:
    """Write a list of `Body` (shapes, or `bodies.Drawn` where no kernel is needed); the path.

    As `export`, for who has no document.
    """
    path = Path(path)
    return _written(_writer(path, options), bodies, path, options)


def _written(
    write: Callable[..., Any], bodies: Sequence[Any], path: Path, options: Mapping[str, Any]
) -> Path:
    check_target(path)
    try:
        with whole_file(path) as unfinished:
            write(bodies, unfinished, **options)
    except OSError as error:
        refuse_to_write(path, error)
    return path


def _writer(path: Path, options: Mapping[str, Any]) -> Callable[..., Any]:
    """Function that writes the format of ``path``, its options checked."""
    suffix = suffix_of(path)
    if suffix not in FORMATS:
        what = phrase("the suffix {suffix}" if path.suffix else "no suffix", suffix=path.suffix)
        raise Refusal(
            "{name} has {what}: name the file with one of {suffixes}.",
            name=path.name,
            what=what,
            suffixes=suffixes(),
        )
    write = importlib.import_module(f"{__name__}.{FORMATS[suffix].module}").write
    known = [p.name for p in inspect.signature(write).parameters.values()][2:]
    known += ["state"] if FORMATS[suffix].has_states else []
    for name in options:
        if name not in known:
            offers = phrase(
                "it has {options}" if known else "it has none", options=", ".join(known)
            )
            raise Refusal(
                "{suffix} export has no option {name!r}: {offers}.",
                suffix=suffix,
                name=name,
                offers=offers,
            )
    return write
