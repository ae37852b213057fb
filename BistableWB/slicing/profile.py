# SPDX-License-Identifier: LGPL-2.1-or-later
"""The settings with which prints are sliced and compared."""

from ..origami.hinges.processes import BY_POWDER, BY_STANDOFFS, BY_TIES, PROCESSES
from ..origami.hinges.standoff_inputs import LINE_IN_NOZZLES

_BED = 2000  # mm: whether a print fits the real bed is told apart

# A common printer that moves along three axes, with PLA and a second nozzle for soluble support:
# the speeds (mm/s) and accelerations (mm/s²) of Prusa's own profile for a good surface.
_SETTINGS = {
    "printer_technology": "FFF",
    "gcode_flavor": "marlin",
    "bed_shape": f"0x0,{_BED}x0,{_BED}x{_BED},0x{_BED}",
    "max_print_height": 1200,  # the most that PrusaSlicer takes
    "filament_diameter": "1.75,1.75",
    "extruder_offset": "0x0,0x0",
    "temperature": "215,215",
    "first_layer_temperature": "215,215",
    "bed_temperature": "60,60",
    "first_layer_bed_temperature": "60,60",
    "perimeters": 2,
    "top_solid_layers": 4,
    "bottom_solid_layers": 4,
    "fill_density": "15%",
    "fill_pattern": "gyroid",
    "skirts": 0,
    "seam_position": "aligned",
    # Soluble support in every gap: it may touch the model, and nothing is left to bridge.
    "filament_soluble": "0,1",
    "support_material": 1,
    "support_material_auto": 1,
    "support_material_extruder": 2,
    "support_material_interface_extruder": 2,
    "support_material_contact_distance": 0,
    "support_material_interface_layers": 2,
    "support_material_style": "snug",  # the least, which helps deployed prints most
    "support_material_spacing": 2,
    "support_material_speed": 50,
    "support_material_interface_speed": "80%",
    "dont_support_bridges": 0,
    "thick_bridges": 0,
    "wipe_tower": 0,
    "perimeter_speed": 45,
    "external_perimeter_speed": 25,
    "small_perimeter_speed": 25,
    "infill_speed": 80,
    "solid_infill_speed": 80,
    "top_solid_infill_speed": 40,
    "gap_fill_speed": 40,
    "bridge_speed": 30,
    "travel_speed": 180,
    "first_layer_speed": 20,
    "default_acceleration": 1000,
    "perimeter_acceleration": 800,
    "infill_acceleration": 1000,
    "machine_limits_usage": "time_estimate_only",
    "machine_max_acceleration_x": "1250,1250",
    "machine_max_acceleration_y": "1250,1250",
    "machine_max_acceleration_extruding": "1250,1250",
    "machine_max_acceleration_travel": "1250,1250",
    "machine_max_feedrate_x": "200,200",
    "machine_max_feedrate_y": "200,200",
    "machine_max_jerk_x": "8,8",
    "machine_max_jerk_y": "8,8",
}
# A printer that is pushed: speeds and accelerations of usual fast profiles, twice to three times as
# high.
_FAST = {
    "perimeter_speed": 100,
    "external_perimeter_speed": 60,
    "small_perimeter_speed": 50,
    "infill_speed": 150,
    "solid_infill_speed": 150,
    "top_solid_infill_speed": 80,
    "gap_fill_speed": 60,
    "bridge_speed": 40,
    "first_layer_speed": 30,
    "default_acceleration": 3000,
    "perimeter_acceleration": 2500,
    "infill_acceleration": 3000,
    "machine_max_acceleration_x": "3000,3000",
    "machine_max_acceleration_y": "3000,3000",
    "machine_max_acceleration_extruding": "3000,3000",
    "machine_max_acceleration_travel": "3000,3000",
}
SPEEDS = {"quality": {}, "fast": _FAST}  # the settings of a slower and of a faster printer
# The middle of the bed (x, y), mm: prints are sliced there.
MIDDLE = _BED / 2, _BED / 2


def settings(printer, extra=()):
    """Text of a configuration file for PrusaSlicer.

    ``printer``: `checks.printer.Printer`; ``extra``: (name, value) pairs that replace settings.
    """
    width = round(line_width(printer), 4)
    chosen = {
        **_SETTINGS,
        "support_material_threshold": round(90 - printer.steepest),
        "layer_height": printer.layer_height,
        "first_layer_height": printer.layer_height,
        "nozzle_diameter": f"{printer.nozzle_diameter},{printer.nozzle_diameter}",
        "extrusion_width": width,
        "first_layer_extrusion_width": width,
        **dict(extra),
    }
    return "".join(f"{name} = {value}\n" for name, value in chosen.items())


def speeds(name: str) -> dict:
    """Settings of a slower or a faster printer, one of `SPEEDS`."""
    return {**_SETTINGS, **SPEEDS[name]}


def for_process(name: str) -> dict:
    """Settings, in place of ours, of a process: whether the slicer adds support."""
    alone = PROCESSES[name].held in (BY_STANDOFFS, BY_TIES, BY_POWDER)
    return {"support_material": 0} if alone else {}


def line_width(printer):
    """Width of the lines that a `checks.printer.Printer` lays, mm."""
    return LINE_IN_NOZZLES * printer.nozzle_diameter
