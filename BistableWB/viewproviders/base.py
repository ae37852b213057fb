# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all view providers share."""

import FreeCAD as App
import FreeCADGui as Gui

from .. import ICONS, hooks


class BistableView:
    """Icon from the type of the object, inputs claimed in the tree. Nothing of it is saved.

    Subclasses give ``LOOK``: view properties of a new object, which are the user's afterwards.
    """

    LOOK: dict = {}

    def __init__(self, view_object):
        view_object.Proxy = self
        if not hasattr(self, "ViewObject"):  # a repaired one: FreeCAD attaches only the first proxy
            self.attach(view_object)
        for name, value in self.LOOK.items():
            setattr(view_object, name, value)

    def attach(self, view_object):
        """Made or restored: keep the way back to the object."""
        self.ViewObject = view_object

    def updateData(self, obj, name):
        """Follow a change of the object, once attached: FreeCAD may tell of it before."""
        if name == "Shape" and hasattr(self, "ViewObject"):
            self.refresh(obj)

    def refresh(self, obj):
        """Follow the object's shape; nothing to do here."""

    def onChanged(self, view_object, name):
        """Follow a change of a view property; nothing to do here."""

    def icon_name(self, obj):
        """Name of the icon: the type's, or another where the object has several looks."""
        return obj.BistableType.removeprefix("Bistable::")

    def getIcon(self):
        """Path of the icon, found anew each time: a saved path would be somebody else's."""
        icon = ICONS / f"{self.icon_name(self.ViewObject.Object)}.svg"
        return str(icon if icon.exists() else ICONS / "BistableWorkbench.svg")

    def claimChildren(self):
        """Put the inputs of an object below it: what is linked as a whole, not by elements."""
        obj = getattr(getattr(self, "ViewObject", None), "Object", None)
        claimed = []
        for name in obj.PropertiesList if obj else ():
            kind = obj.getTypeIdOfProperty(name)
            if kind == "App::PropertyLink" and getattr(obj, name):
                claimed.append(getattr(obj, name))
            elif kind == "App::PropertyLinkSub" and getattr(obj, name):
                target, elements = getattr(obj, name)
                if not any(elements):
                    claimed.append(target)
        return claimed

    def doubleClicked(self, view_object):
        """Edit the object in its panel."""
        Gui.getDocument(view_object.Object.Document.Name).setEdit(view_object.Object.Name)
        return True

    def setEdit(self, view_object, mode):
        """Open the panel; other modes (transform, colours) are FreeCAD's own."""
        if mode != 0:
            return None
        return hooks.panels().open_panel(view_object.Object)

    def unsetEdit(self, view_object, mode):
        """Close the panel."""
        if mode != 0:
            return None
        Gui.Control.closeDialog()
        return True

    def setupContextMenu(self, view_object, menu):
        """Offer the panel in the tree's menu."""
        text = App.Qt.translate("BistablePanel", "Edit {}").format(view_object.Object.Label)
        menu.addAction(text).triggered.connect(lambda: self.doubleClicked(view_object))

    def dumps(self):
        """Nothing of the proxy is saved."""
        return None

    def loads(self, state):
        """See `dumps`."""

    # FreeCAD 0.20 asks for these names.
    __getstate__ = dumps
    __setstate__ = loads
