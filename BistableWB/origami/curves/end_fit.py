# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rule EndFit: gamma near the wanted one with which the last midpoint is the curve's end.

The march of section 2 runs on along the curve's last tangent, so that where unit N ends is a
function of gamma beyond the curve's end too; its root is found for the two counts between which
the wanted gamma lies, and the nearer of the two is taken (section 5).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal
from . import bezier
from .crossing import CurveTable
from .marching import march
from .quick import QuickMarch
from .tightness import too_long

if TYPE_CHECKING:
    from .curve import Curve
    from .legs import Legs
    from .marching import Blocks
    from .placement import Placement

LEAST, MOST = np.radians(4.0), np.radians(60.0)  # gammas that are tried
_MET = 1e-8  # of ‖AB‖: how near the last midpoint comes to the end
_ROUGH, _CLOSE = 2e-3, 0.05  # of ‖AB‖: a quick march is as good; and where secants begin
_NEAR = np.radians(1.5)
_STEPS = 30
_BEYOND = 3.0  # ‖AB‖ of straight line behind the end
_MANY = 300  # units of which another one makes no other tube: fewer counts are tried
_MORE = (0, 1, -1, 2, -2)  # counts that are tried, from those that the wanted gamma gives


class Extended:
    """A curve that goes on straight behind its end, by ``length``: parameters 0 … 1 again.

    ``share`` of these is the curve itself.
    """

    def __init__(self, curve: "Curve", length: float) -> None:
        self.curve = curve
        ends = np.asarray(curve.point(np.array([1 - 1e-4, 1 - 1e-6, 1.0])), float)
        speed = np.linalg.norm(ends[2] - ends[0]) / 1e-4
        self.end, tangent = ends[2], bezier.normalised(2 * ends[2] - ends[1] - ends[1])
        self.stretch = 1 + length / speed
        self.share = 1 / self.stretch
        self.speed = speed * tangent
        if hasattr(curve, "bend"):
            self.bend = curve.bend * self.stretch**2
        inner = np.asarray(getattr(curve, "breaks", ()) or (0.0,), float) * self.share
        self.breaks = [*inner.tolist(), self.share, 1.0] if inner[-1] < self.share else [
            *inner.tolist(), 1.0]  # fmt: skip

    def point(self, s: NDArray) -> NDArray:
        """Points (…, 3) at ``s`` in [0, 1]."""
        own = np.asarray(s, float) * self.stretch
        points = np.asarray(self.curve.point(np.minimum(own, 1.0)), float)
        return points + np.maximum(own - 1, 0)[..., None] * self.speed


class EndFit:
    """Marches along ``curve`` that end at its end; arguments as of `placement.place`."""

    def __init__(
        self,
        curve: "Curve",
        legs: "Legs",
        edge_length: float,
        pitch: float,
        flip: bool,
        extra: NDArray | Sequence[Any],
    ) -> None:
        self.curve = Extended(curve, _BEYOND * edge_length)
        self.table = CurveTable(self.curve, edge_length)
        self.given = legs, edge_length
        self.more = pitch, flip, extra
        self.edge_length = edge_length
        self.speed = np.linalg.norm(self.curve.speed)
        self.quick = QuickMarch(self.table, legs, edge_length, pitch, flip, extra)
        self.length = float(self.table.length_at(self.curve.share))

    def fitted(self, gamma: float, near: "Placement | None" = None) -> "tuple[Blocks, float]":
        """`marching.Blocks` and their gamma, nearest to ``gamma``; `Refusal` where there is none.

        ``near``: a `Placement` of as many units, with about the same gamma.
        """
        found = []
        if near is not None:
            found = [self._ending(near.gamma, len(near))]
        else:
            wanted = max(1, self._count(gamma))
            for more in _MORE if wanted <= _MANY else _MORE[:2]:
                if len(found) == 2 or (found and more not in _MORE[:2]):
                    break
                one = self._nearest(gamma, wanted + more) if wanted + more > 0 else None
                found += [] if one is None else [one]
        if not found and self.edge_length > self.length:
            too_long(self.edge_length, self.length)
        if not found or found[0] is None:
            raise Refusal(
                "{Gamma}: no angle near {value:.4g}° ends the tube at the curve's end",
                cure="choose Steered or Paper as {PlacementRule}, or change {EdgeLength}",
                parameter="PlacementRule",
                value=float(np.degrees(gamma)),
            )
        return min(found, key=lambda one: abs(one[1] - gamma))

    def _nearest(self, gamma: float, count: int) -> Any:
        """Blocks of ``count`` units and their gamma: from a quick guess, or from the wanted one.

        The guess leads astray where a sharp bend makes the end hang on every hundredth of a degree.
        """
        start = self._roughly(gamma, count)
        one = None if start is None else self._ending(start, count)
        if one is None or abs(one[1] - gamma) > _NEAR:
            other = self._ending(gamma, count)
            if one is None or (other is not None and abs(other[1] - gamma) < abs(one[1] - gamma)):
                return other
        return one

    def _count(self, gamma: float) -> int:
        lengths = self.quick.march(gamma).lengths
        return int(np.searchsorted(lengths, self.length, side="right")) - 1

    def _roughly(self, gamma: float, count: int) -> float | None:
        """A gamma whose quick march of ``count`` units ends about at the curve's end, or None."""
        search, best = _Search(gamma), None
        for _ in range(_STEPS):
            march = self.quick.march(search.gamma, count)
            miss = (march.lengths[-1] - self.length) / self.edge_length
            if len(march.thetas) < count:
                if march.tight:
                    break
                miss = _BEYOND
            if best is None or abs(miss) < best[0]:
                best = abs(miss), search.gamma
            if abs(miss) < _ROUGH or not search.goes_on(miss, self.length / self.edge_length):
                break
        return best and best[1]

    def _ending(self, gamma: float, count: int) -> Any:
        """Blocks of ``count`` units and their gamma, None where there are none."""
        search = _Search(gamma)
        legs, edge = self.given
        for _ in range(_STEPS):
            try:
                blocks = march(self.table, legs, edge, search.gamma, *self.more, count)
            except ValueError:
                return None
            miss = self._miss(blocks) if len(blocks.sines) == count else _BEYOND
            if abs(miss) <= _MET:
                return self._done(blocks), search.gamma
            if not search.goes_on(miss, self.length / self.edge_length):
                return None
        return None

    def _miss(self, blocks: "Blocks") -> float:
        """How far the last midpoint is beyond the curve's end, in ‖AB‖."""
        ahead = (blocks.parameters[-1] - self.curve.share) * self.curve.stretch
        return float(ahead * self.speed / self.edge_length)

    def _done(self, blocks: "Blocks") -> "Blocks":
        blocks.parameters = [min(s * self.curve.stretch, 1.0) for s in blocks.parameters]
        blocks.parameters[-1] = 1.0
        return blocks


class _Search:
    """The gamma that is tried next, from how far those before missed the end (in ‖AB‖)."""

    def __init__(self, gamma: float) -> None:
        self.gamma = gamma
        # (gamma, miss): the nearest from below and from above, and the one before
        self.low: Any = None
        self.high: Any = None
        self.before: Any = None
        self.is_secant = False  # whether a secant gave the gamma that is tried

    def goes_on(self, miss: float, length: float) -> bool:
        """Choose the next gamma; False where there is none. ``length`` of the curve in ‖AB‖."""
        here = self.gamma, miss
        if miss < 0:
            self.low = here
        else:
            self.high = here
        trial = self._secant(miss)
        self.is_secant = trial is not None
        if trial is None:
            trial = self._from_afar(miss, length)
        if trial is None and abs(self.high[0] - self.low[0]) > 1e-15:
            share = self.low[1] / (self.low[1] - self.high[1])
            trial = self.low[0] + min(max(share, 0.05), 0.95) * (self.high[0] - self.low[0])
        self.before = here
        if trial is None or not LEAST < trial < MOST or trial == self.gamma:
            return False
        self.gamma = trial
        return True

    def _secant(self, miss: float) -> float | None:
        if self.before is None or max(abs(miss), abs(self.before[1])) > _CLOSE:
            return None
        # where the end hangs on gamma much more than by length alone, steps from afar crawl
        if self.gamma == self.before[0] or (
            self.is_secant and abs(miss) > 0.5 * abs(self.before[1]) > 0
        ):
            return None
        slope = (miss - self.before[1]) / (self.gamma - self.before[0])
        return self.gamma - miss / slope if slope > 0 else None

    def _from_afar(self, miss: float, length: float) -> float | None:
        """The next gamma while all missed on one side: units advance by about ‖AB‖ sin gamma."""
        if self.low is not None and self.high is not None:
            return None
        more = 0.0 if abs(miss) < _CLOSE else 0.02 * np.sign(miss)
        sine = np.sin(self.gamma) / max(1 + miss / length, 0.1) * (1 - more)
        return float(np.arcsin(min(sine, 0.99)))
