# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's preferences: printer, default hinge, colours.

They count for objects made from now on and for checks. Nothing here is read while a file is
opened or recomputed: a file looks and prints the same on every computer.
"""

import FreeCAD as App

from . import colours
from .origami.hinges.parameters import SEGMENT_WIDTH, HingeParameters

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


def hinge_lines(variable, without=()):
    """Lines of a macro that give the hinge in ``variable`` what differs from its defaults."""
    lines = []
    for name in _HINGE_NUMBERS:
        if name in without:
            continue
        value = round(number(name), 6)
        if abs(value - NUMBERS[name]) > 1e-9:
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
