# SPDX-License-Identifier: LGPL-2.1-or-later
"""Charts of a tube in a dock."""

import FreeCAD as App

from .base import QT_TRANSLATE_NOOP, Command
from .motion import moving_object


class Plots(Command):
    """Show or hide the dock."""

    name = "Bistable_Plots"
    icon = "Plots"
    text = QT_TRANSLATE_NOOP("Bistable_Plots", "Tube charts")
    tip = QT_TRANSLATE_NOOP(
        "Bistable_Plots",
        "Show opening angles, ratios, snap margins and energies of all units; click a bar to see "
        "its unit",
    )
    shortcut = "O, L"

    def IsActive(self):
        """With a document."""
        return App.ActiveDocument is not None

    def run(self):
        """Show the dock for the selected tube, or hide it."""
        from ..taskpanels.plots import dock

        charts = dock()
        if charts.isVisible():
            charts.hide()
            return
        charts.show()
        charts.raise_()
        charts.show_tube(moving_object())
