# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves of an SVG, read to the specification as a browser shows it, at 96 dots an inch.

The picture's y points down, that of the document up: the x axis stays.
"""

import re
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ..origami.errors import Phrase, Refusal, phrase
from . import svg_shapes, svg_units
from .drawing import Read, Stroke
from .pieces import MAX_PIECES, Array
from .svg_style import Styled, StyleSheet, declarations
from .xml_text import xml_root

_SVG = "{http://www.w3.org/2000/svg}"
_INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
_XLINK = "{http://www.w3.org/1999/xlink}"
_DEEPEST = 150  # groups in groups
_MOST = 10_000  # elements that are drawn
_GROUPS = {"g", "a", "svg", "switch"}
_TEXTS = {
    "text": phrase("text"), "image": phrase("picture"), "foreignObject": phrase("foreign content"),
}  # fmt: skip
_INHERITED = ("visibility", "fill", "stroke")


class _Place(NamedTuple):
    """Where an element stands: what it inherits."""

    matrix: Array
    view: tuple
    layer: str
    styled: Styled | None
    style: dict
    depth: int
    used: tuple = ()


def read_svg(path: Path, scale: float | None = None) -> Read:
    """Strokes of an SVG in mm; ``scale``: given by the user, who knows the size then."""
    root, text = xml_root(path)
    if _name(root) != "svg":
        raise Refusal("{name} is not an SVG file", name=path.name,
                      cure="choose one, or another suffix")  # fmt: skip
    return _Reader(path, root, text, scale).read


class _Reader:
    def __init__(self, path, root, text, scale):
        self.path = path
        self.read = Read([], "px", phrase(""))
        self.ids = {}
        for element in root.iter():
            if element.get("id"):
                self.ids.setdefault(element.get("id"), element)
        styles = [e.text or "" for e in root.iter() if _name(e) == "style"]
        self.sheet = StyleSheet(styles)
        self.layered = any(e.get(f"{_INKSCAPE}groupmode") == "layer" for e in root.iter())
        self.drawn = self.count = 0
        self.unseen: list[Stroke] = []
        width, height = self._size(root, text, scale)
        flip = np.diag([svg_units.PIXEL, -svg_units.PIXEL, 1.0, 1.0])
        place = _Place(flip, (width, height), "", None, {}, 0)
        self._element(root, place, viewport=(0.0, 0.0, width, height))
        self._unseen()

    def _unseen(self):
        """Shapes with neither stroke nor fill count only where the drawing has no others."""
        if self.unseen and self.read.strokes:
            self.read.left_out[phrase("shape"), phrase("neither stroke nor fill")] += len(
                self.unseen
            )
        elif self.unseen:
            self.read.strokes = self.unseen
            self.read.notes.append(phrase("the shapes have neither stroke nor fill"))

    def _size(self, root, text, scale):
        """Width and height of the picture in pixels, and its unit for the receipt."""
        box = _box(root, self.path)
        sizes = []
        for name in ("width", "height"):
            given = root.get(name, "auto").strip()
            if given in ("auto", "") or (given == "100%"):
                sizes.append(None)
            elif given.endswith("%") or given.lower().endswith(("vw", "vh")):
                raise Refusal(
                    "{file}: its {name} is {given} of a window, which has no size in mm",
                    file=self.path.name, name=name, given=given,
                    cure="give the document a size in mm in the drawing program",
                )  # fmt: skip
            else:
                sizes.append(svg_units.length(given, 0.0, f"{self.path.name}: {name}"))
                self.read.unit = svg_units.unit_of(given) or "px"
        self._tell_unit(root, text, box, sizes, scale)
        if box is None:
            return sizes[0] or 300.0, sizes[1] or 150.0
        width, height = sizes
        if width is None and height is None:
            return box[2], box[3]
        if width is None:
            return height * box[2] / box[3], height
        return width, width * box[3] / box[2] if height is None else height

    def _tell_unit(self, root, text, box, sizes, scale):
        told = any(size is not None for size in sizes)
        if box is not None and told:
            self.read.source = phrase("width, height and viewBox of the picture")
        elif told:
            self.read.unit, self.read.source = "px", phrase("no viewBox: 96 px an inch")
        else:
            self.read.source = phrase("no size given: 96 px an inch")
        version = re.match(r"0\.(\d+)", root.get(f"{_INKSCAPE}version", ""))
        old = version is not None and int(version[1][:2]) < 92
        if old and (box is None or not told or self.read.unit == "px") and scale is None:
            raise Refusal(
                "{file} was drawn by Inkscape {version}, whose pixel is 1/90 inch, and gives no "
                "size in mm: read as today, at 96 px an inch, it would be 6 % too small",
                file=self.path.name, version=root.get(f"{_INKSCAPE}version").split()[0],
                parameter="scale",
                cure="open it in Inkscape of today and let it convert the file, or give a scale "
                     "(1.0667 for 90 px an inch, 1 for 96)",
            )  # fmt: skip
        if "Adobe Illustrator" in text[:2000] and self.read.unit == "px":
            self.read.notes.append(
                phrase("Illustrator draws in points: if the size is too small, the scale is 1.3333")
            )

    def _element(self, element, place, viewport=None):
        name = _name(element)
        if name is None or (name not in _GROUPS and name not in _DRAWN and name not in _TEXTS):
            return
        self._count(place)
        styled = Styled(name, element.get("id", ""), frozenset(element.get("class", "").split()),
                        place.styled)  # fmt: skip
        style = self._style(element, styled, place.style)
        if style.get("display") == "none" or _is_zero(style.get("opacity", "1")):
            what = phrase("group") if name in _GROUPS else phrase("shape")
            self.read.left_out[what, phrase("not displayed")] += 1
            return
        matrix = place.matrix @ svg_units.transform(
            style.get("transform", ""), place.view, style.get("transform-origin", "")
        )
        here = place._replace(matrix=matrix, styled=styled, style=style, depth=place.depth + 1,
                              layer=self._layer(element, name, place))  # fmt: skip
        if name == "use":
            self._use(element, here)
        elif name in _GROUPS:
            self._group(element, name, here, viewport)
        elif name in _TEXTS:
            self.read.left_out[_TEXTS[name], phrase("no path: convert it to one")] += 1
        else:
            self._shape(element, name, here)

    def _count(self, place):
        self.drawn += 1
        if place.depth > _DEEPEST:
            raise Refusal("{name} has groups in groups, more than {most} deep", name=self.path.name,
                          most=_DEEPEST, cure="ungroup the curve")  # fmt: skip
        if self.drawn > _MOST:
            raise Refusal(
                "{name} draws more than {most} shapes", name=self.path.name, most=_MOST,
                cure="save the one curve by itself",
            )  # fmt: skip

    def _style(self, element, styled, inherited):
        """All properties of an element: attributes, then the style sheet, then its own style."""
        style = {key: inherited[key] for key in _INHERITED if key in inherited}
        style |= {key: value.strip() for key, value in element.attrib.items()}
        style |= self.sheet.of(styled)
        if "style" in element.attrib:
            style |= declarations(element.get("style"))
        for key in _INHERITED:
            if style.get(key) == "inherit" and key in inherited:
                style[key] = inherited[key]
        return style

    def _layer(self, element, name, place):
        if name != "g":
            return place.layer
        if self.layered:
            if element.get(f"{_INKSCAPE}groupmode") == "layer":
                return element.get(f"{_INKSCAPE}label") or element.get("id", "")
            return place.layer
        return place.layer or element.get("id", "")

    def _group(self, element, name, place, viewport):
        if name == "svg":
            place = self._viewport(element, place, viewport)
        children = list(element)
        if name == "switch":
            children = [child for child in children if _is_for_us(child)][:1]
        for child in children:
            self._element(child, place)

    def _viewport(self, element, place, viewport):
        """What holds inside an ``svg`` or a symbol: a new viewport, and its view box."""
        box = _box(element, self.path)
        if viewport is None:
            x, y = (svg_units.length(element.get(key, "0"), whole, key)
                    for key, whole in zip("xy", place.view, strict=True))  # fmt: skip
            width, height = (
                svg_units.length(_auto(place.style.get(key)), whole, key)
                for key, whole in zip(("width", "height"), place.view, strict=True)
            )
        else:
            x, y, width, height = viewport
        matrix = place.matrix @ svg_units.move(x, y)
        if box is None:
            return place._replace(matrix=matrix, view=(width, height))
        aspect = element.get("preserveAspectRatio", "")
        matrix = matrix @ svg_units.fitted(box, width, height, aspect)
        return place._replace(matrix=matrix, view=(box[2], box[3]))

    def _use(self, element, place):
        reference = element.get("href") or element.get(f"{_XLINK}href") or ""
        target = self.ids.get(reference.strip().removeprefix("#"))
        if not reference.strip().startswith("#") or target is None:
            self.read.left_out[phrase("use"), phrase("its original is not in the file")] += 1
            return
        if reference in place.used:
            raise Refusal("{file}: the clone of {name} holds itself", file=self.path.name,
                          name=reference, cure="unlink the clone")  # fmt: skip
        x, y = (svg_units.length(element.get(key, "0"), whole, key)
                for key, whole in zip("xy", place.view, strict=True))  # fmt: skip
        place = place._replace(matrix=place.matrix @ svg_units.move(x, y),
                               used=(*place.used, reference))  # fmt: skip
        if _name(target) not in ("symbol", "svg"):
            self._element(target, place)
            return
        sizes = [
            svg_units.length(_auto(element.get(key) or target.get(key)), whole, key)
            for key, whole in zip(("width", "height"), place.view, strict=True)
        ]
        styled = Styled(_name(target), target.get("id", ""), frozenset(), place.styled)
        style = self._style(target, styled, place.style)
        if style.get("display") == "none":
            return
        inner = self._viewport(target, place._replace(style=style), (0.0, 0.0, *sizes))
        for child in target:
            self._element(child, inner)

    def _shape(self, element, name, place):
        style = place.style
        if style.get("visibility") in ("hidden", "collapse"):
            self.read.left_out[phrase("shape"), phrase("hidden")] += 1
            return
        unseen = style.get("fill") == "none" and style.get("stroke", "none") in ("none", "")
        strokes = self.unseen if unseen else self.read.strokes
        where = f"{self.path.name}: {name} {element.get('id', '')}".rstrip()
        for pieces, complete in svg_shapes.SHAPES[name](style, place.view, where):
            if not complete:
                self.read.notes.append(_broken_off(name, element))
            self.count += len(pieces)
            if self.count > MAX_PIECES:
                raise Refusal("{name} has more than {most} pieces of curves", name=self.path.name,
                              most=MAX_PIECES, cure="save the one curve by itself")  # fmt: skip
            if pieces:
                mapped = [piece.mapped(place.matrix) for piece in pieces]
                strokes.append(Stroke(mapped, place.layer))


_DRAWN = {*svg_shapes.SHAPES, "use"}


def _broken_off(name: str, element) -> Phrase:
    return phrase("the {name} {id} has an error and is read up to it, as a browser does",
                  name=name, id=element.get("id", ""))  # fmt: skip


def _name(element):
    """Local name of an SVG element (also of one without any name space), else None."""
    tag = element.tag
    if not isinstance(tag, str):
        return None
    if tag.startswith(_SVG):
        return tag[len(_SVG) :]
    return None if tag.startswith("{") else tag


def _auto(given):
    return "100%" if given in (None, "", "auto") else given


def _is_zero(text):
    try:
        return float(text.rstrip("%")) == 0
    except ValueError:
        return False


def _is_for_us(element):
    """Whether a ``switch`` may show this child: it needs no extension and no other language."""
    languages = element.get("systemLanguage")
    return (
        _name(element) is not None
        and not element.get("requiredExtensions")
        and (languages is None or any(x.strip().startswith("en") for x in languages.split(",")))
    )


def _box(element, path):
    given = element.get("viewBox")
    if given is None:
        return None
    box = svg_units.numbers(given)
    if len(box) != 4 or not all(np.isfinite(box)) or box[2] <= 0 or box[3] <= 0:
        raise Refusal(
            "{file}: the viewBox “{given}” is not x, y, and a width and a height above 0",
            file=path.name, given=given[:40], cure="set the page size again and save it",
        )  # fmt: skip
    return box
