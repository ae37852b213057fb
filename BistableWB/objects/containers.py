# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are moved: FreeCAD does not tell who followed what is inside of them.

A Curve follows its Source in space, a tube its Curve. Where the two stand in different Parts, a
Part that moves, or takes something in, makes what follows out of date: it is touched.
"""

import FreeCAD as App

from . import links

_MOVING = ("Placement", "Group")  # what changes where the things in a container are
_watching = None


def watch():
    """Follow the containers of all documents; once."""
    global _watching
    if _watching is None:
        _watching = _Observer()
        App.addDocumentObserver(_watching)


class _Observer:
    def slotChangedObject(self, obj, name):
        """A property has changed."""
        if name in _MOVING and obj.hasExtension("App::GeoFeatureGroupExtension"):
            doc = obj.Document
            if not (doc.Restoring or getattr(doc, "Importing", False)):
                for one in doc.Objects:
                    if hasattr(getattr(one, "Proxy", None), "PROPERTIES") and _crosses(one, obj):
                        one.touch()


def _crosses(obj, container):
    """Whether ``obj`` follows something that is in ``container`` where it is not, or inversely."""
    inside = _is_inside(obj, container)
    targets = (links.target_of(obj, name) for name in links.link_names(obj.Proxy)
               if name in obj.PropertiesList)  # fmt: skip
    return any(t is not None and _is_inside(t, container) != inside for t in targets)


def stands_apart(obj) -> bool:
    """Whether ``obj`` follows something that is in another Part than itself."""
    home = obj.getParentGeoFeatureGroup()
    targets = (links.target_of(obj, name) for name in links.link_names(obj.Proxy))
    return any(t is not None and t.getParentGeoFeatureGroup() is not home for t in targets)


def _is_inside(obj, container):
    home = obj.getParentGeoFeatureGroup()
    while home is not None and home is not container:
        home = home.getParentGeoFeatureGroup()
    return home is container
