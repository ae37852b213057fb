# SPDX-License-Identifier: LGPL-2.1-or-later
"""Flexible hinges: TPU strips with their fingers, and the pockets for them in the panels."""

import Part

from ..origami.strip_plan import strip_volume
from . import brep


def strip_solid(strip, parameters):
    """One connected solid of a strip (frame of its layout); its volume is checked."""
    start, end = strip.hinge.segments[0]
    along = brep.at(strip.hinge.direction, 0.0) * (end - start)
    pieces = []
    for n0, n1, v0, v1 in strip.boxes:
        origin = strip.hinge.point(start)
        section = [(n0, v0), (n1, v0), (n1, v1), (n0, v1)]
        face = brep.polygon([brep.at(origin + n * strip.across, v) for n, v in section])
        pieces.append(face.extrude(along))
    pieces += [finger_solid(f) for made in strip.fingers.values() for f in made]
    shape = pieces[0].multiFuse(pieces[1:])
    return one_solid(shape, strip_volume(strip, parameters), strip.name)


def finger_solid(finger):
    """Prism of one finger."""
    face = brep.polygon([brep.at(p, finger.low) for p in finger.corners])
    return face.extrude(brep.Vector(0, finger.high - finger.low, 0))


def fingers_in(strips, plate_name):
    """Prisms of all fingers that reach into one plate."""
    return [finger_solid(f) for strip in strips.values() for f in strip.fingers.get(plate_name, ())]


def with_pockets(shape, fingers, volume, name):
    """A panel or block less the fingers: the complementary body, of the predicted ``volume``."""
    if not fingers:
        return shape
    return one_solid(shape.cut(Part.makeCompound(fingers)), volume, name)


def one_solid(shape, volume, name):
    """The single solid of a boolean's result, with the predicted volume (mm³) to 0.1 %."""
    solids = shape.Solids
    if len(solids) != 1 or abs(solids[0].Volume - volume) > brep.VOLUME_TOLERANCE * volume:
        found = ", ".join(f"{solid.Volume:.6g}" for solid in solids)
        raise RuntimeError(f"Body {name} has {found} mm³ instead of one solid of {volume:.6g} mm³.")
    return solids[0]
