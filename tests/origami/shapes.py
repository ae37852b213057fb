# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves for tests of placement: ``point(s)`` by formulas."""

import numpy as np

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.thick.thick_tube import thick_tube
from BistableWB.origami.units import tube as tubes
from BistableWB.origami.units.ratios import RatioRule

EXAMPLE = Bezier([(0, 0, 0), (90, 180, 0), (270, 180, 0), (360, 0, 0)])
ARCH = Bezier([(0, 0), (0, 220), (300, 220), (300, 0)])
ESS = Bezier([(0, 0), (150, 0), (150, 200), (300, 200)])


class Bend:
    """Straight for ``before`` mm, a bend of 90° at radius 40, straight for 200 mm."""

    radius = 40.0

    def __init__(self, before):
        turn = np.pi / 2 * self.radius
        self.before, self.length = before, before + turn + 200
        self.after = before + turn
        self.breaks = (0, before / self.length, self.after / self.length, 1)

    def point(self, s):
        along = np.asarray(s, float) * self.length
        turn = np.clip((along - self.before) / self.radius, 0, np.pi / 2)
        x = np.minimum(along, self.before) + self.radius * np.sin(turn)
        y = self.radius * (1 - np.cos(turn)) + np.maximum(along - self.after, 0)
        return np.stack([x, y, 0 * x], -1)


class Ring:
    """A closed curve: an ellipse with half axes ``a`` and ``b`` that waves up and down."""

    def __init__(self, a, b=None, wave=0.0):
        self.a, self.b, self.wave = a, b or a, wave

    def point(self, s):
        t = 2 * np.pi * np.asarray(s, float)
        return np.stack([self.a * np.cos(t), self.b * np.sin(t), self.wave * np.cos(2 * t)], -1)


class Heart:
    """Closed, with a kink at the notch and one at the tip."""

    kinks = (0.0, 0.5)

    def point(self, s):
        t = 2 * np.pi * np.asarray(s, float)
        x = 16 * np.sin(t) * np.abs(np.sin(t))
        y = 13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t)
        return 8 * np.stack([x, y, 0 * t], -1)


class OnSphere:
    """An arc of 120° of a great circle of radius ``radius``, swung sideways."""

    def __init__(self, radius=300.0, swing=0.1):
        self.radius, self.swing = radius, swing

    def point(self, s):
        s = np.asarray(s, float)
        t = np.radians(120) * s
        p = np.stack([np.cos(t), np.sin(t), self.swing * np.sin(2 * np.pi * s)], -1)
        return self.radius * p / np.linalg.norm(p, axis=-1, keepdims=True)


class OnSphereRing:
    """A closed wavy curve on the sphere of radius ``radius`` about the origin."""

    def __init__(self, radius=150.0, wave=0.2):
        self.radius, self.wave = radius, wave

    def point(self, s):
        t = 2 * np.pi * np.asarray(s, float)
        p = np.stack([np.cos(t), np.sin(t), 0.5 + self.wave * np.cos(3 * t)], -1)
        return self.radius * p / np.linalg.norm(p, axis=-1, keepdims=True)


class Rising:
    """A curve in space that climbs by 80 mm."""

    def point(self, s):
        s = np.asarray(s, float)
        return np.stack([300 * s, 60 * np.sin(3 * s), 80 * s * s], -1)


class Random:
    """A smooth random curve: sums of a few waves, closed or not, in a plane or in space."""

    def __init__(self, seed, closed=False, height=0.0):
        rng = np.random.default_rng(seed)
        self.closed, self.phase = closed, rng.uniform(0, 2 * np.pi, 3)
        self.size = rng.uniform(-1, 1, 3) * [30, 20, height]

    def point(self, s):
        s = np.asarray(s, float)
        t = 2 * np.pi * s
        waves = [a * np.cos((k + 2) * t / (1 if self.closed else 2) + p)
                 for k, (a, p) in enumerate(zip(self.size, self.phase, strict=True))]  # fmt: skip
        if self.closed:
            reach = 110 + 0.4 * waves[0] + 0.3 * waves[1]
            return np.stack([reach * np.cos(t), reach * np.sin(t), waves[2]], -1)
        return np.stack([320 * s, waves[0] + waves[1], waves[2]], -1)


def arch_of_examples(share=0.04):
    """The arch of the examples, nine thick units of ‖AB‖ 90."""
    rule = RatioRule(share=share)
    return thick_tube(
        lambda tuning: place(EXAMPLE, 90, np.radians(28), 1.8, extra=tuning.extra),
        lambda placed, tuning: tubes.along(placed, "Plane", 2.5, rule, None, tuning), 1.2, 0.6,
    )  # fmt: skip
