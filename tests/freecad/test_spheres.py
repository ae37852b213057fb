# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves on spheres, from a great circle to a loxodrome, are printed firm by one command."""

import FreeCAD as App
import numpy as np
import Part
import pytest

from BistableWB import fitting, make

BED = (250.0, 210.0, 210.0)


def swung(radius, share, angle=120.0):
    """An arc of a great circle, swung sideways by a share of the radius, once to either side."""
    t = np.linspace(0, 1, 41)
    along = np.radians(angle) * (t - 0.5)
    aside = share * np.sin(2 * np.pi * t)
    return radius * np.stack([np.sin(along) * np.cos(aside), np.sin(aside),
                              np.cos(along) * np.cos(aside)], 1)  # fmt: skip


def loxodrome(radius, slope=0.6):
    """A line of constant bearing, from 10° to 60° of latitude."""
    latitude = np.radians(np.linspace(10, 60, 41))
    longitude = slope * np.arctanh(np.sin(latitude))
    flat = np.cos(latitude)
    points = [flat * np.cos(longitude), flat * np.sin(longitude), np.sin(latitude)]
    return radius * np.stack(points, 1)


CASES = {
    "great circle R 300": (300, swung(300, 0.0)),
    "swung by a tenth": (300, swung(300, 0.1)),
    "swung by a fifth": (300, swung(300, 0.2)),
    "loxodrome R 300": (300, loxodrome(300)),
    "meridian R 150": (150, swung(150, 0.0, 100)),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", CASES)
def test_curves_on_spheres_are_firm(doc, valid, name):
    radius, points = CASES[name]
    spline = Part.BSplineCurve()
    spline.interpolate([App.Vector(*p) for p in points.tolist()])
    feature = doc.addObject("Part::Feature", "Drawn")
    feature.Shape = spline.toShape()
    curve = make.make_curve(doc, source=feature, kind="Sphere", sphere_radius=radius)
    valid(doc)
    made = fitting.make_printable(curve, BED)
    assert made.blocked is None
    assert made.curve.Kind == "Sphere"
    margins = [m for hinges in made.hinge_sets for m in hinges.SnapMargins]
    assert len(margins) == made.triangles.Count
    assert min(margins) >= 1.2 * 0.999
    # the blocks of the deployed tube stand across the sphere: their middles are on it
    edge = made.triangles.EdgeLength.Value
    middles = np.array([
        tuple(e.CenterOfMass) for e in made.unit.Shape.Edges if abs(e.Length - edge) < 1e-6
    ])  # fmt: skip
    off = np.abs(np.linalg.norm(middles, axis=1) - radius)
    assert np.sort(off)[: made.triangles.Count].max() < 0.02 * edge
