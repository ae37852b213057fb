# SPDX-License-Identifier: LGPL-2.1-or-later
"""Printers that people have: one table, pure data, of which one is chosen in the preferences.

To add one, add a line. What it gives are the numbers of new objects; all can be changed.
"""

from typing import NamedTuple

from .processes import POWDER, RESIN, STANDOFFS

CUSTOM = "Custom"


class PrinterProfile(NamedTuple):
    """``bed`` (x, y, z), ``nozzle`` and ``layer``, mm; ``process``: of `PROCESSES`; ``source``.

    A nozzle of 0: the thinnest wall of its process.
    """

    bed: tuple[float, float, float]
    nozzle: float
    layer: float
    process: str
    source: str


PRINTERS = {
    "Prusa MK3": PrinterProfile(
        (250, 210, 210), 0.4, 0.2, STANDOFFS, "help.prusa3d.com, Original Prusa i3 MK3S+"
    ),
    "Prusa MK4": PrinterProfile(
        (250, 210, 220), 0.4, 0.2, STANDOFFS, "help.prusa3d.com, Original Prusa MK4"
    ),
    "Prusa XL": PrinterProfile(
        (360, 360, 360), 0.4, 0.2, STANDOFFS, "help.prusa3d.com, Original Prusa XL"
    ),
    "Creality Ender 3": PrinterProfile(
        (220, 220, 250), 0.4, 0.2, STANDOFFS, "creality.com, Ender-3"
    ),
    "Bambu Lab A1": PrinterProfile((256, 256, 256), 0.4, 0.2, STANDOFFS, "bambulab.com, A1"),
    "Bambu Lab X1": PrinterProfile((256, 256, 256), 0.4, 0.2, STANDOFFS, "bambulab.com, X1"),
    "Formlabs Form 3": PrinterProfile(
        (145, 145, 185), 0.0, 0.1, RESIN, "formlabs.com, Form 3: technical specifications"
    ),
    "Service, SLS": PrinterProfile(
        (340, 340, 600), 0.0, 0.1, POWDER, "eos.info, EOS P 396: building volume"
    ),
    "Service, MJF": PrinterProfile(
        (380, 284, 380), 0.0, 0.1, POWDER, "hp.com, HP Jet Fusion 4200: effective building volume"
    ),
}
