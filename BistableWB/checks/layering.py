# SPDX-License-Identifier: LGPL-2.1-or-later
"""What layers make of a print: bodies that thicken or fuse, and what is laid over air.

Measured on the layers of the meshes (`layers`), with no slicer: `slicing` asks one.
"""

from concurrent.futures import ThreadPoolExecutor
from os import cpu_count

import numpy as np

from .findings import ERROR, NOTE, WARNING, Finding
from .layers import PIXEL, layers
from .overhang import hangs, starts_in_air

SHARE_TOLERANCE = 0.05  # by which a body's layers may be off its volume
CONTACT_LIMIT = 0.15  # mm² between two moving bodies that is not felt
WELDED = 1.0  # mm² from which bodies do not break free any more
_SUPPORT_CURE = {
    "off": "switch Support on, or let the slicer fill the gaps with soluble support",
    "on": "let the slicer add support there too",
    "none": "let the slicer add support there",
}


class Layering:
    """The layers of a print's ``bodies`` (`PlacedMesh`, as they lie on the bed), unit by unit.

    ``support``: `Mesh` of the soluble support, if it is printed; ``support_state``: "on", "off"
    (it could be) or "none". Only units next to each other are held in memory.
    """

    def __init__(self, bodies, printer, support=None, support_state="none"):
        self.bodies, self.printer = list(bodies), printer
        self.support_state = support_state
        self._support = None if support is None else layers(support, printer.layer_height)
        self._shares, self._contacts, self._hangs, self._islands = [], [], [], []

    def findings(self):
        """List of `Finding`: thickness, fused bodies, what hangs over air."""
        alive = []
        for unit in sorted({body.unit for body in self.bodies}):
            bodies = [body for body in self.bodies if body.unit == unit]
            with ThreadPoolExecutor(cpu_count()) as pool:
                made = list(pool.map(self._layers, bodies))
                new = list(zip(bodies, made, strict=True))
                around = [*alive, *new]
                list(pool.map(self._look_below, bodies, made, [around] * len(new)))
            self._touch(new, around)
            alive = new
        return [*self._thickness(), *self._fused(), *self._over_air()]

    def _layers(self, body):
        mesh = body.placed
        found = layers(mesh, self.printer.layer_height)
        volume = found.inside.sum() * PIXEL**2 * self.printer.layer_height
        self._shares.append((body.name, volume / mesh.volume, _off_grid(mesh, self.printer)))
        return found

    def _look_below(self, body, made, around):
        if not made.inside.size:
            return
        for hang in hangs(made, self.printer, self._support):
            point = made.middle(hang.pixel, self.printer.layer_height)
            self._hangs.append((hang, body.name, point))
        others = [other for _, other in around if other is not made]
        if starts_in_air(made, others, self.printer, self._support):
            point = made.middle(np.argwhere(made.inside[:1])[0], self.printer.layer_height)
            self._islands.append((point[2], body.name, point))

    def _touch(self, new, around):
        """Areas in which layers of two rigid bodies lie on each other or are the same."""
        for k, (body, made) in enumerate(new):
            others = around[: len(around) - len(new) + k]
            for other, its in others:
                if body.material == other.material == "rigid":
                    pixels, where = _contact(its, made)
                    if pixels:
                        point = made.middle(where - made.first, self.printer.layer_height)
                        self._contacts.append((pixels * PIXEL**2, other.name, body.name, point))

    def _thickness(self):
        height = self.printer.layer_height
        name, share, off = max(sorted(self._shares), key=lambda entry: abs(entry[1] - 1))
        if abs(share - 1) <= SHARE_TOLERANCE:
            return [Finding(
                NOTE, "layers", (), share, 1.0,
                f"Layers of {height:g} mm give every body its volume to {abs(share - 1):.1%}.",
            )]  # fmt: skip
        return [Finding(
            WARNING, "layers", (name,), share, 1.0,
            f"Layers of {height:g} mm make {name} {share:.0%} of its volume: its flat faces lie up "
            f"to {off:.2g} mm off the layers.",
            f"make FaceThickness and GapBetweenPlanes multiples of {height:g} mm",
        )]  # fmt: skip

    def _fused(self):
        found = sorted(self._contacts, reverse=True)
        fused = [entry for entry in found if entry[0] > CONTACT_LIMIT]
        if not fused:
            most = found[0][0] if found else 0.0
            rest = f", but for {most:.2g} mm²" if most else ""
            text = f"Between any two moving bodies lies a layer of air{rest}."
            return [Finding(NOTE, "fused", (), most, CONTACT_LIMIT, text)]
        area, lower, upper, _ = fused[0]
        welded = area > WELDED
        result = "which welds them" if welded else "which has to break free at the first opening"
        other = len(fused) - 1
        more = f" (and of {other} other pair{'s' * (other > 1)})" if other else ""
        return [Finding(
            ERROR if welded else WARNING, "fused", (lower, upper), area, CONTACT_LIMIT,
            f"Layers of {self.printer.layer_height:g} mm lay {area:.2g} mm² of {upper} directly on "
            f"{lower}{more}, {result}.",
            "make LayerHeight smaller, or GapLength and GapBetweenPlanes larger",
            tuple(entry[3] for entry in fused[:20]),
        )]  # fmt: skip

    def _over_air(self):
        if not self._hangs:
            return [Finding(NOTE, "overhang", (), 0.0, None, "Nothing is laid over air.")]
        span, total = self.printer.bridge, sum(hang.area for hang, *_ in self._hangs)
        return [self._hang_finding(total, span), *self._island_findings()]

    def _hang_finding(self, total, span):
        wide = [entry for entry in self._hangs if entry[0].wide]
        hang, name, point = max(wide or self._hangs, key=lambda entry: (entry[0].area, entry[1]))
        most = f"{hang.area:.0f} mm² of {name} at a height of {point[2]:.1f} mm"
        if not wide:
            return Finding(
                NOTE, "overhang", (name,), total, None,
                f"{_area(total)} are laid over air, all in strips narrower than the "
                f"{span:g} mm that a printer spans; the largest are {most}.", "", (point,),
            )  # fmt: skip
        many = f"{len(wide)} places are" if wide[1:] else "one place is"
        return Finding(
            WARNING, "overhang", (name,), hang.area, span**2,
            f"{_area(total)} are laid over air, where {many} wider than the {span:g} mm "
            f"that a printer spans, the largest {most}.",
            _SUPPORT_CURE[self.support_state], tuple(entry[2] for entry in wide[:20]),
        )  # fmt: skip

    def _island_findings(self):
        if not self._islands:
            return []
        lowest = sorted(self._islands)
        names = tuple(name for _, name, _ in lowest)
        what = f"{names[0]} starts" if len(names) == 1 else f"{len(names)} bodies start"
        first = "" if len(names) == 1 else f", {names[0]} first"
        return [Finding(
            WARNING, "island", names, lowest[0][0], self.printer.bridge,
            f"{what} in mid-air{first}, {lowest[0][0]:.1f} mm above the bed and more than "
            f"{self.printer.bridge:g} mm above anything else.",
            _SUPPORT_CURE["none"], tuple(entry[2] for entry in lowest[:20]),
        )]  # fmt: skip


def _area(square_mm):
    """An area in words: cm² with two digits."""
    return f"{square_mm / 100:.0f} cm²" if square_mm >= 1000 else f"{square_mm / 100:.2g} cm²"


def _contact(one, other):
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


def _off_grid(mesh, printer):
    """How far (mm) flat, level faces of a mesh lie from the planes between layers, at most."""
    heights = mesh.corners[:, :, 2]
    level = heights[np.ptp(heights, axis=1) < 1e-6, 0] / printer.layer_height
    return float(np.abs(level - np.round(level)).max(initial=0.0) * printer.layer_height)
