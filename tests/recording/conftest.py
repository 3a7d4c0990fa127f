"""Whether pictures can be painted here."""

import os
from pathlib import Path

import pytest


def vulkan():
    places = (Path("/usr/share/vulkan/icd.d"), Path("/etc/vulkan/icd.d"))
    return any(place.is_dir() and any(place.iterdir()) for place in places)


@pytest.fixture
def painting():
    """CI has a Vulkan driver, and fails where it is missing."""
    if not vulkan() and not os.environ.get("CI"):
        pytest.skip("no Vulkan driver")
