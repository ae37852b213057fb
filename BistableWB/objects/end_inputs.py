# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a print ends: inputs of a HingeSet for joints and end parts."""

import FreeCAD as App

from ..origami.hinges.ends import END_PARTS, Ends
from ..origami.hinges.feet import Plane
from ..origami.hinges.joints import JOINTS, Joint
from ..origami.snap.materials import material
from .base import Prop

_DEFAULTS, _GROUND = Joint(), Plane()
END_PROPERTIES = (
    Prop("Enumeration", "Joint", "Ends", "How two halves of a contact block are joined, where the "
         "tube is cut into parts and where a closed one meets itself when deployed. Dowel: pieces "
         "of filament. Clip: posts that snap behind tongues. Magnet: pockets. Screw: through "
         "holes. None: plain faces to glue", list(JOINTS)),
    Prop("Length", "DowelDiameter", "Ends", "Diameter of the dowels; holes are 0.2 mm wider",
         _DEFAULTS.dowel_diameter),
    Prop("Length", "MagnetDiameter", "Ends", "Diameter of the magnets; pockets are 0.2 mm wider",
         _DEFAULTS.magnet_diameter),
    Prop("Length", "MagnetDepth", "Ends", "Thickness of the magnets; pockets are 0.1 mm deeper",
         _DEFAULTS.magnet_depth),
    Prop("Length", "ScrewDiameter", "Ends", "Nominal diameter of the screws of joints and "
         "flanges; holes clear them as ISO 273 has it", _DEFAULTS.screw_diameter),
    Prop("Enumeration", "StartPart", "Ends", "What the first end of an open tube has. Plate: "
         "closed all over. Flange: a wider plate with four screw holes. Foot: a flange and a foot "
         "for it, printed beside, that stands square on the plane of FootPoint and FootNormal",
         list(END_PARTS)),
    Prop("Enumeration", "EndPart", "Ends", "What the last end of an open tube has, as StartPart",
         list(END_PARTS)),
    Prop("Vector", "FootPoint", "Ends", "A point of the plane on which feet stand when the tube is "
         "deployed", App.Vector(*_GROUND.point)),
    Prop("Vector", "FootNormal", "Ends", "Direction from the plane of the feet to the tube: feet "
         "stand square on it", App.Vector(*_GROUND.normal)),
    Prop("Length", "PlateThickness", "Ends", "Thickness of plates and flanges; 0: twice the "
         "panels'", 0.0),
)  # fmt: skip


def ends_of(obj):
    """`Ends` of a HingeSet object; refuses numbers that cannot be."""
    own = material(obj.Material).edited(young=obj.YoungsModulus, strength=obj.Strength)
    clips = {"strain": own.snap_strain} if obj.Joint == "Clip" else {}
    joint = Joint(
        obj.Joint,
        dowel_diameter=obj.DowelDiameter.Value,
        magnet_diameter=obj.MagnetDiameter.Value,
        magnet_depth=obj.MagnetDepth.Value,
        screw_diameter=obj.ScrewDiameter.Value,
        **clips,
    )
    ground = Plane(tuple(obj.FootPoint), tuple(obj.FootNormal))
    return Ends(joint, obj.StartPart, obj.EndPart, obj.PlateThickness.Value, ground)
