# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all commands share: resources, one undo step, lines that a macro can replay headless."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import ICONS

translate = App.Qt.translate


def QT_TRANSLATE_NOOP(context, text):
    """Mark ``text`` for the translators; FreeCAD translates it when it is shown."""
    return text


class Command:
    """One command: a row of resources and ``run``.

    ``icon`` names a file of resources/icons; ``shortcut`` is a Qt key sequence. The translation
    context of ``text`` and ``tip`` is ``name``, as FreeCAD wants it.
    """

    name = ""
    icon = ""
    text = ""
    tip = ""
    shortcut = ""

    def GetResources(self):
        """Menu text, icon, tips and shortcut as FreeCAD asks for them."""
        resources = {
            "Pixmap": str(ICONS / f"{self.icon}.svg"),
            "MenuText": self.text,
            "ToolTip": self.tip,
            "StatusTip": self.tip,
        }
        return resources | ({"Accel": self.shortcut} if self.shortcut else {})

    def IsActive(self):
        """Always, unless a command says otherwise. Asked many times a second: keep it cheap."""
        return True

    def Activated(self, index=0):
        """FreeCAD's entry."""
        self.run()

    def run(self):
        """Do it."""
        raise NotImplementedError


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
        except Exception as error:
            doc.abortTransaction()
            if is_cancel(error):
                text = translate("Bistable", "{}: cancelled, the document is as it was.")
                App.Console.PrintMessage(text.format(self.title) + "\n")
            else:
                print_error(error, self.title)
            return
        doc.commitTransaction()
        for line in self.in_view:
            Gui.doCommandGui(line)


def print_error(reason, who=""):
    """Say in the report view, in the user's language, why something was refused: a sentence."""
    from ..taskpanels.sentences import clean, in_own_language

    App.Console.PrintError(f"{who}{': ' * bool(who)}{in_own_language(clean(str(reason)))}\n")


def is_cancel(error):
    """Whether an error is the user's Esc while a progress bar ran."""
    return isinstance(error, RuntimeError) and "abort" in str(error)


def fit_view(isometric=False):
    """Bring the whole document into view at once; on request seen from above at an angle."""
    view = Gui.ActiveDocument.ActiveView if Gui.ActiveDocument else None
    if not hasattr(view, "fitAll"):
        return
    animated = view.isAnimationEnabled()
    view.setAnimationEnabled(False)
    if isometric:
        view.viewIsometric()
    view.fitAll()
    view.setAnimationEnabled(animated)


def quoted(text):
    """``text`` as a Python string literal with double quotes."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


def by_name(obj):
    """The Python expression that names ``obj`` in a recorded line."""
    return f"doc.getObject({quoted(obj.Name)})"
