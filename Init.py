# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start, with a window or without: names the files that FreeCAD's own Import and Export know.

The modules are imported when such a file is. Drawings and tables are not named: other workbenches
read them too, and FreeCAD would ask each time which one is meant (they have a command of ours).
"""

import FreeCAD

FreeCAD.addImportType("Bistable units (*.fold)", "BistableWB.imports.fold")
FreeCAD.addExportType("Bistable tube (*.fold)", "BistableWB.exporters")
