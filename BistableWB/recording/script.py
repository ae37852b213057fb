# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that a macro can replay headless, executed as one undo step."""

import FreeCAD as App
import FreeCADGui as Gui

from ..origami.progress import Cancelled

translate = App.Qt.translate


class Script:
    """Python lines that are executed and recorded together: one undo step, one piece of a macro.

    ``with Script("New curve") as script: script.add("curve = make.make_curve(doc)")``. Nothing runs
    before the block ends; where a line fails, the document is as it was and the reason is in the
    report view.
    """

    def __init__(self, title):
        self.title = title
        self.lines = ["from BistableWB import make"]
        self.in_view = []
        self.done = False  # whether all lines ran
        if App.ActiveDocument is None:
            self.lines.append(f'doc = App.newDocument("{self._document_name()}")')
        else:
            self.lines.append("doc = App.ActiveDocument")

    @staticmethod
    def _document_name():
        return "BistableTube"

    def add(self, line):
        """A line for the document; it must run without a window too."""
        self.lines.append(line)

    def view(self, line):
        """A line for the window only: a macro keeps it as a comment."""
        self.in_view.append(line)

    def __enter__(self):
        return self

    def __exit__(self, kind, error, trace):
        if kind is None:
            self._execute()

    def _execute(self):
        head, rest = self.lines[:2], [*self.lines[2:], "doc.recompute()"]
        for line in head:
            Gui.doCommand(line)
        doc = App.ActiveDocument
        doc.openTransaction(self.title)
        try:
            for line in rest:
                Gui.doCommand(line)
        except Cancelled:
            doc.abortTransaction()
            text = translate("Bistable", "{}: cancelled, the document is as it was.")
            App.Console.PrintMessage(text.format(self.title) + "\n")
            return
        except Exception as error:
            doc.abortTransaction()
            print_error(error, self.title)
            return
        doc.commitTransaction()
        self.done = True
        for line in self.in_view:
            Gui.doCommandGui(line)


def print_error(reason, who=""):
    """Say in the report view, in the user's language, why something was refused.

    ``reason``: a `Refusal`, or another exception, which is said word by word.
    """
    from ..language.words import in_words

    App.Console.PrintError(f"{who}{': ' * bool(who)}{in_words(reason)}\n")


def quoted(text):
    """``text`` as a Python string literal with double quotes."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def by_name(obj):
    """The Python expression that names ``obj`` in a recorded line."""
    return f"doc.getObject({quoted(obj.Name)})"
