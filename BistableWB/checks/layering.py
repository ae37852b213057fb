# SPDX-License-Identifier: LGPL-2.1-or-later
"""What layers make of a print: bodies that thicken or fuse, and what is laid over air.

Measured on the layers of the meshes (`layers`), with no slicer: `slicing` asks one.
"""

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import repeat
from math import ceil
from os import cpu_count
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..origami.errors import ERROR, NOTE, WARNING, Finding, phrase
from .layers import PIXEL, Tops, extent, layers
from .overhang import hangs
from .starts import starts

if TYPE_CHECKING:
    from ..origami.meshes import Mesh, PlacedMesh
    from .layers import Layers
    from .printer import Printer

SHARE_TOLERANCE = 0.05  # by which a body's layers may be off its volume
CONTACT_LIMIT = 0.15  # mm² between two moving bodies that is not felt
WELDED = 1.0  # mm² from which bodies do not break free any more
_SUPPORT_CURE = {
    "off": phrase(
        "switch {Support} on, or let the slicer fill the gaps with soluble support"
    ).setting(Support=True),
    "on": phrase("let the slicer add support there too"),
    "none": phrase("let the slicer add support there"),
    "stand-offs": phrase(
        "make {StandOffSpacing} smaller or {GapBetweenPlanes} larger, or choose another {Process}"
    ),
}
NEAR = 0.4  # mm of air, at least two layers, over which a line is laid on what lies below


class Layering:
    """The layers of a print's ``bodies`` (`PlacedMesh`, as they lie on the bed), unit by unit.

    ``support``: `Mesh` of the soluble support, if it is printed; ``support_state``: "on", "off"
    (it could be), "none", or "stand-offs": bodies hold each other up. ``alone``: nothing is added
    by a slicer, so that regions start in mid-air where nothing lies closely below. Only units next
    to each other are held in memory.
    """

    def __init__(
        self,
        bodies: "Sequence[PlacedMesh]",
        printer: "Printer",
        support: "Mesh | None" = None,
        support_state: str = "none",
        alone: bool = False,
    ) -> None:
        self.bodies, self.printer = list(bodies), printer
        self.support_state = support_state
        near = max(round(NEAR / printer.layer_height), 2) + 1
        self._depth = near if alone else ceil(printer.bridge / printer.layer_height) + 1
        self._holds = near if support_state == "stand-offs" else 0
        self._support = None if support is None else layers(support, printer.layer_height)
        self._shares: list[Any] = []
        self._contacts: list[Any] = []
        self._hangs: list[Any] = []
        self._islands: list[Any] = []

    def findings(self) -> list[Finding]:
        """List of `Finding`: thickness, fused bodies, what hangs over air."""
        alive: list[Any] = []
        bounds = np.array([body.placed.bounds for body in self.bodies])
        tops = Tops(*extent(bounds))  # of the units further below
        for unit in sorted({body.unit for body in self.bodies}):
            bodies = [body for body in self.bodies if body.unit == unit]
            with ThreadPoolExecutor(cpu_count()) as pool:
                made, shares = zip(*pool.map(self._layers, bodies), strict=True)
                new = list(zip(bodies, made, strict=True))
                around = [*alive, *new]
                below = [*(layers for _, layers in around), tops]
                for found, islands in pool.map(self._looked_below, bodies, made, repeat(below)):
                    self._hangs += found
                    self._islands += islands
            self._shares += shares
            self._touch(new, around)
            for _, gone in alive:
                tops.add(gone)
            alive = new
        return [*self._thickness(), *self._fused(), *self._over_air()]

    def _layers(self, body: "PlacedMesh") -> "tuple[Layers, tuple[str, float, float]]":
        mesh = body.placed
        found = layers(mesh, self.printer.layer_height)
        volume = found.inside.sum() * PIXEL**2 * self.printer.layer_height
        return found, (body.name, volume / mesh.volume, _off_grid(mesh, self.printer))

    def _looked_below(
        self, body: "PlacedMesh", made: "Layers", around: "Sequence[Layers | Tops]"
    ) -> tuple[list[Any], list[Any]]:
        """(`Hang`, name, point) list of what hangs over air, and of its start if that is there."""
        if not made.inside.size:
            return [], []
        height = self.printer.layer_height
        others = [other for other in around if other is not made]
        found = [
            (hang, body.name, made.middle(hang.pixel, height))
            for hang in hangs(made, self.printer, self._support, others, self._holds)
        ]
        below = [*others, self._support] if self._support is not None else others
        return found, [
            (point[2], body.name, point, start.area)
            for start in starts(made, below, self._depth)
            for point in [made.middle(start.pixel, height)]
        ]

    def _touch(
        self,
        new: "Sequence[tuple[PlacedMesh, Layers]]",
        around: "Sequence[tuple[PlacedMesh, Layers]]",
    ) -> None:
        """Areas in which layers of two rigid bodies lie on each other or are the same."""
        for k, (body, made) in enumerate(new):
            others = around[: len(around) - len(new) + k]
            for other, its in others:
                if body.material == other.material == "rigid":
                    pixels, where = _contact(its, made)
                    if pixels:
                        point = made.middle(where - made.first, self.printer.layer_height)
                        self._contacts.append((pixels * PIXEL**2, other.name, body.name, point))

    def _thickness(self) -> list[Finding]:
        height = self.printer.layer_height
        name, share, off = max(sorted(self._shares), key=lambda entry: abs(entry[1] - 1))
        if abs(share - 1) <= SHARE_TOLERANCE:
            return [
                Finding(
                    severity=NOTE,
                    code="layers",
                    number=share,
                    limit=1.0,
                    message=phrase(
                        "Layers of {height:g} mm give every body its volume to {share:.1%}.",
                        height=height,
                        share=abs(share - 1),
                    ),
                )
            ]
        return [
            Finding(
                severity=WARNING,
                code="layers",
                bodies=(name,),
                number=share,
                limit=1.0,
                message=phrase(
                    "Layers of {height:g} mm make {body} {share:.0%} of its volume: its flat "
                    "faces lie up to {off:.2g} mm off the layers.",
                    height=height,
                    body=name,
                    share=share,
                    off=off,
                ),
                cure=phrase(
                    "make {FaceThickness} and {GapBetweenPlanes} multiples of {height:g} mm",
                    height=height,
                ),
            )
        ]

    def _fused(self) -> list[Finding]:
        found = sorted(self._contacts, reverse=True)
        fused = [entry for entry in found if entry[0] > CONTACT_LIMIT]
        if not fused:
            most = found[0][0] if found else 0.0
            text = phrase(
                "Between any two moving bodies lies a layer of air{rest}.",
                rest=phrase(", but for {area:.2g} mm²", area=most) if most else "",
            )
            return [
                Finding(
                    severity=NOTE,
                    code="fused",
                    number=most,
                    limit=CONTACT_LIMIT,
                    message=text,
                )
            ]
        area, lower, upper, _ = fused[0]
        welded = area > WELDED
        result = phrase(
            "which welds them" if welded else "which has to break free at the first opening"
        )
        count = len(fused) - 1
        more = phrase(
            " (and of {count} other pairs)" if count > 1 else " (and of {count} other pair)",
            count=count,
        )
        return [
            Finding(
                severity=ERROR if welded else WARNING,
                code="fused",
                bodies=(lower, upper),
                number=area,
                limit=CONTACT_LIMIT,
                message=phrase(
                    "Layers of {height:g} mm lay {area:.2g} mm² of {upper} directly on "
                    "{lower}{more}, {result}.",
                    height=self.printer.layer_height,
                    area=area,
                    upper=upper,
                    lower=lower,
                    more=more if count else "",
                    result=result,
                ),
                cure=phrase(
                    "make {LayerHeight} smaller, or {GapLength} and {GapBetweenPlanes} larger"
                ),
                points=tuple(entry[3] for entry in fused[:20]),
            )
        ]

    def _over_air(self) -> list[Finding]:
        if not self._hangs and not self._islands:
            return [
                Finding(
                    severity=NOTE,
                    code="overhang",
                    number=0.0,
                    message=phrase("Nothing is laid over air."),
                )
            ]
        span, total = self.printer.bridge, sum(hang.area for hang, *_ in self._hangs)
        hangs = [self._hang_finding(total, span)] if self._hangs else []
        return [*hangs, *self._island_findings()]

    def _hang_finding(self, total: float, span: float) -> Finding:
        wide = [entry for entry in self._hangs if entry[0].wide]
        hang, name, point = max(wide or self._hangs, key=lambda entry: (entry[0].area, entry[1]))
        most = phrase(
            "{area:.0f} mm² of {body} at a height of {height:.1f} mm",
            area=hang.area,
            body=name,
            height=point[2],
        )
        if not wide:
            return Finding(
                severity=NOTE,
                code="overhang",
                bodies=(name,),
                number=total,
                message=phrase(
                    "{total} are laid over air, all in strips narrower than the {span:g} mm "
                    "that a printer spans; the largest are {most}.",
                    total=_area(total),
                    span=span,
                    most=most,
                ),
                points=(point,),
            )
        many = phrase("{count} places are" if wide[1:] else "one place is", count=len(wide))
        return Finding(
            severity=WARNING,
            code="overhang",
            bodies=(name,),
            number=hang.area,
            limit=span**2,
            message=phrase(
                "{total} are laid over air, where {many} wider than the {span:g} mm that "
                "a printer spans, the largest {most}.",
                total=_area(total),
                many=many,
                span=span,
                most=most,
            ),
            cure=_SUPPORT_CURE[self.support_state],
            points=tuple(entry[2] for entry in wide[:20]),
        )

    def _island_findings(self) -> list[Finding]:
        if not self._islands:
            return []
        lowest = sorted(self._islands)
        count = len(lowest)
        height, name, *_ = lowest[0]
        what = phrase(
            "{count} places start, {area:.3g} mm² in all" if count > 1 else "{body} starts",
            count=count,
            area=sum(start[3] for start in lowest),
            body=name,
        )
        first = phrase(", one of {body} first", body=name) if count > 1 else ""
        depth = (self._depth - 1) * self.printer.layer_height
        return [
            Finding(
                severity=WARNING,
                code="island",
                bodies=tuple(dict.fromkeys(start[1] for start in lowest)),
                number=height,
                limit=depth,
                message=phrase(
                    "{what} in mid-air{first}, {lowest:.1f} mm above the bed and more than "
                    "{bridge:g} mm above anything else.",
                    what=what,
                    first=first,
                    lowest=height,
                    bridge=depth,
                ),
                cure=_SUPPORT_CURE["stand-offs" if self._holds else "none"],
                points=tuple(start[2] for start in lowest[:20]),
            )
        ]


def _area(square_mm: float) -> str:
    """An area in words: cm² with two digits."""
    return f"{square_mm / 100:.0f} cm²" if square_mm >= 1000 else f"{square_mm / 100:.2g} cm²"


def _contact(one: "Layers", other: "Layers") -> tuple[int, NDArray | None]:
    """Pixels of two `Layers` that lie on each other or fall together, and one of them (3,)."""
    more = np.array([1, 0, 0])
    low = np.maximum(one.first, other.first) - more
    high = np.minimum(one.end, other.end) + more
    if (low[1:] >= high[1:]).any() or low[0] + 1 >= high[0]:
        return 0, None
    a, b = one.window(low, high), other.window(low, high)
    both = a & b
    both[1:] |= a[:-1] & b[1:]
    both[1:] |= a[1:] & b[:-1]
    count = int(both.sum())
    return count, low + np.argwhere(both)[count // 2] if count else None


def _off_grid(mesh: "Mesh", printer: "Printer") -> float:
    """How far (mm) flat, level faces of a mesh lie from the planes between layers, at most."""
    heights = mesh.corners[:, :, 2]
    level = heights[np.ptp(heights, axis=1) < 1e-6, 0] / printer.layer_height
    return float(np.abs(level - np.round(level)).max(initial=0.0) * printer.layer_height)
