"""A fresh document a test, and how these tests look at an object's state."""

import FreeCAD as App
import pytest

import BistableWB  # a saved proxy is restored only if its module can be imported

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
