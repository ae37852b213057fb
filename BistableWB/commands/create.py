# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands that make objects: the chain Curve → TrianglePlacement → BistableUnit."""

import FreeCAD as App

from .. import settings
from ..scene import chosen
from .base import QT_TRANSLATE_NOOP, Command, Script, by_name, fit_view, quoted, translate

CURVE, TRIANGLES = "Bistable::Curve", "Bistable::TrianglePlacement"
_ON_SPHERE = [(-110, -30, 0), (-50, 75, 0), (50, -75, 0), (110, 30, 0)]


class NewTube(Command):
    """One click to a whole tube."""

    name = "Bistable_NewTube"
    icon = "NewTube"
    text = QT_TRANSLATE_NOOP("Bistable_NewTube", "New tube")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_NewTube",
        "Make an example curve with triangles and bistable units along it, ready to be changed",
    )
    shortcut = "O, N"

    def run(self):
        """Curve, triangles and units in one step, seen from above at an angle."""
        with Script(translate("Bistable_NewTube", "New tube")) as script:
            script.add("curve = make.make_curve(doc)")
            script.add("triangles = make.make_triangle_placement(doc, curve, **make.NEW_TUBE)")
            script.add("units = make.make_bistable_unit(doc, triangles)")
        fit_view(isometric=True)


class CurveCommand(Command):
    """A curve by points, or along what is selected."""

    name = "Bistable_Curve"
    icon = "Curve"
    text = QT_TRANSLATE_NOOP("Bistable_Curve", "Curve")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Curve",
        "Make a curve for a tube: along the selected sketch, wire or edges, else by example points",
    )
    shortcut = "O, C"

    def run(self):
        """Make the curve and show it."""
        with Script(translate("Bistable_Curve", "Curve")) as script:
            add_curve(script, chosen.edges())
            select(script, "curve")
        fit_view()


class CurveOnSphere(Command):
    """A curve on a sphere by points, or along what is selected."""

    name = "Bistable_CurveOnSphere"
    icon = "CurveOnSphere"
    text = QT_TRANSLATE_NOOP("Bistable_CurveOnSphere", "Curve on sphere")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_CurveOnSphere",
        "Make a curve on a sphere: the selected edges projected onto the selected sphere, "
        "else an example",
    )
    shortcut = "O, B"

    def run(self):
        """Make the curve on its sphere and show it."""
        with Script(translate("Bistable_CurveOnSphere", "Curve on sphere")) as script:
            add_curve_on_sphere(script, chosen.edges(), chosen.sphere())
            select(script, "curve")
        fit_view(isometric=True)  # from above the sphere hides that it is one


class TrianglePlacement(Command):
    """Triangles along a curve."""

    name = "Bistable_TrianglePlacement"
    icon = "TrianglePlacement"
    text = QT_TRANSLATE_NOOP("Bistable_TrianglePlacement", "Triangle placement")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_TrianglePlacement",
        "Place triangles along the selected curve, sketch, wire or edges: "
        "their angles are those of the units",
    )
    shortcut = "O, T"

    def IsActive(self):
        """With a curve, or something that can become one."""
        return has_curve()

    def run(self):
        """Place the triangles, on a new Curve where edges are selected."""
        with Script(translate("Bistable_TrianglePlacement", "Triangle placement")) as script:
            add_triangles(script)
            select(script, "triangles")
        fit_view()


class Units(Command):
    """Bistable units of a whole tube, or one by itself."""

    name = "Bistable_Units"
    icon = "BistableUnit"
    text = QT_TRANSLATE_NOOP("Bistable_Units", "Bistable units")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Units",
        "Make the bistable units of the selected triangle placement (or curve); "
        "where there is none, one unit by itself",
    )
    shortcut = "O, U"

    def run(self):
        """Make the units, and the triangles before them where those are missing."""
        triangles = chosen.of_type(TRIANGLES)
        with Script(translate("Bistable_Units", "Bistable units")) as script:
            if triangles is not None:
                script.add(f"triangles = {by_name(triangles)}")
            elif has_curve():
                add_triangles(script)
            else:
                script.add("triangles = None")
            script.add("units = make.make_bistable_unit(doc, triangles)")
            script.view("Gui.Selection.clearSelection()")  # green would hide the colours
        fit_view()


def has_curve():
    """Whether `add_triangles` has something to go along. Cheap."""
    return App.ActiveDocument is not None and bool(chosen.of_type(CURVE) or chosen.edges())


def add_curve(script, source):
    """Line for a plane curve; ``source`` as from `chosen.edges`."""
    if source is None:
        script.add("curve = make.make_curve(doc)")
    else:
        script.add(f"curve = make.make_curve(doc, source={_link(source)})")


def add_curve_on_sphere(script, source, ball):
    """Lines for a curve on a sphere; ``ball`` as from `chosen.sphere`, else an example."""
    what = f"points={_ON_SPHERE}" if source is None else f"source={_link(source)}"
    radius = ball[0] if ball else 150.0
    script.add(f'curve = make.make_curve(doc, {what}, kind="Sphere", sphere_radius={radius!r})')
    if ball and ball[1].Length:
        script.add(f"curve.SphereCenter = App.Vector{tuple(ball[1])}")


def add_triangles(script):
    """Lines for triangles along the chosen Curve, or along a new one on the selected edges."""
    curve = chosen.of_type(CURVE)
    if curve is None:
        add_curve(script, chosen.edges())
    else:
        script.add(f"curve = {by_name(curve)}")
    script.add(new_triangles())


def new_triangles():
    """Line for triangles along the curve in ``curve``, of a width that suits it and the printer."""
    bed = tuple(round(x, 6) for x in settings.bed())
    return f"triangles = make.make_triangle_placement(doc, curve, **make.new_tube(curve, {bed}))"


def select(script, variable):
    """Select what was made, so that the next command goes on from it."""
    script.view("Gui.Selection.clearSelection()")
    script.view(f"Gui.Selection.addSelection({variable})")


def _link(source):
    obj, names = source
    return f"({by_name(obj)}, [{', '.join(map(quoted, names))}])"
