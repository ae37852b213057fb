# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contacts as springs behind cones: what a displacement at a cone costs, and with which force.

At every contact the displacement u of one body against the other is v + e: v within what the
clearance leaves free, e the give of knuckles and panels nearby, which costs e·S·e / 2. With the law
of `contact` (slope |r| ≤ clear + lean a) v lies in a second-order cone. Its wall is a logarithmic
barrier of sharpness ``mu`` (N·mm), so that all is smooth; every v is found exactly, from one scalar
equation (docs/theory/hinges.md 4). Frames: the axis is the third coordinate.
"""

from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

_ROUNDS = 40
_FAR = 60.0  # in the logarithmic coordinate
_SETTLED = 1e-9
_AFTER, _BEFORE = np.array([1, 2, 0]), np.array([2, 0, 1])


@dataclass(frozen=True)
class Cones:
    """n contacts with stiffness (n, 3, 3) N/mm and free cones, ready to be asked.

    ``apex`` (n,): place of the cone's tip along the axis, mm; ``square`` (n,): clear² where the
    cone has no tip (a pin's ring), else 0; ``law`` (n, 3): the diagonal of g(w) = square + w·law·w,
    which is 0 on the wall; ``values``, ``to``, ``back``: of the law in the metric of the stiffness.
    """

    stiffness: NDArray
    apex: NDArray
    square: NDArray
    law: NDArray
    values: NDArray
    to: NDArray
    back: NDArray

    def push(self, u: NDArray, mu: float) -> tuple[NDArray, NDArray, NDArray, NDArray]:
        """What displacements (n, 3) mm cost.

        Returns the cost, barrier included (n,), the strain energy (n,), N·mm, and the derivatives
        of the cost: force (n, 3), N, and stiffness (n, 3, 3).
        """
        at = u.copy()
        at[:, 2] -= self.apex
        y = (self.to @ at[..., None])[..., 0]
        lam = _multiplier(self.values, y, self.square, mu)
        w = (self.back @ (y / (1 - lam[:, None] * self.values))[..., None])[..., 0]
        bent = self.law * w
        force = -lam[:, None] * bent
        strain = (force * (at - w)).sum(1) / 2
        wall = self.stiffness + (lam**2 / mu)[:, None, None] * bent[:, :, None] * bent[:, None]
        wall[:, [0, 1, 2], [0, 1, 2]] -= lam[:, None] * self.law
        slope: NDArray = self.stiffness - self.stiffness @ _inverse(wall) @ self.stiffness
        room = self.square + (bent * w).sum(1)
        far = room < 1e-6 * (np.abs(bent * w).sum(1) + self.square)  # cancelled: then by its law
        room = np.where(far, 2 * mu / lam, room)
        return strain - mu * np.log(room), strain, force, slope


def cones(compliance: NDArray, slope: NDArray, lean: NDArray, clear: NDArray) -> Cones:
    """`Cones` of contacts with ``compliance`` (n, 3, 3) mm/N and clearance ``clear`` (n,) mm."""
    tipped = lean != 0
    law = np.stack([-(slope**2), -(slope**2), lean**2], -1)
    apex = np.where(tipped, -clear / np.where(tipped, lean, 1.0), 0.0)
    stiffness = np.linalg.inv(compliance)
    root = np.linalg.cholesky(stiffness)
    inverse = np.linalg.inv(root)
    inner = inverse @ (law[:, :, None] * np.swapaxes(inverse, -1, -2))
    values, vectors = np.linalg.eigh(inner)
    back = np.swapaxes(inverse, -1, -2) @ vectors
    # The last eigenvector is the one inside the cone: let it look the way the cone opens.
    flip = np.where(tipped & (back[:, 2, 2] * lean < 0), -1.0, 1.0)
    vectors[:, :, 2] *= flip[:, None]
    back[:, :, 2] *= flip[:, None]
    values = np.where(np.abs(values) < 1e-12 * np.abs(values).max(1, keepdims=True), 0.0, values)
    to = np.swapaxes(vectors, -1, -2) @ np.swapaxes(root, -1, -2)
    return Cones(stiffness, apex, np.where(tipped, 0.0, clear**2), law, values, to, back)


def _inverse(matrices: NDArray) -> Any:
    """Inverses of symmetric (n, 3, 3) matrices: BLAS would start threads for every one of them."""
    a, b, c = (matrices[:, k] for k in range(3))
    rows = np.stack([_cross(b, c), _cross(c, a), _cross(a, b)], 1)
    return rows / (a * rows[:, 0]).sum(1)[:, None, None]


def _cross(a: Any, b: Any) -> Any:
    return a[:, _AFTER] * b[:, _BEFORE] - a[:, _BEFORE] * b[:, _AFTER]


def _multiplier(values: NDArray, y: NDArray, square: NDArray, mu: float) -> NDArray:
    """λ with square + Σ θ y² / (1 − λ θ)² = 2 μ / λ, the root whose w lies inside its cone.

    λ < 1/θ₊ where u lies before the cone's tip, beyond where it lies behind: one root there,
    found from the logarithms of both sides, in a logarithmic coordinate, by guarded Newton steps.
    """
    search = _Root.of(values, y, square, mu)
    lam, active = np.empty(len(y)), np.arange(len(y))
    for _ in range(_ROUNDS):
        lam[active], settled = search.step()
        if settled.all():
            break
        if 2 * settled.sum() > len(active):
            active, search = active[~settled], search.left(~settled)
    return lam


@dataclass
class _Root:
    """Where the search for every λ stands: its coordinate ``t`` between ``low`` and ``high``."""

    top: NDArray  # θ₊, 0 for a pin's ring
    rest: NDArray  # (n, 3) the other θ, below 0
    unit: NDArray
    before: NDArray
    behind: NDArray
    ahead: NDArray  # square and θ y² of the first
    square: NDArray
    others: NDArray
    t: NDArray
    low: NDArray
    high: NDArray
    mu: float

    @classmethod
    def of(cls, values: NDArray, y: NDArray, square: NDArray, mu: float) -> Any:
        """At the start: where u is free, λ is about 2 μ / what is free."""
        pole = values[:, 2] > 0
        top = np.where(pole, values[:, 2], 0.0)
        unit = 1 / np.where(pole, top, np.abs(values).max(1))
        behind = pole & (y[:, 2] < 0)
        weight = values * y**2
        free = square + weight.sum(1)
        inside = free > 1e-300
        t = np.where(inside, np.log(2 * mu / np.where(inside, free, 1.0) / unit), 0.0)
        ahead = np.where(pole, weight[:, 2], 0.0)
        return cls(
            top, np.minimum(values, 0.0), unit, pole & ~behind, behind, ahead, square,
            np.abs(np.minimum(weight, 0.0)), np.clip(t, -_FAR / 2, _FAR / 2),
            np.full(len(y), -_FAR), np.full(len(y), _FAR), mu,
        )  # fmt: skip

    def left(self, kept: Any) -> Any:
        """Only those not settled."""
        own = {f.name: getattr(self, f.name) for f in fields(self) if f.name != "mu"}
        return _Root(**{name: array[kept] for name, array in own.items()}, mu=self.mu)

    def step(self) -> Any:
        """One step of Newton's; λ where it started, and which had arrived."""
        t, unit = self.t, self.unit
        power = np.exp(np.where(self.before, -np.abs(t), t))
        share = np.where(self.before, 1 / (1 + power), 1.0)
        beyond = self.before & (t > 0)
        lam = unit * (np.where(beyond, share, power * share) + self.behind)
        # 1 − λθ₊ without cancellation
        free = np.where(self.before, np.where(beyond, power, 1.0) * share, -power)
        free = np.where(self.top > 0, free, 1.0)
        left = 1 / (1 - lam[:, None] * self.rest)
        far = self.others * left**2
        near, twice = self.ahead / free**2, 2 * self.mu / lam
        inside, outside = self.square + near, far.sum(1) + twice
        by_inside = 2 * near * self.top / free
        by_outside = 2 * (far * self.rest * left).sum(1) - twice / lam
        value = np.log(inside / outside)
        slope = (by_inside / inside - by_outside / outside) * unit * power * share**2
        rising = np.where(self.behind, -value, value) < 0
        self.low, self.high = np.where(rising, t, self.low), np.where(rising, self.high, t)
        there = t - value / slope
        kept = (there >= self.low) & (there <= self.high)
        self.t = np.where(kept, there, (self.low + self.high) / 2)
        return lam, np.abs(self.t - t) < _SETTLED
