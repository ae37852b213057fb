# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading files, and text in whatever encoding a program wrote it."""

import codecs
from pathlib import Path

from ..origami.errors import Refusal

_BOMS = (
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
_CONTROLS = {chr(k) for k in range(32)} - set("\t\n\r\f\v\x1a")


def file_at(path) -> Path:
    """``path`` as a Path; `Refusal` where there is no such file."""
    path = Path(path)
    if not path.is_file():
        raise Refusal("There is no file {path}", path=str(path), cure="check its name and folder")
    return path


def content_of(path: Path) -> bytes:
    """Bytes of a file; `Refusal` where it cannot be read."""
    try:
        return file_at(path).read_bytes()
    except OSError as error:
        raise Refusal("{name} cannot be read ({error})", name=path.name, error=error.strerror,
                      cure="check it") from error  # fmt: skip


def text_of(path, kind: str) -> str:
    """Content of a text file in UTF-8; `Refusal` where it cannot be read or is no text."""
    try:
        return content_of(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise _no_text(path, kind) from error


def any_text_of(path: Path, kind: str) -> str:
    """Content of a text file as Windows or Unix programs write it: UTF-8, -16, -32, or cp1252."""
    content = content_of(path)
    encoding = next((name for mark, name in _BOMS if content.startswith(mark)), None)
    if encoding is None and content[:200].count(0) > len(content[:200]) / 4:
        encoding = "utf-16-be" if content[:1] == b"\0" else "utf-16-le"
    for name in (encoding,) if encoding else ("utf-8", "cp1252", "latin-1"):
        try:
            text = content.decode(name)
        except UnicodeDecodeError:
            continue
        if not _CONTROLS & set(text):
            return text
    raise _no_text(path, kind)


def _no_text(path, kind):
    return Refusal("{name} is not a text file", name=path.name, kind=kind,
                   cure="choose a {kind} file")  # fmt: skip
