# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recording a deployment in the 3D view as pictures and films."""
