"""Reference numbers of the fast tests."""

import json
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))  # for curves that several tests draw: shapes.py


@pytest.fixture(scope="session")
def vectors():
    """Numbers computed independently of this code."""
    return json.loads((Path(__file__).parents[1] / "data" / "vectors.json").read_text())
