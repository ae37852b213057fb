#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings the .ts files up to date with the sources and makes the .qm files (with Qt's lrelease).

    python3 resources/translations/update.py

Texts are what the sources give to ``translate`` and ``QT_TRANSLATE_NOOP``, the property tables
(labels, groups, tooltips and choices), and the sentences of errors, warnings and findings (see
`sentences`). Translations are kept; what is new comes without one, and the script names it. Needs
no FreeCAD.
"""

import ast
import re
import runpy
import shutil
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import sentences  # noqa: E402  (beside this file, also where a test loads it)

PACKAGE = HERE.parent.parent / "BistableWB"
LANGUAGES = ("de",)
TABLES = "BistableProperty"
MARKERS = {"translate", "QT_TRANSLATE_NOOP"}
# Choices of enumerations, which the tables often take from elsewhere.
CHOICES = (
    "Adaptive", "Fixed", "TargetSnap", "Exact", "Paper", "Plane", "Sphere", "General", "Automatic",
    "Direction", "Viewpoint", "Rotational", "Flexible", "Cone", "Pin", "Flat", "OnEdge",
    "Dihedral", "Vertex", "NonDevelopableVertex", "Custom", "EndFit", "Steered", "Live", "OnDemand",
    "Start", "Both", "Free", "Square", "FDM, stand-offs", "FDM, ties", "FDM, soluble", "Powder",
    "Resin", "Dowel", "Clip", "Magnet", "Screw", "None", "Plain", "Plate", "Flange", "Foot",
    "Piano", "Textile", "Tape", "Contact", "Crease", "Recommended", "RecommendedVertex", "Given",
    "Coarse",
)  # fmt: skip
LABELS = ("BedWidth", "BedDepth", "BedHeight")  # preferences that are no properties
# Tooltips that are made of a table: (module, constant).
TIPS = (
    ("origami/hinges/kinds.py", "KINDS_TIP"),
    ("origami/curves/families.py", "KINDS_TIP"),
    ("origami/curves/families.py", "FOUND_TIP"),
)
KINDS = ("Contact panels", "Border panels", "Primary triangles", "Secondary triangles")


def label_of(name):
    """The same as `taskpanels.texts.label_of`, which needs FreeCAD."""
    words = re.findall(r"[A-Z]+(?![a-z])|[A-Z][a-z']*|\d+", name)
    return " ".join(
        [words[0], *(w if w.isupper() and len(w) > 1 else w.lower() for w in words[1:])]
    )


def messages():
    """Set of (context, text) in all sources."""
    found = {(TABLES, text) for text in (*CHOICES, *KINDS, *map(label_of, LABELS))}
    found |= {(TABLES, runpy.run_path(str(PACKAGE / path))[name]) for path, name in TIPS}
    found |= {(sentences.CONTEXT, text) for text in sentences.templates(PACKAGE)}
    for path in sorted(PACKAGE.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                found |= set(_of_call(node))
    return found


def _of_call(node):
    name = getattr(node.func, "attr", getattr(node.func, "id", ""))
    # None is what is no constant, as what is in TIPS
    texts = [arg.value if isinstance(arg, ast.Constant) else None for arg in node.args]
    if name in MARKERS and len(texts) == 2 and None not in texts:
        yield tuple(texts)
    elif name in ("Prop", "Result", "OfShape") and len(texts) >= 4 and None not in texts[:3]:
        for text in (label_of(texts[1]), texts[2], texts[3]):
            if text is not None:
                yield TABLES, text


def read(path):
    """{(context, text): translation} of a .ts file."""
    known = {}
    for context in ET.parse(path).getroot().iter("context") if path.exists() else ():
        for message in context.iter("message"):
            translation = message.findtext("translation")
            if translation:
                known[context.findtext("name"), message.findtext("source")] = translation
    return known


def write(path, language, wanted, known):
    """Write a .ts file, contexts and texts in alphabetical order."""
    root = ET.Element("TS", version="2.1", language=language, sourcelanguage="en")
    for name in sorted({context for context, _ in wanted}):
        context = ET.SubElement(root, "context")
        ET.SubElement(context, "name").text = name
        for text in sorted(text for where, text in wanted if where == name):
            message = ET.SubElement(context, "message")
            ET.SubElement(message, "source").text = text
            translation = ET.SubElement(message, "translation")
            if (name, text) in known:
                translation.text = known[name, text]
            else:
                translation.set("type", "unfinished")
    ET.indent(root, " ")
    body = ET.tostring(root, encoding="unicode")
    head = '<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n'
    path.write_text(f"{head}{body}\n", encoding="utf-8")


def main():
    """Update all languages; 1 if a text has no translation."""
    wanted, missing = messages(), 0
    for language in LANGUAGES:
        path = HERE / f"Bistable_{language}.ts"
        known = read(path)
        write(path, language, wanted, known)
        for context, text in sorted(wanted - set(known)):
            missing += 1
            print(f"{path.name}: {context}: {text}")
        if shutil.which("lrelease"):
            subprocess.run(
                ["lrelease", "-silent", path, "-qm", path.with_suffix(".qm")], check=True
            )
        else:
            print("lrelease is not installed: the .qm files stay as they are", file=sys.stderr)
    return int(missing > 0)


if __name__ == "__main__":
    sys.exit(main())
