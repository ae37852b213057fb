# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which properties count only with a choice that another one makes: panels show no others."""

# Property -> (the one that decides, its values with which it counts)
_WITH = {
    "Ratio": ("RatioRule", ("Fixed",)),
    "RatioShare": ("RatioRule", ("Adaptive",)),
    "TargetMargin": ("RatioRule", ("TargetSnap",)),
    "TargetBarrier": ("RatioRule", ("TargetSnap",)),
    "StrainLimit": ("RatioRule", ("TargetSnap",)),
    "Tolerance": ("PlacementRule", ("Steered",)),
    "Symmetric": ("PlacementRule", ("Steered",)),
    "StartDirection": ("PlacementRule", ("Steered",)),
    "EndDirection": ("PlacementRule", ("Steered",)),
    "Preload": ("PreloadRule", ("Given",)),
    "DowelDiameter": ("Joint", ("Dowel",)),
    "MagnetDiameter": ("Joint", ("Magnet",)),
    "MagnetDepth": ("Joint", ("Magnet",)),
    "Pivot": ("HingeType", ("Rotational",)),
    "ConeAngle": ("HingeType", ("Rotational",)),
    "StandOffSpacing": ("Process", ("FDM, stand-offs",)),
    "StandOffWidth": ("Process", ("FDM, stand-offs",)),
    "AirLayers": ("Process", ("FDM, stand-offs",)),
    "StandOffRim": ("Process", ("FDM, stand-offs",)),
    "Pillars": ("Process", ("FDM, stand-offs",)),
}


def counts(obj, name):
    """Whether the property ``name`` of an object changes anything at the moment."""
    decides, values = _WITH.get(name, ("", ()))
    return decides not in obj.PropertiesList or getattr(obj, decides) in values
