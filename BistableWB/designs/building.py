# SPDX-License-Identifier: LGPL-2.1-or-later
"""A `Design` becomes a document, files, pictures and a report. Runs inside FreeCAD.

To add a table that makes an object: its keys go into `keys.TABLES`, a function into
`_MAKERS` here; what it gives goes into `outputs` and `_pictures`. What is special about prints is
in `print_facts`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import FreeCAD as App

from .. import exporters, make, pictures, slicing
from ..exporters.glb import live_model
from ..files import whole_file
from ..objects.hinge_inputs import hinge_parameters
from ..objects.refused import refusal_of
from ..origami.curves.families import FAMILIES
from ..origami.errors import Phrase, Refusal, phrase
from ..origami.progress import NOBODY, as_progress
from ..programs import openscad
from ..reports import facts, page, print_facts
from ..slicing import ways
from ..slicing.section import section
from . import printable
from .documents import hidden_document, quiet_console
from .drawing import draw_unit
from .keys import PRINTS, TABLES
from .outputs import wanted_files
from .parts import in_parts
from .reading import Design, DesignError
from .source import source_of
from .wording import keyed, with_keys
from .writing import unused

if TYPE_CHECKING:
    from ..origami.progress import Progress

# What was made, by the tables of the design file.
Objects = Mapping[str, App.DocumentObject]

MAX_UNITS = 2000  # more are a slip of the pen, and hours of FreeCAD


@dataclass
class Result:
    """What `building` made: ``files`` (paths), ``problems`` (phrases; empty if all went well).

    ``attached``: text files that a report carries with it, {name: content}.
    """

    design: Design
    folder: Path
    files: list = field(default_factory=list)
    problems: list = field(default_factory=list)
    pictures: dict = field(default_factory=dict)  # caption -> path
    live: dict = field(default_factory=dict)  # caption -> GLB, bytes
    facts: Any = None  # `facts.Facts`, once all is made
    attached: dict = field(default_factory=dict)

    def add(self, path: Path) -> Path:
        """Note a file that was made."""
        self.files.append(path)
        return path


def produce(design: Design, folder: Path, progress: "Progress | None" = None) -> Result:
    """Make everything that ``design`` asks for in ``folder``; returns a `Result`.

    `DesignError` where an object refuses its values. What fails on the way, such as a picture
    without matplotlib, is a problem of the result, and the rest is made.
    """
    folder, progress = Path(folder), as_progress(progress)
    folder.mkdir(parents=True, exist_ok=True)
    result = Result(design, folder)
    with quiet_console(), hidden_document(design.title) as doc:
        objects = build(doc, design, progress, result.problems)
        progress.step(_summary(objects))
        _exports(result, objects, progress)
        _save(result, doc, progress)
        tell(result, objects, progress)
        result.problems += [
            keyed(design, table, error)
            for table, made in result.facts.prints.items()
            for error in made.errors
        ]
    if design.get("output", "report", True):
        _try(result, phrase("report"), _report, result, progress)
    return result


def tell(result: Result, objects: Objects, progress: "Progress" = NOBODY) -> None:
    """Facts and pictures of recomputed ``objects`` {table: object} into a `Result`.

    ``progress``: a `Progress`.
    """
    prints = _prints(objects)
    result.facts = facts.facts_of(objects, prints, unused, progress)
    if result.design.get("output", "openscad", False):
        for table, made in prints.items():
            progress.step(f"OpenSCAD reads the {table}")
            found = openscad.check([body.placed for body in made.meshes])
            result.facts.prints[table].findings.extend(found)
    if result.design.get("output", "slicer", False):
        _try(result, phrase("slicer"), _slice, result, objects["hinges"], progress)
    if result.design.get("output", "pictures", True):
        _try(result, phrase("live view"), _live, result, objects, progress)
        _try(result, phrase("pictures"), _pictures, result, objects, prints, progress)


def pictures_of(design: Design, folder: Path, wanted: Any) -> Any:
    """Only some pictures of the prints of ``design``: ``wanted`` {name: file}; returns the paths.

    "film" is one that is made only here: the HingeSet as it opens and folds.

    `DesignError` and `pictures.NoMatplotlib` where there can be none.
    """
    paths = []

    def draw(name: str, caption: Phrase | str, function: Callable[..., Any], *args: Any) -> None:
        if name in wanted:
            paths.append(function(Path(folder) / wanted[name], *args))

    with quiet_console(), hidden_document(design.title) as doc:
        for made in _prints(build(doc, design)).values():
            made.draw(draw)
            if "film" in wanted:
                draw("film", "", made.film)
    return paths


def build(
    doc: App.Document,
    design: Design,
    progress: "Progress" = NOBODY,
    problems: list[str] | None = None,
) -> dict[str, App.DocumentObject]:
    """Make and recompute the objects of ``design`` in ``doc``: {table name: object}.

    ``problems`` gets what stands in the way of what is wished. `DesignError`, in the words of the
    design file, where an object is invalid.
    """
    objects: dict[Any, Any] = {}
    for table, maker in _MAKERS.items():
        wanted = maker(doc, design, objects)
        if wanted is not None:
            objects[table] = wanted
            _set_properties(wanted, table, design)
    _allow_for_thickness(design, objects)
    blocked = printable.make_it(doc, design, objects, progress)
    if problems is not None:
        problems += blocked
    in_parts(doc, design, objects)
    doc.recompute()
    for table, obj in objects.items():
        refusal = refusal_of(obj)
        if refusal is not None:
            raise DesignError(
                "{path}: [{table}] {refused}.",
                path=design.path,
                table=table,
                refused=with_keys(design, table, refusal).rstrip("."),
            )
    _refuse_keys_of_other_kinds(design, objects)
    return objects


def _refuse_keys_of_other_kinds(design: Design, objects: Objects) -> None:
    """What only another kind of curve uses would be left out without a word."""
    if "curve" not in objects:
        return
    found = objects["curve"].FoundKind
    for needed, family in FAMILIES.items():
        for key in family.keys:
            if design.get("curve", key) is not None and needed != found:
                raise DesignError(
                    "{path}: [curve] {key} needs the kind {needed}, and the curve is found to be "
                    '{found}; add kind = "{needed}" or remove {key}.',
                    path=design.path,
                    key=key,
                    needed=needed,
                    found=found,
                )


def _curve(doc: App.Document, design: Design, objects: Objects) -> App.DocumentObject | None:
    if "curve" not in design.tables:
        return None
    return make.make_curve(
        doc, source=source_of(doc, design), kind=design.get("curve", "kind", "Automatic")
    )


def _triangles(doc: App.Document, design: Design, objects: Objects) -> App.DocumentObject | None:
    return make.make_triangle_placement(doc, objects["curve"]) if "curve" in objects else None


def _unit(doc: App.Document, design: Design, objects: Objects) -> App.DocumentObject | None:
    if not design.makes_unit:
        return None
    triangles = objects.get("triangles")
    if triangles is not None:
        _refuse_too_many(design, triangles)
    return make.make_bistable_unit(doc, triangles)


def _hinges(doc: App.Document, design: Design, objects: Objects) -> App.DocumentObject | None:
    if "hinges" not in design.tables:
        return None
    chosen = (design.get("hinges", key) for key in ("preset", "process"))
    made = make.make_hinge_set(doc, objects["unit"], "Rotational", *chosen)
    _set_properties(objects["unit"], "unit", design)  # what the file says goes before what suits
    return made


def _coupon(doc: App.Document, design: Design, objects: Objects) -> Any:
    if "coupon" not in design.tables:
        return None
    return make.make_hinge_coupon(doc, design.get("coupon", "kind", "Dihedral"), preset=None)


def _calibration(
    doc: App.Document, design: Design, objects: Mapping[str, App.DocumentObject]
) -> Any:
    return make.make_calibration_plate(doc) if "calibration" in design.tables else None


def _allow_for_thickness(design: Design, objects: Mapping[str, App.DocumentObject]) -> None:
    """Triangles without a thickness of their own leave room for the panels of the hinges."""
    if "hinges" in objects and "triangles" in objects:
        pitch = hinge_parameters(objects["hinges"]).pitch
        objects["triangles"].Thickness = design.get("triangles", "thickness", pitch)


# Table -> function (doc, design, objects so far) that makes its object, or gives None. In this
# order: an object may link to those before it.
_MAKERS = {
    "curve": _curve,
    "triangles": _triangles,
    "unit": _unit,
    "hinges": _hinges,
    "coupon": _coupon,
    "calibration": _calibration,
}


def _refuse_too_many(design: Design, triangles: App.DocumentObject) -> None:
    """Place the triangles before anything with faces is made of them."""
    triangles.Document.recompute()
    if triangles.isValid() and triangles.Count > MAX_UNITS:
        raise DesignError(
            "{path}: [triangles] edge_length {edge:g} gives {count} units, more than "
            "{most}; make it longer.",
            path=design.path,
            edge=triangles.EdgeLength.Value,
            count=triangles.Count,
            most=MAX_UNITS,
        )


def _set_properties(obj: App.DocumentObject, table: str, design: Design) -> None:
    for key, entry in TABLES[table].items():  # in this order, whatever the file's
        name, value = entry.property, design.get(table, key)
        if value is None or (name == "Process" and obj.Process == value):
            continue  # chosen again, a process would set its numbers again
        if name == "Points":
            value = [App.Vector(*point) for point in value]
        elif isinstance(value, list) and name != "UnitMargins":
            value = App.Vector(*value)
        if name:
            setattr(obj, name, value)


def _summary(objects: Objects) -> str:
    told = []
    if "unit" in objects:
        unit = objects["unit"]
        count = len(unit.Alphas)
        told.append(f"{count} unit{'s' if count != 1 else ''}")
        told.append(f"isometry error {unit.IsometryError:.1e}")
    told += [f"{objects[t].BodyCount} bodies" for t in PRINTS if t in objects]
    return ", ".join(told)


def _prints(objects: Objects) -> dict[str, Any]:
    """What `print_facts` knows of the prints: {table: HingedTube or Coupon}."""
    kinds = dict.fromkeys(PRINTS, print_facts.Coupon) | {"hinges": print_facts.HingedTube}
    return {table: kind(objects[table]) for table, kind in kinds.items() if table in objects}


def _exports(result: Result, objects: Objects, progress: "Progress") -> None:
    for obj, name, options in wanted_files(result.design, objects):
        path = result.folder / f"{result.design.stem}{name}"
        if _try(result, path.name, exporters.export, [obj], path, **options):
            progress.step(result.add(path).name)


def _save(result: Result, doc: App.Document, progress: "Progress") -> None:
    path = result.folder / f"{result.design.stem}.FCStd"
    with whole_file(path) as unfinished:
        doc.saveCopy(str(unfinished))
    progress.step(result.add(path).name)


def _pictures(result: Result, objects: Objects, prints: Any, progress: "Progress") -> None:
    pictures.require()

    def draw(name: str, caption: Phrase | str, function: Callable[..., Any], *args: Any) -> None:
        path = result.folder / f"{result.design.stem}-{name}.png"
        result.pictures[caption] = result.add(function(path, *args))
        progress.step(path.name)

    for made in prints.values():
        made.draw(draw)
    if "unit" in objects:
        draw_unit(objects, "hinges" not in prints, draw)


def _live(result: Result, objects: Objects, progress: "Progress") -> None:
    """What moves in the report: the thick tube, else the faces."""
    shown = objects.get("hinges") or objects.get("unit")
    if shown is not None:
        caption = phrase("Drag to turn it, roll to come nearer; the slider opens and folds it")
        result.live[caption] = live_model(shown, result.design.stem)
        progress.step("live view")


def _slice(result: Result, hinge_set: Any, progress: "Progress") -> None:
    compared = slicing.compare(hinge_set, progress)
    made = result.facts.prints["hinges"]
    made.findings.extend(compared.findings)
    made.sections.append(section(compared))
    made.sections.append(ways.section(slicing.modes(hinge_set, progress)))


def _report(result: Result, progress: "Progress") -> None:
    path = result.folder / "report.html"
    page.write(path, [result])
    progress.step(result.add(path).name)


def _try(
    result: Result, what: Phrase | str, function: Callable[..., Any], *args: Any, **options: Any
) -> bool:
    """Call ``function``; what goes wrong in a known way becomes a problem. True if it went well."""
    try:
        function(*args, **options)
    except (Refusal, OSError) as error:
        said = keyed(result.design, None, error) if isinstance(error, Refusal) else str(error)
        result.problems.append(phrase("{what}: {said}", what=what, said=said))
        return False
    return True
