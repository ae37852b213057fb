# SPDX-License-Identifier: LGPL-2.1-or-later
"""A `Design` becomes a document, files, pictures and a report. Runs inside FreeCAD.

To add a table that makes an object: its keys go into `design_table.TABLES`, a function into
`_MAKERS` here; what it gives goes into `outputs` and `_pictures`. What is special about prints is
in `hinged`.
"""

import contextlib
import math
import os
import re
from dataclasses import dataclass, field
from pathlib import Path

import FreeCAD as App
import Part

from . import exporters, hinged, imports, make, openscad, pictures, report, slicing
from .design import Design, DesignError
from .design_table import SINGLE_UNIT, TABLES, key_of_property
from .objects.bistable_unit import tube_of
from .objects.hinge_inputs import hinge_parameters
from .objects.triangle_placement import place_along
from .outputs import wanted_files
from .slicing.section import section

MAX_UNITS = 2000  # more are a slip of the pen, and hours of FreeCAD
_SHAPES = (".step", ".stp", ".iges", ".igs", ".brep", ".brp")
_DRAWINGS = (".svg", ".dxf", ".csv")


@dataclass
class Result:
    """What `produce` made: ``files`` (paths), ``problems`` (sentences; empty if all went well).

    ``attached``: text files that a report carries with it, {name: content}.
    """

    design: Design
    folder: Path
    files: list = field(default_factory=list)
    problems: list = field(default_factory=list)
    pictures: dict = field(default_factory=dict)  # caption -> path
    facts: report.Facts | None = None
    attached: dict = field(default_factory=dict)

    def add(self, path):
        """Note a file that was made."""
        self.files.append(path)
        return path


def produce(design, folder, progress=lambda text: None):
    """Make everything that ``design`` asks for in ``folder``; returns a `Result`.

    `DesignError` where an object refuses its values. What fails on the way, such as a picture
    without matplotlib, is a problem of the result, and the rest is made.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    result = Result(design, folder)
    with _quiet(), _document(design) as doc:
        objects = build(doc, design)
        progress(_summary(objects))
        _exports(result, objects, progress)
        _save(result, doc, progress)
        tell(result, objects, progress)
        result.problems += [
            _with_keys(design, table, error)
            for table, facts in result.facts.prints.items()
            for error in facts.errors
        ]
    if design.get("output", "report", True):
        _try(result, "report", _report, result, progress)
    return result


def tell(result, objects, progress=lambda text: None):
    """Facts and pictures of recomputed ``objects`` {table: object} into a `Result`.

    ``progress(text)`` may raise to cancel.
    """
    prints = _prints(objects)
    result.facts = report.facts_of(objects, prints, progress)
    if result.design.get("output", "openscad", False):
        for table, made in prints.items():
            progress(f"OpenSCAD reads the {table}")
            found = openscad.check([body.placed for body in made.meshes])
            result.facts.prints[table].findings.extend(found)
    if result.design.get("output", "slicer", False):
        _try(result, "slicer", _slice, result, objects["hinges"], progress)
    if result.design.get("output", "pictures", True):
        _try(result, "pictures", _pictures, result, objects, prints, progress)


def pictures_of(design, folder, wanted):
    """Only some pictures of the prints of ``design``: ``wanted`` {name: file}; returns the paths.

    "film" is one that is made only here: the HingeSet as it opens and folds.

    `DesignError` and `pictures.NoMatplotlib` where there can be none.
    """
    paths = []

    def draw(name, caption, function, *args):
        if name in wanted:
            paths.append(function(Path(folder) / wanted[name], *args))

    with _quiet(), _document(design) as doc:
        for made in _prints(build(doc, design)).values():
            made.draw(draw)
            if "film" in wanted:
                draw("film", "", made.film)
    return paths


def build(doc, design):
    """Make and recompute the objects of ``design`` in ``doc``: {table name: object}.

    `DesignError`, in the words of the design file, where an object is invalid.
    """
    objects = {}
    for table, maker in _MAKERS.items():
        wanted = maker(doc, design, objects)
        if wanted is not None:
            objects[table] = wanted
            _set_properties(wanted, table, design)
    _allow_for_thickness(design, objects)
    doc.recompute()
    for table, obj in objects.items():
        if not obj.isValid():
            raise DesignError(_in_words_of_the_file(design, table, obj.getStatusString()))
    return objects


def _curve(doc, design, objects):
    if "curve" not in design.tables:
        return None
    return make.make_curve(
        doc, source=_source(doc, design), kind=design.get("curve", "kind", "Plane")
    )


def _triangles(doc, design, objects):
    return make.make_triangle_placement(doc, objects["curve"]) if "curve" in objects else None


def _unit(doc, design, objects):
    if not design.makes_unit:
        return None
    triangles = objects.get("triangles")
    if triangles is not None:
        _refuse_too_many(design, triangles)
    return make.make_bistable_unit(doc, triangles)


def _hinges(doc, design, objects):
    if "hinges" not in design.tables:
        return None
    made = make.make_hinge_set(doc, objects["unit"], preset=design.get("hinges", "preset"))
    _set_properties(objects["unit"], "unit", design)  # what the file says goes before what suits
    return made


def _coupon(doc, design, objects):
    if "coupon" not in design.tables:
        return None
    return make.make_hinge_coupon(doc, design.get("coupon", "kind", "Dihedral"), preset=None)


def _allow_for_thickness(design, objects):
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
}


def _refuse_too_many(design, triangles):
    """Place the triangles before anything with faces is made of them."""
    triangles.Document.recompute()
    if triangles.isValid() and triangles.Count > MAX_UNITS:
        raise DesignError(
            f"{design.path}: [triangles] edge_length {triangles.EdgeLength.Value:g} gives "
            f"{triangles.Count} units, more than {MAX_UNITS}; make it longer."
        )


def _set_properties(obj, table, design):
    for key, entry in TABLES[table].items():  # in this order, whatever the file's
        name, value = entry.property, design.get(table, key)
        if value is None:
            continue
        if name == "Points":
            value = [App.Vector(*point) for point in value]
        elif isinstance(value, list):
            value = App.Vector(*value)
        if name:
            setattr(obj, name, value)


def _source(doc, design):
    """A feature with the shape of [curve] source, a file beside the design; None if not given."""
    name = design.get("curve", "source")
    if name is None:
        return None
    path = design.path.parent / name
    where = f"{design.path}: [curve] source {name}"
    known = (*_SHAPES, *_DRAWINGS)
    if path.suffix.lower() not in known:
        raise DesignError(f"{where} is no shape file; give one of {', '.join(known)}.")
    if not path.is_file():
        raise DesignError(f"{where} is not there; give a path as seen from the design file.")
    shape = Part.Shape()
    if path.suffix.lower() in _DRAWINGS:
        try:
            shape = imports.curve_wire(path)
        except ValueError as error:
            raise DesignError(f"{where}: {error}") from error
    else:
        with contextlib.suppress(Part.OCCError, OSError, ValueError):
            shape = Part.read(str(path))
    if shape.isNull() or not shape.Edges:
        raise DesignError(f"{where} has no edge that can be read; export the curve again.")
    feature = doc.addObject("Part::Feature", "Source")
    feature.Label = path.stem
    feature.Shape = shape
    return feature


def _in_words_of_the_file(design, table, sentence):
    """What an object refuses, as a sentence about the file."""
    return f"{design.path}: [{table}] {_with_keys(design, table, sentence).rstrip('.')}."


def _with_keys(design, table, sentence):
    """A sentence with keys of the file for properties of the object."""
    others = [name for name in TABLES if name in _relevant(design)]

    def key(match):
        for home in (table, *others):
            found = key_of_property(home, match[0])
            single_only = home == "unit" and found in SINGLE_UNIT and "curve" in design.tables
            if found and not single_only:
                return found if home == table else f"[{home}] {found}"
        return match[0]

    names = sorted({e.property for keys in TABLES.values() for e in keys.values() if e.property})
    return re.sub(rf"\b({'|'.join(names)})\b", key, sentence)


def _relevant(design):
    """Tables whose keys may cure what an object of the design refuses."""
    if "curve" in design.tables:
        return {"curve", "triangles", "unit", "hinges"}
    return {"unit", "hinges"} if design.makes_unit else {"coupon"}


def _summary(objects):
    told = []
    if "unit" in objects:
        unit = objects["unit"]
        count = len(unit.Alphas)
        told.append(f"{count} unit{'s' if count != 1 else ''}")
        told.append(f"isometry error {unit.IsometryError:.1e}")
    told += [f"{objects[t].BodyCount} bodies" for t in ("hinges", "coupon") if t in objects]
    return ", ".join(told)


def _prints(objects):
    """What `hinged` knows of the prints: {table: HingedTube or Coupon}."""
    kinds = {"hinges": hinged.HingedTube, "coupon": hinged.Coupon}
    return {table: kind(objects[table]) for table, kind in kinds.items() if table in objects}


def _exports(result, objects, progress):
    for obj, name, options in wanted_files(result.design, objects):
        path = result.folder / f"{result.design.stem}{name}"
        if _try(result, path.name, exporters.export, [obj], path, **options):
            progress(result.add(path).name)


def _save(result, doc, progress):
    path = result.folder / f"{result.design.stem}.FCStd"
    unfinished = path.with_name(f".{path.stem}.writing.FCStd")
    try:
        doc.saveCopy(str(unfinished))
        os.replace(unfinished, path)
    finally:
        unfinished.unlink(missing_ok=True)
    progress(result.add(path).name)


def _pictures(result, objects, prints, progress):
    pictures.require()

    def draw(name, caption, function, *args):
        path = result.folder / f"{result.design.stem}-{name}.png"
        result.pictures[caption] = result.add(function(path, *args))
        progress(path.name)

    for made in prints.values():
        made.draw(draw)
    if "unit" in objects:
        _draw_unit(objects, "hinges" not in prints, draw)


def _draw_unit(objects, states, draw):
    """Pictures of the zero-thickness tube; those of both ``states`` if they are wanted."""
    tube, sides = tube_of(objects["unit"]), None
    if "triangles" in objects:
        triangles = objects["triangles"]
        placed, geometry = place_along(triangles)
        sides = placed.sides
        gamma = math.radians(triangles.Gamma.Value)
        draw("plan", "The curve and its triangles, seen along the legs of the strips",
             pictures.top_view, placed, geometry.curve, gamma, geometry.sphere_radius)  # fmt: skip
    if states:
        draw("states", "The two stable states at one scale", pictures.both_states, tube)
    if len(tube) > 1:
        draw("angles", "Opening angle and ratio of every unit",
             pictures.angle_chart, tube.unit.theta, tube.unit.ratio, sides)  # fmt: skip


def _slice(result, hinge_set, progress):
    compared = slicing.compare(hinge_set, progress)
    facts = result.facts.prints["hinges"]
    facts.findings.extend(compared.findings)
    facts.sections.append(section(compared))


def _report(result, progress):
    path = result.folder / "report.html"
    report.write(path, [result])
    progress(result.add(path).name)


def _try(result, what, function, *args, **options):
    """Call ``function``; what goes wrong in a known way becomes a problem. True if it went well."""
    try:
        function(*args, **options)
    except (ValueError, OSError, pictures.NoMatplotlib) as error:
        result.problems.append(f"{what}: {error}")
        return False
    return True


@contextlib.contextmanager
def _document(design):
    doc = App.newDocument("Bistable", hidden=True)
    doc.Label = design.title
    try:
        yield doc
    finally:
        App.closeDocument(doc.Name)


@contextlib.contextmanager
def _quiet():
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
