# SPDX-License-Identifier: LGPL-2.1-or-later
"""Coin nodes shown in place of document objects, as long as a panel is open."""

from pivy import coin


class StandIn:
    """Shows ``root`` in a 3D view and hides ``objects`` there, until `end`; documents know nothing.

    A view without a scene (a spreadsheet, say) stays as it is.
    """

    def __init__(self, view, root, objects):
        self._scene = view.getSceneGraph() if hasattr(view, "getSceneGraph") else None
        self._root, self._hidden = root, []
        if self._scene is None:
            return
        self._scene.addChild(root)
        for obj in objects:
            for switch in _switches(obj.ViewObject):
                self._hidden.append((switch, switch.whichChild.getValue()))
                switch.whichChild = coin.SO_SWITCH_NONE

    def end(self):
        """Bring the view back to what it was."""
        if self._scene is not None:
            self._scene.removeChild(self._root)
        for switch, child in self._hidden:
            switch.whichChild = child
        self._scene, self._hidden = None, []


def _switches(view_object):
    """FreeCAD's own switch, and that of lines which are drawn over everything."""
    yield view_object.SwitchNode
    overlay = getattr(view_object.Proxy, "switch", None)
    if overlay is not None:
        yield overlay
