# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading files, and points out of text tables."""

import csv
import math
from pathlib import Path

_LARGEST = 1e6  # mm: a coordinate beyond this is no length in millimetres
_AXES = ("x", "y", "z")


def file_at(path):
    """``path`` as a Path; ValueError where there is no such file."""
    path = Path(path)
    if not path.is_file():
        raise ValueError(f"There is no file {path}: check its name and folder.")
    return path


def text_of(path, kind):
    """Content of a text file; ValueError where it cannot be read or is no text."""
    try:
        return file_at(path).read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(f"{path.name} is not a text file: choose a {kind} file.") from error
    except OSError as error:
        raise ValueError(f"{path.name} cannot be read ({error.strerror}): check it.") from error


def table_points(path):
    """Points [(x, y, z)] of a CSV table, one a row; two columns lie in the plane z = 0.

    Commas, semicolons (then decimal commas are allowed), tabs or blanks between columns; lines that
    begin with # are skipped. A first row of names is allowed: columns x, y, z are then found by
    their names, in any order, others are left out.
    """
    path = file_at(path)
    lines = text_of(path, "CSV").splitlines()
    rows = [(i, line) for i, line in enumerate(lines, 1) if line.strip(" \t;,")]
    rows = [(i, line) for i, line in rows if not line.lstrip().startswith("#")]
    split = _splitter(rows[0][1]) if rows else None
    cells = [(i, split(line)) for i, line in rows]
    columns = None
    if cells and _is_header(cells[0][1]):
        columns = _named_columns(cells.pop(0)[1], path)
    points = [_point(row, columns, i, path) for i, row in cells]
    points = [p for k, p in enumerate(points) if k == 0 or p != points[k - 1]]
    if len(points) < 2:
        raise ValueError(
            f"{path.name} has {len(points)} different points: give one point a row, x, y and "
            "perhaps z in mm, two rows or more."
        )
    return points


def _splitter(line):
    if ";" in line:
        return lambda text: [c.strip().replace(",", ".") for c in text.split(";")]
    if "," in line:
        return lambda text: [c.strip() for c in next(csv.reader([text]))]
    return str.split


def _is_header(cells):
    return not any(_number(cell) is not None for cell in cells if cell)


def _named_columns(cells, path):
    names = [cell.strip("\"' ").lower() for cell in cells]
    plain = [name.split("(")[0].split("[")[0].split("/")[0].strip() for name in names]
    if not {"x", "y"} <= set(plain):
        return None
    for axis in _AXES:
        unit = next((n for n, p in zip(names, plain, strict=True) if p == axis), "")
        if any(other in unit for other in ("(m)", "[m]", "(cm)", "[cm]", "(in)", "[in]")):
            raise ValueError(f"{path.name} is not in mm (column {unit!r}): convert it to mm first.")
    return [plain.index(axis) for axis in _AXES if axis in plain]


def _point(row, columns, line, path):
    while row and not row[-1]:
        row = row[:-1]
    if columns is not None:
        row = [row[c] if c < len(row) else "" for c in columns]
    if len(row) not in (2, 3):
        raise ValueError(
            f"{path.name}, line {line}: {len(row)} columns; give x, y or x, y, z, or name the "
            "columns in the first row."
        )
    values = [_number(cell) for cell in row]
    for cell, value in zip(row, values, strict=True):
        if value is None or not abs(value) < _LARGEST:
            raise ValueError(
                f"{path.name}, line {line}: {cell[:20]!r} is not a coordinate in mm: correct it."
            )
    return (*values, 0.0)[:3]


def _number(cell):
    try:
        value = float(cell)
    except ValueError:
        return None
    return value if math.isfinite(value) else None
