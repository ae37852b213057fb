"""Reference numbers of the fast tests."""

import json
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def vectors():
    """Numbers computed independently of this code."""
    return json.loads((Path(__file__).parents[1] / "data" / "vectors.json").read_text())
