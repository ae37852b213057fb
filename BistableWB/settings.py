# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's preferences: printer, default hinge, colours.

They count for objects made from now on and for checks. Nothing here is read while a file is
opened or recomputed: a file looks and prints the same on every computer.
"""

import FreeCAD as App

from . import colours
from .origami.hinges.parameters import SEGMENT_WIDTH, HingeParameters
from .origami.hinges.printers import CUSTOM, PRINTERS
from .origami.hinges.processes import PROCESSES, STANDOFFS

PATH = "User parameter:BaseApp/Preferences/Mod/Bistable"
_HINGE = HingeParameters()

# Preference -> default. Those of the hinge and the printer bear the names of the properties.
NUMBERS = {
    "BedWidth": 250.0,
    "BedDepth": 210.0,
    "BedHeight": 210.0,
    "NozzleDiameter": _HINGE.nozzle_diameter,
    "LayerHeight": _HINGE.layer_height,
    "FaceThickness": _HINGE.face_thickness,
    "GapLength": _HINGE.gap_length,
    "GapBetweenPlanes": _HINGE.gap_between_planes,
}
PIVOTS = ("Cone", "Pin")
_GIVEN = ("gap_length", "gap_between_planes", "face_thickness", "layer_height", "nozzle_diameter")
_HINGE_NUMBERS = tuple(NUMBERS)[3:]
CLEARANCE, AIR_LAYERS = "TightestThatTurns", "AirLayers"  # of a calibration plate; 0: not tried
NO_AIR = -1  # of the pairs of plates none came apart


def group():
    """The parameter group of the workbench."""
    return App.ParamGet(PATH)


def number(name):
    """A preference of `NUMBERS`, in mm."""
    return group().GetFloat(name, NUMBERS[name])


def pivot():
    """The kind of pivot of new hinges."""
    chosen = group().GetString("Pivot", PIVOTS[0])
    return chosen if chosen in PIVOTS else PIVOTS[0]


def printer():
    """Name of the printer that was chosen, `CUSTOM` where its numbers are the user's own."""
    chosen = group().GetString("Printer", "")
    return chosen if chosen in PRINTERS else CUSTOM


def printer_was_asked():
    """Whether the first start has asked for the printer."""
    return group().GetBool("PrinterAsked", False)


def keep_printer_asked():
    """Do not ask again."""
    group().SetBool("PrinterAsked", True)


def process():
    """Process of new hinges, a name of `PROCESSES`."""
    chosen = group().GetString("Process", STANDOFFS)
    return chosen if chosen in PROCESSES else STANDOFFS


def numbers_of(name):
    """{preference: mm} that a printer of `PRINTERS` has, with the hinges of its process."""
    profile = PRINTERS[name]
    found = dict(NUMBERS)
    found |= given_by(profile.process)
    found |= dict(zip(("BedWidth", "BedDepth", "BedHeight"), map(float, profile.bed), strict=True))
    found["LayerHeight"] = profile.layer
    if profile.nozzle:
        found["NozzleDiameter"] = profile.nozzle
    return found


def given_by(name):
    """{preference: mm} of the hinge that a process gives."""
    words = ((key, "".join(part.capitalize() for part in key.split("_"))) for key in _GIVEN)
    return {word: PROCESSES[name].gives[key] for key, word in words}


def use_printer(name):
    """Take a printer of `PRINTERS` for all that is made from now on; `CUSTOM` keeps the numbers."""
    group().SetString("Printer", name)
    if name == CUSTOM:
        return
    for key, value in numbers_of(name).items():
        group().SetFloat(key, value)
    group().SetString("Process", PRINTERS[name].process)
    group().RemFloat(CLEARANCE)  # what another printer's calibration plate told
    group().RemInt(AIR_LAYERS)


def bed():
    """Room of the printer (x, y, z), mm."""
    return tuple(number(f"Bed{side}") for side in ("Width", "Depth", "Height"))


def hinge():
    """`HingeParameters` of new hinges."""
    return HingeParameters(
        pivot=pivot(),
        nozzle_diameter=number("NozzleDiameter"),
        layer_height=number("LayerHeight"),
        face_thickness=number("FaceThickness"),
        gap_length=number("GapLength"),
        gap_between_planes=number("GapBetweenPlanes"),
        segment_width=SEGMENT_WIDTH,
        **({} if process() == STANDOFFS else {"process": process()}),
    )


def bed_line(variable):
    """Line of a macro that tells the HingeSet in ``variable`` the room of the printer."""
    return f"{variable}.Bed = App.Vector{tuple(round(x, 6) for x in bed())!r}"


def keep_calibration(clearance=None, air_layers=None):
    """Keep what a calibration plate told of this printer; None: not asked, what was known stays.

    ``clearance``: of the tightest hinge that turns (mm), from now on that of new hinges and the
    least that checks ask for; 0: none of them turned. ``air_layers``: fewest layers of air over
    which a pair of plates came apart, `NO_AIR` if none did.
    """
    if clearance is not None:
        group().SetFloat(CLEARANCE, clearance)
        if clearance:
            group().SetFloat("GapLength", clearance)
    if air_layers is not None:
        group().SetInt(AIR_LAYERS, air_layers)


def calibrated_clearance():
    """Clearance of the tightest hinge that turned on this printer, mm; 0: not known."""
    return group().GetFloat(CLEARANCE, 0.0)


def air_layers():
    """Fewest layers of air over which plates came apart; 0: not known, `NO_AIR`: over none."""
    return group().GetInt(AIR_LAYERS, 0)


def air_lines(variable):
    """Lines of a macro that give the HingeSet in ``variable`` the air that plates came off over."""
    known = air_layers()
    return [f"{variable}.AirLayers = {known}"] if known > 0 and process() == STANDOFFS else []


def hinge_lines(variable, without=()):
    """Lines of a macro that give the hinge in ``variable`` what differs from its defaults."""
    usual, lines = NUMBERS, []
    if process() != STANDOFFS:
        usual = {**NUMBERS, **given_by(process())}
        lines.append(f'{variable}.Process = "{process()}"')
    for name in _HINGE_NUMBERS:
        if name in without:
            continue
        value = round(number(name), 6)
        if abs(value - usual[name]) > 1e-9:
            lines.append(f"{variable}.{name} = {value!r}")
    if pivot() != PIVOTS[0]:
        lines.append(f'{variable}.Pivot = "{pivot()}"')
    return lines


def colour(kind):
    """RGB in 0…1 of a kind of bodies, for new objects: of panels, the one that the user likes."""
    kind = "contact" if kind == "block" else kind
    packed = group().GetUnsigned(f"Colour_{kind}", 0) if kind in colours.PANELS else 0
    if not packed:
        return colours.rgb(colours.of(kind))
    return tuple((packed >> shift & 255) / 255 for shift in (24, 16, 8))


def set_panel_colour(kind, code):
    """Remember the colour "#RRGGBB" of a kind of panel; the default one is not stored."""
    if code.upper() == colours.PANELS[kind].upper():
        group().RemUnsigned(f"Colour_{kind}")
    else:
        group().SetUnsigned(f"Colour_{kind}", int(code[1:], 16) << 8 | 255)
