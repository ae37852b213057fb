# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which files for other programs a design asks for."""

from .design_table import FORMATS_OF, NET_FORMATS, PRINT_FORMATS, STATES


def wanted_files(design, objects):
    """(object, end of the file's name, options) of every file for other programs."""
    prints = design.get("output", "print_states", ["flat"])
    for suffix in design.formats:
        of_print = suffix in PRINT_FORMATS or "unit" not in objects
        if of_print and suffix not in NET_FORMATS:
            if "hinges" in objects and suffix == "scad":
                yield objects["hinges"], "-print.scad", {}
            elif "hinges" in objects:
                for state in prints:
                    name = "print" if state == "flat" else f"print-{state}"
                    yield objects["hinges"], f"-{name}.{suffix}", {"state": state}
            if "coupon" in objects:
                yield objects["coupon"], f"-coupon.{suffix}", {}
        elif suffix in NET_FORMATS and "unit" in objects:
            yield objects["unit"], f".{suffix}", _net_options(design, suffix)
        elif "unit" in objects:
            for state in design.get("output", "states", list(STATES)):
                yield objects["unit"], f"-{state}.{suffix}", {"state": state}


def _net_options(design, suffix):
    given = {key: design.get("output", key) for key, of in FORMATS_OF.items() if suffix in of}
    return {key: value for key, value in given.items() if value is not None}
