# SPDX-License-Identifier: LGPL-2.1-or-later
"""Documents that nobody sees, and a console that keeps still."""

import contextlib
from collections.abc import Iterator

import FreeCAD as App


@contextlib.contextmanager
def hidden_document(title: str) -> Iterator[App.Document]:
    """A document without a window, closed at the end."""
    doc = App.newDocument("Bistable", hidden=True)
    doc.Label = title
    try:
        yield doc
    finally:
        App.closeDocument(doc.Name)


@contextlib.contextmanager
def quiet_console() -> Iterator[None]:
    """No tracebacks of refused values on the console: they become sentences here."""
    console = App.Console
    before = {kind: console.GetStatus("Console", kind) for kind in ("Err", "Log", "Msg", "Wrn")}
    for kind in before:
        console.SetStatus("Console", kind, False)
    try:
        yield
    finally:
        for kind, state in before.items():
            console.SetStatus("Console", kind, bool(state))
