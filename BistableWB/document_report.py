# SPDX-License-Identifier: LGPL-2.1-or-later
"""A report on a tube or a print in an open document: one HTML file.

    from BistableWB import document_report
    document_report.write(doc.HingeSet, "report.html")

It has what the report of a design file has (`report`), and that design file itself, which makes the
same again.
"""

import tempfile
from pathlib import Path

from .designs import building, reading
from .designs.writing import CURVE_FILE, objects_of, text_of
from .files import check_target, refuse_to_write
from .objects.busy import progress_bar
from .objects.current import refuse_stale
from .origami.errors import Refusal, message_of
from .reports import page

_STEPS = 12  # of the progress bar: about as many as there are checks and pictures


def write(obj, path, title=None, with_slicer=False):
    """Write the report on a BistableUnit, HingeSet or HingeCoupon to ``path``; returns the path.

    ``obj``: one of them, or a list: then all of them are in one report, in this order.
    ``with_slicer``: compare a HingeSet's print with the deployed one by PrusaSlicer, which takes
    minutes. Esc stops it where there is a window, by `Cancelled`. A file that is there is
    replaced only by a whole new one. ValueError, one sentence with the cure, for other objects,
    invalid ones and a path that cannot be written. Without matplotlib the report says so, and has
    no pictures.
    """
    path = Path(path)
    if path.suffix.lower() not in (".html", ".htm"):
        raise Refusal(
            "{name} is no name of a report: let it end in .html.",
            name=path.name,
        )
    check_target(path)
    several = [objects_of(one) for one in (obj if isinstance(obj, list | tuple) else [obj])]
    if not several:
        raise Refusal("Nothing is selected to report on: choose one or more prints or tubes.")
    for objects in several:
        _check(objects)
    try:
        with (
            progress_bar("Report…", _STEPS * len(several)) as bar,
            tempfile.TemporaryDirectory() as folder,
        ):
            results = []
            for number, objects in enumerate(several):
                own = Path(folder) / str(number)
                own.mkdir()
                results.append(_told(objects, title, own, with_slicer, bar))
            return page.write(path, results)
    except OSError as error:
        refuse_to_write(path, error)


def _told(objects, title, folder, with_slicer, bar):
    """The `building.Result` of the objects of one print, with its facts and pictures."""
    last = list(objects.values())[-1]
    heading = title or f"{last.Document.Label}: {last.Label}"
    result = _result(objects, heading, folder, with_slicer)
    building.tell(result, objects, bar)
    result.files.clear()  # the pictures, which the report holds
    return result


def _check(objects):
    for obj in objects.values():
        refuse_stale(obj)


def _result(objects, title, folder, with_slicer):
    """The `building.Result` of a document's objects, with the design that they are."""
    output = {"slicer": True} if with_slicer else {}
    name = Path("".join(c if c.isalnum() or c in "-_" else "-" for c in title) + ".toml")
    try:
        text, curve = text_of(objects, title)
        made = reading.check(name, text + "\n[output]\nslicer = true\n" * with_slicer)
    except Refusal as error:
        tables = {"design": {"name": title}, "output": output}
        result = building.Result(reading.Design(name, "", tables), Path(folder))
        result.problems.append(message_of(error))
        return result
    result = building.Result(made, Path(folder))
    if curve:
        result.attached[CURVE_FILE] = curve
    return result
