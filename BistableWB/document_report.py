# SPDX-License-Identifier: LGPL-2.1-or-later
"""A report on a tube or a print in an open document: one HTML file.

    from BistableWB import document_report
    document_report.write(doc.HingeSet, "report.html")

It has what the report of a design file has (`report`), and that design file itself, which makes the
same again.
"""

import tempfile
from pathlib import Path

import FreeCAD as App

from . import design, produce, report
from .design_text import CURVE_FILE, objects_of, text_of
from .exporters import check_target, refuse_to_write

_STEPS = 12  # of the progress bar: about as many as there are checks and pictures


def write(obj, path, title=None, with_slicer=False):
    """Write the report on a BistableUnit, HingeSet or HingeCoupon to ``path``; returns the path.

    ``with_slicer``: compare a HingeSet's print with the deployed one by PrusaSlicer, which takes
    minutes. Esc stops it where there is a window, by a RuntimeError. A file that is there is
    replaced only by a whole new one. ValueError, one sentence with the cure, for other objects,
    invalid ones and a path that cannot be written. Without matplotlib the report says so, and has
    no pictures.
    """
    path = Path(path)
    if path.suffix.lower() not in (".html", ".htm"):
        raise ValueError(f"{path.name} is no name of a report: let it end in .html.")
    check_target(path)
    objects = objects_of(obj)
    _check(objects)
    indicator = App.Base.ProgressIndicator()
    indicator.start("Report…", _STEPS)
    try:
        with tempfile.TemporaryDirectory() as folder:
            heading = title or f"{obj.Document.Label}: {obj.Label}"
            result = _result(objects, heading, folder, with_slicer)
            produce.tell(result, objects, lambda text: indicator.next(True))
            result.files.clear()  # the pictures, which the report holds
            return report.write(path, [result])
    except OSError as error:
        refuse_to_write(path, error)
    finally:
        indicator.stop()


def _check(objects):
    for obj in objects.values():
        if not obj.isValid():
            raise ValueError(f"{obj.Label} is invalid, correct it first: {obj.getStatusString()}")
        if "Touched" in obj.State:
            raise ValueError(f"{obj.Label} is not computed yet: recompute the document first.")


def _result(objects, title, folder, with_slicer):
    """The `produce.Result` of a document's objects, with the design that they are."""
    output = {"slicer": True} if with_slicer else {}
    name = Path("".join(c if c.isalnum() or c in "-_" else "-" for c in title) + ".toml")
    try:
        text, curve = text_of(objects, title)
        made = design.check(name, text + "\n[output]\nslicer = true\n" * with_slicer)
    except (ValueError, design.DesignError) as error:
        tables = {"design": {"name": title}, "output": output}
        result = produce.Result(design.Design(name, "", tables), Path(folder))
        result.problems.append(str(error))
        return result
    result = produce.Result(made, Path(folder))
    if curve:
        result.attached[CURVE_FILE] = curve
    return result
