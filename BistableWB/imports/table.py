# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points out of tables, as spreadsheets and instruments write them: one point a row."""

import csv
import re
from collections import Counter
from pathlib import Path

import numpy as np

from ..origami.errors import Phrase, Refusal, phrase
from .drawing import MAX_POINTS, Read, Stroke
from .pieces import Array
from .splines import through
from .table_columns import Columns, columns_of, no_length, unit_in, unit_said
from .table_numbers import UNITS, decimal_mark, split_cell, value_of
from .text import any_text_of, file_at

_LONGEST = 4_000  # characters of a line
_MOST_LINES = 20_000  # some of which may be no points
_LARGEST = 1e7  # mm: a curve that is larger is not told in the unit that it was read in
_ERROR = r"#(?:[A-ZÄÖÜ]+[!?]|N/?[AV]\b|DIV/0!)"  # what a spreadsheet writes for a value it has not
_COMMENT = re.compile(rf"\s*(?:(?!{_ERROR})#|%|//|!|\*|--|REM\b|;)", re.IGNORECASE)
_TAIL = re.compile(rf"\s*(?:(?!{_ERROR})#|//|%).*$")
_NEGATIVE = re.compile(r"\((\d[\d.,]*)\)")  # as accountants write it
_ON_EARTH = re.compile(r"[NSEW] ?\d+\.\d+|\d ?°")
_BRACKETS = str.maketrans(dict.fromkeys("(){}[]<>"))
_COMMA_NUMBER = re.compile(r"[+-]?\d+(?:,\d+)?(?:[eE][+-]?\d+)?")


class _Table:
    """Lines of a file as rows of cells: ``heads`` above the first point, ``rows`` (line, cells)."""

    def __init__(self, text: str, where: str):
        self.where = where
        lines = list(enumerate(text.replace("\x1a", "").splitlines(), 1))
        long = next((n for n, line in lines if len(line) > _LONGEST), None)
        if long is not None:
            raise Refusal(
                "{name}, line {line} is longer than {most} characters: it is no table of points",
                name=where, line=long, most=_LONGEST, cure="give one point a row",
            )  # fmt: skip
        self.notes: list[Phrase] = []
        self.said = unit_said([line for _, line in lines[:50] if not _is_data(line)], where)
        separator = None
        if lines and (match := re.fullmatch(r'"?sep=(.)"?\s*', lines[0][1], re.IGNORECASE)):
            separator, lines = match[1], lines[1:]
        lines = [(n, line) for n, line in lines if line.strip(" \t;,|")]
        lines = [(n, line) for n, line in lines if not _COMMENT.match(line)]
        if len(lines) > _MOST_LINES:
            raise _too_many(where, len(lines))
        data = [line for _, line in lines if _is_data(line)]
        split = _splitter(data, separator)
        cells = [(n, [c.strip().strip("\"'") for c in split(line)]) for n, line in lines]
        first = next((k for k, (_, row) in enumerate(cells) if _is_point(row)), len(cells))
        self.heads = [row for _, row in cells[:first]]
        self.rows = [(n, [_plain(c) for c in row]) for n, row in cells[first:]]
        self.said = self.said or self._unit_column()
        if not self.rows and _ON_EARTH.search(text):
            raise no_length(where, "°")

    def _unit_column(self):
        """The unit that a column of the table repeats in every row, or ""."""
        for head in self.heads:
            for k, name in enumerate(head):
                if name.lower() in ("unit", "units", "einheit"):
                    units = {row[k].lower() for _, row in self.rows if k < len(row)}
                    if len(units) == 1 and (unit := units.pop()) in UNITS:
                        return unit
                    raise Refusal("{where} has rows in several units, or in one that is not known",
                                  where=self.where, cure="convert them all to mm")  # fmt: skip
        return ""


def read_table(path: Path) -> Read:
    """The smooth curve through the points of a table, in mm."""
    points, read = _points(path)
    read.strokes = [Stroke([through(points)], smooth=True)]
    return read


def table_points(path) -> list[tuple[float, float, float]]:
    """Points [(x, y, z)] in mm of a table, one a row; two columns lie in the plane z = 0.

    Between columns: commas, semicolons, tabs, bars or blanks. Lines that begin with #, %, // are
    skipped. A head names columns and units: x, y, z are found in any order, others are left out.
    """
    return [tuple(point) for point in _points(file_at(path))[0].tolist()]


def _points(path) -> tuple[Array, Read]:
    table = _Table(any_text_of(path, "CSV"), path.name)
    columns = columns_of(table.heads, table.said, path.name)
    rows = table.rows
    if columns is None:
        columns = _by_place(table, path)
    points, ordered = _values(rows, columns, path)
    read = Read([], columns.unit or "mm", _source(columns), Counter(), table.notes)
    points = _different(points, read) if len(points) else points
    if len(points) < 2:
        raise Refusal(
            "{name} has {count} different points", name=path.name, count=len(points),
            cure="give one point a row, x, y and perhaps z in mm, two rows or more",
        )  # fmt: skip
    if ordered:
        read.notes.append(phrase("the rows are sorted by the column {name}", name=ordered))
    if len(points) > MAX_POINTS:
        raise _too_many(path.name, len(points))
    return points, read


def _too_many(name, count):
    return Refusal(
        "{name} has {count} points, more than {most}", name=name, count=count, most=MAX_POINTS,
        step=-(-count // 1000), cure="keep every {step}th row: a tube follows a smooth curve",
    )  # fmt: skip


def _source(columns):
    if columns.unit:
        return phrase("the head of the table")
    return phrase("no unit given: taken as mm")


def _by_place(table, path):
    """Columns of a table without names for them: by their number, perhaps with one that counts."""
    widths = Counter(len(_trimmed(row)) for _, row in table.rows)
    width = widths.most_common(1)[0][0] if widths else 2
    first = [value_of(c[0], ".") if (c := split_cell(row[0])) else None for _, row in table.rows]
    counts = len(first) > 1 and first in (
        [float(k) for k in range(len(first))],
        [float(k) for k in range(1, len(first) + 1)],
    )
    last = {cells[-1] for _, row in table.rows if (cells := _trimmed(row))}
    flat = width == 3 and len(last) == 1
    named = len(first) > 1 and not any(split_cell(row[0]) for _, row in table.rows)
    skip = int((counts and width in (3, 4) and not flat) or (named and width in (3, 4)))
    if skip:
        table.notes.append(phrase("the first column only names or counts the rows and is left out"))
    places = [skip + k if skip + k < max(width, 2) else None for k in range(3)]
    head = table.heads[-1] if table.heads else []
    units = [unit_in(head[p], path.name) if p is not None and p < len(head) else "" for p in places]
    units = [unit or table.said for unit in units]
    factors = [UNITS[unit] if unit else 1.0 for unit in units]
    columns = Columns(places, factors, None, next((u for u in units if u), ""))
    _refuse_widths(table.rows, width, skip, path)
    return columns


def _refuse_widths(rows, width, skip, path):
    for line, row in rows:
        count = len(_trimmed(row))
        if count == width and count - skip in (2, 3):
            continue
        raise Refusal(
            "{name}, line {line}: {count} columns", name=path.name, line=line, count=count,
            cure="give x, y or x, y, z (with a semicolon between them where numbers have commas), "
                 "or name the columns in the first row",
        )  # fmt: skip


def _values(rows, columns, path):
    """Points (n, 3) in mm, sorted where there is a column for that (then also its name)."""
    used = [place for place in columns.places if place is not None]
    cells = [(n, [_cell(row, p, n, path) for p in used]) for n, row in rows]
    mark = decimal_mark([text for _, row in cells for text, _ in row], path.name)
    points = np.zeros((len(cells), 3))
    axes = [axis for axis in range(3) if columns.places[axis] is not None]
    for k, (n, row) in enumerate(cells):
        for axis, (text, unit) in zip(axes, row, strict=True):
            value = value_of(text, mark)
            if value is None:
                raise _no_coordinate(path, n, text)
            points[k, axis] = value * (unit or columns.factors[axis])
    _refuse_far(points, rows, path)
    if columns.order is None:
        return points, ""
    keys = [split_cell(row[columns.order]) if columns.order < len(row) else None for _, row in rows]
    if None in keys:
        return points, ""
    order = np.argsort([value_of(key[0], mark) or 0.0 for key in keys], kind="stable")
    return points[order], "order" if (np.diff(order) < 0).any() else ""


def _cell(row, place, line, path):
    cell = row[place] if place < len(row) else ""
    found = split_cell(cell)
    if found is None:
        raise _no_coordinate(path, line, cell)
    return found


def _no_coordinate(path, line, cell):
    return Refusal(
        "{name}, line {line}: {cell} is not a coordinate in mm", name=path.name, line=line,
        cell=repr(cell[:20]), cure="correct it",
    )  # fmt: skip


def _refuse_far(points, rows, path):
    if not len(points):
        return
    away = np.abs(points - np.sort(points, axis=0)[(len(points) - 1) // 2]).max(1)
    k = int(np.argmax(away))
    if away[k] > _LARGEST:
        raise Refusal(
            "{name}, line {line}: the point lies {away:.3g} mm from the others, which is not a "
            "coordinate in mm", name=path.name, line=rows[k][0], away=float(away[k]),
            cure="correct it, or the unit in the head of the table",
        )  # fmt: skip


def _different(points, read):
    """Points without repetitions; `Refusal` where the last is the first again."""
    new = [0, *(np.flatnonzero(np.abs(np.diff(points, axis=0)).max(1) > 0) + 1).tolist()]
    points = points[new]
    if len(points) > 3 and (points[0] == points[-1]).all():
        raise Refusal(
            "The last row of the table is its first point again: the curve closes, and a closed "
            "tube cannot be folded flat", cure="remove the last rows, so that a gap stays open",
        )  # fmt: skip
    _, first = np.unique(points, axis=0, return_index=True)
    if len(first) < len(points):
        count = len(points) - len(first)
        read.notes.append(phrase("{count} points that were there before are left out", count=count))
    return points[np.sort(first)]


def _plain(cell):
    return _NEGATIVE.sub(r"-\1", cell).translate(_BRACKETS).strip()


def _is_data(line):
    words = re.split(r"[;\t|,\s]+", line.translate(_BRACKETS).strip())
    return sum(split_cell(word.strip("\"'")) is not None for word in words if word) >= 2


def _is_point(row):
    return sum(split_cell(cell.translate(_BRACKETS)) is not None for cell in row if cell) >= 2


def _trimmed(row):
    while row and not row[-1]:
        row = row[:-1]
    return row


def _splitter(lines, separator):
    """A function that splits a line into cells."""
    for mark in (separator,) if separator else (";", "\t", "|"):
        if separator or (lines and sum(mark in line for line in lines) > len(lines) / 2):
            return lambda text: next(csv.reader([_TAIL.sub("", text)], delimiter=mark))
    words = [line.translate(_BRACKETS).split() for line in lines]
    blanks = all(len(w) > 1 and all(map(_COMMA_NUMBER.fullmatch, w)) for w in words) if words else 0
    if not blanks and any("," in line for line in lines):
        return lambda text: next(csv.reader([_TAIL.sub("", text)], skipinitialspace=True))
    return lambda text: _TAIL.sub("", text).split()
