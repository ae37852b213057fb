# SPDX-License-Identifier: LGPL-2.1-or-later
"""XML of other programs: any encoding, entities that are harmless, nothing that explodes."""

import codecs
import gzip
import re
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path
from xml.parsers import expat

from ..origami.errors import Refusal

_MOST = 100_000_000  # bytes of an unpacked drawing
_MOST_EXPANDED = 2_000_000  # characters that all entities of a file may become
_BOMS = (
    (codecs.BOM_UTF32_LE, "utf-32"), (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"), (codecs.BOM_UTF16_BE, "utf-16"),
    (b"<\0?\0", "utf-16-le"), (b"\0<\0?", "utf-16-be"), (b"<\0s\0", "utf-16-le"),
)  # fmt: skip
_DECLARED = re.compile(rb"<\?xml[^>]*?encoding\s*=\s*[\"']([A-Za-z][\w.\-]*)[\"']")
_PROLOG = re.compile(r"\s*<\?xml[^>]*\?>")
_REFERENCE = re.compile(r"&([^\s#&;]{1,80});")


def xml_root(path: Path) -> tuple[ElementTree.Element, str]:
    """The root of an XML file, and its text; `Refusal` where it is none, or a bomb."""
    text = _decoded(path, _content(path))
    _refuse_bombs(path, text)
    try:
        return ElementTree.fromstring(text), text
    except ElementTree.ParseError as error:
        raise Refusal(
            "{name} is not a whole SVG file ({error})", name=path.name, error=str(error),
            cure="save it again as plain SVG",
        ) from error  # fmt: skip


def _content(path):
    try:
        content = path.read_bytes()
        if content[:2] == b"\x1f\x8b":  # .svgz
            unpack = zlib.decompressobj(16 + zlib.MAX_WBITS)
            content = unpack.decompress(content, _MOST)
            if unpack.unconsumed_tail:
                raise Refusal("{name} unpacks to more than {size} MB", name=path.name,
                              size=_MOST // 10**6, cure="save it as plain SVG")  # fmt: skip
        return content
    except (OSError, EOFError, zlib.error, gzip.BadGzipFile) as error:
        raise Refusal("{name} cannot be read ({error})", name=path.name, error=str(error),
                      cure="check it, or save it again") from error  # fmt: skip


def _decoded(path, content):
    encoding = next((name for mark, name in _BOMS if content.startswith(mark)), None)
    if encoding is None:
        declared = _DECLARED.search(content[:1000])
        encoding = declared[1].decode() if declared else "utf-8"
    try:
        text = content.decode(encoding)
    except (UnicodeError, LookupError) as error:
        raise Refusal(
            "{name} is not a text file in the encoding that it names, {encoding}", name=path.name,
            encoding=encoding, cure="choose an SVG file, or save it again as plain SVG",
        ) from error  # fmt: skip
    return _PROLOG.sub("", text.lstrip("\ufeff"), count=1)


def _refuse_bombs(path, text):
    if "<!DOCTYPE" not in text or "<!ENTITY" not in text:
        return
    entities: dict[str, str] = {}

    def declared(name, is_parameter, value, *_):
        if value is not None and not is_parameter:
            entities[name] = value

    class Enough(Exception):
        pass

    def begun(*_):
        raise Enough

    parser = expat.ParserCreate()
    parser.EntityDeclHandler = declared
    parser.StartElementHandler = begun
    try:
        parser.Parse(text, True)
    except Enough:
        pass
    except expat.ExpatError:
        return  # the reader says so in its own words
    sizes: dict[str, int] = {}
    names = [name for name in _REFERENCE.findall(text) if name in entities]
    count = sum(_size(name, entities, (), sizes) for name in names)
    if count > _MOST_EXPANDED:
        raise Refusal(
            "{name} blows up when its entities are expanded, as files do that are made to do harm",
            name=path.name, cure="do not use it, or save the drawing again as plain SVG",
        )  # fmt: skip


def _size(name, entities, within, sizes):
    """Characters that an entity becomes; more than anybody may use where it holds itself."""
    if name in within or len(within) > 20:
        return _MOST_EXPANDED + 1
    if name not in sizes:
        inner = [other for other in _REFERENCE.findall(entities[name]) if other in entities]
        parts = (_size(other, entities, (*within, name), sizes) for other in inner)
        sizes[name] = min(len(entities[name]) + sum(parts), _MOST_EXPANDED + 1)
    return sizes[name]
