# SPDX-License-Identifier: LGPL-2.1-or-later
"""Materials of a print: stiffness, weight, strength and friction, each with its source.

Printed parts differ by machine and direction: the numbers are typical ones of solid prints (or of
sheets), to be replaced by what a coupon of one's own shows. ``layer_share`` is the part of the
strength that is left across the layers of a print (docs/theory/hinges.md 4).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import isfinite
from typing import Any

from ..errors import Choice, Refusal, name_of

PLA, TPU = "PLA", "TPU"
_OFTEN = 0.6


@dataclass(frozen=True)
class Material:
    """What a print is made of.

    ``young`` E, MPa; ``poisson`` ν; ``density``, g/cm³; ``strength``: tensile, along the layers,
    MPa; ``layer_share``: of it across layers (1: the same); ``friction``: on itself; ``sources``:
    where each number is from.
    """

    name: str
    young: float
    poisson: float
    density: float
    strength: float
    layer_share: float
    friction: float
    sources: Mapping[str, str]

    def __post_init__(self) -> None:
        for name, (parameter, unit) in _EDITABLE.items():
            value = getattr(self, name)
            if not (isfinite(value) and value > 0):
                raise Refusal(
                    "{name} of {material} is {value:.6g}{measure}",
                    cure="set it to a number above 0", parameter=parameter,
                    name=name_of(parameter), material=Choice(self.name), value=value, measure=unit,
                )  # fmt: skip
        if not 0 <= self.poisson < 0.5:
            raise Refusal(
                "Poisson's ratio of {material} is {value:.6g}",
                cure="set it from 0 to below 0.5", parameter="Material",
                material=Choice(self.name), value=self.poisson,
            )  # fmt: skip

    def edited(self, **values: Any) -> "Material":
        """The same with some numbers replaced; None and 0 keep the table's."""
        given = {name: value for name, value in values.items() if value}
        sources = {**self.sources, **dict.fromkeys(given, "given by the user")}
        return replace(self, **given, sources=sources) if given else self

    @property
    def shear(self) -> float:
        """Shear modulus G, MPa."""
        return self.young / (2 * (1 + self.poisson))

    @property
    def breaking_strain(self) -> float:
        """Strain that it bears once, along its layers: strength / E."""
        return self.strength / self.young

    @property
    def snap_strain(self) -> float:
        """Strain that a clip in the plane of the layers may have again and again.

        0.6 of strength / E: guides to snap fits (Covestro, *Snap-Fit Joints for Plastics*) give
        what is joined often 60 % of the strain that it bears once.
        """
        return _OFTEN * self.breaking_strain

    def bears(self, across_layers: bool) -> float:
        """Strength, MPa, of a bending tab that lies along its layers or stands across them."""
        return self.strength * (self.layer_share if across_layers else 1.0)


_EDITABLE = {
    "young": ("YoungsModulus", " MPa"),
    "density": ("Density", " g/cm³"),
    "strength": ("Strength", " MPa"),
    "layer_share": ("LayerStrength", ""),
    "friction": ("Friction", ""),
}

_ASSUMED = "assumed: no source at hand; measure a coupon"
_TOOLS = "additive.tools/materials/{}: FDM as built, middle of its range"
_SANTANA = "Santana, Alves, da Costa Sabino Netto 2020, doi 10.1177/1464420720978997: static"
_HP = "HP 3D High Reusability PA 12, technical fact sheet (ASTM D638, D792)"
_DURABLE = "Formlabs Durable FLDUCL01 data sheet, post-cured"
_PLY = "MatWeb, plywood, sheathing grade (ASTM D3043, D3500), middle of its range"


def _material(name: str, numbers: Any, sources: Sequence[str]) -> Material:
    keys = "young", "poisson", "density", "strength", "layer_share", "friction"
    of = dict(zip(keys, sources, strict=True))
    return Material(name, **dict(zip(keys, numbers, strict=True)), sources=of)


MATERIALS = {
    found.name: found
    for found in (
        _material(
            PLA, (3000.0, 0.35, 1.24, 50.0, 0.5, 0.25),
            ("design value of docs/theory/hinges.md 4; data sheets give 2.3 to 3.5 GPa", _ASSUMED,
             "usual on data sheets of filament", "low end of usual data sheets (50 to 60 MPa)",
             "upright arms bend across layers: half, docs/theory/hinges.md 4",
             _SANTANA + " 0.12 to 0.38"),
        ),
        _material(
            "PETG", (2200.0, 0.38, 1.27, 48.0, 0.63, 0.17),
            (_TOOLS.format("petg") + " (2 to 3 GPa)", _ASSUMED, _TOOLS.format("petg"),
             _TOOLS.format("petg") + " (44 to 56 MPa)",
             _TOOLS.format("petg") + ": upright 25 to 38 MPa", _SANTANA + " 0.13 to 0.21"),
        ),
        _material(
            "ABS", (2000.0, 0.37, 1.04, 46.0, 0.5, 0.3),
            ("Wohlers Report 2011, appendix E: 2,000 MPa", _ASSUMED,
             "usual on data sheets of filament", "Wohlers Report 2011, appendix E: 46 MPa",
             _ASSUMED, _ASSUMED),
        ),
        _material(
            "ASA", (2000.0, 0.37, 1.07, 45.0, 0.5, 0.3),
            ("as ABS: " + _ASSUMED, _ASSUMED, "usual on data sheets of filament",
             "as ABS: " + _ASSUMED, _ASSUMED, _ASSUMED),
        ),
        _material(
            "PA12", (1800.0, 0.43, 1.01, 48.0, 1.0, 0.3),
            (_HP, _HP + ", across layers", _HP, _HP, _HP + ": 48 MPa both ways", _ASSUMED),
        ),
        _material(
            TPU, (120.0, 0.48, 1.22, 25.0, 0.6, 0.5),
            ("Eng. Proc. 2025, 113, 19: 100 to 146 MPa", _ASSUMED, _TOOLS.format("tpu"),
             "Eng. Proc. 2025, 113, 19: 18 to 32 MPa",
             _TOOLS.format("tpu") + ": upright 12 to 24 MPa", _ASSUMED),
        ),
        _material(
            "Resin", (1260.0, 0.4, 1.15, 31.8, 1.0, 0.3),
            (_DURABLE, _ASSUMED, _ASSUMED, _DURABLE, "isotropic: " + _ASSUMED, _ASSUMED),
        ),
        _material(
            "Plywood", (9200.0, 0.3, 0.5, 30.0, 1.0, 0.4),
            (_PLY + " (8.2 to 10.3 GPa)", _ASSUMED, _PLY, _PLY + " (27.6 to 34.5 MPa)",
             "a sheet has no layers of a print", _ASSUMED),
        ),
        _material(
            "Acrylic", (3200.0, 0.37, 1.19, 65.0, 1.0, 0.4),
            (_ASSUMED, _ASSUMED, _ASSUMED, _ASSUMED, "a sheet has no layers of a print", _ASSUMED),
        ),
    )
}  # fmt: skip


def material(name: str) -> Material:
    """The `Material` of a name; refuses one that is not in the table."""
    if name not in MATERIALS:
        raise Refusal(
            "{Material} {name} is unknown", cure="choose one of {known}", parameter="Material",
            name=repr(name), known=", ".join(MATERIALS),
        )  # fmt: skip
    return MATERIALS[name]
