"""A fresh document a test, and how these tests look at an object's state."""

import FreeCAD as App
import pytest

import BistableWB  # a saved proxy is restored only if its module can be imported
from BistableWB import make

assert BistableWB.__version__


@pytest.fixture
def doc():
    """An empty document, closed after the test."""
    document = App.newDocument("Test")
    name = document.Name
    yield document
    if name in App.listDocuments():
        App.closeDocument(name)


@pytest.fixture
def valid():
    """Recompute and assert that every object is valid (recompute itself never raises)."""

    def check(document):
        document.recompute()
        for obj in document.Objects:
            assert obj.isValid(), f"{obj.Name}: {obj.getStatusString()}"

    return check


@pytest.fixture
def refused():
    """Recompute and return the sentence with which an object refuses its input."""

    def check(document, obj):
        document.recompute()
        assert not obj.isValid(), f"{obj.Name} should have been refused"
        return obj.getStatusString()

    return check


@pytest.fixture
def unit(doc, valid):
    """One unit by itself, 60 mm."""
    obj = make.make_bistable_unit(doc, theta=50, ratio=0.5, edge_length=60)
    valid(doc)
    return obj


@pytest.fixture
def tube(doc, valid):
    """A tube along an arch; neighbouring units share their contact panels."""
    curve = make.make_curve(doc)  # the example arch
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    obj = make.make_bistable_unit(doc, triangles)
    valid(doc)
    return obj


@pytest.fixture
def hinges(doc, valid):
    """A firm print of one unit, 60 mm."""
    unit = make.make_bistable_unit(doc, theta=45, ratio=0.42, edge_length=60)
    obj = make.make_hinge_set(doc, unit)
    valid(doc)
    return obj
